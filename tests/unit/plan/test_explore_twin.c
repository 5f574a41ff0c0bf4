/* Exploring goes as its plain twin does: rooms with random crates, two types of
 * sensors, with a fixed sensor or without. The twin weighs every pose anew at
 * each step, tests segments against the crates by hand, and finds paths by
 * trying all steps. Seeds are fixed: nothing here is random. */
#include "base/rng.h"
#include "check.h"
#include "chosen.h"
#include "stage_text.h"

#include <stdlib.h>

#define CRATES 5
#define CASES  16
#define STEPS  7
#define MAX    200 /* places */

typedef struct floor_plan {
    murk_box crate[CRATES];
    murk_vec3 start, fixed;
    bool has_fixed;
    char text[4096];
} floor_plan;

static double between(const murk_random4 *r, int k, double a, double b)
{
    return a + (b - a) * r->u[k];
}

/* Crates are 2.3 m high, so that all air above them can be reached. In two
 * of four rooms only the first crate reflects, so that most poses gain
 * nothing. */
static floor_plan make_floor_plan(uint32_t seed)
{
    floor_plan m = {.has_fixed = seed % 2 == 0};
    /* Walls, lights and materials. */
    int at = snprintf(
        m.text, sizeof m.text,
        "murk: 1\n"
        "domain: {min_m: [-0.1, -0.1, -0.1], max_m: [8.1, 6.1, "
        "3.1]}\n"
        "lights: [{type: point, position_m: [2, 2, 2.9], "
        "power_w: 1}, {type: point, position_m: [6, 4, 2.9], "
        "power_w: 1}]\n"
        "photons: {emit: 400}\n"
        "materials: {lit: {diffuse: 0.5}, other: {diffuse: %g}}\n"
        "geometry:\n"
        "  - {box: {min_m: [0, 0, 0], max_m: [8, 6, 3]}, material: other}\n",
        seed % 4 < 2 ? 0.5 : 0.0);
    /* Random crates, of which the first always reflects. */
    for (int k = 0; k < CRATES; ++k) {
        const murk_random4 r = murk_random(seed, MURK_EMIT, (uint64_t)k, 0, 0);
        const double x = between(&r, 0, 0, 6.5), y = between(&r, 1, 0, 4.5);
        m.crate[k] =
            (murk_box){.min = {x, y, -0.05},
                       .max = {fmin(8.05, x + between(&r, 2, 0.3, 2.4)),
                               fmin(6.05, y + between(&r, 3, 0.3, 2.4)), 2.3}};
        const murk_box *c = &m.crate[k];
        at += snprintf(m.text + at, sizeof m.text - (size_t)at,
                       "  - {box: {min_m: [%.17g, %.17g, %.17g], max_m: "
                       "[%.17g, %.17g, %.17g]}, material: %s}\n",
                       c->min.x, c->min.y, c->min.z, c->max.x, c->max.y,
                       c->max.z, k == 0 ? "lit" : "other");
    }
    /* Random positions of the start and of the fixed sensor. */
    const murk_random4 r = murk_random(seed, MURK_EMIT, CRATES, 0, 0);
    m.start = murk_vec(between(&r, 0, 0.5, 7.5), between(&r, 1, 0.5, 5.5), 2.8);
    m.fixed = murk_vec(between(&r, 2, 0.5, 7.5), between(&r, 3, 0.5, 5.5), 2.6);
    /* Sensor types and candidates, every second time with the fixed sensor. */
    at += snprintf(
        m.text + at, sizeof m.text - (size_t)at,
        "sensors:\n"
        "  types:\n"
        "    - {name: node, range_m: 1.9}\n"
        "    - {name: cam, range_m: 4, least_range_m: 0.3, view: {hfov_deg: "
        "70, vfov_deg: 60}, headings: 3, tilts_deg: [-25]}\n"
        "  candidates: {grid: {min_m: [0.4, 0.4, 0.5], max_m: [7.6, 5.6, 2.6], "
        "size: [8, 6, 3]}, clearance_m: 0.01}\n"
        "  count: %d\n",
        STEPS);
    if (m.has_fixed) {
        at += snprintf(m.text + at, sizeof m.text - (size_t)at,
                       "  fixed: [{type: node, position_m: [%.17g, %.17g, "
                       "%.17g]}]\n",
                       m.fixed.x, m.fixed.y, m.fixed.z);
    }
    snprintf(m.text + at, sizeof m.text - (size_t)at,
             "placement: {hold_out: false, knowledge: explore, start_m: "
             "[%.17g, %.17g, %.17g]}\n",
             m.start.x, m.start.y, m.start.z);
    return m;
}

/* ---- the twin ---- */

