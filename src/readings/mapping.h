/* A mapping file: how readings are made of the columns of a file of
 * measurements. Keys and meanings: doc/reference/calibration.md. */
#ifndef MURK_READINGS_MAPPING_H
#define MURK_READINGS_MAPPING_H

#include "readings/cells.h"
#include "readings/field_file.h"
#include "scene/yaml.h"

/* Limits of a mapping: entries, which the wavelengths of aod_nm multiply, and
 * conditions of a selection. */
#define MURK_MAPPING_ENTRIES_MAX 1000
#define MURK_MAPPING_SELECT_MAX  16

/* How one cell of a reading is made: a constant, or a column of the file. */
typedef struct murk_mapping_rule {
    const murk_yaml *node; /* NULL: the cell is empty */
    const char *constant;  /* NULL: no constant */
    const char *column;    /* NULL: no column */
    const char *unit;      /* that the file must state for the column; NULL:
                            * any */
    double factor, offset; /* the number of the column is multiplied by the
                            * factor, then the offset is added */
    double relative; /* standard_error: of the absolute value of the reading */
    double at_least; /* standard_error */
} murk_mapping_rule;

/* Rows whose cell of a column is a text or an equal number, or lies in
 * low..high. */
typedef struct murk_mapping_select {
    const murk_yaml *node;
    const char *column;
    const char *text; /* NULL: a range */
    double low, high;
} murk_mapping_select;

typedef struct murk_mapping_selection {
    murk_mapping_select item[MURK_MAPPING_SELECT_MAX]; /* [n] */
    size_t n;
} murk_mapping_selection;

/* What becomes one reading of each row of the file. */
typedef struct murk_mapping_entry {
    murk_mapping_rule rule[MURK_READING_COLUMNS];
    murk_mapping_selection select;
    bool is_averaged; /* all rows together are one reading */
    const murk_yaml *node;
} murk_mapping_entry;

typedef struct murk_mapping {
    murk_yaml *root;
    char *file; /* path from the working folder */
    murk_field_format format;
    const murk_yaml *missing; /* list of texts that stand for none; NULL: none
                               */
    murk_mapping_selection select;
    murk_mapping_entry *entry; /* [n] */
    size_t n;
    murk_arena arena; /* of the entries and of texts */
} murk_mapping;

/* True for the name of a mapping file: one that ends with .yaml or .yml. */
bool murk_mapping_is(const char *path);

/* Parses the text of a mapping; `path` is the source in messages and must
 * outlive *out. Fails with MURK_BAD_FILE or MURK_BAD_VALUE at the line and
 * column that is wrong, and with MURK_NO_MEMORY. Release *out also after a
 * failure. */
murk_status murk_mapping_parse(murk_mapping *out, const char *path,
                               const char *text, size_t size, murk_error *err);
void murk_mapping_release(murk_mapping *mapping);

#endif
