/* Candidate sites: finds the free space of the grid (sensing/reach.h),
 * classifies the points of the grid and the listed sites (sensing/listed.h),
 * and collects the usable ones. Each site gets one verdict, so the usable sites
 * and the counts of the causes add up to the number of requested sites. */
#include "sensing/candidates.h"

#include "base/pool.h"
#include "sensing/listed.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>

/* If no site is usable and some are too close, a precision of the surfaces that
 * is coarser than this and than the clearance is reported as the cause: sensors
 * are not mounted nearer to a surface than a millimetre. */
#define MIN_STEP_M 1e-3

/* Grid points that a thread takes at a time: some 100 us of work (a choice). */
#define BATCH_POINTS 4096

/* The request, with the classification (murk_verdict) of each site. The points
 * of the grid come first, unless the grid gives no candidates and only serves
 * to find the free space (is_reach_grid). The listed sites follow. */
typedef struct request {
    const murk_candidate_desc *desc;
    murk_free_space space;
    size_t grid; /* candidates of the grid */
    murk_listed *listed;
    size_t n_listed;
    uint8_t *verdict; /* [grid + n_listed] murk_verdict */
} request;

static murk_verdict verdict_on(const request *a, size_t i)
{
    const murk_free_space *space = &a->space;
    const murk_closeness closeness = (murk_closeness)space->closeness[i];
    if (murk_candidate_is_forbidden(
            a->desc, murk_candidate_grid_point(&a->desc->grid, i))) {
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

static void classify(void *context, uint64_t i)
{
    request *a = context;
    a->verdict[i] = (uint8_t)verdict_on(a, i);
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
        return murk_no_memory(err, where, "for %zu candidates", all);
    }
    /* Find the free space and classify the grid, then the listed sites. */
    status = murk_free_space_find(&a->space, &a->desc->grid, surfaces, reach,
                                  threads, where, err);
    if (status) {
        return status;
    }
    murk_pool_run_items(threads, a->grid, BATCH_POINTS, classify, a);
    return murk_listed_judge(a->verdict + a->grid, a->listed, a->n_listed,
                             a->desc, &a->space, threads, err);
}

/* ---- the result ---- */

static void count(murk_candidates *c, const request *a)
{
    size_t n[MURK_SITE_VERDICTS] = {0};
    c->asked = a->grid + a->n_listed;
    for (size_t i = 0; i < c->asked; ++i) {
        ++n[a->verdict[i]];
    }
    c->usable = n[MURK_SITE_USABLE] + n[MURK_SITE_DOUBTFUL];
    c->doubtful = n[MURK_SITE_DOUBTFUL] + n[MURK_SITE_BARELY_UNREACHED];
    c->duplicates = n[MURK_SITE_DUPLICATE];
    c->forbidden = n[MURK_SITE_FORBIDDEN];
    c->too_close = n[MURK_SITE_TOO_CLOSE];
    c->unreached = n[MURK_SITE_UNREACHED] + n[MURK_SITE_BARELY_UNREACHED];
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
        return murk_no_memory(err, where, "for %zu candidates", c->usable);
    }
    size_t copied = 0;
    for (size_t i = 0; i < c->asked; ++i) {
        if (a->verdict[i] == MURK_SITE_USABLE ||
            a->verdict[i] == MURK_SITE_DOUBTFUL) {
            keep_one(c, copied++, a, i);
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
    request a = {.desc = desc};
    murk_candidates *c = calloc(1, sizeof *c);
    murk_status status = c ? murk_candidate_desc_check(
                                 desc, surfaces, &reach->domain, where, err)
                           : murk_no_memory(err, where, "for candidates");
    /* Classify, count, and keep the usable sites. */
    if (!status) {
        status = classify_sites(&a, surfaces, reach, threads, where, err);
    }
    if (!status) {
        count(c, &a);
        status = keep_usable(c, &a, surfaces, where, err);
    }
    murk_free_space_release(&a.space);
    free(a.listed);
    free(a.verdict);
    if (status) {
        murk_candidates_destroy(c);
        return status;
    }
    *out = c;
    return MURK_OK;
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
