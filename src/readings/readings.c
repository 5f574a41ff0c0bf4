/* Reads a CSV file of readings, checks them against each other, and groups them
 * into rows: the sensors of one group and condition form one reading of
 * coverage, and each other reading is a row of its own. */
#include "readings/readings.h"

#include "base/file.h"
#include "base/log.h"
#include "readings/mapped.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* some 300 bytes for each of MURK_READINGS_MAX readings */
#define FILE_BYTES_MAX 32000000

/* A reading with the names of group and factor, which point into the table. */
typedef struct named {
    murk_reading reading;
    const char *group, *gain;
    size_t leader; /* index in listing.item of the first reading of the row */
} named;

typedef struct listing {
    const murk_table *table;
    named *item; /* [n]; in the order of lines */
    size_t n;
    murk_error *err;
} listing;

static murk_status no_memory(const char *path, murk_error *err)
{
    return murk_no_memory(err, path, "for its readings");
}

/* The place of a cell for messages. */
static murk_reading_where where_of(const listing *all, const named *at,
                                   murk_reading_column column)
{
    return murk_reading_where_at(all->table, (int)at->reading.line, column);
}

/* ---- groups ---- */

static int compare_groups(const void *a, const void *b)
{
    const named *x = *(named *const *)a, *y = *(named *const *)b;
    const int by_name = strcmp(x->group, y->group);
    if (by_name) {
        return by_name;
    }
    if (x->reading.condition != y->reading.condition) {
        return x->reading.condition < y->reading.condition ? -1 : 1;
    }
    return x < y ? -1 : 1;
}

/* Readings of one group must have one kind and one unit. */
static murk_status check_alike(const listing *all, const named *first,
                               const named *at)
{
    const murk_reading *a = &first->reading, *b = &at->reading;
    if (b->kind != a->kind) {
        return murk_fail(
            all->err, MURK_BAD_VALUE, where_of(all, at, MURK_COLUMN_KIND).text,
            "%s, but line %zu of this group is %s, must be of one kind",
            murk_reading_kinds[b->kind], a->line, murk_reading_kinds[a->kind]);
    }
    if (b->unit != a->unit) {
        return murk_fail(
            all->err, MURK_BAD_VALUE, where_of(all, at, MURK_COLUMN_UNIT).text,
            "%s, but line %zu of this group is in %s, must be in one unit",
            murk_reading_unit_name(b->unit), a->line,
            murk_reading_unit_name(a->unit));
    }
    return MURK_OK;
}

/* The sensors of one reading of coverage must state the same value, error,
 * factor and use. */
static murk_status check_same(const listing *all, const named *first,
                              const named *at)
{
    const murk_reading *a = &first->reading, *b = &at->reading;
    /* Compare the columns. */
    const struct {
        bool differs;
        murk_reading_column column;
    } parts[] = {
        {a->value != b->value, MURK_COLUMN_VALUE},
        {a->standard_error != b->standard_error, MURK_COLUMN_ERROR},
        {strcmp(first->gain, at->gain) != 0, MURK_COLUMN_GAIN},
        {a->is_held_out != b->is_held_out, MURK_COLUMN_USE},
    };
    for (size_t i = 0; i < sizeof parts / sizeof *parts; ++i) {
        if (parts[i].differs) {
            return murk_fail(all->err, MURK_BAD_VALUE,
                             where_of(all, at, parts[i].column).text,
                             "differs from line %zu of this group, which is "
                             "one reading of coverage, must be the same in "
                             "all its lines",
                             a->line);
        }
    }
    return MURK_OK;
}

/* Finds the first reading of the row of each reading, and checks the groups. */
static murk_status find_rows(listing *all)
{
    named **sorted = calloc(all->n + 1, sizeof *sorted);
    murk_status status =
        sorted ? MURK_OK : no_memory(all->table->path, all->err);
    size_t n = 0;
    /* Sort the readings that have a group by name, condition and line. */
    for (size_t i = 0; i < all->n && !status; ++i) {
        all->item[i].leader = i;
        if (all->item[i].group[0] != '\0') {
            sorted[n++] = &all->item[i];
        }
    }
    if (n > 0) {
        qsort(sorted, n, sizeof *sorted, compare_groups);
    }
    /* Compare each reading with the first one of its group (`first`) and with
     * the first one of its group and condition (`leader`). */
    for (size_t i = 1, first = 0, leader = 0; i < n && !status; ++i) {
        const bool is_named = strcmp(sorted[i]->group, sorted[i - 1]->group);
        first = is_named ? i : first;
        leader = is_named || sorted[i]->reading.condition !=
                                 sorted[i - 1]->reading.condition
                     ? i
                     : leader;
        status = check_alike(all, sorted[first], sorted[i]);
        if (!status && leader != i &&
            sorted[i]->reading.kind == MURK_READ_COVERAGE) {
            status = check_same(all, sorted[leader], sorted[i]);
            sorted[i]->leader = (size_t)(sorted[leader] - all->item);
        }
    }
    free(sorted);
    return status;
}

