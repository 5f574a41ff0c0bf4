/* Greedy next best view with path planning over the places seen so far
 * (plan/explore.h describes the method and cites the source). Gains are
 * evaluated lazily (placement/lazy_greedy.h), and so is the number of places
 * that a pose brings into view. Both can only decrease while stations are
 * added, so the last known value of each is an upper bound. */
#include "plan/explore.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "base/sort.h"
#include "placement/lazy_greedy.h"
#include "plan/explored.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* The largest number of poses whose views are computed, in parallel, between
 * two comparisons with the best pose so far. The number is fixed, so the set of
 * computed views does not depend on the number of threads; 32 poses occupy the
 * threads of a large machine. */
#define CHUNK 32

typedef struct exploring {
    murk_explore *out;
    const murk_poses *poses;
    murk_sight *sight;
    uint32_t start;
    murk_constraint_set constraint_set;
    murk_partial_plan partial;
    murk_lazy_greedy greedy;
    murk_explored explored;
    uint32_t *open;      /* [poses]; poses that the constraints admit next */
    uint32_t *opens;     /* [poses]; upper bound on the number of places that
                          * each pose brings into view */
    murk_ranked *ranked; /* [poses]; sorted by that bound */
    uint32_t chunk[CHUNK];
    uint32_t here; /* place at which the path ends so far */
} exploring;

/* ---- candidates for the next station ---- */

/* Fills e->open with the poses that may be added and returns their number.
 * While the path has no stop, these are poses at the start, later poses at
 * places that were seen and are connected to the start (plan/explored.h). *seen
 * is the number of all candidates at these places, also of those that the
 * constraints do not admit or that the plan already has. */
static size_t gather(exploring *e, size_t *seen)
{
    size_t n = 0;
    const bool is_first = e->out->stops == 0;
    const size_t candidates = e->poses->count - e->poses->fixed;
    *seen = 0;
    for (uint32_t j = 0; j < candidates; ++j) {
        const uint32_t place = e->poses->site[j];
        if (is_first ? place == e->start
                     : murk_explored_joins(&e->explored, place, e->start)) {
            ++*seen;
            if (murk_partial_plan_can_add(&e->partial, j, false)) {
                e->open[n++] = j;
            }
        }
    }
    return n;
}

static void count_opened(void *context, uint64_t batch)
{
    exploring *e = context;
    const uint32_t j = e->chunk[batch];
    e->opens[j] = (uint32_t)murk_explored_opens(
        &e->explored, &e->poses->pose[j], e->poses->site[j]);
}

/* Finds among e->open[n] the pose that brings most places into view
 * (murk_explored_opens()); false if none brings any. The count of places of a
 * pose only decreases while stations are added, so poses are evaluated in
 * falling order of their last known count until the best count cannot be
 * exceeded. Ties go to the pose with the lowest index. */
static bool find_opener(exploring *e, size_t n, uint32_t *next)
{
    /* Sort by the upper bounds. */
    for (size_t k = 0; k < n; ++k) {
        e->ranked[k] = (murk_ranked){e->opens[e->open[k]], e->open[k]};
    }
    murk_ranked_sort(e->ranked, n);
    murk_ranked best = {0, 0};
    /* Evaluate chunks of poses whose upper bound exceeds the best count, or
     * equals the best count with a lower index, until no such pose is left. */
    for (size_t at = 0; at < n && !murk_interrupted();) {
        size_t taken = 0;
        while (at < n && taken < CHUNK &&
               (e->ranked[at].bound > best.bound ||
                (e->ranked[at].bound == best.bound && best.bound > 0 &&
                 e->ranked[at].candidate < best.candidate))) {
            e->chunk[taken++] = e->ranked[at++].candidate;
        }
        if (taken == 0) {
            break;
        }
        murk_pool_run(murk_sight_described(e->sight)->threads, taken,
                      count_opened, e);
        for (size_t k = 0; k < taken; ++k) {
            const murk_ranked now = {e->opens[e->chunk[k]], e->chunk[k]};
            if (now.bound > best.bound ||
                (now.bound == best.bound && best.bound > 0 &&
                 now.candidate < best.candidate)) {
                best = now;
            }
        }
    }
    *next = best.candidate;
    return best.bound > 0;
}

/* ---- steps ---- */

/* Appends the path from the place e->here to `place`, whose length becomes
 * *length_m, and sets e->here to `place`. */
static murk_status go_to(exploring *e, uint32_t place, double *length_m,
                         murk_error *err)
{
    murk_explore *out = e->out;
    size_t stops = 0;
    murk_vec3 *path = NULL;
    murk_status status = murk_explored_path(&e->explored, &path, &stops,
                                            length_m, e->here, place, err);
    if (status) {
        return status;
    }
    const size_t first = out->stops > 0; /* if the list has stops, the first
                                          * stop of the path is left out,
                                          * because it is the last stop of the
                                          * list */
    murk_vec3 *stop =
        realloc(out->stop, (out->stops + stops + 1) * sizeof *stop);
    if (stop) {
        out->stop = stop;
        memcpy(stop + out->stops, path + first, (stops - first) * sizeof *stop);
        out->stops += stops - first;
        e->here = place;
    } else {
        status = murk_no_memory(err, "", "for the path");
    }
    free(path);
    return status;
}

