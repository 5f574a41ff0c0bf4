/* Readers of the formats of a coverage matrix. Each reads the text of a file,
 * which ends with '\0' and may be changed in place, and fills a builder whose
 * path is set; the caller finishes the builder, or releases it after a failure.
 * The readers fail with MURK_BAD_FILE or MURK_NO_MEMORY. */
#ifndef MURK_SPARSE_READ_H
#define MURK_SPARSE_READ_H

#include "sparse/builder.h"

#include <stdbool.h>

/* The place that a message names. */
typedef struct murk_text_place {
    const char *path;
    size_t line, column; /* from 1 */
} murk_text_place;

murk_status murk_fail_at(murk_error *err, murk_text_place place,
                         const char *format, ...)
    __attribute__((format(printf, 3, 4)));

murk_status murk_sparse_read_csv(murk_sparse_builder *builder, char *text,
                                 size_t size, murk_error *err);
murk_status murk_sparse_read_or_library(murk_sparse_builder *builder,
                                        const char *text, murk_error *err);

/* Parses a weight or a cost: 0, or 1e-12..1e12. False if the text is no such
 * number; *out is then unchanged. */
bool murk_sparse_weight_parse(const char *text, double *out);

#endif
