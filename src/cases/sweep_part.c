/* Writes and reads study.part, and takes over the rows of parts
 * (cases/sweep_part.h). study.part is a text with one line a fact: the mark
 * with the number of the format; version, study, scene, part and rows, each a
 * name and a value; then, for each row of the whole study in order, the key of
 * the row and the checksum of the file of the row, "-" for a row that the part
 * does not have. A row whose scene could not be read has the key "-".
 *
 * Parts are compared by keys, which are hashes of all that a row follows from
 * (cases/sweep_keys.h): the checksums of study and scene only say what has
 * changed if keys differ, so that a new comment in the study does no harm. */
#include "cases/sweep_part.h"

#include "base/file.h"
#include "base/log.h"
#include "base/number.h"
#include "cases/sweep_store.h"
#include "medium/grid_write.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NAME "study.part"
#define MARK "murk part of a study 1"

/* Bytes of a line of a row: a key, a blank, a checksum and a line break. */
#define LINE_BYTES (64 + 1 + MURK_ROW_SUM_SIZE)
/* The lines before those of rows have a few hundred bytes. */
#define HEAD_BYTES_MAX 4096

/* ---- writing ---- */

murk_status murk_sweep_part_check(const murk_sweep *sweep, murk_error *err)
{
    char path[MURK_SWEEP_PATH_SIZE];
    const murk_status status = murk_sweep_path(path, sweep, NAME, err);
    return status ? status
                  : murk_file_check_owner(path, MARK, sizeof MARK - 1,
                                          sweep->desc.force, err);
}

static const char *key_of(const murk_sweep *sweep, size_t i)
{
    return sweep->row[i].key[0] ? sweep->row[i].key : "-";
}

/* Prints the line of a row. */
static murk_status print_row(FILE *to, const murk_sweep *sweep, size_t i,
                             murk_error *err)
{
    const murk_sweep_row *row = &sweep->row[i];
    char sum[MURK_ROW_SUM_SIZE] = "-";
    murk_status status = MURK_OK;
    if (murk_sweep_owns(sweep, i) && row->is_done && !row->found.failed[0]) {
        status = murk_sweep_sum_row(sum, sweep, row->key, err);
    }
    fprintf(to, "%s %s\n", key_of(sweep, i), sum);
    return status;
}

murk_status murk_sweep_part_write(const murk_sweep *sweep, murk_error *err)
{
    const murk_sweep_desc *desc = &sweep->desc;
    char path[MURK_SWEEP_PATH_SIZE];
    murk_file *file = NULL;
    murk_status status = murk_sweep_path(path, sweep, NAME, err);
    if (!status) {
        status = murk_file_create(&file, path, err);
    }
    if (status) {
        return status;
    }
    /* The study, then a line a row. */
    FILE *to = murk_file_stream(file);
    fprintf(to, MARK "\nversion %s\nstudy %s\nscene %s\npart %u/%u\nrows %zu\n",
            desc->version, desc->study->sha256, sweep->scene_sha256,
            desc->shard.number, desc->shard.count, desc->study->rows);
    for (size_t i = 0; i < desc->study->rows && !status; ++i) {
        status = print_row(to, sweep, i, err);
    }
    if (!status) {
        status = murk_file_commit(&file, err);
    }
    murk_file_discard(file);
    return status;
}

/* ---- reading ---- */

/* While parts are read. */
typedef struct reading {
    murk_sweep *sweep;
    uint32_t count; /* of the parts of the run; 0: no part was read yet */
    bool *has;      /* [count] parts that were given */
    char (*sum)[MURK_ROW_SUM_SIZE]; /* [rows] the checksum of the row in a part;
                                       empty: no part has the row */
    size_t *from; /* [rows] number, from 1, of the part that gave it */
} reading;

/* A part that is read. */
typedef struct part {
    const char *folder;
    size_t number; /* from 1, among those given */
    char path[MURK_SWEEP_PATH_SIZE];
    char *text, *at; /* the next line of study.part */
    murk_shard shard;
    bool has_other_study, has_other_scene; /* than this run */
} part;

static murk_status bad_part(const part *p, const char *what, murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, p->path, "no part of a study: %s",
                     what);
}

/* The next line without the line break; NULL at the end. */
static char *next_line(part *p)
{
    char *line = p->at, *end = strchr(line, '\n');
    if (!end) {
        return NULL;
    }
    *end = '\0';
    p->at = end + 1;
    return line;
}

/* The value of the next line, which begins with the name; "" if it does not. */
static const char *next_fact(part *p, const char *name)
{
    const char *line = next_line(p);
    const size_t n = strlen(name);
    return line && strncmp(line, name, n) == 0 && line[n] == ' ' ? line + n + 1
                                                                 : "";
}

