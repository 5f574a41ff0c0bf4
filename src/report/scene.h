/* What the page shows in space: sensors with ranges and views, photons by the
 * number of sensors that see each, readings of a fit, the path of an
 * exploration, and the surfaces and media of the scene. */
#ifndef MURK_REPORT_SCENE_H
#define MURK_REPORT_SCENE_H

#include "report/plan_points.h"
#include "report/results_in.h"
#include "world/stage.h"

#include <stdio.h>

typedef struct murk_shown_sensor {
    murk_vec3 place;
    double heading_deg, tilt_deg;     /* NaN: sees in all directions, or not
                                         known */
    const char *type;                 /* name of the type; "": none */
    const murk_scene_sensor_type *of; /* type in the scene; NULL: not known */
    double covers, only;              /* NaN: not known */
} murk_shown_sensor;

/* The page shows one state at a time: a condition of a plan, a plan or row of a
 * study, or a step of a timeline. */
#define MURK_SHOWN_STATES_MAX 32
typedef struct murk_shown_state {
    char name[160]; /* empty: it is the only state */
    murk_plan_points points;
    murk_media *media;         /* NULL: those of the scene */
    murk_fillings *fillings;   /* used by media */
    murk_phases *phases;       /* used by media */
    murk_shown_sensor *sensor; /* [sensors] */
    size_t sensors;
    char *folder;           /* of the results of a step; NULL: no step */
    murk_scene_desc *scene; /* of a step; NULL: no step, or not known */
} murk_shown_state;

/* A row of fit.csv that has a place. Rows beyond the limit are not shown. */
#define MURK_SHOWN_READINGS_MAX 2000
typedef struct murk_shown_reading {
    murk_vec3 place, to; /* to: the other end of a segment, else equal to
                            place */
    size_t row;
} murk_shown_reading;

typedef struct murk_report_scene {
    const murk_scene_desc *scene; /* of the results, borrowed; NULL: none */
    murk_stage *stage;            /* NULL: no scene, or it cannot be built */
    murk_shown_state state[MURK_SHOWN_STATES_MAX]; /* [states]; at least 1 */
    size_t states, states_asked;
    bool is_study;   /* the states are plans and rows of a study; the scene is
                        its base */
    bool is_follow;  /* the states are steps; the scene is that of the first */
    murk_vec3 *stop; /* [stops]; of the path */
    size_t stops;
    murk_table *fit;             /* fit.csv; NULL: not there */
    murk_shown_reading *reading; /* [readings] */
    size_t readings;
    char note[640]; /* why something cannot be shown; may be empty */
} murk_report_scene;

/* Largest number of photons in a page, of all states together. */
#define MURK_REPORT_PHOTONS_MAX 100000

/* Reads the photons of the folder (from plan.ply, plan-NAME.ply of conditions,
 * plan.ply of steps, coverage.ply or light.murk), sensors, path.ply and
 * fit.csv, and builds the world of the scene. If something cannot be read, the
 * note says so, and the page is made without it. Fails with MURK_NO_MEMORY.
 * Release *out in any case; it borrows from the results. */
murk_status murk_report_scene_read(murk_report_scene *out,
                                   const murk_results_in *results,
                                   murk_error *err);
void murk_report_scene_release(murk_report_scene *scene);

/* Appends "WHAT (WHY)." to the note, which is cut where it is full. */
void murk_report_scene_note(murk_report_scene *scene, const char *what,
                            const murk_error *why);

/* Builds the world of the scene, and the media of states that are conditions or
 * steps with other media. If that fails, the stage is NULL and the note says
 * why. */
void murk_report_build(murk_report_scene *scene);

/* Parts of murk_report_scene_read(): they read the states of a study, the steps
 * of a timeline, of which it chooses some evenly if there are too many, the
 * readings of fit.csv, and the stops of path.ply. They fail with MURK_NO_MEMORY
 * only; if a file cannot be read, the note says so. */
murk_status murk_report_read_study(murk_report_scene *out,
                                   const murk_yaml *study, murk_error *err);
murk_status murk_report_read_follow(murk_report_scene *out, const char *folder,
                                    const murk_yaml *follow, murk_error *err);
murk_status murk_report_read_fit(murk_report_scene *out, const char *folder,
                                 murk_error *err);
murk_status murk_report_read_path(murk_report_scene *out, const char *folder,
                                  murk_error *err);
/* Reads the sensors of a list in a JSON, except those without a place, up to a
 * limit. scene NULL: types are not known. The caller frees *out; the names of
 * types belong to the list. Fails with MURK_NO_MEMORY. */
murk_status murk_report_read_sensors(murk_shown_sensor **out, size_t *n,
                                     const murk_scene_desc *scene,
                                     const murk_yaml *list, murk_error *err);

/* True if a place can be drawn: no coordinate is NaN or larger than 1e12 m. */
bool murk_is_shown(murk_vec3 place);

/* True if there is something to show in space. */
bool murk_report_has_view(const murk_report_scene *scene);

#endif
