/* Finds heights above the ground by rays straight down (plan/on_ground.h). */
#include "plan/on_ground.h"

#include <math.h>
#include <stdio.h>

murk_status murk_place_on_ground(murk_vec3 *out, const murk_stage *stage,
                                 const murk_table_places *places, size_t row,
                                 murk_error *err)
{
    murk_vec3 user;
    double above_m;
    const murk_status status =
        murk_table_places_read(places, row, &user, &above_m, err);
    if (status || isnan(above_m)) {
        *out = status ? *out : murk_scene_local(stage->scene, user);
        return status;
    }
    /* Down from the top of the domain. */
    const murk_box *box = &stage->world.domain.box;
    user.z = 0;
    murk_vec3 from = murk_scene_local(stage->scene, user);
    from.z = box->max.z;
    murk_hit hit;
    if (!murk_surfaces_hit(stage->surfaces, from, murk_vec(0, 0, -1),
                           box->max.z - box->min.z, &hit)) {
        const murk_table *table = places->table;
        char *const *cell = &table->cell[row * table->columns];
        char where[MURK_SCENE_WHERE_SIZE];
        snprintf(where, sizeof where, "%.300s:%d", table->path,
                 table->line[row]);
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "above_ground_m at %s = %.24s, %s = %.24s, where the "
                         "domain has no ground",
                         table->name[places->at[0]], cell[places->at[0]],
                         table->name[places->at[1]], cell[places->at[1]]);
    }
    *out = murk_vec(from.x, from.y, from.z - hit.distance_m + above_m);
    return MURK_OK;
}
