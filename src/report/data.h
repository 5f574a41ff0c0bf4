/* Data of the page as JSON inside a script element, written as it comes.
 *
 * Text is escaped so that no browser can take any of it for a tag; what is no
 * UTF-8, and control characters, become U+FFFD. Errors of writing are the
 * stream's: murk_file_commit() asks it. */
#ifndef MURK_REPORT_DATA_H
#define MURK_REPORT_DATA_H

#include "base/vector.h"
#include "scene/yaml.h"

#include <stdio.h>

typedef struct murk_data {
    FILE *to;
    bool has_item; /* in the object or list that is open */
} murk_data;

/* <script type="application/json" id="..."> with one object; the element's end.
 */
murk_data murk_data_open(FILE *to, const char *id);
void murk_data_close(murk_data *data);

/* An object '{' or a list '[' inside of what is open, and its end '}' or ']'.
 * key: NULL in a list; likewise below. */
void murk_data_begin(murk_data *data, const char *key, char bracket);
void murk_data_end(murk_data *data, char bracket);

void murk_data_number(murk_data *data, const char *key, double value);
void murk_data_numbers(murk_data *data, const char *key, const double *value,
                       size_t n);
void murk_data_vector(murk_data *data, const char *key, murk_vec3 value);
void murk_data_bool(murk_data *data, const char *key, bool value);
void murk_data_text(murk_data *data, const char *key, const char *text);
/* The numbers in single precision, little endian, as one base64 text. */
void murk_data_floats(murk_data *data, const char *key, const double *value,
                      size_t n);
/* What was read from a JSON file. A list of more than `items_max` items becomes
 * {"of": their number, "first": the first of them}; of a map the first are
 * written. */
void murk_data_yaml(murk_data *data, const char *key, const murk_yaml *node,
                    size_t items_max);

#endif
