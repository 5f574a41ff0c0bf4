/* Where plans and sections of a world are cut unless the user chooses the
 * planes: for the picture of murk check and the drawings of the report page. */
#ifndef MURK_WORLD_SECTION_CUT_H
#define MURK_WORLD_SECTION_CUT_H

#include "world/stage.h"

/* The box of everything in the domain: surfaces, bounded regions, lamps, fixed
 * sensors, cameras, and site[sites]; the domain if there is nothing. */
murk_box murk_stage_things_box(const murk_stage *stage, const murk_vec3 *site,
                               size_t sites);

/* The planes of the two sections, x = result.x and y = result.y, and of the
 * plan, z = result.z, relative to the local origin (scene/origin.h). The
 * sections pass through the middle of the box of the sites, or without sites of
 * murk_stage_things_box(). The plan is 1.5 m above the floor below the sites,
 * or halfway between this floor and the highest thing if that is lower. In the
 * coordinates of the user the numbers are whole centimetres, unless rounding
 * would leave the domain. */
murk_vec3 murk_stage_section_cut(const murk_stage *stage, const murk_vec3 *site,
                                 size_t sites);

#endif
