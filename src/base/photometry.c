/* Photometric and quantum conversions of radiant power; base/photometry.h has
 * the sources. A band is divided at the ends of V and PAR; within each piece
 * the spectral integrals are sums over midpoints of equal steps. A table of a
 * spectrum is divided at each of its wavelengths, too, and each piece takes two
 * points of Gauss and Legendre a step: a line narrower than a step counts. */
#include "base/photometry.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

/* h c in joule nanometres (SI 2019). */
#define HC_J_NM 1.986445857148929e-16
/* The table of V, the limits of PAR and the unit of PAR (base/photometry.h). */
#define V_FROM_NM   380.0
#define V_STEP_NM   5.0
#define PAR_FROM_NM 400.0
#define PAR_TO_NM   700.0
#define UMOL        1e6
/* Steps of the midpoint rule: V changes by at most 3 % of its maximum in 1
 * nm. */
#define MAX_STEP_NM 1.0
/* The largest number of steps in one piece of a band; a piece wider than this
 * many nm has longer steps. */
#define MAX_STEPS 20000
/* The points of the rule of Gauss and Legendre with two points lie so far from
 * the middle of a step of 1: sqrt(1 / 12). */
#define GAUSS_2 0.28867513459481287

/* The luminous efficiency V every V_STEP_NM (ISO/CIE 11664-1:2019). */
static const double efficiency[] = {
    0.000039, 0.000064, 0.000120, 0.000217, 0.000396, 0.000640, 0.001210,
    0.002180, 0.004000, 0.007300, 0.011600, 0.016840, 0.023000, 0.029800,
    0.038000, 0.048000, 0.060000, 0.073900, 0.090980, 0.112600, 0.139020,
    0.169300, 0.208020, 0.258600, 0.323000, 0.407300, 0.503000, 0.608200,
    0.710000, 0.793200, 0.862000, 0.914850, 0.954000, 0.980300, 0.994950,
    1.000000, 0.995000, 0.978600, 0.952000, 0.915400, 0.870000, 0.816300,
    0.757000, 0.694900, 0.631000, 0.566800, 0.503000, 0.441200, 0.381000,
    0.321000, 0.265000, 0.217000, 0.175000, 0.138200, 0.107000, 0.081600,
    0.061000, 0.044580, 0.032000, 0.023200, 0.017000, 0.011920, 0.008210,
    0.005723, 0.004102, 0.002929, 0.002091, 0.001484, 0.001047, 0.000740,
    0.000520, 0.000361, 0.000249, 0.000172, 0.000120, 0.000085, 0.000060,
    0.000042, 0.000030, 0.000021, 0.000015};
/* The last index of the table. */
#define LAST    ((int)(sizeof efficiency / sizeof *efficiency) - 1)
#define V_TO_NM (V_FROM_NM + V_STEP_NM * LAST)

/* A band is divided at the ends of V and PAR, so that no step contains a
 * jump. */
static const double CUT_NM[] = {V_FROM_NM, PAR_FROM_NM, PAR_TO_NM, V_TO_NM};
#define CUTS (sizeof CUT_NM / sizeof *CUT_NM)

double murk_luminous_efficiency(double wavelength_nm)
{
    const double x = (wavelength_nm - V_FROM_NM) / V_STEP_NM;
    if (!(x >= 0 && x <= LAST)) {
        return 0;
    }
    /* Lagrange cubic through two values on either side of x, or through the
     * outermost four at an end of the table. */
    int i = (int)x - 1;
    i = i < 0 ? 0 : i > LAST - 3 ? LAST - 3 : i;
    const double t = x - i;
    const double *v = efficiency + i;
    return fmax(0, -v[0] * (t - 1) * (t - 2) * (t - 3) / 6 +
                       v[1] * t * (t - 2) * (t - 3) / 2 -
                       v[2] * t * (t - 1) * (t - 3) / 2 +
                       v[3] * t * (t - 1) * (t - 2) / 6);
}

double murk_photons_per_joule(double wavelength_nm)
{
    return wavelength_nm / HC_J_NM;
}

/* The amount of a quantity in one watt at a wavelength. */
static double per_watt(murk_quantity quantity, double wavelength_nm)
{
    switch (quantity) {
    case MURK_PHOTOMETRIC:
        return MURK_LUMEN_PER_WATT * murk_luminous_efficiency(wavelength_nm);
    case MURK_PHOTONS:
        return murk_photons_per_joule(wavelength_nm);
    case MURK_PAR:
        return wavelength_nm >= PAR_FROM_NM && wavelength_nm <= PAR_TO_NM
                   ? murk_photons_per_joule(wavelength_nm) * UMOL /
                         MURK_AVOGADRO
                   : 0;
    case MURK_RADIOMETRIC:
        break;
    }
    return 1;
}

