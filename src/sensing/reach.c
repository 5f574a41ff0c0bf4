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
#include "sensing/lamp.h"

#include <stdlib.h>

/* Grid points that a thread takes at a time (a choice). */
#define BATCH_POINTS 1024

enum reached {
    UNREACHED,
    SEEN_BY_LIGHT, /* reached, but not yet expanded */
    REACHED
};

typedef struct search {
    const murk_candidate_grid *grid;
    murk_free_space *space;
    const murk_free_segments *segments; /* those of space */
    const murk_domain *domain;
    unsigned threads;
    size_t points;
    size_t stride[3];
    uint8_t *closeness, *reached; /* those of space */
    uint8_t *open; /* bit `axis`: the step to the next point along the axis is
                      open */
    uint32_t *stack;
    murk_vec3 light; /* the place of light under test */
} search;

static void measure_closeness(void *context, uint64_t i)
{
    search *s = context;
    s->closeness[i] = (uint8_t)murk_free_segments_closeness(
        s->segments, murk_candidate_grid_point(s->grid, i),
        s->grid->clearance_m, NULL);
    murk_progress_add(1);
}

/* ---- steps between neighbours ---- */

/* The next point along the axis, upwards or downwards, that is not on a
 * surface; *wraps tells whether the step crosses a periodic side. False if
 * there is no such point. Points on a surface are skipped, so a transmitting
 * sheet in a plane of the grid can be crossed like any other sheet. */
static bool step_along(const search *s, size_t point, int axis, bool is_up,
                       size_t *next, bool *wraps)
{
    const size_t n = s->grid->size[axis];
    const size_t at = point / s->stride[axis] % n;
    const size_t base = point - at * s->stride[axis];
    const bool may_wrap = s->domain->is_periodic && axis < 2;
    for (size_t step = 1; step < n; ++step) {
        *wraps = is_up ? at + step >= n : step > at;
        if (*wraps && !may_wrap) {
            return false;
        }
        *next =
            base + (is_up ? at + step : at + n - step) % n * s->stride[axis];
        if (s->closeness[*next] != MURK_ON_SURFACE) {
            return true;
        }
    }
    return false;
}

static bool step_is_open(const search *s, size_t point, int axis)
{
    size_t next;
    bool wraps;
    if (!step_along(s, point, axis, true, &next, &wraps)) {
        return false;
    }
    const murk_vec3 from = murk_candidate_grid_point(s->grid, point);
    murk_vec3 to = murk_candidate_grid_point(s->grid, next);
    if (wraps) {
        const murk_box *box = &s->domain->box;
        to.x += axis == 0 ? box->max.x - box->min.x : 0;
        to.y += axis == 1 ? box->max.y - box->min.y : 0;
    }
    return murk_free_segment_is_open(s->segments, from, to);
}

static void open_steps(void *context, uint64_t i)
{
    search *s = context;
    for (int axis = 0; axis < 3 && s->closeness[i] != MURK_ON_SURFACE; ++axis) {
        if (step_is_open(s, i, axis)) {
            s->open[i] |= (uint8_t)(1u << axis);
        }
    }
    murk_progress_add(1);
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
                step_along(s, at, axis, true, &other, &wraps)) {
                depth = push(s, depth, other);
            }
            if (step_along(s, at, axis, false, &other, &wraps) &&
                (s->open[other] >> axis & 1)) {
                depth = push(s, depth, other);
            }
        }
    }
}

/* ---- points that light reaches ---- */

static void ask_light(void *context, uint64_t i)
{
    search *s = context;
    if (s->reached[i] || s->closeness[i] == MURK_ON_SURFACE) {
        return;
    }
    const murk_vec3 to = murk_path_nearest_image(
        s->domain, murk_candidate_grid_point(s->grid, i), s->light);
    if (murk_free_segment_is_open(s->segments, s->light, to)) {
        s->reached[i] = SEEN_BY_LIGHT;
    }
}

static void ask_sides(void *context, uint64_t i)
{
    search *s = context;
    if (!s->reached[i] && s->closeness[i] != MURK_ON_SURFACE &&
        murk_free_segment_leads_out(s->segments,
                                    murk_candidate_grid_point(s->grid, i))) {
        s->reached[i] = SEEN_BY_LIGHT;
    }
}

static void enter_by(search *s, murk_job ask)
{
    murk_pool_run_items(s->threads, s->points, BATCH_POINTS, ask, s);
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
           murk_free_segment_is_open(s->segments,
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

static void find_doubtful(void *context, uint64_t i)
{
    search *s = context;
    s->space->is_doubtful[i] = !s->reached[i] &&
                               s->closeness[i] != MURK_ON_SURFACE &&
                               is_doubtful(s, i);
    murk_progress_add(1);
}

/* Runs the whole test: distances, steps, lamps, sides, doubtful points. */
static void explore(search *s)
{
    murk_progress_begin("reach", 3 * (uint64_t)s->points, "points");
    murk_pool_run_items(s->threads, s->points, BATCH_POINTS, measure_closeness,
                        s);
    murk_pool_run_items(s->threads, s->points, BATCH_POINTS, open_steps, s);
    for (size_t i = 0; i < s->space->places && !murk_interrupted(); ++i) {
        s->light = s->space->place[i];
        enter_by(s, ask_light);
    }
    if (s->space->reach->from_sides) {
        enter_by(s, ask_sides);
    }
    murk_pool_run_items(s->threads, s->points, BATCH_POINTS, find_doubtful, s);
    murk_progress_end();
}

murk_status murk_free_space_find(murk_free_space *out,
                                 const murk_candidate_grid *grid,
                                 const murk_surfaces *surfaces,
                                 const murk_reach *reach, unsigned threads,
                                 const char *where, murk_error *err)
{
    const size_t *size = grid->size, n = size[0] * size[1] * size[2];
    /* Allocate the result and the buffers of the search. */
    *out = (murk_free_space){
        .segments = murk_free_segments_of(surfaces, &reach->domain),
        .reach = reach,
        .place = malloc((reach->n_lamps * MURK_LAMP_PLACES_MAX + 1) *
                        sizeof *out->place),
        .closeness = malloc(n),
        .is_reached = calloc(n, 1),
        .is_doubtful = calloc(n, 1)};
    search s = {.grid = grid,
                .space = out,
                .segments = &out->segments,
                .domain = &reach->domain,
                .threads = threads,
                .points = n,
                .stride = {1, size[0], size[0] * size[1]},
                .closeness = out->closeness,
                .reached = out->is_reached,
                .open = calloc(n, 1),
                .stack = malloc(n * sizeof *s.stack)};
    murk_status status = MURK_OK;
    if (!out->place || !out->closeness || !out->is_reached ||
        !out->is_doubtful || !s.open || !s.stack) {
        status = murk_no_memory(err, where, "for %zu candidates", n);
        goto done;
    }
    /* List the places of light, and explore. */
    for (size_t i = 0; i < reach->n_lamps; ++i) {
        out->places +=
            murk_lamp_places(surfaces, &reach->domain, reach->lamps[i],
                             out->place + out->places);
    }
    explore(&s);
    status = murk_interrupt_check(err);
done:
    free(s.open);
    free(s.stack);
    return status;
}

void murk_free_space_release(murk_free_space *space)
{
    free(space->place);
    free(space->closeness);
    free(space->is_reached);
    free(space->is_doubtful);
    *space = (murk_free_space){0};
}
