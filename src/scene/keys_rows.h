/* Macros for the rows of the key tables, and checks that several tables
 * share. Only keys*.c and study_*.c include this file. */
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
/* The words of a row, and the rows of the items of a list. */
#define WORDS_END \
    {             \
        NULL, 0   \
    }
#define WORDS(...)               \
    .words = (const murk_word[]) \
    {                            \
        __VA_ARGS__, WORDS_END   \
    }
#define LIST_ITEMS(...)         \
    .items = (const murk_key[]) \
    {                           \
        __VA_ARGS__, END        \
    }

#define NEEDED .required = true
#define AT(type, member) \
    .at = offsetof(type, member), .size = sizeof(((type *)0)->member)
#define INSIDE(type, member) .inside = offsetof(type, member)
#define FLAG(type, member)   .has_flag = true, .flag_at = offsetof(type, member)
#define WHERE(type, member) \
    .has_where = true, .where_at = offsetof(type, member)
#define VARIANT(type, member) \
    .has_variant_at = true, .variant_at = offsetof(type, member)
/* An array of a struct `owner`, and the number of items. */
#define ITEMS(owner, array, count)            \
    .item_size = sizeof *((owner *)0)->array, \
    .array_at = offsetof(owner, array), .count_at = offsetof(owner, count)
#define BIT(variant) (1u << (variant))

/* Ranges. Larger lengths, powers and so on are mistakes; within these ranges
 * squares and products stay finite in double precision, and lengths in
 * single precision. */
#define LONG_M    .min = -1e9, .max = 1e9, .unit = "m"
#define PLACE_M   LONG_M, .is_position = true
#define SIZE_M    .above = true, .max = 1e9, .unit = "m"
#define ANY_UNIT  .min = -1e9, .max = 1e9
#define SHARE     .max = 1
#define LATITUDE  .min = -90, .max = 90, .unit = "degrees"
#define LONGITUDE .min = -180, .max = 360, .unit = "degrees"
#define ALTITUDE  .min = -500, .max = 9000, .unit = "m"
#define RADIANS   .unit = "degrees", .factor = MURK_PI / 180

#define MURK_TIME_ALLOWED "a date and time, such as 2026-06-21T12:00:00Z"
#define MURK_SCHEDULE_ALLOWED \
    "always, night, never, or a list of spans such as [[06:00, 22:00]]"

/* The JSON Schema of keys of kind MURK_KEY_OWN whose reader takes a text. */
#define TEXT_SCHEMA .schema = "{\"type\": \"string\"}"

/* A mean cosine: at -1 and 1 the phase function has no density. */
#define COSINE .min = -1, .max = 1, .above = true, .below = true

/* Phase functions of several numbers, of scenes and of presets. The argument
 * is AT(...) of the numbers. */
#define TWO_HG_ITEMS                                                 \
    LIST_ITEMS(ROW("g1", NUMBER, COSINE), ROW("g2", NUMBER, COSINE), \
               ROW("weight1", NUMBER, SHARE))
#define TWO_HG_ROW(...) \
    ROW("two_hg", NUMBERS, .group = 1, NEEDED, TWO_HG_ITEMS, __VA_ARGS__)
#define FOURNIER_FORAND_ITEMS                            \
    LIST_ITEMS(ROW("n", NUMBER, .min = 1.001, .max = 2), \
               ROW("mu", NUMBER, .min = 3.0001, .max = 4.9999))
#define FOURNIER_FORAND_ROW(...)                                               \
    ROW("fournier_forand", NUMBERS, .group = 1, NEEDED, FOURNIER_FORAND_ITEMS, \
        __VA_ARGS__)

/* The row of a box that cuts a part out of a file, a double[4] with a flag;
 * murk_check_within() checks the box. The arguments are AT(...), FLAG(...) and
 * further members of the row. */
#define WITHIN_ITEMS                                                 \
    LIST_ITEMS(ROW("x0", NUMBER, LONG_M), ROW("y0", NUMBER, LONG_M), \
               ROW("x1", NUMBER, LONG_M), ROW("y1", NUMBER, LONG_M))
#define WITHIN_ROW(...) \
    ROW("within_m", NUMBERS, WITHIN_ITEMS, .selects_files = true, __VA_ARGS__)

/* Rows of a struct that has a murk_scene_solid as the member `solid`. The
 * further arguments (group, variants) are added to each row, but not to the
 * rows unit_m and up. */