/* Fills the rows, groups and readings: readings are ordered by row, and rows by
 * their first lines. */
static void lay_rows(murk_readings *m, const listing *all, size_t *row_of)
{
    /* Number the rows and count their readings. */
    for (size_t i = 0; i < all->n; ++i) {
        const named *at = &all->item[i];
        if (at->leader == i) {
            row_of[i] = m->rows++;
            memcpy(m->group[row_of[i]], at->group, strlen(at->group) + 1);
            m->held_out += at->reading.is_held_out;
        }
        row_of[i] = row_of[at->leader];
        ++m->row[row_of[i]].n;
    }
    /* Positions of the rows. */
    for (size_t r = 1; r < m->rows; ++r) {
        m->row[r].first = m->row[r - 1].first + m->row[r - 1].n;
    }
    for (size_t r = 0; r < m->rows; ++r) {
        m->row[r].n = 0;
    }
    /* Place the readings. */
    for (size_t i = 0; i < all->n; ++i) {
        murk_reading_row *row = &m->row[row_of[i]];
        m->reading[row->first + row->n++] = all->item[i].reading;
    }
    m->readings = all->n;
}

/* ---- gains ---- */

static bool is_plain(const char *name)
{
    for (const char *c = name; *c; ++c) {
        if (!isalnum((unsigned char)*c) && *c != '_' && *c != '-') {
            return false;
        }
    }
    return true;
}

/* Adds a factor. */
static murk_status add_gain(murk_readings *m, const named **first,
                            const listing *all, const named *at)
{
    if (!is_plain(at->gain)) {
        return murk_fail(all->err, MURK_BAD_VALUE,
                         where_of(all, at, MURK_COLUMN_GAIN).text,
                         "must be a name of letters, digits, - and _, of the "
                         "free key gain.NAME");
    }
    if (m->gains == MURK_READING_GAINS_MAX) {
        return murk_fail(all->err, MURK_BAD_VALUE,
                         where_of(all, at, MURK_COLUMN_GAIN).text,
                         "one more than 512 factors, the most there may be");
    }
    memcpy(m->gain[m->gains], at->gain, strlen(at->gain) + 1);
    first[m->gains++] = at;
    return MURK_OK;
}

/* Numbers the factors in the order of their first lines; readings of one factor
 * must have one unit. */
static murk_status find_gains(murk_readings *m, listing *all)
{
    const named *first[MURK_READING_GAINS_MAX];
    for (size_t i = 0; i < all->n; ++i) {
        named *at = &all->item[i];
        size_t k = 0;
        if (at->gain[0] == '\0') {
            continue;
        }
        /* Find the factor or add it. */
        while (k < m->gains && strcmp(m->gain[k], at->gain) != 0) {
            ++k;
        }
        if (k == m->gains) {
            const murk_status status = add_gain(m, first, all, at);
            if (status) {
                return status;
            }
        }
        /* Compare the units. */
        if (at->reading.unit != first[k]->reading.unit) {
            return murk_fail(
                all->err, MURK_BAD_VALUE,
                where_of(all, at, MURK_COLUMN_UNIT).text,
                "%s, but line %zu of factor %s is in %s, must be in one unit",
                murk_reading_unit_name(at->reading.unit),
                first[k]->reading.line, m->gain[k],
                murk_reading_unit_name(first[k]->reading.unit));
        }
        at->reading.gain = k;
    }
    return MURK_OK;
}

/* ---- all ---- */

/* Logs a note with the law of each unit that is derived from a transmittance,
 * if readings of transmittance have that unit. */
static void tell(const murk_readings *m)
{
    size_t count[MURK_READING_UNITS] = {0};
    for (size_t i = 0; i < m->readings; ++i) {
        count[m->reading[i].unit] +=
            m->reading[i].kind == MURK_READ_TRANSMITTANCE;
    }
    for (int u = 0; u < MURK_READING_UNITS; ++u) {
        const char *law = murk_reading_unit_law((murk_reading_unit)u);
        if (law && count[u] > 0) {
            murk_note(m->path,
                      "%zu reading%s in %s: compared as %s, T the "
                      "transmittance of a segment of L metres",
                      count[u], count[u] > 1 ? "s" : "",
                      murk_reading_unit_name((murk_reading_unit)u), law);
        }
    }
}

