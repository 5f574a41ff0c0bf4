/* Several scenarios as one placement problem: their photons side by side, in
 * blocks whose weights are scaled to the weights of the scenarios. Plans for
 * the mean are plans of that problem; plans for the worst scenario and for the
 * least regret compare its blocks (placement/worst.h). */
#include "cases/scenarios.h"

#include "base/progress.h"
#include "placement/worst.h"
#include "plan/plan.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The sum of all weights, times the number of sensors that count for one photon
 * (murk_problem_layers()), is less than WHOLE (placement/problem.h), and no
 * weight exceeds 32 bits. */
#define WHOLE      0x1p47
#define WEIGHT_MAX 4294967295.0

/* Memory in which one worker joins the rows of a candidate. */
typedef struct murk_scenarios_workspace {
    uint32_t *photon;  /* [photons] */
    uint16_t *clarity; /* [photons] */
} murk_scenarios_workspace;

static void append(murk_scenarios_workspace *workspace, size_t at, size_t first,
                   const murk_sparse_row *get_row)
{
    for (size_t k = 0; k < get_row->seen; ++k) {
        workspace->photon[at + k] = (uint32_t)(first + get_row->photon[k]);
        workspace->clarity[at + k] =
            get_row->clarity ? get_row->clarity[k] : MURK_CLEAR;
    }
}

/* Joins the rows of all parts; with need, the entries that are needed. No part
 * alone can give up the row. */
static void join_rows(const murk_scenarios *j, unsigned worker,
                      size_t candidate, const murk_row_need *need,
                      murk_sparse_row *out)
{
    murk_scenarios_workspace *workspace = &j->workspace[worker];
    bool is_clear = true;
    size_t seen = 0;
    for (size_t c = 0; c < j->blocks.n; ++c) {
        const murk_problem *part = &j->part[c].problem;
        murk_sparse_row one;
        if (need) {
            const murk_row_need own = {need->entry_max + j->blocks.first[c], 0};
            (void)part->get_part(part->context, worker, candidate, &own, &one);
        } else {
            part->get_row(part->context, worker, candidate, &one);
        }
        append(workspace, seen, j->blocks.first[c], &one);
        is_clear = is_clear && !one.clarity;
        seen += one.seen;
    }
    *out = (murk_sparse_row){seen, workspace->photon,
                             is_clear ? NULL : workspace->clarity};
}

static void get_row(void *context, unsigned worker, size_t candidate,
                    murk_sparse_row *out)
{
    join_rows(context, worker, candidate, NULL, out);
}

static bool get_part(void *context, unsigned worker, size_t candidate,
                     const murk_row_need *need, murk_sparse_row *out)
{
    join_rows(context, worker, candidate, need, out);
    return true;
}

static void list_counters(void *context, murk_counters *list)
{
    _Static_assert(MURK_SIGHT_COUNTERS * MURK_BLOCKS_MAX <= MURK_COUNTERS_MAX,
                   "a longer list");
    const murk_scenarios *j = context;
    for (size_t c = 0; c < j->blocks.n; ++c) {
        const murk_problem *part = &j->part[c].problem;
        part->list_counters(part->context, list);
    }
}

/* The largest sum of weights per unit of share at which the sum of all weights
 * and the largest single weight stay in range. whole[c] is the sum of the
 * unscaled weights of block c. */
static double scale_of(const murk_scenarios *j, const double *shares,
                       const double *whole)
{
    double all = 0, scale;
    for (size_t c = 0; c < j->blocks.n; ++c) {
        all += shares[c];
    }
    scale = (WHOLE / (double)murk_problem_layers(&j->problem) -
             (double)j->problem.photons) /
            all;
    for (size_t c = 0; c < j->blocks.n; ++c) {
        const uint32_t *weight = j->part[c].problem.weight;
        uint32_t max = 1;
        for (size_t i = 0; i < j->part[c].problem.photons; ++i) {
            max = weight[i] > max ? weight[i] : max;
        }
        scale = fmin(scale, WEIGHT_MAX / ((double)max * shares[c] / whole[c]));
    }
    return scale;
}

