/* Candidate sites: checks the request, finds the free space of the grid
 * (sensing/reach.h), classifies the points of the grid and the listed sites
 * (sensing/listed.h), and collects the usable ones. Each site gets one verdict,
 * so the counts of the causes add up to the number of requested sites. */
#include "sensing/candidates.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/position.h"
#include "path/segment.h"
#include "sensing/listed.h"
#include "sensing/reach.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>

/* Sensors are not mounted nearer to a surface than a millimetre, so a coarser
 * precision of the surfaces is reported as the cause of lost candidates. */
#define MIN_STEP_M 1e-3

#define POINTS_MAX ((double)MURK_CANDIDATES_MAX)
/* Grid points of a task: some 100 us of work (a choice). */
#define BATCH_POINTS 4096

static double coordinate(double min, double max, size_t i, size_t n)
{
    if (n == 1) {
        return min + (max - min) / 2;
    }
    return i + 1 == n ? max : min + (max - min) * (double)i / (double)(n - 1);
}

murk_candidate_grid murk_candidate_grid_fill(const murk_box *box, size_t points)
{
    const murk_vec3 extent = murk_sub(box->max, box->min);
    const double maximum = (double)points;
    const double step = cbrt(extent.x * extent.y * extent.z / maximum);
    const double n[3] = {fmin(fmax(1, round(extent.x / step)), maximum),
                         fmin(fmax(1, round(extent.y / step)), maximum),
                         fmin(fmax(1, round(extent.z / step)), maximum)};
    const murk_vec3 half = {extent.x / n[0] / 2, extent.y / n[1] / 2,
                            extent.z / n[2] / 2};
    return (murk_candidate_grid){
        .min = murk_add(box->min, half),
        .max = murk_sub(box->max, half),
        .size = {(size_t)n[0], (size_t)n[1], (size_t)n[2]}};
}

murk_vec3 murk_candidate_grid_point(const murk_candidate_grid *grid,
                                    size_t index)
{
    const size_t *n = grid->size;
    const size_t i = index % n[0], j = index / n[0] % n[1],
                 k = index / n[0] / n[1];
    return murk_vec(coordinate(grid->min.x, grid->max.x, i, n[0]),
                    coordinate(grid->min.y, grid->max.y, j, n[1]),
                    coordinate(grid->min.z, grid->max.z, k, n[2]));
}

static murk_status check_size(const murk_candidate_grid *grid,
                              const char *where, murk_error *err)
{
    double points = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (grid->size[axis] < 1) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "size is [%zu, %zu, %zu], must be 1 or more along "
                             "each axis",
                             grid->size[0], grid->size[1], grid->size[2]);
        }
        points *= (double)grid->size[axis];
    }
    if (!(points <= POINTS_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "size [%zu, %zu, %zu] makes %.3g candidates, must be "
                         "%.3g at most",
                         grid->size[0], grid->size[1], grid->size[2], points,
                         POINTS_MAX);
    }
    return MURK_OK;
}

static murk_status check_place(const murk_candidate_grid *grid,
                               const murk_domain *domain, const char *where,
                               murk_error *err)
{
    const murk_vec3 a = grid->min, b = grid->max;
    const double from[3] = {a.x, a.y, a.z}, to[3] = {b.x, b.y, b.z};
    if (!murk_is_finite(a) || !murk_is_finite(b)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "min_m or max_m is not finite");
    }
    /* The grid must extend upwards along each axis, and lie in the domain. */
    for (int axis = 0; axis < 3; ++axis) {
        const bool is_line = grid->size[axis] > 1;
        if (!(is_line ? from[axis] < to[axis] : from[axis] <= to[axis])) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "%c runs from %g to %g m, must rise", "xyz"[axis],
                             from[axis], to[axis]);
        }
    }
    const size_t n = grid->size[0] * grid->size[1] * grid->size[2];
    for (size_t i = 0; i < n; ++i) {
        const murk_vec3 p = murk_candidate_grid_point(grid, i);
        if (!murk_box_contains(&domain->box, p)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "candidate %s m is outside the domain, %s to %s m",
                             murk_position_show(p).text,
                             murk_position_show(domain->box.min).text,
                             murk_position_show(domain->box.max).text);
        }
    }
    return MURK_OK;
}