/* Reads "K/N". */
static bool read_shard(murk_shard *out, const char *text)
{
    const char *slash = strchr(text, '/');
    char number[16] = "";
    uint64_t k = 0, n = 0;
    if (!slash || (size_t)(slash - text) >= sizeof number) {
        return false;
    }
    memcpy(number, text, (size_t)(slash - text));
    const bool is_shard = murk_count_parse(number, &k) &&
                          murk_count_parse(slash + 1, &n) && k >= 1 && k <= n &&
                          n <= MURK_SHARDS_MAX;
    if (is_shard) {
        *out = (murk_shard){(uint32_t)k, (uint32_t)n};
    }
    return is_shard;
}

/* The lines before those of the rows. */
static murk_status read_head(part *p, const murk_sweep *sweep, murk_error *err)
{
    const murk_sweep_desc *desc = &sweep->desc;
    uint64_t rows = 0;
    const char *line = next_line(p);
    if (!line || strcmp(line, MARK) != 0) {
        return bad_part(p, "the mark \"" MARK "\" is missing", err);
    }
    const char *version = next_fact(p, "version");
    const murk_status status = murk_shard_check_version(
        version[0] ? version : "?", SIZE_MAX, desc->version, p->path, err);
    if (status) {
        return status;
    }
    /* The study, the number of the part, and the number of rows. */
    p->has_other_study =
        strcmp(next_fact(p, "study"), desc->study->sha256) != 0;
    p->has_other_scene =
        strcmp(next_fact(p, "scene"), sweep->scene_sha256) != 0;
    if (!read_shard(&p->shard, next_fact(p, "part")) ||
        !murk_count_parse(next_fact(p, "rows"), &rows)) {
        return bad_part(p, "the number of the part or of rows is missing", err);
    }
    return rows == desc->study->rows ? MURK_OK
                                     : murk_fail(err, MURK_BAD_VALUE, p->path,
                                                 "made for a study of %" PRIu64
                                                 " rows, this one has %zu",
                                                 rows, desc->study->rows);
}

/* Checks the number of the part against the parts before. */
static murk_status check_number(reading *r, const part *p, murk_error *err)
{
    if (r->count == 0) {
        r->count = p->shard.count;
        r->has = calloc(r->count, sizeof *r->has);
        if (!r->has) {
            return murk_no_memory(err, p->path, "for %u parts", r->count);
        }
    }
    if (p->shard.count != r->count) {
        return murk_fail(err, MURK_BAD_VALUE, p->path,
                         "part %u of %u, other parts are of %u",
                         p->shard.number, p->shard.count, r->count);
    }
    r->has[p->shard.number - 1] = true;
    return MURK_OK;
}

/* Takes over row i from the part if the file of the row is the one that the
 * part wrote, with its grid. */
static void take_row(reading *r, const part *p, size_t i)
{
    murk_sweep_row *row = &r->sweep->row[i];
    murk_sweep there = *r->sweep; /* the same rows, stored in another folder */
    char sum[MURK_ROW_SUM_SIZE];
    there.desc.folder = p->folder;
    if (!row->is_done && !murk_sweep_sum_row(sum, &there, row->key, NULL) &&
        strcmp(sum, r->sum[i]) == 0) {
        murk_sweep_load_row(&there, i);
        row->part = row->is_done ? p->number : 0;
    }
}

/* The line of row i. */
static murk_status read_row(reading *r, part *p, size_t i, murk_error *err)
{
    const murk_sweep *sweep = r->sweep;
    char *key = next_line(p), *sum = key ? strchr(key, ' ') : NULL;
    if (!sum) {
        return bad_part(p, "lines of rows are missing", err);
    }
    *sum++ = '\0';
    if (strcmp(key, key_of(sweep, i)) != 0) {
        return murk_fail(err, MURK_BAD_VALUE, p->path,
                         "made for another row %zu of the study: %s", i + 1,
                         p->has_other_study   ? "the study file has changed"
                         : p->has_other_scene ? "the scene has changed"
                                              : "an option, or a file that the "
                                                "scene names, is another one");
    }
    if (strcmp(sum, "-") == 0) {
        return MURK_OK;
    }
    /* A row that the part has. */
    const size_t group = sweep->row[i].group;
    if (strlen(sum) != MURK_ROW_SUM_SIZE - 1 || group == SIZE_MAX ||
        group % p->shard.count != p->shard.number - 1) {
        return bad_part(p, "it has rows of other parts", err);
    }
    if (r->sum[i][0] && strcmp(r->sum[i], sum) != 0) {
        return murk_fail(err, MURK_BAD_VALUE, p->path,
                         "part %u of %u again, and row %zu other than in %s",
                         p->shard.number, p->shard.count, i + 1,
                         sweep->desc.part[r->from[i] - 1]);
    }
    r->from[i] = r->sum[i][0] ? r->from[i] : p->number;
    memcpy(r->sum[i], sum, MURK_ROW_SUM_SIZE);
    take_row(r, p, i);
    return MURK_OK;
}

