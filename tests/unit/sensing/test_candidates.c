/* Where sensors may stand: what light reaches, and nothing else.
 *
 * Deterministic: never cries wolf. */
#include "candidates_box.h"
#include "geometry/polygon.h"

static void test_an_empty_box_keeps_all_in_order(void)
{
    murk_surface_desc d[N_MAX];
    const murk_candidate_grid grid = {
        .min = {1, 2, 1}, .max = {9, 8, 3}, .size = {3, 2, 1}};
    const murk_reach reach = by_lamp();
    murk_candidates *c = candidates_of(d, add_sides(d, 0), &grid, &reach, 1);
    CHECK(c && c->asked == 6 && c->usable == 6 && c->doubtful == 0);
    const murk_vec3 want[6] = {{1, 2, 2}, {5, 2, 2}, {9, 2, 2},
                               {1, 8, 2}, {5, 8, 2}, {9, 8, 2}};
    for (int i = 0; c && i < 6; ++i) {
        CHECK(murk_length(murk_sub(c->position[i], want[i])) == 0);
    }
    murk_candidates_destroy(c);
}

static void test_inside_a_closed_crate_is_dropped(void)
{
    murk_surface_desc d[N_MAX];
    size_t n = add_sides(d, 0);
    const murk_vec3 min = {4.25, 4.25, 0.25}, max = {6.25, 6.25, 2.25};
    d[n++] = a_box(min, max);
    const murk_candidate_grid grid = half_metres();
    const murk_reach reach = by_lamp();
    murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->asked == 19 * 19 * 7);
    CHECK(c && c->unreached == 4 * 4 * 4 && c->too_close == 0);
    CHECK(inside(c, min, max) == 0);
    murk_candidates_destroy(c);
}

/* Five sides, the floor closes it: no inside-outside test could tell. */
static void test_inside_an_open_crate_on_the_floor_is_dropped(void)
{
    murk_surface_desc d[N_MAX];
    size_t n = add_sides(d, 0);
    const double a = 4.25, w = 2, h = 2.25;
    d[n++] = a_rect(murk_vec(a, a, 0), murk_vec(w, 0, 0), murk_vec(0, 0, h), 0);
    d[n++] = a_rect(murk_vec(a, a, 0), murk_vec(0, w, 0), murk_vec(0, 0, h), 0);
    d[n++] =
        a_rect(murk_vec(a + w, a, 0), murk_vec(0, w, 0), murk_vec(0, 0, h), 0);
    d[n++] =
        a_rect(murk_vec(a, a + w, 0), murk_vec(w, 0, 0), murk_vec(0, 0, h), 0);
    d[n++] = a_rect(murk_vec(a, a, h), murk_vec(w, 0, 0), murk_vec(0, w, 0), 0);
    const murk_candidate_grid grid = half_metres();
    const murk_reach reach = by_lamp();
    murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->unreached == 4 * 4 * 4);
    murk_candidates_destroy(c);

    /* Lifted off the floor, light finds the way in. */
    for (size_t i = 1; i < n; ++i) {
        d[i].to_world.shift.z = 0.75;
    }
    c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->unreached == 0);
    murk_candidates_destroy(c);
}

/* A cube of twelve separate triangles, in which every second triangle has
 * the opposite winding. */