static murk_status check_listed(const murk_candidate_desc *desc,
                                const murk_surfaces *surfaces,
                                const murk_domain *domain, const char *where,
                                murk_error *err)
{
    for (size_t i = 0; i < desc->points; ++i) {
        const murk_vec3 p = desc->point[i];
        if (!murk_box_contains(&domain->box, p)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "point %zu, %s m, is outside the domain", i,
                             murk_position_show(p).text);
        }
    }
    const double min_m = 2 * murk_path_surface_tolerance_m(surfaces, domain);
    for (size_t i = 0; i < desc->mounts; ++i) {
        if (!(desc->mount[i].offset_m > min_m)) {
            return murk_fail(err, MURK_BAD_VALUE, where,
                             "offset_m is %g m, must be more than %.3g m: less "
                             "is lost in rounding",
                             desc->mount[i].offset_m, min_m);
        }
    }
    return MURK_OK;
}

static murk_status check(const murk_candidate_desc *desc,
                         const murk_surfaces *surfaces,
                         const murk_domain *domain, const char *where,
                         murk_error *err)
{
    const murk_candidate_grid *grid = &desc->grid;
    if (!(grid->clearance_m >= 0 && isfinite(grid->clearance_m))) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "clearance_m is %g m, must be 0 or more",
                         grid->clearance_m);
    }
    murk_status status = check_size(grid, where, err);
    if (!status) {
        status = check_place(grid, domain, where, err);
    }
    return status ? status : check_listed(desc, surfaces, domain, where, err);
}

/* ---- verdicts ---- */

/* The request, with a verdict on each site: first the grid, unless it only
 * carries reach, then the listed sites. */
typedef struct request {
    const murk_candidate_desc *desc;
    murk_free_space space;
    size_t grid; /* candidates of the grid */
    murk_listed *listed;
    size_t n_listed;
    uint8_t *verdict; /* [grid + n_listed] murk_verdict */
} request;

static murk_verdict classify(const request *a, size_t i)
{
    const murk_free_space *space = &a->space;
    const murk_closeness closeness = (murk_closeness)space->closeness[i];
    if (murk_site_is_forbidden(a->desc,
                               murk_candidate_grid_point(&a->desc->grid, i))) {
        return MURK_SITE_FORBIDDEN;
    }
    if (closeness == MURK_ON_SURFACE ||
        (space->is_reached[i] && closeness == MURK_TOO_CLOSE)) {
        return MURK_SITE_TOO_CLOSE;
    }
    if (!space->is_reached[i]) {
        return space->is_doubtful[i] ? MURK_SITE_BARELY_UNREACHED
                                     : MURK_SITE_UNREACHED;
    }
    return closeness == MURK_BARELY_CLEAR ? MURK_SITE_DOUBTFUL
                                          : MURK_SITE_USABLE;
}

static void classify_grid(void *context, uint64_t batch)
{
    request *a = context;
    const size_t begin = (size_t)batch * BATCH_POINTS;
    for (size_t i = begin; i < a->grid && i < begin + BATCH_POINTS; ++i) {
        a->verdict[i] = (uint8_t)classify(a, i);
    }
}

static murk_status classify_sites(request *a, const murk_surfaces *surfaces,
                                  const murk_reach *reach, unsigned threads,
                                  const char *where, murk_error *err)
{
    /* List all sites. */
    const size_t *n = a->desc->grid.size;
    murk_status status = murk_listed_all(&a->listed, &a->n_listed, a->desc,
                                         &reach->domain, where, err);
    if (status) {
        return status;
    }
    a->grid = a->desc->is_reach_grid ? 0 : n[0] * n[1] * n[2];
    const size_t all = a->grid + a->n_listed;
    if (all < 1 || all > MURK_CANDIDATES_MAX) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%zu candidates are asked for, must be 1..%d", all,
                         MURK_CANDIDATES_MAX);
    }
    a->verdict = malloc(all);
    if (!a->verdict) {
        return murk_fail(err, MURK_NO_MEMORY, where,
                         "no memory for %zu candidates", all);
    }
    /* Find the free space and classify the grid, then the listed sites. */
    status = murk_free_space_find(&a->space, &a->desc->grid, surfaces, reach,
                                  threads, where, err);
    if (status) {
        return status;
    }
    murk_pool_run(threads, (a->grid + BATCH_POINTS - 1) / BATCH_POINTS,
                  classify_grid, a);
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    return a->n_listed == 0
               ? MURK_OK
               : murk_listed_judge(a->verdict + a->grid, a->listed, a->n_listed,
                                   a->desc, &a->space, surfaces, reach, threads,
                                   where, err);
}

static void release(request *a)
{
    murk_free_space_release(&a->space);
    free(a->listed);
    free(a->verdict);
}

/* ---- the result ---- */

static bool is_usable(murk_verdict verdict)
{
    return verdict == MURK_SITE_USABLE || verdict == MURK_SITE_DOUBTFUL;
}

