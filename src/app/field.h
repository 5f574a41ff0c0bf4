/* Reading the fields of results, by paths that are formatted as by printf(). */
#ifndef MURK_APP_FIELD_H
#define MURK_APP_FIELD_H

#include "murk.h"

#define MURK_FIELD_PATH_SIZE 192 /* of a path, with the zero byte */

/* The number at a path; 0 if there is none. */
__attribute__((format(printf, 2, 3))) double
murk_field_number(const murk_fields *fields, const char *path, ...);

/* The text at a path, which belongs to the fields; NULL if there is none. */
__attribute__((format(printf, 2, 3))) const char *
murk_field_text(const murk_fields *fields, const char *path, ...);

/* The number of items of the list, or of fields of the object, at a path. */
__attribute__((format(printf, 2, 3))) size_t
murk_field_length(const murk_fields *fields, const char *path, ...);

#endif