static void test_winding_means_nothing(void)
{
    /* Two triangles for each side of the cube, with opposite winding and no
     * shared vertices. */
    static const int quad[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    float vertex[12 * 9];
    uint32_t corner[36], material[12] = {0};
    char name[1][MURK_NAME_SIZE] = {"crate"};
    for (int t = 0; t < 12; ++t) {
        for (int k = 0; k < 3; ++k) {
            const int pick = t % 2 ? (int[]){0, 2, 3}[k] : (int[]){1, 0, 2}[k];
            const int v = quad[t / 2][pick];
            float *p = &vertex[9 * t + 3 * k];
            p[0] = 4.25f + 2 * (float)(v & 1);
            p[1] = 4.25f + 2 * (float)(v >> 1 & 1);
            p[2] = 0.25f + 2 * (float)(v >> 2);
            corner[3 * t + k] = (uint32_t)(3 * t + k);
        }
    }
    /* The cube stands in the room. */
    const murk_mesh mesh = {
        .vertices = 36,
        .triangles = 12,
        .materials = 1,
        .vertex_m = vertex,
        .corner = corner,
        .material = material,
        .material_name = name,
        .bounds_m = {{4.25, 4.25, 0.25}, {6.25, 6.25, 2.25}}};
    murk_surface_desc d[N_MAX];
    size_t n = add_sides(d, 0);
    d[n++] = (murk_surface_desc){.shape = MURK_SHAPE_MESH,
                                 .mesh = &mesh,
                                 .to_world = murk_affine_identity(),
                                 .where = "crate"};
    /* Candidates inside the cube are out of reach. */
    const murk_candidate_grid grid = half_metres();
    const murk_reach reach = by_lamp();
    murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->unreached == 4 * 4 * 4);
    murk_candidates_destroy(c);
}

/* The segment from the lamp to a point in the crate passes exactly through the
 * crate's corner, through an edge, and along the diagonal of a face. */
static void test_nothing_slips_in_through_a_corner(void)
{
    const murk_vec3 places[3] = {{8, 8, 3.5}, {8, 5, 3.5}, {5, 5, 3.9}};
    const murk_candidate_grid grid = {
        .min = {5, 5, 0.5}, .max = {7, 5, 0.5}, .size = {2, 1, 1}};
    for (int i = 0; i < 3; ++i) {
        murk_surface_desc d[N_MAX];
        size_t n = add_sides(d, 0);
        d[n++] = a_box(murk_vec(4, 4, 0.25), murk_vec(6, 6, 1.5));
        const murk_reach reach = {
            .lamps = &places[i], .n_lamps = 1, .domain = interior};
        murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
        CHECK(c && c->usable == 1 && has(c, murk_vec(7, 5, 0.5)));
        murk_candidates_destroy(c);
    }
}

/* A tilted wall of three pieces: a corner of two lies on the edge of the third,
 * where rounding leaves cracks. A row of candidates lies behind the wall, and
 * for each candidate a lamp lies before the wall, in line with that corner. */