static double constant(const void *context, double wavelength_nm)
{
    (void)context;
    (void)wavelength_nm;
    return 1;
}

typedef struct weighed {
    double power, counted;
} weighed;

/* Adds to the sums the power, and the power times the amount of the quantity
 * per watt, at the midpoints of equal steps between two wavelengths. */
static void add_piece(weighed *sums, murk_quantity quantity, double from_nm,
                      double to_nm, murk_spectral_shape shape,
                      const void *context)
{
    const double wanted = ceil((to_nm - from_nm) / MAX_STEP_NM);
    const int steps = (int)fmin(fmax(wanted, 0), MAX_STEPS);
    const double step = steps ? (to_nm - from_nm) / steps : 0;
    for (int i = 0; i < steps; ++i) {
        const double at = from_nm + (i + 0.5) * step;
        const double power = shape(context, at) * step;
        sums->power += power;
        sums->counted += power * per_watt(quantity, at);
    }
}

double murk_quantity_per_watt_of(murk_quantity quantity, double from_nm,
                                 double to_nm, murk_spectral_shape shape,
                                 const void *context)
{
    assert(from_nm > 0 && from_nm <= to_nm);
    if (from_nm == to_nm || quantity == MURK_RADIOMETRIC) {
        return per_watt(quantity, from_nm);
    }
    weighed sums = {0, 0};
    double start = from_nm;
    for (size_t i = 0; i < CUTS; ++i) {
        if (CUT_NM[i] > start && CUT_NM[i] < to_nm) {
            add_piece(&sums, quantity, start, CUT_NM[i], shape, context);
            start = CUT_NM[i];
        }
    }
    add_piece(&sums, quantity, start, to_nm, shape, context);
    if (!(sums.power > 0)) {
        return murk_quantity_per_watt_of(quantity, from_nm, to_nm, constant,
                                         NULL);
    }
    return sums.counted / sums.power;
}

/* Adds a part of a band in which the power per nm is linear. The two points of
 * Gauss and Legendre are exact for cubics: for the power, and for photons in
 * one step. */
static void add_linear(weighed *sums, murk_quantity quantity,
                       const double nm[2], const double power_per_nm[2],
                       double from_nm, double to_nm)
{
    /* V is met in steps; it is 0 in the rest of a band, which has no limit. */
    const bool has_steps = quantity == MURK_PHOTOMETRIC &&
                           from_nm >= V_FROM_NM && to_nm <= V_TO_NM;
    const int steps =
        has_steps ? (int)ceil((to_nm - from_nm) / MAX_STEP_NM) : 1;
    const double step = (to_nm - from_nm) / steps,
                 slope = (power_per_nm[1] - power_per_nm[0]) / (nm[1] - nm[0]);
    for (int i = 0; i < 2 * steps; ++i) {
        const double aside = i % 2 ? GAUSS_2 : -GAUSS_2;
        const double at = from_nm + (i / 2 + 0.5 + aside) * step;
        const double power =
            fmax(0, power_per_nm[0] + slope * (at - nm[0])) * step / 2;
        sums->power += power;
        sums->counted += power * per_watt(quantity, at);
    }
}

double murk_quantity_per_watt_of_table(murk_quantity quantity, double from_nm,
                                       double to_nm, size_t n, const double *nm,
                                       const double *power_per_nm)
{
    assert(from_nm > 0 && from_nm <= to_nm);
    weighed sums = {0, 0};
    /* The first part that reaches beyond from_nm. */
    size_t first = 1, last = n;
    while (first < last) {
        const size_t middle = first + (last - first) / 2;
        if (nm[middle] <= from_nm) {
            first = middle + 1;
        } else {
            last = middle;
        }
    }
    /* Each part within the band, cut at the ends of V and PAR. */
    for (size_t i = first; i < n && nm[i - 1] < to_nm; ++i) {
        const double end = fmin(to_nm, nm[i]);
        double start = fmax(from_nm, nm[i - 1]);
        for (size_t k = 0; k < CUTS && start < end; ++k) {
            if (CUT_NM[k] > start && CUT_NM[k] < end) {
                add_linear(&sums, quantity, nm + i - 1, power_per_nm + i - 1,
                           start, CUT_NM[k]);
                start = CUT_NM[k];
            }
        }
        if (start < end) {
            add_linear(&sums, quantity, nm + i - 1, power_per_nm + i - 1, start,
                       end);
        }
    }
    return sums.power > 0 ? sums.counted / sums.power
                          : murk_quantity_per_watt(quantity, from_nm, to_nm);
}

double murk_quantity_per_watt(murk_quantity quantity, double from_nm,
                              double to_nm)
{
    return murk_quantity_per_watt_of(quantity, from_nm, to_nm, constant, NULL);
}
