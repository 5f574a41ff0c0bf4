/* Candidates that are listed or mounted, beside those of a grid, and zones: in
 * rooms where each answer is known.
 *
 * Deterministic: never cries wolf. */
#include "sensing/candidates.h"
#include "world.h"

#include <stdlib.h>

#define N_MAX 8

/* A room of 4 x 3 x 2.5 m with a lamp and a crate on its floor. */
static const murk_domain INTERIOR = {.box = {{0, 0, 0}, {4, 3, 2.5}}};
static const murk_vec3 LAMP = {1, 1, 2.2};

typedef struct asking {
    murk_surface_desc surface[N_MAX];
    size_t surfaces;
    murk_domain domain;
    murk_candidate_desc desc;
    double spacing_m, offset_m, min_up, max_up;
} asking;

static asking asking_of(bool has_crate)
{
    asking a = {.surface = {a_box(INTERIOR.box.min, INTERIOR.box.max),
                            a_box(murk_vec(2, 1, 0), murk_vec(3, 2, 1))},
                .surfaces = has_crate ? 2 : 1,
                .domain = INTERIOR,
                .desc = {.grid = {.min = {.25, .25, .25},
                                  .max = {3.75, 2.75, 2.25},
                                  .size = {8, 6, 5}}},
                .offset_m = .1,
                .min_up = -1,
                .max_up = 1};
    return a;
}

/* Makes candidates, with mounts on all surfaces if spacing_m is above 0. If
 * err is given, a refusal is expected: returns NULL and the error. */
static murk_candidates *candidates_of(const asking *a, unsigned threads,
                                      murk_error *err)
{
    /* The surfaces, and a lamp from which candidates are reached. */
    murk_surfaces *surfaces = surfaces_of(a->surface, a->surfaces);
    const murk_reach reach = {
        .lamps = &LAMP, .n_lamps = 1, .domain = a->domain};
    murk_candidate_desc desc = a->desc;
    murk_candidate_mount mount = {
        .offset_m = a->offset_m, .min_up = a->min_up, .max_up = a->max_up};
    murk_mount_site *foot = NULL;
    /* Mount sites on all surfaces, if a spacing is asked for. */
    if (a->spacing_m > 0) {
        const murk_mount_search lay = {.spacing_m = a->spacing_m,
                                       .within = a->domain.box,
                                       .max_rise = 1,
                                       .max = 1000000};
        CHECK(murk_surfaces_mount_sites(&foot, &mount.sites, surfaces, &lay,
                                        "here", NULL) == MURK_OK);
        mount.site = foot;
        desc.mount = &mount;
        desc.mounts = 1;
    }
    /* Candidates, or a refusal if the caller expects one. */
    murk_candidates *out = NULL;
    murk_error found_err = {0};
    const murk_status status = murk_candidates_create(
        &out, &desc, surfaces, &reach, threads, "here", &found_err);
    if (err) {
        *err = found_err;
        CHECK(status == MURK_BAD_VALUE && out == NULL);
    } else {
        CHECK(status == MURK_OK);
        CHECK_TEXT(found_err.text, "");
    }
    /* Every candidate is usable or left out for one reason. */
    if (out) {
        CHECK(out->usable + out->duplicates + out->forbidden + out->too_close +
                  out->unreached ==
              out->asked);
    }
    free(foot);
    murk_surfaces_destroy(surfaces);
    return out;
}

/* ---- listed points ---- */

static void test_points_are_joined_to_the_grid(void)
{
    const murk_vec3 point[5] = {{.6, .7, .8},   /* free */
                                {2.5, 1.5, .5}, /* in the crate */
                                {2.5, 1.5, 1.2},
                                {3, 1.5, .5}, /* on its side */
                                {3.01, 1.5, .5}};
    asking a = asking_of(true);
    a.desc.point = point;
    a.desc.points = 5;
    murk_candidates *c = candidates_of(&a, 1, NULL);
    CHECK(c->asked == 240 + 5 && c->unreached == 8 + 1 && c->too_close == 1);
    CHECK(c->usable == 240 - 8 + 3 && c->normal == NULL);
    const size_t first = c->usable - 3;
    CHECK(murk_length(murk_sub(c->position[first], point[0])) == 0);
    CHECK(murk_length(murk_sub(c->position[first + 1], point[2])) == 0);
    CHECK(murk_length(murk_sub(c->position[first + 2], point[4])) == 0);
    CHECK(c->kind[first - 1] == MURK_CANDIDATE_GRID &&
          c->kind[first] == MURK_CANDIDATE_POINT);
    murk_candidates_destroy(c);

    a.desc.grid.clearance_m = .05;
    a.desc.is_reach_grid = true; /* only the points are asked */
    c = candidates_of(&a, 1, NULL);
    CHECK(c->asked == 5 && c->usable == 2 && c->too_close == 2 &&
          c->unreached == 1);
    murk_candidates_destroy(c);
}

