/* Builds spectra of sun and sky as piecewise linear functions, from the tables
 * of ASTM G173, the model of Bird and Riordan (source/clear_spectrum.h) and a
 * two-stream cloud, and integrates them over bands. */
#include "source/solar_spectrum.h"

#include "base/interval.h"
#include "base/vector.h"
#include "source/clear_sky.h"
#include "source/clear_spectrum.h"
#include "source/solar_tables.h"

#include <assert.h>

#define RAD_PER_DEG    (MURK_PI / 180) /* degrees to radians */
#define SEA_LEVEL_HPA  1013.25         /* ISO 2533 */
#define G173_CONSTANT  1366.1          /* ASTM E490-00a [W/m2] */
#define LOWEST_SUN_DEG 89.0            /* largest zenith angle */
#define ANGSTROM       1.14            /* rural aerosol, Bird and Riordan 2-7 */
/* The cloud (source/solar_spectrum.h): optical depth, radius and mean cosine of
 * the droplets. */
#define CLOUD_DEPTH         20.0
#define DROPLET_RADIUS_M    10e-6
#define DROPLET_COSINE      0.86
#define MIN_DROP_ABSORPTION 1e-12 /* keeps the two-stream formula finite */
#define MAX_DROP_ABSORPTION 0.5   /* an opaque drop still diffracts half */

murk_spectrum_air murk_spectrum_air_defaults(void)
{
    return (murk_spectrum_air){.apparent_zenith_deg = 48.19,
                               .linke_turbidity = 3,
                               .pressure_hpa = SEA_LEVEL_HPA,
                               .water_cm = 1.42,
                               .ozone_cm = 0.344,
                               .ground_albedo = 0.2};
}

double murk_aerosol_depth(const murk_spectrum_air *air)
{
    const double p = SEA_LEVEL_HPA / air->pressure_hpa;
    const double clean =
        2 + p * (0.54 + p * (-0.5 + p * 0.16)) + 0.376 * log(air->water_cm);
    return fmax(0, (air->linke_turbidity - clean) / (3.91 * exp(0.689 * p)));
}

static void add_node(murk_solar_spectrum *out, double nm, double value)
{
    assert(out->nodes < MURK_SPECTRUM_NODES);
    const size_t i = out->nodes++;
    out->nm[i] = nm;
    out->w_per_m2_nm[i] = value;
    out->up_to[i] =
        i == 0 ? 0
               : out->up_to[i - 1] + (nm - out->nm[i - 1]) *
                                         (value + out->w_per_m2_nm[i - 1]) / 2;
}

static void make_extraterrestrial(murk_solar_spectrum *out)
{
    for (size_t i = 0; i < MURK_G173_CELLS; ++i) {
        const murk_g173_cell *cell = &murk_g173[i];
        add_node(out, cell->from_nm, cell->extraterrestrial);
        add_node(out, cell[1].from_nm, cell->extraterrestrial);
    }
    out->total = G173_CONSTANT;
}

/* The absorption index of water, by a power law between the rows of the
 * table. */
static double water_index(double nm)
{
    size_t i = 0;
    while (i + 2 < MURK_WATER_INDICES && murk_water[i + 1].nm < nm) {
        ++i;
    }
    const murk_water_index *a = &murk_water[i], *b = a + 1;
    const double t = log(nm / a->nm) / log(b->nm / a->nm);
    return a->k * pow(b->k / a->k, t);
}

/* The transmittance of the cloud for diffuse light (two-stream theory). */
static double cloud_transmittance(double nm)
{
    const double absorption_per_m = 4 * MURK_PI * water_index(nm) / (nm * 1e-9);
    const double lost = fmin(
        fmax(0.85 * absorption_per_m * DROPLET_RADIUS_M, MIN_DROP_ABSORPTION),
        MAX_DROP_ABSORPTION);
    const double back = 1 - (1 - lost) * DROPLET_COSINE;
    const double u = sqrt(back / lost);
    const double depth = sqrt(3 * lost * back) * CLOUD_DEPTH;
    const double lower = exp(-depth);
    return 4 * u * lower /
           ((u + 1) * (u + 1) - (u - 1) * (u - 1) * lower * lower);
}

static void make_clear(murk_solar_spectrum *out, murk_spectrum_source source,
                       const murk_spectrum_air *air)
{
    const double zenith = fmin(air->apparent_zenith_deg, LOWEST_SUN_DEG);
    const double cosine = cos(RAD_PER_DEG * zenith);
    /* Compute the spectra, then add the requested one node by node. */
    const murk_clear_air clear = {
        .zenith_deg = zenith,
        .relative_airmass = murk_relative_airmass(zenith),
        .pressure_hpa = air->pressure_hpa,
        .water_cm = air->water_cm,
        .ozone_cm = air->ozone_cm,
        .aerosol_500 = murk_aerosol_depth(air) * pow(550. / 500, ANGSTROM),
        .ground_albedo = air->ground_albedo};
    murk_clear_spectrum spectrum;
    murk_clear_spectrum_make(&spectrum, &clear);
    for (int i = 0; i < MURK_BIRD_LINES; ++i) {
        const double global = spectrum.direct[i] * cosine + spectrum.diffuse[i];
        const double nm = murk_bird[i].nm;
        add_node(out, nm,
                 source == MURK_SPECTRUM_DIRECT      ? spectrum.direct[i]
                 : source == MURK_SPECTRUM_CLEAR_SKY ? spectrum.diffuse[i]
                 : source == MURK_SPECTRUM_OVERCAST
                     ? global * cloud_transmittance(nm)
                     : global);
    }
}

void murk_solar_spectrum_make(murk_solar_spectrum *out,
                              murk_spectrum_source source,
                              const murk_spectrum_air *air)
{
    out->nodes = 0;
    if (source == MURK_SPECTRUM_EXTRATERRESTRIAL) {
        make_extraterrestrial(out);
    } else {
        make_clear(out, source, air);
        out->total = out->up_to[out->nodes - 1];
    }
}

double murk_solar_spectrum_at(const void *spectrum, double wavelength_nm)
{
    const murk_solar_spectrum *s = spectrum;
    if (!(wavelength_nm >= s->nm[0] && wavelength_nm <= s->nm[s->nodes - 1])) {
        return 0;
    }
    const size_t i = murk_interval_of(s->nm, 1, s->nodes, wavelength_nm);
    const double t = (wavelength_nm - s->nm[i]) / (s->nm[i + 1] - s->nm[i]);
    return s->w_per_m2_nm[i] + t * (s->w_per_m2_nm[i + 1] - s->w_per_m2_nm[i]);
}

/* The integral from the first node to a wavelength. */
static double integral(const murk_solar_spectrum *s, double nm)
{
    if (!(nm > s->nm[0])) {
        return 0;
    }
    if (nm >= s->nm[s->nodes - 1]) {
        return s->up_to[s->nodes - 1];
    }
    const size_t i = murk_interval_of(s->nm, 1, s->nodes, nm);
    return s->up_to[i] +
           (nm - s->nm[i]) *
               (s->w_per_m2_nm[i] + murk_solar_spectrum_at(s, nm)) / 2;
}

double murk_solar_spectrum_share(const murk_solar_spectrum *spectrum,
                                 double from_nm, double to_nm)
{
    return (integral(spectrum, to_nm) - integral(spectrum, from_nm)) /
           spectrum->total;
}
