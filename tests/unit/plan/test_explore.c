/* Exploring: what is seen from where, and that nothing else is used. The seed
 * is fixed: nothing here is random. */
#include "corridor.h"

/* From (1, 1) the segment to (2, 9) passes the corner's edge, (2, 8), at x =
 * 1.875; that to (3, 9) would pass it at 2.75. */
static void test_nobody_jumps_round_the_corner(void)
{
    made m = explore(NULL);
    const murk_explore *e = &m.plan.explore;
    CHECK_TEXT(m.err.text, "");
    CHECK(e->steps > 1 && e->places == SITES);
    if (e->steps > 1) {
        CHECK(is_at(station(&m, 0), 1, 1));
        CHECK(e->step[0].places_seen == 10 && e->step[0].path_m == 0);
        CHECK(station(&m, 1).x <= 2 && e->step[1].gain > 0);
        CHECK_NEAR(e->step[1].path_m,
                   murk_length(murk_sub(station(&m, 1), station(&m, 0))),
                   1e-12);
    }
    CHECK(m.plan.place.upper >= m.plan.place.value);
    CHECK_TEXT(m.plan.place.guarantee, "none");
    /* in clear air it ends where all is seen, short of the count */
    CHECK(e->end == MURK_EXPLORE_NOTHING && e->steps < 8);
    CHECK(m.plan.place.value == m.plan.place.ceiling);
    unmake(&m);
}

/* Each place that is seen is tried once, and remembered. */
static void test_queries_are_counted(void)
{
    const char *const list[] = {NEAR, "sensors.count=3", NULL};
    made m = explore_with(CORRIDOR, list, 2);
    const murk_explore_step *step = m.plan.explore.step;
    CHECK(m.plan.explore.steps == 3 &&
          m.plan.explore.end == MURK_EXPLORE_COUNT);
    if (m.plan.explore.steps == 3) {
        CHECK(step[0].queries == 1 && step[0].shadow_rays > 0);
        CHECK(step[0].places_seen == 4);
        CHECK(step[1].queries == 4);
        CHECK(step[2].queries == step[1].places_seen);
        CHECK(m.plan.queries == step[2].queries);
        CHECK(m.plan.shadow_rays == step[2].shadow_rays);
        CHECK(m.plan.place.queries == m.plan.queries);
    }
    unmake(&m);
}

/* Only a shield in the second leg reflects, away from the first, so that
 * nothing there adds coverage: the corner is turned all the same. (1, 8), (1,
 * 9) and (2, 9) see all of the second leg: the first has the lowest number. */
static void test_a_dark_corner_is_turned(void)
{
    const char *const list[] = {
        "materials.wall.diffuse=0",
        "geometry=[" WALLS ", {box: {min_m: [8.4, 8.2, 0.5], max_m: [8.599, "
        "8.8, 2.5]}, material: wall}, {rect: {corner_m: [8.6, 8.2, 0.5], "
        "edge1_m: [0, 0.6, 0], edge2_m: [0, 0, 2]}, material: lit}]",
        NULL};
    made m = explore_with(CORRIDOR, list, 1);
    const murk_explore *e = &m.plan.explore;
    CHECK_TEXT(m.err.text, "");
    CHECK(e->steps > 2);
    if (e->steps > 2) {
        CHECK(e->step[0].gain == 0 && e->step[1].gain == 0);
        CHECK(is_at(station(&m, 1), 1, 8) && e->step[1].places_seen == SITES);
        CHECK_NEAR(e->step[1].path_m, 7, 1e-12);
        CHECK(e->step[2].gain > 0);
    }
    unmake(&m);
}

/* 2.996 / 0.5 per m: what is farther than 5.99 m is not seen, (1, 1) to (1, 6)
 * are. */
static void test_fog_hides_places(void)
{
    const char *const list[] = {
        "media={fog: {extinction_per_m: 0.5, albedo: 0.5}}",
        "regions=[{medium: fog}]", NULL};
    const char *const thinner[] = {
        "media={fog: {extinction_per_m: 0.4, albedo: 0.5}}",
        "regions=[{medium: fog}]", NULL};
    made m = explore_with(CORRIDOR, list, 2);
    CHECK_TEXT(m.err.text, "");
    CHECK(m.plan.explore.steps > 0 && m.plan.explore.step[0].places_seen == 6);
    unmake(&m);
    m = explore_with(CORRIDOR, thinner, 2); /* 7.49 m */
    CHECK(m.plan.explore.steps > 0 && m.plan.explore.step[0].places_seen == 8);
    unmake(&m);
}

