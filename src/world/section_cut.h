/* Where plans and sections of a world are cut if nobody says: for the picture
 * of murk check and the drawings of the report page. */
#ifndef MURK_WORLD_SECTION_CUT_H
#define MURK_WORLD_SECTION_CUT_H

#include "world/stage.h"

/* The box of everything in the domain: surfaces, bounded regions, lamps, fixed
 * sensors, cameras, and site[sites]; the domain if there is nothing. */
murk_box murk_stage_things_box(const murk_stage *stage, const murk_vec3 *site,
                               size_t sites);

/* The planes x, y, z: the sections through the middle of the sites, or of
 * everything without sites; the plan 1.5 m above the floor below the sites, or
 * at half the height of a world that is lower. Whole centimetres in the
 * coordinates of the user. */
murk_vec3 murk_stage_section_cut(const murk_stage *stage, const murk_vec3 *site,
                                 size_t sites);

#endif
