/* What the report shows in space: sensors with their ranges and views, photons
 * by how many sensors see each, and what stands in the scene. */
#ifndef MURK_APP_REPORT_SCENE_H
#define MURK_APP_REPORT_SCENE_H

#include "app/plan_points.h"
#include "app/results_in.h"
#include "study/stage.h"

#include <stdio.h>

typedef struct murk_shown_sensor {
    murk_vec3 place;
    double heading_deg, tilt_deg;     /* NaN: sees all round */
    const char *type;                 /* "" where there is none */
    const murk_scene_sensor_type *of; /* of the scene; NULL: not known */
    double covers, only;              /* NaN: not known */
} murk_shown_sensor;

typedef struct murk_report_scene {
    murk_scene *scene; /* NULL: not there, or cannot be read */
    murk_stage *stage; /* NULL: likewise, or what it names is not there */
    murk_plan_points points;
    murk_shown_sensor *sensor; /* [sensors] */
    size_t sensors;
    char note[640]; /* why something is not shown; may be empty */
} murk_report_scene;

/* Photons at most, of those in the folder. */
#define MURK_REPORT_PHOTONS_MAX 100000

/* Reads plan.ply and scene.yaml of the folder. What is missing or cannot be
 * read is said in the note: the page has the numbers all the same. Fails with
 * MURK_NO_MEMORY. Release in any case. */
murk_status murk_report_scene_read(murk_report_scene *out,
                                   const murk_results_in *results,
                                   murk_error *err);
void murk_report_scene_release(murk_report_scene *scene);

/* The view in space: a section that the page's script fills, and its data;
 * what is shown of how much is said in it. Needs what murk_report_plans() does.
 * Fails with MURK_NO_MEMORY. */
murk_status murk_report_view(FILE *to, const murk_report_scene *scene,
                             murk_error *err);

/* The section of places: the view, and the scene from above and from the side
 * as inline SVG; nothing where there is neither sensor nor photon. */
murk_status murk_report_plans(FILE *to, const murk_report_scene *scene,
                              murk_error *err);

#endif
