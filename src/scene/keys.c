#include "scene/keys.h"

#include <float.h>
#include <stddef.h>
#include <string.h>

#include "scene/walk.h"

#define AT(type, member) \
    .at = offsetof(type, member), .size = sizeof(((type *)0)->member)
#define FLAG(type, member) .has_flag = true, .flag_at = offsetof(type, member)
#define WHERE(type, member) \
    .has_where = true, .where_at = offsetof(type, member)
#define BIT(variant) (1u << (variant))

/* Larger lengths, powers and so on are slips of the pen; within these, squares
 * and products stay finite in double, and lengths in float. */
#define LONG_M   .least = -1e9, .most = 1e9, .unit = "m"
#define SIZE_M   .above = true, .most = 1e9, .unit = "m"
#define ANY_UNIT .least = -1e9, .most = 1e9
#define POWER_W  .most = 1e15, .unit = "W"
#define SHARE    .most = 1

#define LATER(key)                          \
    {                                       \
        .name = key, .kind = MURK_KEY_LATER \
    }

/* ---- geometry ---- */

/* One of the shapes is there; the walk has checked that they exclude each
 * other and that one is given. */
static murk_status choose_geometry(murk_walk *walk, const murk_yaml *map,
                                   int *variant)
{
    (void)walk;
    *variant = murk_yaml_get(map, "box")      ? MURK_SCENE_BOX
               : murk_yaml_get(map, "rect")   ? MURK_SCENE_RECT
               : murk_yaml_get(map, "sphere") ? MURK_SCENE_SPHERE
                                              : MURK_SCENE_FILE;
    return MURK_OK;
}

static murk_status check_box(murk_walk *walk, const murk_yaml *map,
                             murk_box box)
{
    if (!(box.min.x < box.max.x && box.min.y < box.max.y &&
          box.min.z < box.max.z)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "min_m [%.9g, %.9g, %.9g] and max_m "
                              "[%.9g, %.9g, %.9g], min must be less than max "
                              "on each axis, m",
                              box.min.x, box.min.y, box.min.z, box.max.x,
                              box.max.y, box.max.z);
    }
    return MURK_OK;
}

static murk_status check_geometry_box(murk_walk *walk, const murk_yaml *map,
                                      void *item)
{
    return check_box(walk, map, ((murk_scene_geometry *)item)->box);
}

static murk_status check_edges(murk_walk *walk, const murk_yaml *map,
                               murk_vec3 edge1, murk_vec3 edge2)
{
    const double area = murk_length(murk_cross(edge1, edge2));
    /* three products and three differences: edges that are parallel but for
     * rounding leave no more than this */
    const double slack =
        4 * DBL_EPSILON * murk_length(edge1) * murk_length(edge2);
    if (!(area > slack)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "edge1_m and edge2_m span no area, must not be "
                              "zero or parallel");
    }
    return MURK_OK;
}

static murk_status check_geometry_rect(murk_walk *walk, const murk_yaml *map,
                                       void *item)
{
    const murk_scene_geometry *rect = item;
    return check_edges(walk, map, rect->edge1, rect->edge2);
}

