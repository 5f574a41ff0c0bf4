/* Reader of coverage matrices in CSV: dense, with one line a row and one cell a
 * column; or, under a header with `row` and `column`, sparse with one line an
 * entry. A dense file may have a header of names, and under the header cells of
 * labels and weights. A line of a sparse file may also name a row or a column
 * alone, or give the weight of a row. */
#include "sparse/read.h"

#include "base/csv.h"
#include "base/number.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct reader {
    murk_csv csv;
    const char *line_begin;
    size_t line; /* the last line that was read */
    char **cell; /* [cells] of that line */
    size_t cells, capacity;
    double *weight; /* [weight_capacity]; NAN: not given so far */
    size_t weight_capacity;
    murk_sparse_builder *b;
    murk_error *err;
} reader;

static murk_status no_memory(const reader *r)
{
    return murk_no_memory(r->err, r->b->path, "for the matrix");
}

static murk_text_place place_of(const reader *r, size_t k)
{
    return (murk_text_place){r->b->path, r->line,
                             (size_t)(r->cell[k] - r->line_begin) + 1};
}

/* ---- lines and cells ---- */

/* Fills cell[cells] from the next line that is neither blank nor a comment.
 * *is_end is true, and cells is 0, if there is no such line. */
static murk_status read_line(reader *r, bool *is_end)
{
    r->cells = 0;
    *is_end = !murk_csv_find_line(&r->csv);
    r->line_begin = r->csv.next;
    r->line = r->csv.line;
    for (bool is_last = *is_end; !is_last; ++r->cells) {
        if (r->cells == r->capacity) {
            const size_t capacity = r->capacity ? 2 * r->capacity : 64;
            char **grown = realloc(r->cell, capacity * sizeof *grown);
            if (!grown) {
                return no_memory(r);
            }
            r->cell = grown;
            r->capacity = capacity;
        }
        const char *fault =
            murk_csv_read_cell(&r->csv, &r->cell[r->cells], &is_last);
        if (fault) {
            return murk_fail_at(r->err, place_of(r, r->cells), "%s", fault);
        }
    }
    return MURK_OK;
}

/* ---- numbers ---- */

static murk_status read_clarity(const reader *r, size_t k, double *out)
{
    if (!murk_number_parse(r->cell[k], out) || !(*out >= 0 && *out <= 1)) {
        return murk_fail_at(r->err, place_of(r, k),
                            "clarity \"%.40s\", must be a number 0..1",
                            r->cell[k]);
    }
    return MURK_OK;
}

static murk_status read_weight(const reader *r, size_t k, double *out)
{
    if (!murk_sparse_weight_parse(r->cell[k], out)) {
        return murk_fail_at(r->err, place_of(r, k),
                            "weight \"%.40s\", must be 0 or a number "
                            "1e-12..1e12",
                            r->cell[k]);
    }
    return MURK_OK;
}

/* Makes space for the weight of a row; new weights are NAN. */
static murk_status need_weight(reader *r, size_t row)
{
    if (row < r->weight_capacity) {
        return MURK_OK;
    }
    const size_t capacity = row < 512 ? 1024 : 2 * row;
    double *weight = realloc(r->weight, capacity * sizeof *weight);
    if (!weight) {
        return no_memory(r);
    }
    for (size_t i = r->weight_capacity; i < capacity; ++i) {
        weight[i] = NAN;
    }
    r->weight = weight;
    r->weight_capacity = capacity;
    return MURK_OK;
}

/* ---- dense ---- */

/* The meaning of a cell in a dense line. */
typedef enum part { ENTRY, WEIGHT, LABEL } part;

typedef struct dense {
    part *part; /* [cells] */
    size_t cells;
    bool has_weight;
} dense;

/* True for a header: names only, except for the first cell, which may be empty
 * above a column of labels. A text that C takes for a number is no name (nan,
 * 0x10). */
static bool is_header(const reader *r)
{
    for (size_t k = 0; k < r->cells; ++k) {
        const char *text = r->cell[k];
        char *end = NULL;
        (void)strtod(text, &end);
        if (*text ? *end == '\0' : k > 0 || r->cells == 1) {
            return false;
        }
    }
    return true;
}

static murk_status name_columns(dense *d, const reader *r)
{
    murk_sparse_builder *b = r->b;
    b->name = calloc(r->cells, sizeof *b->name);
    if (!b->name) {
        return no_memory(r);
    }
    for (size_t k = 0; k < r->cells; ++k) {
        const char *text = r->cell[k];
        if (strcmp(text, "weight") == 0) {
            if (d->has_weight) {
                return murk_fail_at(r->err, place_of(r, k),
                                    "a second column weight, must be one");
            }
            d->part[k] = WEIGHT;
            d->has_weight = true;
        } else if (k == 0 && (!*text || strcmp(text, "row") == 0)) {
            d->part[k] = LABEL;
        } else if (!(b->name[b->columns++] = strdup(text))) {
            return no_memory(r);
        }
    }
    return MURK_OK;
}

