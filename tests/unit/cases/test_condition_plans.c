/* Plans over conditions, from the scene's text to the regret table, against
 * brute force over all pairs of candidates. The seeds are fixed: nothing here
 * is random. */
#include "cases/condition_plans.h"
#include "check.h"
#include "stage_text.h"

#include <stdlib.h>

#define SCENE                                                                 \
    "murk: 1\n"                                                               \
    "domain: {min_m: [0, 0, 0], max_m: [6, 4, 3]}\n"                          \
    "geometry: [{box: {min_m: [0.1, 0.1, 0.1], max_m: [5.9, 3.9, 2.9]}}]\n"   \
    "media: {air: {extinction_per_m: 0, albedo: 0.9}}\n"                      \
    "regions: [{medium: air, box: {min_m: [0, 0, 0], max_m: [6, 4, 1.5]}}]\n" \
    "lights:\n"                                                               \
    "  - {type: point, position_m: [1, 1, 2.5], power_w: 8}\n"                \
    "  - {type: point, position_m: [5, 3, 0.5], power_w: 2}\n"                \
    "photons: {emit: 250}\n"                                                  \
    "sensors: {types: [{name: node, range_m: 2.5}], count: 2, candidates: "   \
    "{grid: {min_m: [1, 1, 0.6], max_m: [5, 3, 2.4], size: [3, 2, 2]}}}\n"

#define THREE                                                           \
    "conditions: {clear: {}, fog: {media.air.extinction_per_m: 1.2},\n" \
    "  dark: {lights.0.power_w: 0.01, media.air.extinction_per_m: 0.5}}\n"

typedef struct made {
    murk_stage *stage; /* of the scene as it stands; holds the scene */
    murk_plan_result plan;
    murk_condition_plans over;
    murk_error err;
    murk_status status;
} made;

static void make(made *out, const char *text, const char *over,
                 unsigned threads)
{
    const char *const overrides[] = {over, NULL};
    *out = (made){.stage = stage_text_create(text, overrides)};
    CHECK(out->stage != NULL);
    if (!out->stage) {
        exit(check_done());
    }
    out->status = murk_condition_plans_prepare(
        &out->over, &out->plan, out->stage->scene, threads, &out->err);
    if (!out->status) {
        out->status = murk_condition_plans_make(&out->over, &out->plan, threads,
                                                &out->err);
    }
}

static void unmake(made *m)
{
    murk_condition_plans_release(&m->over);
    murk_plan_result_release(&m->plan);
    stage_text_destroy(m->stage);
}

static void must_make(made *out, const char *text, const char *over,
                      unsigned threads)
{
    make(out, text, over, threads);
    CHECK(out->status == MURK_OK);
    CHECK_TEXT(out->err.text, "");
    if (out->status) {
        exit(check_done());
    }
}

/* Coverage of a pair of candidates in one condition. */
static double see(const made *m, size_t c, size_t i, size_t j)
{
    const murk_pose pair[] = {m->plan.poses->pose[i], m->plan.poses->pose[j]};
    murk_coverage_result coverage = {0};
    murk_error err = {0};
    CHECK(murk_coverage_result_measure(&coverage,
                                       m->over.conditions->condition[c].sight,
                                       pair, 2, &err) == MURK_OK);
    const double total = coverage.total.value;
    murk_coverage_result_release(&coverage);
    return total;
}

typedef struct optima {
    double mean, worst, own[3];
} optima;

/* The best of all pairs, with weights of the mean. */
static optima try_all(const made *m, const double *weight)
{
    optima best = {0};
    for (size_t i = 0; i < m->plan.poses->count; ++i) {
        for (size_t j = 0; j < i; ++j) {
            double mean = 0, min = 1, all = 0;
            for (size_t c = 0; c < 3; ++c) {
                const double share = see(m, c, i, j);
                best.own[c] = fmax(best.own[c], share);
                mean += weight[c] * share;
                all += weight[c];
                min = weight[c] > 0 ? fmin(min, share) : min;
            }
            best.mean = fmax(best.mean, mean / all);
            best.worst = fmax(best.worst, min);
        }
    }
    return best;
}

