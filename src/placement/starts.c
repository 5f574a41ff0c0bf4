/* SPOQ starts followed by relocation, several at once. Each start writes to a
 * place of its own; the results are then accepted in the order of the starts,
 * with the stop rule applied after each. So the plan is the same for any number
 * of threads, and the starts beyond the stop are discarded.
 *
 * Starts that share the passes over the rows advance step by step. In each
 * round every search makes the partial plan of its next step, one pass computes
 * the gains of all candidates over all these plans, and every search moves a
 * sensor. A search that has finished a start begins the next one. */
#include "placement/starts.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "placement/settings.h"

#include <string.h>

/* One start takes about an eighth of the work of all starts at most, so that
 * the limit on work does not end the starts before the eighth (a choice). */
#define STARTS_OF_ALL_WORK 8

/* Starts handed to each thread at once: with fewer, threads wait for the
 * slowest start of a wave; with more, more starts beyond the stop are in vain
 * (a choice). */
#define STARTS_PER_WORKER 4

/* A start that was made, or is being made. */
typedef struct murk_start {
    bool is_begun; /* false: a request to finish came before */
    size_t size;   /* sensors of the plan */
    uint64_t value, evaluations, queries, rows;
} murk_start;

/* The start that a search of a shared pass is making. */
typedef struct shared_climb {
    murk_climb climb;
    bool is_active;
    size_t batch; /* number of the start in the wave */
} shared_climb;

static void run_start(void *context, unsigned worker, uint64_t batch)
{
    murk_starts *t = context;
    murk_gain_scan *s = &t->search[worker];
    if (murk_must_finish()) {
        return;
    }
    uint32_t *plan = t->plan + batch * t->count;
    s->evaluations = s->queries = s->rows = 0;
    s->is_cut = false;
    uint64_t value = murk_search_spoq(s, plan, t->n, t->seed, t->first + batch);
    if (!murk_must_finish()) {
        value = murk_search_relocate(s, plan, s->size);
    }
    t->start[batch] =
        (murk_start){true, s->size, value, s->evaluations, s->queries, s->rows};
}

/* ---- starts that share the passes over the rows ---- */

/* True if the starts of the wave before this one have already spent the work
 * that is left: the start will not be accepted. */
static bool is_in_vain(const murk_starts *t, size_t batch)
{
    uint64_t rows = t->all_rows;
    for (size_t k = 0; k < batch; ++k) {
        rows += t->start[k].rows;
    }
    return rows > murk_gain_scan_rows_max(t->search[0].evaluator);
}

/* Makes the partial plan of the next step of the start: SPOQ, then relocation.
 * False at the end of the start. */
static bool prepare(shared_climb *c, murk_gain_scan *s)
{
    if (murk_climb_prepare(&c->climb, s)) {
        return true;
    }
    if (!c->climb.is_spoq || murk_must_finish()) {
        return false;
    }
    murk_climb_begin_relocation(&c->climb, s, c->climb.plan, s->size);
    return murk_climb_prepare(&c->climb, s);
}

/* Takes the search to the next step, if need be of the next start that is not
 * yet begun. The search is inactive if there is none. */
static void advance(murk_starts *t, shared_climb *c, murk_gain_scan *s,
                    size_t *begun, size_t wave)
{
    while (true) {
        if (c->is_active) {
            const bool has_step = prepare(c, s);
            t->start[c->batch] =
                (murk_start){true,           s->size,    c->climb.value,
                             s->evaluations, s->queries, s->rows};
            if (has_step && !is_in_vain(t, c->batch)) {
                return;
            }
            murk_progress_add(1);
        }
        /* The start has ended, or there was none: begin the next one. */
        c->is_active =
            *begun < wave && !is_in_vain(t, *begun) && !murk_must_finish();
        if (!c->is_active) {
            return;
        }
        c->batch = (*begun)++;
        s->evaluations = s->queries = s->rows = 0;
        s->is_cut = false;
        murk_climb_begin_spoq(&c->climb, s, t->plan + c->batch * t->count, t->n,
                              t->seed, t->first + c->batch);
    }
}

/* Makes all starts of a wave. */
static void run_shared(murk_starts *t, size_t wave)
{
    shared_climb climbs[MURK_COVER_LANES] = {{.is_active = false}};
    const murk_cover *cover[MURK_COVER_LANES];
    size_t begun = 0;
    while (true) {
        /* Prepare the next step of each search. */
        size_t active = 0;
        for (size_t k = 0; k < MURK_COVER_LANES; ++k) {
            advance(t, &climbs[k], &t->search[k], &begun, wave);
            if (climbs[k].is_active) {
                cover[active++] = &t->search[k].cover;
            }
        }
        if (active == 0) {
            return;
        }
        /* One pass for all steps; a few steps are faster alone. */
        const bool is_shared = active >= MURK_LANES_MIN;
        if (is_shared) {
            murk_lanes_gains(&t->lanes, cover, active);
        }
        for (size_t k = 0, lane = 0; k < MURK_COVER_LANES; ++k) {
            if (climbs[k].is_active) {
                murk_gain_scan *s = &t->search[k];
                s->known = is_shared ? t->lanes.gain + lane++ : NULL;
                s->known_step = MURK_COVER_LANES;
                murk_climb_move(&climbs[k].climb, s);
                s->known = NULL;
            }
        }
    }
}