static const murk_keys GEOMETRY_BOX = {
    .noun = "box",
    .check = check_geometry_box,
    .key = (const murk_key[]){{.name = "min_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene_geometry, box.min)},
                              {.name = "max_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene_geometry, box.max)},
                              {.name = NULL}}};

static const murk_keys GEOMETRY_RECT = {
    .noun = "rect",
    .check = check_geometry_rect,
    .key = (const murk_key[]){{.name = "corner_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene_geometry, corner)},
                              {.name = "edge1_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene_geometry, edge1)},
                              {.name = "edge2_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene_geometry, edge2)},
                              {.name = NULL}}};

static const murk_keys GEOMETRY_SPHERE = {
    .noun = "sphere",
    .key = (const murk_key[]){{.name = "center_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene_geometry, center)},
                              {.name = "radius_m",
                               .kind = MURK_KEY_NUMBER,
                               .required = true,
                               SIZE_M,
                               AT(murk_scene_geometry, radius_m)},
                              {.name = NULL}}};

static const char *const GEOMETRY_VARIANTS[] = {"file", "box", "rect",
                                                "sphere"};

static const murk_keys GEOMETRY = {
    .noun = "geometry",
    .choose = choose_geometry,
    .variant_names = GEOMETRY_VARIANTS,
    .has_variant_at = true,
    .variant_at = offsetof(murk_scene_geometry, shape),
    WHERE(murk_scene_geometry, where),
    .item_size = sizeof(murk_scene_geometry),
    .array_at = offsetof(murk_scene, geometry),
    .count_at = offsetof(murk_scene, geometries),
    .most_items = 10000,
    .key = (const murk_key[]){{.name = "file",
                               .kind = MURK_KEY_PATH,
                               .group = 1,
                               .required = true,
                               AT(murk_scene_geometry, file)},
                              {.name = "box",
                               .kind = MURK_KEY_MAP,
                               .group = 1,
                               .required = true,
                               .keys = &GEOMETRY_BOX},
                              {.name = "rect",
                               .kind = MURK_KEY_MAP,
                               .group = 1,
                               .required = true,
                               .keys = &GEOMETRY_RECT},
                              {.name = "sphere",
                               .kind = MURK_KEY_MAP,
                               .group = 1,
                               .required = true,
                               .keys = &GEOMETRY_SPHERE},
                              {.name = "unit_m",
                               .kind = MURK_KEY_NUMBER,
                               SIZE_M,
                               .variants = BIT(MURK_SCENE_FILE),
                               AT(murk_scene_geometry, unit_m)},
                              {.name = "up",
                               .kind = MURK_KEY_WORD,
                               .variants = BIT(MURK_SCENE_FILE),
                               .words = (const murk_word[]){{"x", 'x', false},
                                                            {"y", 'y', false},
                                                            {"z", 'z', false},
                                                            {NULL, 0, false}},
                               AT(murk_scene_geometry, up)},
                              {.name = "scale",
                               .kind = MURK_KEY_NUMBER,
                               .above = true,
                               .most = 1e9,
                               .preset = "1",
                               AT(murk_scene_geometry, scale)},
                              {.name = "rotate_deg",
                               .kind = MURK_KEY_VECTOR,
                               ANY_UNIT,
                               .unit = "degrees",
                               .preset = "[0, 0, 0]",
                               AT(murk_scene_geometry, rotate_deg)},
                              {.name = "translate_m",
                               .kind = MURK_KEY_VECTOR,
                               LONG_M,
                               .preset = "[0, 0, 0]",
                               AT(murk_scene_geometry, translate_m)},
                              {.name = "material",
                               .kind = MURK_KEY_REFERENCE,
                               .of = "materials",
                               AT(murk_scene_geometry, material)},
                              {.name = NULL}}};

/* ---- materials ---- */

static murk_status check_material(murk_walk *walk, const murk_yaml *map,
                                  void *item)
{
    const murk_scene_material *material = item;
    for (int i = 0; i < walk->scene->bands; ++i) {
        const double sum = material->diffuse.band[i] +
                           material->specular.band[i] +
                           material->transmit.band[i];
        /* three decimal fractions and two sums may round up: 0.35 + 0.6 +
         * 0.05 */
        if (!(sum <= 1 + 4 * DBL_EPSILON)) {
            return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                                  "diffuse + specular + transmit is %.9g at "
                                  "%.9g nm, must be at most 1",
                                  sum, walk->scene->band_nm[i]);
        }
    }
    return MURK_OK;
}

static const murk_keys MATERIAL = {
    .noun = "material",
    .check = check_material,
    WHERE(murk_scene_material, where),
    .item_size = sizeof(murk_scene_material),
    .array_at = offsetof(murk_scene, materials),
    .count_at = offsetof(murk_scene, n_materials),
    .most_items = 256,
    .name_at = offsetof(murk_scene_material, name),
    .first = "default",
    .first_preset = "{diffuse: 0.5}",
    .key = (const murk_key[]){{.name = "diffuse",
                               .kind = MURK_KEY_SPECTRUM,
                               SHARE,
                               .preset = "0",
                               AT(murk_scene_material, diffuse)},
                              {.name = "specular",
                               .kind = MURK_KEY_SPECTRUM,
                               SHARE,
                               .preset = "0",
                               AT(murk_scene_material, specular)},
                              {.name = "transmit",
                               .kind = MURK_KEY_SPECTRUM,
                               SHARE,
                               .preset = "0",
                               AT(murk_scene_material, transmit)},
                              {.name = "ior",
                               .kind = MURK_KEY_NUMBER,
                               .least = 1,
                               .most = 10,
                               AT(murk_scene_material, ior)},
                              {.name = NULL}}};

/* ---- media and their regions ---- */

enum { MEDIUM_HOMOGENEOUS, MEDIUM_GRID };

static murk_status choose_medium(murk_walk *walk, const murk_yaml *map,
                                 int *variant)
{
    (void)walk;
    *variant = murk_yaml_get(map, "vdb") ? MEDIUM_GRID : MEDIUM_HOMOGENEOUS;
    return MURK_OK;
}

static const murk_keys PHASE = {
    .noun = "phase",
    .key = (const murk_key[]){{.name = "hg",
                               .kind = MURK_KEY_SPECTRUM,
                               .group = 1,
                               .required = true,
                               .least = -1,
                               .most = 1,
                               .above = true,
                               .below = true,
                               AT(murk_scene_medium, mean_cosine)},
                              LATER("two_hg"),
                              LATER("fournier_forand"),
                              LATER("table"),
                              {.name = NULL}}};

static const char *const MEDIUM_VARIANTS[] = {"homogeneous", "grid"};

static const murk_keys MEDIUM = {
    .noun = "medium",
    .choose = choose_medium,
    .variant_names = MEDIUM_VARIANTS,
    WHERE(murk_scene_medium, where),
    .item_size = sizeof(murk_scene_medium),
    .array_at = offsetof(murk_scene, media),
    .count_at = offsetof(murk_scene, n_media),
    .most_items = 256,
    .name_at = offsetof(murk_scene_medium, name),
    .key = (const murk_key[]){
        {.name = "vdb", .kind = MURK_KEY_PATH, AT(murk_scene_medium, vdb)},
        {.name = "grid",
         .kind = MURK_KEY_TEXT,
         .variants = BIT(MEDIUM_GRID),
         AT(murk_scene_medium, grid)},
        {.name = "interpolation",
         .kind = MURK_KEY_WORD,
         .variants = BIT(MEDIUM_GRID),
         .preset = "nearest",
         .words = (const murk_word[]){{"nearest", 0, false},
                                      {"linear", 1, true},
                                      {NULL, 0, false}}},
        {.name = "extinction_per_m",
         .kind = MURK_KEY_SPECTRUM,
         .required = true,
         .most = 1e9,
         .unit = "1/m",
         AT(murk_scene_medium, extinction_per_m)},
        {.name = "albedo",
         .kind = MURK_KEY_SPECTRUM,
         .required = true,
         SHARE,
         AT(murk_scene_medium, albedo)},
        {.name = "phase",
         .kind = MURK_KEY_MAP,
         .keys = &PHASE,
         .preset = "isotropic",
         .words = (const murk_word[]){{"isotropic", 0, false},
                                      {"rayleigh", 1, true},
                                      {NULL, 0, false}}},
        LATER("preset"),
        LATER("visibility_m"),
        LATER("mor_m"),
        LATER("profile"),
        {.name = NULL}}};

static murk_status check_region_box(murk_walk *walk, const murk_yaml *map,
                                    void *item)
{
    return check_box(walk, map, ((murk_scene_region *)item)->box);
}

static const murk_keys REGION_BOX = {
    .noun = "box",
    .check = check_region_box,
    .key = (const murk_key[]){{.name = "min_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene_region, box.min)},
                              {.name = "max_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene_region, box.max)},
                              {.name = NULL}}};

static const murk_keys REGION_SPHERE = {
    .noun = "sphere",
    .key = (const murk_key[]){{.name = "center_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene_region, center)},
                              {.name = "radius_m",
                               .kind = MURK_KEY_NUMBER,
                               .required = true,
                               SIZE_M,
                               AT(murk_scene_region, radius_m)},
                              {.name = NULL}}};

static const char *const REGION_VARIANTS[] = {"everywhere", "box", "sphere",
                                              "grid"};

/* A region without a shape is everywhere, or where its medium's grid lies. */
static murk_status choose_region(murk_walk *walk, const murk_yaml *map,
                                 int *variant)
{
    const murk_yaml *media = murk_yaml_get(walk->root, "media");
    const murk_yaml *name = murk_yaml_get(map, "medium");
    const murk_yaml *medium =
        media && name && name->text ? murk_yaml_get(media, name->text) : NULL;
    const bool has_grid = medium && murk_yaml_get(medium, "vdb");
    *variant = murk_yaml_get(map, "box")      ? MURK_SCENE_IN_BOX
               : murk_yaml_get(map, "sphere") ? MURK_SCENE_IN_SPHERE
               : has_grid                     ? MURK_SCENE_IN_GRID
                                              : MURK_SCENE_EVERYWHERE;
    if (has_grid && *variant != MURK_SCENE_IN_GRID) {
        return murk_walk_fail(walk, MURK_UNSUPPORTED, map, false,
                              "a %s around a grid medium is not supported yet, "
                              "must be the grid alone",
                              REGION_VARIANTS[*variant]);
    }
    return MURK_OK;
}

#define MOVABLE                                                      \
    .variants = BIT(MURK_SCENE_IN_BOX) | BIT(MURK_SCENE_IN_SPHERE) | \
                BIT(MURK_SCENE_IN_GRID)

/* A region everywhere is not moved; its members still hold the identity. */
static murk_status check_region(murk_walk *walk, const murk_yaml *map,
                                void *item)
{
    murk_scene_region *region = item;
    (void)walk;
    (void)map;
    if (region->shape == MURK_SCENE_EVERYWHERE) {
        region->scale = 1;
    }
    return MURK_OK;
}

static const murk_keys REGION = {
    .noun = "region",
    .choose = choose_region,
    .check = check_region,
    .variant_names = REGION_VARIANTS,
    .has_variant_at = true,
    .variant_at = offsetof(murk_scene_region, shape),
    WHERE(murk_scene_region, where),
    .item_size = sizeof(murk_scene_region),
    .array_at = offsetof(murk_scene, regions),
    .count_at = offsetof(murk_scene, n_regions),
    .most_items = 64,
    .key = (const murk_key[]){
        {.name = "medium",
         .kind = MURK_KEY_REFERENCE,
         .of = "media",
         .required = true,
         AT(murk_scene_region, medium)},
        {.name = "box", .kind = MURK_KEY_MAP, .group = 1, .keys = &REGION_BOX},
        {.name = "sphere",
         .kind = MURK_KEY_MAP,
         .group = 1,
         .keys = &REGION_SPHERE},
        {.name = "scale",
         .kind = MURK_KEY_NUMBER,
         .above = true,
         .most = 1e9,
         MOVABLE,
         .preset = "1",
         AT(murk_scene_region, scale)},
        {.name = "rotate_deg",
         .kind = MURK_KEY_VECTOR,
         ANY_UNIT,
         MOVABLE,
         .unit = "degrees",
         .preset = "[0, 0, 0]",
         AT(murk_scene_region, rotate_deg)},
        {.name = "translate_m",
         .kind = MURK_KEY_VECTOR,
         LONG_M,
         MOVABLE,
         .preset = "[0, 0, 0]",
         AT(murk_scene_region, translate_m)},
        {.name = "replace",
         .kind = MURK_KEY_BOOL,
         .preset = "false",
         AT(murk_scene_region, replaces)},
        LATER("below_z_m"),
        LATER("mesh"),
        LATER("ior"),
        {.name = NULL}}};

/* ---- lights ---- */

static murk_status check_light(murk_walk *walk, const murk_yaml *map,
                               void *item)
{
    const murk_scene_light *light = item;
    if (light->type == MURK_SCENE_LIGHT_RECT) {
        return check_edges(walk, map, light->edge1, light->edge2);
    }
    if ((light->type == MURK_SCENE_LIGHT_BEAM ||
         light->type == MURK_SCENE_LIGHT_DIRECTIONAL) &&
        !(murk_length(light->direction) > 0)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "direction is [0, 0, 0], must point somewhere");
    }
    return MURK_OK;
}

static const char *const LIGHT_VARIANTS[] = {"sphere", "rect", "point", "beam",
                                             "directional"};

#define SPHERE      BIT(MURK_SCENE_LIGHT_SPHERE)
#define RECT        BIT(MURK_SCENE_LIGHT_RECT)
#define POINT       BIT(MURK_SCENE_LIGHT_POINT)
#define BEAM        BIT(MURK_SCENE_LIGHT_BEAM)
#define DIRECTIONAL BIT(MURK_SCENE_LIGHT_DIRECTIONAL)

static const murk_keys LIGHT = {
    .noun = "light",
    .selector = "type",
    .check = check_light,
    .variant_names = LIGHT_VARIANTS,
    .has_variant_at = true,
    .variant_at = offsetof(murk_scene_light, type),
    WHERE(murk_scene_light, where),
    .item_size = sizeof(murk_scene_light),
    .array_at = offsetof(murk_scene, lights),
    .count_at = offsetof(murk_scene, n_lights),
    .most_items = 256,
    .needs_item = true,
    .key = (const murk_key[]){
        {.name = "type",
         .kind = MURK_KEY_WORD,
         .required = true,
         .words =
             (const murk_word[]){
                 {"sphere", MURK_SCENE_LIGHT_SPHERE, false},
                 {"rect", MURK_SCENE_LIGHT_RECT, false},
                 {"point", MURK_SCENE_LIGHT_POINT, false},
                 {"beam", MURK_SCENE_LIGHT_BEAM, false},
                 {"directional", MURK_SCENE_LIGHT_DIRECTIONAL, false},
                 {"sun", 0, true},
                 {"moon", 0, true},
                 {"sky", 0, true},
                 {"night_sky", 0, true},
                 {NULL, 0, false}}},
        {.name = "center_m",
         .kind = MURK_KEY_VECTOR,
         .required = true,
         LONG_M,
         .variants = SPHERE,
         AT(murk_scene_light, position)},
        {.name = "corner_m",
         .kind = MURK_KEY_VECTOR,
         .required = true,
         LONG_M,
         .variants = RECT,
         AT(murk_scene_light, position)},
        {.name = "edge1_m",
         .kind = MURK_KEY_VECTOR,
         .required = true,
         LONG_M,
         .variants = RECT,
         AT(murk_scene_light, edge1)},
        {.name = "edge2_m",
         .kind = MURK_KEY_VECTOR,
         .required = true,
         LONG_M,
         .variants = RECT,
         AT(murk_scene_light, edge2)},
        {.name = "position_m",
         .kind = MURK_KEY_VECTOR,
         .required = true,
         LONG_M,
         .variants = POINT,
         AT(murk_scene_light, position)},
        {.name = "origin_m",
         .kind = MURK_KEY_VECTOR,
         .required = true,
         LONG_M,
         .variants = BEAM,
         AT(murk_scene_light, position)},
        {.name = "direction",
         .kind = MURK_KEY_VECTOR,
         .required = true,
         ANY_UNIT,
         .variants = BEAM | DIRECTIONAL,
         AT(murk_scene_light, direction)},
        {.name = "radius_m",
         .kind = MURK_KEY_NUMBER,
         .required = true,
         SIZE_M,
         .variants = SPHERE,
         AT(murk_scene_light, radius_m)},
        {.name = "radius_m",
         .kind = MURK_KEY_NUMBER,
         .most = 1e9,
         .unit = "m",
         .variants = BEAM,
         .preset = "0",
         AT(murk_scene_light, radius_m)},
        {.name = "divergence_deg",
         .kind = MURK_KEY_NUMBER,
         .most = 90,
         .unit = "degrees",
         .variants = BEAM,
         .preset = "0",
         .factor = MURK_PI / 180,
         AT(murk_scene_light, divergence_rad)},
        {.name = "power_w",
         .kind = MURK_KEY_SHARED,
         .required = true,
         POWER_W,
         .variants = SPHERE | RECT | POINT | BEAM,
         AT(murk_scene_light, power_w)},
        {.name = "irradiance_w_per_m2",
         .kind = MURK_KEY_SHARED,
         .required = true,
         .most = 1e15,
         .unit = "W/m2",
         .variants = DIRECTIONAL,
         AT(murk_scene_light, power_w)},
        LATER("schedule"),
        LATER("latitude_deg"),
        LATER("longitude_deg"),
        LATER("altitude_m"),
        LATER("time"),
        LATER("linke_turbidity"),
        {.name = NULL}}};

/* ---- photons ---- */

static murk_status check_photons(murk_walk *walk, const murk_yaml *map,
                                 void *item)
{
    const murk_scene_photons *photons = &((murk_scene *)item)->photons;
    if (photons->store > photons->max_stored) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "store %llu is more than max_stored %llu",
                              (unsigned long long)photons->store,
                              (unsigned long long)photons->max_stored);
    }
    if (photons->store > 0 && photons->maps == MURK_SCENE_MAPS_NONE) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "store %llu with maps: none, must be emit where "
                              "nothing is stored",
                              (unsigned long long)photons->store);
    }
    return MURK_OK;
}

static const murk_keys PHOTONS = {
    .noun = "photons",
    .check = check_photons,
    WHERE(murk_scene, photons.where),
    .key = (const murk_key[]){
        {.name = "emit",
         .kind = MURK_KEY_COUNT,
         .group = 1,
         .least = 1,
         .most = 4294967295.0,
         .unit = "photons",
         .preset = "100000",
         AT(murk_scene, photons.emit)},
        {.name = "store",
         .kind = MURK_KEY_COUNT,
         .group = 1,
         .least = 1,
         .most = 4294967295.0,
         .unit = "records",
         AT(murk_scene, photons.store)},
        {.name = "store_when",
         .kind = MURK_KEY_WORD,
         .preset = "reflected",
         .words = (const murk_word[]){{"reflected", 0, false},
                                      {"hit", 1, false},
                                      {NULL, 0, false}},
         AT(murk_scene, photons.store_hits)},
        {.name = "maps",
         .kind = MURK_KEY_WORD,
         .preset = "both",
         .words =
             (const murk_word[]){{"both", MURK_SCENE_MAPS_BOTH, false},
                                 {"surface", MURK_SCENE_MAPS_SURFACE, false},
                                 {"volume", MURK_SCENE_MAPS_VOLUME, false},
                                 {"none", MURK_SCENE_MAPS_NONE, false},
                                 {NULL, 0, false}},
         AT(murk_scene, photons.maps)},
        {.name = "max_stored",
         .kind = MURK_KEY_COUNT,
         .least = 1,
         .most = 4294967295.0,
         .unit = "records",
         .preset = "100000000",
         AT(murk_scene, photons.max_stored)},
        {.name = NULL}}};

/* ---- sensors ---- */

static const murk_keys SENSOR_TYPE = {
    .noun = "sensor type",
    .most_items = 1,
    .needs_item = true,
    .key = (const murk_key[]){{.name = "name",
                               .kind = MURK_KEY_TEXT,
                               .required = true,
                               AT(murk_scene, sensors.type_name)},
                              {.name = "range_m",
                               .kind = MURK_KEY_NUMBER,
                               .required = true,
                               SIZE_M,
                               AT(murk_scene, sensors.range_m)},
                              LATER("least_range_m"),
                              LATER("view"),
                              LATER("headings"),
                              LATER("tilts_deg"),
                              LATER("arrival"),
                              LATER("bands"),
                              LATER("cost"),
                              LATER("max_count"),
                              {.name = NULL}}};

#define MOST_CANDIDATES 1e7

/* max - min over spacing_m is rounded a few times: a last point that passes
 * max by less than this share of a step still counts. */
#define STEP_SLACK 1e-9

static void fill_size_by_spacing(murk_scene_sensors *sensors, double spacing)
{
    const double min[3] = {sensors->grid_min.x, sensors->grid_min.y,
                           sensors->grid_min.z};
    double *const max[3] = {&sensors->grid_max.x, &sensors->grid_max.y,
                            &sensors->grid_max.z};
    for (int i = 0; i < 3; ++i) {
        const double steps = fmin(
            floor((*max[i] - min[i]) / spacing + STEP_SLACK), MOST_CANDIDATES);
        sensors->grid_size[i] = (size_t)steps + 1;
        *max[i] = min[i] + steps * spacing;
    }
}

static murk_status check_grid(murk_walk *walk, const murk_yaml *map, void *item)
{
    murk_scene_sensors *sensors = &((murk_scene *)item)->sensors;
    const murk_vec3 min = sensors->grid_min, max = sensors->grid_max;
    if (!(min.x <= max.x && min.y <= max.y && min.z <= max.z)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "min_m [%.9g, %.9g, %.9g] and max_m "
                              "[%.9g, %.9g, %.9g], min must be at most max on "
                              "each axis, m",
                              min.x, min.y, min.z, max.x, max.y, max.z);
    }
    const murk_yaml *spacing = murk_yaml_get(map, "spacing_m");
    double spacing_m;
    if (spacing && murk_yaml_number(spacing, &spacing_m)) {
        fill_size_by_spacing(sensors, spacing_m);
    }
    const double extent[3] = {max.x - min.x, max.y - min.y, max.z - min.z};
    double points = 1;
    for (int i = 0; i < 3; ++i) {
        points *= (double)sensors->grid_size[i];
        if (extent[i] == 0 && sensors->grid_size[i] > 1) {
            return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                                  "size %zu along %c where min_m is max_m, "
                                  "must be 1",
                                  sensors->grid_size[i], "xyz"[i]);
        }
    }
    if (!(points <= MOST_CANDIDATES)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "%.9g points, must be at most 1e7", points);
    }
    return MURK_OK;
}

