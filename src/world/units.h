/* Conversion of radiant power into the quantity of the key `units`: watts,
 * lumens, photons per second, or photosynthetic photons.
 *
 * There is one factor for each light source and band. A band without edges is a
 * single wavelength. Within a band that has edges, the light of sun, moon and
 * skies has the spectrum of murk_sky_facts (world/sky.h), and the light of any
 * other source is even in wavelength. Attenuation by media and surfaces within
 * a band does not change the factor, because a photon carries a band and no
 * wavelength. */
#ifndef MURK_WORLD_UNITS_H
#define MURK_WORLD_UNITS_H

#include "base/bands.h"
#include "base/stats.h"
#include "world/stage.h"

typedef struct murk_units {
    const char *power;      /* "W", "lm", "1/s", "umol/s" */
    const char *irradiance; /* "W/m2", "lux", "1/s/m2", "umol/s/m2" */
    const char *suffix;     /* "w", "lm", "photons_per_s", "umol_per_s": the
                             * end of JSON keys of power, such as emitted_lm */
} murk_units;

murk_units murk_units_of(murk_quantity quantity);

/* The value of one watt of a light source in a band, in the unit
 * murk_units.power of the quantity. */
double murk_units_per_watt(murk_quantity quantity, const murk_stage *stage,
                           size_t light, int band);

/* Converts the power of photon packets, packet_w[lights * bands], all bands of
 * the first light source first, into out[lights * bands] in the unit
 * murk_units.power of the quantity. If out is passed to murk_tallies_read() as
 * packet_w, tallies and their errors are in the quantity. */
void murk_units_packets(double *out, murk_quantity quantity,
                        const murk_stage *stage, const double *packet_w);

/* The sum of n estimates of different bands, value[n]. Each band has its own
 * photons, so the errors are independent and the squares of the standard errors
 * add up. */
murk_estimate murk_units_sum(const murk_estimate *value, int n);

/* Prints a note that lists the bands whose light, if even in wavelength, counts
 * 0 in the quantity of the scene: light that eyes or plants do not detect.
 * Prints nothing if there is no such band. In a photometric scene, warns of the
 * first luminaire without a spectrum whose lumens count as another flux in the
 * bands. */
void murk_units_note(const murk_scene_desc *scene);

#endif