typedef struct twin {
    const floor_plan *floor_plan;
    const murk_plan_result *plan;
    murk_sight *sight;
    size_t places, sites;
    murk_vec3 place[MAX];
    bool is_seen[MAX], is_linked[MAX][MAX], is_joined[MAX];
    uint16_t *best; /* [photons] */
    bool *stands;   /* [poses] */
} twin;

static bool is_open(const twin *t, murk_vec3 a, murk_vec3 b)
{
    for (int k = 0; k < CRATES; ++k) {
        double first = 0, last = 1;
        const murk_vec3 offset = murk_sub(b, a);
        const murk_box *c = &t->floor_plan->crate[k];
        const double from[3] = {a.x, a.y, a.z},
                     to[3] = {offset.x, offset.y, offset.z};
        const double min[3] = {c->min.x, c->min.y, c->min.z},
                     max[3] = {c->max.x, c->max.y, c->max.z};
        /* The part of the segment inside the crate, as fractions. */
        for (int i = 0; i < 3; ++i) {
            const double p = (min[i] - from[i]) / to[i],
                         q = (max[i] - from[i]) / to[i];
            if (to[i] == 0) {
                last = from[i] > min[i] && from[i] < max[i] ? last : -1;
                continue;
            }
            first = fmax(first, fmin(p, q));
            last = fmin(last, fmax(p, q));
        }
        if (first < last) {
            return false;
        }
    }
    return true;
}

static bool sees(const twin *t, const murk_pose *pose, murk_vec3 place)
{
    const murk_sight_desc *sight = murk_sight_described(t->sight);
    const murk_sensor_type *type = &sight->type[pose->type];
    const murk_field field = murk_field_of(type, pose, sight->north);
    const murk_vec3 offset = murk_sub(place, pose->position);
    const double distance_m = murk_length(offset);
    return distance_m == 0 || (distance_m <= type->range_m &&
                               murk_field_contains(&field, offset) &&
                               is_open(t, pose->position, place));
}

/* All that links lead to from the start. */
static void join(twin *t)
{
    memset(t->is_joined, 0, sizeof t->is_joined);
    t->is_joined[t->plan->start] = true;
    for (size_t round = 0; round < t->places; ++round) {
        for (size_t a = 0; a < t->places; ++a) {
            for (size_t b = 0; b < t->places; ++b) {
                if (t->is_linked[a][b] &&
                    (t->is_joined[a] || t->is_joined[b])) {
                    t->is_joined[a] = t->is_joined[b] = true;
                }
            }
        }
    }
}

static uint64_t gain_of(const twin *t, size_t j)
{
    murk_sparse_row row;
    murk_sight_row(t->sight, 0, &t->plan->poses->pose[j], &row);
    const uint32_t *weight = murk_sight_weights(t->sight);
    uint64_t gain = 0;
    for (size_t k = 0; k < row.seen; ++k) {
        gain += (uint64_t)weight[row.photon[k]] *
                (uint64_t)(MURK_CLEAR - t->best[row.photon[k]]);
    }
    CHECK(row.clarity == NULL); /* clear air */
    return gain;
}

static size_t opens_of(const twin *t, size_t j)
{
    size_t n = 0;
    for (size_t k = 0; k < t->sites; ++k) {
        n += !(t->is_seen[k] && t->is_joined[k]) &&
             sees(t, &t->plan->poses->pose[j], t->place[k]);
    }
    return n;
}

static void stand(twin *t, size_t j)
{
    const murk_poses *poses = t->plan->poses;
    const size_t here = poses->site[j];
    murk_sparse_row row;
    murk_sight_row(t->sight, 0, &poses->pose[j], &row);
    for (size_t k = 0; k < row.seen; ++k) {
        t->best[row.photon[k]] = MURK_CLEAR;
    }
    t->stands[j] = true;
    t->is_seen[here] = true;
    for (size_t k = 0; k < t->places; ++k) {
        if (sees(t, &poses->pose[j], t->place[k])) {
            t->is_seen[k] = true;
            t->is_linked[here][k] = true;
        }
    }
    join(t);
}

/* Finds the next pose; returns false if no pose gains or opens anything. */
static bool next_of(const twin *t, bool is_first, size_t *next)
{
    /* First the largest gain; if no pose gains, the most places that a pose
     * would open. */
    const murk_poses *poses = t->plan->poses;
    uint64_t max_gain = 0;
    size_t max_opened = 0;
    bool has_any = false;
    for (int by_gain = 1; by_gain >= 0 && !has_any; --by_gain) {
        for (size_t j = 0; j < poses->count - poses->fixed; ++j) {
            /* The first pose stands at the start, later ones at seen places
             * that can be reached. */
            const size_t place = poses->site[j];
            if (t->stands[j] ||
                (is_first ? place != t->plan->start
                          : !t->is_seen[place] || !t->is_joined[place])) {
                continue;
            }
            const uint64_t gain = by_gain ? gain_of(t, j) : 0;
            const size_t opened = by_gain ? 0 : opens_of(t, j);
            /* The lowest number wins a tie. */
            if (gain > max_gain || opened > max_opened) {
                max_gain = gain;
                max_opened = opened;
                *next = j;
                has_any = true;
            }
        }
    }
    return has_any;
}

