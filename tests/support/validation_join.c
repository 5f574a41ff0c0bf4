/* Reads the rows that an earlier run wrote as CSV and adds them to a
 * validation run. All rows must have one seed, because the table states one.
 */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

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

static bool flag(const murk_table *t, size_t row, const char *column)
{
    return number(t, row, column) != 0;
}

/* The first row says the seed of the run, the others must have it, too. */
static void read_seed(validation *v, const murk_table *t, size_t row)
{
    const uint32_t seed = (uint32_t)strtoul(text(t, row, "seed"), NULL, 10);
    if (v->rows > 0 && seed != v->settings.seed) {
        fprintf(stderr,
                "%s:%d: seed %" PRIu32 ", but rows before have seed %" PRIu32
                ": one table takes one seed\n",
                t->path, t->line[row], seed, v->settings.seed);
        exit(1);
    }
    v->settings.seed = seed;
}

static bool read_is_quick(const murk_table *t, size_t row)
{
    const char *form = text(t, row, "form");
    const bool is_quick = strcmp(form, "quick") == 0;
    if (!is_quick && strcmp(form, "nightly") != 0) {
        fprintf(stderr, "%s:%d: form `%s`: quick or nightly\n", t->path,
                t->line[row], form);
        exit(1);
    }
    return is_quick;
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
        /* Name, source and reference of the row. */
        const validation_reference reference = {text(t, i, "quantity"),
                                                number(t, i, "reference"),
                                                number(t, i, "uncertainty")};
        read_seed(v, t, i);
        validation_group(v, text(t, i, "group"));
        validation_row *row =
            validation_add_row(v, text(t, i, "case"), text(t, i, "source"),
                               text(t, i, "wrong"), &reference);
        /* The result, and the flags that the verdict needs. */
        row->murk.value = number(t, i, "murk");
        row->murk.standard_error = number(t, i, "standard_error");
        row->is_quick = read_is_quick(t, i);
        row->sigmas_max = number(t, i, "sigmas_most");
        row->is_bound = flag(t, i, "is_bound");
        row->is_short = flag(t, i, "is_short");
        snprintf(row->why_short, sizeof row->why_short, "%s",
                 text(t, i, "why_short"));
        row->is_unsound = flag(t, i, "is_unsound");
        row->photons = strtoull(text(t, i, "photons"), NULL, 10);
    }
    murk_table_destroy(t);
}
