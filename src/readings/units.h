/* Kinds and units of readings: names, ranges, laws, and conversions from the
 * quantity of the model. */
#ifndef MURK_READINGS_UNITS_H
#define MURK_READINGS_UNITS_H

#include "base/photometry.h"
#include "base/status.h"
#include "scene/scene.h"

typedef enum murk_reading_kind {
    MURK_READ_COVERAGE,
    MURK_READ_FLUENCE,
    MURK_READ_IRRADIANCE,
    MURK_READ_TRANSMITTANCE,
    MURK_READ_EXTINCTION,
    MURK_READING_KINDS
} murk_reading_kind;

/* True if readings of this kind need photons. The others are exact. */
static inline bool murk_reading_needs_light(murk_reading_kind kind)
{
    return kind != MURK_READ_TRANSMITTANCE && kind != MURK_READ_EXTINCTION;
}

/* A set of kinds has one bit for each kind. */
#define MURK_READING_KIND_BIT(kind) (1u << (kind))

/* Names of the kinds. */
extern const char *const murk_reading_kinds[MURK_READING_KINDS];

/* The unit of a reading, as a function of the quantity of the model: watts per
 * square metre and band for light, the transmittance T of the segment of length
 * L in metres for transmittance, the coefficient K in 1/m for extinction, the
 * fraction for coverage. Units of extinction are those of a transmittance whose
 * -ln T / L is K. */
typedef enum murk_reading_unit {
    MURK_UNIT_FRACTION, /* coverage, transmittance */
    MURK_UNIT_PERCENT,  /* coverage, transmittance; light, with a free factor */
    MURK_UNIT_W_PER_M2, /* light */
    MURK_UNIT_LUX,      /* light */
    MURK_UNIT_PHOTONS,  /* light: 1/s/m2 */
    MURK_UNIT_PAR,      /* light: umol/s/m2 */
    MURK_UNIT_RELATIVE, /* light: any; a free factor is needed */
    MURK_UNIT_TRANSMISSION_PERCENT_PER_M, /* 100 T^(1/L); 100 is clear */
    MURK_UNIT_OBSCURATION_PERCENT_PER_M,  /* 100 (1 - T^(1/L)); 0 is clear */
    MURK_UNIT_OBSCURATION_PERCENT,        /* transmittance: 100 (1 - T) */
    MURK_UNIT_OPTICAL_DEPTH,              /* transmittance: -ln T */
    MURK_UNIT_DB_PER_KM,                  /* -10 log10 T over L in km */
    MURK_UNIT_EXTINCTION_PER_M,           /* -ln T / L */
    MURK_UNIT_VISIBILITY_M,               /* 3.912 L / -ln T */
    MURK_UNIT_MOR_M,                      /* 2.996 L / -ln T */
    MURK_READING_UNITS
} murk_reading_unit;

const char *murk_reading_unit_name(murk_reading_unit unit);

/* The law that relates the unit to a transmittance T over L metres; NULL for
 * units that are proportional to the quantity of the model. Only a reading
 * without a law may have a free factor: a value that follows from a root or a
 * logarithm of T is not proportional to anything that an instrument
 * measured. */
const char *murk_reading_unit_law(murk_reading_unit unit);

/* True if readings of this kind state no absolute value in this unit and need a
 * free factor: light in percent or in relative units. */
bool murk_reading_unit_needs_gain(murk_reading_unit unit,
                                  murk_reading_kind kind);

/* Finds the unit of a word in the file for a kind of reading; an empty word
 * means fraction, or 1/m for extinction. Fails with MURK_BAD_VALUE at
 * `where` if the word is unknown or ambiguous or names a unit of other
 * kinds. */
murk_status murk_reading_unit_find(murk_reading_unit *out, const char *word,
                                   murk_reading_kind kind, const char *where,
                                   murk_error *err);

/* Fails with MURK_BAD_VALUE at `where` for a value that no instrument reads in
 * that unit, such as a fraction of 87. */
murk_status murk_reading_unit_check(murk_reading_unit unit, double value,
                                    const char *where, murk_error *err);

/* Converts the quantity of the model to the unit of a row; *slope is the
 * derivative with respect to that quantity; factors of readings are not
 * applied. Not for extinction. model: coverage or transmittance; for light, the
 * value already summed over bands in lux, photons or PAR if these are the unit,
 * else in W/m2. length_m: length of the segment; 1 for other kinds. Result and
 * *slope are finite for transmittance 0 and 1, too. */
double murk_reading_in_unit(murk_reading_unit unit, double model,
                            double length_m, double *slope);

/* Converts an extinction coefficient to the unit of a row. The result is finite
 * for an extinction of 0, too. */
double murk_reading_of_extinction(murk_reading_unit unit, double per_m);

/* The quantity (base/photometry.h) that the unit measures: lux, photons or PAR;
 * radiometric for all other units. */
murk_quantity murk_reading_quantity(murk_reading_unit unit);

/* Factors from W/m2 in a band to a unit of light, for the bands of the scene,
 * with constant power per nm within each band; bands without edges have the
 * single wavelength of the band. 1 for other units. */
murk_spectrum murk_reading_per_watt(murk_reading_unit unit,
                                    const murk_scene_desc *scene);

#endif
