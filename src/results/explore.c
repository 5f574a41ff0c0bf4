/* The steps of an exploration: fields of JSON, columns of CSV, lines of the
 * summary, and path.ply: the stops of the path, and a thin three-sided tube
 * about each segment, because some viewers leave the edges of a PLY file out.
 */
#include "results/explore.h"

#include "results/coverage.h"
#include "results/mesh_file.h"
#include "results/summary.h"

#include <math.h>

#define DIGITS 9 /* of shares and lengths in explore.csv */

#define LINE_SIZE                                                   \
    0.001       /* radius of a tube, share of the domain's diagonal \
                 */
#define SIDES 3 /* of a tube */

static const char *const END_NAMES[] = {[MURK_EXPLORE_COUNT] = "count",
                                        [MURK_EXPLORE_TARGET] = "target",
                                        [MURK_EXPLORE_CONSTRAINTS] = "rules",
                                        [MURK_EXPLORE_NOTHING] =
                                            "nothing_to_gain",
                                        [MURK_EXPLORE_STATIONS] = "stations"};

/* The number of the sensor of a step among the sensors of the plan, from 1. The
 * plan lists them by rising candidate. */
static size_t sensor_of(const murk_plan_result *plan,
                        const murk_explore_step *step)
{
    size_t k = 0;
    while (k + 1 < plan->place.count &&
           plan->place.sensor[k + 1] <= step->candidate) {
        ++k;
    }
    return k + 1;
}

static double coverage_of(const murk_plan_result *plan, uint64_t value)
{
    return murk_share(value, plan->place.whole);
}

/* The state at the end; zeros if there are no steps. */
static murk_explore_step end_of(const murk_explore *explore)
{
    return explore->steps ? explore->step[explore->steps - 1]
                          : (murk_explore_step){0};
}

typedef struct explored {
    const murk_plan_result *plan;
    const murk_scene_desc *scene;
} explored;

/* steps[] of plan.json, and explore.csv. */
void murk_results_list_step(murk_results_fields *f, const void *of, size_t i)
{
    const explored *e = of;
    const murk_explore_step *step = e ? &e->plan->explore.step[i] : NULL;
    const murk_posed p =
        e ? (murk_posed){e->scene, &e->plan->poses->pose[step->candidate]}
          : (murk_posed){NULL, NULL};
    /* CSV and JSON have these columns in different order. */
    if (murk_results_is_csv(f)) {
        MURK_COUNT(f, "step", "number, from 1", i + 1);
        murk_results_list_position(f, p);
        murk_results_list_type(f, p);
        murk_results_list_heading(f, p);
    }
    MURK_COUNT(f, "sensor", "number among the plan's, from 1",
               sensor_of(e->plan, step));
    if (!murk_results_is_csv(f)) {
        murk_results_list_type(f, p);
        murk_results_list_position(f, p);
        murk_results_list_heading(f, p);
    }
    MURK_ROUNDED(f, "gain", "1", "coverage that the station adds",
                 coverage_of(e->plan, step->gain), DIGITS);
    MURK_ROUNDED(f, "coverage", "1", "coverage so far",
                 coverage_of(e->plan, step->value), DIGITS);
    MURK_ROUNDED(f, "path_m", "m", "length of the path so far", step->path_m,
                 DIGITS);
    MURK_COUNT(f, "places_seen", "candidates known so far", step->places_seen);
    MURK_COUNT(f, "queries", "queries of the maps so far", step->queries);
    MURK_COUNT(f, "shadow_rays", "sightlines followed so far",
               step->shadow_rays);
}

static void list_explore(murk_results_fields *f, const void *of)
{
    const explored *e = of;
    const murk_explore *explore = e ? &e->plan->explore : NULL;
    MURK_VECTOR(f, "start_m", "m", "the first station",
                explore->stops ? murk_scene_user(e->scene, explore->stop[0])
                               : murk_vec(NAN, NAN, NAN));
    MURK_NUMBER(f, "path_m", "m", "length of the path", end_of(explore).path_m);
    MURK_COUNT(f, "places", "candidates", explore->places);
    MURK_COUNT(f, "places_seen", "candidates that became known",
               end_of(explore).places_seen);
    MURK_COUNT(f, "ways_tried", "segments that were tried",
               explore->lines_tested);
    MURK_TEXT(f, "ended_by",
              "count, target, rules, nothing_to_gain or stations",
              END_NAMES[explore->end]);
    MURK_LIST(f, "steps", "the stations, in order", murk_results_list_step, e,
              explore->steps);
}

void murk_results_list_explore(murk_results_fields *f,
                               const murk_scene_desc *scene,
                               const murk_plan_result *plan)
{
    const explored e = {plan, scene};
    if (MURK_LISTED_IF(f, scene->placement.knowledge == MURK_SCENE_EXPLORE)) {
        MURK_OBJECT(f, "explore", "with knowledge: explore", list_explore, &e);
    }
}

/* ---- path.ply ---- */

typedef enum vertex_kind { STATION, PASSED, CORNER } vertex_kind;

typedef struct path {
    const murk_scene_desc *scene;
    const murk_explore *explore;
    size_t segments; /* between stops */
    double line_m;
} path;

static const murk_mesh_column columns[] = {
    MURK_MESH_COLOR,
    {"kind", MURK_MESH_UINT8, .components = 1},
    {"step", MURK_MESH_UINT16, .components = 1}};

/* The values of a vertex, in the order of the columns. */
typedef struct record {
    uint8_t color[3], kind;
    uint16_t step;
} record;