static murk_status read_part(reading *r, part *p, murk_error *err)
{
    const murk_sweep *sweep = r->sweep;
    size_t size = 0;
    murk_sweep there = *sweep;
    there.desc.folder = p->folder;
    murk_status status = murk_sweep_path(p->path, &there, NAME, err);
    if (!status) {
        status = murk_file_read_own(
            &p->text, &size, p->path,
            HEAD_BYTES_MAX + (size_t)LINE_BYTES * MURK_STUDY_ROWS_MAX, err);
    }
    if (status) {
        return status;
    }
    /* The head, then a line a row, and nothing behind. */
    p->at = p->text;
    status = read_head(p, sweep, err);
    if (!status) {
        status = check_number(r, p, err);
    }
    for (size_t i = 0; i < sweep->desc.study->rows && !status; ++i) {
        status = read_row(r, p, i, err);
    }
    return !status && p->at != p->text + size
               ? bad_part(p, "more lines than rows", err)
               : status;
}

static bool has_part(const void *of, uint32_t number)
{
    const reading *r = of;
    return r->has[number - 1];
}

/* Warns of missing parts, and of rows that cannot be taken over. */
static void warn(const reading *r)
{
    const murk_sweep *sweep = r->sweep;
    murk_shards_warn_of_missing(has_part, r, r->count,
                                "their rows are run now");
    /* Rows that a part has, whose files are not those that it wrote. */
    for (size_t i = 0; i < sweep->desc.study->rows; ++i) {
        if (r->sum[i][0] && !sweep->row[i].is_done) {
            murk_warn(sweep->desc.part[r->from[i] - 1],
                      "the files of row %zu are damaged or missing: it is run "
                      "now",
                      i + 1);
        }
    }
}

murk_status murk_sweep_parts_read(murk_sweep *sweep, murk_error *err)
{
    const murk_sweep_desc *desc = &sweep->desc;
    const size_t rows = desc->study->rows;
    reading r = {.sweep = sweep,
                 .sum = calloc(rows, sizeof *r.sum),
                 .from = calloc(rows, sizeof *r.from)};
    murk_status status = r.sum && r.from
                             ? MURK_OK
                             : murk_no_memory(err, "", "for %zu rows", rows);
    for (size_t i = 0; i < desc->parts && !status; ++i) {
        part p = {.folder = desc->part[i], .number = i + 1};
        status = read_part(&r, &p, err);
        free(p.text);
    }
    if (!status) {
        warn(&r);
    }
    free(r.has);
    free(r.sum);
    free(r.from);
    return status;
}

/* ---- copying ---- */

/* Copies the grid of row i from the folder of the part, unless it is there. */
static murk_status copy_grid(const murk_sweep *sweep, size_t i, murk_error *err)
{
    const murk_sweep_row *row = &sweep->row[i];
    char path[MURK_SWEEP_PATH_SIZE], from[MURK_SWEEP_PATH_SIZE];
    murk_sweep there = *sweep;
    there.desc.folder = sweep->desc.part[row->part - 1];
    if (murk_sweep_has_fluence(sweep, i, &row->found)) {
        return MURK_OK;
    }
    murk_status status = murk_sweep_fluence_path(path, sweep, i, err);
    if (!status) {
        status = murk_sweep_fluence_path(from, &there, i, err);
    }
    return status
               ? status
               : murk_file_copy_own(path, from, MURK_SWEEP_GRID_BYTES_MAX, err);
}

/* Copies row i with its grid. The text is printed again, which gives the bytes
 * of the file in the part. */
static murk_status copy_row(murk_sweep *sweep, size_t i, murk_error *err)
{
    murk_sweep_row *row = &sweep->row[i];
    char *text = murk_study_row_print(&row->found, i);
    const char *end = text ? strchr(text, '\n') : NULL;
    murk_status status =
        end ? copy_grid(sweep, i, err) : murk_no_memory(err, "", "for a row");
    if (!status) {
        const murk_sweep_message message = {
            .number = i, .text = end + 1, .size = strlen(end + 1)};
        status = murk_sweep_keep(sweep, row->key, &message, err);
    }
    free(text);
    row->part = status ? row->part : 0;
    return status;
}

murk_status murk_sweep_parts_copy(murk_sweep *sweep, murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0;
         sweep->desc.folder && i < sweep->desc.study->rows && !status; ++i) {
        if (sweep->row[i].part) {
            status = copy_row(sweep, i, err);
        }
    }
    return status;
}
