/* Coverage of a set of sensors, with the standard error.
 *
 * Records of one emitted photon are correlated, so the error is computed by
 * emitted photon e. N is the number of emitted photons. With whole-number
 * weights, X_e the covered and Y_e the whole weight of the records of e, C =
 * sum X / sum Y has the linearised residual r_e = (X_e - C Y_e) / sum Y. The
 * `balanced` coverage is the mean of the ratios C of both maps, so the residual
 * is the mean of both residuals (if one map has no weight, those of the other
 * map alone); photons without records have residual 0. Then se^2 = N / (N - 1)
 * sum r_e^2 (Cochran, Sampling Techniques, 1977, ch. 6). */
#include "base/interrupt.h"
#include "base/pool.h"
#include "base/position.h"
#include "base/progress.h"
#include "sensing/combined_rows.h"
#include "sensing/region_coverage.h"
#include "sensing/sight_parts.h"

#include <stdlib.h>
#include <string.h>

/* Rows in memory at a time for each thread: enough that threads seldom wait (a
 * choice). */
#define ROWS_EACH 4

typedef struct stored_row {
    size_t seen;
    uint32_t *photon;  /* [seen]; NULL: memory ran out */
    uint16_t *clarity; /* [seen]; NULL: all are MURK_CLEAR */
} stored_row;

typedef struct measure {
    murk_sight *sight;
    const murk_pose *pose;
    size_t sensors, surface_photons;
    murk_combined_rows combined;
    stored_row *block;             /* [ROWS_EACH * threads] */
    size_t capacity;               /* of block */
    size_t first;                  /* sensor of block[0] */
    uint64_t *single_value, *only; /* [sensors] sums of weight * clarity: of the
                                      sensor alone, and lost without the
                                      sensor */
    bool is_second_pass; /* second pass over the rows, for the value that is
                            lost without each sensor; detection probabilities
                            only */
    uint64_t *seen_by; /* [sensors + 1]: element k is the weight of the photons
                          that exactly k sensors see */
    size_t at_least; /* 0, or a number of sensors: a photon that so many sensors
                        or more see counts fully, any other photon not at all */
} measure;

/* Sums over the photons of one map: `whole` of weight times full_of(), the
 * value of a fully covered photon; `seen` of weight times worth_of(), the value
 * of the photon for these sensors. whole_w and seen_w are the same sums with
 * the power [W], times the factor of the regions of interest, in place of the
 * whole-number weight. The coverage of a map alone uses power, because the
 * weight of a map in the total may be 0, or so small that all weights of the
 * map round to 0. */
typedef struct share {
    uint64_t seen, whole;
    double seen_w, whole_w;
} share;

/* ---- rows ---- */

static void find_row(void *context, unsigned worker, uint64_t batch)
{
    measure *m = context;
    stored_row *s = &m->block[batch];
    murk_sparse_row row;
    murk_sight_row(m->sight, worker, &m->pose[m->first + batch], &row);
    murk_progress_add(1);
    s->seen = row.seen;
    s->photon = malloc(row.seen * sizeof *s->photon + 1);
    s->clarity = row.clarity ? malloc(row.seen * sizeof *s->clarity + 1) : NULL;
    if (!s->photon || (row.clarity && !s->clarity)) {
        free(s->photon);
        s->photon = NULL;
        return;
    }
    memcpy(s->photon, row.photon, row.seen * sizeof *s->photon);
    if (row.clarity) {
        memcpy(s->clarity, row.clarity, row.seen * sizeof *s->clarity);
    }
}

static void add_row(measure *m, uint32_t sensor, const stored_row *stored)
{
    const uint32_t *weight = m->sight->weight;
    const murk_sparse_row row = {stored->seen, stored->photon, stored->clarity};
    if (m->is_second_pass) {
        m->only[sensor] =
            murk_combined_rows_only_of(&m->combined, weight, &row);
        return;
    }
    for (size_t k = 0; k < row.seen; ++k) {
        m->single_value[sensor] += (uint64_t)weight[row.photon[k]] *
                                   (row.clarity ? row.clarity[k] : MURK_CLEAR);
    }
    murk_combined_rows_add(&m->combined, sensor, &row);
}

static void release_block(measure *m)
{
    for (size_t i = 0; m->block && i < m->capacity; ++i) {
        free(m->block[i].photon);
        free(m->block[i].clarity);
        m->block[i] = (stored_row){0};
    }
}