static const murk_keys GRID = {
    .noun = "grid",
    .check = check_grid,
    WHERE(murk_scene, sensors.grid_where),
    .key = (const murk_key[]){{.name = "min_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene, sensors.grid_min)},
                              {.name = "max_m",
                               .kind = MURK_KEY_VECTOR,
                               .required = true,
                               LONG_M,
                               AT(murk_scene, sensors.grid_max)},
                              {.name = "size",
                               .kind = MURK_KEY_SIZES,
                               .group = 1,
                               .required = true,
                               .least = 1,
                               .most = MOST_CANDIDATES,
                               .unit = "points",
                               AT(murk_scene, sensors.grid_size)},
                              {.name = "spacing_m",
                               .kind = MURK_KEY_NUMBER,
                               .group = 1,
                               .required = true,
                               SIZE_M},
                              {.name = NULL}}};

static const murk_keys CANDIDATES = {
    .noun = "candidates",
    .key = (const murk_key[]){
        {.name = "grid",
         .kind = MURK_KEY_MAP,
         .keys = &GRID,
         FLAG(murk_scene, sensors.has_grid)},
        {.name = "clearance_m",
         .kind = MURK_KEY_NUMBER,
         .most = 1e9,
         .unit = "m",
         .preset = "0",
         AT(murk_scene, sensors.clearance_m)},
        {.name = "avoid", .kind = MURK_KEY_ONLY, .preset = "[]"},
        {.name = "mount", .kind = MURK_KEY_ONLY, .preset = "free"},
        {.name = "spacing_m", .kind = MURK_KEY_ONLY, .preset = "0"},
        {.name = NULL}}};

static murk_status check_sensors(murk_walk *walk, const murk_yaml *map,
                                 void *item)
{
    const murk_scene_sensors *sensors = &((murk_scene *)item)->sensors;
    const size_t *n = sensors->grid_size;
    const uint64_t points = (uint64_t)n[0] * n[1] * n[2];
    if (sensors->has_grid && sensors->count > points) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "count is %llu, must be 1..%llu: the points of "
                              "the grid",
                              (unsigned long long)sensors->count,
                              (unsigned long long)points);
    }
    return MURK_OK;
}