static void count(murk_candidates *c, const request *a)
{
    c->asked = a->grid + a->n_listed;
    for (size_t i = 0; i < c->asked; ++i) {
        const murk_verdict verdict = (murk_verdict)a->verdict[i];
        c->usable += is_usable(verdict);
        c->doubtful += verdict == MURK_SITE_DOUBTFUL ||
                       verdict == MURK_SITE_BARELY_UNREACHED;
        c->duplicates += verdict == MURK_SITE_DUPLICATE;
        c->forbidden += verdict == MURK_SITE_FORBIDDEN;
        c->too_close += verdict == MURK_SITE_TOO_CLOSE;
        c->unreached += verdict == MURK_SITE_UNREACHED ||
                        verdict == MURK_SITE_BARELY_UNREACHED;
    }
}

static murk_status refuse_none(const murk_candidates *c, double clearance_m,
                               const murk_surfaces *surfaces, const char *where,
                               murk_error *err)
{
    /* Rays start this far from a surface: closer positions cannot be
     * distinguished. */
    const double step_m = murk_surfaces_leave_step_m(surfaces);
    char more[96] = "";
    if (c->too_close > 0 && step_m > fmax(clearance_m, MIN_STEP_M)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "none of the %zu candidates is usable: at the size "
                         "of the coordinates surfaces are known to %.3g m "
                         "only, more than clearance_m, %g m. Give a domain, "
                         "and leave out surfaces that are far from it",
                         c->asked, step_m, clearance_m);
    }
    if (c->forbidden + c->duplicates > 0) {
        snprintf(more, sizeof more, ", %zu forbidden by zones, %zu duplicates",
                 c->forbidden, c->duplicates);
    }
    return murk_fail(err, MURK_BAD_VALUE, where,
                     "none of the %zu candidates is usable: %zu out of reach "
                     "of any light, %zu on a surface or nearer to one than %g "
                     "m%s",
                     c->asked, c->unreached, c->too_close, clearance_m, more);
}

static void keep_one(murk_candidates *c, size_t to, const request *a, size_t i)
{
    if (i < a->grid) {
        c->position[to] = murk_candidate_grid_point(&a->desc->grid, i);
        c->kind[to] = MURK_CANDIDATE_GRID;
        return;
    }
    const murk_listed *site = &a->listed[i - a->grid];
    c->position[to] = site->position;
    c->kind[to] =
        site->offset_m > 0 ? MURK_CANDIDATE_MOUNT : MURK_CANDIDATE_POINT;
    if (c->normal) {
        c->normal[to] = site->normal;
    }
}

static murk_status keep_usable(murk_candidates *c, const request *a,
                               const murk_surfaces *surfaces, const char *where,
                               murk_error *err)
{
    if (c->usable == 0) {
        return refuse_none(c, a->desc->grid.clearance_m, surfaces, where, err);
    }
    /* Copy position, kind and normal of the usable sites. */
    const bool has_normals = a->desc->mounts > 0;
    c->position = malloc(c->usable * sizeof *c->position);
    c->kind = malloc(c->usable);
    c->normal = has_normals ? calloc(c->usable, sizeof *c->normal) : NULL;
    if (!c->position || !c->kind || (has_normals && !c->normal)) {
        return murk_fail(err, MURK_NO_MEMORY, where,
                         "no memory for %zu candidates", c->usable);
    }
    size_t kept = 0;
    for (size_t i = 0; i < c->asked; ++i) {
        if (is_usable((murk_verdict)a->verdict[i])) {
            keep_one(c, kept++, a, i);
        }
    }
    return MURK_OK;
}

murk_status murk_candidates_create(murk_candidates **out,
                                   const murk_candidate_desc *desc,
                                   const murk_surfaces *surfaces,
                                   const murk_reach *reach, unsigned threads,
                                   const char *where, murk_error *err)
{
    assert(out && desc && surfaces && reach && threads >= 1 && where);
    murk_candidates *candidates = NULL;
    request a = {.desc = desc};
    murk_status status = check(desc, surfaces, &reach->domain, where, err);
    if (status) {
        goto done;
    }
    /* Classify, count, and keep the usable sites. */
    status = classify_sites(&a, surfaces, reach, threads, where, err);
    if (status) {
        goto done;
    }
    candidates = calloc(1, sizeof *candidates);
    if (!candidates) {
        status =
            murk_fail(err, MURK_NO_MEMORY, where, "no memory for candidates");
        goto done;
    }
    count(candidates, &a);
    status = keep_usable(candidates, &a, surfaces, where, err);
    if (status) {
        goto done;
    }
    *out = candidates;
    candidates = NULL;
done:
    murk_candidates_destroy(candidates);
    release(&a);
    return status;
}

void murk_candidates_destroy(murk_candidates *candidates)
{
    if (candidates) {
        free(candidates->position);
        free(candidates->normal);
        free(candidates->kind);
        free(candidates);
    }
}
