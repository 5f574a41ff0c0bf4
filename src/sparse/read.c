/* Reads a coverage matrix from a file: checks that the file is text, tells the
 * format by the first line that is neither blank nor a comment, and calls the
 * reader of that format. */
#include "sparse/read.h"

#include "base/file.h"
#include "base/number.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Largest file on the disk: line numbers, rows and columns stay within 32 bits.
 * Weights between 1e-12 and 1e12 (or 0) keep sums and ratios far from the
 * limits of a double. */
#define FILE_BYTES_MAX 4000000000u
#define WEIGHT_MIN     1e-12
#define WEIGHT_MAX     1e12

murk_status murk_fail_at(murk_error *err, murk_text_place place,
                         const char *format, ...)
{
    char where[320], text[600];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    snprintf(where, sizeof where, "%.270s:%zu:%zu", place.path, place.line,
             place.column);
    return murk_fail(err, MURK_BAD_FILE, where, "%s", text);
}

bool murk_sparse_weight_parse(const char *text, double *out)
{
    double value;
    if (!murk_number_parse(text, &value) ||
        !(value == 0 || (value >= WEIGHT_MIN && value <= WEIGHT_MAX))) {
        return false;
    }
    *out = value;
    return true;
}

/* True if the first line that is neither blank nor a comment (#) has only
 * characters of numbers, blanks and tabs: OR-Library's text has nothing else. A
 * CSV file is expected to have a comma, or another letter than e and E, in that
 * line. */
static bool is_or_library(const char *text)
{
    const char *p = text + strspn(text, " \t\r\n");
    while (*p == '#') {
        p += strcspn(p, "\n");
        p += strspn(p, " \t\r\n");
    }
    return *p && strspn(p, "0123456789+-.eE \t\r") >= strcspn(p, "\n");
}

/* Refuses an empty text and zero bytes. */
static murk_status check_text(const char *path, const char *text, size_t size,
                              murk_error *err)
{
    if (size == 0 || text[strspn(text, " \t\r\n")] == '\0') {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "is empty, must be a coverage matrix: CSV or "
                         "OR-Library text");
    }
    if (strlen(text) != size) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "byte %zu is 0: must be a text, CSV or OR-Library's",
                         strlen(text) + 1);
    }
    return MURK_OK;
}

murk_status murk_sparse_matrix_read(murk_sparse_matrix **out, const char *path,
                                    murk_error *err)
{
    char *text = NULL;
    char sha256[65];
    size_t size = 0;
    murk_sparse_builder builder = {.path = path};
    murk_status status =
        murk_file_read(&text, &size, path, FILE_BYTES_MAX, err);
    if (!status) {
        status = check_text(path, text, size, err);
    }
    /* Skip a byte order mark, and read by format. */
    if (!status) {
        murk_sha256_hex(text, size, sha256);
        const size_t mark = strncmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
        status =
            is_or_library(text + mark)
                ? murk_sparse_read_or_library(&builder, text + mark, err)
                : murk_sparse_read_csv(&builder, text + mark, size - mark, err);
    }
    free(text);
    if (status) {
        murk_sparse_builder_release(&builder);
        return status;
    }
    status = murk_sparse_builder_finish(out, &builder, err);
    if (!status) {
        memcpy((*out)->sha256, sha256, sizeof sha256);
    }
    return status;
}
