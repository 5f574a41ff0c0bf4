/* Tallies: prepares planes, spheres and grids for scoring, gives each thread a
 * scorer, and reads values with their standard errors by emitted photon from
 * integer sums. */
#include "transport/tallies.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "transport/score.h"

/* The largest memory of several copies of the sums; a single copy may be
 * larger. Beyond that, memory costs more than the waiting of threads for each
 * other, because with so many sums threads seldom meet. */
#define COPIES_BYTES 64e6

/* Bytes of the sums of a cell and channel: both halves. */
#define SUMS_BYTES (2 * sizeof(murk_tally_bin))

/* Bytes of a line of the cache of most processors. */
#define CACHE_LINE 64

/* Bytes of a voxel of one band during writing: the float, the place in a tree
 * of voxels, and twice the bytes of the file. */
#define WRITTEN_BYTES 16

static size_t scorers_of(unsigned threads)
{
    return threads > 1 ? threads : 1;
}

static size_t copies_of(double cells, size_t channels, unsigned threads)
{
    const double copy_bytes = cells * (double)channels * SUMS_BYTES;
    const double copies = floor(COPIES_BYTES / copy_bytes);
    const double maximum = (double)scorers_of(threads);
    return copies < 1 ? 1 : (size_t)(copies < maximum ? copies : maximum);
}

double murk_tallies_memory(const murk_tally_desc *descs, size_t n,
                           size_t channels, int bands, unsigned threads)
{
    double cells = 0, largest_grid = 0;
    for (size_t i = 0; i < n; ++i) {
        const double own = (double)murk_tally_cells(&descs[i]);
        cells += own;
        if (descs[i].type == MURK_TALLY_GRID) {
            largest_grid = fmax(largest_grid, own);
        }
    }
    const double sums = (double)copies_of(cells, channels, threads) *
                        (double)channels * SUMS_BYTES;
    const double scratch =
        (double)scorers_of(threads) * (sizeof(double) + sizeof(uint32_t));
    const double lists = (double)scorers_of(threads) *
                         (sizeof(murk_scorer) +
                          (double)MURK_SCORE_LISTS * sizeof(murk_score_entry));
    return sizeof(murk_tallies) + lists + cells * (sums + scratch) +
           largest_grid * bands * WRITTEN_BYTES;
}

static murk_tally_plane plane_of(const murk_tally_desc *d, const murk_box *box,
                                 uint32_t first)
{
    const double low[3] = {box->min.x, box->min.y, box->min.z};
    const double high[3] = {box->max.x, box->max.y, box->max.z};
    murk_tally_plane plane = {
        .point = d->point,
        .normal = murk_unit(d->normal),
        .bins = {(uint32_t)d->bins[0], (uint32_t)d->bins[1]},
        .angle_bins = (uint32_t)d->angle_bins,
        .first = first};
    murk_tally_axes(d, plane.axes);
    for (int i = 0; i < 2; ++i) {
        const int axis = plane.axes[i];
        plane.low_m[i] = low[axis];
        plane.bins_per_m[i] = (double)d->bins[i] / (high[axis] - low[axis]);
    }
    return plane;
}

static murk_vec3 cell_edges(const murk_tally_desc *d)
{
    const murk_vec3 all = murk_sub(d->box.max, d->box.min);
    return murk_vec(all.x / (double)d->size[0], all.y / (double)d->size[1],
                    all.z / (double)d->size[2]);
}

static murk_lattice lattice_of(const murk_tally_desc *d, uint32_t first)
{
    const murk_vec3 edge = cell_edges(d);
    return (murk_lattice){.box = d->box,
                          .cells_per_m = {1 / edge.x, 1 / edge.y, 1 / edge.z},
                          .size = {(uint32_t)d->size[0], (uint32_t)d->size[1],
                                   (uint32_t)d->size[2]},
                          .per_m = 1 / murk_length(edge),
                          .first = first};
}

static void prepare(murk_tallies *t, const murk_tally_desc *descs,
                    const murk_box *box)
{
    for (size_t i = 0; i < t->n; ++i) {
        const murk_tally_desc *d = &descs[i];
        const uint32_t first = (uint32_t)t->cells;
        t->desc[i] = *d;
        t->first[i] = first;
        t->cells += murk_tally_cells(d);
        /* A segment crosses a plane or a sphere once, and each face of a grid
         * at most once. */
        t->entries_max += d->type == MURK_TALLY_GRID
                              ? d->size[0] + d->size[1] + d->size[2]
                              : 1;
        if (d->type == MURK_TALLY_PLANE) {
            t->plane[t->planes++] = plane_of(d, box, first);
        } else if (d->type == MURK_TALLY_GRID) {
            t->lattice[t->lattices++] = lattice_of(d, first);
        } else {
            t->probe[t->probes++] = (murk_probe){.center = d->center,
                                                 .radius_m = d->radius_m,
                                                 .per_m = 0.5 / d->radius_m,
                                                 .hemispheres = d->hemispheres,
                                                 .first = first};
        }
    }
}

