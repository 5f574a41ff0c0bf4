/* Surfaces in a level and an upright plane, as lines for the drawings from
 * above and from the side. */
#ifndef MURK_REPORT_VIEW_SECTIONS_H
#define MURK_REPORT_VIEW_SECTIONS_H

#include "geometry/plane_cut.h"
#include "report/data.h"
#include "report/scene.h"

/* The drawings: from above, and from the side along y. */
#define MURK_VIEW_SECTIONS 2

typedef struct murk_view_sections {
    murk_vec3 cut; /* the planes, in local coordinates */
    murk_box box;  /* the domain, which lines are drawn in */
    murk_plane_cut lines[MURK_VIEW_SECTIONS]; /* empty without a world */
} murk_view_sections;

/* Cuts the world of a report where murk check would cut it for the sensors of
 * the first state. Fails with MURK_NO_MEMORY. Release *out in any case. */
murk_status murk_view_sections_make(murk_view_sections *out,
                                    const murk_report_scene *scene,
                                    murk_error *err);
void murk_view_sections_release(murk_view_sections *sections);

/* Adds `sections`: a list of {axis, at_m, asked, count, lines}. Each line is
 * four floats: two coordinates of two ends, counted from the lower corner of
 * the domain. */
void murk_view_sections_add(murk_data *data,
                            const murk_view_sections *sections);

#endif