#define ROW 64
static void check_seam(uint32_t number)
{
    /* A wall of three rectangles with a seam of random direction. */
    const murk_random4 r = murk_random(1, MURK_TEST, number, 0, 0);
    const murk_random4 q = murk_random(1, MURK_TEST, number, 0, 1);
    const murk_vec3 from = {5 + r.u[0], 5 + r.u[1], r.u[2]};
    const murk_vec3 to = {5 + q.u[0], 5 + q.u[1], 3 + q.u[2]};
    const murk_vec3 seam = murk_sub(to, from), edge = {1, -0.3, 0.1};
    const double share = 0.37;
    const murk_vec3 corner = murk_along(from, share, seam);
    const murk_surface_desc d[3] = {
        a_rect(from, seam, murk_scale(-1, edge), WALL),
        a_rect(from, murk_scale(share, seam), edge, WALL),
        a_rect(corner, murk_scale(1 - share, seam), edge, WALL)};
    /* A row of candidates behind the wall, and a lamp for each on the line
     * through the corner. */
    const murk_vec3 behind = murk_unit(murk_cross(seam, edge));
    const murk_vec3 middle = murk_along(corner, -1.1, behind);
    const murk_candidate_grid grid = {
        .min = {middle.x - 0.3, middle.y, middle.z},
        .max = {middle.x + 0.3, middle.y, middle.z},
        .size = {ROW, 1, 1}};
    murk_vec3 lamps[ROW];
    for (size_t i = 0; i < ROW; ++i) {
        const murk_vec3 at = murk_candidate_grid_point(&grid, i);
        lamps[i] = murk_along(at, 2, murk_sub(corner, at));
    }
    const murk_reach reach = {
        .lamps = lamps, .n_lamps = ROW, .domain = interior};
    /* All candidates are out of reach. */
    murk_surfaces *surfaces = surfaces_of(d, 3);
    murk_candidates *c = NULL;
    murk_error err = {0};
    CHECK(murk_candidates_create(&c, &(murk_candidate_desc){.grid = grid},
                                 surfaces, &reach, 1, "here",
                                 &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "64 out of reach");
    murk_candidates_destroy(c);
    murk_surfaces_destroy(surfaces);
}

static void test_nothing_slips_in_through_a_seam(void)
{
    for (uint32_t i = 0; i < 100; ++i) {
        check_seam(i);
    }
}

/* A wall at x = 5.25 with a door, y 7..9, z 0..2; door filled by `door`. */
static size_t add_wall(murk_surface_desc *d, size_t n, double x, int door)
{
    d[n++] =
        a_rect(murk_vec(x, 0, 0), murk_vec(0, 7, 0), murk_vec(0, 0, 4), WALL);
    d[n++] =
        a_rect(murk_vec(x, 9, 0), murk_vec(0, 1, 0), murk_vec(0, 0, 4), WALL);
    d[n++] =
        a_rect(murk_vec(x, 7, 2), murk_vec(0, 2, 0), murk_vec(0, 0, 2), WALL);
    if (door >= 0) {
        d[n++] = a_rect(murk_vec(x, 7, 0), murk_vec(0, 2, 0), murk_vec(0, 0, 2),
                        door);
    }
    return n;
}

static void test_light_goes_through_doors_and_windows(void)
{
    const murk_candidate_grid grid = half_metres();
    const murk_reach reach = by_lamp();
    const int doors[3] = {-1, GLASS, WALL};
    for (int i = 0; i < 3; ++i) {
        murk_surface_desc d[N_MAX];
        const size_t n = add_wall(d, add_sides(d, 0), 5.25, doors[i]);
        murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
        CHECK(c && c->unreached == (doors[i] == WALL ? 9 * 19 * 7 : 0));
        /* In a corner that the lamp cannot see through the door. */
        CHECK(has(c, murk_vec(5.5, 0.5, 0.5)) == (doors[i] != WALL));
        murk_candidates_destroy(c);
    }
}

/* The wall lies in a plane of the grid: its points are dropped, and those
 * behind the window are reached all the same. */
static void test_a_wall_in_a_plane_of_the_grid(void)
{
    const murk_candidate_grid grid = half_metres();
    const murk_reach reach = by_lamp();
    murk_surface_desc d[N_MAX];
    const size_t n = add_wall(d, add_sides(d, 0), 5, GLASS);
    murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->too_close == 19 * 7 && c->unreached == 0);
    CHECK(c && c->doubtful == 0);
    CHECK(!has(c, murk_vec(5, 0.5, 0.5)) && has(c, murk_vec(5.5, 0.5, 0.5)));
    murk_candidates_destroy(c);
}

/* The same, with a screen between lamp and window: only steps lead there, and
 * they pass over the points on the glass. */
static void test_steps_cross_a_sheet_in_a_plane_of_the_grid(void)
{
    const murk_candidate_grid grid = half_metres();
    const murk_reach reach = by_lamp();
    murk_surface_desc d[N_MAX];
    size_t n = add_wall(d, add_sides(d, 0), 5, GLASS);
    d[n++] = a_rect(murk_vec(0, 5.75, 0), murk_vec(4.4, 0, 0),
                    murk_vec(0, 0, 4), WALL);
    murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->too_close == 19 * 7 && c->unreached == 0);
    murk_candidates_destroy(c);
}

