/* Sums of coverage over photons, with the standard error.
 *
 * Records of one emitted photon are correlated, so the error is computed by
 * emitted photon e. N is the number of emitted photons. With whole-number
 * weights, X_e the covered and Y_e the whole weight of the records of e, C =
 * sum X / sum Y has the linearised residual r_e = (X_e - C Y_e) / sum Y. The
 * `balanced` coverage is the mean of the ratios C of both maps, so the residual
 * is the mean of both residuals (if one map has no weight, those of the other
 * map alone); photons without records have residual 0. Then se^2 = N / (N - 1)
 * sum r_e^2 (Cochran, Sampling Techniques, 1977, ch. 6). */
#include "sensing/covered_photons.h"

#include "base/sort.h"
#include "sensing/region_coverage.h"
#include "sensing/sight_parts.h"

#include <stdlib.h>

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

/* The power [W] of photon i, times the factor of the regions of interest. */
static double power_of(const murk_covered_photons *m, size_t i)
{
    return m->power_w ? m->power_w[i]
           : m->list  ? (double)m->list->power_w[i]
                      : murk_sight_power_w(m->sight, i);
}

/* The map of photon i: 0 surface, 1 volume. */
static int map_of(const murk_covered_photons *m, size_t i)
{
    return m->list ? m->list->bits[i] & MURK_LISTED_VOLUME
                   : i >= m->surface_photons;
}

/* ---- sums ---- */

/* The value of a photon that is fully covered. */
static uint32_t full_of(const murk_covered_photons *m)
{
    return (uint32_t)m->combined.layers * MURK_CLEAR;
}

/* The value of photon i for these sensors; with at_least, full_of() or 0. */
static uint32_t worth_of(const murk_covered_photons *m, size_t i)
{
    return m->at_least == 0 ? murk_combined_rows_worth(&m->combined, i)
           : m->combined.sensors[i] >= m->at_least ? full_of(m)
                                                   : 0;
}

/* Sums over the photons of each map. Power is summed in the order of the
 * photons, which does not depend on threads. */
