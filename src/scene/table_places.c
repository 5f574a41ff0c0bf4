/* Reads places from tables (scene/table_places.h): finds the columns once, and
 * converts longitude and latitude of each row to the frame of the scene. */
#include "scene/table_places.h"

#include "scene/ground.h"

#include <math.h>
#include <stdio.h>

murk_status murk_table_places_find(murk_table_places *out,
                                   const murk_table *table,
                                   const murk_scene_desc *scene,
                                   bool may_be_above, murk_error *err)
{
    static const char *const names[] = {"x_m", "y_m", "z_m"};
    static const char *const of_earth[] = {"longitude_deg", "latitude_deg"};
    const long longitude = murk_table_column(table, "longitude_deg"),
               latitude = murk_table_column(table, "latitude_deg");
    murk_table_places p = {.table = table, .scene = scene, .above = -1};
    for (int i = 0; i < 3; ++i) {
        p.at[i] = murk_table_column(table, names[i]);
    }
    /* Longitude and latitude where there is no x and y. */
    p.is_on_earth =
        p.at[0] < 0 && p.at[1] < 0 && (longitude >= 0 || latitude >= 0);
    if (p.is_on_earth) {
        p.at[0] = longitude;
        p.at[1] = latitude;
    }
    if (p.at[2] < 0 && may_be_above) {
        p.above = murk_table_column(table, "above_ground_m");
    }
    for (int i = 0; i < 3; ++i) {
        if ((i < 2 || p.above < 0) && p.at[i] < 0) {
            return murk_fail(
                err, MURK_BAD_FILE, table->path,
                "misses column %s, must have x_m, y_m and z_m, or "
                "longitude_deg and latitude_deg in place of x_m "
                "and y_m%s",
                p.is_on_earth && i < 2 ? of_earth[i] : names[i],
                may_be_above ? ", or above_ground_m in place of z_m" : "");
        }
    }
    if (p.is_on_earth && !murk_scene_frame(scene, &p.frame)) {
        return murk_fail(err, MURK_BAD_FILE, table->path,
                         "has the columns longitude_deg and latitude_deg: the "
                         "scene must have site.longitude_deg and "
                         "site.latitude_deg");
    }
    *out = p;
    return MURK_OK;
}

murk_status murk_table_places_read(const murk_table_places *p, size_t row,
                                   murk_vec3 *out, double *above_m,
                                   murk_error *err)
{
    double value[3] = {NAN, NAN, NAN};
    *above_m = NAN;
    for (int i = 0; i < 3; ++i) {
        const bool is_above = i == 2 && p->at[2] < 0;
        const murk_status status =
            murk_table_number(p->table, row, is_above ? p->above : p->at[i],
                              NAN, is_above ? above_m : &value[i], err);
        if (status) {
            return status;
        }
    }
    /* Longitude and latitude to x and y. */
    double at[2] = {value[0], value[1]};
    if (p->is_on_earth &&
        !murk_local_from_geographic(&p->frame, value[1], value[0], at)) {
        char where[MURK_SCENE_WHERE_SIZE];
        snprintf(where, sizeof where, "%.300s:%d", p->table->path,
                 p->table->line[row]);
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "longitude %.9g and latitude %.9g degrees, must be "
                         "within %.0f km of the site",
                         value[0], value[1], MURK_LOCAL_MAX_M / 1000);
    }
    *out = murk_vec(at[0], at[1], value[2]);
    return MURK_OK;
}
