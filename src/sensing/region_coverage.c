/* Coverage of regions of interest. The coverage of a region is the total that
 * would result if all other photons were absent and every region had weight 1.
 * The error is by emitted photon, with the formula of sensing/coverage.c; one
 * pass over the sorted photons computes the residuals of all regions. */
#include "sensing/region_coverage.h"

#include "sensing/sight_parts.h"

/* One region: covered and whole power, by map. */
typedef struct share {
    double seen_w[2], whole_w[2];
    size_t photons;
    /* A record adds power * (seen - mean) * scale to the residual, with the
     * values of its map. */
    double mean[2], scale[2];
    double residual,
        squares; /* residual of the present emitted photon; sum of squares */
} share;

typedef struct sums {
    const murk_sight *sight;
    size_t n; /* regions */
    size_t surface_photons;
    share part[MURK_INTERESTS_MAX];
} sums;

static int map_of(const sums *s, size_t i)
{
    return i >= s->surface_photons;
}

static double power_w(const sums *s, size_t i)
{
    return murk_photon_power_w(murk_sight_photon(s->sight, i));
}

static void add_up(sums *s, murk_photon_view seen, const void *context)
{
    for (size_t i = 0; i < s->sight->photons; ++i) {
        const uint64_t regions = s->sight->regions[i];
        const double worth = regions ? seen(context, i) : 0;
        const int p = map_of(s, i);
        for (size_t r = 0; r < s->n; ++r) {
            if (regions >> r & 1) {
                share *part = &s->part[r];
                part->seen_w[p] += power_w(s, i) * worth;
                part->whole_w[p] += power_w(s, i);
                ++part->photons;
            }
        }
    }
}

/* Sets mean and scale; returns the coverage, NaN for a region without weight.
 */
static double set_coverage(share *part, const murk_map_weights *weights)
{
    const double given[2] = {weights->surface, weights->volume};
    double seen = 0, whole = 0;
    for (int p = 0; p < 2; ++p) {
        const double each = !weights->balanced     ? given[p]
                            : part->whole_w[p] > 0 ? 1 / part->whole_w[p]
                                                   : 0;
        part->scale[p] = each;
        part->mean[p] =
            part->whole_w[p] > 0 ? part->seen_w[p] / part->whole_w[p] : 0;
        seen += each * part->seen_w[p];
        whole += each * part->whole_w[p];
    }
    if (!(whole > 0)) {
        return NAN;
    }
    const double coverage = seen / whole;
    for (int p = 0; p < 2; ++p) {
        part->scale[p] /= whole;
        part->mean[p] = weights->balanced ? part->mean[p] : coverage;
    }
    return coverage;
}

static void add_squares(sums *s, uint64_t touched)
{
    for (size_t r = 0; r < s->n; ++r) {
        if (touched >> r & 1) {
            share *part = &s->part[r];
            part->squares += part->residual * part->residual;
            part->residual = 0;
        }
    }
}

static void square_residuals(sums *s, const uint64_t *key,
                             murk_photon_view seen, const void *context)
{
    uint64_t touched = 0;
    for (size_t k = 0; k < s->sight->photons; ++k) {
        /* A new emitted photon: square the residuals of the last one. */
        if (k > 0 && key[k] >> 32 != key[k - 1] >> 32) {
            add_squares(s, touched);
            touched = 0;
        }
        const size_t i = (size_t)(key[k] & UINT32_MAX);
        const uint64_t regions = s->sight->regions[i];
        const double worth = regions ? seen(context, i) : 0;
        const int p = map_of(s, i);
        touched |= regions;
        for (size_t r = 0; r < s->n; ++r) {
            if (regions >> r & 1) {
                share *part = &s->part[r];
                part->residual +=
                    power_w(s, i) * (worth - part->mean[p]) * part->scale[p];
            }
        }
    }
    add_squares(s, touched);
}

void murk_region_coverage_measure(murk_region_coverage *out,
                                  const murk_sight *sight, const uint64_t *key,
                                  murk_photon_view seen, const void *context)
{
    const murk_sight_desc *desc = &sight->desc;
    sums s = {.sight = sight,
              .n = desc->interest->n,
              .surface_photons = murk_photon_map_count(desc->surface_map)};
    /* Coverage of each region, then the errors. */
    add_up(&s, seen, context);
    for (size_t r = 0; r < s.n; ++r) {
        out[r].photons = s.part[r].photons;
        out[r].coverage.value = set_coverage(&s.part[r], &desc->weights);
    }
    square_residuals(&s, key, seen, context);
    const double emitted = (double)desc->photons_emitted;
    for (size_t r = 0; r < s.n; ++r) {
        out[r].coverage.standard_error =
            isfinite(out[r].coverage.value) && emitted > 1
                ? sqrt(emitted / (emitted - 1) * s.part[r].squares)
                : NAN;
    }
}