static void test_points_on_the_sides_are_dropped(void)
{
    murk_surface_desc d[N_MAX];
    const murk_candidate_grid grid = {
        .min = {0, 0, 0}, .max = {10, 10, 4}, .size = {11, 11, 5}};
    const murk_reach reach = by_lamp();
    murk_candidates *c = candidates_of(d, add_sides(d, 0), &grid, &reach, 1);
    CHECK(c && c->usable == 9 * 9 * 3 && c->unreached == 0);
    murk_candidates_destroy(c);
}

static void test_clearance(void)
{
    murk_surface_desc d[N_MAX];
    const size_t n = add_sides(d, 0);
    murk_candidate_grid grid = half_metres();
    const murk_reach reach = by_lamp();
    grid.clearance_m = 0.5; /* the outer points stand exactly there: kept */
    murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->usable == c->asked);
    murk_candidates_destroy(c);
    grid.clearance_m = 0.5001;
    c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->usable == 17 * 17 * 5 && c->unreached == 0);
    murk_candidates_destroy(c);
}

/* A slot 0.4 m wide between two slabs: too narrow to stand in with 0.35 m of
 * clearance, and the only path to the room behind. */
static void test_paths_lead_through_points_too_close(void)
{
    murk_surface_desc d[N_MAX];
    size_t n = add_sides(d, 0);
    d[n++] =
        a_rect(murk_vec(5.25, 0, 0), murk_vec(0, 4.8, 0), murk_vec(0, 0, 4), 0);
    d[n++] = a_rect(murk_vec(5.25, 5.2, 0), murk_vec(0, 4.8, 0),
                    murk_vec(0, 0, 4), 0);
    murk_candidate_grid grid = half_metres();
    grid.clearance_m = 0.35;
    const murk_reach reach = by_lamp();
    murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->unreached == 0 && c->too_close == 2 * 19 * 7);
    murk_candidates_destroy(c);
}

static void test_a_lamp_on_the_ceiling(void)
{
    const murk_vec3 on = {5, 5, 4};
    murk_surface_desc d[N_MAX];
    const murk_candidate_grid grid = half_metres();
    const murk_reach reach = {.lamps = &on, .n_lamps = 1, .domain = interior};
    murk_candidates *c = candidates_of(d, add_sides(d, 0), &grid, &reach, 1);
    CHECK(c && c->usable == c->asked);
    murk_candidates_destroy(c);
}

static void test_distant_light_enters_by_open_sides(void)
{
    murk_surface_desc d[N_MAX];
    size_t n = 0;
    const murk_candidate_grid grid = half_metres();
    murk_reach reach = {.from_sides = true, .domain = interior};
    d[n++] =
        a_rect(murk_vec(0, 0, 0.1), murk_vec(10, 0, 0), murk_vec(0, 10, 0), 0);
    d[n++] = a_box(murk_vec(4.25, 4.25, 0.25), murk_vec(6.25, 6.25, 2.25));
    murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->unreached == 4 * 4 * 4);
    murk_candidates_destroy(c);

    /* Walls in the planes of the sides close them. */
    n = add_sides(d, 0);
    murk_surfaces *surfaces = surfaces_of(d, n);
    murk_error err = {0};
    c = NULL;
    CHECK(murk_candidates_create(&c, &(murk_candidate_desc){.grid = grid},
                                 surfaces, &reach, 1, "here",
                                 &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "none of the 2527 candidates");
    murk_surfaces_destroy(surfaces);
}

/* A roof with eaves: from the sides of an open domain light comes in under it;
 * in a periodic one only from above and below, here through a slit that shows
 * in the plane of the grid's last column; the rest is reached through the
 * side. */