/* Light and sight go through it, nobody else does. */
static void test_a_pane_is_not_walked_through(void)
{
    const char *const list[] = {"geometry=[" WALLS PANE "]", NULL};
    made m = explore_with(CORRIDOR, list, 2);
    const murk_explore *e = &m.plan.explore;
    CHECK_TEXT(m.err.text, "");
    CHECK(e->places == SITES && e->steps > 0);
    CHECK(e->steps > 0 && e->step[e->steps - 1].places_seen == 5);
    for (size_t k = 0; k < e->steps; ++k) {
        CHECK(station(&m, k).y <= 5);
    }
    CHECK(e->end == MURK_EXPLORE_NOTHING && e->steps < 8);
    unmake(&m);
}

/* Whether the straight segment keeps out of the block within the corner. */
static bool is_outside(murk_vec3 a, murk_vec3 b)
{
    for (int k = 0; k <= 1000; ++k) {
        const murk_vec3 p = murk_along(a, k / 1000.0, murk_sub(b, a));
        if (p.x > 2 && p.y < 8) {
            return false;
        }
    }
    return true;
}

/* From the corner, stations go down the first leg, (1, 6) and (1, 3), and
 * then to (4, 9), which is out of straight reach: the shortest path there
 * leads over (2, 9). */
static void test_paths_go_round_corners(void)
{
    /* Nodes that see 3.5 m must walk along both legs. */
    const char *const list[] = {NEAR, "placement.start_m=[1, 9, 1]", NULL};
    made m = explore_with(CORRIDOR, list, 2);
    const murk_explore *e = &m.plan.explore;
    /* No part of the path leads through the inner block. */
    double length_m = 0;
    size_t turns = 0;
    for (size_t k = 1; k < e->stops; ++k) {
        length_m += murk_length(murk_sub(e->stop[k], e->stop[k - 1]));
        CHECK(is_outside(e->stop[k - 1], e->stop[k]));
    }
    /* A station out of straight reach adds two stops, once, at the corner;
     * all others add one at most. */
    for (size_t k = 1; k < e->steps; ++k) {
        const bool is_straight = is_outside(station(&m, k - 1), station(&m, k));
        const size_t passed = e->step[k].stops - e->step[k - 1].stops;
        CHECK(is_straight ? passed <= 1 : passed == 2);
        turns += !is_straight;
    }
    CHECK(turns == 1);
    /* The fourth station and the path length there are known, and path
     * lengths are the lengths of the stops. */
    if (e->steps > 3) {
        CHECK(is_at(station(&m, 3), 4, 9));
        CHECK(is_at(e->stop[3], 2, 9));
        CHECK_NEAR(e->step[3].path_m, 3 + 3 + sqrt(37) + 2, 1e-12);
    }
    CHECK(e->steps > 3 && e->step[e->steps - 1].stops == e->stops);
    CHECK(e->steps > 3 && fabs(length_m - e->step[e->steps - 1].path_m) < 1e-9);
    unmake(&m);
}

static bool is_same_run(const murk_explore *a, const murk_explore *b)
{
    bool is_same = a->steps == b->steps && a->stops == b->stops &&
                   a->lines_tested == b->lines_tested && a->end == b->end;
    for (size_t k = 0; is_same && k < a->steps; ++k) {
        const murk_explore_step *s = &a->step[k], *t = &b->step[k];
        is_same = s->candidate == t->candidate && s->gain == t->gain &&
                  s->value == t->value && s->path_m == t->path_m &&
                  s->places_seen == t->places_seen &&
                  s->queries == t->queries && s->shadow_rays == t->shadow_rays;
    }
    return is_same;
}

static void test_threads_change_nothing(void)
{
    const char *const list[] = {NEAR, NULL};
    made one = explore_with(CORRIDOR, list, 1);
    made three = explore_with(CORRIDOR, list, 3);
    CHECK(one.plan.explore.steps >= 4);
    CHECK(is_same_run(&one.plan.explore, &three.plan.explore));
    unmake(&one);
    unmake(&three);
}

static void check_refused(const char *override, const char *part)
{
    made m = explore(override);
    CHECK(m.status == MURK_BAD_VALUE);
    CHECK_MENTIONS(m.err.text, part);
    CHECK_MENTIONS(m.err.where, "placement");
    unmake(&m);
}

static void test_bad_starts_are_refused(void)
{
    check_refused("placement={knowledge: explore}",
                  "start_m: not given, but knowledge is explore, which begins "
                  "at start_m, [x, y, z] in m, or at a fixed sensor");
    check_refused("placement.start_m=[1, 1, 7]",
                  "start_m: [1, 1, 7] m lies outside the domain, [-0.1");
    check_refused("placement.start_m=[5, 5, 1]",
                  "no straight open way leads from [5, 5, 1] m to any of the "
                  "17 usable candidates");
}

int main(void)
{
    test_nobody_jumps_round_the_corner();
    test_queries_are_counted();
    test_a_dark_corner_is_turned();
    test_fog_hides_places();
    test_a_pane_is_not_walked_through();
    test_paths_go_round_corners();
    test_threads_change_nothing();
    test_bad_starts_are_refused();
    return check_done();
}