static bool is_whole(const murk_scorer *s)
{
    return s && s->sides && s->lists && s->sum && s->touched;
}

static void begin_lists(murk_scorer *s, size_t planes)
{
    s->spare = s->lists + (size_t)MURK_SCORE_PATHS * MURK_SCORE_STRIDE;
    s->spare[0] = (murk_score_entry){0, MURK_SCORE_NO_CELL};
    for (size_t i = 0; i < MURK_SCORE_PATHS; ++i) {
        murk_score_path *const path = &s->path[i];
        *path = (murk_score_path){.scorer = s,
                                  .side = s->sides + i * (planes + 1),
                                  .list = s->lists + i * MURK_SCORE_STRIDE};
        path->list[0] = (murk_score_entry){0, MURK_SCORE_NO_CELL};
    }
}

static murk_scorer *scorer_made(const murk_tallies *t, size_t number)
{
    murk_scorer *s = calloc(1, sizeof *s);
    if (s) {
        s->tallies = t;
        s->sides = calloc(MURK_SCORE_PATHS * (t->planes + 1), sizeof *s->sides);
        s->lists = malloc(MURK_SCORE_LISTS * sizeof *s->lists);
        s->sum = calloc(t->cells, sizeof *s->sum);
        s->touched = malloc((t->cells + 1) * sizeof *s->touched);
        s->add = murk_score_add_entries;
        s->is_alone = t->copies == t->scorers;
        const size_t first = number % t->copies * t->channels * t->cells;
        s->low = t->low + first;
        s->high = t->high + first;
        if (is_whole(s)) {
            begin_lists(s, t->planes);
        }
    }
    return s;
}

/* Allocates memory after the checks of murk_tallies_create(); false when out of
 * memory. */
static bool provide(murk_tallies *t, unsigned threads)
{
    t->scorers = scorers_of(threads);
    t->copies = copies_of((double)t->cells, t->channels, threads);
    /* Four bins share a cache line, and none lies in two. */
    const size_t bins = t->copies * t->channels * t->cells;
    t->memory = calloc(bins * SUMS_BYTES + CACHE_LINE, 1);
    if (t->memory) {
        const size_t off = (uintptr_t)t->memory % CACHE_LINE;
        t->low = (murk_tally_bin *)((char *)t->memory + CACHE_LINE - off);
        t->high = t->low + bins;
    }
    t->scorer = calloc(t->scorers, sizeof *t->scorer);
    bool has_all = t->low && t->scorer;
    for (size_t i = 0; has_all && i < t->scorers; ++i) {
        t->scorer[i] = scorer_made(t, i);
        has_all = is_whole(t->scorer[i]);
    }
    return has_all;
}

murk_status murk_tallies_create(murk_tallies **out,
                                const murk_tally_desc *descs, size_t n,
                                const murk_domain *domain, size_t channels,
                                int bands, unsigned threads,
                                double memory_max_bytes, murk_error *err)
{
    assert(out && n > 0 && channels > 0 && channels % (size_t)bands == 0);
    murk_status status = murk_tallies_check(descs, n, domain, err);
    if (status) {
        return status;
    }
    /* Refuse tallies that do not fit in memory, and name the largest one. */
    const double bytes =
        murk_tallies_memory(descs, n, channels, bands, threads);
    if (!(bytes <= memory_max_bytes)) {
        size_t largest = 0;
        for (size_t i = 1; i < n; ++i) {
            if (murk_tally_cells(&descs[i]) >
                murk_tally_cells(&descs[largest])) {
                largest = i;
            }
        }
        return murk_fail(err, MURK_BAD_VALUE, descs[largest].where,
                         "the tallies take %.3g GB: %zu cells in this one, "
                         "for each of %zu lights times bands; this machine "
                         "has %.3g GB free",
                         bytes / 1e9, murk_tally_cells(&descs[largest]),
                         channels, memory_max_bytes / 1e9);
    }
    /* Prepare the tallies and the scorers of all threads. */
    murk_tallies *t = calloc(1, sizeof *t);
    if (t) {
        t->n = n;
        t->channels = channels;
        t->bands = bands;
        prepare(t, descs, &domain->box);
    }
    if (!t || !provide(t, threads)) {
        murk_tallies_destroy(t);
        return murk_no_memory(err, descs[0].where, "for the tallies: %.3g GB",
                              bytes / 1e9);
    }
    *out = t;
    return MURK_OK;
}