static const murk_keys SENSORS = {
    .noun = "sensors",
    .check = check_sensors,
    WHERE(murk_scene, sensors.where),
    .key = (const murk_key[]){
        {.name = "types",
         .kind = MURK_KEY_LIST,
         .required = true,
         .keys = &SENSOR_TYPE},
        {.name = "candidates",
         .kind = MURK_KEY_MAP,
         .keys = &CANDIDATES,
         .preset = "{}"},
        {.name = "fixed", .kind = MURK_KEY_ONLY, .preset = "[]"},
        {.name = "count",
         .kind = MURK_KEY_COUNT,
         .group = 1,
         .least = 1,
         .most = 1e6,
         .unit = "sensors",
         AT(murk_scene, sensors.count)},
        LATER("target"),
        LATER("budget"),
        {.name = NULL}}};

/* ---- placement ---- */

static murk_status check_weights(murk_walk *walk, const murk_yaml *map,
                                 void *item)
{
    const murk_scene_placement *placement = &((murk_scene *)item)->placement;
    if (!(placement->weight_surface + placement->weight_volume > 0)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "surface and volume are both 0, one must be "
                              "more than 0");
    }
    return MURK_OK;
}

static const murk_keys WEIGHTS = {
    .noun = "weights",
    .check = check_weights,
    .key = (const murk_key[]){{.name = "surface",
                               .kind = MURK_KEY_NUMBER,
                               .required = true,
                               .most = 1e6,
                               AT(murk_scene, placement.weight_surface)},
                              {.name = "volume",
                               .kind = MURK_KEY_NUMBER,
                               .required = true,
                               .most = 1e6,
                               AT(murk_scene, placement.weight_volume)},
                              {.name = NULL}}};

