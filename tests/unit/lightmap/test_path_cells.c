/* The cells that segments cross, against points along the segments: at random,
 * and along and in the sides of cells, where a wrong division would lose the
 * middle of a segment. Seeds are fixed. */
#include "base/rng.h"
#include "check.h"
#include "lightmap/path_cells.h"

static double draw(uint32_t a, uint32_t b)
{
    uint32_t word[4];
    murk_random_words(1, 0, a, b, 0, word);
    return word[0] * 0x1p-32;
}

/* The cell of a point inside the box. */
static uint64_t cell_of(const murk_path_cells *cells, murk_vec3 p)
{
    int at[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double min = murk_component(cells->box.min, axis),
                     max = murk_component(cells->box.max, axis);
        const double place = (murk_component(p, axis) - min) / (max - min);
        const int k = (int)(place * cells->size[axis]);
        at[axis] = k < cells->size[axis] ? k : cells->size[axis] - 1;
    }
    return UINT64_C(1) << (at[0] +
                           cells->size[0] * (at[1] + cells->size[1] * at[2]));
}

/* Marks the segment, and compares: no cell with a point of the segment may be
 * missing. Returns the number of cells. */
static int check_segment(murk_path_cells *cells, murk_vec3 from, murk_vec3 to)
{
    const murk_vec3 along = murk_sub(to, from);
    const double length = murk_length(along);
    const murk_event event = {.kind = MURK_EVENT_SURFACE,
                              .position = to,
                              .direction_in = length > 0 ? murk_unit(along)
                                                         : murk_vec(1, 0, 0),
                              .path_m = length};
    uint64_t wanted = 0;
    cells->crossed[0] = 0;
    murk_path_cells_add(cells, &(murk_domain){.box = cells->box}, &event);
    for (int k = 0; k <= 4000; ++k) {
        const murk_vec3 p = murk_along(from, k / 4000.0, along);
        if (murk_box_contains(&cells->box, p)) {
            wanted |= cell_of(cells, p);
        }
    }
    CHECK((wanted & ~cells->crossed[0]) == 0);
    return __builtin_popcountll(cells->crossed[0]);
}

static void test_random_segments(murk_path_cells *cells)
{
    double marked = 0;
    for (uint32_t i = 0; i < 2000; ++i) {
        double x[6];
        for (uint32_t k = 0; k < 6; ++k) {
            x[k] = 20 * draw(i, k) - 2;
        }
        marked += check_segment(cells, murk_vec(x[0], x[1], x[2]),
                                murk_vec(x[3], x[4], x[5]));
    }
    CHECK(marked / 2000 < 12); /* of 64: the cells tell something */
}

/* Segments whose ends lie on sides of cells, some of them along a side. */
static void test_sides(murk_path_cells *cells)
{
    for (int i = 0; i < 5 * 5 * 5; ++i) {
        const murk_vec3 from = {4 * (i % 5), 4 * (i / 5 % 5), 4 * (i / 25)};
        for (int k = 0; k < 5 * 5 * 5; ++k) {
            const murk_vec3 to = {4 * (k % 5), 4 * (k / 5 % 5), 4 * (k / 25)};
            check_segment(cells, from, to);
        }
        /* Almost along a side. */
        check_segment(cells, from, murk_vec(from.x + 1e-12, 15, 3));
        check_segment(cells, from, murk_vec(from.x - 1e-7, 1, 14));
    }
}

static void test_changed_places(const murk_path_cells *cells)
{
    const murk_box domain = {{-1, -1, -1}, {17, 17, 17}};
    murk_box_list list = {0};
    uint64_t bits = 1;
    CHECK(murk_path_cells_of(&bits, cells, &list, &domain) && bits == 0);
    murk_box_list_add(&list, (murk_box){{5, 5, 5}, {6, 7, 7}});
    CHECK(murk_path_cells_of(&bits, cells, &list, &domain));
    CHECK(bits == cell_of(cells, murk_vec(5, 5, 5)));
    /* Outside of the domain nothing passes; between it and the cells paths are
     * not known. */
    murk_box_list_add(&list, (murk_box){{20, 20, 20}, {30, 30, 30}});
    CHECK(murk_path_cells_of(&bits, cells, &list, &domain));
    murk_box_list_add(&list, (murk_box){{15, 15, 15}, {16.5, 16, 16}});
    CHECK(!murk_path_cells_of(&bits, cells, &list, &domain));
}

/* A photon that passes a side crosses the cells up to there, unless photons in
 * its direction may jump, which depends on surfaces at all heights. */
static void test_wraps(murk_path_cells *cells)
{
    const murk_domain domain = {.box = cells->box, .is_periodic = true};
    /* From bottom to top the first direction passes 5 sides, which is too few
     * for a jump, and the second one 8. */
    const double slope[] = {5, 8};
    for (int i = 0; i < 2; ++i) {
        const murk_event event = {.kind = MURK_EVENT_WRAPPED,
                                  .position = {16, 1, 1},
                                  .direction_in =
                                      murk_unit(murk_vec(slope[i], 0, 1)),
                                  .path_m = 0.5};
        cells->crossed[0] = 0;
        murk_path_cells_add(cells, &domain, &event);
        CHECK(cells->crossed[0] ==
              (i == 0 ? cell_of(cells, murk_vec(15, 1, 1)) : UINT64_MAX));
    }
}

int main(void)
{
    const murk_box box = {{0, 0, 0}, {16, 16, 16}};
    murk_path_cells *cells = NULL;
    murk_error err = {0};
    CHECK(murk_path_cells_create(&cells, &box, 1, &err) == MURK_OK);
    CHECK(cells->size[0] * cells->size[1] * cells->size[2] == MURK_PATH_CELLS);
    test_random_segments(cells);
    test_sides(cells);
    test_changed_places(cells);
    test_wraps(cells);
    murk_path_cells_destroy(cells);
    return check_done();
}
