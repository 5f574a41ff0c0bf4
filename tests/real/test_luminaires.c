/* Photometric files of makers: intensities and fluxes equal those of another
 * reader (../shared/data/frontier/luminaires, whose tables say how they were
 * computed). */
#include "base/file.h"
#include "check.h"
#include "luminaire/photometric_file.h"
#include "scene/table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define DATA "../shared/data/frontier/luminaires/"

/* The reference has 7 significant digits. */
#define DIGITS 1e-6
/* Agreement of the integral that the reference states to 7 digits. */
#define LUMENS 1e-6

static murk_luminaire *lamp_of(const char *name)
{
    char path[300];
    murk_luminaire *out = NULL;
    murk_error err = {0};
    snprintf(path, sizeof path, DATA "%s", name);
    CHECK(murk_luminaire_read(&out, path, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return out;
}

static double number(const murk_table *t, size_t row, const char *column)
{
    double value = NAN;
    murk_error err = {0};
    murk_table_number(t, row, murk_table_column(t, column), NAN, &value, &err);
    CHECK_TEXT(err.text, "");
    return value;
}

static void test_intensities(void)
{
    murk_table *t = NULL;
    murk_error err = {0};
    CHECK(!murk_table_read(&t, DATA "reference_candela.csv", &err));
    if (!t) {
        return;
    }
    murk_luminaire *lamp = NULL;
    const char *name = "";
    double worst = 0, worst_by_direction = 0;
    for (size_t i = 0; i < t->rows; ++i) {
        const char *file = t->cell[i * t->columns];
        if (strcmp(file, name) != 0) {
            murk_luminaire_destroy(lamp);
            lamp = lamp_of(file);
            name = file;
        }
        if (!lamp) {
            continue;
        }
        /* By angles, and by the direction of these angles. */
        const double c = number(t, i, "C_deg"), g = number(t, i, "gamma_deg");
        const double want = number(t, i, "candela");
        const double got = murk_intensity_at_angles(lamp->intensity, g, c);
        const double rad = MURK_PI / 180;
        const murk_vec3 d = {sin(g * rad) * cos(c * rad),
                             sin(g * rad) * sin(c * rad), -cos(g * rad)};
        const double seen = murk_intensity_candela(lamp->intensity, d);
        const double scale = murk_intensity_max_candela(lamp->intensity);
        if (fabs(got - want) > DIGITS * fmax(want, 1e-3 * scale)) {
            printf("%s C %g gamma %g: %.9g, reference %.9g\n", file, c, g, got,
                   want);
        }
        worst = fmax(worst, fabs(got - want) / fmax(want, 1e-3 * scale));
        worst_by_direction = fmax(worst_by_direction, fabs(seen - got) / scale);
    }
    printf("%zu intensities: off by %.2g at most, by direction %.2g\n", t->rows,
           worst, worst_by_direction);
    CHECK(t->rows > 200);
    CHECK(worst < DIGITS);
    CHECK(worst_by_direction < 1e-12);
    murk_luminaire_destroy(lamp);
    murk_table_destroy(t);
}

/* Checks one line of the totals. Notes at the end of a line have commas of
 * their own, so the line is cut by hand. */
static void check_totals(char *line)
{
    enum { FILE_NAME, LUMENS_AT = 6, CANDELA_AT = 7, CELLS };
    char *cell[CELLS] = {NULL}, *rest = NULL;
    for (int i = 0; i < CELLS; ++i) {
        cell[i] = strtok_r(i == 0 ? line : NULL, ",", &rest);
    }
    murk_luminaire *lamp = cell[CANDELA_AT] ? lamp_of(cell[FILE_NAME]) : NULL;
    CHECK(lamp != NULL);
    if (!lamp) {
        return;
    }
    const double lumens = murk_intensity_lumens(lamp->intensity);
    const double off = lumens / strtod(cell[LUMENS_AT], NULL) - 1;
    printf("%-28s %-10s %-36s %10.3f lm, declared %.6g, reference off %.1e; "
           "opening %.4g x %.4g m\n",
           cell[FILE_NAME], lamp->format,
           murk_luminaire_symmetry_name(lamp->symmetry), lumens,
           lamp->declared_lumens, off, lamp->along_c0_m, lamp->along_c90_m);
    CHECK_NEAR(off, 0, LUMENS);
    CHECK_NEAR(murk_intensity_max_candela(lamp->intensity) /
                   strtod(cell[CANDELA_AT], NULL),
               1, DIGITS);
    murk_luminaire_destroy(lamp);
}

static void test_totals(void)
{
    char *text = NULL;
    size_t size = 0, lines = 0;
    murk_error err = {0};
    CHECK(!murk_file_read(&text, &size, DATA "reference_totals.csv", 100000,
                          &err));
    char *rest = NULL;
    for (char *line = strtok_r(text, "\n", &rest); line;
         line = strtok_r(NULL, "\n", &rest)) {
        if (line[0] != '#' && lines++ > 0) {
            check_totals(line);
        }
    }
    CHECK(lines > 10);
    free(text);
}

int main(void)
{
    if (access(DATA "reference_candela.csv", R_OK) != 0) {
        check_skip(DATA " is not there");
    }
    test_intensities();
    test_totals();
    return check_done();
}
