/* Sums weights and covered weights of the records, with derivatives, in
 * parallel over runs of batches. Each run writes only its own sums. */
#include "calibrate/coverage_sums.h"

#include "base/interrupt.h"
#include "base/pool.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The batches of a run. */
static void run_of(const murk_coverage_sums *r, size_t run, size_t *first,
                   size_t *last)
{
    *first = run * r->batches / r->runs;
    *last = (run + 1) * r->batches / r->runs;
}

/* Adds to slope[keys] the derivatives of the weight of a contribution times a
 * factor. */
static void add_slopes(double *slope, const murk_coverage_sums *r,
                       size_t contribution, double factor)
{
    const double *of = r->reweighed->slope + contribution;
    for (size_t k = 0; k < r->keys; ++k) {
        if (r->has_say[k]) {
            slope[k] += factor * of[k * r->reweighed->n];
        }
    }
}

/* The runs that are summed here, and how many they are. */
static size_t first_run(const murk_coverage_sums *r)
{
    return murk_reweighed_first_run(r->reweighed, r->runs);
}
static size_t own_runs(const murk_coverage_sums *r)
{
    return murk_reweighed_end_run(r->reweighed, r->runs) - first_run(r);
}

/* Sums the weights of the records of a run, and the derivatives of the
 * weights. */
static void sum_all(void *context, uint64_t number)
{
    murk_coverage_sums *r = context;
    const size_t run = first_run(r) + (size_t)number;
    const murk_visible *visible = r->visible;
    double *slope = r->all_slope + run * MURK_MAP_PARTS * r->keys;
    size_t first, last;
    run_of(r, run, &first, &last);
    for (size_t b = first; b < last; ++b) {
        for (size_t i = r->bound[b]; i < r->bound[b + 1]; ++i) {
            if (visible->worth_w[i] > 0) {
                const size_t map = visible->kind[i] & 1;
                r->all[b * MURK_MAP_PARTS + map] +=
                    visible->worth_w[i] * r->reweighed->ratio[i];
                add_slopes(slope + map * r->keys, r, i, visible->worth_w[i]);
            }
        }
    }
}

/* Combines the transmittances through[n] of one record into the clarity D, as
 * the mode of detection asks, and sets by[n] to the derivatives of D. */
static double combine(const murk_coverage_sums *r, const double *through,
                      size_t n, double *by)
{
    /* Independent detections: D = 1 - product of (1 - T). The derivative by T
     * of one sightline is the product of the factors of all others: the first
     * loop multiplies those before, the second those after. */
    double before = 1, after = 1;
    if (r->combining == MURK_COMBINE_INDEPENDENT) {
        for (size_t j = 0; j < n; ++j) {
            by[j] = before;
            before *= 1 - through[j];
        }
        for (size_t j = n; j-- > 0;) {
            by[j] *= after;
            after *= 1 - through[j];
        }
        return 1 - before;
    }
    /* Otherwise: the mean of the clearest `redundancy` sightlines; sightlines
     * that a record lacks count as 0. */
    memset(by, 0, n * sizeof *by);
    const double each = 1 / (double)r->redundancy;
    double sum = 0;
    for (size_t k = 0; k < r->redundancy && k < n; ++k) {
        size_t best = n;
        for (size_t j = 0; j < n; ++j) {
            if (by[j] == 0 && (best == n || through[j] > through[best])) {
                best = j;
            }
        }
        by[best] = each;
        sum += each * through[best];
    }
    return sum;
}

/* The row of the extinctions that sightline i needs: acceptance and band. */
static size_t row_of(const murk_coverage_sums *r, const murk_sightlines *lines,
                     size_t i)
{
    const size_t a =
        lines->acceptance ? lines->acceptance[i] : lines->acceptance_all;
    return a * r->bands + (r->visible->kind[lines->contribution[i]] >> 1);
}

/* The transmittance of sightline i. */
static double through_of(const murk_coverage_sums *r,
                         const murk_sightlines *lines, size_t i)
{
    const size_t media = r->visible->media;
    const double *extinction = r->extinction + row_of(r, lines, i) * media;
    double depth = 0;
    for (size_t m = 0; m < media; ++m) {
        depth += extinction[m] * (double)lines->path_m[i * media + m];
    }
    return (lines->rest ? (double)lines->rest[i] : 1) * exp(-depth);
}

/* Scratch arrays of a run. */
typedef struct scratch {
    double *through, *by; /* [max]; for the sightlines of one record */
    double *less;         /* [MURK_MAP_PARTS][cells]; sum of w (dD/dT) T path */
} scratch;

/* Adds the record whose sightlines are [i, end). */
static void add_record(const murk_coverage_sums *r,
                       const murk_sightlines *lines, size_t i, size_t end,
                       scratch *s, double seen_by[MURK_MAP_PARTS],
                       double *slope)
{
    const murk_visible *visible = r->visible;
    const size_t media = visible->media;
    const size_t contribution = lines->contribution[i];
    const size_t map = visible->kind[contribution] & 1;
    const double worth_w = visible->worth_w[contribution];
    /* Weight, transmittances, combined clarity. */
    const double w = worth_w * r->reweighed->ratio[contribution];
    for (size_t j = i; j < end; ++j) {
        s->through[j - i] = through_of(r, lines, j);
    }
    const double clarity = combine(r, s->through, end - i, s->by);
    seen_by[map] += w * clarity;
    add_slopes(slope + map * r->keys, r, contribution, worth_w * clarity);
    double *less = s->less + map * murk_coverage_cells(r);
    /* Sums of w (dD/dT) T path; sum_seen() multiplies them by the derivatives
     * of the extinctions. */
    for (size_t j = i; j < end; ++j) {
        const double factor = w * s->by[j - i] * s->through[j - i];
        double *row = less + row_of(r, lines, j) * media;
        for (size_t m = 0; factor > 0 && m < media; ++m) {
            row[m] += factor * (double)lines->path_m[j * media + m];
        }
    }
}

