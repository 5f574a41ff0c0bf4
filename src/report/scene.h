/* What the report shows in space: sensors with their ranges and views, photons
 * by how many sensors see each, readings of a calibration, an explorer's path,
 * and what stands in the scene. */
#ifndef MURK_REPORT_SCENE_H
#define MURK_REPORT_SCENE_H

#include "report/plan_points.h"
#include "report/results_in.h"
#include "world/stage.h"

#include <stdio.h>

typedef struct murk_shown_sensor {
    murk_vec3 place;
    double heading_deg, tilt_deg;     /* NaN: sees all round */
    const char *type;                 /* "" where there is none */
    const murk_scene_sensor_type *of; /* of the scene; NULL: not known */
    double covers, only;              /* NaN: not known */
} murk_shown_sensor;

/* Of what is shown in turn, one: a condition of a plan, a row of a study. */
#define MURK_SHOWN_STATES_MAX 32
typedef struct murk_shown_state {
    char name[160]; /* empty: there is no other */
    murk_plan_points points;
    murk_media *media;         /* NULL: the scene's */
    murk_fillings *fillings;   /* of media */
    murk_phases *phases;       /* likewise */
    murk_shown_sensor *sensor; /* [sensors] */
    size_t sensors;
} murk_shown_state;

/* A row of fit.csv that has a place. */
#define MURK_SHOWN_READINGS_MAX 2000
typedef struct murk_shown_reading {
    murk_vec3 place, to; /* to: the other end of a line of sight, or place */
    size_t row;
} murk_shown_reading;

typedef struct murk_report_scene {
    const murk_scene_desc *scene; /* of the results */
    murk_stage *stage; /* NULL: likewise, or what it names is not there */
    murk_shown_state state[MURK_SHOWN_STATES_MAX]; /* [states], 1 or more */
    size_t states, states_asked;
    bool is_study;   /* states are its rows, the scene is its base */
    murk_vec3 *stop; /* [stops] the path's */
    size_t stops;
    murk_table *fit;             /* fit.csv; NULL: not there */
    murk_shown_reading *reading; /* [readings] */
    size_t readings;
    char note[640]; /* why something is not shown; may be empty */
} murk_report_scene;

/* Photons at most that a page has, of those in the folder. */
#define MURK_REPORT_PHOTONS_MAX 100000

/* Reads the folder's photons (plan.ply, those of its conditions, coverage.ply,
 * or light.murk's), the resolved scene, path.ply and fit.csv. What is missing
 * or cannot be read is said in the note: the page has the numbers all the same.
 * Fails with MURK_NO_MEMORY. Release in any case. */
murk_status murk_report_scene_read(murk_report_scene *out,
                                   const murk_results_in *results,
                                   murk_error *err);
void murk_report_scene_release(murk_report_scene *scene);

/* One more line of the note: what, and why. */
void murk_report_scene_note(murk_report_scene *scene, const char *what,
                            const murk_error *why);

/* Builds the scene's world, and the media of those states that are conditions.
 * Says in the note what cannot be built. */
void murk_report_build(murk_report_scene *scene);

/* Parts of reading: the states of a study, the readings of a fit, a path. */
murk_status murk_report_read_study(murk_report_scene *out,
                                   const murk_yaml *study, murk_error *err);
murk_status murk_report_read_fit(murk_report_scene *out, const char *folder,
                                 murk_error *err);
murk_status murk_report_read_path(murk_report_scene *out, const char *folder,
                                  murk_error *err);
/* A list of sensors as JSON has it. *out is for free(). */
murk_status murk_report_read_sensors(murk_shown_sensor **out, size_t *n,
                                     const murk_scene_desc *scene,
                                     const murk_yaml *list, murk_error *err);

/* Whether a place can be drawn: finite, and not beyond all measure. */
bool murk_is_shown(murk_vec3 place);

/* Whether there is anything in space to be shown. */
bool murk_report_has_view(const murk_report_scene *scene);

#endif