/* Behind a screen there is no point of the grid, but one path leads there. */
static void test_a_path_to_any_point_of_the_grid_suffices(void)
{
    const murk_vec3 point[2] = {{3.97, 1.5, 1.2}, {3.97, 1.5, .05}};
    asking a = asking_of(false);
    a.surface[a.surfaces++] =
        a_rect(murk_vec(3.94, 0, .1), murk_vec(0, 3, 0), murk_vec(0, 0, 2), 0);
    a.desc.grid.max.x = 3.5;
    a.desc.point = point;
    a.desc.points = 2;
    a.desc.is_reach_grid = true;
    murk_candidates *c = candidates_of(&a, 1, NULL);
    /* the lower one sees through the gap of 10 cm, the other does not */
    CHECK(c->usable == 1 && c->unreached == 1 && c->position[0].z == .05);
    murk_candidates_destroy(c);
}

/* Light alone joins what no point of the grid is near. */
static void test_a_lamp_joins_too(void)
{
    const murk_vec3 point = {1.2, 1.1, 2.1};
    asking a = asking_of(false);
    a.surface[a.surfaces++] =
        a_box(murk_vec(.8, .8, 2), murk_vec(1.3, 1.3, 2.4));
    a.desc.grid.size[0] = a.desc.grid.size[1] = a.desc.grid.size[2] = 2;
    a.desc.point = &point;
    a.desc.points = 1;
    a.desc.is_reach_grid = true;
    murk_candidates *c = candidates_of(&a, 1, NULL);
    CHECK(c && c->usable == 1);
    murk_candidates_destroy(c);
}

static void test_duplicates_are_counted_once(void)
{
    const murk_vec3 point[6] = {
        {1, 1, 1},     {1, 1, 1 + 1e-6},
        {1, 1.001, 1}, {1.25, .75, 1.25}, /* of the grid */
        {1, 1, 1},     {3.75 + 1e-7, 2.75, 2.25}};
    asking a = asking_of(false);
    a.desc.point = point;
    a.desc.points = 6;
    murk_candidates *c = candidates_of(&a, 1, NULL);
    CHECK(c->asked == 246 && c->duplicates == 4 && c->usable == 242);
    murk_candidates_destroy(c);
    a.desc.is_reach_grid = true;
    c = candidates_of(&a, 1, NULL);
    CHECK(c->asked == 6 && c->duplicates == 2 && c->usable == 4);
    murk_candidates_destroy(c);
}

/* ---- mounts ---- */

/* Each stands offset_m before one wall of the room, its normal out of it, in
 * the pattern of half metres. */
static void test_mounts_stand_off_walls(void)
{
    asking a = asking_of(false);
    a.desc.is_reach_grid = true;
    a.desc.grid.clearance_m = .2; /* its own wall does not count */
    a.spacing_m = .5;
    murk_candidates *c = candidates_of(&a, 1, NULL);
    CHECK(c->asked == 2 * 236 && c->usable == 236 && c->unreached == 236);
    for (size_t i = 0; i < c->usable; ++i) {
        const double p[3] = {c->position[i].x, c->position[i].y,
                             c->position[i].z};
        const double n[3] = {c->normal[i].x, c->normal[i].y, c->normal[i].z};
        const double size[3] = {4, 3, 2.5};
        int walls = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (n[axis] == 0) {
                CHECK_NEAR(fabs(fmod(p[axis], .5) - .25), 0, 1e-12);
                continue;
            }
            ++walls;
            CHECK(n[axis] == 1 || n[axis] == -1);
            CHECK_NEAR(p[axis], n[axis] > 0 ? .1 : size[axis] - .1, 1e-12);
        }
        CHECK(walls == 1 && c->kind[i] == MURK_CANDIDATE_MOUNT);
    }
    murk_candidates_destroy(c);

    a.desc.grid.clearance_m = .25 + 1e-3; /* rows at .25 of the other walls */
    c = candidates_of(&a, 1, NULL);
    CHECK(c->usable == 2 * (6 * 4 + 6 * 3 + 4 * 3));
    CHECK(c->too_close == 236 - c->usable);
    murk_candidates_destroy(c);
}

