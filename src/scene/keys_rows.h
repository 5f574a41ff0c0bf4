/* Macros for the rows of the key tables, and checks that several tables
 * share. Only keys*.c include this file. */
#ifndef MURK_SCENE_KEYS_ROWS_H
#define MURK_SCENE_KEYS_ROWS_H

#include <stddef.h>

#include "scene/keys.h"
#include "scene/walk.h"

#define ROW(name_, kind_, ...)                               \
    {                                                        \
        .name = name_, .kind = MURK_KEY_##kind_, __VA_ARGS__ \
    }
#define END          \
    {                \
        .name = NULL \
    }
/* Ends a list of words. */
#define WORDS_END \
    {             \
        NULL, 0   \
    }

#define NEEDED .required = true
#define AT(type, member) \
    .at = offsetof(type, member), .size = sizeof(((type *)0)->member)
#define FLAG(type, member) .has_flag = true, .flag_at = offsetof(type, member)
#define WHERE(type, member) \
    .has_where = true, .where_at = offsetof(type, member)
#define VARIANT(type, member) \
    .has_variant_at = true, .variant_at = offsetof(type, member)
#define ITEMS(type, array, count)                                            \
    .item_size = sizeof(type), .array_at = offsetof(murk_scene_desc, array), \
    .count_at = offsetof(murk_scene_desc, count)
#define BIT(variant) (1u << (variant))

/* Ranges. Larger lengths, powers and so on are mistakes; within these ranges
 * squares and products stay finite in double precision, and lengths in
 * single precision. */
#define LONG_M    .min = -1e9, .max = 1e9, .unit = "m"
#define SIZE_M    .above = true, .max = 1e9, .unit = "m"
#define ANY_UNIT  .min = -1e9, .max = 1e9
#define SHARE     .max = 1
#define LATITUDE  .min = -90, .max = 90, .unit = "degrees"
#define LONGITUDE .min = -180, .max = 360, .unit = "degrees"
#define ALTITUDE  .min = -500, .max = 9000, .unit = "m"

#define MURK_TIME_ALLOWED "a date and time, such as 2026-06-21T12:00:00Z"
#define MURK_SCHEDULE_ALLOWED \
    "always, night, never, or a list of spans such as [[06:00, 22:00]]"

/* One table for each part of a scene; keys_scene.c joins them. */
extern const murk_keys murk_geometry_keys, murk_material_keys, murk_medium_keys,
    murk_region_keys, murk_lightmap_keys, murk_photon_keys, murk_tally_keys,
    murk_placement_keys, murk_sensor_keys, murk_candidate_keys,
    murk_condition_keys, murk_condition_weight_keys, murk_interest_keys,
    murk_target_keys, murk_site_keys, murk_portal_keys, murk_camera_keys;

/* Readers of keys that need a reader of their own: into murk_scene_site,
 * murk_scene_schedule. */
murk_status murk_read_time(murk_key_reader *walk, const murk_key *key,
                           murk_yaml *node, void *item);
murk_status murk_read_schedule(murk_key_reader *walk, const murk_key *key,
                               murk_yaml *node, void *item);

/* For a light of the sky: takes place and time that the light does not give
 * from the site of the scene, and checks them. */
murk_status murk_check_sky(murk_key_reader *walk, const murk_yaml *map,
                           murk_scene_light *light);

/* The up axis of meshes: x, y, z. */
extern const murk_word murk_up_words[];

/* For the whole scene, after everything is read: placement over conditions
 * needs conditions. */
murk_status murk_check_conditions(murk_key_reader *walk, const murk_yaml *map,
                                  void *item);

/* The shape of an item with a box, a sphere, a mesh or none of them:
 * murk_region_shape. */
extern const char *const murk_zone_variants[];

/* The shape whose key the map has, or `otherwise`. */
murk_region_shape murk_shape_of_region(const murk_yaml *map,
                                       murk_region_shape otherwise);

murk_status murk_choose_zone(murk_key_reader *walk, const murk_yaml *map,
                             int *variant);

/* Checks that min is less than max on each axis. */
murk_status murk_check_box(murk_key_reader *walk, const murk_yaml *map,
                           murk_box box);

/* Checks that two edges span an area. */
murk_status murk_check_edges(murk_key_reader *walk, const murk_yaml *map,
                             murk_vec3 edge1, murk_vec3 edge2);

#endif