static murk_status find_rows(measure *m, murk_error *err)
{
    for (m->first = 0; m->first < m->sensors; m->first += m->capacity) {
        const size_t left = m->sensors - m->first;
        const size_t n = left < m->capacity ? left : m->capacity;
        /* The threads compute the rows of a block, which are then added in the
         * order of the sensors. */
        murk_pool_run_workers(m->sight->desc.threads, n, find_row, m);
        if (murk_interrupted()) {
            return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
        }
        for (size_t i = 0; i < n; ++i) {
            if (!m->block[i].photon) {
                return murk_no_memory(err, "", "to look from %zu sensors", n);
            }
            add_row(m, (uint32_t)(m->first + i), &m->block[i]);
        }
        release_block(m);
    }
    return MURK_OK;
}

static murk_status find_only(measure *m, murk_error *err)
{
    m->is_second_pass = m->combined.dose;
    if (m->is_second_pass) {
        return find_rows(m, err);
    }
    murk_combined_rows_only(&m->combined, m->sight->weight, m->only);
    return MURK_OK;
}

/* ---- sums ---- */

/* The value of a photon that is fully covered. */
static uint32_t full_of(const measure *m)
{
    return (uint32_t)m->combined.layers * MURK_CLEAR;
}

/* The value of photon i for these sensors; with at_least, full_of() or 0. */
static uint32_t worth_of(const measure *m, size_t i)
{
    return m->at_least == 0 ? murk_combined_rows_worth(&m->combined, i)
           : m->combined.sensors[i] >= m->at_least ? full_of(m)
                                                   : 0;
}

/* Sums over the records of a map; the first record is photon `first`. Power is
 * summed in the order of the map, which does not depend on threads. */
static share add_up(const measure *m, const murk_photon_map *map, size_t first)
{
    const size_t n = murk_photon_map_count(map);
    share sum = {0};
    for (size_t k = 0; k < n; ++k) {
        const size_t i = first + k;
        const uint32_t worth = worth_of(m, i);
        const double power_w = murk_sight_power_w(m->sight, i);
        sum.seen_w += power_w * worth;
        sum.whole_w += power_w * full_of(m);
        const uint64_t w = m->sight->weight[i];
        sum.seen += w * worth;
        sum.whole += w * full_of(m);
    }
    return sum;
}

static double ratio(uint64_t part, uint64_t whole)
{
    return whole > 0 ? (double)part / (double)whole : NAN;
}

/* The covered fraction of the power of a map; NaN for a map that is empty or
 * without power. */
static double own_fraction(const share *s)
{
    return s->whole_w > 0 ? s->seen_w / s->whole_w : NAN;
}

static void fill(murk_coverage_result *out, const measure *m, uint64_t whole)
{
    uint64_t seen = 0;
    for (size_t i = 0; i < m->sight->photons; ++i) {
        m->seen_by[m->combined.sensors[i]] += m->sight->weight[i];
    }
    for (size_t k = m->sensors; k-- > 0;) {
        seen += m->seen_by[k + 1];
        out->seen_by_at_least[k] = ratio(seen * full_of(m), whole);
    }
    out->sum_of_views = 0;
    for (size_t j = 0; j < m->sensors; ++j) {
        out->covers[j] = ratio(m->single_value[j], whole);
        out->only_it_covers[j] = ratio(m->only[j], whole);
        out->sum_of_views +=
            ratio(m->single_value[j], whole / m->combined.layers);
    }
}

/* ---- errors by emitted photon ---- */

/* Sorts the records by emitted photon, as emitted << 32 | record: radix sort by
 * bytes, least significant first, which keeps the records of a photon in order.
 * Uses two arrays of n keys and returns the one that holds the result.
 * `emitted` is the number of emitted photons. */
static uint64_t *sort_by_emitted(uint64_t *keys, uint64_t *other, size_t n,
                                 uint64_t emitted)
{
    for (unsigned shift = 32; shift < 64 && (emitted - 1) >> (shift - 32) > 0;
         shift += 8) {
        size_t begin[257] = {0};
        for (size_t i = 0; i < n; ++i) {
            ++begin[(keys[i] >> shift & 255) + 1];
        }
        for (int d = 0; d < 256; ++d) {
            begin[d + 1] += begin[d];
        }
        for (size_t i = 0; i < n; ++i) {
            other[begin[keys[i] >> shift & 255]++] = keys[i];
        }
        uint64_t *const sorted = other;
        other = keys;
        keys = sorted;
    }
    return keys;
}

typedef struct residuals {
    double total;   /* sum of squared residuals, in weight * clarity */
    double part[2]; /* sum of squared residuals of each map's own coverage, in
                       power * clarity */
    double map[2];  /* sum of squared residuals of the total, in weight *
                       clarity, with the records of each map alone */
} residuals;

/* Sums the squared residuals by emitted photon. In weights, each record is
 * compared with the coverage of its own map for `balanced`, and otherwise with
 * the total; in power, always with the coverage of its own map. */