/* The step, from 0, on whose part of the path a stop lies. */
static size_t step_of(const murk_explore *explore, size_t stop)
{
    size_t k = 0;
    while (k + 1 < explore->steps && explore->step[k].stops <= stop) {
        ++k;
    }
    return k;
}

static void put_vertex(const murk_ply *ply, const path *p, murk_vec3 at,
                       vertex_kind kind, size_t stop)
{
    /* Green at the start, violet at the end. */
    static const double first[3] = {60, 175, 90}, last[3] = {150, 60, 200};
    const double share = p->segments ? (double)stop / (double)p->segments : 0;
    record r = {.kind = (uint8_t)kind,
                .step = (uint16_t)(step_of(p->explore, stop) + 1)};
    for (int c = 0; c < 3; ++c) {
        r.color[c] = (uint8_t)(first[c] + share * (last[c] - first[c]));
    }
    murk_mesh_put_vertex(ply, at, &r);
}

static void put_stops(const murk_ply *ply, const path *p)
{
    const murk_explore *explore = p->explore;
    for (size_t k = 0; k < explore->stops; ++k) {
        const bool is_station =
            explore->step[step_of(explore, k)].stops == k + 1;
        put_vertex(ply, p, explore->stop[k], is_station ? STATION : PASSED, k);
    }
}

/* The corners of each segment: around its beginning, then around its end. */
static void put_corners(const murk_ply *ply, const path *p)
{
    for (size_t i = 0; i < p->segments; ++i) {
        const murk_vec3 *end = &p->explore->stop[i];
        murk_vec3 side[2];
        murk_frame(murk_unit(murk_sub(end[1], end[0])), &side[0], &side[1]);
        for (size_t e = 0; e < 2; ++e) {
            for (int s = 0; s < SIDES; ++s) {
                const double angle = 2 * MURK_PI * s / SIDES;
                murk_vec3 at =
                    murk_along(end[e], p->line_m * cos(angle), side[0]);
                at = murk_along(at, p->line_m * sin(angle), side[1]);
                put_vertex(ply, p, at, CORNER, i + e);
            }
        }
    }
}

/* The sides of the tubes, two triangles each, wound so that normals point
 * out. */
static void put_faces(const murk_ply *ply, const path *p)
{
    for (size_t i = 0; i < p->segments; ++i) {
        const size_t near = p->explore->stops + 2 * SIDES * i;
        const size_t far = near + SIDES;
        for (size_t s = 0; s < SIDES; ++s) {
            const size_t next = (s + 1) % SIDES;
            murk_mesh_put_face(ply, near + s, near + next, far + next, NULL);
            murk_mesh_put_face(ply, near + s, far + next, far + s, NULL);
        }
    }
}

static murk_status write_path(FILE *to, const void *context, murk_error *err)
{
    const path *p = context;
    murk_ply ply =
        murk_mesh_begin(to, p->scene,
                        "comment murk path: stops, corners of the line between "
                        "them\n"
                        "comment kind: 0 station, 1 passed on the way, 2 "
                        "corner\n");
    murk_mesh_vertices(&ply, p->explore->stops + 2 * SIDES * p->segments,
                       columns, sizeof columns / sizeof *columns);
    murk_mesh_faces(&ply, 2 * SIDES * p->segments, NULL, 0);
    fprintf(to,
            "element edge %zu\nproperty int vertex1\nproperty int vertex2\n",
            p->segments);
    murk_mesh_end_header(&ply);
    put_stops(&ply, p);
    put_corners(&ply, p);
    put_faces(&ply, p);
    for (size_t i = 0; i < p->segments; ++i) {
        const uint32_t edge[2] = {(uint32_t)i, (uint32_t)(i + 1)};
        (void)fwrite(edge, sizeof edge, 1, to); /* failures show when the file
                                                   is committed */
    }
    (void)err;
    return MURK_OK;
}

murk_status murk_add_explore(murk_results *results, const murk_stage *stage,
                             const murk_plan_result *plan, murk_error *err)
{
    const murk_explore *explore = &plan->explore;
    /* A plan over conditions has no steps, and stage is NULL. */
    if (explore->steps == 0) {
        return MURK_OK;
    }
    const explored e = {plan, stage->scene};
    const murk_box *box = &stage->world.domain.box;
    const path p = {stage->scene, explore,
                    explore->stops > 0 ? explore->stops - 1 : 0,
                    LINE_SIZE * murk_length(murk_sub(box->max, box->min))};
    const murk_status status =
        murk_results_add_csv(results, "explore.csv", murk_results_list_step, &e,
                             explore->steps, err);
    return status ? status
                  : murk_results_add_stream(results, "path.ply", write_path, &p,
                                            err);
}

/* ---- the summary ---- */

void murk_print_explore(const murk_plan_result *plan, const char *folder)
{
    const murk_explore *explore = &plan->explore;
    if (explore->steps == 0) {
        return;
    }
    murk_print("explore     %.4g m gone; %zu of %zu places seen; ended by %s\n",
               end_of(explore).path_m, end_of(explore).places_seen,
               explore->places, END_NAMES[explore->end]);
    murk_print(
        "            step  sensor     gain  coverage    path m   places    "
        "queries\n");
    for (size_t k = 0; k < explore->steps && k < MURK_PRINTED_ROWS; ++k) {
        const murk_explore_step *step = &explore->step[k];
        murk_print("            %4zu  %6zu  %7.4f  %8.4f  %8.2f  %7zu  %9llu\n",
                   k + 1, sensor_of(plan, step), coverage_of(plan, step->gain),
                   coverage_of(plan, step->value), step->path_m,
                   step->places_seen, (unsigned long long)step->queries);
    }
    murk_print_more(explore->steps, folder, "explore.csv");
}