static murk_status put_dense_line(const dense *d, reader *r)
{
    murk_sparse_builder *b = r->b;
    if (r->cells != d->cells) {
        return murk_fail_at(r->err, place_of(r, r->cells - 1),
                            "the line has %zu cells, the first has %zu",
                            r->cells, d->cells);
    }
    const size_t row = b->rows++;
    murk_status status = d->has_weight ? need_weight(r, row) : MURK_OK;
    size_t column = 0;
    double value = 0;
    for (size_t k = 0; k < r->cells && !status; ++k) {
        if (d->part[k] == WEIGHT) {
            status = read_weight(r, k, &r->weight[row]);
        } else if (d->part[k] == ENTRY) {
            status = read_clarity(r, k, &value);
            if (!status) {
                status = murk_sparse_builder_put(b, row, column++, r->line,
                                                 value, r->err);
            }
        }
    }
    return status;
}

/* Reads the dense format; the first line has been read already. */
static murk_status read_dense(reader *r)
{
    dense d = {calloc(r->cells, sizeof *d.part), r->cells, false};
    murk_status status = d.part ? MURK_OK : no_memory(r);
    bool is_end = false;
    if (!status && is_header(r)) {
        status = name_columns(&d, r);
        if (!status) {
            status = read_line(r, &is_end);
        }
    } else {
        r->b->columns = r->cells;
    }
    while (!status && !is_end) {
        status = put_dense_line(&d, r);
        if (!status) {
            status = read_line(r, &is_end);
        }
    }
    free(d.part);
    return status;
}

/* ---- sparse ---- */

/* The columns of the sparse format, by name. */
#define PARTS 4
static const char *const part_name[PARTS] = {"row", "column", "clarity",
                                             "weight"};

typedef struct sparse {
    long at[PARTS]; /* cell of each part in a line; -1: missing */
    size_t cells;
    uint8_t *named[2]; /* [capacity] rows and columns that some line names */
    size_t capacity[2];
    size_t lines;
} sparse;

static bool find_parts(sparse *s, const reader *r)
{
    for (int p = 0; p < PARTS; ++p) {
        s->at[p] = -1;
        for (size_t k = r->cells; k-- > 0;) {
            if (strcmp(r->cell[k], part_name[p]) == 0) {
                s->at[p] = (long)k;
            }
        }
    }
    s->cells = r->cells;
    return s->at[0] >= 0 && s->at[1] >= 0;
}

static murk_status check_header(const sparse *s, const reader *r)
{
    for (size_t k = 0; k < r->cells; ++k) {
        bool is_known = false;
        for (int p = 0; p < PARTS; ++p) {
            is_known = is_known || s->at[p] == (long)k;
        }
        if (!is_known) {
            return murk_fail_at(r->err, place_of(r, k),
                                "column \"%.40s\", must be row, column, "
                                "clarity and weight, each once",
                                r->cell[k]);
        }
    }
    return MURK_OK;
}

static bool is_given(const sparse *s, const reader *r, int p)
{
    return s->at[p] >= 0 && *r->cell[s->at[p]];
}

/* Reads the number of the row (p = 0) or column (p = 1) that a line names, from
 * 1; *out is 0 if the line names none. The file must name every number from 1
 * to the largest, so a number is refused if it exceeds the number of lines so
 * far plus the bytes from this line to the end of the file, of which each
 * further line needs one or more. */
static murk_status read_number(sparse *s, const reader *r, int p, size_t *out)
{
    *out = 0;
    if (!is_given(s, r, p)) {
        return MURK_OK;
    }
    /* A whole number within the limit. */
    const size_t k = (size_t)s->at[p];
    const size_t max = (size_t)(r->csv.end - r->line_begin) + s->lines;
    uint64_t value = 0;
    if (!murk_count_parse(r->cell[k], &value) || value < 1) {
        return murk_fail_at(r->err, place_of(r, k),
                            "%s \"%.40s\", must be a whole number from 1",
                            part_name[p], r->cell[k]);
    }
    if (value > max) {
        return murk_fail_at(r->err, place_of(r, k),
                            "%s %llu, but the file can name no more than %zu: "
                            "they are numbered from 1 without gaps",
                            part_name[p], (unsigned long long)value, max);
    }
    /* Record that the number is named. */
    if (value > s->capacity[p]) {
        const size_t capacity = 2 * (size_t)value;
        uint8_t *named = realloc(s->named[p], capacity);
        if (!named) {
            return no_memory(r);
        }
        memset(named + s->capacity[p], 0, capacity - s->capacity[p]);
        s->named[p] = named;
        s->capacity[p] = capacity;
    }
    s->named[p][value - 1] = 1;
    *out = (size_t)value;
    return MURK_OK;
}

