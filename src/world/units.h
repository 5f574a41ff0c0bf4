/* What users read of light: watts, lumens or photons, by the scene's `units`.
 *
 * One factor a light and band. A line is what it is. Between edges light of
 * sun, moon and sky has the spectrum that it has at the domain's boundary, a
 * lamp's is even in wavelength: what a medium or a wall takes within a band
 * changes no factor, since a photon knows its band alone. */
#ifndef MURK_WORLD_UNITS_H
#define MURK_WORLD_UNITS_H

#include "base/bands.h"
#include "base/stats.h"
#include "world/stage.h"

typedef struct murk_units {
    const char *power;      /* "W", "lm", "1/s", "umol/s" */
    const char *irradiance; /* "W/m2", "lux", "1/s/m2", "umol/s/m2" */
    const char *suffix;     /* of JSON keys: "w", "lm", "photons_per_s" .. */
} murk_units;

murk_units murk_units_of(murk_quantity quantity);

/* What a watt of one of the stage's lights counts as in a band. */
double murk_units_per_watt(murk_quantity quantity, const murk_stage *stage,
                           size_t light, int band);

/* What packets of packet_w watts count as, both [lights * bands], light by
 * light: given to murk_tallies_read in place of watts, they make tallies and
 * their errors ones of the quantity. */
void murk_units_packets(double *out, murk_quantity quantity,
                        const murk_stage *stage, const double *packet_w);

/* The sum over n bands of values in one unit: bands have photons of their own,
 * so their errors are independent. */
murk_estimate murk_units_sum(const murk_estimate *value, int n);

/* A note where bands count nothing: light that eyes or plants do not see. */
void murk_units_note(const murk_scene_desc *scene);

#endif