/* The length of the shortest path over seen places, by the algorithm of
 * Bellman and Ford. */
static double path_length(const twin *t, size_t from, size_t to)
{
    /* Distances from the place `from`, and pairs of seen places in straight
     * reach. */
    static double gone[MAX];
    static bool open[MAX][MAX];
    for (size_t a = 0; a < t->places; ++a) {
        gone[a] = a == from ? 0 : INFINITY;
        for (size_t b = 0; b < a; ++b) {
            open[a][b] = open[b][a] = t->is_seen[a] && t->is_seen[b] &&
                                      is_open(t, t->place[a], t->place[b]);
        }
    }
    /* Shorten distances by all steps until none becomes shorter. */
    for (bool is_better = true; is_better;) {
        is_better = false;
        for (size_t a = 0; a < t->places; ++a) {
            for (size_t b = 0; b < t->places; ++b) {
                const double distance =
                    gone[a] + murk_length(murk_sub(t->place[a], t->place[b]));
                if (a != b && open[a][b] && distance < gone[b] - 1e-12) {
                    gone[b] = distance;
                    is_better = true;
                }
            }
        }
    }
    return gone[to];
}

static void check_against_twin(twin *t, size_t *opened)
{
    const murk_poses *poses = t->plan->poses;
    const murk_explore *e = &t->plan->explore;
    double path_m = 0;
    size_t here = t->plan->start, next = 0;
    for (size_t k = 0; k < poses->fixed; ++k) {
        CHECK(e->step[k].candidate == poses->count - poses->fixed + k);
        stand(t, poses->count - poses->fixed + k);
    }
    for (size_t k = poses->fixed; k < e->steps; ++k) {
        const bool has_next = next_of(t, k == poses->fixed, &next);
        CHECK(has_next || k == poses->fixed);
        next =
            has_next ? next : e->step[k].candidate; /* nothing at the start */
        CHECK(e->step[k].candidate == next);
        CHECK(e->step[k].gain == gain_of(t, next));
        *opened += e->step[k].gain == 0;
        path_m += path_length(t, here, poses->site[next]);
        here = poses->site[next];
        CHECK_NEAR(e->step[k].path_m, path_m, 1e-9);
        stand(t, next);
        size_t seen = 0;
        for (size_t s = 0; s < t->sites; ++s) {
            seen += t->is_seen[s];
        }
        CHECK(e->step[k].places_seen == seen);
    }
    CHECK(e->steps == STEPS || !next_of(t, false, &next));
    CHECK((e->end == MURK_EXPLORE_COUNT) == (e->steps == STEPS));
}

static void check_floor_plan(uint32_t seed, size_t *steps, size_t *opened)
{
    const floor_plan m = make_floor_plan(seed);
    murk_stage *stage = stage_text_create(m.text, NULL);
    murk_traced *traced = NULL;
    murk_plan_result plan = {0};
    murk_error err = {0};
    static twin t;
    t = (twin){.floor_plan = &m, .plan = &plan};
    const bool is_made = stage && !murk_plan_prepare(&plan, stage, 2, &err) &&
                         !murk_lightmap_trace(&traced, stage, 0, 2, &err) &&
                         !choose_sensors(&plan, stage, traced, 2, &err) &&
                         !murk_plan_sight(&t.sight, stage, traced, 1, &err);
    /* the lit crate may stand within another */
    CHECK(is_made || strstr(err.text, "nothing to see"));
    if (t.sight) {
        t.sites = plan.candidates->usable;
        t.places = t.sites + plan.poses->fixed;
        CHECK(t.places < MAX);
        memcpy(t.place, plan.candidates->position, t.sites * sizeof *t.place);
        t.place[t.sites] = m.fixed;
        t.best = calloc(murk_sight_photons(t.sight), sizeof *t.best);
        t.stands = calloc(plan.poses->count, sizeof *t.stands);
        check_against_twin(&t, opened);
        *steps += plan.explore.steps;
    }
    free(t.best);
    free(t.stands);
    murk_sight_destroy(t.sight);
    murk_plan_result_release(&plan);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
}

int main(void)
{
    size_t steps = 0, opened = 0;
    for (uint32_t seed = 1; seed <= CASES; ++seed) {
        check_floor_plan(seed, &steps, &opened);
    }
    CHECK(steps > 5 * CASES && opened > CASES / 4); /* or little was compared */
    printf("%zu steps compared, %zu of them to see further\n", steps, opened);
    return check_done();
}
