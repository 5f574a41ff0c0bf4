/* Whole-number weights: scales the powers of the photons so that the weights
 * use as many bits as 32 bits a photon and 47 bits for the sum allow, and
 * rounds. `balanced` gives both maps the same sum. */
#include "sensing/weights.h"

/* The sum of all weights times the entries that count stays below this
 * (placement/problem.h). */
#define WEIGHT_SUM 0x1p47

/* The largest 32-bit number. */
#define WEIGHT_MAX 4294967295.0

typedef struct powers {
    const murk_photon *photon;
    size_t n;
    const murk_interest *interest;
    const uint64_t *regions; /* [n]; NULL: none */
    double sum, max;
} powers;

static double power_of(const powers *p, size_t i)
{
    const double power_w = murk_photon_power_w(&p->photon[i]);
    return p->regions
               ? power_w * murk_interest_factor(p->interest, p->regions[i])
               : power_w;
}

static powers add_up(const murk_photon_map *map, const murk_interest *interest,
                     const uint64_t *regions)
{
    powers p = {.photon = murk_photon_map_photons(map),
                .n = murk_photon_map_count(map),
                .interest = interest,
                .regions = regions};
    for (size_t i = 0; i < p.n; ++i) {
        const double power_w = power_of(&p, i);
        p.sum += power_w;
        p.max = fmax(p.max, power_w);
    }
    return p;
}

/* The largest sum of unrounded weights: rounding adds at most half a unit a
 * record, so a sum of `max` - n, with n records, stays below max; and no weight
 * exceeds WEIGHT_MAX. */
static double largest_sum(const powers *p, double max)
{
    const double by_weight = p->max > 0 ? WEIGHT_MAX * (p->sum / p->max) : 0;
    return fmin(max - (double)p->n, by_weight);
}

static void scale(uint32_t *weight, const powers *p, double factor)
{
    for (size_t i = 0; i < p->n; ++i) {
        const double w = floor(power_of(p, i) * factor + 0.5);
        weight[i] = (uint32_t)fmin(w, WEIGHT_MAX);
    }
}

/* Gives each map's weights the same sum; a map without power leaves all weight
 * to the other. The sum is a multiple of the number of records of the larger
 * map, which has the smaller weights: if all these records have the same power,
 * their weight is a whole number, so that rounding does not change the sum of
 * this map. */
static void balance(double *factor_surface, double *factor_volume,
                    const powers *surface, const powers *volume, double whole)
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

murk_status
murk_photon_weights(uint32_t *weight, const murk_photon_map *surface,
                    const murk_photon_map *volume, const murk_map_weights *maps,
                    const murk_interest *interest, const uint64_t *regions,
                    unsigned combined, const char *where, murk_error *err)
{
    /* Refuse weights of the maps without a positive sum. */
    const double a = maps->surface, b = maps->volume,
                 whole = WEIGHT_SUM / combined;
    if (!maps->balanced &&
        !(a >= 0 && b >= 0 && a + b > 0 && isfinite(a + b))) {
        return murk_fail(err, MURK_BAD_VALUE, "placement.weights",
                         "surface %g and volume %g, must be 0 or more and not "
                         "both 0",
                         a, b);
    }
    const powers s = add_up(surface, interest, regions);
    const powers v = add_up(volume, interest, regions ? regions + s.n : NULL);
    /* One factor for each map, as large as both limits allow. */
    double factor_surface, factor_volume;
    if (maps->balanced) {
        balance(&factor_surface, &factor_volume, &s, &v, whole);
    } else {
        const double share_surface = a / fmax(a, b),
                     share_volume = b / fmax(a, b);
        const double sum = share_surface * s.sum + share_volume * v.sum;
        const double max = fmax(share_surface * s.max, share_volume * v.max);
        const double rest = whole - (double)s.n - (double)v.n;
        const double factor = sum > 0 ? fmin(rest / sum, WEIGHT_MAX / max) : 0;
        factor_surface = share_surface * factor;
        factor_volume = share_volume * factor;
    }
    if (!(factor_surface * s.sum + factor_volume * v.sum > 0)) {
        return murk_fail(err, MURK_RUN_FAILED, where,
                         "nothing to see: the %zu surface and %zu volume "
                         "photons stored have no weight",
                         s.n, v.n);
    }
    scale(weight, &s, factor_surface);
    scale(weight + s.n, &v, factor_volume);
    return MURK_OK;
}
