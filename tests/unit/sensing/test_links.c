/* Links between sensors: by hand, and against every pair tried. Nothing here
 * is random but places, of a fixed seed. */
#include "base/rng.h"
#include "sensing/links.h"
#include "world.h"

static const murk_domain hall = {.box = {{0, 0, 0}, {10, 10, 4}}};

static murk_links find(const murk_vec3 *place, size_t n,
                       const murk_surfaces *surfaces, const murk_domain *domain,
                       bool through_sheets)
{
    murk_links links = {0};
    murk_error err = {0};
    CHECK(murk_links_find(&links, partial_at(place, n), n, surfaces, domain,
                          through_sheets, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return links;
}

/* Three in a row: the longer of the two gaps. */
static void test_a_row(void)
{
    murk_surfaces *none = surfaces_of(NULL, 0);
    const murk_vec3 row[3] = {{6, 1, 1}, {0.5, 1, 1}, {2, 1, 1}};
    murk_links l = find(row, 3, none, &hall, true);
    CHECK(l.groups == 1 && l.n == 2);
    CHECK(l.range_m == 4 && l.plain_range_m == 4);
    CHECK(l.link[0].from == 0 && l.link[0].to == 2 && l.link[0].length_m == 4);
    CHECK(l.link[1].from == 2 && l.link[1].to == 1);
    murk_links_release(&l);

    l = find(row, 1, none, &hall, true);
    CHECK(l.groups == 1 && l.n == 0 && l.range_m == 0);
    murk_links_release(&l);
    const murk_vec3 same[2] = {{1, 1, 1}, {1, 1, 1}};
    l = find(same, 2, none, &hall, true);
    CHECK(l.groups == 1 && l.range_m == 0);
    murk_links_release(&l);
    l = find(row, 0, none, &hall, true);
    CHECK(l.groups == 0 && l.n == 0 && isnan(l.range_m));
    murk_links_release(&l);
    murk_surfaces_destroy(none);
}

/* A wall from y = 0 to `length_m` at x = 5, to the ceiling. */
static murk_surfaces *walled(double length_m, int material)
{
    const murk_surface_desc wall =
        a_rect(murk_vec(5, 0, 0), murk_vec(0, length_m, 0), murk_vec(0, 0, 4),
               material);
    return surfaces_of(&wall, 1);
}

static void test_walls(void)
{
    const murk_vec3 place[3] = {{4, 2, 2}, {6, 2, 2}, {5, 9, 2}};
    murk_surfaces *closed = walled(10, WALL), *gap = walled(8, WALL),
                  *pane = walled(10, GLASS);
    murk_links l = find(place, 2, closed, &hall, true);
    CHECK(l.groups == 2 && l.n == 0 && isnan(l.range_m));
    CHECK(l.plain_range_m == 2);
    murk_links_release(&l);
    l = find(place, 3, gap, &hall, true); /* by the third, round the end */
    CHECK(l.groups == 1 && l.plain_range_m == sqrt(50));
    CHECK(l.range_m == sqrt(50) && l.n == 2);
    CHECK(l.link[0].to == 2 && l.link[1].from == 2);
    murk_links_release(&l);
    l = find(place, 2, pane, &hall, true);
    CHECK(l.groups == 1 && l.range_m == 2);
    murk_links_release(&l);
    l = find(place, 2, pane, &hall, false);
    CHECK(l.groups == 2);
    murk_links_release(&l);

    /* Periodic sides lead round the closed wall: 8 m in place of 2 m. */
    murk_domain periodic = hall;
    periodic.is_periodic = true;
    const murk_vec3 near_sides[2] = {{1, 2, 2}, {9, 2, 2}};
    l = find(near_sides, 2, closed, &periodic, true);
    CHECK(l.groups == 1);
    CHECK_NEAR(l.range_m, 2, 1e-15);
    murk_links_release(&l);
    murk_surfaces_destroy(closed);
    murk_surfaces_destroy(gap);
    murk_surfaces_destroy(pane);
}

#define PLACES 9

/* Whether links no longer than range_m join all: spread until nothing new. */
static bool joined(double length_m[PLACES][PLACES], double range_m)
{
    bool is_in[PLACES] = {true};
    for (int sweep = 0; sweep < PLACES; ++sweep) {
        for (int i = 0; i < PLACES; ++i) {
            for (int j = 0; j < PLACES; ++j) {
                is_in[j] = is_in[j] || (is_in[i] && length_m[i][j] <= range_m);
            }
        }
    }
    bool all = true;
    for (int i = 0; i < PLACES; ++i) {
        all = all && is_in[i];
    }
    return all;
}

/* The least of all pairs' lengths that joins; NaN: none does. */
static double min(double length_m[PLACES][PLACES])
{
    double best = NAN;
    for (int i = 0; i < PLACES * PLACES; ++i) {
        const double range_m = length_m[i / PLACES][i % PLACES];
        if (isfinite(range_m) && !(range_m >= best) &&
            joined(length_m, range_m)) {
            best = range_m;
        }
    }
    return best;
}

static void test_against_all_pairs(void)
{
    int split = 0, longer = 0;
    for (uint32_t world = 0; world < 60; ++world) {
        murk_surface_desc wall[6];
        for (uint32_t k = 0; k < 6; ++k) {
            const murk_random4 r = murk_random(1, MURK_TEST, world, 0, k);
            wall[k] = a_rect(murk_vec(9 * r.u[0], 9 * r.u[1], 0),
                             murk_vec(8 * r.u[2] - 4, 8 * r.u[3] - 4, 0),
                             murk_vec(0, 0, 4), WALL);
        }
        murk_surfaces *surfaces = surfaces_of(wall, 6);
        murk_vec3 place[PLACES];
        for (uint32_t k = 0; k < PLACES; ++k) {
            const murk_random4 r = murk_random(1, MURK_TEST, world, 1, k);
            place[k] = murk_vec(10 * r.u[0], 10 * r.u[1], 4 * r.u[2]);
        }
        double open[PLACES][PLACES], plain[PLACES][PLACES];
        for (int i = 0; i < PLACES; ++i) {
            for (int j = 0; j < PLACES; ++j) {
                plain[i][j] = murk_length(murk_sub(place[i], place[j]));
                open[i][j] =
                    murk_surfaces_blocked(surfaces, place[i], place[j], true)
                        ? INFINITY
                        : plain[i][j];
            }
        }
        murk_links l = find(place, PLACES, surfaces, &hall, true);
        const double want = min(open);
        CHECK(l.range_m == want || (isnan(l.range_m) && isnan(want)));
        CHECK(l.plain_range_m == min(plain));
        CHECK(l.n == PLACES - l.groups);
        CHECK((l.groups == 1) == isfinite(l.range_m));
        for (size_t k = 0; k < l.n; ++k) {
            CHECK(l.link[k].length_m == open[l.link[k].from][l.link[k].to]);
        }
        split += l.groups > 1;
        longer += l.range_m > l.plain_range_m;
        murk_links_release(&l);
        murk_surfaces_destroy(surfaces);
    }
    CHECK(split > 5 && longer > 5); /* or the walls did not matter */
}

/* Too many to try all pairs: said, not tried. */
static void test_a_crowd(void)
{
    const size_t n = MURK_LINKED_SENSORS_MAX + 1;
    murk_pose *pose = calloc(n, sizeof *pose);
    murk_surfaces *none = surfaces_of(NULL, 0);
    murk_links l = {0};
    murk_error err = {0};
    CHECK(!murk_links_find(&l, pose, n, none, &hall, true, &err));
    CHECK(l.groups == 0 && l.n == 0 && isnan(l.range_m) &&
          isnan(l.plain_range_m));
    murk_links_release(&l);
    murk_surfaces_destroy(none);
    free(pose);
}

int main(void)
{
    test_a_row();
    test_walls();
    test_against_all_pairs();
    test_a_crowd();
    return check_done();
}