/* Adds a pose to the plan and records the state. is_gone_to: extend the path to
 * the place of the pose. */
static murk_status take(exploring *e, uint32_t j, bool is_gone_to,
                        murk_error *err)
{
    murk_explore *out = e->out;
    murk_explore_step *step = &out->step[out->steps];
    double length_m = 0;
    /* Extend the path. */
    if (is_gone_to) {
        const murk_status status = go_to(e, e->poses->site[j], &length_m, err);
        if (status) {
            return status;
        }
    }
    /* Add the pose and record the coverage and the work so far. */
    const double gone_m = out->steps ? out->step[out->steps - 1].path_m : 0;
    murk_partial_plan_add(&e->partial, j);
    *step = (murk_explore_step){
        .candidate = j,
        .gain = murk_lazy_greedy_add(&e->greedy, j),
        .value = e->greedy.value,
        .path_m = gone_m + length_m,
        .places_seen = murk_explored_see(&e->explored, &e->poses->pose[j],
                                         e->poses->site[j]),
        .queries = murk_sight_work_of(e->sight).queries,
        .shadow_rays = murk_sight_work_of(e->sight).shadow_rays,
        .stops = out->stops};
    ++out->steps;
    murk_progress_add(1);
    return MURK_OK;
}

/* Finds the next station; if there is none, sets out->end and returns false. If
 * the path has no stop yet and no pose at the start brings a gain, the next
 * station is the first pose that may be added there. */
static bool choose(exploring *e, uint32_t *next)
{
    uint64_t gain = 0;
    size_t seen;
    const size_t n = gather(e, &seen);
    if (n == 0) {
        e->out->end = seen > e->out->steps - e->out->fixed
                          ? MURK_EXPLORE_CONSTRAINTS
                          : MURK_EXPLORE_NOTHING;
        return false;
    }
    *next = murk_lazy_greedy_best(&e->greedy, e->open, n, &gain);
    if (gain > 0 || find_opener(e, n, next)) {
        return true;
    }
    *next = e->open[0];
    e->out->end = MURK_EXPLORE_NOTHING;
    return e->out->stops == 0; /* there is a station at the start even if
                                * nothing is gained there */
}

/* Adds the fixed sensors to the plan. If the scene gives no start_m, this
 * function also begins the path, at the first fixed sensor; with start_m the
 * path begins later, with the first station. */
static murk_status begin(exploring *e, bool has_start, murk_error *err)
{
    double none;
    murk_status status = has_start ? MURK_OK : go_to(e, e->start, &none, err);
    const size_t first = e->poses->count - e->poses->fixed;
    for (size_t k = 0; k < e->poses->fixed && !status; ++k) {
        status = take(e, (uint32_t)(first + k), false, err);
    }
    e->out->fixed = e->poses->fixed;
    return status;
}

/* Adds stations until an end condition holds. */
static murk_status add_stations(exploring *e, const murk_place_desc *desc,
                                const char *where, murk_error *err)
{
    murk_status status = MURK_OK;
    while (!status && !murk_interrupted()) {
        uint32_t next;
        /* Target, count and limit of stations. */
        if (desc->target && e->greedy.value >= desc->target) {
            e->out->end = MURK_EXPLORE_TARGET;
            return MURK_OK;
        }
        if (!desc->target && desc->count > 0 &&
            e->partial.size == desc->count) {
            e->out->end = MURK_EXPLORE_COUNT;
            return MURK_OK;
        }
        if (e->out->steps == MURK_EXPLORE_MAX + e->out->fixed) {
            e->out->end = MURK_EXPLORE_STATIONS;
            return MURK_OK;
        }
        /* The next station. */
        if (!choose(e, &next)) {
            break;
        }
        status = take(e, next, true, err);
    }
    /* An interrupt is an error, and so is a start that no sensor may occupy. */
    status = status ? status : murk_interrupt_check(err);
    if (!status && e->out->stops == 0) {
        status = murk_fail(err, MURK_BAD_VALUE, where,
                           "start_m: the rules let no sensor stand at the "
                           "start");
    }
    return status;
}

/* ---- result ---- */

static const char *why(murk_explore_end end)
{
    return end == MURK_EXPLORE_CONSTRAINTS
               ? "the rules let nobody join in seen space"
           : end == MURK_EXPLORE_STATIONS ? "that is the most"
                                          : "nothing in seen space adds to it";
}

