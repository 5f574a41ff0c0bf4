/* The planes of the plan (a level section seen from above) and of the two
 * upright sections of a world, unless the user chooses the planes: for the
 * picture of murk check and the drawings of the report page. */
#ifndef MURK_WORLD_SECTION_CUT_H
#define MURK_WORLD_SECTION_CUT_H

#include "world/stage.h"

/* The box of the things in the domain: surfaces, bounded regions of media,
 * fixed sensors, cameras, site[sites], and of each lamp one point (centre,
 * corner, position or origin). The box is cut to the domain; the result is the
 * domain if there are no things, or if no part of their box is in the domain.
 */
murk_box murk_stage_things_box(const murk_stage *stage, const murk_vec3 *site,
                               size_t sites);

/* The planes of the two sections, x = result.x and y = result.y, and of the
 * plan, z = result.z, relative to the local origin (scene/origin.h). The
 * sections pass through the middle of the box of site[sites], or without sites
 * through that of murk_stage_things_box(). The plan is 1.5 m above the floor,
 * or halfway between the floor and the top of murk_stage_things_box() if this
 * top is not higher than the plan would be. The floor is the median height of
 * the surfaces below the sites, or without sites the bottom of
 * murk_stage_things_box(). In the coordinates of the user the numbers are whole
 * centimetres, unless rounding would leave the domain. */
murk_vec3 murk_stage_section_cut(const murk_stage *stage, const murk_vec3 *site,
                                 size_t sites);

#endif
