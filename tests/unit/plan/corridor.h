/* A corridor with a corner, explored: for the tests of plan/explore.h. */
#ifndef MURK_TESTS_CORRIDOR_H
#define MURK_TESTS_CORRIDOR_H

#include "check.h"
#include "chosen.h"
#include "stage_text.h"

/* A corridor 2 m wide: 10 m along y, then round the corner 8 m along x. Sites a
 * metre apart in its middle: (1, 1..9) and (2..9, 9), all at 1.5 m. */
#define WALLS                                                         \
    "{box: {min_m: [0, 0, 0], max_m: [10, 10, 3]}, material: wall}, " \
    "{box: {min_m: [2, -0.05, -0.05], max_m: [10.05, 8, 3.05]}, "     \
    "material: wall}"
/* Across the first leg, behind (1, 5). */
#define PANE                                                          \
    ", {rect: {corner_m: [-0.05, 5.5, -0.05], edge1_m: [2.1, 0, 0], " \
    "edge2_m: [0, 0, 3.1]}, material: glass}"
#define SITED                                                                \
    "candidates: {grid: {min_m: [1, 1, 1.5], max_m: [9, 9, 1.5], size: [9, " \
    "9, 1]}}"
#define CORRIDOR                                                           \
    "murk: 1\n"                                                            \
    "domain: {min_m: [-0.1, -0.1, -0.1], max_m: [10.1, 10.1, 3.1]}\n"      \
    "geometry: [" WALLS "]\n"                                              \
    "materials: {wall: {diffuse: 0.5}, lit: {diffuse: 0.5}, glass: "       \
    "{transmit: 0.9}}\n"                                                   \
    "lights: [{type: point, position_m: [1, 1, 2.5], power_w: 1}, {type: " \
    "point, position_m: [9, 9, 2.5], power_w: 1}]\n"                       \
    "photons: {emit: 2000}\n"                                              \
    "sensors: {types: [{name: node, range_m: 30}], count: 8, " SITED "}\n" \
    "placement: {hold_out: false, knowledge: explore, start_m: [1, 1.2, "  \
    "1]}\n"
#define SITES 17

/* How far nodes see, where they are to walk. */
#define NEAR "sensors.types.0.range_m=3.5"

typedef struct made {
    murk_stage *stage;
    murk_plan_result plan;
    murk_status status;
    murk_error err;
} made;

static inline made explore_with(const char *text, const char *const *overrides,
                                unsigned threads)
{
    made m = {.stage = stage_text_create(text, overrides)};
    murk_traced *traced = NULL;
    CHECK(m.stage != NULL);
    if (!m.stage) {
        m.status = MURK_BAD_VALUE;
        return m;
    }
    m.status = murk_plan_prepare(&m.plan, m.stage, threads, &m.err);
    if (!m.status) {
        m.status = murk_lightmap_trace(&traced, m.stage, 0, threads, &m.err);
    }
    if (!m.status) {
        m.status = choose_sensors(&m.plan, m.stage, traced, threads, &m.err);
    }
    murk_traced_destroy(traced);
    return m;
}

static inline made explore(const char *override)
{
    const char *const list[] = {override, NULL};
    return explore_with(CORRIDOR, list, 2);
}

static inline void unmake(made *m)
{
    murk_plan_result_release(&m->plan);
    stage_text_destroy(m->stage);
}

static inline murk_vec3 station(const made *m, size_t step)
{
    return m->plan.poses->pose[m->plan.explore.step[step].candidate].position;
}

static inline bool is_at(murk_vec3 p, double x, double y)
{
    return fabs(p.x - x) < 1e-9 && fabs(p.y - y) < 1e-9;
}

#endif
