/* Reads files of measurements.
 *
 * AERONET: the download of version 2 or 3 (aeronet.gsfc.nasa.gov) begins with
 * some lines about site and quality. The row of names below them is recognised
 * by its column of the date. Missing values are -999.
 *
 * SeaBASS: a header of /KEY=VALUE lines names the fields, their units, the
 * delimiter and the values that stand for none; lines that begin with "!" are
 * comments. Source: Werdell and Bailey, NASA/TM-2002-211617 (2002), and the
 * format's page at seabass.gsfc.nasa.gov. */
#include "readings/field_file.h"

#include "base/number.h"
#include "base/words.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The lines above the names of AERONET's columns are six or seven. */
#define PREAMBLE_MAX 40

/* What AERONET writes where there is no measurement. */
#define AERONET_MISSING (-999.0)

/* Editors of text write it before UTF-8; it means nothing. */
#define BYTE_ORDER_MARK "\xEF\xBB\xBF"

/* Limits against hostile files, as those of tables. */
#define COLUMNS_MAX 1000
#define CELLS_MAX   20000000

const char *const murk_field_formats[MURK_FIELD_FORMATS] = {
    [MURK_FIELD_CSV] = "csv",
    [MURK_FIELD_AERONET] = "aeronet",
    [MURK_FIELD_SEABASS] = "seabass"};

static murk_status fail_at(const char *path, size_t line, const char *text,
                           murk_error *err)
{
    char where[320];
    snprintf(where, sizeof where, "%.290s:%zu", path, line);
    return murk_fail(err, MURK_BAD_FILE, where, "%s", text);
}

static murk_status no_memory(const char *path, murk_error *err)
{
    return murk_no_memory(err, path, "for its measurements");
}

/* ---- AERONET ---- */

static murk_status read_aeronet(murk_field_file *out, const char *path,
                                char *text, size_t size, murk_error *err)
{
    /* Find the row of names. */
    size_t line = 1;
    const char *row = text;
    const char *found = NULL;
    while (line <= PREAMBLE_MAX && !found) {
        const size_t length = strcspn(row, "\n");
        const char *date = strstr(row, "Date(");
        if (date && date < row + length &&
            memchr(row, ',', length)) { /* a line of text may have a date */
            found = row;
        } else if (row[length] == '\0') {
            break;
        } else {
            row += length + 1;
            ++line;
        }
    }
    if (!found) {
        free(text);
        return murk_fail(err, MURK_BAD_FILE, path,
                         "no AERONET file: no row of names with a column "
                         "Date(dd:mm:yyyy) in its first %d lines",
                         PREAMBLE_MAX);
    }
    out->missing[out->n_missing++] = AERONET_MISSING;
    return murk_table_parse_from(&out->table, path, text, size, line, err);
}

/* ---- SeaBASS ---- */

/* The rest of the text, by lines. */
typedef struct cursor {
    const char *path;
    char *next;
    char *line;    /* the line that was read last, without blanks around it */
    size_t number; /* of this line, from 1 */
    murk_error *err;
} cursor;

static char *trimmed(char *text)
{
    while (isspace((unsigned char)*text)) {
        ++text;
    }
    char *end = text + strlen(text);
    while (end > text && isspace((unsigned char)end[-1])) {
        --end;
    }
    *end = '\0';
    return text;
}

/* Reads the next line that is neither empty nor a comment; false at the end. */
static bool next_line(cursor *at)
{
    do {
        if (*at->next == '\0') {
            return false;
        }
        at->line = at->next;
        at->next += strcspn(at->next, "\n");
        if (*at->next) {
            *at->next++ = '\0';
        }
        at->line = trimmed(at->line);
        ++at->number;
    } while (at->line[0] == '\0' || at->line[0] == '!');
    return true;
}

/* The keys of a header that are needed. The first three state numbers that
 * stand for no measurement. */
enum { MISSING, BELOW, ABOVE, FIELDS, UNITS, DELIMITER, KEYS };
_Static_assert(FIELDS == MURK_FIELD_MISSING_MAX, "a key for each number");

static const char *const KEY[KEYS] = {"missing",
                                      "below_detection_limit",
                                      "above_detection_limit",
                                      "fields",
                                      "units",
                                      "delimiter"};

typedef struct header {
    char *value[KEYS]; /* NULL: not given */
    size_t line[KEYS];
} header;

