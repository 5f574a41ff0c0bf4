/* Ground from files of elevations as murk check reports it: the heights of the
 * file, and the mesh that was made of them. */
#include "overview/parts.h"

#include "results/summary.h"
#include "scene/ground.h"

#include <string.h>

/* The ground of an item of the geometry; NULL: the item is something else. */
static const murk_terrain_facts *ground_of(const murk_stage *stage, size_t item)
{
    const murk_mesh *mesh = stage->mesh[item];
    return stage->scene->geometry[item].is_geotiff && mesh ? &mesh->terrain
                                                           : NULL;
}

void murk_overview_json_ground(cJSON *root, const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    cJSON *list = murk_scene_has_ground(scene)
                      ? cJSON_AddArrayToObject(root, "ground")
                      : NULL;
    for (size_t i = 0; list && i < scene->geometries; ++i) {
        const murk_terrain_facts *t = ground_of(stage, i);
        if (!t) {
            continue;
        }
        /* Heights, the mesh, and the place on the earth. */
        cJSON *item = murk_json_item(list);
        murk_json_number(item, "geometry", (double)i);
        cJSON_AddStringToObject(item, "file", scene->geometry[i].solid.mesh);
        murk_json_number(item, "columns", (double)t->columns);
        murk_json_number(item, "rows", (double)t->rows);
        murk_json_number(item, "missing",
                         (double)(t->columns * t->rows - t->known));
        murk_json_number(item, "uncovered", (double)t->bare);
        murk_json_numbers(item, "spacing_m", t->spacing_m, 2);
        murk_json_number(item, "low_m", t->low_m);
        murk_json_number(item, "high_m", t->high_m);
        murk_json_number(item, "unit_m", t->unit_m);
        cJSON_AddStringToObject(item, "unit_from", t->unit_from);
        cJSON_AddBoolToObject(item, "are_depths", t->is_depth != 0);
        murk_json_number(item, "triangles", (double)stage->mesh[i]->triangles);
        murk_json_number(item, "error_m", t->error_m);
        murk_json_number(item, "longitude_deg", t->longitude_deg);
        murk_json_number(item, "latitude_deg", t->latitude_deg);
        cJSON_AddStringToObject(item, "system", t->crs);
    }
}

void murk_overview_print_ground(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    for (size_t i = 0; i < scene->geometries; ++i) {
        const murk_terrain_facts *t = ground_of(stage, i);
        if (!t) {
            continue;
        }
        /* The mesh, then heights and place. */
        const double n = (double)t->columns * (double)t->rows;
        murk_print("ground      geometry %zu: %zu x %zu heights, %.4g x %.4g m "
                   "apart, %.3g %% missing; %zu triangles, off by at most "
                   "%.3g m\n",
                   i, (size_t)t->columns, (size_t)t->rows, t->spacing_m[0],
                   t->spacing_m[1], 100 * (n - (double)t->known) / n,
                   stage->mesh[i]->triangles, t->error_m);
        murk_print(
            "heights     %.6g to %.6g m above site.altitude_m %.6g; unit "
            "%.6g m (%s)%s\n",
            t->low_m, t->high_m, scene->site.altitude_m, t->unit_m,
            strcmp(t->unit_from, "key") == 0    ? "height_unit"
            : strcmp(t->unit_from, "none") == 0 ? "the file states none"
                                                : "of the file",
            t->is_depth ? "; the file has depths, which count downwards" : "");
        murk_print("middle      longitude %.7f, latitude %.7f degrees; %s\n",
                   t->longitude_deg, t->latitude_deg,
                   t->crs[0] ? t->crs : "system without name");
        if (t->bare > 0) {
            murk_print("uncovered   %zu heights, each of whose triangles has a "
                       "corner without a height\n",
                       (size_t)t->bare);
        }
    }
    murk_local_frame frame;
    if (murk_scene_has_ground(scene) && murk_scene_frame(scene, &frame)) {
        murk_print("site        longitude %.7f, latitude %.7f degrees: x = y = "
                   "0\n",
                   frame.longitude_deg, frame.latitude_deg);
    }
}
