/* What the view in space draws, as its script reads it: one JSON text and
 * blocks of bytes (tools/report/view.js reads these names). */
#ifndef MURK_REPORT_VIEW_DATA_H
#define MURK_REPORT_VIEW_DATA_H

#include "report/scene.h"
#include "report/view_media.h"
#include "report/view_mesh.h"

typedef struct murk_view_data {
    const murk_report_scene *scene; /* borrowed */
    murk_box box;                   /* of what is to be looked at */
    murk_view_mesh mesh;
    murk_view_media media[MURK_SHOWN_STATES_MAX]; /* [medias] that differ */
    size_t medias;
    size_t media_of[MURK_SHOWN_STATES_MAX]; /* of each state: its media */
} murk_view_data;

/* The view's data as script elements that no browser runs. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_view_data_write(FILE *to, const murk_report_scene *scene,
                                 murk_error *err);

/* ---- parts of it ---- */

/* The JSON, as a script element. */
void murk_view_data_json(FILE *to, const murk_view_data *data);
/* Of a state's photons, between whose corners places are sent. */
murk_box murk_view_photon_box(const murk_plan_points *points);
/* A photon's bits of who sees it. */
size_t murk_view_bit_bytes(const murk_shown_state *state);
/* Whether corners' numbers need four bytes. */
bool murk_view_is_wide(const murk_view_mesh *mesh);

#endif
