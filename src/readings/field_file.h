/* Files of measurements as others publish them, as tables of text: CSV, AERONET
 * and SeaBASS. */
#ifndef MURK_READINGS_FIELD_FILE_H
#define MURK_READINGS_FIELD_FILE_H

#include "base/arena.h"
#include "scene/table.h"

#include <stdbool.h>

typedef enum murk_field_format {
    MURK_FIELD_CSV,     /* a row of names, then rows of as many cells */
    MURK_FIELD_AERONET, /* CSV below some lines of text; columns may have the
                         * same name, such as AOD_Empty */
    MURK_FIELD_SEABASS, /* /KEY=VALUE from /begin_header to /end_header, then
                         * rows of as many cells as /fields has names */
    MURK_FIELD_FORMATS
} murk_field_format;

extern const char *const murk_field_formats[MURK_FIELD_FORMATS];

/* Values of SeaBASS that stand for none: missing, and below and above the limit
 * of detection. */
#define MURK_FIELD_MISSING_MAX 3

typedef struct murk_field_file {
    murk_table *table;
    char **unit;   /* [table->columns]; NULL: the format states no units */
    int unit_line; /* line of the units */
    double missing[MURK_FIELD_MISSING_MAX]; /* [n_missing]; numbers that stand
                                             * for no measurement */
    size_t n_missing;
    murk_arena arena; /* of unit[] */
} murk_field_file;

/* Reads the text of a file. Takes ownership of the text, also on failure; the
 * text must have a '\0' behind its `size` bytes. `path` is the name in
 * messages. Fails with MURK_BAD_FILE at the line that is wrong, and with
 * MURK_NO_MEMORY. Release *out also after a failure. */
murk_status murk_field_file_read(murk_field_file *out, murk_field_format format,
                                 const char *path, char *text, size_t size,
                                 murk_error *err);
void murk_field_file_release(murk_field_file *file);

/* True if a cell holds no measurement: it is empty, NA or NaN, or one of the
 * file's numbers for missing values. */
bool murk_field_is_missing(const murk_field_file *file, const char *cell);

#endif