static void test_mounts_face_as_asked(void)
{
    asking a = asking_of(true);
    a.desc.is_reach_grid = true;
    a.spacing_m = .5;
    a.min_up = .7;
    murk_candidates *c = candidates_of(&a, 1, NULL);
    /* floor, ceiling, lid; the crate's floor lies in the room's. Free are the
     * floor, but under the crate, and the lid. */
    CHECK(c->asked == 48 + 48 + 4);
    CHECK(c->usable == 48 - 4 + 4);
    for (size_t i = 0; i < c->usable; ++i) {
        const double z = c->position[i].z;
        CHECK(c->normal[i].z == 1 && (fabs(z - .1) < 1e-9 || z == 1.1));
    }
    murk_candidates_destroy(c);
    a.min_up = -1;
    a.max_up = -.7;
    c = candidates_of(&a, 1, NULL);
    CHECK(c->usable == 48);
    murk_candidates_destroy(c);
    a.max_up = .7;
    a.min_up = -.7;
    c = candidates_of(&a, 1, NULL);
    CHECK(c->usable == 2 * (40 + 30) + 4 * 4);
    murk_candidates_destroy(c);
}

/* A screen a hand before the wall: mounts on the wall that would lie beyond
 * the screen are not usable. An open sheet has mounts on both sides. */
static void test_mounts_do_not_pass_through(void)
{
    /* A screen 0.08 m before a wall, and mounts 0.1 m before each surface. */
    asking a = asking_of(false);
    a.surface[a.surfaces++] =
        a_rect(murk_vec(.08, 0, 0), murk_vec(0, 3, 0), murk_vec(0, 0, 2), 0);
    a.desc.is_reach_grid = true;
    a.spacing_m = .5;
    murk_candidates *c = candidates_of(&a, 1, NULL);
    /* Mounts of the screen are usable; those of the wall would be beyond
     * the screen. */
    size_t before = 0, beyond = 0;
    for (size_t i = 0; i < c->usable; ++i) {
        const bool is_low = c->position[i].z < 2;
        before += is_low && fabs(c->position[i].x - .18) < 1e-6;
        beyond += is_low && fabs(c->position[i].x - .1) < 1e-6;
    }
    CHECK(before == 6 * 4 && beyond == 0);
    murk_candidates_destroy(c);
    /* The same screen in the middle of the room. */
    a.surface[1].corner.x = 2;
    c = candidates_of(&a, 1, NULL);
    /* Mounts are on both sides of the screen. */
    size_t side[2] = {0, 0};
    for (size_t i = 0; i < c->usable; ++i) {
        side[0] += fabs(c->position[i].x - 1.9) < 1e-6;
        side[1] += fabs(c->position[i].x - 2.1) < 1e-6;
    }
    CHECK(side[0] == 24 && side[1] == 24);
    murk_candidates_destroy(c);
}

/* Where the domain repeats, a path may lead through its sides. */
static void test_paths_through_periodic_sides(void)
{
    const murk_vec3 point = {.1, 1.5, 1};
    asking a = asking_of(false);
    a.domain.is_periodic = true;
    a.surface[0] = a_box(murk_vec(.5, -9, -9), murk_vec(.6, 9, 9));
    a.desc.grid.min.x = 1;
    a.desc.point = &point;
    a.desc.points = 1;
    a.desc.is_reach_grid = true;
    murk_candidates *c = candidates_of(&a, 1, NULL);
    CHECK(c && c->usable == 1);
    murk_candidates_destroy(c);
    a.domain.is_periodic = false;
    murk_error err;
    c = candidates_of(&a, 1, &err);
    CHECK_MENTIONS(err.text, "none of the 1 candidates is usable: 1 out of "
                             "reach of any light");
}

/* A wall in the plane where the domain repeats has both its sides in it. */
static void test_mounts_on_a_periodic_side(void)
{
    asking a = asking_of(false);
    a.domain.is_periodic = true;
    a.surface[0] =
        a_rect(murk_vec(0, 0, 0), murk_vec(0, 3, 0), murk_vec(0, 0, 2.5), 0);
    a.desc.is_reach_grid = true;
    a.spacing_m = .5;
    murk_candidates *c = candidates_of(&a, 1, NULL);
    CHECK(c->asked == 60 && c->usable == 60);
    size_t side[2] = {0, 0};
    for (size_t i = 0; i < c->usable; ++i) {
        side[0] += c->normal[i].x == 1 && fabs(c->position[i].x - .1) < 1e-9;
        side[1] += c->normal[i].x == -1 && fabs(c->position[i].x - 3.9) < 1e-9;
    }
    CHECK(side[0] == 30 && side[1] == 30);
    murk_candidates_destroy(c);
    a.domain.is_periodic = false;
    c = candidates_of(&a, 1, NULL);
    CHECK(c->usable == 30 && c->unreached == 30);
    murk_candidates_destroy(c);
}

/* ---- zones ---- */

static murk_zones *box_zone(murk_vec3 min, murk_vec3 max)
{
    const murk_zone zone = {.shape = MURK_REGION_BOX,
                            .box = {min, max},
                            .to_world = murk_affine_identity()};
    murk_zones *zones = NULL;
    CHECK(murk_zones_create(&zones, &zone, 1, NULL) == MURK_OK);
    return zones;
}

