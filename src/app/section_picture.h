/* The picture of murk check: plan, front section and side section of a scene on
 * one sheet, with sensors, light sources, media and a legend.
 *
 * The plan looks down, the front section along +y and the side section along
 * -x. The plan stands above the front section and shares x with it; the side
 * section stands to the right of the front section and shares z with it (third
 * angle projection). All three have one scale. */
#ifndef MURK_APP_SECTION_PICTURE_H
#define MURK_APP_SECTION_PICTURE_H

#include "app/section_view.h"
#include "plan/targets.h"
#include "sensing/candidates.h"

/* The least size of a sheet [pixels]: views and a legend of readable letters
 * fit into no smaller one. */
#define MURK_SECTION_WIDTH_MIN  640
#define MURK_SECTION_HEIGHT_MIN 480

/* The views, in the order of their arrays. */
enum { MURK_SECTION_PLAN, MURK_SECTION_FRONT, MURK_SECTION_SIDE };
#define MURK_SECTIONS 3

typedef struct murk_section_request {
    const murk_stage *stage;
    const murk_candidates *candidates; /* NULL: none */
    const murk_targets *targets;       /* NULL: none */
    bool has_cut;
    murk_vec3 cut;    /* planes x, y, z relative to the local origin; without
                       * has_cut they are chosen */
    size_t pixels[2]; /* size of the sheet; 0: 1600 wide, as high as needed */
    double escaped_share; /* of the light of the pilot photons */
    unsigned threads;
    /* Set by murk_section_picture_draw(): */
    murk_section_view view[MURK_SECTIONS];
} murk_section_request;

/* Draws the sheet; sets request->cut to the planes, and request->view. The
 * caller destroys *out. Fails with MURK_BAD_VALUE if a plane of the request is
 * outside of the domain, MURK_NO_MEMORY, or as murk_canvas_create() does. */
murk_status murk_section_picture_draw(murk_canvas **out,
                                      murk_section_request *request,
                                      murk_error *err);

#endif
