/* Keys of light sources, one set of keys for each type, and of the photons
 * that they emit. */
#include "scene/keys_rows.h"

static murk_status check_light(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    murk_scene_light *light = item;
    if (murk_scene_light_is_of_sky(light)) {
        return murk_check_sky(walk, map, light);
    }
    /* A schedule needs the time of the scene. */
    if (light->schedule.when != MURK_SCENE_ALWAYS &&
        light->schedule.when != MURK_SCENE_NEVER &&
        !walk->scene->site.has_time) {
        return murk_walk_fail(
            walk, MURK_BAD_VALUE, murk_yaml_get(map, "schedule"), false,
            "a schedule by the time of a scene that has none, "
            "must have site.time (or site.date and "
            "site.clock)");
    }
    /* Shapes and directions must not be degenerate. */
    if (murk_yaml_get(map, "edge1_m")) {
        return murk_check_edges(walk, map, light->edge1, light->edge2);
    }
    if (murk_yaml_get(map, "direction") &&
        !(murk_length(light->direction) > 0)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "direction is [0, 0, 0], must point somewhere");
    }
    return MURK_OK;
}

/* Bits of the variants that a key belongs to: one for each type, and for
 * groups of types. */
#define TYPE_BIT(id, name, group) id = BIT(MURK_SOURCE_##id),
#define LAMP_BIT(id, name, group) \
    | (MURK_SOURCE_##group == MURK_SOURCE_LAMP ? id : 0)
enum {
    MURK_SOURCE_TYPES(TYPE_BIT) /* */
    LAMPS = 0 MURK_SOURCE_TYPES(LAMP_BIT),
    BY_TIME = SUN | MOON | SKY,
};

#define TYPE_NAME(id, name, group) name,
static const char *const LIGHT_VARIANTS[] = {MURK_SOURCE_TYPES(TYPE_NAME)};

#define TYPE_WORD(id, name, group) {name, MURK_SOURCE_##id},
static const murk_word TYPE_WORDS[] = {MURK_SOURCE_TYPES(TYPE_WORD) WORDS_END};

static const murk_word COVER_WORDS[] = {
    {"clear", MURK_SCENE_CLEAR},
    {"intermediate", MURK_SCENE_INTERMEDIATE},
    {"overcast", MURK_SCENE_OVERCAST},
    WORDS_END,
};

static murk_status read_time(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, void *item)
{
    return murk_read_time(walk, key, node, &((murk_scene_light *)item)->site);
}

static murk_status read_schedule(murk_key_reader *walk, const murk_key *key,
                                 murk_yaml *node, void *item)
{
    return murk_read_schedule(walk, key, node,
                              &((murk_scene_light *)item)->schedule);
}

static const murk_key LIGHT_ROWS[] = {
    ROW("type", WORD, NEEDED, .words = TYPE_WORDS),
    ROW("center_m", VECTOR, NEEDED, LONG_M, .variants = SPHERE,
        AT(murk_scene_light, position)),
    ROW("corner_m", VECTOR, NEEDED, LONG_M, .variants = RECT,
        AT(murk_scene_light, position)),
    ROW("edge1_m", VECTOR, NEEDED, LONG_M, .variants = RECT,
        AT(murk_scene_light, edge1)),
    ROW("edge2_m", VECTOR, NEEDED, LONG_M, .variants = RECT,
        AT(murk_scene_light, edge2)),
    ROW("position_m", VECTOR, NEEDED, LONG_M, .variants = POINT,
        AT(murk_scene_light, position)),
    ROW("origin_m", VECTOR, NEEDED, LONG_M, .variants = BEAM,
        AT(murk_scene_light, position)),
    ROW("direction", VECTOR, NEEDED, ANY_UNIT, .variants = BEAM | DIRECTIONAL,
        AT(murk_scene_light, direction)),
    ROW("radius_m", NUMBER, NEEDED, SIZE_M, .variants = SPHERE,
        AT(murk_scene_light, radius_m)),
    ROW("radius_m", NUMBER, .max = 1e9, .unit = "m", .variants = BEAM,
        .preset = "0", AT(murk_scene_light, radius_m)),
    ROW("divergence_deg", NUMBER, .max = 90, .unit = "degrees",
        .variants = BEAM, .preset = "0", .factor = MURK_PI / 180,
        AT(murk_scene_light, divergence_rad)),
    ROW("power_w", SHARED, NEEDED, .max = 1e15, .unit = "W", .variants = LAMPS,
        AT(murk_scene_light, power_w)),
    ROW("irradiance_w_per_m2", SHARED, NEEDED, .max = 1e15, .unit = "W/m2",
        .variants = DIRECTIONAL, AT(murk_scene_light, power_w)),
    ROW("irradiance_w_per_m2", SHARED, .max = 1e15, .unit = "W/m2",
        .variants = BY_TIME | NIGHT_SKY, AT(murk_scene_light, power_w),
        FLAG(murk_scene_light, has_irradiance)),
    ROW("latitude_deg", NUMBER, LATITUDE, .variants = BY_TIME,
        AT(murk_scene_light, site.latitude_deg),
        FLAG(murk_scene_light, site.has_latitude)),
    ROW("longitude_deg", NUMBER, LONGITUDE, .variants = BY_TIME,
        AT(murk_scene_light, site.longitude_deg),
        FLAG(murk_scene_light, site.has_longitude)),
    ROW("altitude_m", NUMBER, ALTITUDE, .variants = BY_TIME,
        AT(murk_scene_light, site.altitude_m),
        FLAG(murk_scene_light, site.has_altitude)),
    ROW("time", OWN, .read = read_time, .variants = BY_TIME,
        .allowed = MURK_TIME_ALLOWED),
    ROW("linke_turbidity", NUMBER, .min = 1, .max = 20,
        .variants = BY_TIME | NIGHT_SKY, .preset = "3",
        AT(murk_scene_light, linke_turbidity)),
    ROW("cover", WORD, .variants = BY_TIME, .preset = "clear",
        .words = COVER_WORDS, AT(murk_scene_light, cover)),
    ROW("cie_type", COUNT, .variants = SKY, .min = 1, .max = 15,
        AT(murk_scene_light, cie_type)),
    ROW("mag_per_arcsec2", NUMBER, .variants = NIGHT_SKY, .min = 10, .max = 30,
        .unit = "mag/arcsec2", .preset = "21.6",
        AT(murk_scene_light, mag_per_arcsec2)),
    ROW("aim", LIST, .keys = &murk_portal_keys, .preset = "[]",
        .variants = DIRECTIONAL | BY_TIME | NIGHT_SKY),
    ROW("schedule", OWN, .read = read_schedule, .preset = "always",
        .variants = LAMPS | DIRECTIONAL, .allowed = MURK_SCHEDULE_ALLOWED),
    END,
};

const murk_keys murk_lightmap_keys = {
    .noun = "light",
    .selector = "type",
    .check = check_light,
    .variant_names = LIGHT_VARIANTS,
    VARIANT(murk_scene_light, type),
    WHERE(murk_scene_light, where),
    ITEMS(murk_scene_light, lights, n_lights),
    .max_items = 256,
    .needs_item = true,
    .key = LIGHT_ROWS,
};

/* ---- photons ---- */

static murk_status check_photons(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    const murk_scene_photons *photons = &((murk_scene_desc *)item)->photons;
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

static const murk_word STORE_WHEN_WORDS[] = {
    {"reflected", 0},
    {"hit", 1},
    WORDS_END,
};

static const murk_word MAPS_WORDS[] = {
    {"both", MURK_SCENE_MAPS_BOTH},
    {"surface", MURK_SCENE_MAPS_SURFACE},
    {"volume", MURK_SCENE_MAPS_VOLUME},
    {"none", MURK_SCENE_MAPS_NONE},
    WORDS_END,
};

static const murk_key PHOTONS_ROWS[] = {
    ROW("emit", COUNT, .group = 1, .min = 1, .max = 4294967295.0,
        .unit = "photons", .preset = "100000",
        AT(murk_scene_desc, photons.emit)),
    ROW("store", COUNT, .group = 1, .min = 1, .max = 4294967295.0,
        .unit = "records", AT(murk_scene_desc, photons.store)),
    ROW("store_when", WORD, .preset = "reflected", .words = STORE_WHEN_WORDS,
        AT(murk_scene_desc, photons.store_hits)),
    ROW("least_weight", NUMBER, .min = 1e-5, .max = 1, .preset = "1",
        AT(murk_scene_desc, photons.least_weight)),
    ROW("maps", WORD, .preset = "both", .words = MAPS_WORDS,
        AT(murk_scene_desc, photons.maps)),
    ROW("max_stored", COUNT, .min = 1, .max = 4294967295.0, .unit = "records",
        .preset = "100000000", AT(murk_scene_desc, photons.max_stored)),
    END,
};

const murk_keys murk_photon_keys = {
    .noun = "photons",
    .check = check_photons,
    WHERE(murk_scene_desc, photons.where),
    .key = PHOTONS_ROWS,
};
