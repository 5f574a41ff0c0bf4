/* Keys of light sources, one set of keys for each type, and of the photons
 * that they emit. scene/light_source.h has the files and powers of lamps. */
#include "scene/keys_rows.h"
#include "scene/light_source.h"
#include "scene/weather.h"

/* The sine of the angle between c0 and aim below which c0 is along the aim. */
#define ALONG 1e-6

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
            walk, murk_yaml_get(map, "schedule"),
            "a schedule by the time of a scene that has none, must have "
            "site.time (or site.date and site.clock)");
    }
    /* Shapes and directions must not be degenerate. */
    murk_status status = MURK_OK;
    if (murk_yaml_get(map, "edge1_m")) {
        status = murk_check_edges(walk, map, light->edge1, light->edge2);
    }
    const bool is_luminaire = light->type == MURK_SOURCE_LUMINAIRE;
    if ((is_luminaire || murk_yaml_get(map, "direction")) &&
        !(murk_length(light->direction) > 0)) {
        return murk_walk_fail(walk, map,
                              "%s is [0, 0, 0], must point somewhere",
                              is_luminaire ? "aim" : "direction");
    }
    if (light->has_c0 &&
        !(murk_length(murk_cross(light->c0, light->direction)) >
          ALONG * murk_length(light->c0) * murk_length(light->direction))) {
        return murk_walk_fail(walk, map,
                              "c0 is zero or along the aim, must point aside");
    }
    return status ? status : murk_light_source_read(walk, map, light);
}

/* Bits of the variants that a key belongs to: one for each type, and for
 * groups of types. */