static const murk_keys PLACEMENT = {
    .noun = "placement",
    WHERE(murk_scene, placement.where),
    .key = (const murk_key[]){
        {.name = "method",
         .kind = MURK_KEY_WORD,
         .preset = "best",
         .words = (const murk_word[]){{"best", MURK_SCENE_BEST, false},
                                      {"spoq", MURK_SCENE_SPOQ, false},
                                      {"greedy", MURK_SCENE_GREEDY, false},
                                      {"exact", 0, true},
                                      {NULL, 0, false}},
         AT(murk_scene, placement.method)},
        {.name = "detection",
         .kind = MURK_KEY_WORD,
         .preset = "weighted",
         .words = (const murk_word[]){{"weighted", 0, false},
                                      {"independent", 0, true},
                                      {"threshold", 0, true},
                                      {"power", 0, true},
                                      {NULL, 0, false}}},
        {.name = "visibility",
         .kind = MURK_KEY_WORD,
         .preset = "ray",
         .words = (const murk_word[]){{"ray", 0, false},
                                      {"normal", 1, false},
                                      {NULL, 0, false}},
         AT(murk_scene, placement.by_normal)},
        {.name = "through",
         .kind = MURK_KEY_WORD,
         .preset = "thin",
         .words = (const murk_word[]){{"thin", 0, false},
                                      {"block", 1, false},
                                      {"refract", 0, true},
                                      {NULL, 0, false}},
         AT(murk_scene, placement.block)},
        {.name = "knowledge",
         .kind = MURK_KEY_WORD,
         .preset = "known",
         .words = (const murk_word[]){{"known", 0, false},
                                      {"unknown", 1, false},
                                      {"explore", 0, true},
                                      {NULL, 0, false}},
         AT(murk_scene, placement.unknown)},
        {.name = "restarts",
         .kind = MURK_KEY_COUNT,
         .least = 1,
         .most = 1e6,
         .preset = "200",
         AT(murk_scene, placement.restarts)},
        {.name = "redundancy", .kind = MURK_KEY_ONLY, .preset = "1"},
        {.name = "weights",
         .kind = MURK_KEY_MAP,
         .keys = &WEIGHTS,
         .preset = "balanced",
         .words = (const murk_word[]){{"balanced", 1, false}, {NULL, 0, false}},
         AT(murk_scene, placement.balanced)},
        {.name = "hold_out",
         .kind = MURK_KEY_BOOL,
         .preset = "true",
         AT(murk_scene, placement.hold_out)},
        {.name = "nodes",
         .kind = MURK_KEY_COUNT,
         .least = 1,
         .most = 1e12,
         .preset = "1000000"},
        {.name = "over", .kind = MURK_KEY_ONLY, .preset = "null"},
        {.name = "condition_weights", .kind = MURK_KEY_ONLY, .preset = "{}"},
        {.name = NULL}}};