#define BOX_ROW(type, ...)                                           \
    ROW("box", MAP, .keys = &murk_box_keys, INSIDE(type, solid.box), \
        __VA_ARGS__)
#define SPHERE_ROW(type, ...)                                          \
    ROW("sphere", MAP, .keys = &murk_sphere_keys, INSIDE(type, solid), \
        __VA_ARGS__)
#define MESH_ROWS(type, ...)                                             \
    ROW("mesh", PATH, AT(type, solid.mesh), __VA_ARGS__),                \
        ROW("unit_m", NUMBER, SIZE_M, .variants = BIT(MURK_REGION_MESH), \
            AT(type, solid.unit_m)),                                     \
        ROW("up", WORD, .variants = BIT(MURK_REGION_MESH),               \
            .words = murk_up_words, AT(type, solid.up))
#define PLACEMENT_ROWS(type, ...)                                            \
    ROW("scale", NUMBER, .above = true, .max = 1e9, .preset = "1",           \
        AT(type, solid.scale), __VA_ARGS__),                                 \
        ROW("rotate_deg", VECTOR, ANY_UNIT, .unit = "degrees",               \
            .preset = "[0, 0, 0]", AT(type, solid.rotate_deg), __VA_ARGS__), \
        ROW("translate_m", VECTOR, LONG_M, .preset = "[0, 0, 0]",            \
            AT(type, solid.translate_m), __VA_ARGS__)

/* One table for each part of a scene; keys_scene.c joins them. */
extern const murk_keys murk_geometry_keys, murk_material_keys, murk_medium_keys,
    murk_region_keys, murk_light_keys, murk_photon_keys, murk_tally_keys,
    murk_placement_keys, murk_sensor_keys, murk_candidate_keys,
    murk_condition_keys, murk_condition_weight_keys, murk_interest_keys,
    murk_target_keys, murk_site_keys, murk_portal_keys, murk_camera_keys,
    murk_timeline_keys, murk_weather_keys;

/* The keys of a box (murk_box) and of a sphere (murk_scene_solid). */
extern const murk_keys murk_box_keys, murk_sphere_keys;

/* The up axis of meshes: x, y, z. */
extern const murk_word murk_up_words[];

/* Phase functions that are words: isotropic, rayleigh; and the names of all
 * kinds, by murk_phase_kind. */
extern const murk_word murk_phase_words[];
extern const char *const murk_phase_variants[];

/* The units of results: radiometric, photometric, photons, par. */
extern const murk_word murk_units_words[];

/* The shapes of an item with a box, a sphere, a mesh or none of them, by
 * murk_region_shape. */
extern const char *const murk_zone_variants[];

/* Checks that min is less than max on each axis of a murk_box. */
murk_status murk_check_box(murk_key_reader *walk, const murk_yaml *map,
                           void *box);

/* Checks that two edges span an area. */
murk_status murk_check_edges(murk_key_reader *walk, const murk_yaml *map,
                             murk_vec3 edge1, murk_vec3 edge2);

/* Fails unless the box of WITHIN_ROW() has an area. */
murk_status murk_check_within(murk_key_reader *walk, const murk_yaml *map,
                              const double box[4]);

/* Readers of keys that need a reader of their own: into murk_scene_site,
 * murk_scene_schedule. */
murk_status murk_read_time(murk_key_reader *walk, const murk_key *key,
                           murk_yaml *node, void *site);
murk_status murk_read_schedule(murk_key_reader *walk, const murk_key *key,
                               murk_yaml *node, void *schedule);

/* For a light of the sky: takes place and time that the light does not give
 * from the site of the scene, checks that they are complete (a night sky needs
 * none), and checks the irradiance. */
murk_status murk_check_sky(murk_key_reader *walk, const murk_yaml *map,
                           murk_scene_light *light);

/* For the whole scene, after everything is read: a scene that changes with time
 * needs a domain. */
murk_status murk_check_timeline(murk_key_reader *walk,
                                const murk_scene_desc *scene);

/* For the whole scene, after everything is read: placement over conditions
 * needs conditions. */
murk_status murk_check_conditions(murk_key_reader *walk, const murk_yaml *map,
                                  const murk_scene_desc *scene);

/* Checks that no item of an array before `item` has the name of the item. The
 * items have `size` bytes and begin with the name. */
murk_status murk_check_own_name(murk_key_reader *walk, const murk_yaml *map,
                                const char *noun, const void *items,
                                size_t size, const void *item);

#endif