/* The first sightline of a contribution, or of the next one that has any. */
static size_t first_at_least(const murk_sightlines *lines, size_t contribution)
{
    size_t low = 0, high = lines->n;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (lines->contribution[middle] < contribution) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/* Sums the covered weights of one group in one run. */
static void sum_seen(void *context, uint64_t number)
{
    murk_coverage_sums *r = context;
    const size_t group = (size_t)number / own_runs(r);
    const size_t run = first_run(r) + (size_t)number % own_runs(r);
    const murk_sightlines *lines = &r->visible->of[group];
    const size_t cells = murk_coverage_cells(r);
    double *slope =
        r->in_view_slope + (group * r->runs + run) * MURK_MAP_PARTS * r->keys;
    /* Scratch arrays. */
    scratch s = {.through = malloc(lines->max * sizeof *s.through + 1),
                 .by = malloc(lines->max * sizeof *s.by + 1),
                 .less = calloc(MURK_MAP_PARTS * cells + 1, sizeof *s.less)};
    /* Add the records of each batch; sightlines are sorted by record. */
    size_t first, last;
    run_of(r, run, &first, &last);
    size_t i = first_at_least(lines, r->bound[first]);
    const bool has_memory = s.through && s.by && s.less;
    for (size_t b = first; has_memory && b < last; ++b) {
        double *seen_by =
            r->in_view + (group * r->batches + b) * MURK_MAP_PARTS;
        while (i < lines->n && lines->contribution[i] < r->bound[b + 1]) {
            size_t end = i + 1;
            while (end < lines->n &&
                   lines->contribution[end] == lines->contribution[i]) {
                ++end;
            }
            add_record(r, lines, i, end, &s, seen_by, slope);
            i = end;
        }
    }
    /* Apply the derivatives of the extinctions. */
    for (size_t map = 0; has_memory && map < MURK_MAP_PARTS; ++map) {
        for (size_t k = 0; k < r->keys; ++k) {
            for (size_t cell = 0; cell < cells; ++cell) {
                slope[map * r->keys + k] -=
                    r->steepness[k * cells + cell] * s.less[map * cells + cell];
            }
        }
    }
    murk_tally_add(&r->failures, !has_memory);
    free(s.through);
    free(s.by);
    free(s.less);
}

bool murk_coverage_sums_allocate(murk_coverage_sums *s)
{
    const size_t cells = murk_coverage_cells(s), groups = s->visible->groups;
    const size_t maps = MURK_MAP_PARTS, size = sizeof(double);
    murk_arena *arena = &s->arena;
    s->has_say = murk_arena_array(arena, s->keys, sizeof *s->has_say);
    s->bound = murk_arena_array(arena, s->batches + 1, sizeof *s->bound);
    s->extinction = murk_arena_array(arena, cells, size);
    s->steepness = murk_arena_array(arena, s->keys * cells, size);
    s->all = murk_arena_array(arena, s->batches * maps, size);
    s->all_slope = murk_arena_array(arena, s->runs * maps * s->keys, size);
    s->in_view = murk_arena_array(arena, groups * s->batches * maps, size);
    s->in_view_slope =
        murk_arena_array(arena, groups * s->runs * maps * s->keys, size);
    return !arena->is_short;
}

void murk_coverage_sums_release(murk_coverage_sums *s)
{
    murk_arena_release(&s->arena);
}

size_t murk_coverage_cells(const murk_coverage_sums *sums)
{
    return sums->visible->acceptances * sums->bands * sums->visible->media;
}

murk_status murk_coverage_sums_add(murk_coverage_sums *s, unsigned threads,
                                   murk_error *err)
{
    const size_t groups = s->visible->groups;
    murk_pool_run(threads, own_runs(s), sum_all, s);
    murk_pool_run(threads, groups * own_runs(s), sum_seen, s);
    murk_status status = murk_interrupt_check(err);
    if (!status && murk_tally_read(&s->failures)) {
        status =
            murk_no_memory(err, "", "for the coverage of %zu groups", groups);
    }
    if (s->reweighed->is_divided) {
        /* Sums of other ranks are 0 here. */
        const size_t maps = MURK_MAP_PARTS * sizeof(double);
        const size_t slopes = s->runs * maps * s->keys;
        status = murk_ranks_complete(s->all, s->batches * maps, status, err);
        status = murk_ranks_complete(s->all_slope, slopes, status, err);
        status = murk_ranks_complete(s->in_view, groups * s->batches * maps,
                                     status, err);
        status =
            murk_ranks_complete(s->in_view_slope, groups * slopes, status, err);
    }
    return status;
}
