/* What was measured in the field: the readings of a CSV file.
 *
 * Columns and meanings: contract.md, "--data" (scenes/README.md). A row to be
 * fitted is one reading, or all readings of one `group` of coverage together.
 * Values stay in the unit they were read in: the model's prediction is turned
 * into that (murk_reading_unit). */
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

/* What a reading is in, as a function of the model's own quantity: watts per
 * square metre by band for light, the transmittance of the segment for
 * transmittance, the fraction for coverage. */
typedef enum murk_reading_unit {
    MURK_UNIT_FRACTION, /* coverage, transmittance */
    MURK_UNIT_PERCENT,  /* likewise; of light: free gain needed */
    MURK_UNIT_W_PER_M2, /* light */
    MURK_UNIT_LUX,      /* light */
    MURK_UNIT_PHOTONS,  /* light: 1/s/m2 */
    MURK_UNIT_PAR,      /* light: umol/s/m2 */
    MURK_UNIT_RELATIVE, /* light: any; free gain needed */
    MURK_UNIT_TRANSMISSION_PERCENT_PER_M, /* 100 T^(1/L), 100: clear */
    MURK_UNIT_OBSCURATION_PERCENT_PER_M,  /* 100 (1 - T^(1/L)), 0: clear */
    MURK_UNIT_DB_PER_KM,                  /* -10 log10 T over L in km */
    MURK_UNIT_EXTINCTION_PER_M,           /* -ln T / L */
    MURK_UNIT_VISIBILITY_M,               /* 3.912 L / -ln T */
    MURK_UNIT_MOR_M,                      /* 2.996 L / -ln T */
    MURK_READING_UNITS
} murk_reading_unit;

typedef struct murk_reading {
    murk_reading_kind kind;
    size_t line;      /* of the file, from 1 */
    size_t condition; /* of the scene's; SIZE_MAX: the scene as it stands */
    murk_vec3 position;
    murk_vec3 to;          /* transmittance: the segment's other end */
    murk_vec3 direction;   /* irradiance: unit, the receiver's outward normal */
    double radius_m;       /* of the receiver's sphere */
    double acceptance_rad; /* NaN: none given */
    int band;              /* -1: all together */
    murk_pose pose;        /* coverage: the sensor */
    size_t gain;           /* its factor; SIZE_MAX: 1 */
    murk_reading_unit unit;
    double value, standard_error; /* in its unit; > 0 */
    bool is_held_out;
} murk_reading;

#define MURK_READINGS_MAX      100000
#define MURK_READING_GAINS_MAX 512

typedef struct murk_measured_row {
    size_t first, n; /* readings, next to each other in reading[] */
} murk_measured_row;

typedef struct murk_measurements {
    char *path;
    murk_reading
        *reading; /* [readings] those of a group are brought together */
    size_t readings;
    murk_measured_row *row; /* [rows] in the order of their first lines */
    size_t rows, held_out;  /* of them */
    char (*group)[64];      /* [rows]; empty: none. Coverage of one group and
                               condition is one row; of other kinds it is a
                               label */
    char (*gain)[64];       /* [gains] names of free factors */
    size_t gains;
    char sha256[65];
} murk_measurements;

/* Reads and checks against the scene (conditions, bands, sensor types) and its
 * domain: one line with the file's line number for what is wrong. A note says
 * of units that are derived from a transmittance by what law they compare. *out
 * is the caller's: murk_measurements_destroy(). */
murk_status murk_measurements_read(murk_measurements **out, const char *path,
                                   const murk_scene_desc *scene,
                                   const murk_domain *domain, murk_error *err);
void murk_measurements_destroy(murk_measurements *measured); /* NULL is fine */

/* The model's quantity in a row's unit, with the derivative by it; a row's gain
 * is not in it. model: coverage or transmittance; light: already summed over
 * bands in W/m2, lux, photons or PAR as unit says. length_m: of the segment; 1
 * of other kinds. Finite also where nothing passes, or all. */
double murk_reading_in_unit(murk_reading_unit unit, double model,
                            double length_m, double *slope);
const char *murk_reading_unit_name(murk_reading_unit unit);

/* The quantity that a unit of light is of; radiometric for others. */
murk_quantity murk_reading_quantity(murk_reading_unit unit);

/* From W/m2 in a band to a light unit, of the scene's bands, light taken as
 * even in wavelength within each; 1 for others. */
murk_spectrum murk_reading_per_watt(murk_reading_unit unit,
                                    const murk_scene_desc *scene);

#endif