static residuals square_residuals(const measure *m, const uint64_t *key,
                                  const share part[2], double c_total)
{
    const murk_sight_desc *desc = &m->sight->desc;
    double c_weight[2], c_power[2];
    for (int p = 0; p < 2; ++p) {
        c_weight[p] = desc->weights.balanced
                          ? ratio(part[p].seen, part[p].whole)
                          : c_total;
        c_power[p] = own_fraction(&part[p]);
    }
    residuals sum = {0};
    for (size_t k = 0; k < m->sight->photons;) {
        const uint64_t emitted = key[k] >> 32;
        double own[2] = {0, 0}, of_map[2] = {0, 0};
        /* All records of one emitted photon. */
        for (; k < m->sight->photons && key[k] >> 32 == emitted; ++k) {
            const size_t i = (size_t)(key[k] & UINT32_MAX);
            const int p = i >= m->surface_photons;
            const double power_w = murk_sight_power_w(m->sight, i);
            const double worth = worth_of(m, i);
            own[p] += power_w * (worth - c_power[p] * full_of(m));
            if (m->sight->weight[i] > 0) {
                const double x = (double)m->sight->weight[i] * worth;
                const double y = (double)m->sight->weight[i] * full_of(m);
                of_map[p] += x - c_weight[p] * y;
            }
        }
        sum.part[0] += own[0] * own[0];
        sum.part[1] += own[1] * own[1];
        sum.map[0] += of_map[0] * of_map[0];
        sum.map[1] += of_map[1] * of_map[1];
        const double total = of_map[0] + of_map[1];
        sum.total += total * total;
    }
    return sum;
}

static double error_of(double squares, double whole, double emitted)
{
    return whole > 0 && emitted > 1
               ? sqrt(emitted / (emitted - 1) * squares) / whole
               : NAN;
}

/* The share of the whole weight that lies in photons seen by desc->at_least
 * sensors or more, each of which counts fully, with the standard error; NaN if
 * at_least is 0. */
static void find_at_least(murk_coverage_result *out, const measure *m,
                          const uint64_t *sorted)
{
    const murk_sight_desc *desc = &m->sight->desc;
    out->at_least = (murk_estimate){NAN, NAN};
    if (desc->at_least == 0) {
        return;
    }
    measure strict = *m;
    strict.at_least = desc->at_least;
    const share part[2] = {
        add_up(&strict, desc->surface_map, 0),
        add_up(&strict, desc->volume_map, m->surface_photons)};
    const uint64_t whole = part[0].whole + part[1].whole;
    out->at_least.value = ratio(part[0].seen + part[1].seen, whole);
    const residuals sum =
        square_residuals(&strict, sorted, part, out->at_least.value);
    out->at_least.standard_error =
        error_of(sum.total, (double)whole, (double)desc->photons_emitted);
}

static double seen_of(const void *context, size_t i)
{
    const measure *m = context;
    return (double)murk_combined_rows_worth(&m->combined, i) / full_of(m);
}

static murk_status find_errors(murk_coverage_result *out, const measure *m,
                               const share part[2], murk_error *err)
{
    const murk_sight_desc *desc = &m->sight->desc;
    uint64_t *keys = malloc(m->sight->photons * sizeof *keys);
    uint64_t *other = malloc(m->sight->photons * sizeof *other);
    murk_status status = MURK_OK;
    if (!keys || !other) {
        status =
            murk_no_memory(err, "", "to sort %zu photons", m->sight->photons);
        goto done;
    }
    /* Sort the records by emitted photon, then sum. */
    for (size_t i = 0; i < m->sight->photons; ++i) {
        const uint64_t emitted =
            murk_photon_emitted(murk_sight_photon(m->sight, i));
        keys[i] = emitted << 32 | i;
    }
    const uint64_t *sorted =
        sort_by_emitted(keys, other, m->sight->photons, desc->photons_emitted);
    const residuals sum = square_residuals(m, sorted, part, out->total.value);
    const double emitted = (double)desc->photons_emitted;
    out->surface.standard_error =
        error_of(sum.part[0], part[0].whole_w, emitted);
    out->volume.standard_error =
        error_of(sum.part[1], part[1].whole_w, emitted);
    const uint64_t whole = part[0].whole + part[1].whole;
    out->total.standard_error = error_of(sum.total, (double)whole, emitted);
    for (int p = 0; p < 2; ++p) {
        /* For `balanced` with records of weight in both maps exactly one half:
         * the rounding of weights is ignored. */
        const bool is_half =
            desc->weights.balanced && part[0].whole && part[1].whole;
        out->map[p].weight = is_half ? .5 : ratio(part[p].whole, whole);
        out->map[p].standard_error =
            error_of(sum.map[p], (double)whole, emitted);
    }
    find_at_least(out, m, sorted);
    out->map[0].photons = m->surface_photons;
    out->map[1].photons = m->sight->photons - m->surface_photons;
    if (out->region) {
        murk_region_coverage_measure(out->region, m->sight, sorted, seen_of, m);
    }
done:
    free(keys);
    free(other);
    return status;
}

