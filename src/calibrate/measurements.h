/* The readings of a CSV file, and the rows of a fit that they form.
 *
 * Columns and meanings: scenes/README.md, "--data". A row of a fit is one
 * reading, or all readings of one `group` of coverage together. Values stay in
 * the unit of the file; the prediction of the model is converted to it
 * (murk_reading_in_unit()). */
#ifndef MURK_CALIBRATE_MEASUREMENTS_H
#define MURK_CALIBRATE_MEASUREMENTS_H

#include "base/status.h"
#include "scene/scene.h"
#include "sensing/sensor.h"

typedef enum murk_reading_kind {
    MURK_READ_COVERAGE,
    MURK_READ_FLUENCE,
    MURK_READ_IRRADIANCE,
    MURK_READ_TRANSMITTANCE
} murk_reading_kind;

/* The unit of a reading, as a function of the quantity of the model: watts per
 * square metre and band for light, the transmittance of the segment for
 * transmittance, the fraction for coverage. */
typedef enum murk_reading_unit {
    MURK_UNIT_FRACTION, /* coverage, transmittance */
    MURK_UNIT_PERCENT,  /* likewise; for light a free factor is needed */
    MURK_UNIT_W_PER_M2, /* light */
    MURK_UNIT_LUX,      /* light */
    MURK_UNIT_PHOTONS,  /* light: 1/s/m2 */
    MURK_UNIT_PAR,      /* light: umol/s/m2 */
    MURK_UNIT_RELATIVE, /* light: any; a free factor is needed */
    MURK_UNIT_TRANSMISSION_PERCENT_PER_M, /* 100 T^(1/L); 100 is clear */
    MURK_UNIT_OBSCURATION_PERCENT_PER_M,  /* 100 (1 - T^(1/L)); 0 is clear */
    MURK_UNIT_DB_PER_KM,                  /* -10 log10 T over L in km */
    MURK_UNIT_EXTINCTION_PER_M,           /* -ln T / L */
    MURK_UNIT_VISIBILITY_M,               /* 3.912 L / -ln T */
    MURK_UNIT_MOR_M,                      /* 2.996 L / -ln T */
    MURK_READING_UNITS
} murk_reading_unit;

typedef struct murk_reading {
    murk_reading_kind kind;
    size_t line;      /* line of the file, from 1 */
    size_t condition; /* number in the scene; SIZE_MAX: the scene without a
                       * condition */
    murk_vec3 position;
    murk_vec3 to;          /* transmittance: the other end of the segment */
    murk_vec3 direction;   /* irradiance: unit vector, outward normal of the
                            * receiver */
    double radius_m;       /* radius of the sphere of the receiver */
    double acceptance_rad; /* NaN: not given */
    int band;              /* -1: all bands together */
    murk_pose pose;        /* coverage: the sensor */
    size_t gain;           /* index of the factor; SIZE_MAX: no factor */
    murk_reading_unit unit;
    double value, standard_error; /* in this unit; the error is above 0 */
    bool is_held_out;
} murk_reading;

/* Limits of a file: the readings of any field campaign, and factors that fit
 * into the parameters of a fit. */
#define MURK_READINGS_MAX      100000
#define MURK_READING_GAINS_MAX 512

typedef struct murk_measured_row {
    size_t first, n; /* readings of the row, adjacent in reading[] */
} murk_measured_row;

typedef struct murk_measurements {
    char *path;
    /* readings of a group are adjacent */
    murk_reading
        *reading; /* [readings] those of a group are brought together */
    size_t readings;
    murk_measured_row *row; /* [rows]; in the order of their first lines */
    size_t rows, held_out;  /* held_out: number of rows that are held out */
    char (*group)[64];      /* [rows]; empty: none. Coverage of one group and
                             * condition is one row; for other kinds the group
                             * is a label */
    char (*gain)[64];       /* [gains]; names of free factors */
    size_t gains;
    char sha256[65];
} murk_measurements;

/* Reads and checks a file against the scene (conditions, bands, sensor types)
 * and the domain; the message for an error has the line number. A note states
 * the law of units that are derived from a transmittance. The caller owns *out
 * (murk_measurements_destroy()). */
murk_status murk_measurements_read(murk_measurements **out, const char *path,
                                   const murk_scene_desc *scene,
                                   const murk_domain *domain, murk_error *err);
void murk_measurements_destroy(murk_measurements *measured); /* NULL is fine */

/* Converts the quantity of the model to the unit of a row, with the derivative;
 * factors of readings are not applied. model: coverage or transmittance; for
 * light, the value already summed over bands in W/m2, lux, photons or PAR as
 * the unit requires. length_m: length of the segment; 1 for other kinds. Finite
 * for transmittance 0 and 1, too. */
double murk_reading_in_unit(murk_reading_unit unit, double model,
                            double length_m, double *slope);
const char *murk_reading_unit_name(murk_reading_unit unit);

/* The quantity of a unit of light; radiometric for others. */
murk_quantity murk_reading_quantity(murk_reading_unit unit);

/* Factors from W/m2 in a band to a unit of light, for the bands of the scene,
 * with light even in wavelength within each band; 1 for other units. */
murk_spectrum murk_reading_per_watt(murk_reading_unit unit,
                                    const murk_scene_desc *scene);

#endif