static murk_status put_weight(const sparse *s, reader *r, size_t row)
{
    const size_t k = (size_t)s->at[3];
    double weight = 0;
    murk_status status = read_weight(r, k, &weight);
    if (!status && row == 0) {
        status = murk_fail_at(r->err, place_of(r, k), "a weight without a row");
    }
    if (!status) {
        status = need_weight(r, row - 1);
    }
    if (!status && !isnan(r->weight[row - 1]) &&
        !(r->weight[row - 1] == weight)) {
        status = murk_fail_at(r->err, place_of(r, k),
                              "weight %g of row %zu, which a line above says "
                              "is %g",
                              weight, row, r->weight[row - 1]);
    }
    if (!status) {
        r->weight[row - 1] = weight;
    }
    return status;
}

static murk_status put_sparse_line(sparse *s, reader *r)
{
    murk_sparse_builder *b = r->b;
    size_t row = 0, column = 0;
    double clarity = 1;
    ++s->lines;
    if (r->cells != s->cells) {
        return murk_fail_at(r->err, place_of(r, r->cells - 1),
                            "the line has %zu cells, the header has %zu",
                            r->cells, s->cells);
    }
    /* Row and column, weight, clarity. */
    murk_status status = read_number(s, r, 0, &row);
    if (!status) {
        status = read_number(s, r, 1, &column);
    }
    if (!status && row == 0 && column == 0) {
        status = murk_fail_at(r->err, place_of(r, 0),
                              "names neither a row nor a column");
    }
    if (!status && is_given(s, r, 3)) {
        status = put_weight(s, r, row);
    }
    if (!status && is_given(s, r, 2)) {
        status = read_clarity(r, (size_t)s->at[2], &clarity);
        if (!status && (row == 0 || column == 0)) {
            status = murk_fail_at(r->err, place_of(r, (size_t)s->at[2]),
                                  "a clarity needs a row and a column");
        }
    }
    if (!status && row && column) {
        status = murk_sparse_builder_put(b, row - 1, column - 1, r->line,
                                         clarity, r->err);
    }
    b->rows = row > b->rows ? row : b->rows;
    b->columns = column > b->columns ? column : b->columns;
    return status;
}

static murk_status check_gaps(const sparse *s, const reader *r)
{
    const size_t n[2] = {r->b->rows, r->b->columns};
    for (int p = 0; p < 2; ++p) {
        for (size_t i = 0; i < n[p]; ++i) {
            if (!s->named[p][i]) {
                return murk_fail(r->err, MURK_BAD_FILE, r->b->path,
                                 "%s %zu of 1..%zu is in no line; one that "
                                 "covers nothing or is not covered has a line "
                                 "with its number alone",
                                 part_name[p], i + 1, n[p]);
            }
        }
    }
    return MURK_OK;
}

static murk_status read_sparse(sparse *s, reader *r)
{
    bool is_end = false;
    r->b->format = MURK_MATRIX_SPARSE_CSV;
    murk_status status = check_header(s, r);
    while (!status && !is_end) {
        status = read_line(r, &is_end);
        if (!status && !is_end) {
            status = put_sparse_line(s, r);
        }
    }
    return status ? status : check_gaps(s, r);
}

murk_status murk_sparse_read_csv(murk_sparse_builder *b, char *text,
                                 size_t size, murk_error *err)
{
    reader r = {.csv = {text, text + size, 1, true}, .b = b, .err = err};
    sparse s = {0};
    bool is_end = false;
    b->format = MURK_MATRIX_DENSE_CSV;
    murk_status status = read_line(&r, &is_end);
    if (!status && is_end) {
        status = murk_fail(err, MURK_BAD_FILE, b->path,
                           "has comments alone, must be a coverage matrix");
    }
    if (!status && r.cells == 1 && strchr(r.cell[0], ';')) {
        status = murk_fail_at(err, place_of(&r, 0),
                              "semicolons and no comma: cells are separated by "
                              "commas, decimals by points");
    }
    if (!status) {
        status = find_parts(&s, &r) ? read_sparse(&s, &r) : read_dense(&r);
    }
    for (size_t i = 0; !status && r.weight && i < b->rows; ++i) {
        status = need_weight(&r, i);
        if (!status && isnan(r.weight[i])) {
            r.weight[i] =
                1; /* weights are given for some rows, and not for this one */
        }
    }
    b->weight = r.weight;
    free(s.named[0]);
    free(s.named[1]);
    free(r.cell);
    return status;
}