static murk_status read_missing(murk_field_file *out, const cursor *at,
                                const char *value)
{
    double number;
    if (!murk_number_parse(value, &number)) {
        return fail_at(at->path, at->number,
                       "a value that stands for none must be a number",
                       at->err);
    }
    out->missing[out->n_missing++] = number;
    return MURK_OK;
}

/* Takes what is needed of one line of the header, /KEY=VALUE. */
static murk_status take_key(murk_field_file *out, header *h, const cursor *at)
{
    char *value = strchr(at->line, '=');
    if (!value) {
        return MURK_OK;
    }
    *value++ = '\0';
    const char *name = trimmed(at->line + 1);
    int key = 0;
    while (key < KEYS && strcasecmp(name, KEY[key]) != 0) {
        ++key;
    }
    if (key == KEYS) {
        return MURK_OK;
    }
    if (h->value[key]) {
        char what[64];
        snprintf(what, sizeof what, "/%s is there twice", KEY[key]);
        return fail_at(at->path, at->number, what, at->err);
    }
    h->value[key] = trimmed(value);
    h->line[key] = at->number;
    return key < FIELDS ? read_missing(out, at, h->value[key]) : MURK_OK;
}

static murk_status read_header(murk_field_file *out, header *h, cursor *at)
{
    if (!next_line(at) || strcasecmp(at->line, "/begin_header") != 0) {
        return fail_at(at->path, at->number ? at->number : 1,
                       "no SeaBASS file: must begin with /begin_header",
                       at->err);
    }
    /* Take what is needed of each line, up to the end of the header. */
    while (next_line(at)) {
        if (strcasecmp(at->line, "/end_header") == 0) {
            return h->value[FIELDS]
                       ? MURK_OK
                       : fail_at(at->path, at->number,
                                 "the header ends without /fields", at->err);
        }
        if (at->line[0] != '/') {
            return fail_at(at->path, at->number,
                           "no line of a header: must begin with / or !, and "
                           "the header end with /end_header",
                           at->err);
        }
        const murk_status status = take_key(out, h, at);
        if (status) {
            return status;
        }
    }
    return fail_at(at->path, at->number,
                   "the file ends within its header, before /end_header",
                   at->err);
}

/* The byte that separates cells: comma, tab, or a blank for any number of
 * blanks and tabs. */
static murk_status find_delimiter(char *out, const header *h, const cursor *at)
{
    static const struct {
        const char *word;
        char byte;
    } known[] = {{"comma", ','}, {"space", ' '}, {"tab", '\t'}};
    if (!h->value[DELIMITER]) {
        *out = ' ';
        return MURK_OK;
    }
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i) {
        if (strcasecmp(h->value[DELIMITER], known[i].word) == 0) {
            *out = known[i].byte;
            return MURK_OK;
        }
    }
    return murk_fail(at->err, MURK_BAD_FILE, at->path,
                     "/delimiter=%.40s, must be comma, space or tab",
                     h->value[DELIMITER]);
}

/* Cuts text into cells in place; returns their number, of which the first `max`
 * are in cell[]. */
static size_t cut(char **cell, size_t max, char *text, char delimiter)
{
    size_t n = 0;
    char *next = text;
    while (next) {
        char *begin = next;
        const char by[] = {delimiter, delimiter == ' ' ? '\t' : '\0', '\0'};
        next = strpbrk(begin, by);
        if (next) {
            *next++ = '\0';
            /* Any number of blanks is one delimiter. */
            next += delimiter == ' ' ? strspn(next, by) : 0;
        }
        if (n < max) {
            cell[n] = trimmed(begin);
        }
        ++n;
    }
    return n;
}

/* Fails if a name is empty or there twice: a mapping could mean either. */
static murk_status check_names(const murk_table *table, const cursor *at)
{
    char what[96], shown[48];
    for (size_t i = 0; i < table->columns; ++i) {
        const char *name = table->name[i];
        const bool is_empty = name[0] == '\0';
        if (is_empty || murk_table_column(table, name) != (long)i) {
            murk_words_show(shown, sizeof shown, name);
            snprintf(what, sizeof what, "/fields has %s%s",
                     is_empty ? "an empty name" : shown,
                     is_empty ? "" : " twice");
            return fail_at(at->path, (size_t)table->header_line, what, at->err);
        }
    }
    return MURK_OK;
}

