/* Places in tables: the columns x_m, y_m and z_m, or longitude_deg,
 * latitude_deg and a height. If a table has both, x_m and y_m count. */
#ifndef MURK_SCENE_TABLE_PLACES_H
#define MURK_SCENE_TABLE_PLACES_H

#include "scene/scene.h"
#include "scene/table.h"

typedef struct murk_table_places {
    const murk_table *table;
    const murk_scene_desc *scene;
    long at[3];       /* columns of x and y, or of longitude and latitude; of z;
                       * z -1: `above` */
    long above;       /* column of the height above the ground; -1: not used */
    bool is_on_earth; /* longitude and latitude */
    murk_local_frame frame;
} murk_table_places;

/* Finds the columns. may_be_above: the height may be above_ground_m in place of
 * z_m, which the caller adds to the height of the ground. Table and scene are
 * borrowed. Fails with MURK_BAD_FILE at the file if a column is missing, or if
 * there are longitudes and the site of the scene has none. */
murk_status murk_table_places_find(murk_table_places *out,
                                   const murk_table *table,
                                   const murk_scene_desc *scene,
                                   bool may_be_above, murk_error *err);

/* Reads the place of a row, in the coordinates of the scene file. With
 * above_ground_m, *above_m is that height and out->z is NAN; else *above_m is
 * NAN. Fails with MURK_BAD_VALUE at the line. */
murk_status murk_table_places_read(const murk_table_places *places, size_t row,
                                   murk_vec3 *out, double *above_m,
                                   murk_error *err);

#endif