/* Fails if the target or the minimum counts of types are not reached. */
static murk_status check_end(const exploring *e, const murk_place_desc *desc,
                             murk_error *err)
{
    const murk_explore *out = e->out;
    if (desc->target && out->end != MURK_EXPLORE_TARGET) {
        const double whole = (double)e->greedy.layout.whole;
        return murk_fail(err, MURK_RUN_FAILED, "",
                         "target %.6g is not reached: exploring ends with %zu "
                         "sensors that see %.6g, %zu of %zu places seen: %s",
                         (double)desc->target / whole, out->steps,
                         (double)e->greedy.value / whole,
                         out->steps ? out->step[out->steps - 1].places_seen : 0,
                         out->places, why(out->end));
    }
    if (e->partial.missing > 0) {
        return murk_fail(err, MURK_RUN_FAILED, "",
                         "exploring ends with %zu sensors, %zu short of the "
                         "types' least counts: %s",
                         out->steps, e->partial.missing, why(out->end));
    }
    return MURK_OK;
}

/* Fills the result with the sensors in rising order. */
static murk_status fill(murk_place_result *place, const exploring *e,
                        murk_error *err)
{
    const murk_explore *out = e->out;
    size_t *sensor = calloc(out->steps + 1, sizeof *sensor);
    if (!sensor) {
        return murk_no_memory(err, "", "for the plan");
    }
    for (size_t k = 0; k < out->steps; ++k) {
        sensor[k] = out->step[k].candidate;
    }
    qsort(sensor, out->steps, sizeof *sensor, murk_by_size);
    *place =
        (murk_place_result){.count = out->steps,
                            .sensor = sensor,
                            .value = e->greedy.value,
                            .cost = e->partial.cost,
                            .whole = e->greedy.layout.whole,
                            .evaluations = e->greedy.queries,
                            .queries = murk_sight_work_of(e->sight).queries};
    return MURK_OK;
}

/* Allocates. The upper bounds e->opens on the numbers of places that poses
 * bring into view start at UINT32_MAX. */
static murk_status allocate(exploring *e, murk_error *err)
{
    const size_t n = e->poses->count + 1;
    const size_t steps = e->poses->fixed + MURK_EXPLORE_MAX + 1;
    e->open = malloc(n * sizeof *e->open);
    e->opens = malloc(n * sizeof *e->opens);
    e->ranked = malloc(n * sizeof *e->ranked);
    e->out->step = calloc(steps, sizeof *e->out->step);
    if (!e->open || !e->opens || !e->ranked || !e->out->step) {
        return murk_no_memory(err, "", "to explore %zu candidates",
                              e->poses->count);
    }
    memset(e->opens, 0xff, n * sizeof *e->opens);
    return MURK_OK;
}

murk_status murk_explore_run(murk_explore *out, murk_place_result *place,
                             const murk_stage *stage, murk_sight *sight,
                             const murk_problem *problem,
                             const murk_candidates *sites,
                             const murk_poses *poses, uint32_t start,
                             const murk_place_desc *desc, murk_error *err)
{
    assert(desc->constraints);
    const murk_scene_placement *settings = &stage->scene->placement;
    exploring e = {.out = out,
                   .poses = poses,
                   .sight = sight,
                   .start = start,
                   .here = start};
    *out = (murk_explore){.places = sites->usable};
    /* Set up constraints, the partial plan, lazy evaluation and the map of
     * places. With a target or a budget the count is a maximum. */
    const bool is_max = desc->target || desc->constraints->budget > 0;
    const size_t count = desc->count > 0 ? desc->count : poses->count;
    murk_status status = murk_constraint_set_init(
        &e.constraint_set, desc->constraints, poses->count,
        count < poses->count ? count : poses->count, is_max, err);
    if (!status) {
        status = murk_partial_plan_init(&e.partial, &e.constraint_set, err);
    }
    if (!status) {
        status =
            murk_lazy_greedy_init(&e.greedy, problem, &e.constraint_set, err);
    }
    if (!status) {
        status =
            murk_explored_init(&e.explored, murk_sight_described(sight),
                               stage->scene->bands, sites->usable, poses, err);
    }
    if (!status) {
        status = allocate(&e, err);
    }
    if (status) {
        goto done;
    }
    /* Explore. */
    murk_progress_begin("explore", desc->target ? 0 : count, "stations");
    status = begin(&e, settings->has_start, err);
    if (!status) {
        status = add_stations(&e, desc, settings->where, err);
    }
    murk_progress_end();
    /* Check and return the plan. */
    out->lines_tested = (uint64_t)murk_tally_read(&e.explored.outlook.tried);
    if (!status) {
        status = check_end(&e, desc, err);
    }
    if (!status) {
        status = fill(place, &e, err);
    }
done:
    free(e.open);
    free(e.opens);
    free(e.ranked);
    murk_explored_release(&e.explored);
    murk_lazy_greedy_release(&e.greedy);
    murk_partial_plan_release(&e.partial);
    murk_constraint_set_release(&e.constraint_set);
    return status;
}

void murk_explore_release(murk_explore *explore)
{
    free(explore->step);
    free(explore->stop);
    *explore = (murk_explore){0};
}