static void weigh(murk_scenarios *j, const double *shares)
{
    double whole[MURK_BLOCKS_MAX] = {0};
    for (size_t c = 0; c < j->blocks.n; ++c) {
        for (size_t i = 0; i < j->part[c].problem.photons; ++i) {
            whole[c] += j->part[c].problem.weight[i];
        }
    }
    if (j->blocks.n == 1) { /* the weights of the sight, without rounding */
        memcpy(j->weight, j->part[0].problem.weight,
               j->problem.photons * sizeof *j->weight);
        return;
    }
    const double scale = scale_of(j, shares, whole);
    for (size_t c = 0; c < j->blocks.n; ++c) {
        const double factor = scale * shares[c] / whole[c];
        for (size_t i = 0; i < j->part[c].problem.photons; ++i) {
            const double w = floor(j->part[c].problem.weight[i] * factor + .5);
            j->weight[j->blocks.first[c] + i] = (uint32_t)fmin(w, WEIGHT_MAX);
        }
    }
}

static bool set_aside(murk_scenarios *j)
{
    const size_t n = j->problem.photons + 1;
    const unsigned threads = j->problem.threads;
    j->weight = malloc(n * sizeof *j->weight);
    j->workspace = calloc(threads, sizeof *j->workspace);
    bool has_memory = j->weight && j->workspace;
    for (unsigned k = 0; has_memory && k < threads; ++k) {
        j->workspace[k].photon = malloc(n * sizeof *j->workspace[k].photon);
        j->workspace[k].clarity = malloc(n * sizeof *j->workspace[k].clarity);
        has_memory = j->workspace[k].photon && j->workspace[k].clarity;
    }
    return has_memory;
}

murk_status murk_scenarios_create(murk_scenarios **out,
                                  const murk_scene_desc *scene,
                                  murk_sight *const *sight,
                                  const double *shares, size_t n,
                                  const murk_poses *poses, murk_error *err)
{
    const murk_scenarios_rows none = {0};
    return murk_scenarios_create_from(out, scene, sight, shares, n, poses,
                                      &none, err);
}

murk_status
murk_scenarios_create_from(murk_scenarios **out, const murk_scene_desc *scene,
                           murk_sight *const *sight, const double *shares,
                           size_t n, const murk_poses *poses,
                           const murk_scenarios_rows *rows, murk_error *err)
{
    assert(n >= 1 && n <= MURK_BLOCKS_MAX);
    murk_scenarios *j = calloc(1, sizeof *j);
    if (!j) {
        return murk_no_memory(err, "", "for %zu conditions", n);
    }
    j->scene = scene;
    j->poses = poses;

    /* The blocks lie behind one another. */
    j->blocks.n = n;
    for (size_t c = 0; c < n; ++c) {
        murk_sight_problem_init(&j->part[c], sight[c],
                                rows->pose ? rows->pose[c] : poses->pose,
                                poses->count);
        murk_sight_problem_know(&j->part[c],
                                rows->known ? rows->known[c] : NULL);
        j->part[c].tested =
            rows->tested ? rows->tested + c * poses->count : NULL;
        j->blocks.first[c + 1] =
            j->blocks.first[c] + j->part[c].problem.photons;
    }
    j->problem = j->part[0].problem; /* takes over the combining rule, the
                                        redundancy and the threads */
    j->problem.photons = j->blocks.first[n];
    j->problem.is_reweighed = true;
    j->problem.earlier_hash = NULL; /* no photons are merged */
    j->problem.has_columns = rows->has_columns;
    j->problem.get_row = get_row;
    j->problem.get_part = get_part;
    j->problem.rest = NULL;
    j->problem.list_counters = list_counters;
    j->problem.context = j;
    murk_status status = MURK_OK;
    if (j->problem.photons > UINT32_MAX) {
        status = murk_fail(err, MURK_RUN_FAILED, "",
                           "%zu photons in %zu conditions together, must be "
                           "below 2^32",
                           j->problem.photons, n);
    } else if (!set_aside(j)) {
        status = murk_no_memory(err, "", "for %zu photons of %zu conditions",
                                j->problem.photons, n);
    }

    /* Set the weights; in a known environment compute the row of each
     * candidate. */
    if (!status) {
        weigh(j, shares);
        j->problem.weight = j->weight;
    }
    if (!status && scene->placement.knowledge == MURK_SCENE_KNOWN) {
        const double begun_s = murk_clock_s();
        status = murk_matrix_create(
            &j->matrix, &j->problem,
            murk_plan_desc(scene).row_memory - rows->memory_taken, err);
        j->sense_s = murk_clock_s() - begun_s;
    }
    if (status) {
        murk_scenarios_destroy(j);
        return status;
    }
    *out = j;
    return MURK_OK;
}

