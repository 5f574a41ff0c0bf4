/* Exploring under rules: targets, budgets, spacing, least counts, fixed
 * sensors. The seed is fixed: nothing here is random. */
#include "corridor.h"

static void test_targets_end_it(void)
{
    /* A target of half ends the exploration as soon as the target is
     * reached. */
    const char *const list[] = {
        "sensors={types: [{name: node, range_m: 3.5}], target: 0.5, " SITED "}",
        NULL};
    made m = explore_with(CORRIDOR, list, 2);
    const murk_place_result *place = &m.plan.place;
    CHECK_TEXT(m.err.text, "");
    CHECK(m.plan.explore.end == MURK_EXPLORE_TARGET);
    CHECK(2 * place->value >= place->whole && place->count > 1);
    CHECK(2 * m.plan.explore.step[place->count - 2].value < place->whole);
    /* The curve counts the stations of the exploration. */
    CHECK(place->fewest >= 1 && place->fewest <= place->count);
    CHECK(place->curve_points == place->count &&
          place->curve[0].value == m.plan.explore.step[0].value);
    unmake(&m);
    /* Behind a pane, nothing can be explored, and a target of all light is
     * not reached. */
    const char *const spaced[] = {
        "geometry=[" WALLS PANE "]",
        "sensors={types: [{name: node, range_m: 30}], target: 1, " SITED "}",
        NULL};
    m = explore_with(CORRIDOR, spaced, 2);
    CHECK(m.status == MURK_RUN_FAILED);
    CHECK_MENTIONS(m.err.text, "target 1 is not reached: exploring ends with ");
    CHECK_MENTIONS(m.err.text, "5 of 17 places seen: nothing in seen space");
    CHECK_MENTIONS(m.err.where, "sensors");
    unmake(&m);
}

/* Far nodes cost what they see more and a little: near ones are chosen, as many
 * as can be paid. */
static void test_budgets_go_by_cost(void)
{
    const char *const list[] = {
        "sensors={types: [{name: far, range_m: 30, cost: 9}, {name: near, "
        "range_m: 3.5, cost: 1}], budget: 3, " SITED "}",
        NULL};
    made m = explore_with(CORRIDOR, list, 2);
    CHECK_TEXT(m.err.text, "");
    CHECK(m.plan.explore.steps == 3 && m.plan.place.cost == 3000000);
    CHECK(m.plan.explore.end == MURK_EXPLORE_CONSTRAINTS);
    for (size_t k = 0; k < m.plan.explore.steps; ++k) {
        CHECK(m.plan.sensor[k].type == 1);
    }
    unmake(&m);
}

static void test_constraints_are_met(void)
{
    const char *const list[] = {NEAR, "sensors.one_per_site=true",
                                "sensors.candidates.spacing_m=2",
                                "sensors.count=4", NULL};
    made m = explore_with(CORRIDOR, list, 2);
    CHECK_TEXT(m.err.text, "");
    CHECK(m.plan.explore.steps == 4);
    for (size_t k = 0; k < m.plan.explore.steps; ++k) {
        for (size_t j = 0; j < k; ++j) {
            CHECK(murk_length(murk_sub(station(&m, j), station(&m, k))) >= 2);
        }
    }
    unmake(&m);
    /* from (1, 7) on nobody seen is as far as this from it */
    const char *const spaced[] = {NEAR, "sensors.candidates.spacing_m=2.5",
                                  NULL};
    m = explore_with(CORRIDOR, spaced, 2);
    CHECK_TEXT(m.err.text, "");
    CHECK(m.plan.explore.steps == 3 &&
          m.plan.explore.end == MURK_EXPLORE_CONSTRAINTS);
    unmake(&m);
    const char *const short_of[] = {"geometry=[" WALLS PANE "]",
                                    "sensors.types.0.least_count=8", NULL};
    m = explore_with(CORRIDOR, short_of, 2);
    CHECK(m.status == MURK_RUN_FAILED);
    CHECK_MENTIONS(m.err.text, "short of the types' least counts");
    unmake(&m);
}

/* A fixed sensor behind the pane sees the places there, yet no path from
 * the start leads to them. If the path begins at the fixed sensor, no path
 * leads to the first leg. */
static void test_fixed_sensors_see_but_do_not_walk(void)
{
    /* A fixed sensor behind the pane sees all places there, but every
     * station stays before the pane. */
    const char *const list[] = {
        "geometry=[" WALLS PANE "]",
        "sensors.fixed=[{position_m: [1.01, 8.7, 1.5]}]", NULL};
    made m = explore_with(CORRIDOR, list, 2);
    const murk_explore *e = &m.plan.explore;
    CHECK_TEXT(m.err.text, "");
    CHECK(e->fixed == 1 && e->steps > 1);
    if (e->steps > 1) {
        CHECK(e->step[0].path_m == 0 && e->step[0].places_seen == 12);
        CHECK(e->step[e->steps - 1].places_seen == SITES);
    }
    for (size_t k = 1; k < e->steps; ++k) {
        CHECK(station(&m, k).y <= 5);
    }
    unmake(&m);
    /* A path that begins at the fixed sensor stays behind the pane. */
    const char *const from_it[] = {
        "geometry=[" WALLS PANE "]",
        "sensors.fixed=[{position_m: [1.01, 8.7, 1.5]}]",
        "placement={hold_out: false, knowledge: explore}", NULL};
    m = explore_with(CORRIDOR, from_it, 2);
    CHECK_TEXT(m.err.text, "");
    CHECK(m.plan.explore.stops > 0 && is_at(m.plan.explore.stop[0], 1.01, 8.7));
    for (size_t k = 1; k < m.plan.explore.steps; ++k) {
        CHECK(station(&m, k).y > 5.5);
    }
    unmake(&m);
}

/* Nodes see more than the cameras that are asked for: a path that begins with
 * one covers more than any plan of so few that must have two cameras. */
static void test_bounds_hold_before_min_counts_are_met(void)
{
    const char *const list[] = {
        "sensors={types: [{name: node, range_m: 6}, {name: camera, range_m: 3, "
        "least_count: 2, view: {cone_deg: 60}}], count: 3, " SITED "}",
        NULL};
    made m = explore_with(CORRIDOR, list, 2);
    const murk_place_result *place = &m.plan.place;
    CHECK_TEXT(m.err.text, "");
    CHECK(place->count == 3 && place->curve_points == 3);
    for (size_t k = 0; k < place->curve_points; ++k) {
        const murk_curve_point *point = &place->curve[k];
        CHECK(point->count == k + 1);
        CHECK(point->value == m.plan.explore.step[k].value);
        CHECK(point->upper >= point->value);
    }
    CHECK(place->upper >= place->value);
    CHECK(place->curve_points == 0 ||
          place->curve[place->curve_points - 1].upper == place->upper);
    unmake(&m);
}

int main(void)
{
    test_targets_end_it();
    test_budgets_go_by_cost();
    test_constraints_are_met();
    test_fixed_sensors_see_but_do_not_walk();
    test_bounds_hold_before_min_counts_are_met();
    return check_done();
}
