#include <stdlib.h>

#include "scene/table.h"
#include "validation_rows.h"

static const char *text(const murk_table *t, size_t row, const char *column)
{
    const long at = murk_table_column(t, column);
    if (at < 0) {
        fprintf(stderr, "%s: no column %s\n", t->path, column);
        exit(1);
    }
    return t->cell[row * t->columns + (size_t)at];
}

static double number(const murk_table *t, size_t row, const char *column)
{
    return strtod(text(t, row, column), NULL); /* as validation_csv() wrote */
}

void validation_join(validation *v, const char *path)
{
    murk_table *t = NULL;
    murk_error err = {0};
    if (murk_table_read(&t, path, &err)) {
        fprintf(stderr, "%s: %s\n", err.where, err.text);
        exit(1);
    }
    for (size_t i = 0; i < t->rows; ++i) {
        const validation_reference reference = {text(t, i, "quantity"),
                                                number(t, i, "reference"),
                                                number(t, i, "uncertainty")};
        validation_group(v, text(t, i, "group"));
        validation_row *row =
            validation_add_row(v, text(t, i, "case"), text(t, i, "source"),
                               text(t, i, "wrong"), &reference);
        row->murk.value = number(t, i, "murk");
        row->murk.standard_error = number(t, i, "standard_error");
        row->is_short = number(t, i, "is_short") != 0;
        row->photons = strtoull(text(t, i, "photons"), NULL, 10);
    }
    murk_table_destroy(t);
}