static void test_zones_forbid(void)
{
    const murk_vec3 point[2] = {{.6, .7, .8}, {3.1, .7, .8}};
    asking a = asking_of(true);
    a.desc.point = point;
    a.desc.points = 2;
    /* x up to 2: four of the grid's eight columns, and none of the crate */
    murk_zones *half = box_zone(murk_vec(0, 0, 0), murk_vec(2, 3, 3));
    a.desc.avoid = half;
    murk_candidates *c = candidates_of(&a, 1, NULL);
    CHECK(c->forbidden == 120 + 1 && c->unreached == 8 &&
          c->usable == 120 - 8 + 1);
    for (size_t i = 0; i < c->usable; ++i) {
        CHECK(c->position[i].x > 2);
    }
    murk_candidates_destroy(c);
    a.desc.avoid = NULL;
    a.desc.within = half;
    c = candidates_of(&a, 1, NULL);
    CHECK(c->forbidden == 120 + 1 && c->unreached == 0 && c->usable == 121);
    murk_candidates_destroy(c);
    a.desc.avoid = half;
    murk_error err;
    c = candidates_of(&a, 1, &err);
    CHECK_TEXT(err.text,
               "none of the 242 candidates is usable: 0 out of reach of any "
               "light, 0 on a surface or nearer to one than 0 m, 242 forbidden "
               "by zones, 0 duplicates");
    murk_zones_destroy(half);
}

/* ---- all together ---- */

static void test_threads_change_nothing(void)
{
    /* Listed points, a grid, mounts and a forbidden zone. */
    asking a = asking_of(true);
    murk_vec3 point[700];
    for (size_t i = 0; i < 700; ++i) {
        point[i] = murk_vec((double)(i % 41) * .09, (double)(i % 17) * .17,
                            (double)(i % 29) * .08);
    }
    a.desc.point = point;
    a.desc.points = 700;
    a.desc.grid.clearance_m = .07;
    a.spacing_m = .2;
    murk_zones *zone = box_zone(murk_vec(1, 0, 1), murk_vec(1.5, 3, 2));
    a.desc.avoid = zone;
    /* With one thread, candidates are left out for every reason. */
    murk_candidates *one = candidates_of(&a, 1, NULL);
    CHECK(one->forbidden > 0 && one->duplicates > 0 && one->too_close > 0 &&
          one->unreached > 0);
    /* More threads give the same candidates. */
    for (unsigned threads = 2; threads <= 5; threads += 3) {
        murk_candidates *c = candidates_of(&a, threads, NULL);
        CHECK(c->usable == one->usable && c->doubtful == one->doubtful);
        CHECK(memcmp(c->position, one->position,
                     c->usable * sizeof *c->position) == 0);
        CHECK(memcmp(c->normal, one->normal, c->usable * sizeof *c->normal) ==
              0);
        CHECK(memcmp(c->kind, one->kind, c->usable) == 0);
        murk_candidates_destroy(c);
    }
    murk_candidates_destroy(one);
    murk_zones_destroy(zone);
}

static void test_bad_lists_are_refused(void)
{
    const murk_vec3 point = {4.5, 1, 1}, lost = {1, NAN, 1};
    asking a = asking_of(false);
    murk_error err;
    a.desc.points = 1;
    a.desc.point = &point;
    candidates_of(&a, 1, &err);
    CHECK_MENTIONS(err.text, "point 0, [4.5, 1, 1] m, is outside");
    a.desc.point = &lost;
    candidates_of(&a, 1, &err);
    CHECK_MENTIONS(err.text, "is outside the domain");
    a = asking_of(false);
    a.spacing_m = 1;
    a.offset_m = 1e-5;
    candidates_of(&a, 1, &err);
    CHECK_MENTIONS(err.text, "offset_m is 1e-05 m, must be more than");
    a = asking_of(false);
    a.desc.is_reach_grid = true;
    candidates_of(&a, 1, &err);
    CHECK_TEXT(err.text, "0 candidates are asked for, must be 1..10000000");
}

int main(void)
{
    test_points_are_joined_to_the_grid();
    test_a_path_to_any_point_of_the_grid_suffices();
    test_a_lamp_joins_too();
    test_duplicates_are_counted_once();
    test_mounts_stand_off_walls();
    test_mounts_face_as_asked();
    test_mounts_do_not_pass_through();
    test_paths_through_periodic_sides();
    test_mounts_on_a_periodic_side();
    test_zones_forbid();
    test_threads_change_nothing();
    test_bad_lists_are_refused();
    return check_done();
}