void murk_tallies_destroy(murk_tallies *t)
{
    if (!t) {
        return;
    }
    for (size_t i = 0; t->scorer && i < t->scorers; ++i) {
        if (t->scorer[i]) {
            free(t->scorer[i]->sides);
            free(t->scorer[i]->lists);
            free(t->scorer[i]->sum);
            free(t->scorer[i]->touched);
            free(t->scorer[i]);
        }
    }
    free(t->scorer);
    free(t->memory);
    free(t);
}

bool murk_tallies_fit(const murk_tallies *t, size_t channels, unsigned threads)
{
    return t->channels == channels && scorers_of(threads) <= t->scorers;
}

murk_scorer *murk_tallies_scorer(murk_tallies *t, unsigned worker)
{
    return t->scorer[worker % t->scorers];
}

/* ---- reading ---- */

/* The two sums of bin i of [channels][cells], over all copies. */
static void sum_copies(const murk_tallies *t, size_t i, murk_wide *sum,
                       murk_wide *squares)
{
    *sum = *squares = 0;
    for (size_t copy = 0; copy < t->copies; ++copy) {
        const size_t at = copy * t->channels * t->cells + i;
        *sum += murk_wide_read(&t->low[at].sum, &t->high[at].sum);
        *squares += murk_wide_read(&t->low[at].squares, &t->high[at].squares);
    }
}

size_t murk_tallies_words(const murk_tallies *t)
{
    return 4 * t->channels * t->cells;
}

void murk_tallies_read_sums(const murk_tallies *t, uint64_t *word)
{
    for (size_t i = 0; i < t->channels * t->cells; ++i) {
        murk_wide sum, squares;
        sum_copies(t, i, &sum, &squares);
        *word++ = (uint64_t)sum;
        *word++ = (uint64_t)(sum >> 64);
        *word++ = (uint64_t)squares;
        *word++ = (uint64_t)(squares >> 64);
    }
}

void murk_tallies_add_sums(murk_tallies *t, const uint64_t *word)
{
    for (size_t i = 0; i < t->channels * t->cells; ++i, word += 4) {
        murk_wide_add(&t->low[i].sum, &t->high[i].sum,
                      (murk_wide)word[1] << 64 | word[0]);
        murk_wide_add(&t->low[i].squares, &t->high[i].squares,
                      (murk_wide)word[3] << 64 | word[2]);
    }
}

size_t murk_tallies_count(const murk_tallies *t)
{
    return t->n;
}

const murk_tally_desc *murk_tallies_desc(const murk_tallies *t, size_t tally)
{
    return &t->desc[tally];
}

/* The factor from a sum [W], in which lengths count in units of the diagonal of
 * a cell or the diameter of a sphere, to the value of the cell: 1 for a plane
 * [W], length / volume [1/m2] for a grid or sphere. */
static double worth(const murk_tally_desc *d)
{
    if (d->type == MURK_TALLY_PLANE) {
        return 1;
    }
    if (d->type == MURK_TALLY_SPHERE) {
        const double r = d->radius_m;
        return 2 * r / (4. / 3 * MURK_PI * r * r * r);
    }
    const murk_vec3 edge = cell_edges(d);
    return murk_length(edge) / (edge.x * edge.y * edge.z);
}

/* The variance of the sum over n photons; for a single photon, the square of
 * the contribution. */
static double variance(murk_wide sum, murk_wide squares, int64_t n)
{
    return n > 1 ? (double)n / (double)(n - 1) *
                       murk_wide_spread(sum, squares, (uint64_t)n)
                 : murk_wide_value(squares);
}

murk_estimate murk_tallies_read(const murk_tallies *t, size_t tally, int band,
                                size_t cell, const murk_tally *emitted,
                                const double *packet_w)
{
    double power_w = 0, variance_w2 = 0;
    for (size_t c = (size_t)band; c < t->channels; c += (size_t)t->bands) {
        murk_wide sum, squares;
        sum_copies(t, c * t->cells + t->first[tally] + cell, &sum, &squares);
        const double quantum_w = packet_w[c] / (double)MURK_PACKET;
        const int64_t n = murk_tally_read(&emitted[c]) / MURK_PACKET;
        power_w += quantum_w * murk_wide_value(sum);
        if (n > 0) {
            variance_w2 += quantum_w * quantum_w * variance(sum, squares, n);
        }
    }
    const double w = worth(&t->desc[tally]);
    return (murk_estimate){w * power_w, w * sqrt(variance_w2)};
}