/* Reads the names of the columns, and their units. */
static murk_status read_names(murk_field_file *out, const header *h,
                              const cursor *at)
{
    murk_table *table = out->table;
    table->name = calloc(COLUMNS_MAX, sizeof *table->name);
    out->unit = murk_arena_array(&out->arena, COLUMNS_MAX, sizeof *out->unit);
    if (!table->name || !out->unit) {
        return no_memory(at->path, at->err);
    }
    table->header_line = (int)h->line[FIELDS];
    table->columns = cut(table->name, COLUMNS_MAX, h->value[FIELDS], ',');
    if (table->columns > COLUMNS_MAX) {
        table->columns = 0;
        return fail_at(at->path, h->line[FIELDS], "more than 1000 fields",
                       at->err);
    }
    /* As many units as names, or none. */
    out->unit_line = (int)h->line[UNITS];
    if (!h->value[UNITS]) {
        out->unit = NULL;
    } else if (cut(out->unit, COLUMNS_MAX, h->value[UNITS], ',') !=
               table->columns) {
        return fail_at(at->path, h->line[UNITS],
                       "/units must have as many items as /fields", at->err);
    }
    return check_names(table, at);
}

/* Reads the rows below the header. */
static murk_status read_rows(murk_table *table, char delimiter, cursor *at)
{
    /* As many rows as the rest of the text has lines, or fewer. */
    size_t lines = 1;
    for (const char *p = at->next; *p; ++p) {
        lines += *p == '\n';
    }
    if (lines > CELLS_MAX / table->columns) {
        return murk_fail(at->err, MURK_BAD_FILE, at->path,
                         "too large, must be at most 2e7 cells");
    }
    table->cell = calloc(lines * table->columns, sizeof *table->cell);
    table->line = calloc(lines, sizeof *table->line);
    if (!table->cell || !table->line) {
        return no_memory(at->path, at->err);
    }
    while (next_line(at)) {
        char **row = table->cell + table->rows * table->columns;
        const size_t n = cut(row, table->columns, at->line, delimiter);
        if (n != table->columns) {
            char text[120];
            snprintf(text, sizeof text,
                     "%zu cells, must be %zu: one for each of /fields", n,
                     table->columns);
            return fail_at(at->path, at->number, text, at->err);
        }
        table->line[table->rows++] = (int)at->number;
    }
    return MURK_OK;
}

static murk_status read_seabass(murk_field_file *out, const char *path,
                                char *text, size_t size, murk_error *err)
{
    murk_table *table = calloc(1, sizeof *table);
    out->table = table;
    if (!table || !(table->path = strdup(path))) {
        free(text);
        return no_memory(path, err);
    }
    table->text = text;
    if (strlen(text) < size) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "no SeaBASS file: a NUL byte, must be text");
    }
    /* The header, then the rows. */
    const bool has_mark = strncmp(text, BYTE_ORDER_MARK, 3) == 0;
    cursor at = {.path = path, .next = text + 3 * has_mark, .err = err};
    header h = {0};
    char delimiter = ' ';
    murk_status status = read_header(out, &h, &at);
    status = status ? status : find_delimiter(&delimiter, &h, &at);
    status = status ? status : read_names(out, &h, &at);
    return status ? status : read_rows(table, delimiter, &at);
}

/* ---- all formats ---- */

murk_status murk_field_file_read(murk_field_file *out, murk_field_format format,
                                 const char *path, char *text, size_t size,
                                 murk_error *err)
{
    *out = (murk_field_file){0};
    switch (format) {
    case MURK_FIELD_AERONET:
        return read_aeronet(out, path, text, size, err);
    case MURK_FIELD_SEABASS:
        return read_seabass(out, path, text, size, err);
    default:
        return murk_table_parse(&out->table, path, text, size, err);
    }
}

void murk_field_file_release(murk_field_file *file)
{
    murk_table_destroy(file->table);
    murk_arena_release(&file->arena);
    *file = (murk_field_file){0};
}

bool murk_field_is_missing(const murk_field_file *file, const char *cell)
{
    double number;
    if (cell[0] == '\0' || strcasecmp(cell, "NA") == 0 ||
        strcasecmp(cell, "NaN") == 0) {
        return true;
    }
    bool is_missing = false;
    for (size_t i = 0; i < file->n_missing; ++i) {
        is_missing = is_missing || (murk_number_parse(cell, &number) &&
                                    number == file->missing[i]);
    }
    return is_missing;
}