static murk_status read_lines(listing *all, const murk_reading_source *source)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < all->n && !status; ++i) {
        named *at = &all->item[i];
        status = murk_reading_read(&at->reading, &at->group, &at->gain, source,
                                   i, all->err);
    }
    return status;
}

/* Allocates and fills the rows. */
static murk_status fill(murk_readings *m, listing *all)
{
    size_t *row_of = calloc(all->n, sizeof *row_of);
    murk_arena *arena = &m->arena;
    m->reading = murk_arena_array(arena, all->n, sizeof *m->reading);
    m->row = murk_arena_array(arena, all->n, sizeof *m->row);
    m->group = murk_arena_array(arena, all->n, sizeof *m->group);
    m->gain = murk_arena_array(arena, MURK_READING_GAINS_MAX, sizeof *m->gain);
    murk_status status = row_of && !arena->is_short
                             ? find_gains(m, all)
                             : no_memory(m->path, all->err);
    status = status ? status : find_rows(all);
    if (!status) {
        lay_rows(m, all, row_of);
    }
    free(row_of);
    return status;
}

static murk_status from_table(murk_readings *m, const murk_table *table,
                              const murk_scene_desc *scene,
                              const murk_domain *domain, murk_error *err)
{
    /* Find the columns, then read each line. */
    murk_reading_source source = {
        .table = table, .scene = scene, .domain = domain};
    murk_status status = murk_reading_columns(&source, err);
    if (status) {
        return status;
    }
    if (table->rows < 1 || table->rows > MURK_READINGS_MAX) {
        return murk_fail(err, MURK_BAD_FILE, table->path,
                         "%zu readings, must be 1..%d", table->rows,
                         MURK_READINGS_MAX);
    }
    listing all = {.table = table,
                   .item = calloc(table->rows, sizeof *all.item),
                   .n = table->rows,
                   .err = err};
    status = all.item ? read_lines(&all, &source) : no_memory(m->path, err);
    status = status ? status : fill(m, &all);
    free(all.item);
    return status;
}

/* Reads a CSV file of readings. */
static murk_status from_csv(murk_readings *m, const char *path,
                            const murk_scene_desc *scene,
                            const murk_domain *domain, murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    murk_table *table = NULL;
    murk_status status =
        murk_file_read(&text, &size, path, FILE_BYTES_MAX, err);
    if (status) {
        return status;
    }
    if (!(m->path = strdup(path))) {
        free(text);
        return no_memory(path, err);
    }
    /* The checksum identifies the data in results. */
    murk_sha256_hex(text, size, m->sha256);
    status = murk_table_parse(&table, path, text, size, err);
    status = status ? status : from_table(m, table, scene, domain, err);
    murk_table_destroy(table);
    return status;
}

/* Reads the file of measurements that a mapping names. */
static murk_status from_mapping(murk_readings *m, const char *path,
                                const murk_scene_desc *scene,
                                const murk_domain *domain, murk_error *err)
{
    murk_mapped_file mapped;
    murk_status status = murk_mapped_file_read(&mapped, path, FILE_BYTES_MAX,
                                               MURK_READINGS_MAX, err);
    if (!status && !(m->path = strdup(mapped.table.path))) {
        status = no_memory(path, err);
    }
    if (!status) {
        m->is_mapped = true;
        memcpy(m->sha256, mapped.sha256, sizeof m->sha256);
        status = from_table(m, &mapped.table, scene, domain, err);
    }
    murk_mapped_file_release(&mapped);
    return status;
}

murk_status murk_readings_read(murk_readings **out, const char *path,
                               const murk_scene_desc *scene,
                               const murk_domain *domain, murk_error *err)
{
    murk_readings *m = calloc(1, sizeof *m);
    if (!m) {
        return no_memory(path, err);
    }
    const murk_status status = murk_mapping_is(path)
                                   ? from_mapping(m, path, scene, domain, err)
                                   : from_csv(m, path, scene, domain, err);
    if (!status) {
        tell(m);
        *out = m;
        m = NULL;
    }
    murk_readings_destroy(m);
    return status;
}

void murk_readings_destroy(murk_readings *measured)
{
    if (measured) {
        free(measured->path);
        murk_arena_release(&measured->arena);
        free(measured);
    }
}