/* Weights are whole numbers, rounded by less than 2^-20 of a photon. */
#define ROUNDING 0x1p-19

static void check_against_all(const char *text, const double *weight)
{
    made mean, worst;
    must_make(&mean, text, "placement.over=mean", 2);
    must_make(&worst, text, "placement.over=worst", 2);
    const optima best = try_all(&mean, weight);
    CHECK(mean.plan.place.proven_optimal && worst.plan.place.proven_optimal);
    CHECK_NEAR(mean.plan.in_sample.total.value, best.mean, ROUNDING);
    CHECK_NEAR(worst.plan.in_sample.total.value, best.worst, ROUNDING);
    CHECK_NEAR((double)mean.plan.place.value / (double)mean.plan.place.whole,
               best.mean, ROUNDING);
    CHECK_NEAR((double)worst.plan.place.value / (double)worst.plan.place.whole,
               best.worst, ROUNDING);
    CHECK(best.worst <
          best.mean - 0.01); /* or they are told apart by nothing */
    /* both runs make all plans, and their own is the same */
    CHECK(mean.over.plans == 5 && worst.over.plans == 5);
    CHECK_TEXT(mean.over.plan[mean.over.chosen].made_for, "mean");
    CHECK_TEXT(worst.over.plan[worst.over.chosen].made_for, "worst");
    for (size_t c = 0; c < 3; ++c) {
        CHECK_NEAR(mean.over.plan[c].in_sample[c].value, best.own[c], ROUNDING);
        CHECK(murk_condition_plans_regret(&mean.over, &mean.over.plan[c], c) ==
              0);
        CHECK(mean.over.plan[4].in_sample[c].value ==
              worst.over.plan[4].in_sample[c].value);
        CHECK(mean.over.plan[3].held_out[c].value ==
              worst.over.plan[3].held_out[c].value);
    }
    unmake(&mean);
    unmake(&worst);
}

static void test_mean_and_worst_are_the_best_of_all(void)
{
    const double equal[] = {1, 1, 1}, weights[] = {1, 3, 0.5},
                 two[] = {1, 1, 0};
    check_against_all(SCENE THREE, equal);
    check_against_all(SCENE THREE
                      "placement: {condition_weights: {fog: 3, dark: .5}}\n",
                      weights);
    check_against_all(SCENE THREE "placement: {condition_weights: {dark: 0}}\n",
                      two);
}

/* The plan of the least largest regret, against all pairs: regret to each
 * condition's own best pair, which the search proves. */
static void test_regret_is_the_min_of_all(bool is_relative)
{
    made m;
    must_make(&m, SCENE THREE "placement: {over: regret}\n",
              is_relative ? "placement.regret=relative"
                          : "placement.regret=absolute",
              2);
    const double equal[] = {1, 1, 1};
    const optima best = try_all(&m, equal);
    double min = 2, of_worst = 0, own = 0;
    const size_t n = m.plan.poses->count;
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < i; ++j) {
            double largest = -1;
            for (size_t c = 0; c < 3; ++c) {
                const double lack = best.own[c] - see(&m, c, i, j);
                largest =
                    fmax(largest, is_relative ? lack / best.own[c] : lack);
            }
            min = fmin(min, largest);
        }
    }
    const murk_condition_plan *chosen = &m.over.plan[m.over.chosen];
    const murk_condition_plan *worst = &m.over.plan[m.over.chosen - 1];
    CHECK_TEXT(chosen->made_for, "regret");
    CHECK_TEXT(worst->made_for, "worst");
    for (size_t c = 0; c < 3; ++c) {
        const double unit = is_relative ? best.own[c] : 1;
        const murk_condition *one = &m.over.conditions->condition[c];
        CHECK_NEAR(one->best_known, best.own[c], ROUNDING);
        CHECK(one->best_upper >= one->best_known);
        own = fmax(own, (best.own[c] - chosen->in_sample[c].value) / unit);
        of_worst =
            fmax(of_worst, (best.own[c] - worst->in_sample[c].value) / unit);
    }
    CHECK_NEAR(own, min, ROUNDING);
    CHECK_NEAR(m.over.regret, min, ROUNDING);
    CHECK(m.plan.place.proven_optimal);
    CHECK_NEAR(m.over.regret_lower, min, ROUNDING);
    CHECK(m.over.regret_upper >= m.over.regret);
    CHECK_NEAR(m.over.regret_upper, min, ROUNDING); /* all are proven */
    CHECK(min <= of_worst);
    printf("largest regret %.4f, of the plan for the worst %.4f\n", min,
           of_worst);
    /* coverage is that of the condition where the regret is largest */
    size_t at;
    const murk_estimate seen =
        murk_conditions_estimate(m.over.conditions, chosen->in_sample,
                                 MURK_SCENE_OBJECTIVE_REGRET, false, &at);
    CHECK(m.plan.in_sample.total.value == seen.value);
    CHECK_NEAR((best.own[at] - seen.value) / (is_relative ? best.own[at] : 1),
               min, ROUNDING);
    CHECK(m.plan.place.ceiling >= m.plan.place.upper);
    /* and held out it is of the same condition */
    CHECK(m.plan.held_out.value == chosen->held_out[at].value);
    unmake(&m);
}