static void add_up(share part[2], const murk_covered_photons *m)
{
    part[0] = part[1] = (share){0};
    for (size_t i = 0; i < m->photons; ++i) {
        share *sum = &part[map_of(m, i)];
        const uint32_t worth = worth_of(m, i);
        const double power_w = power_of(m, i);
        sum->seen_w += power_w * worth;
        sum->whole_w += power_w * full_of(m);
        const uint64_t w = m->weight[i];
        sum->seen += w * worth;
        sum->whole += w * full_of(m);
    }
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

static void fill(murk_coverage_result *out, const murk_covered_photons *m,
                 uint64_t whole)
{
    uint64_t seen = 0;
    for (size_t i = 0; i < m->photons; ++i) {
        m->seen_by[m->combined.sensors[i]] += m->weight[i];
    }
    for (size_t k = m->sensors; k-- > 0;) {
        seen += m->seen_by[k + 1];
        out->seen_by_at_least[k] = ratio(seen * full_of(m), whole);
    }
    out->sum_of_views = m->single_value ? 0 : NAN;
    for (size_t j = 0; j < m->sensors; ++j) {
        out->only_it_covers[j] = ratio(m->only[j], whole);
        out->covers[j] = NAN;
        if (m->single_value) {
            out->covers[j] = ratio(m->single_value[j], whole);
            out->sum_of_views +=
                ratio(m->single_value[j], whole / m->combined.layers);
        }
    }
}

/* ---- errors by emitted photon ---- */

typedef struct residuals {
    double total;   /* sum of squared residuals, in weight * clarity */
    double part[2]; /* sum of squared residuals of each map's own coverage, in
                       power * clarity */
    double map[2];  /* sum of squared residuals of the total, in weight *
                       clarity, with the records of each map alone */
} residuals;

/* True if place k > 0 of the order by emitted photon begins another emitted
 * photon. key NULL: the photons are listed in this order. */
static bool is_first(const murk_covered_photons *m, const uint64_t *key,
                     size_t k)
{
    return key ? key[k] >> 32 != key[k - 1] >> 32
               : m->list->bits[k] & MURK_LISTED_FIRST;
}

/* Sums the squared residuals by emitted photon. In weights, each record is
 * compared with the coverage of its own map for `balanced`, and otherwise with
 * the total; in power, always with the coverage of its own map. */
static residuals square_residuals(const murk_covered_photons *m,
                                  const uint64_t *key, const share part[2],
                                  double c_total)
{
    const murk_sight_desc *desc = m->desc;
    double c_weight[2], c_power[2];
    for (int p = 0; p < 2; ++p) {
        c_weight[p] = desc->weights.balanced
                          ? ratio(part[p].seen, part[p].whole)
                          : c_total;
        c_power[p] = own_fraction(&part[p]);
    }
    residuals sum = {0};
    for (size_t k = 0; k < m->photons;) {
        double own[2] = {0, 0}, of_map[2] = {0, 0};
        /* All records of one emitted photon. */
        do {
            const size_t i = key ? (size_t)(key[k] & UINT32_MAX) : k;
            const int p = map_of(m, i);
            const double power_w = power_of(m, i);
            const double worth = worth_of(m, i);
            own[p] += power_w * (worth - c_power[p] * full_of(m));
            if (m->weight[i] > 0) {
                const double x = (double)m->weight[i] * worth;
                const double y = (double)m->weight[i] * full_of(m);
                of_map[p] += x - c_weight[p] * y;
            }
        } while (++k < m->photons && !is_first(m, key, k));
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
static void find_at_least(murk_coverage_result *out,
                          const murk_covered_photons *m, const uint64_t *sorted)
{
    const murk_sight_desc *desc = m->desc;
    out->at_least = (murk_estimate){NAN, NAN};
    if (desc->at_least == 0) {
        return;
    }
    murk_covered_photons strict = *m;
    strict.at_least = desc->at_least;
    share part[2];
    add_up(part, &strict);
    const uint64_t whole = part[0].whole + part[1].whole;
    out->at_least.value = ratio(part[0].seen + part[1].seen, whole);
    const residuals sum =
        square_residuals(&strict, sorted, part, out->at_least.value);
    out->at_least.standard_error =
        error_of(sum.total, (double)whole, (double)desc->photons_emitted);
}

static double seen_of(const void *context, size_t i)
{
    const murk_covered_photons *m = context;
    return (double)murk_combined_rows_worth(&m->combined, i) / full_of(m);
}

/* The photons sorted by emitted photon, as emitted << 32 | photon, for free().
 * NULL when out of memory. */
static uint64_t *sort_by_emitted(const murk_covered_photons *m)
{
    uint64_t *key = malloc(m->photons * sizeof *key + 1);
    for (size_t i = 0; key && i < m->photons; ++i) {
        const uint64_t emitted =
            murk_photon_emitted(murk_sight_photon(m->sight, i));
        key[i] = emitted << 32 | i;
    }
    if (key) {
        murk_sort_uint64(key, m->photons);
    }
    return key;
}

/* Fills the errors, the shares of the maps, at_least and the regions. sorted:
 * the photons by emitted photon; NULL if they are listed in that order. */
static void find_errors(murk_coverage_result *out,
                        const murk_covered_photons *m, const share part[2],
                        const uint64_t *sorted)
{
    const murk_sight_desc *desc = m->desc;
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
    out->map[1].photons = m->photons - m->surface_photons;
    if (out->region) {
        murk_region_coverage_measure(out->region, m->sight, sorted, seen_of, m);
    }
}

/* ---- the whole ---- */

bool murk_covered_photons_init(murk_covered_photons *out, size_t photons)
{
    const murk_sight_desc *desc = out->desc;
    const size_t n = out->sensors;
    out->only = calloc(n + 1, sizeof *out->only);
    out->seen_by = calloc(n + 1, sizeof *out->seen_by);
    return murk_combined_rows_init(&out->combined, photons, desc->combining,
                                   desc->redundancy > 1 ? desc->redundancy
                                                        : 1) &&
           out->only && out->seen_by;
}

void murk_covered_photons_release(murk_covered_photons *covered)
{
    murk_combined_rows_release(&covered->combined);
    free(covered->single_value);
    free(covered->only);
    free(covered->seen_by);
}

/* Errors are summed in the order of emitted photons, which asks for records all
 * over the maps. If these are in a scratch file, every record would be read
 * from the disk by itself, so the powers are copied in the order of the records
 * first; for free(). *status: MURK_NO_MEMORY if there is no memory. */
static double *copy_powers(const murk_covered_photons *m, murk_status *status,
                           murk_error *err)
{
    double *power_w = NULL;
    if (m->sight && murk_sight_is_in_file(m->sight)) {
        power_w = malloc(m->photons * sizeof *power_w + 1);
        *status = power_w ? MURK_OK
                          : murk_no_memory(err, "", "for the power of photons");
    }
    for (size_t i = 0; power_w && i < m->photons; ++i) {
        power_w[i] = murk_sight_power_w(m->sight, i);
    }
    return power_w;
}

static murk_status sum_up(murk_coverage_result *out,
                          const murk_covered_photons *m, murk_error *err)
{
    uint64_t *sorted = NULL;
    share part[2];
    add_up(part, m);
    /* Values. */
    const uint64_t whole = part[0].whole + part[1].whole;
    fill(out, m, whole);
    out->surface.value = own_fraction(&part[0]);
    out->volume.value = own_fraction(&part[1]);
    out->total.value = ratio(part[0].seen + part[1].seen, whole);
    /* Errors. */
    if (!m->list) {
        sorted = sort_by_emitted(m);
        if (!sorted) {
            return murk_no_memory(err, "", "to sort %zu photons", m->photons);
        }
    }
    find_errors(out, m, part, sorted);
    free(sorted);
    return MURK_OK;
}

murk_status murk_covered_photons_sum_up(murk_coverage_result *out,
                                        const murk_covered_photons *covered,
                                        murk_error *err)
{
    murk_status status = MURK_OK;
    double *power_w = copy_powers(covered, &status, err);
    murk_covered_photons m = *covered;
    m.power_w = power_w;
    if (!status) {
        status = sum_up(out, &m, err);
    }
    free(power_w);
    return status;
}
