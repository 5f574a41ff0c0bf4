/* Reads the reference tables and ends the program with one line if a table, a
 * column or a row is missing: a case without its reference must not pass. */
#include "cases/reference.h"

#include <math.h>
#include <stdlib.h>

#define FOLDER "tests/physics/reference/"

murk_table *reference_read(const char *file)
{
    char path[256];
    murk_table *table = NULL;
    murk_error err = {0};
    snprintf(path, sizeof path, FOLDER "%s", file);
    if (murk_table_read(&table, path, &err)) {
        fprintf(stderr, "%s: %s\n", err.where, err.text);
        exit(1);
    }
    return table;
}

const char *reference_text(const murk_table *table, size_t row,
                           const char *column)
{
    const long at = murk_table_column(table, column);
    if (at < 0 || row >= table->rows) {
        fprintf(stderr, "%s: no column %s or no row %zu\n", table->path, column,
                row);
        exit(1);
    }
    return table->cell[row * table->columns + (size_t)at];
}

double reference_number(const murk_table *table, size_t row, const char *column)
{
    const char *text = reference_text(table, row, column);
    char *end = NULL;
    const double number = strtod(text, &end);
    if (*text != '\0' && *end != '\0') {
        fprintf(stderr, "%s:%d: %s is %s, must be a number\n", table->path,
                table->line[row], column, text);
        exit(1);
    }
    return *text ? number : NAN;
}

validation_reference reference_value(const murk_table *table, size_t row,
                                     const char *column, const char *quantity)
{
    return (validation_reference){.quantity = quantity,
                                  .value = reference_number(table, row, column),
                                  .uncertainty = validation_half_digit_of(
                                      reference_text(table, row, column))};
}
