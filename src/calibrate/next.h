/* The next measurement: of the scene's candidates, the places whose readings
 * would tell most about the parameters (fit/optimal.h). */
#ifndef MURK_CALIBRATE_NEXT_H
#define MURK_CALIBRATE_NEXT_H

#include "calibrate/calibrate.h"
#include "fit/optimal.h"

/* Of more poses every so-and-so-many-th is judged. */
#define MURK_NEXT_CANDIDATES_MAX 2000

typedef struct murk_next_place {
    murk_pose pose;        /* coverage: of that type; else its place alone */
    double gain;           /* of log det of the information, in this order */
    double predicted;      /* reading, in `unit` */
    double standard_error; /* that it is taken to have */
} murk_next_place;

typedef struct murk_next {
    murk_reading_kind kind; /* what most of the fitted readings of light are */
    murk_reading_unit unit;
    size_t condition;      /* of the scene's; SIZE_MAX: as it stands */
    double relative_error; /* the median one of these readings */
    /* as the first of these readings has them */
    murk_vec3 direction; /* irradiance */
    double radius_m;     /* of light */
    int band;            /* -1: all together */
    size_t candidates, judged;
    murk_next_place *place; /* [n] best first */
    size_t n;
    double *standard_error; /* [keys->n] of the parameters, with all of these
                               read; NaN: undetermined */
} murk_next;

/* Refuses where no fitted reading is of light or coverage, whose places could
 * be chosen, or where the scene has no sensors: before anything is fitted. */
murk_status murk_next_check(const murk_measurements *measured,
                            const murk_scene_desc *scene, murk_error *err);

/* About a finished calibration. Release it also after a failure. */
murk_status murk_next_propose(murk_next *out, size_t k,
                              const murk_calibration *found,
                              const murk_calibration_desc *desc,
                              murk_error *err);
void murk_next_release(murk_next *next);

#endif
