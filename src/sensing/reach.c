/* Free space of a grid: distances to surfaces and steps between neighbours are
 * tested in parallel; then a flood fill starts at every point that a lamp or an
 * open side reaches. The steps are tested before the fill, so the result is a
 * closure and does not depend on the order. Bytes instead of bits keep the
 * tasks free of shared words. */
#include "sensing/reach.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "path/segment.h"
#include "sensing/free_segments.h"
#include "sensing/lamp.h"

#include <stdlib.h>

/* Grid points of a task (a choice). */
#define BATCH_POINTS 1024

enum reached {
    UNREACHED,
    SEEN_BY_LIGHT, /* reached, but not yet expanded */
    REACHED
};

typedef struct search {
    const murk_candidate_grid *grid;
    const murk_surfaces *surfaces;
    const murk_reach *reach;
    unsigned threads;
    size_t points;
    size_t stride[3];
    murk_free_segments segments;
    uint8_t *closeness;
    uint8_t *open; /* bit `axis`: the step to the next point along the axis is
                      open */
    uint8_t *reached;
    uint32_t *stack;
    murk_vec3 light; /* the place of light under test */
} search;

static size_t batch_end(const search *s, uint64_t batch)
{
    const size_t end = (size_t)(batch + 1) * BATCH_POINTS;
    return end < s->points ? end : s->points;
}

static void measure_closeness(void *context, uint64_t batch)
{
    search *s = context;
    const size_t begin = (size_t)batch * BATCH_POINTS;
    const size_t end = batch_end(s, batch);
    for (size_t i = begin; i < end; ++i) {
        s->closeness[i] = (uint8_t)murk_free_segments_closeness(
            &s->segments, murk_candidate_grid_point(s->grid, i),
            s->grid->clearance_m, NULL);
    }
    murk_progress_add(end - begin);
}

/* ---- steps between neighbours ---- */

/* The next point along the axis that is not on a surface; *wraps if the step
 * crosses a periodic side. Points on a surface are skipped, so a transmitting
 * sheet in a plane of the grid can be crossed like any other sheet. */
static bool onward(const search *s, size_t point, int axis, size_t *next,
                   bool *wraps)
{
    const size_t n = s->grid->size[axis];
    const size_t at = point / s->stride[axis] % n;
    const size_t base = point - at * s->stride[axis];
    const bool may_wrap = s->reach->domain.is_periodic && axis < 2;
    for (size_t step = 1; step < n && (may_wrap || at + step < n); ++step) {
        const size_t j = base + (at + step) % n * s->stride[axis];
        if (s->closeness[j] != MURK_ON_SURFACE) {
            *next = j;
            *wraps = at + step >= n;
            return true;
        }
    }
    return false;
}

/* The point from which the step onward leads to `point`. */
static bool backward(const search *s, size_t point, int axis, size_t *previous)
{
    const size_t n = s->grid->size[axis];
    const size_t at = point / s->stride[axis] % n;
    const size_t base = point - at * s->stride[axis];
    const bool may_wrap = s->reach->domain.is_periodic && axis < 2;
    for (size_t step = 1; step < n && (may_wrap || step <= at); ++step) {
        const size_t j = base + (at + n - step) % n * s->stride[axis];
        if (s->closeness[j] != MURK_ON_SURFACE) {
            *previous = j;
            return true;
        }
    }
    return false;
}

static bool step_is_open(const search *s, size_t point, int axis)
{
    size_t next;
    bool wraps;
    if (!onward(s, point, axis, &next, &wraps)) {
        return false;
    }
    const murk_vec3 from = murk_candidate_grid_point(s->grid, point);
    murk_vec3 to = murk_candidate_grid_point(s->grid, next);
    if (wraps) {
        const murk_box *box = &s->reach->domain.box;
        to.x += axis == 0 ? box->max.x - box->min.x : 0;
        to.y += axis == 1 ? box->max.y - box->min.y : 0;
    }
    return murk_free_segment_is_open(&s->segments, from, to);
}

static void open_steps(void *context, uint64_t batch)
{
    search *s = context;
    const size_t begin = (size_t)batch * BATCH_POINTS;
    const size_t end = batch_end(s, batch);
    for (size_t i = begin; i < end; ++i) {
        unsigned open = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (s->closeness[i] != MURK_ON_SURFACE &&
                step_is_open(s, i, axis)) {
                open |= 1u << axis;
            }
        }
        s->open[i] = (uint8_t)open;
    }
    murk_progress_add(end - begin);
}

static size_t push(search *s, size_t depth, size_t point)
{
    if (s->reached[point] != REACHED) {
        s->reached[point] = REACHED;
        s->stack[depth++] = (uint32_t)point;
    }
    return depth;
}

/* Marks all points that open steps lead to from `point`. Each point is pushed
 * once, so the stack has space for all. */
static void flood(search *s, size_t point)
{
    size_t depth = push(s, 0, point);
    while (depth > 0) {
        const size_t at = s->stack[--depth];
        for (int axis = 0; axis < 3; ++axis) {
            size_t other;
            bool wraps;
            if ((s->open[at] >> axis & 1) &&
                onward(s, at, axis, &other, &wraps)) {
                depth = push(s, depth, other);
            }
            if (backward(s, at, axis, &other) && (s->open[other] >> axis & 1)) {
                depth = push(s, depth, other);
            }
        }
    }
}

/* ---- points that light reaches ---- */

