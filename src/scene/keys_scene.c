/* The key table of the scene: top-level keys, the domain, and the search for
 * rows and words. The tables of other parts are in keys_*.c. */
#include "scene/keys.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/ground.h"
#include "scene/keys_rows.h"
#include "scene/light_source.h"
#include "scene/override.h"
#include "scene/walk_names.h"
#include "scene/weather.h"

/* ---- the scene ---- */

static murk_status check_domain(murk_key_reader *walk, const murk_yaml *map,
                                void *item)
{
    return murk_check_box(walk, map, &((murk_scene_desc *)item)->domain.box);
}

#define SCENE(member) AT(murk_scene_desc, member)

const murk_word murk_units_words[] = {{"radiometric", MURK_RADIOMETRIC},
                                      {"photometric", MURK_PHOTOMETRIC},
                                      {"photons", MURK_PHOTONS},
                                      {"par", MURK_PAR},
                                      WORDS_END};

static const murk_key DOMAIN_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, PLACE_M, SCENE(domain.box.min)),
    ROW("max_m", VECTOR, NEEDED, PLACE_M, SCENE(domain.box.max)),
    ROW("sides", WORD, .preset = "open", WORDS({"open", 0}, {"periodic", 1}),
        SCENE(domain.is_periodic)),
    ROW("outside", WORD, .preset = "empty",
        WORDS({"empty", 0}, {"continued", 1}), SCENE(continues)),
    END,
};

static const murk_keys DOMAIN_KEYS = {.noun = "domain",
                                      .check = check_domain,
                                      WHERE(murk_scene_desc, domain_where),
                                      .key = DOMAIN_ROWS};

/* Keys on which the traced light depends: TRACED are the same in all
 * conditions, VARIED may be set by conditions. */
#define TRACED .lights = true
#define VARIED .lights = true, .may_differ = true
#define STILL  .is_still = true
#define NM     .above = true, .max = 1e9, .unit = "nm"

/* Keys are read in this order: bands before spectra, names before the keys
 * that refer to them. */
static const murk_key SCENE_ROWS[] = {
    ROW("murk", COUNT, NEEDED, .min = 1, .max = 1, STILL),
    ROW("bands_nm", BANDS, .group = 1, NM, .preset = "[550]", TRACED, STILL,
        SCENE(band_nm)),
    ROW("band_edges_nm", BAND_EDGES, .group = 1, NM, TRACED, STILL,
        SCENE(band_edge_nm)),
    ROW("seed", COUNT, .max = 4294967295.0, .preset = "1", VARIED, STILL,
        SCENE(seed)),
    ROW("north", VECTOR, ANY_UNIT, .preset = "[0, 1, 0]", TRACED, STILL,
        SCENE(north)),
    ROW("weather", MAP, .keys = &murk_weather_keys, VARIED, STILL,
        INSIDE(murk_scene_desc, weather), FLAG(murk_scene_desc, weather.given)),
    ROW("site", MAP, .keys = &murk_site_keys, TRACED,
        INSIDE(murk_scene_desc, site)),
    ROW("timeline", MAP, .keys = &murk_timeline_keys, .may_differ = true, STILL,
        INSIDE(murk_scene_desc, timeline),
        FLAG(murk_scene_desc, timeline.given)),
    ROW("domain", MAP, .keys = &DOMAIN_KEYS, TRACED, STILL,
        FLAG(murk_scene_desc, has_domain)),
    ROW("materials", NAMED, .keys = &murk_material_keys, .preset = "{}",
        VARIED),
    ROW("geometry", LIST, .keys = &murk_geometry_keys, .preset = "[]", VARIED),
    ROW("media", NAMED, .keys = &murk_medium_keys, .preset = "{}", VARIED),
    ROW("regions", LIST, .keys = &murk_region_keys, .preset = "[]", VARIED),
    ROW("lights", LIST, .keys = &murk_light_keys, NEEDED, VARIED),
    ROW("photons", MAP, .keys = &murk_photon_keys, .preset = "{}", VARIED,
        STILL, INSIDE(murk_scene_desc, photons)),
    ROW("flight", WORD, .preset = "march", VARIED, STILL,
        WORDS({"march", 0}, {"delta", 1}), SCENE(by_delta)),
    ROW("units", WORD, .preset = "radiometric", STILL, SCENE(units),
        .words = murk_units_words),
    ROW("tallies", LIST, .keys = &murk_tally_keys, .preset = "[]",
        .may_differ = true, STILL),
    ROW("sensors", MAP, .keys = &murk_sensor_keys, STILL,
        INSIDE(murk_scene_desc, sensors), FLAG(murk_scene_desc, sensors.given)),
    ROW("conditions", NAMED, .keys = &murk_condition_keys, .preset = "{}",
        STILL),
    ROW("placement", MAP, .keys = &murk_placement_keys, .preset = "{}", STILL,
        INSIDE(murk_scene_desc, placement)),
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
        return murk_walk_fail(walk, murk_yaml_get(map, "north"),
                              "north: [%.9g, %.9g, %.9g] is not level, must be "
                              "[x, y, 0] and point somewhere",
                              n.x, n.y, n.z);
    }
    scene->north = murk_scale(1 / length, n);
    murk_weather_release(&scene->weather);
    murk_status status = murk_light_arrays_expand(walk, scene);
    if (!status) {
        status = murk_check_timeline(walk, scene);
    }
    return status ? status : murk_check_conditions(walk, map, item);
}

