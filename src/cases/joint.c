#include "cases/joint.h"

#include "plan/plan.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* All weights add up to less than this, and none reaches 2^32. */
#define WHOLE      0x1p47
#define WEIGHT_MAX 4294967295.0

/* Where one worker puts a look together. */
typedef struct murk_joint_workspace {
    uint32_t *photon;  /* [photons] */
    uint16_t *clarity; /* [photons] */
} murk_joint_workspace;

static void append(murk_joint_workspace *workspace, size_t at, size_t first,
                   const murk_look *look)
{
    for (size_t k = 0; k < look->seen; ++k) {
        workspace->photon[at + k] = (uint32_t)(first + look->photon[k]);
        workspace->clarity[at + k] =
            look->clarity ? look->clarity[k] : MURK_CLEAR;
    }
}

static void look(void *context, unsigned worker, size_t candidate,
                 murk_look *out)
{
    const murk_joint *j = context;
    murk_joint_workspace *workspace = &j->workspace[worker];
    bool is_clear = true;
    size_t seen = 0;
    for (size_t c = 0; c < j->blocks.n; ++c) {
        const murk_problem *part = &j->part[c].problem;
        murk_look one;
        part->look(part->context, worker, candidate, &one);
        append(workspace, seen, j->blocks.first[c], &one);
        is_clear = is_clear && !one.clarity;
        seen += one.seen;
    }
    *out = (murk_look){seen, workspace->photon,
                       is_clear ? NULL : workspace->clarity};
}

/* The largest scale, for shares of it to each block's whole, at which sums and
 * single weights stay in range. */
static double scale_of(const murk_joint *j, const double *shares,
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

static void weigh(murk_joint *j, const double *shares)
{
    double whole[MURK_BLOCKS_MAX] = {0};
    for (size_t c = 0; c < j->blocks.n; ++c) {
        for (size_t i = 0; i < j->part[c].problem.photons; ++i) {
            whole[c] += j->part[c].problem.weight[i];
        }
    }
    if (j->blocks.n == 1) { /* as its own sight counts: nothing is rounded */
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

static bool set_aside(murk_joint *j)
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

murk_status murk_joint_create(murk_joint **out, murk_sight *const *sight,
                              const double *shares, size_t n,
                              const murk_pose *pose, size_t n_poses,
                              murk_error *err)
{
    assert(n >= 1 && n <= MURK_BLOCKS_MAX);
    murk_joint *j = calloc(1, sizeof *j);
    if (!j) {
        return murk_fail(err, MURK_NO_MEMORY, "",
                         "no memory for %zu conditions", n);
    }
    j->blocks.n = n;
    for (size_t c = 0; c < n; ++c) {
        murk_sight_problem_init(&j->part[c], sight[c], pose, n_poses);
        j->blocks.first[c + 1] =
            j->blocks.first[c] + j->part[c].problem.photons;
    }
    j->problem = j->part[0].problem; /* how views combine, and threads */
    j->problem.photons = j->blocks.first[n];
    j->problem.is_reweighed = true;
    j->problem.look = look;
    j->problem.context = j;
    murk_status status = MURK_OK;
    if (j->problem.photons > UINT32_MAX) {
        status = murk_fail(err, MURK_RUN_FAILED, "",
                           "%zu photons in %zu conditions together, must be "
                           "below 2^32",
                           j->problem.photons, n);
    } else if (!set_aside(j)) {
        status = murk_fail(err, MURK_NO_MEMORY, "",
                           "no memory for %zu photons of %zu conditions",
                           j->problem.photons, n);
    }
    if (status) {
        murk_joint_destroy(j);
        return status;
    }
    weigh(j, shares);
    j->problem.weight = j->weight;
    *out = j;
    return MURK_OK;
}

void murk_joint_destroy(murk_joint *j)
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
    free(j);
}

uint32_t *murk_joint_weights_of(const murk_joint *j, size_t c, bool as_joint)
{
    uint32_t *out = calloc(j->problem.photons + 1, sizeof *out);
    if (out) {
        memcpy(out + j->blocks.first[c],
               as_joint ? j->weight + j->blocks.first[c]
                        : j->part[c].problem.weight,
               j->part[c].problem.photons * sizeof *out);
    }
    return out;
}

uint64_t murk_joint_target(const murk_joint *j, double share, bool is_worst)
{
    return is_worst
               ? (uint64_t)ceil(share * (double)MURK_SHARE_ONE * (1 - 0x1p-51))
               : murk_plan_value_of(share, &j->problem);
}
