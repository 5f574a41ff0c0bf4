/* What the picture of murk check is asked to show, and the three views that
 * show it. */
#ifndef MURK_OVERVIEW_SECTION_REQUEST_H
#define MURK_OVERVIEW_SECTION_REQUEST_H

#include "overview/section_view.h"
#include "plan/targets.h"
#include "sensing/candidates.h"

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

#endif