const murk_keys murk_scene_keys = {
    .noun = "scene",
    .complete = murk_ground_complete,
    .check = check_scene,
    .key = SCENE_ROWS,
};

/* ---- visits ---- */

/* The variant of a struct if the struct stores the variant; otherwise -1, which
 * stands for any variant. */
static int variant_of(const murk_keys *keys, const void *item)
{
    int variant = -1;
    if (keys->has_variant_at) {
        memcpy(&variant, (const char *)item + keys->variant_at, sizeof variant);
    }
    return variant;
}

void murk_keys_visit(const murk_keys *keys, void *item, murk_key_visit *visit,
                     void *context)
{
    const int variant = variant_of(keys, item);
    for (const murk_key *key = keys->key; key->name; ++key) {
        const murk_keys *below = key->keys;
        char *items = (char *)item + key->inside;
        size_t n = 1;
        if (!murk_walk_fits(key, variant)) {
            continue;
        }
        /* The structs below: a map, an array of the struct, or an array that
         * is allocated. */
        if (below && below->item_size > 0) {
            memcpy(&n, (char *)item + below->count_at, sizeof n);
            items = (char *)item + key->at;
        }
        if (below && below->item_size > 0 && key->kind != MURK_KEY_PER_BAND) {
            memcpy(&items, (char *)item + below->array_at, sizeof items);
        }
        for (size_t i = 0; below && items && i < n; ++i) {
            murk_keys_visit(below, items + i * below->item_size, visit,
                            context);
        }
        visit(context, key, item);
    }
}

/* ---- paths ---- */

/* The row at a path such as "placement.over". *inside: where the struct of the
 * row lies in murk_scene_desc. */
static const murk_key *find_path(const char *path, size_t *inside)
{
    *inside = 0;
    const murk_keys *keys = &murk_scene_keys;
    const murk_key *key = NULL;
    while (*path && keys) {
        const size_t length = strcspn(path, ".");
        char name[MURK_SCENE_NAME_SIZE];
        snprintf(name, sizeof name, "%.*s", (int)length, path);
        *inside += key ? key->inside : 0;
        key = murk_keys_find(keys, name);
        keys = key ? key->keys : NULL;
        path += length + (path[length] == '.');
    }
    return *path ? NULL : key;
}

const char *murk_scene_word(const char *path, int value)
{
    size_t inside;
    const murk_key *key = find_path(path, &inside);
    assert(key && key->words);
    const murk_word *word = key->words;
    while (word->text && word->value != value) {
        ++word;
    }
    return word->text;
}

murk_status murk_scene_override_read(murk_scene_desc *out,
                                     const murk_override *override,
                                     murk_error *err)
{
    murk_key_reader walk = {.scene = out, .err = err};
    const size_t length = strcspn(override->text, "=");
    snprintf(walk.key, sizeof walk.key, "%.*s", (int)length, override->text);
    size_t inside;
    const murk_key *key = find_path(walk.key, &inside);
    const char *value = override->text + length + 1;
    char *source = murk_override_source(override);
    assert(key && override->text[length] == '=');
    murk_status status =
        source ? murk_yaml_parse(&walk.root, value, strlen(value), source, err)
               : murk_no_memory(err, walk.key, "for it");
    if (!status) {
        status = murk_walk_value(&walk, key, walk.root, (char *)out + inside);
    }
    murk_yaml_destroy(walk.root);
    free(source);
    return status;
}

murk_status murk_check_own_name(murk_key_reader *walk, const murk_yaml *map,
                                const char *noun, const void *items,
                                size_t size, const void *item)
{
    for (const char *other = items; other < (const char *)item; other += size) {
        if (strcmp(other, item) == 0) {
            return murk_walk_fail(
                walk, map,
                "name: %s is the name of an earlier %s, must be one's own",
                (const char *)item, noun);
        }
    }
    return MURK_OK;
}