static void ask_light(void *context, uint64_t batch)
{
    search *s = context;
    const size_t end = batch_end(s, batch);
    for (size_t i = (size_t)batch * BATCH_POINTS; i < end; ++i) {
        if (s->reached[i] || s->closeness[i] == MURK_ON_SURFACE) {
            continue;
        }
        const murk_vec3 point = murk_candidate_grid_point(s->grid, i);
        const murk_vec3 to =
            murk_path_nearest_image(&s->reach->domain, point, s->light);
        if (murk_free_segment_is_open(&s->segments, s->light, to)) {
            s->reached[i] = SEEN_BY_LIGHT;
        }
    }
}

static void ask_sides(void *context, uint64_t batch)
{
    search *s = context;
    const size_t end = batch_end(s, batch);
    for (size_t i = (size_t)batch * BATCH_POINTS; i < end; ++i) {
        if (!s->reached[i] && s->closeness[i] != MURK_ON_SURFACE &&
            murk_free_segment_leads_out(
                &s->segments, murk_candidate_grid_point(s->grid, i))) {
            s->reached[i] = SEEN_BY_LIGHT;
        }
    }
}

static void enter_by(search *s, murk_job ask)
{
    const uint64_t batches = (s->points + BATCH_POINTS - 1) / BATCH_POINTS;
    murk_pool_run(s->threads, batches, ask, s);
    for (size_t i = 0; i < s->points; ++i) {
        if (s->reached[i] == SEEN_BY_LIGHT) {
            flood(s, i);
        }
    }
}

/* ---- doubtful points ---- */

static bool diagonal_is_open(const search *s, size_t point, const int step[3])
{
    size_t other = point;
    for (int axis = 0; axis < 3; ++axis) {
        const size_t at = point / s->stride[axis] % s->grid->size[axis];
        if ((step[axis] < 0 && at == 0) ||
            (step[axis] > 0 && at + 1 == s->grid->size[axis])) {
            return false;
        }
        other += (size_t)step[axis] *
                 s->stride[axis]; /* unsigned arithmetic: the sum is right even
                                     if the step is negative */
    }
    return s->reached[other] &&
           murk_free_segment_is_open(&s->segments,
                                     murk_candidate_grid_point(s->grid, other),
                                     murk_candidate_grid_point(s->grid, point));
}

static bool is_doubtful(const search *s, size_t point)
{
    for (int k = 0; k < 27; ++k) {
        const int step[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        const int along = abs(step[0]) + abs(step[1]) + abs(step[2]);
        if (along >= 2 && diagonal_is_open(s, point, step)) {
            return true;
        }
    }
    return false;
}

static void find_doubtful(void *context, uint64_t batch)
{
    search *s = context;
    const size_t begin = (size_t)batch * BATCH_POINTS;
    const size_t end = batch_end(s, batch);
    for (size_t i = begin; i < end; ++i) {
        s->open[i] = !s->reached[i] && s->closeness[i] != MURK_ON_SURFACE &&
                     is_doubtful(s, i);
    }
    murk_progress_add(end - begin);
}

/* Runs the whole test: distances, steps, lamps, sides, doubtful points. */
static void explore(search *s)
{
    const uint64_t batches = (s->points + BATCH_POINTS - 1) / BATCH_POINTS;
    murk_progress_begin("reach", 3 * (uint64_t)s->points, "points");
    murk_pool_run(s->threads, batches, measure_closeness, s);
    murk_pool_run(s->threads, batches, open_steps, s);
    for (size_t l = 0; l < s->reach->n_lamps && !murk_interrupted(); ++l) {
        murk_vec3 place[MURK_LAMP_PLACES_MAX];
        const size_t n = murk_lamp_places(s->surfaces, &s->reach->domain,
                                          s->reach->lamps[l], place);
        for (size_t i = 0; i < n; ++i) {
            s->light = place[i];
            enter_by(s, ask_light);
        }
    }
    if (s->reach->from_sides) {
        enter_by(s, ask_sides);
    }
    murk_pool_run(s->threads, batches, find_doubtful, s);
    murk_progress_end();
}

murk_status murk_free_space_find(murk_free_space *out,
                                 const murk_candidate_grid *grid,
                                 const murk_surfaces *surfaces,
                                 const murk_reach *reach, unsigned threads,
                                 const char *where, murk_error *err)
{
    const size_t *n = grid->size;
    search s = {.grid = grid,
                .surfaces = surfaces,
                .reach = reach,
                .threads = threads,
                .points = n[0] * n[1] * n[2],
                .stride = {1, n[0], n[0] * n[1]},
                .segments = murk_free_segments_of(surfaces, &reach->domain)};
    /* Allocate, explore, and hand the arrays over; `open` then has the doubtful
     * points. */
    s.closeness = malloc(s.points);
    s.open = malloc(s.points);
    s.reached = calloc(s.points, 1);
    s.stack = malloc(s.points * sizeof *s.stack);
    murk_status status = MURK_OK;
    if (!s.closeness || !s.open || !s.reached || !s.stack) {
        status = murk_fail(err, MURK_NO_MEMORY, where,
                           "no memory for %zu candidates", s.points);
        goto done;
    }
    explore(&s);
    if (murk_interrupted()) {
        status = murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
        goto done;
    }
    *out = (murk_free_space){s.closeness, s.reached, s.open};
    s.closeness = s.reached = s.open = NULL;
done:
    free(s.closeness);
    free(s.open);
    free(s.reached);
    free(s.stack);
    return status;
}

void murk_free_space_release(murk_free_space *space)
{
    free(space->closeness);
    free(space->is_reached);
    free(space->is_doubtful);
    *space = (murk_free_space){0};
}