/* A plan over one condition that changes nothing equals the plan of the
 * plain scene to the bit, including the estimate with held-out light. */
static void test_one_condition_is_the_plain_plan(void)
{
    static const char *const overs[] = {"placement.over=mean",
                                        "placement.over=worst"};
    for (int k = 0; k < 2; ++k) {
        /* A plan over one condition, and a plan of the stage of the same
         * condition. */
        made one;
        murk_plan_result plain = {0};
        murk_traced *traced = NULL;
        murk_error err = {0};
        must_make(&one, SCENE "conditions: {as_is: {}}\n", overs[k], 2);
        const murk_stage *stage = one.over.conditions->condition[0].stage;
        CHECK(!murk_plan_prepare(&plain, stage, 2, &err) &&
              !murk_lightmap_trace(&traced, stage, 0, 2, &err) &&
              !murk_plan_for_scene(&plain, stage, traced, 2, &err));
        CHECK_TEXT(err.text, "");
        /* Sensors and coverage are equal to the bit. */
        CHECK(plain.place.count == one.plan.place.count);
        for (size_t i = 0; i < plain.place.count; ++i) {
            CHECK(plain.place.sensor[i] == one.plan.place.sensor[i]);
            CHECK(plain.in_sample.covers[i] == one.plan.in_sample.covers[i]);
        }
        /* So are the estimates with the light of the plan and with held-out
         * light. */
        CHECK(plain.in_sample.total.value == one.plan.in_sample.total.value);
        CHECK(plain.in_sample.total.standard_error ==
              one.plan.in_sample.total.standard_error);
        CHECK(plain.held_out.value == one.plan.held_out.value);
        CHECK(plain.held_out.standard_error ==
              one.plan.held_out.standard_error);
        murk_plan_result_release(&plain);
        murk_traced_destroy(traced);
        unmake(&one);
    }
}

/* Held-out maps of different conditions share no random numbers, though their
 * light is the same; and the same light is traced once. */
static void test_light_alike_is_shared(void)
{
    made m;
    must_make(&m, SCENE "conditions: {a: {}, b: {}}\n", "placement.over=mean",
              2);
    const murk_condition *c = m.over.conditions->condition;
    CHECK(c[1].borrows_light && c[1].traced == c[0].traced);
    const murk_condition_plan *chosen = &m.over.plan[m.over.chosen];
    CHECK(chosen->in_sample[0].value == chosen->in_sample[1].value);
    CHECK(chosen->held_out[0].value != chosen->held_out[1].value);
    CHECK_NEAR(m.plan.held_out.value,
               (chosen->held_out[0].value + chosen->held_out[1].value) / 2,
               1e-15);
    CHECK_NEAR(m.plan.held_out.standard_error,
               hypot(chosen->held_out[0].standard_error,
                     chosen->held_out[1].standard_error) /
                   2,
               1e-15);
    unmake(&m);
}

