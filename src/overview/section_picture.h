/* The picture of murk check: plan, front section and side section of a scene on
 * one sheet, with sensors, light sources, media and a legend.
 *
 * The plan looks down, the front section along +y and the side section along
 * -x. The plan stands above the front section and shares x with it; the side
 * section stands to the right of the front section and shares z with it (third
 * angle projection). All three have one scale. */
#ifndef MURK_OVERVIEW_SECTION_PICTURE_H
#define MURK_OVERVIEW_SECTION_PICTURE_H

#include "overview/section_request.h"

/* The least size of a sheet [pixels]: views and a legend of readable letters
 * fit into no smaller one. */
#define MURK_SECTION_WIDTH_MIN  640
#define MURK_SECTION_HEIGHT_MIN 480

/* Draws the sheet; sets request->cut to the planes, and request->view. The
 * caller destroys *out. Fails with MURK_BAD_VALUE at "cut_m" if a plane of the
 * request is outside of the domain, with MURK_NO_MEMORY, or as
 * murk_canvas_create() does. */
murk_status murk_section_picture_draw(murk_canvas **out,
                                      murk_section_request *request,
                                      murk_error *err);

#endif
