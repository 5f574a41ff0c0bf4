/* Reader of OR-Library's set covering files: the numbers of rows and columns;
 * the cost of each column; for each row the number of columns that cover it,
 * then these columns, counted from 1. Blanks, tabs and line ends separate
 * numbers. As an extension the weights of all rows may follow.
 *
 * Source: Beasley, J. Oper. Res. Soc. 41 (1990) 1069,
 * doi:10.1057/jors.1990.166. */
#include "sparse/read.h"

#include "base/number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Bytes of a token with the '\0', more than a number needs; a longer token is
 * cut and refused. */
#define TOKEN_SIZE 64

typedef struct reader {
    const char *next;
    murk_text_place place; /* of `next` */
    murk_text_place at;    /* of the token */
    char token[TOKEN_SIZE];
    murk_error *err;
} reader;

/* Reads a token; false at the end of the text. A token that is too long for a
 * number is cut and ends with "...", so it is refused as a number. */
static bool read_token(reader *r)
{
    for (; *r->next && strchr(" \t\r\n", *r->next); ++r->next) {
        ++r->place.column;
        if (*r->next == '\n') {
            ++r->place.line;
            r->place.column = 1;
        }
    }
    r->at = r->place;
    const size_t length = strcspn(r->next, " \t\r\n");
    const size_t copied = length < TOKEN_SIZE ? length : TOKEN_SIZE - 1;
    memcpy(r->token, r->next, copied);
    r->token[copied] = '\0';
    if (length > copied) {
        memcpy(r->token + copied - 3, "...", 3);
    }
    r->next += length;
    r->place.column += length;
    return length > 0;
}

static murk_status read_whole(reader *r, const char *what, size_t low,
                              size_t high, size_t *out)
{
    uint64_t value = 0;
    if (!read_token(r)) {
        return murk_fail_at(r->err, r->at, "the file ends before %s", what);
    }
    if (!murk_count_parse(r->token, &value) || value < low || value > high) {
        return murk_fail_at(r->err, r->at,
                            "%s: %s, must be a whole number %zu..%zu", what,
                            r->token, low, high);
    }
    *out = (size_t)value;
    return MURK_OK;
}

static murk_status read_weight(reader *r, const char *what, double *out)
{
    if (!read_token(r)) {
        return murk_fail_at(r->err, r->at, "the file ends before %s", what);
    }
    return murk_sparse_weight_parse(r->token, out)
               ? MURK_OK
               : murk_fail_at(r->err, r->at,
                              "%s: %s, must be 0 or a number 1e-12..1e12", what,
                              r->token);
}

/* Reads the numbers of rows and columns. They are compared with the size of the
 * rest of the file before memory is allocated: each column has a cost and each
 * row has a count, each of two bytes or more with the blank before the number.
 */
static murk_status read_sizes(reader *r, murk_sparse_builder *b)
{
    murk_status status = read_whole(r, "rows", 1, UINT32_MAX - 1, &b->rows);
    if (!status) {
        status = read_whole(r, "columns", 1, UINT32_MAX - 1, &b->columns);
    }
    const size_t max = (strlen(r->next) + 1) / 2;
    if (!status && b->rows + b->columns > max) {
        status = murk_fail_at(r->err, r->at,
                              "%zu rows and %zu columns need %zu numbers more, "
                              "the file has room for %zu at most",
                              b->rows, b->columns, b->rows + b->columns, max);
    }
    return status;
}

static murk_status read_row(reader *r, murk_sparse_builder *b, size_t row)
{
    char what[128];
    size_t n = 0, column = 0;
    snprintf(what, sizeof what, "the count of row %zu", row + 1);
    murk_status status = read_whole(r, what, 0, b->columns, &n);
    for (size_t k = 0; k < n && !status; ++k) {
        snprintf(what, sizeof what, "column %zu of %zu of row %zu", k + 1, n,
                 row + 1);
        status = read_whole(r, what, 1, b->columns, &column);
        if (!status) {
            status = murk_sparse_builder_put(b, row, column - 1, r->at.line, 1,
                                             r->err);
        }
    }
    return status;
}

/* Reads the weights of all rows, if there are any. */
static murk_status read_weights(reader *r, murk_sparse_builder *b)
{
    if (r->next[strspn(r->next, " \t\r\n")] == '\0') {
        return MURK_OK;
    }
    b->weight = malloc(b->rows * sizeof *b->weight);
    if (!b->weight) {
        return murk_no_memory(r->err, b->path, "for the weights");
    }
    /* One weight for each row, and nothing behind them. */
    murk_status status = MURK_OK;
    char what[128];
    for (size_t i = 0; i < b->rows && !status; ++i) {
        snprintf(what, sizeof what,
                 "behind the last row, the weight of row %zu of %zu", i + 1,
                 b->rows);
        status = read_weight(r, what, &b->weight[i]);
    }
    if (!status && read_token(r)) {
        status = murk_fail_at(r->err, r->at,
                              "%s behind the last weight, must be the end of "
                              "the file",
                              r->token);
    }
    return status;
}

murk_status murk_sparse_read_or_library(murk_sparse_builder *b,
                                        const char *text, murk_error *err)
{
    reader r = {.next = text, .place = {b->path, 1, 1}, .err = err};
    b->format = MURK_MATRIX_OR_LIBRARY;
    murk_status status = read_sizes(&r, b);
    if (status) {
        return status;
    }
    b->cost = malloc(b->columns * sizeof *b->cost);
    if (!b->cost) {
        return murk_no_memory(err, b->path, "for the costs");
    }
    for (size_t j = 0; j < b->columns && !status; ++j) {
        char what[128];
        snprintf(what, sizeof what, "the cost of column %zu of %zu", j + 1,
                 b->columns);
        status = read_weight(&r, what, &b->cost[j]);
    }
    for (size_t i = 0; i < b->rows && !status; ++i) {
        status = read_row(&r, b, i);
    }
    return status ? status : read_weights(&r, b);
}
