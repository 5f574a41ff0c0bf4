/* A* search for the shortest path, with lazy evaluation of steps: steps enter a
 * priority queue (binary heap) by a lower bound on the length of a path that
 * uses the step, and the line of a step is tested for surfaces when the step
 * leaves the queue. The bound is the length of the path to the end of the step
 * plus the straight-line distance from there to the goal, an admissible
 * heuristic. */
#include "plan/explored.h"

#include <math.h>
#include <stdlib.h>

#define NOWHERE SIZE_MAX /* the predecessor of a place that is not reached */

/* A step whose line is not yet tested, to a place that was not yet reached when
 * the step was added. */
typedef struct step {
    double whole_m; /* lower bound on the length of a path that uses the step */
    double gone_m;  /* length from the start to the end of the step */
    uint32_t from, to;
} step;

typedef struct search {
    murk_outlook *outlook;
    const murk_vec3 *place;
    size_t n, goal;
    size_t *before; /* [n]; predecessor on the shortest path; NOWHERE: not
                     * reached */
    double *gone_m; /* [n]; length from the start */
    step *heap;     /* binary heap, smallest first */
    size_t steps, capacity;
} search;

/* The order of steps in the heap. It is a total order, so that of paths of
 * equal length the same path is found on every machine. */
static bool is_less(const step *a, const step *b)
{
    if (a->whole_m != b->whole_m) {
        return a->whole_m < b->whole_m;
    }
    if (a->gone_m != b->gone_m) {
        return a->gone_m > b->gone_m;
    }
    return a->to != b->to ? a->to < b->to : a->from < b->from;
}

static void swap(step *a, step *b)
{
    const step c = *a;
    *a = *b;
    *b = c;
}

/* Adds a step to the heap; false when out of memory. */
static bool push(search *s, step new)
{
    if (s->steps == s->capacity) {
        const size_t capacity = 2 * s->capacity + 1024;
        step *heap = realloc(s->heap, capacity * sizeof *heap);
        if (!heap) {
            return false;
        }
        s->heap = heap;
        s->capacity = capacity;
    }
    size_t at = s->steps++;
    s->heap[at] = new;
    for (; at > 0 && is_less(&s->heap[at], &s->heap[(at - 1) / 2]);
         at = (at - 1) / 2) {
        swap(&s->heap[at], &s->heap[(at - 1) / 2]);
    }
    return true;
}

/* Removes the smallest step from the heap. */
static step pop(search *s)
{
    const step min = s->heap[0];
    s->heap[0] = s->heap[--s->steps];
    for (size_t at = 0;;) {
        size_t below = 2 * at + 1;
        if (below + 1 < s->steps &&
            is_less(&s->heap[below + 1], &s->heap[below])) {
            ++below;
        }
        if (below >= s->steps || !is_less(&s->heap[below], &s->heap[at])) {
            return min;
        }
        swap(&s->heap[at], &s->heap[below]);
        at = below;
    }
}

static double distance(const search *s, size_t a, size_t b)
{
    return murk_length(murk_sub(s->place[a], s->place[b]));
}

static bool is_open(const search *s, size_t a, size_t b)
{
    return murk_outlook_is_open(s->outlook, s->place[a], s->place[b]);
}

/* Adds the steps from the reached place `from` to all places that are not
 * reached; false when out of memory. */
static bool push_steps(search *s, size_t from)
{
    for (size_t to = 0; to < s->n; ++to) {
        if (s->before[to] == NOWHERE) {
            const double gone = s->gone_m[from] + distance(s, from, to);
            const step new = {gone + distance(s, to, s->goal), gone,
                              (uint32_t)from, (uint32_t)to};
            if (!push(s, new)) {
                return false;
            }
        }
    }
    return true;
}

/* Searches until the goal is reached or no step is left; false when out of
 * memory. */
static bool find_goal(search *s, size_t from)
{
    s->before[from] = from;
    bool has_memory = push_steps(s, from);
    while (has_memory && s->steps > 0 && s->before[s->goal] == NOWHERE) {
        const step next = pop(s);
        if (s->before[next.to] == NOWHERE && is_open(s, next.from, next.to)) {
            s->before[next.to] = next.from;
            s->gone_m[next.to] = next.gone_m;
            has_memory = next.to == s->goal || push_steps(s, next.to);
        }
    }
    return has_memory;
}

/* Writes the path to stop[] and returns the number of stops: follows the
 * predecessors from the goal, reverses the order, and leaves out places that a
 * straight step between their neighbours bypasses. */
static size_t read_path(const search *s, size_t from, size_t *stop)
{
    /* Follow the predecessors. */
    size_t n = 0;
    for (size_t at = s->goal; at != from; at = s->before[at]) {
        stop[n++] = at;
    }
    stop[n++] = from;
    /* Reverse. */
    for (size_t k = 0; k < n / 2; ++k) {
        const size_t other = stop[k];
        stop[k] = stop[n - 1 - k];
        stop[n - 1 - k] = other;
    }
    /* Leave out places that are not needed. */
    size_t needed = 1;
    for (size_t k = 1; k < n; ++k) {
        const bool is_needed =
            k + 1 == n || !is_open(s, stop[needed - 1], stop[k + 1]);
        if (is_needed) {
            stop[needed++] = stop[k];
        }
    }
    return needed;
}

murk_status murk_route_find(size_t *stop, size_t *stops, double *length_m,
                            murk_outlook *outlook, const murk_vec3 *place,
                            size_t n, size_t from, size_t to, murk_error *err)
{
    search s = {.outlook = outlook, .place = place, .n = n, .goal = to};
    *stops = 0;
    *length_m = 0;
    /* A path to the same place has one stop. */
    if (from == to) {
        stop[(*stops)++] = from;
        return MURK_OK;
    }
    /* Allocate; no place is reached. */
    s.before = malloc(n * sizeof *s.before);
    s.gone_m = calloc(n, sizeof *s.gone_m);
    murk_status status = MURK_OK;
    if (s.before && s.gone_m) {
        for (size_t k = 0; k < n; ++k) {
            s.before[k] = NOWHERE;
        }
        /* First test the straight line to the goal, which is unobstructed in
         * most cases. */
        if (is_open(&s, from, to)) {
            s.before[to] = from;
        }
    }
    /* Otherwise search. */
    if (!s.before || !s.gone_m ||
        (s.before[to] == NOWHERE && !find_goal(&s, from))) {
        status = murk_no_memory(err, "", "for a way over %zu places", n);
        goto done;
    }
    /* Read the path and measure it. */
    if (s.before[to] != NOWHERE) {
        *stops = read_path(&s, from, stop);
    }
    for (size_t k = 1; k < *stops; ++k) {
        *length_m += distance(&s, stop[k - 1], stop[k]);
    }
done:
    free(s.heap);
    free(s.before);
    free(s.gone_m);
    return status;
}