/* The number of searches, and of the threads of each. If rows are asked of the
 * problem or of other ranks, which is done by one thread, and for long scans,
 * threads share each scan; so they do if searches share the passes. Otherwise
 * each thread makes a start of its own. */
static void choose_searches(murk_starts *t, const murk_evaluator *evaluator,
                            unsigned *searches, unsigned *threads)
{
    const unsigned all = evaluator->problem->threads;
    const bool is_wide = !evaluator->has_all_rows ||
                         murk_evaluator_threads(evaluator, MURK_SCAN_CHUNK) > 1;
    t->has_lanes = murk_lanes_pay(evaluator);
    *searches = t->has_lanes ? MURK_COVER_LANES : is_wide ? 1 : all;
    *threads = t->has_lanes || is_wide ? all : 1;
    /* In shared passes no start of a wave is in vain: with fewer starts the
     * stop rule cannot end them. */
    t->wave_max = t->has_lanes    ? MURK_STARTS_WITHOUT_GAIN
                  : *searches > 1 ? *searches * STARTS_PER_WORKER
                                  : 1;
}

murk_status murk_starts_init(murk_starts *t, const murk_evaluator *evaluator,
                             size_t count, uint32_t seed, murk_error *err)
{
    *t = (murk_starts){.seed = seed, .count = count};
    unsigned searches, threads;
    choose_searches(t, evaluator, &searches, &threads);
    t->search = murk_arena_array(&t->arena, searches, sizeof *t->search);
    t->plan = murk_arena_array(&t->arena, t->wave_max * count, sizeof *t->plan);
    t->start = murk_arena_array(&t->arena, t->wave_max, sizeof *t->start);
    if (t->arena.is_short) {
        return murk_no_memory(err, "", "for %zu sensors", count);
    }
    murk_status status =
        t->has_lanes ? murk_lanes_init(&t->lanes, evaluator, err) : MURK_OK;
    for (; t->searches < searches && !status; ++t->searches) {
        murk_gain_scan *s = &t->search[t->searches];
        const unsigned worker = t->has_lanes ? 0 : t->searches;
        status = murk_gain_scan_init(s, evaluator, worker, threads, err);
        /* a single start must not take all the work */
        s->rows_max = murk_gain_scan_rows_max(evaluator) / STARTS_OF_ALL_WORK;
    }
    return status;
}

void murk_starts_release(murk_starts *t)
{
    for (unsigned k = 0; k < t->searches; ++k) {
        murk_gain_scan_release(&t->search[k]);
    }
    murk_lanes_release(&t->lanes);
    murk_arena_release(&t->arena);
}

uint64_t murk_starts_try(murk_starts *t, const murk_gain_scan *search,
                         uint32_t *plan, size_t *size, size_t n, uint64_t value,
                         uint64_t upper, size_t max, size_t *made)
{
    size_t without_gain = 0, done = 0;
    t->n = n;
    for (unsigned k = 0; k < t->searches; ++k) {
        t->search[k].fallback = search->fallback;
        t->search[k].fallback_size = search->fallback_size;
    }
    const uint64_t rows_max = murk_gain_scan_rows_max(t->search[0].evaluator);
    while (done < max && without_gain < MURK_STARTS_WITHOUT_GAIN &&
           value < upper && t->all_rows <= rows_max && !murk_must_finish()) {
        const size_t left = max - done;
        const size_t wanted =
            t->has_lanes ? t->wave_max - without_gain : t->wave_max;
        const size_t wave = left < wanted ? left : wanted;
        t->first = done;
        /* Make a wave of starts. */
        memset(t->start, 0, wave * sizeof *t->start);
        if (t->has_lanes) {
            run_shared(t, wave);
        } else if (t->searches > 1) {
            murk_pool_run_workers(t->searches, wave, run_start, t);
        } else {
            run_start(t, 0, 0);
        }
        /* Accept the starts in order. */
        for (size_t k = 0;
             k < wave && without_gain < MURK_STARTS_WITHOUT_GAIN &&
             value < upper && t->all_rows <= rows_max;
             ++k) {
            const murk_start *start = &t->start[k];
            if (!start->is_begun) {
                break;
            }
            ++done;
            ++without_gain;
            t->all_evaluations += start->evaluations;
            t->all_queries += start->queries;
            t->all_rows += start->rows;
            if (start->value > value) {
                value = start->value;
                *size = start->size;
                memcpy(plan, t->plan + k * t->count, *size * sizeof *plan);
                without_gain = 0;
            }
        }
        murk_progress_add(t->has_lanes ? 0 : wave);
    }
    *made += done;
    t->is_cut = t->is_cut || t->all_rows > rows_max;
    return value;
}