/* ---- the scene ---- */

static murk_status check_domain(murk_walk *walk, const murk_yaml *map,
                                void *item)
{
    return check_box(walk, map, ((murk_scene *)item)->domain.box);
}

static const murk_keys DOMAIN_KEYS = {
    .noun = "domain",
    .check = check_domain,
    WHERE(murk_scene, domain_where),
    .key =
        (const murk_key[]){{.name = "min_m",
                            .kind = MURK_KEY_VECTOR,
                            .required = true,
                            LONG_M,
                            AT(murk_scene, domain.box.min)},
                           {.name = "max_m",
                            .kind = MURK_KEY_VECTOR,
                            .required = true,
                            LONG_M,
                            AT(murk_scene, domain.box.max)},
                           {.name = "sides",
                            .kind = MURK_KEY_WORD,
                            .preset = "open",
                            .words = (const murk_word[]){{"open", 0, false},
                                                         {"periodic", 1, false},
                                                         {NULL, 0, false}},
                            AT(murk_scene, domain.is_periodic)},
                           {.name = NULL}}};

/* What others need comes first: bands before spectra, names before their
 * users. */
const murk_keys murk_scene_keys = {
    .noun = "scene",
    .key = (const murk_key[]){
        {.name = "murk",
         .kind = MURK_KEY_COUNT,
         .required = true,
         .least = 1,
         .most = 1},
        {.name = "bands_nm",
         .kind = MURK_KEY_BANDS,
         .group = 1,
         .above = true,
         .most = 1e9,
         .unit = "nm",
         .preset = "[550]",
         .lights = true,
         AT(murk_scene, band_nm)},
        {.name = "band_edges_nm",
         .kind = MURK_KEY_BAND_EDGES,
         .group = 1,
         .above = true,
         .most = 1e9,
         .unit = "nm",
         .lights = true,
         AT(murk_scene, band_edge_nm)},
        {.name = "seed",
         .kind = MURK_KEY_COUNT,
         .most = 4294967295.0,
         .preset = "1",
         .lights = true,
         AT(murk_scene, seed)},
        {.name = "north",
         .kind = MURK_KEY_ONLY,
         .preset = "[0, 1, 0]",
         .lights = true},
        {.name = "domain",
         .kind = MURK_KEY_MAP,
         .keys = &DOMAIN_KEYS,
         .lights = true,
         FLAG(murk_scene, has_domain)},
        {.name = "materials",
         .kind = MURK_KEY_NAMED,
         .keys = &MATERIAL,
         .preset = "{}",
         .lights = true},
        {.name = "geometry",
         .kind = MURK_KEY_LIST,
         .keys = &GEOMETRY,
         .preset = "[]",
         .lights = true},
        {.name = "media",
         .kind = MURK_KEY_NAMED,
         .keys = &MEDIUM,
         .preset = "{}",
         .lights = true},
        {.name = "regions",
         .kind = MURK_KEY_LIST,
         .keys = &REGION,
         .preset = "[]",
         .lights = true},
        {.name = "lights",
         .kind = MURK_KEY_LIST,
         .keys = &LIGHT,
         .required = true,
         .lights = true},
        {.name = "photons",
         .kind = MURK_KEY_MAP,
         .keys = &PHOTONS,
         .preset = "{}",
         .lights = true},
        {.name = "flight",
         .kind = MURK_KEY_WORD,
         .preset = "march",
         .lights = true,
         .words = (const murk_word[]){{"march", 0, false},
                                      {"delta", 1, true},
                                      {NULL, 0, false}}},
        {.name = "tallies", .kind = MURK_KEY_ONLY, .preset = "[]"},
        {.name = "sensors",
         .kind = MURK_KEY_MAP,
         .keys = &SENSORS,
         FLAG(murk_scene, sensors.given)},
        {.name = "placement",
         .kind = MURK_KEY_MAP,
         .keys = &PLACEMENT,
         .preset = "{}"},
        {.name = "conditions", .kind = MURK_KEY_ONLY, .preset = "{}"},
        {.name = "cameras", .kind = MURK_KEY_ONLY, .preset = "[]"},
        {.name = NULL}}};

const murk_key *murk_keys_find(const murk_keys *keys, const char *name)
{
    for (const murk_key *key = keys->key; key->name; ++key) {
        if (strcmp(key->name, name) == 0) {
            return key;
        }
    }
    return NULL;
}
