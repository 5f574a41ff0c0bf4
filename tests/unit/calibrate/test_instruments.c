/* What is said of receivers that a surface cuts. Nothing here is random. */
#include "base/log.h"
#include "calibrate/instruments.h"
#include "check.h"

#include <stdio.h>

#define ROWS_MAX 12

static char noted[4000];

static void keep_note(const char *where, const char *text)
{
    const size_t used = strlen(noted);
    snprintf(noted + used, sizeof noted - used, "%s: %s\n", where, text);
}

/* Keeps the warning about receivers at the given x in a room from 0 to 4 m
 * that a wall at x = 2 divides; all have a radius of .25 m. */
static void keep_warning(const double *x, size_t n)
{
    /* A room with a wall across. */
    const murk_material stuff = {.name = "default"};
    const murk_surface_desc desc[2] = {{.shape = MURK_SHAPE_BOX,
                                        .box = {{0, 0, 0}, {4, 4, 4}},
                                        .to_world = murk_affine_identity(),
                                        .where = "room"},
                                       {.shape = MURK_SHAPE_RECT,
                                        .corner = {2, 0, 0},
                                        .edge1 = {0, 4, 0},
                                        .edge2 = {0, 0, 4},
                                        .to_world = murk_affine_identity(),
                                        .where = "wall"}};
    /* A receiver of fluence at each position. */
    murk_reading reading[ROWS_MAX];
    murk_reading_row row[ROWS_MAX];
    for (size_t i = 0; i < n; ++i) {
        reading[i] = (murk_reading){.kind = MURK_READ_FLUENCE,
                                    .line = i + 2,
                                    .position = {x[i], 1, 1},
                                    .radius_m = .25};
        row[i] = (murk_reading_row){.first = i, .n = 1};
    }
    murk_readings measured = {.path = "yard.csv",
                              .reading = reading,
                              .readings = n,
                              .row = row,
                              .rows = n};
    /* Keep the warning that the receivers cause. */
    murk_surfaces *surfaces = NULL;
    murk_instruments instruments = {0};
    murk_error err = {0};
    noted[0] = '\0';
    const bool is_well =
        !murk_surfaces_create(&surfaces, desc, 2, &stuff, 1, &err) &&
        !murk_instruments_create(&instruments, &measured, 0, &err);
    CHECK(is_well);
    if (is_well) {
        const murk_warn_sink before = murk_warn_to(keep_note);
        murk_instruments_warn_of_cut(&instruments, &measured, surfaces);
        (void)murk_warn_to(before);
    }
    murk_instruments_release(&instruments);
    murk_surfaces_destroy(surfaces);
}

/* In the open, touching on either side, and cut by a tenth of the radius. */
static void test_cut_receivers_are_named(void)
{
    keep_warning((const double[]){1, .25, 1.75, 2.25, 3.75}, 5);
    CHECK_TEXT(noted, "");
    keep_warning((const double[]){1, 1.775, 3}, 3);
    CHECK_TEXT(noted,
               "yard.csv:3: a surface cuts the receiver of 0.25 m around "
               "[1.775, 1, 1] m, behind which it is dark: it reads low; take "
               "a smaller radius_m, or a place farther from the surface\n");
}

static void test_many_are_counted(void)
{
    double x[ROWS_MAX];
    for (size_t i = 0; i < ROWS_MAX; ++i) {
        x[i] = 2;
    }
    keep_warning(x, ROWS_MAX);
    size_t lines = 0;
    for (const char *c = noted; *c; ++c) {
        lines += *c == '\n';
    }
    CHECK(lines == 6);
    CHECK(strstr(noted, "yard.csv: 7 more receivers are cut by surfaces and "
                        "read low\n"));
}

int main(void)
{
    test_cut_receivers_are_named();
    test_many_are_counted();
    return check_done();
}
