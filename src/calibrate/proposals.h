/* Proposes the next measurements: candidates of the scene whose readings
 * together would reduce the uncertainty of the parameters most, as far as
 * greedy selection and exchanges find them (D-optimal design,
 * fit/optimal.h). */
#ifndef MURK_CALIBRATE_PROPOSALS_H
#define MURK_CALIBRATE_PROPOSALS_H

#include "calibrate/calibrate.h"
#include "fit/optimal.h"

/* Limit on the candidates that are evaluated; of more, every k-th is. */
#define MURK_PROPOSALS_CANDIDATES_MAX 2000

typedef struct murk_proposed_place {
    murk_pose pose;        /* coverage: a pose of that sensor type; else a
                            * position alone */
    double gain;           /* increase of the logarithm of the determinant of
                            * the information by this place, after the places
                            * before it in place[] */
    double predicted;      /* predicted reading, in `unit` */
    double standard_error; /* assumed error of the reading */
} murk_proposed_place;

typedef struct murk_proposals {
    murk_reading_kind kind; /* the most frequent kind of the fitted rows of
                             * coverage, fluence and irradiance */
    murk_reading_unit unit;
    size_t condition;      /* number in the scene; SIZE_MAX: the scene without a
                            * condition */
    double relative_error; /* median over these rows of the standard error
                            * divided by the absolute value, at most 1 */
    /* Properties of the first of these readings. */
    murk_vec3 direction;        /* irradiance */
    double radius_m;            /* of the receiver */
    int band;                   /* -1: all bands together */
    size_t candidates, judged;  /* candidates of the scene; those that were
                                 * evaluated */
    murk_proposed_place *place; /* [n]; best first */
    size_t n;
    double *standard_error; /* [number of keys]; standard errors of the
                               parameters if all of these places were measured;
                               NaN: undetermined */
} murk_proposals;

/* Fails with MURK_BAD_VALUE if no fitted reading is of coverage, fluence or
 * irradiance, so that no place could be chosen, or if the scene has no sensors.
 * To be called before anything is fitted. */
murk_status murk_proposals_check(const murk_readings *measured,
                                 const murk_scene_desc *scene, murk_error *err);

/* Proposes k places, or all candidates if there are fewer, after the
 * calibration `found`. Release *out also after a failure. */
murk_status murk_proposals_create(murk_proposals *out, size_t k,
                                  const murk_calibration *found,
                                  const murk_calibration_desc *desc,
                                  murk_error *err);
void murk_proposals_release(murk_proposals *next);

#endif
