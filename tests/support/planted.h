/* The example calibrations of scenes/, whose answers are known since they were
 * planted: their rows, what light of many photons gives there at the planted
 * values, and fits of that with noise of a seed. */
#ifndef MURK_TESTS_PLANTED_H
#define MURK_TESTS_PLANTED_H

#include "calibrate/calibrate.h"

#include <stdbool.h>

#define PLANTED_KEYS_MAX 6

typedef struct planted_case {
    const char *name, *scene, *data;
    size_t n;
    const char *key[PLANTED_KEYS_MAX];
    double truth[PLANTED_KEYS_MAX];
    unsigned emit;  /* photons of a fit: so that their noise matters beside
                       that of the readings */
    bool fits_only; /* no comparison with plain least squares: of planted_off
                       only sigma is filled */
} planted_case;

extern const planted_case planted_fog, planted_smoke, planted_water,
    planted_coverage;

/* A case that is read; its files are imported. */
typedef struct planted_field {
    const planted_case *of;
    murk_scene_desc *scene;
    murk_imported_stages imported;
    murk_stage *stage; /* as it stands */
    murk_readings *measured;
    double *truth; /* [measured->rows] what rows read at the planted values */
    const double *start; /* [n] of fits; NULL: the scene's values */
    size_t starts;       /* of a fit; 0: one */
    char text[2][48];
    murk_override override[2]; /* of the keys made last */
} planted_field;

/* Prints what is wrong; then false. Close it also then. Before any thread or
 * ray device is there, since files are imported by children. */
bool planted_open(planted_field *field, const planted_case *of);
void planted_close(planted_field *field);

/* Keys with the scene at so many photons and a seed, good until others are
 * made; the caller's. NULL after printing. */
murk_free_keys *planted_keys(planted_field *field, unsigned emit,
                             uint32_t seed);

/* Fills truth: the mean of `lights` of `emit` photons each, with seeds that no
 * fit has. */
bool planted_light(planted_field *field, unsigned lights, unsigned emit,
                   unsigned threads);

/* Reads truth with noise of `seed`, as large as the data's standard errors. */
void planted_read(planted_field *field, uint32_t seed);

/* How far a fit is off, in search coordinates (murk_fit_search): of each key in
 * its standard error, and of all together: the square in the metric of what is
 * said to be known, chi-squared with n degrees of freedom where it is right. */
typedef struct planted_off {
    double sigma[PLANTED_KEYS_MAX], square;
    double along; /* where noise in slopes draws a fit that takes them for
                     exact, in standard errors; NaN where not all is known */
} planted_off;

typedef struct planted_fit {
    planted_off off;
    planted_off plain; /* of least squares that takes slopes for exact, on the
                          same light */
    double value[PLANTED_KEYS_MAX], standard_error[PLANTED_KEYS_MAX];
    double slope_noise, chi2, effective_share;
    long degrees_of_freedom;
    size_t traces, evaluations;
    bool converged, is_accepted;
} planted_fit;

/* Reads with noise of `seed`, and fits with light of that seed. */
bool planted_fit_once(planted_fit *out, planted_field *field, uint32_t seed,
                      unsigned threads);

/* The forward model of a field, on two threads; says why where there is none.
 */
murk_model *planted_model(const planted_field *field,
                          const murk_free_keys *keys);

/* Whether it is MURK_OK; else says why not. */
bool planted_held(murk_status status, const murk_error *err);

#endif
