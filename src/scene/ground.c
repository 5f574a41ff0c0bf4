/* The site from the coordinates of a file, and requests for ground
 * (scene/ground.h).
 *
 * The site is put into the tree before the tree is read, so that lights of the
 * sky inherit it like a site of the user, and the resolved scene has it. */
#include "scene/ground.h"

#include "scene/value.h"
#include "terrain/units.h"

#include <stdio.h>
#include <stdlib.h>

/* Decimals of degrees: 1 cm on the ground, far less than the size of a pixel.
 */
#define DECIMALS 7

/* The node with the name of the file of the first geometry that is a GeoTIFF
 * file; NULL: there is none. *item: its number. */
static const murk_yaml *find_file(const murk_yaml *root, size_t *item)
{
    const murk_yaml *list = murk_yaml_get(root, "geometry"), *file = NULL;
    for (size_t i = 0; list && list->kind == MURK_YAML_LIST && i < list->n;
         ++i) {
        const murk_yaml *node = murk_yaml_get(list->child[i], "geotiff");
        if (node && !file) {
            file = node->kind == MURK_YAML_MAP ? murk_yaml_get(node, "file")
                                               : node;
            *item = i;
        }
    }
    return file && file->kind == MURK_YAML_SCALAR && file->text[0] != '\0'
               ? file
               : NULL;
}

bool murk_ground_is_in(const murk_yaml *root)
{
    size_t item;
    return find_file(root, &item) != NULL;
}

static murk_status put_degrees(murk_key_reader *walk, murk_yaml *site,
                               const char *name, double degrees)
{
    char text[32];
    snprintf(text, sizeof text, "%.*f", DECIMALS, degrees);
    return murk_walk_put_preset(walk, site, name, text);
}

murk_status murk_ground_complete(murk_key_reader *walk, murk_yaml *root)
{
    murk_yaml *site = murk_yaml_get(root, "site");
    size_t item = 0;
    const murk_yaml *file = find_file(root, &item);
    if (!file || (site && (site->kind != MURK_YAML_MAP ||
                           murk_yaml_get(site, "latitude_deg") ||
                           murk_yaml_get(site, "longitude_deg")))) {
        return MURK_OK;
    }
    /* The middle of the file. */
    char key[64];
    murk_scene_where where;
    snprintf(key, sizeof key, "geometry.%zu.geotiff", item);
    murk_walk_where(file, key, false, where);
    murk_terrain_facts facts;
    char *path = murk_value_opened(file);
    murk_status status =
        path ? murk_geotiff_facts(&facts, path, where, walk->err)
             : murk_walk_no_memory(walk);
    free(path);
    /* Into the tree. */
    if (!status && !site) {
        status = murk_walk_put_preset(walk, root, "site", "{}");
        site = murk_yaml_get(root, "site");
    }
    if (!status) {
        status = put_degrees(walk, site, "latitude_deg", facts.latitude_deg);
    }
    return status
               ? status
               : put_degrees(walk, site, "longitude_deg", facts.longitude_deg);
}

bool murk_scene_has_ground(const murk_scene_desc *scene)
{
    bool has = false;
    for (size_t i = 0; i < scene->geometries; ++i) {
        has = has || scene->geometry[i].is_geotiff;
    }
    return has;
}

bool murk_scene_frame(const murk_scene_desc *scene, murk_local_frame *out)
{
    const murk_scene_site *site = &scene->site;
    if (!site->has_latitude || !site->has_longitude) {
        return false;
    }
    *out = murk_local_frame_at(site->latitude_deg, site->longitude_deg,
                               scene->north.x, scene->north.y);
    return true;
}

murk_geotiff_asked murk_scene_ground_asked(const murk_scene_desc *scene,
                                           size_t i)
{
    /* terrain/units.h has the source of feet. */
    static const double m[] = {[MURK_SCENE_HEIGHT_M] = 1,
                               [MURK_SCENE_HEIGHT_CM] = 0.01,
                               [MURK_SCENE_HEIGHT_FT] = MURK_FOOT_M,
                               [MURK_SCENE_HEIGHT_US_FT] = MURK_US_FOOT_M};
    const murk_scene_geometry *g = &scene->geometry[i];
    murk_geotiff_asked asked = g->geotiff;
    asked.unit_m = g->height_unit ? m[g->height_unit] : 0;
    asked.altitude_m = scene->site.altitude_m;
    asked.has_frame = murk_scene_frame(scene, &asked.frame);
    return asked;
}
