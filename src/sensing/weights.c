/* Whole-number weights: scales the powers of the photons so that the weights
 * use as many bits as 32 bits a photon and 47 bits for the sum allow, and
 * rounds. `balanced` gives both maps the same sum. */
#include "sensing/weights.h"

/* The sum of all weights times the entries that count stays below this
 * (placement/problem.h). */
#define WEIGHT_SUM 0x1p47

/* The largest 32-bit number. */
#define WEIGHT_MAX 4294967295.0

static double power_of(const murk_photon *photon, const murk_interest *interest,
                       const uint64_t *regions, size_t i)
{
    const double power_w = murk_photon_power_w(&photon[i]);
    return regions ? power_w * murk_interest_factor(interest, regions[i])
                   : power_w;
}

void murk_power_sum_add(murk_power_sum *sum, double power_w)
{
    ++sum->n;
    sum->sum += power_w;
    sum->max = fmax(sum->max, power_w);
}

static murk_power_sum add_up(const murk_photon_map *map,
                             const murk_interest *interest,
                             const uint64_t *regions)
{
    const murk_photon *photon = murk_photon_map_photons(map);
    const size_t n = murk_photon_map_count(map);
    murk_power_sum p = {0};
    for (size_t i = 0; i < n; ++i) {
        murk_power_sum_add(&p, power_of(photon, interest, regions, i));
    }
    return p;
}

/* The largest sum of unrounded weights: rounding adds at most half a unit a
 * record, so a sum of `max` - n, with n records, stays below max; and no weight
 * exceeds WEIGHT_MAX. */
static double largest_sum(const murk_power_sum *p, double max)
{
    const double by_weight = p->max > 0 ? WEIGHT_MAX * (p->sum / p->max) : 0;
    return fmin(max - (double)p->n, by_weight);
}

uint32_t murk_weight_of(double power_w, double factor)
{
    return (uint32_t)fmin(floor(power_w * factor + 0.5), WEIGHT_MAX);
}

static void scale(uint32_t *weight, const murk_photon_map *map,
                  const murk_interest *interest, const uint64_t *regions,
                  double factor)
{
    const murk_photon *photon = murk_photon_map_photons(map);
    const size_t n = murk_photon_map_count(map);
    for (size_t i = 0; i < n; ++i) {
        weight[i] =
            murk_weight_of(power_of(photon, interest, regions, i), factor);
    }
}

/* Gives each map's weights the same sum; a map without power leaves all weight
 * to the other. The sum is a multiple of the number of records of the larger
 * map, which has the smaller weights: if all these records have the same power,
 * their weight is a whole number, so that rounding does not change the sum of
 * this map. */
static void balance(double *factor_surface, double *factor_volume,
                    const murk_power_sum *surface, const murk_power_sum *volume,
                    double whole)
{
    double half = whole / 2;
    if (surface->sum > 0) {
        half = fmin(half, largest_sum(surface, whole / 2));
    }
    if (volume->sum > 0) {
        half = fmin(half, largest_sum(volume, whole / 2));
    }
    half -=
        fmod(half, (double)(surface->n > volume->n ? surface->n : volume->n));
    *factor_surface = surface->sum > 0 ? half / surface->sum : 0;
    *factor_volume = volume->sum > 0 ? half / volume->sum : 0;
}

murk_status murk_weight_factors(double factor[2], const murk_power_sum power[2],
                                const murk_map_weights *maps, unsigned combined,
                                const char *where, murk_error *err)
{
    /* Refuse weights of the maps without a positive sum. */
    const double a = maps->surface, b = maps->volume,
                 whole = WEIGHT_SUM / combined;
    const murk_power_sum *s = &power[0], *v = &power[1];
    if (!maps->balanced &&
        !(a >= 0 && b >= 0 && a + b > 0 && isfinite(a + b))) {
        return murk_fail(err, MURK_BAD_VALUE, "placement.weights",
                         "surface %g and volume %g, must be 0 or more and not "
                         "both 0",
                         a, b);
    }
    /* One factor for each map, as large as both limits allow. */
    if (maps->balanced) {
        balance(&factor[0], &factor[1], s, v, whole);
    } else {
        const double share_surface = a / fmax(a, b),
                     share_volume = b / fmax(a, b);
        const double sum = share_surface * s->sum + share_volume * v->sum;
        const double max = fmax(share_surface * s->max, share_volume * v->max);
        const double rest = whole - (double)s->n - (double)v->n;
        const double each = sum > 0 ? fmin(rest / sum, WEIGHT_MAX / max) : 0;
        factor[0] = share_surface * each;
        factor[1] = share_volume * each;
    }
    if (!(factor[0] * s->sum + factor[1] * v->sum > 0)) {
        return murk_fail(err, MURK_RUN_FAILED, where,
                         "nothing to see: the %zu surface and %zu volume "
                         "photons stored have no weight",
                         s->n, v->n);
    }
    return MURK_OK;
}

murk_status
murk_photon_weights(uint32_t *weight, const murk_photon_map *surface,
                    const murk_photon_map *volume, const murk_map_weights *maps,
                    const murk_interest *interest, const uint64_t *regions,
                    unsigned combined, const char *where, murk_error *err)
{
    const size_t first = murk_photon_map_count(surface);
    const uint64_t *of_volume = regions ? regions + first : NULL;
    const murk_power_sum power[2] = {add_up(surface, interest, regions),
                                     add_up(volume, interest, of_volume)};
    double factor[2];
    const murk_status status =
        murk_weight_factors(factor, power, maps, combined, where, err);
    if (!status) {
        scale(weight, surface, interest, regions, factor[0]);
        scale(weight + first, volume, interest, of_volume, factor[1]);
    }
    return status;
}