static void test_a_periodic_domain_is_one_space(void)
{
    murk_surface_desc d[N_MAX];
    size_t n = 0;
    d[n++] =
        a_rect(murk_vec(0, 0, 3.75), murk_vec(9, 0, 0), murk_vec(0, 10, 0), 0);
    d[n++] =
        a_rect(murk_vec(0, 0, 0.25), murk_vec(10, 0, 0), murk_vec(0, 10, 0), 0);
    d[n++] =
        a_rect(murk_vec(8.75, 0, 0), murk_vec(0, 10, 0), murk_vec(0, 0, 4), 0);
    const murk_candidate_grid grid = half_metres();
    murk_domain periodic = interior;
    periodic.is_periodic = true;
    const murk_reach reach = {.from_sides = true, .domain = periodic};
    murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->unreached == 0);
    murk_candidates_destroy(c);

    /* With a wall at the side, too, only the last columns are left. */
    d[n++] =
        a_rect(murk_vec(0, 0, 0), murk_vec(0, 10, 0), murk_vec(0, 0, 4), 0);
    c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->usable == 2 * 19 * 7);
    murk_candidates_destroy(c);
}

/* One point in a corner pocket whose only opening is a corner away. */
static void test_doubt_is_counted(void)
{
    murk_surface_desc d[N_MAX];
    size_t n = add_sides(d, 0);
    const double s = 0.8; /* walls x = 1 and y = 1 leave a gap at the corner */
    d[n++] = a_rect(murk_vec(1, 0, 0), murk_vec(0, s, 0), murk_vec(0, 0, 4), 0);
    d[n++] = a_rect(murk_vec(0, 1, 0), murk_vec(s, 0, 0), murk_vec(0, 0, 4), 0);
    const murk_candidate_grid grid = {
        .min = {0.5, 0.5, 2}, .max = {9.5, 9.5, 2}, .size = {10, 10, 1}};
    const murk_vec3 far_lamp = {9.1, 3.1, 2};
    const murk_reach reach = {
        .lamps = &far_lamp, .n_lamps = 1, .domain = interior};
    murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
    CHECK(c && c->unreached == 1 && c->doubtful == 1);
    CHECK(!has(c, murk_vec(0.5, 0.5, 2)));
    murk_candidates_destroy(c);
}

/* The same with gaps along an edge of the pocket, for each pair of axes: the
 * point's only way out is one diagonal step across both. Walls without a gap
 * leave no doubt. */
static void test_doubt_is_counted_across_each_pair_of_axes(void)
{
    for (int third = 0; third < 3; ++third) {
        for (int has_gap = 0; has_gap < 2; ++has_gap) {
            murk_surface_desc d[N_MAX];
            size_t n = add_sides(d, 0);
            const double s = has_gap ? 0.8 : 1;
            const int axis[2] = {(third + 1) % 3, (third + 2) % 3};
            murk_vec3 beyond = {0, 0, 0};
            murk_component_set(&beyond, third, 10);
            for (int i = 0; i < 2; ++i) {
                murk_vec3 corner = {0, 0, 0}, across = {0, 0, 0};
                murk_component_set(&corner, axis[i], 1);
                murk_component_set(&across, axis[1 - i], s);
                d[n++] = a_rect(corner, across, beyond, 0);
            }
            murk_candidate_grid grid = {.min = {0.5, 0.5, 0.5},
                                        .max = {3.5, 3.5, 3.5},
                                        .size = {4, 4, 4}};
            murk_component_set(&grid.min, third, 2);
            murk_component_set(&grid.max, third, 2);
            grid.size[third] = 1;
            murk_vec3 far_lamp = {0, 0, 0}; /* does not see the pocket */
            murk_component_set(&far_lamp, axis[0], 3.1);
            murk_component_set(&far_lamp, axis[1], 1.2);
            murk_component_set(&far_lamp, third, 2.2);
            const murk_reach reach = {
                .lamps = &far_lamp, .n_lamps = 1, .domain = interior};
            murk_candidates *c = candidates_of(d, n, &grid, &reach, 1);
            CHECK(c && c->unreached == 1 && c->doubtful == (size_t)has_gap);
            murk_candidates_destroy(c);
        }
    }
}