void murk_scenarios_destroy(murk_scenarios *j)
{
    if (!j) {
        return;
    }
    for (unsigned k = 0; j->workspace && k < j->problem.threads; ++k) {
        free(j->workspace[k].photon);
        free(j->workspace[k].clarity);
    }
    free(j->workspace);
    free(j->weight);
    murk_matrix_destroy(j->matrix);
    free(j);
}

/* ---- plans ---- */

murk_place_desc murk_scenarios_desc(const murk_scenarios *j,
                                    murk_scene_objective objective)
{
    murk_place_desc desc = murk_plan_desc(j->scene);
    desc.constraints = murk_poses_constraints(j->poses);
    desc.start_plan = j->poses->start;
    desc.start_size = j->poses->starts;
    /* The target is a share of the coverage, here converted to a value: for the
     * mean in the weights of the problem, for the worst scenario in units of 1
     * / MURK_SHARE_ONE of a block, lowered by the rounding of that product. */
    const double share = j->scene->sensors.target;
    if (share > 0) {
        desc.count = j->poses->count;
        desc.target =
            objective == MURK_SCENE_OBJECTIVE_WORST
                ? (uint64_t)ceil(share * (double)MURK_SHARE_ONE * (1 - 0x1p-51))
                : murk_plan_value_of(share, &j->problem);
    }
    return desc;
}

murk_status murk_scenarios_place(murk_place_result *out,
                                 const murk_scenarios *j,
                                 murk_scene_objective objective,
                                 const murk_place_desc *desc, murk_error *err)
{
    if (objective == MURK_SCENE_OBJECTIVE_MEAN) {
        return murk_place_sensors(out, &j->problem, j->matrix, desc, err);
    }
    murk_blocks blocks = j->blocks;
    blocks.measure = objective == MURK_SCENE_OBJECTIVE_WORST ? MURK_BLOCK_SHARE
                     : j->scene->placement.relative_regret
                         ? MURK_BLOCK_REGRET_RELATIVE
                         : MURK_BLOCK_REGRET;
    return murk_place_worst(out, &j->problem, j->matrix, &blocks, desc, err);
}

murk_status murk_scenarios_place_one(murk_place_result *out,
                                     const murk_scenarios *j, size_t block,
                                     bool with_problem_weights,
                                     const murk_place_desc *desc,
                                     murk_error *err)
{
    murk_matrix *matrix = NULL;
    murk_problem problem = j->problem;
    const size_t first = j->blocks.first[block];
    uint32_t *weight = calloc(problem.photons + 1, sizeof *weight);
    if (!weight) {
        return murk_no_memory(err, "", "for %zu photons", problem.photons);
    }
    /* Weights of all other scenarios are 0. */
    memcpy(weight + first,
           with_problem_weights ? j->weight + first
                                : j->part[block].problem.weight,
           j->part[block].problem.photons * sizeof *weight);
    /* The matrix of all scenarios serves with these weights. */
    murk_status status = murk_matrix_reweigh(&matrix, j->matrix, weight, err);
    if (!status) {
        problem.weight = weight;
        status = murk_place_sensors(out, &problem, matrix, desc, err);
    }
    murk_matrix_destroy(matrix);
    free(weight);
    return status;
}