/* A crate stands where candidates of the clear room stood. */
static void test_candidates_are_usable_in_all(void)
{
    made m;
    must_make(&m,
              SCENE
              "conditions: {empty: {}, full: {geometry: [\n"
              "  {box: {min_m: [0.1, 0.1, 0.1], max_m: [5.9, 3.9, 2.9]}},\n"
              "  {box: {min_m: [2, 0.5, 0.3], max_m: [4, 1.5, 1.5]}}]}}\n",
              "placement.over=worst", 2);
    CHECK(m.plan.candidates->asked == 12 && m.plan.candidates->usable == 11);
    for (size_t i = 0; i < 11; ++i) {
        const murk_vec3 p = m.plan.candidates->position[i];
        CHECK(!(p.x == 3 && p.y == 1 && p.z == 0.6));
    }
    unmake(&m);
}

static void test_target_in_every_condition(void)
{
    made m;
    must_make(&m, SCENE THREE "placement: {over: worst}\n",
              "sensors.target=0.3", 2);
    CHECK(m.plan.place.count == m.plan.place.fewest);
    CHECK(m.plan.in_sample.total.value >= 0.3);
    CHECK(m.plan.confirmed.value > 0 && m.plan.confirmed.standard_error > 0);
    CHECK(m.plan.confirmed.value != m.plan.held_out.value);
    CHECK(m.over.plan[0].count == m.plan.place.count); /* to compare */
    unmake(&m);
}

/* The mean needs no matrix; the worst does. */
static void test_unknown_environment(void)
{
    made known, unknown;
    must_make(&known, SCENE THREE "placement: {nodes: 0}\n",
              "placement.over=mean", 2);
    must_make(&unknown,
              SCENE THREE "placement: {nodes: 0, knowledge: unknown}\n",
              "placement.over=mean", 2);
    CHECK(unknown.over.plans == 4);
    CHECK(known.plan.in_sample.total.value ==
          unknown.plan.in_sample.total.value);
    unmake(&known);
    unmake(&unknown);
    make(&unknown, SCENE THREE "placement: {knowledge: unknown}\n",
         "placement.over=worst", 2);
    CHECK(unknown.status == MURK_BAD_VALUE);
    CHECK_TEXT(unknown.err.text, "over: worst needs what every candidate sees, "
                                 "so knowledge must be known");
    unmake(&unknown);
}

static void test_refusals(void)
{
    made m;
    make(&m, SCENE THREE "placement: {over: regret}\n", "sensors.target=.5", 1);
    CHECK(m.status == MURK_BAD_VALUE);
    CHECK_MENTIONS(m.err.text,
                   "over: regret compares plans of as many sensors");
    unmake(&m);
    make(&m, SCENE "conditions: {a: {}, b: {photons.maps: none}}\n",
         "placement.over=mean", 1);
    CHECK(m.status == MURK_BAD_VALUE);
    CHECK_MENTIONS(m.err.where, "conditions.b.photons");
    CHECK_TEXT(m.err.text, "maps: none, but placing needs stored photons");
    unmake(&m);
    make(&m,
         SCENE "conditions: {a: {}, b: {geometry: [{box: {min_m: [0.2, 0.2, "
               "0.2], max_m: [5.8, 3.8, 2.8]}}], lights: [{type: point, "
               "position_m: [0.1, 0.1, 0.1], power_w: 1}]}}\n",
         "placement.over=mean", 1);
    CHECK(m.status == MURK_BAD_VALUE); /* all stand in a closed box */
    CHECK_MENTIONS(m.err.text, "usable");
    unmake(&m);
}

int main(void)
{
    test_mean_and_worst_are_the_best_of_all();
    test_regret_is_the_min_of_all(false);
    test_regret_is_the_min_of_all(true);
    test_one_condition_is_the_plain_plan();
    test_light_alike_is_shared();
    test_candidates_are_usable_in_all();
    test_target_in_every_condition();
    test_unknown_environment();
    test_refusals();
    return check_done();
}
