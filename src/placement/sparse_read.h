/* The readers of the formats of a coverage matrix, each over the file's text,
 * which ends with '\0' and may be cut in place. They fill builder->path's
 * matrix; the caller finishes or releases it. */
#ifndef MURK_PLACEMENT_SPARSE_READ_H
#define MURK_PLACEMENT_SPARSE_READ_H

#include "placement/sparse_builder.h"

#include <stdbool.h>

/* Where a message points to. */
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

/* A weight or cost as a file may give it: 0, or 1e-12..1e12. */
bool murk_sparse_weight_parse(const char *text, double *out);

#endif
