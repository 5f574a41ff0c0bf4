/* SPOQ starts followed by relocation, several at once. Each start writes to a
 * place of its own; the results are then accepted in the order of the starts,
 * with the stop rule applied after each. So the plan is the same for any number
 * of threads, and the starts beyond the stop are discarded. */
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

/* A start that was made. */
typedef struct murk_start {
    size_t size; /* sensors of the plan */
    uint64_t value, evaluations, queries, rows;
} murk_start;

static void run_start(void *context, unsigned worker, uint64_t batch)
{
    murk_starts *t = context;
    murk_gain_scan *s = &t->search[worker];
    uint32_t *plan = t->plan + batch * t->count;
    s->evaluations = s->queries = s->rows = 0;
    s->is_cut = false;
    uint64_t value = murk_search_spoq(s, plan, t->n, t->seed, t->first + batch);
    if (!murk_interrupted()) {
        value = murk_search_relocate(s, plan, s->size);
    }
    t->start[batch] =
        (murk_start){s->size, value, s->evaluations, s->queries, s->rows};
}

murk_status murk_starts_init(murk_starts *t, const murk_evaluator *evaluator,
                             size_t count, uint32_t seed, murk_error *err)
{
    /* If rows are asked of the problem, and for long scans, threads share each
     * scan. Otherwise each thread makes a start of its own. */
    const unsigned threads = evaluator->problem->threads;
    const bool is_wide = !evaluator->has_all_rows ||
                         murk_evaluator_threads(evaluator, MURK_SCAN_CHUNK) > 1;
    const unsigned workers = is_wide ? 1 : threads;
    const size_t wave = workers > 1 ? workers * STARTS_PER_WORKER : 1;
    *t = (murk_starts){.seed = seed, .count = count, .wave_max = wave};
    t->search = murk_arena_array(&t->arena, workers, sizeof *t->search);
    t->plan = murk_arena_array(&t->arena, wave * count, sizeof *t->plan);
    t->start = murk_arena_array(&t->arena, wave, sizeof *t->start);
    if (t->arena.is_short) {
        return murk_no_memory(err, "", "for %zu sensors", count);
    }
    murk_status status = MURK_OK;
    for (; t->workers < workers && !status; ++t->workers) {
        murk_gain_scan *s = &t->search[t->workers];
        status = murk_gain_scan_init(s, evaluator, t->workers,
                                     is_wide ? threads : 1, err);
        /* a single start must not take all the work */
        s->rows_max = murk_gain_scan_rows_max(evaluator) / STARTS_OF_ALL_WORK;
    }
    return status;
}

void murk_starts_release(murk_starts *t)
{
    for (unsigned k = 0; k < t->workers; ++k) {
        murk_gain_scan_release(&t->search[k]);
    }
    murk_arena_release(&t->arena);
}

uint64_t murk_starts_try(murk_starts *t, const murk_gain_scan *search,
                         uint32_t *plan, size_t *size, size_t n, uint64_t value,
                         uint64_t upper, size_t max, size_t *made)
{
    size_t without_gain = 0, done = 0;
    t->n = n;
    for (unsigned k = 0; k < t->workers; ++k) {
        t->search[k].fallback = search->fallback;
        t->search[k].fallback_size = search->fallback_size;
    }
    const uint64_t rows_max = murk_gain_scan_rows_max(t->search[0].evaluator);
    while (done < max && without_gain < MURK_STARTS_WITHOUT_GAIN &&
           value < upper && t->all_rows <= rows_max && !murk_interrupted()) {
        const size_t left = max - done;
        const size_t wave = left < t->wave_max ? left : t->wave_max;
        t->first = done;
        /* Make a wave of starts. */
        if (t->workers > 1) {
            murk_pool_run_workers(t->workers, wave, run_start, t);
        } else {
            run_start(t, 0, 0);
        }
        /* Accept the starts in order. */
        for (size_t k = 0;
             k < wave && without_gain < MURK_STARTS_WITHOUT_GAIN &&
             value < upper && t->all_rows <= rows_max;
             ++k) {
            ++done;
            ++without_gain;
            const murk_start *start = &t->start[k];
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
        murk_progress_add(wave);
    }
    *made += done;
    t->is_cut = t->is_cut || t->all_rows > rows_max;
    return value;
}
