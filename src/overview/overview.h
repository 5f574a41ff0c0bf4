/* A look over a world before its light is traced: surfaces, media, light
 * sources, candidates, sensors, cameras, and the photons and the memory that a
 * run will take, which a pilot run of few photons foretells; with a picture on
 * request. murk check shows it. */
#ifndef MURK_OVERVIEW_OVERVIEW_H
#define MURK_OVERVIEW_OVERVIEW_H

#include "lightmap/lightmap.h"
#include "overview/section_file.h"
#include "plan/poses.h"
#include "results/session.h"
#include "world/mesh_materials.h"

typedef struct murk_overview {
    const murk_session *session; /* borrowed */
    murk_surfaces_facts surfaces;
    murk_mesh_material *mesh_name; /* [mesh_names], owned */
    size_t mesh_names;
    murk_forecast forecast;
    murk_candidates *candidates; /* owned; NULL: the scene has no sensors */
    murk_poses *poses;           /* likewise */
    unsigned ranks;      /* that the run is to be forecast for; 0: not asked */
    const char *picture; /* the file that was written; NULL: none */
    murk_section_request section; /* of the picture */
} murk_overview;

/* Looks over the stage of a session, warns of what is probably wrong in it, and
 * writes the picture if picture->path is not NULL. The session must live as
 * long as *out; its settings `threads` and `force` and its run.command count.
 * ranks: forecasts the run also for that number of ranks; 0: does not.
 * Release *out also after a failure. Fails as murk_section_file_check(),
 * murk_mesh_materials(), murk_lightmap_forecast(), murk_targets_check(),
 * murk_sites_find(), murk_poses_create() and murk_section_file_write(). If the
 * candidates are refused, the picture is drawn all the same. */
murk_status murk_overview_make(murk_overview *out, const murk_session *session,
                               const murk_section_file *picture, unsigned ranks,
                               murk_error *err);
void murk_overview_release(murk_overview *overview);

/* The JSON of murk check, for murk_session_finish(). */
cJSON *murk_overview_json(const murk_overview *overview);

/* Prints the lines of murk check (results/summary.h). `of` points to a
 * murk_overview. */
void murk_overview_print(const void *of);

#endif
