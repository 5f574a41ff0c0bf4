/* Free space at any point: what one open segment joins to a reached point of a
 * grid or to a lamp. Deterministic: never cries wolf. */
#include "sensing/open_space.h"
#include "world.h"

static const murk_vec3 none = {0, 0, 0}, up = {0, 0, 1}, down = {0, 0, -1};

/* A hall of 8 x 4 x 3 m in two rooms without a door, the eastern one without a
 * lamp; in the western one a crate on the floor and a shelf, 0.4 m under the
 * roof and 1.6 m deep; a pane of glass across its end. */
static murk_surfaces *hall_of(void)
{
    const murk_surface_desc d[] = {
        a_box(murk_vec(0, 0, 0), murk_vec(8, 4, 3)),
        a_rect(murk_vec(5, 0, 0), murk_vec(0, 4, 0), murk_vec(0, 0, 3), WALL),
        a_box(murk_vec(1, 1, 0), murk_vec(2, 2, 1)),
        a_rect(murk_vec(0, 2.4, 2.6), murk_vec(4, 0, 0), murk_vec(0, 1.6, 0),
               WALL),
        a_rect(murk_vec(4, 0, 0), murk_vec(0, 4, 0), murk_vec(0, 0, 3), GLASS)};
    return surfaces_of(d, sizeof d / sizeof *d);
}

static const murk_domain hall = {.box = {{-1, -1, -1}, {9, 5, 4}}};

static murk_open_space *space_of(const murk_surfaces *surfaces,
                                 const murk_candidate_grid *grid,
                                 size_t n_grids, const murk_vec3 *lamp,
                                 unsigned threads)
{
    const murk_reach reach = {.lamps = lamp, .n_lamps = 1, .domain = hall};
    murk_open_space *space = NULL;
    murk_error err = {0};
    CHECK(murk_open_space_create(&space, grid, n_grids, surfaces, &reach,
                                 threads, "here", &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return space;
}

static const murk_candidate_grid fine = {.min = {-0.75, -0.75, -0.75},
                                         .max = {8.75, 4.75, 3.75},
                                         .size = {20, 12, 10}};
static const murk_vec3 lamp = {0.5, 0.5, 2.5};

/* Just off the surface at p, to the side of n. */
static bool holds_side(const murk_open_space *space,
                       const murk_surfaces *surfaces, murk_vec3 p, murk_vec3 n)
{
    return murk_open_space_holds(space, murk_surfaces_leave(surfaces, p, n), n);
}

static void test_what_is_free(void)
{
    murk_surfaces *surfaces = hall_of();
    murk_open_space *space = space_of(surfaces, &fine, 1, &lamp, 2);
    CHECK(murk_open_space_holds(space, murk_vec(3, 3, 1), none));
    CHECK(murk_open_space_holds(space, murk_vec(4.5, 3, 1), none)); /* glass */
    CHECK(murk_open_space_holds(space, murk_vec(1.5, 2.8, 2.8), none));
    CHECK(!murk_open_space_holds(space, murk_vec(1.5, 1.5, 0.5), none));
    CHECK(!murk_open_space_holds(space, murk_vec(6, 2, 1), none));
    CHECK(!murk_open_space_holds(space, murk_vec(2, 2, 3.5), none));
    murk_open_space_destroy(space);
    murk_surfaces_destroy(surfaces);
}

/* All over both faces of the crate, of the roof and of the wall to the dark
 * room: one is free, the other never. */
static void test_sides_of_surfaces(void)
{
    const murk_vec3 east = {1, 0, 0}, west = {-1, 0, 0};
    murk_surfaces *surfaces = hall_of();
    murk_open_space *space = space_of(surfaces, &fine, 1, &lamp, 1);
    /* some of them straight across from a point of the grid */
    for (int i = 0; i < 19 * 19; ++i) {
        const double u = (i % 19 + 1) / 20.0, v = (i / 19 + 1) / 20.0;
        const murk_vec3 top = {1 + u, 1 + v, 1}, roof = {5 * u, 4 * v, 3},
                        wall = {5, 4 * u, 3 * v};
        CHECK(holds_side(space, surfaces, top, up));
        CHECK(!holds_side(space, surfaces, top, down));
        const murk_vec3 side = {2, 1 + u, v};
        CHECK(holds_side(space, surfaces, side, east));
        CHECK(!holds_side(space, surfaces, side, west));
        CHECK(holds_side(space, surfaces, roof, down));
        CHECK(!holds_side(space, surfaces, roof, up));
        CHECK(holds_side(space, surfaces, wall, west));
        CHECK(!holds_side(space, surfaces, wall, east));
    }
    murk_open_space_destroy(space);
    murk_surfaces_destroy(surfaces);
}

/* A grid none of whose points is in the room: a lamp there is enough for what
 * it sees; a second grid in it for what is round the corner. */
static void test_small_rooms_in_large_worlds(void)
{
    const murk_candidate_grid coarse = {
        .min = {-0.5, -0.5, -0.5}, .max = {8.5, 4.5, 3.5}, .size = {2, 2, 2}};
    const murk_candidate_grid both[2] = {coarse, fine};
    const murk_vec3 seen = {3, 0.5, 0.5}, hidden = {1.5, 2.5, 0.2};
    murk_surfaces *surfaces = hall_of();
    murk_open_space *space = space_of(surfaces, &coarse, 1, &lamp, 1);
    CHECK(murk_open_space_holds(space, seen, none));
    CHECK(!murk_open_space_holds(space, hidden, none));
    murk_open_space_destroy(space);
    space = space_of(surfaces, both, 2, &lamp, 1);
    CHECK(murk_open_space_holds(space, hidden, none));
    murk_open_space_destroy(space);
    murk_surfaces_destroy(surfaces);
}

/* Segments go through periodic sides. */
static void test_periodic(void)
{
    const murk_surface_desc d[] = {
        a_rect(murk_vec(1, 0, 0), murk_vec(0, 4, 0), murk_vec(0, 0, 3), WALL),
        a_rect(murk_vec(3, 0, 0), murk_vec(0, 4, 0), murk_vec(0, 0, 3), WALL)};
    murk_surfaces *surfaces = surfaces_of(d, 2);
    const murk_candidate_grid grid = {
        .min = {3.5, 2, 1.5}, .max = {3.5, 2, 1.5}, .size = {1, 1, 1}};
    const murk_vec3 at = {3.5, 2, 2};
    for (int periodic = 0; periodic < 2; ++periodic) {
        const murk_reach reach = {
            .lamps = &at,
            .n_lamps = 1,
            .domain = {.box = {{0, 0, 0}, {4, 4, 3}}, .is_periodic = periodic}};
        murk_open_space *space = NULL;
        murk_error err = {0};
        CHECK(murk_open_space_create(&space, &grid, 1, surfaces, &reach, 1,
                                     "here", &err) == MURK_OK);
        CHECK(murk_open_space_holds(space, murk_vec(0.5, 2, 1), none) ==
              periodic);
        CHECK(!murk_open_space_holds(space, murk_vec(2, 2, 1), none));
        murk_open_space_destroy(space);
    }
    murk_surfaces_destroy(surfaces);
}

int main(void)
{
    test_what_is_free();
    test_sides_of_surfaces();
    test_small_rooms_in_large_worlds();
    test_periodic();
    return check_done();
}