/* ---- the whole ---- */

static murk_status check(const murk_sight_desc *desc, const murk_pose *pose,
                         size_t n, murk_error *err)
{
    for (size_t j = 0; j < n; ++j) {
        const murk_box *box = &desc->domain.box;
        if (!murk_box_contains(box, pose[j].position)) {
            return murk_fail(err, MURK_BAD_VALUE, "sensors",
                             "sensor %zu at %s m is outside the domain, %s to "
                             "%s m",
                             j + 1, murk_position_show(pose[j].position).text,
                             murk_position_show(box->min).text,
                             murk_position_show(box->max).text);
        }
    }
    return MURK_OK;
}

bool murk_coverage_result_create(murk_coverage_result *out, size_t n,
                                 size_t regions)
{
    *out = (murk_coverage_result){
        .covers = calloc(n + 1, sizeof *out->covers),
        .only_it_covers = calloc(n + 1, sizeof *out->only_it_covers),
        .seen_by_at_least = calloc(n + 1, sizeof *out->seen_by_at_least),
        .region = regions ? calloc(regions, sizeof *out->region) : NULL};
    return out->covers && out->only_it_covers && out->seen_by_at_least &&
           (out->region || !regions);
}

static murk_status allocate(measure *m, murk_coverage_result *out,
                            murk_error *err)
{
    const murk_sight_desc *desc = &m->sight->desc;
    const size_t n = m->sensors, photons = m->sight->photons;
    /* Rows, sums by sensor, and the arrays of the result. */
    m->block = calloc(m->capacity, sizeof *m->block);
    m->single_value = calloc(n + 1, sizeof *m->single_value);
    m->only = calloc(n + 1, sizeof *m->only);
    m->seen_by = calloc(n + 1, sizeof *m->seen_by);
    if (murk_coverage_result_create(out, n,
                                    desc->interest ? desc->interest->n : 0) &&
        murk_combined_rows_init(&m->combined, photons, desc->combining,
                                desc->redundancy > 1 ? desc->redundancy : 1) &&
        m->block && m->single_value && m->only && m->seen_by) {
        return MURK_OK;
    }
    return murk_no_memory(err, "", "to measure %zu sensors over %zu photons", n,
                          photons);
}

murk_status murk_coverage_result_measure(murk_coverage_result *out,
                                         murk_sight *sight,
                                         const murk_pose *pose, size_t n,
                                         murk_error *err)
{
    const murk_sight_desc *desc = &sight->desc;
    measure m = {.sight = sight,
                 .pose = pose,
                 .sensors = n,
                 .surface_photons = murk_photon_map_count(desc->surface_map),
                 .capacity = (size_t)ROWS_EACH * desc->threads};
    murk_coverage_result coverage = {0};
    murk_status status = check(desc, pose, n, err);
    if (!status) {
        status = allocate(&m, &coverage, err);
    }
    /* Rows of all sensors, once or in two passes, then the sums. */
    murk_progress_begin("sense", (m.combined.dose ? 2 : 1) * (uint64_t)n,
                        "sensors");
    if (!status) {
        status = find_rows(&m, err);
    }
    if (!status) {
        status = find_only(&m, err);
    }
    /* Values and errors. */
    if (!status) {
        const share part[2] = {add_up(&m, desc->surface_map, 0),
                               add_up(&m, desc->volume_map, m.surface_photons)};
        const uint64_t whole = part[0].whole + part[1].whole;
        fill(&coverage, &m, whole);
        coverage.surface.value = own_fraction(&part[0]);
        coverage.volume.value = own_fraction(&part[1]);
        coverage.total.value = ratio(part[0].seen + part[1].seen, whole);
        status = find_errors(&coverage, &m, part, err);
    }
    murk_progress_end();
    if (status) {
        murk_coverage_result_release(&coverage);
    } else {
        *out = coverage;
    }
    release_block(&m);
    murk_combined_rows_release(&m.combined);
    free(m.block);
    free(m.single_value);
    free(m.only);
    free(m.seen_by);
    return status;
}

murk_status murk_coverage_total_measure(murk_estimate *out, murk_sight *sight,
                                        const murk_pose *pose, size_t n,
                                        murk_error *err)
{
    murk_coverage_result coverage = {0};
    const murk_status status =
        murk_coverage_result_measure(&coverage, sight, pose, n, err);
    *out = coverage.total;
    murk_coverage_result_release(&coverage);
    return status;
}

void murk_coverage_result_release(murk_coverage_result *coverage)
{
    free(coverage->covers);
    free(coverage->only_it_covers);
    free(coverage->seen_by_at_least);
    free(coverage->region);
    *coverage = (murk_coverage_result){0};
}
