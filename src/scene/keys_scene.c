/* The key table of the scene: top-level keys, the domain, and checks that
 * several tables share. The tables of other parts are in keys_*.c. */
#include "scene/keys.h"

#include <assert.h>
#include <float.h>
#include <stdio.h>
#include <string.h>

#include "scene/keys_rows.h"

murk_status murk_check_box(murk_key_reader *walk, const murk_yaml *map,
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

murk_status murk_check_edges(murk_key_reader *walk, const murk_yaml *map,
                             murk_vec3 edge1, murk_vec3 edge2)
{
    const double area = murk_length(murk_cross(edge1, edge2));
    /* The cross product has three differences of products: parallel edges
     * leave no more than this by rounding. */
    const double slack =
        4 * DBL_EPSILON * murk_length(edge1) * murk_length(edge2);
    if (!(area > slack)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "edge1_m and edge2_m span no area, must not be "
                              "zero or parallel");
    }
    return MURK_OK;
}

/* ---- the scene ---- */

static murk_status check_domain(murk_key_reader *walk, const murk_yaml *map,
                                void *item)
{
    return murk_check_box(walk, map, ((murk_scene_desc *)item)->domain.box);
}

static const murk_word SIDES_WORDS[] = {
    {"open", 0},
    {"periodic", 1},
    WORDS_END,
};

static const murk_word OUTSIDE_WORDS[] = {
    {"empty", 0},
    {"continued", 1},
    WORDS_END,
};

static const murk_key DOMAIN_KEYS_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_desc, domain.box.min)),
    ROW("max_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_desc, domain.box.max)),
    ROW("sides", WORD, .preset = "open", .words = SIDES_WORDS,
        AT(murk_scene_desc, domain.is_periodic)),
    ROW("outside", WORD, .preset = "empty", .words = OUTSIDE_WORDS,
        AT(murk_scene_desc, continues)),
    END,
};

static const murk_keys DOMAIN_KEYS = {.noun = "domain",
                                      .check = check_domain,
                                      WHERE(murk_scene_desc, domain_where),
                                      .key = DOMAIN_KEYS_ROWS};

/* Keys are read in this order: bands before spectra, names before the keys
 * that refer to them. */
static const murk_word FLIGHT_WORDS[] = {
    {"march", 0},
    {"delta", 1},
    WORDS_END,
};

static const murk_word UNITS_WORDS[] = {
    {"radiometric", MURK_RADIOMETRIC},
    {"photometric", MURK_PHOTOMETRIC},
    {"photons", MURK_PHOTONS},
    {"par", MURK_PAR},
    WORDS_END,
};

static const murk_key SCENE_ROWS[] = {
    ROW("murk", COUNT, NEEDED, .min = 1, .max = 1),
    ROW("bands_nm", BANDS, .group = 1, .above = true, .max = 1e9, .unit = "nm",
        .preset = "[550]", .lights = true, AT(murk_scene_desc, band_nm)),
    ROW("band_edges_nm", BAND_EDGES, .group = 1, .above = true, .max = 1e9,
        .unit = "nm", .lights = true, AT(murk_scene_desc, band_edge_nm)),
    ROW("seed", COUNT, .max = 4294967295.0, .preset = "1", .lights = true,
        AT(murk_scene_desc, seed)),
    ROW("north", VECTOR, ANY_UNIT, .preset = "[0, 1, 0]", .lights = true,
        AT(murk_scene_desc, north)),
    ROW("site", MAP, .keys = &murk_site_keys, .lights = true),
    ROW("domain", MAP, .keys = &DOMAIN_KEYS, .lights = true,
        FLAG(murk_scene_desc, has_domain)),
    ROW("materials", NAMED, .keys = &murk_material_keys, .preset = "{}",
        .lights = true),
    ROW("geometry", LIST, .keys = &murk_geometry_keys, .preset = "[]",
        .lights = true),
    ROW("media", NAMED, .keys = &murk_medium_keys, .preset = "{}",
        .lights = true),
    ROW("regions", LIST, .keys = &murk_region_keys, .preset = "[]",
        .lights = true),
    ROW("lights", LIST, .keys = &murk_lightmap_keys, NEEDED, .lights = true),
    ROW("photons", MAP, .keys = &murk_photon_keys, .preset = "{}",
        .lights = true),
    ROW("flight", WORD, .preset = "march", .lights = true,
        .words = FLIGHT_WORDS, AT(murk_scene_desc, by_delta)),
    ROW("units", WORD, .preset = "radiometric", .words = UNITS_WORDS,
        AT(murk_scene_desc, units)),
    ROW("tallies", LIST, .keys = &murk_tally_keys, .preset = "[]"),
    ROW("sensors", MAP, .keys = &murk_sensor_keys,
        FLAG(murk_scene_desc, sensors.given)),
    ROW("conditions", NAMED, .keys = &murk_condition_keys, .preset = "{}"),
    ROW("placement", MAP, .keys = &murk_placement_keys, .preset = "{}"),
    ROW("cameras", LIST, .keys = &murk_camera_keys, .preset = "[]"),
    END,
};

static murk_status check_scene(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    murk_scene_desc *scene = item;
    const murk_vec3 n = scene->north;
    const double length = murk_length(n);
    if (n.z != 0 || !(length > 0)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, murk_yaml_get(map, "north"),
                              false,
                              "north: [%.9g, %.9g, %.9g] is not level, must be "
                              "[x, y, 0] and point somewhere",
                              n.x, n.y, n.z);
    }
    scene->north = murk_scale(1 / length, n);
    return murk_check_conditions(walk, map, item);
}

const murk_keys murk_scene_keys = {
    .noun = "scene",
    .check = check_scene,
    .key = SCENE_ROWS,
};

/* The row at a path such as "placement.over". */
static const murk_key *find_path(const char *path)
{
    const murk_keys *keys = &murk_scene_keys;
    const murk_key *key = NULL;
    while (*path && keys) {
        const size_t length = strcspn(path, ".");
        char name[MURK_SCENE_NAME_SIZE];
        snprintf(name, sizeof name, "%.*s", (int)length, path);
        key = murk_keys_find(keys, name);
        keys = key ? key->keys : NULL;
        path += length + (path[length] == '.');
    }
    return *path ? NULL : key;
}

const char *murk_scene_word(const char *path, int value)
{
    const murk_key *key = find_path(path);
    assert(key && key->words);
    for (const murk_word *word = key->words; word->text; ++word) {
        if (word->value == value) {
            return word->text;
        }
    }
    return NULL;
}

bool murk_scene_word_find(const char *path, const char *text, int *value)
{
    const murk_key *key = find_path(path);
    assert(key && key->words);
    for (const murk_word *word = key->words; word->text; ++word) {
        if (strcmp(word->text, text) == 0) {
            *value = word->value;
            return true;
        }
    }
    return false;
}

const murk_key *murk_keys_find(const murk_keys *keys, const char *name)
{
    for (const murk_key *key = keys->key; key->name; ++key) {
        if (strcmp(key->name, name) == 0) {
            return key;
        }
    }
    return NULL;
}
