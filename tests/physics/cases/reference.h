/* Reference tables of tests/physics/reference/, read by name; a table or
 * column that is missing ends the program. */
#ifndef MURK_TESTS_CASES_REFERENCE_H
#define MURK_TESTS_CASES_REFERENCE_H

#include "scene/table.h"
#include "validation.h"

murk_table *reference_read(const char *file);

/* The text of a cell; "" where it is empty. */
const char *reference_text(const murk_table *table, size_t row,
                           const char *column);

/* Its number, "inf" too; NAN where it is empty. */
double reference_number(const murk_table *table, size_t row,
                        const char *column);

/* Value and half a unit of the last digit that is printed. */
validation_reference reference_value(const murk_table *table, size_t row,
                                     const char *column, const char *quantity);

#endif