#define TYPE_BIT(id, name, group) id = BIT(MURK_SOURCE_##id),
#define LAMP_BIT(id, name, group) \
    | (MURK_SOURCE_##group == MURK_SOURCE_LAMP ? id : 0)
enum {
    MURK_SOURCE_TYPES(TYPE_BIT) /* */
    LAMPS = 0 MURK_SOURCE_TYPES(LAMP_BIT),
    OF_SKY = SUN | MOON | SKY,
    BY_TIME = OF_SKY | DAYLIGHT,
};

#define TYPE_WORD(id, name, group) {name, MURK_SOURCE_##id},
static const murk_word TYPE_WORDS[] = {MURK_SOURCE_TYPES(TYPE_WORD) WORDS_END};

#define LIGHT(member) AT(murk_scene_light, member)
#define IF(member)    FLAG(murk_scene_light, member)
#define FOR(types)    .variants = (types)
/* More than 1e15 W/m2 is a mistake. */
#define IRRADIANCE .max = 1e15, .unit = "W/m2", LIGHT(power_w)

/* ---- rows and columns of lamps ---- */

static murk_status check_array(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    const murk_scene_array *array = item;
    const murk_vec3 step[] = {array->step1, array->step2};
    for (int i = 0; i < 2; ++i) {
        if (array->count[i] > 1 && !(murk_length(step[i]) > 0)) {
            return murk_walk_fail(walk, map,
                                  "step%d_m is [0, 0, 0], must point somewhere "
                                  "for %zu lamps",
                                  i + 1, array->count[i]);
        }
    }
    return MURK_OK;
}

#define ARRAY(member) AT(murk_scene_array, member)
static const murk_key ARRAY_ROWS[] = {
    ROW("count", SIZES, NEEDED, .min = 1, .max = 256, ARRAY(count)),
    ROW("step1_m", VECTOR, NEEDED, LONG_M, ARRAY(step1)),
    ROW("step2_m", VECTOR, LONG_M, .preset = "[0, 0, 0]", ARRAY(step2)),
    END,
};
static const murk_keys ARRAY_KEYS = {
    .noun = "lamp array", .check = check_array, .key = ARRAY_ROWS};

/* ---- lights ---- */

static const murk_key LIGHT_ROWS[] = {
    ROW("type", WORD, NEEDED, .words = TYPE_WORDS),
    ROW("center_m", VECTOR, NEEDED, PLACE_M, FOR(SPHERE), LIGHT(position)),
    ROW("corner_m", VECTOR, NEEDED, PLACE_M, FOR(RECT), LIGHT(position)),
    ROW("edge1_m", VECTOR, NEEDED, LONG_M, FOR(RECT), LIGHT(edge1)),
    ROW("edge2_m", VECTOR, NEEDED, LONG_M, FOR(RECT), LIGHT(edge2)),
    ROW("file", PATH, NEEDED, FOR(LUMINAIRE), LIGHT(file)),
    ROW("position_m", VECTOR, NEEDED, PLACE_M, FOR(POINT | LUMINAIRE),
        LIGHT(position)),
    ROW("origin_m", VECTOR, NEEDED, PLACE_M, FOR(BEAM), LIGHT(position)),
    ROW("direction", VECTOR, NEEDED, ANY_UNIT, FOR(BEAM | DIRECTIONAL),
        LIGHT(direction)),
    ROW("radius_m", NUMBER, NEEDED, SIZE_M, FOR(SPHERE), LIGHT(radius_m)),
    ROW("radius_m", NUMBER, .max = 1e9, .unit = "m", FOR(BEAM), .preset = "0",
        LIGHT(radius_m)),
    ROW("divergence_deg", NUMBER, .max = 90, RADIANS, FOR(BEAM), .preset = "0",
        LIGHT(divergence_rad)),
    ROW("power_w", SHARED, NEEDED, .max = 1e15, .unit = "W",
        FOR(LAMPS & ~LUMINAIRE), LIGHT(power_w)),
    ROW("power_w", SHARED, .max = 1e15, .unit = "W", FOR(LUMINAIRE),
        LIGHT(power_w)),
    ROW("lumens", NUMBER, .max = 1e15, .unit = "lm", FOR(LUMINAIRE),
        LIGHT(lumens), IF(has_lumens)),
    ROW("spectrum", PATH, .group = 1, FOR(LAMPS | DIRECTIONAL),
        LIGHT(spectrum_file)),
    ROW("temperature_k", NUMBER, .group = 1, .min = MURK_TEMPERATURE_K_MIN,
        .max = MURK_TEMPERATURE_K_MAX, .unit = "K", FOR(LAMPS | DIRECTIONAL),
        LIGHT(temperature_k)),
    ROW("irradiance_w_per_m2", SHARED, NEEDED, IRRADIANCE, FOR(DIRECTIONAL)),
    ROW("irradiance_w_per_m2", SHARED, IRRADIANCE, FOR(OF_SKY | NIGHT_SKY),
        IF(has_irradiance)),
    ROW("latitude_deg", NUMBER, LATITUDE, FOR(BY_TIME),
        LIGHT(site.latitude_deg), IF(site.has_latitude)),
    ROW("longitude_deg", NUMBER, LONGITUDE, FOR(BY_TIME),
        LIGHT(site.longitude_deg), IF(site.has_longitude)),
    ROW("altitude_m", NUMBER, ALTITUDE, FOR(BY_TIME), LIGHT(site.altitude_m),
        IF(site.has_altitude)),
    ROW("time", OWN, .read = murk_read_time, FOR(BY_TIME), LIGHT(site),
        IF(site.has_time), TEXT_SCHEMA, .allowed = MURK_TIME_ALLOWED),
    ROW("linke_turbidity", NUMBER, .min = 1, .max = 20,
        FOR(BY_TIME | NIGHT_SKY), .preset = "3", LIGHT(linke_turbidity)),
    ROW("cover", WORD, FOR(BY_TIME), .preset = "clear", LIGHT(cover),
        WORDS({"clear", MURK_SCENE_CLEAR},
              {"intermediate", MURK_SCENE_INTERMEDIATE},
              {"overcast", MURK_SCENE_OVERCAST},
              /* check_sky() replaces it by one of the others */
              {MURK_SCENE_BY_WEATHER, MURK_SCENE_CLEAR})),
    ROW("cie_type", COUNT, FOR(SKY | DAYLIGHT), .min = 1, .max = 15,
        LIGHT(cie_type)),
    ROW("mag_per_arcsec2", NUMBER, FOR(NIGHT_SKY), .min = 10, .max = 30,
        .unit = "mag/arcsec2", .preset = "21.6", LIGHT(mag_per_arcsec2)),
    ROW("aim", LIST, .keys = &murk_portal_keys, .preset = "[]",
        FOR(DIRECTIONAL | BY_TIME | NIGHT_SKY)),
    ROW("aim", VECTOR, ANY_UNIT, .preset = "[0, 0, -1]", FOR(LUMINAIRE),
        LIGHT(direction)),
    ROW("c0", VECTOR, ANY_UNIT, FOR(LUMINAIRE), LIGHT(c0), IF(has_c0)),
    ROW("roll_deg", NUMBER, .min = -360, .max = 360, RADIANS, FOR(LUMINAIRE),
        .preset = "0", LIGHT(roll_rad)),
    ROW("size", WORD, FOR(LUMINAIRE), .preset = "point", LIGHT(has_size),
        WORDS({"point", false}, {"file", true})),
    ROW("array", MAP, .keys = &ARRAY_KEYS, FOR(LAMPS),
        INSIDE(murk_scene_light, array)),
    ROW("schedule", OWN, .read = murk_read_schedule, .preset = "always",
        FOR(LAMPS | DIRECTIONAL), LIGHT(schedule),
        .allowed = MURK_SCHEDULE_ALLOWED,
        .schema =
            "{\"anyOf\": [{\"enum\": [\"always\", \"night\", \"never\"]}, "
            "{\"type\": \"array\", \"minItems\": 1, \"items\": {\"type\": "
            "\"array\", \"items\": {\"type\": \"string\"}, \"minItems\": 2, "
            "\"maxItems\": 2}}]}"),
    END,
};

const murk_keys murk_light_keys = {
    .noun = "light",
    .selector = "type",
    .complete = murk_weather_complete_light,
    .check = check_light,
    VARIANT(murk_scene_light, type),
    WHERE(murk_scene_light, where),
    ITEMS(murk_scene_desc, lights, n_lights),
    .max_items = MURK_SCENE_LIGHTS_MAX,
    .needs_item = true,
    .key = LIGHT_ROWS,
};

/* ---- photons ---- */

static murk_status check_photons(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    const murk_scene_photons *photons = item;
    if (photons->store > photons->max_stored) {
        return murk_walk_fail(walk, map,
                              "store %llu is more than max_stored %llu",
                              (unsigned long long)photons->store,
                              (unsigned long long)photons->max_stored);
    }
    if (photons->store > 0 && photons->maps == MURK_SCENE_MAPS_NONE) {
        return murk_walk_fail(
            walk, map,
            "store %llu with maps: none, must be emit where nothing is stored",
            (unsigned long long)photons->store);
    }
    return MURK_OK;
}

#define PHOTONS(member) AT(murk_scene_photons, member)
/* Photons and records are counted in 32 bits. */
#define UP_TO_2_32 .min = 1, .max = 4294967295.0

static const murk_key PHOTONS_ROWS[] = {
    ROW("emit", COUNT, .group = 1, UP_TO_2_32, .unit = "photons",
        .preset = "100000", PHOTONS(emit)),
    ROW("store", COUNT, .group = 1, UP_TO_2_32, .unit = "records",
        PHOTONS(store)),
    ROW("store_when", WORD, .preset = "reflected",
        WORDS({"reflected", 0}, {"hit", 1}), PHOTONS(store_hits)),
    ROW("least_weight", NUMBER, .min = 1e-5, .max = 1, .preset = "1",
        PHOTONS(least_weight)),
    ROW("maps", WORD, .preset = "both", PHOTONS(maps),
        WORDS({"both", MURK_SCENE_MAPS_BOTH},
              {"surface", MURK_SCENE_MAPS_SURFACE},
              {"volume", MURK_SCENE_MAPS_VOLUME},
              {"none", MURK_SCENE_MAPS_NONE})),
    ROW("max_stored", COUNT, UP_TO_2_32, .unit = "records",
        .preset = "100000000", PHOTONS(max_stored)),
    END,
};

const murk_keys murk_photon_keys = {
    .noun = "photons",
    .check = check_photons,
    WHERE(murk_scene_photons, where),
    .key = PHOTONS_ROWS,
};