static void test_threads_change_nothing(void)
{
    murk_surface_desc d[N_MAX];
    size_t n = add_wall(d, add_sides(d, 0), 5.25, -1);
    d[n++] = a_box(murk_vec(1.25, 4.25, 0.25), murk_vec(3.25, 6.25, 2.25));
    const murk_candidate_grid grid = half_metres();
    const murk_reach reach = by_lamp();
    murk_candidates *one = candidates_of(d, n, &grid, &reach, 1);
    const unsigned threads[2] = {2, 5};
    for (int i = 0; i < 2; ++i) {
        murk_candidates *c = candidates_of(d, n, &grid, &reach, threads[i]);
        CHECK(c && one && c->usable == one->usable &&
              c->doubtful == one->doubtful &&
              memcmp(c->position, one->position,
                     c->usable * sizeof *c->position) == 0);
        murk_candidates_destroy(c);
    }
    murk_candidates_destroy(one);
}

static void check_refused(murk_candidate_grid grid, const char *why)
{
    murk_surface_desc d[N_MAX];
    murk_surfaces *surfaces = surfaces_of(d, add_sides(d, 0));
    const murk_reach reach = by_lamp();
    murk_candidates *c = NULL;
    murk_error err = {0};
    CHECK(murk_candidates_create(&c, &(murk_candidate_desc){.grid = grid},
                                 surfaces, &reach, 1, "here",
                                 &err) == MURK_BAD_VALUE);
    CHECK(c == NULL);
    CHECK_TEXT(err.where, "here");
    CHECK_MENTIONS(err.text, why);
    murk_surfaces_destroy(surfaces);
}

static void test_bad_grids_are_refused(void)
{
    murk_candidate_grid grid = half_metres();
    grid.max.x = 10.5;
    check_refused(grid, "candidate [10.5, 0.5, 0.5] m is outside the domain");
    grid = half_metres();
    grid.min.y = 9.6; /* a hundredth farther than where it ends */
    check_refused(grid, "y runs from 9.6 to 9.5 m, must rise");
    grid = half_metres();
    grid.min.x = grid.max.x; /* a line of several points has a length */
    check_refused(grid, "x runs from 9.5 to 9.5 m, must rise");
    grid.size[0] = 2;
    check_refused(grid, "x runs from 9.5 to 9.5 m, must rise");
    grid = half_metres();
    grid.size[1] = 0;
    check_refused(grid, "size is [19, 0, 7]");
    grid = half_metres();
    grid.size[0] = grid.size[1] = grid.size[2] = SIZE_MAX;
    check_refused(grid, "must be 1e+07 at most");
    grid = half_metres();
    grid.min.z = 3.6;
    check_refused(grid, "z runs from 3.6 to 3.5 m");
    grid = half_metres();
    grid.min.y = NAN;
    check_refused(grid, "not finite");
    grid = half_metres();
    grid.clearance_m = -1;
    check_refused(grid, "clearance_m is -1 m");
    grid.clearance_m = NAN;
    check_refused(grid, "clearance_m");
    grid = half_metres();
    grid.clearance_m = 3;
    check_refused(grid, "none of the 2527 candidates is usable: 0 out of reach "
                        "of any light, 2527 on a surface or nearer to one");
}

int main(void)
{
    test_an_empty_box_keeps_all_in_order();
    test_inside_a_closed_crate_is_dropped();
    test_inside_an_open_crate_on_the_floor_is_dropped();
    test_winding_means_nothing();
    test_nothing_slips_in_through_a_corner();
    test_nothing_slips_in_through_a_seam();
    test_light_goes_through_doors_and_windows();
    test_a_wall_in_a_plane_of_the_grid();
    test_steps_cross_a_sheet_in_a_plane_of_the_grid();
    test_points_on_the_sides_are_dropped();
    test_clearance();
    test_paths_lead_through_points_too_close();
    test_a_lamp_on_the_ceiling();
    test_distant_light_enters_by_open_sides();
    test_a_periodic_domain_is_one_space();
    test_doubt_is_counted();
    test_doubt_is_counted_across_each_pair_of_axes();
    test_threads_change_nothing();
    test_bad_grids_are_refused();
    return check_done();
}
