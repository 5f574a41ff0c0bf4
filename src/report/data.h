/* Writes data of the page to a stream, as JSON inside a script element. Text is
 * escaped so that no browser takes any of it for a tag. Bytes that are not
 * UTF-8 and control characters become U+FFFD, and a text is cut after 1000
 * bytes. Failures of writing show when the file is committed
 * (murk_file_commit()). */
#ifndef MURK_REPORT_DATA_H
#define MURK_REPORT_DATA_H

#include "base/vector.h"
#include "scene/yaml.h"

#include <stdio.h>

typedef struct murk_data {
    FILE *to;
    bool has_item; /* the open object or list has an item already */
} murk_data;

/* The first writes the beginning of the element with this id, and opens an
 * object; the second closes both. The id is not escaped.
 */
murk_data murk_data_open(FILE *to, const char *id);
void murk_data_close(murk_data *data);

/* Begin an object '{' or a list '[' inside the open one, and end it with '}' or
 * ']'. key: NULL in a list, here and in the functions below. */
void murk_data_begin(murk_data *data, const char *key, char bracket);
void murk_data_end(murk_data *data, char bracket);

void murk_data_number(murk_data *data, const char *key, double value);
void murk_data_numbers(murk_data *data, const char *key, const double *value,
                       size_t n);
void murk_data_vector(murk_data *data, const char *key, murk_vec3 value);
void murk_data_bool(murk_data *data, const char *key, bool value);
void murk_data_text(murk_data *data, const char *key, const char *text);
/* Writes the numbers in single precision, little endian, as one text in base64.
 * An empty text when out of memory. */
void murk_data_floats(murk_data *data, const char *key, const double *value,
                      size_t n);
/* Writes values that were read from a JSON file. A list of more than
 * `items_max` items becomes {"of": their number, "first": the first items_max
 * of them}. Of a map, the first items_max keys are written. */
void murk_data_yaml(murk_data *data, const char *key, const murk_yaml *node,
                    size_t items_max);

#endif
