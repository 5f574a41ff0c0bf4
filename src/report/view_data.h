/* The data of the view in space: one JSON (report/view_json.c) and blocks of
 * bytes, which scripts in tools/report read by the ids of their elements. */
#ifndef MURK_REPORT_VIEW_DATA_H
#define MURK_REPORT_VIEW_DATA_H

#include "report/scene.h"
#include "report/view_media.h"
#include "report/view_mesh.h"
#include "report/view_sections.h"

typedef struct murk_view_data {
    const murk_report_scene *scene; /* borrowed */
    murk_box box;                   /* of what the view shows */
    murk_view_mesh mesh;
    murk_view_sections sections;
    murk_view_media media[MURK_SHOWN_STATES_MAX]; /* [medias]; different ones */
    size_t medias;
    size_t media_of[MURK_SHOWN_STATES_MAX]; /* [states]; index in media[] */
} murk_view_data;

/* Writes the data of the view as script elements that browsers do not run.
 * Fails with MURK_NO_MEMORY. */
murk_status murk_view_data_write(FILE *to, const murk_report_scene *scene,
                                 murk_error *err);

/* ---- parts of it ---- */

/* Writes the JSON, as a script element. */
void murk_view_data_json(FILE *to, const murk_view_data *data);
/* The box of the photons of a state, in which their places are written as whole
 * numbers; all 0 without photons. */
murk_box murk_view_photon_box(const murk_plan_points *points);
/* Number of bytes for each photon of the bits that tell which sensors see it: 0
 * to 4. */
size_t murk_view_bit_bytes(const murk_shown_state *state);
/* True if numbers of vertices need four bytes instead of two. */
bool murk_view_is_wide(const murk_view_mesh *mesh);

#endif
