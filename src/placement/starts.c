/* SPOQ starts followed by relocation, several at once. Each start writes to a
 * place of its own; the results are then accepted in the order of the starts,
 * with the stop rule applied after each. So the plan is the same for any number
 * of threads, and the starts beyond the stop are discarded. */
#include "placement/starts.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "placement/settings.h"

#include <stdlib.h>
#include <string.h>

/* One start takes at most an eighth of the work of all starts, so that at least
 * eight are made (a choice). */
#define STARTS_OF_ALL_WORK 8

/* Starts handed to each thread at once: with fewer, threads wait for the start
 * of the others; with more, more starts beyond the stop are in vain (a choice).
 */
#define STARTS_PER_WORKER 4

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
    t->size[batch] = s->size;
    t->value[batch] = value;
    t->evaluations[batch] = s->evaluations;
    t->rows[batch] = s->rows;
    t->queries[batch] = s->queries;
}

murk_status murk_starts_init(murk_starts *t, const murk_evaluator *evaluator,
                             size_t count, uint32_t seed, murk_error *err)
{
    /* In an unknown environment, and for long scans, threads share each scan.
     * Otherwise each thread makes a start of its own. */
    const unsigned threads = evaluator->problem->threads;
    const bool is_wide = !evaluator->matrix ||
                         murk_evaluator_threads(evaluator, MURK_SCAN_CHUNK) > 1;
    const unsigned workers = is_wide ? 1 : threads;
    const size_t wave = workers > 1 ? workers * STARTS_PER_WORKER : 1;
    *t = (murk_starts){.seed = seed,
                       .count = count,
                       .search = calloc(workers, sizeof *t->search),
                       .wave_max = wave,
                       .plan = calloc(wave * count, sizeof *t->plan),
                       .size = calloc(wave, sizeof *t->size),
                       .value = calloc(wave, sizeof *t->value),
                       .evaluations = calloc(wave, sizeof *t->evaluations),
                       .queries = calloc(wave, sizeof *t->queries),
                       .rows = calloc(wave, sizeof *t->rows)};
    if (!t->search || !t->plan || !t->size || !t->value || !t->evaluations ||
        !t->queries || !t->rows) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for %zu sensors",
                         count);
    }
    murk_status status = MURK_OK;
    /* a single start must not take all the work */
    const uint64_t rows_max =
        murk_gain_scan_rows_max(evaluator) / STARTS_OF_ALL_WORK;
    for (; t->workers < workers && !status; ++t->workers) {
        status = murk_gain_scan_init(&t->search[t->workers], evaluator,
                                     t->workers, is_wide ? threads : 1, err);
    }
    for (unsigned k = 0; k < t->workers && !status; ++k) {
        t->search[k].rows_max = rows_max;
    }
    return status;
}

void murk_starts_release(murk_starts *t)
{
    for (unsigned k = 0; k < t->workers; ++k) {
        murk_gain_scan_release(&t->search[k]);
    }
    free(t->search);
    free(t->plan);
    free(t->size);
    free(t->value);
    free(t->evaluations);
    free(t->queries);
    free(t->rows);
}

void murk_starts_set_fallback(murk_starts *t, const uint32_t *plan, size_t size)
{
    for (unsigned k = 0; k < t->workers; ++k) {
        t->search[k].fallback = plan;
        t->search[k].fallback_size = size;
    }
}

uint64_t murk_starts_try(murk_starts *t, uint32_t *plan, size_t *size, size_t n,
                         uint64_t value, uint64_t upper, size_t max,
                         size_t *made)
{
    size_t without_gain = 0, done = 0;
    t->n = n;
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
            t->all_evaluations += t->evaluations[k];
            t->all_queries += t->queries[k];
            t->all_rows += t->rows[k];
            if (t->value[k] > value) {
                value = t->value[k];
                *size = t->size[k];
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
