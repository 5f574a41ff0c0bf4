/* Keys of place and time of the scene, of schedules, of portals for distant
 * light, and checks of lights of the sky. */
#include "scene/keys_rows.h"

#include <string.h>

#include "scene/value.h"
#include "scene/weather.h"

/* ---- the time ---- */

static bool is_text(const murk_yaml *node)
{
    return node->kind == MURK_YAML_SCALAR && node->text[0] != '\0';
}

murk_status murk_read_time(murk_key_reader *walk, const murk_key *key,
                           murk_yaml *node, void *member)
{
    murk_scene_site *site = member;
    const murk_scene_site *whole = &walk->scene->site;
    double local_s;
    bool has_zone;
    int zone_min;
    if (!is_text(node) ||
        !murk_time_read(node->text, &local_s, &has_zone, &zone_min)) {
        return murk_value_wrong(walk, key, node);
    }
    if (!has_zone && !site->has_zone && !whole->has_zone) {
        return murk_walk_fail(
            walk, node,
            "%s without its offset from UTC, must end in Z or in one such as "
            "+02:00 (or site.time_zone be given)",
            node->text);
    }
    if (!has_zone) {
        zone_min = site->has_zone ? site->zone_min : whole->zone_min;
    }
    if (!site->has_zone) { /* the key time_zone, if given, stays the zone of the
                            * clocks of schedules */
        site->zone_min = zone_min;
    }
    site->unix_s = local_s - 60.0 * zone_min;
    node->is_quoted = true;
    return MURK_OK;
}

/* Reads the time zone, the date, or the time of day of a site. The caller has
 * set the flag of the row, such as has_date. */
static murk_status read_part(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, void *member)
{
    murk_scene_site *site = member;
    bool is_read = is_text(node);
    if (is_read && strcmp(key->name, "time_zone") == 0) {
        is_read = murk_zone_read(node->text, &site->zone_min);
    } else if (is_read && strcmp(key->name, "date") == 0) {
        is_read = murk_date_read(node->text, &site->date);
    } else if (is_read) {
        is_read = murk_clock_read(node->text, &site->clock_s);
    }
    if (!is_read) {
        return murk_value_wrong(walk, key, node);
    }
    node->is_quoted = true;
    return MURK_OK;
}

static murk_status check_site(murk_key_reader *walk, const murk_yaml *map,
                              void *item)
{
    murk_scene_site *site = item;
    if (!site->has_date && !site->has_clock) {
        return MURK_OK;
    }
    if (site->has_time) {
        return murk_walk_fail(
            walk, map,
            "has time and clock, must have time, or date, clock and time_zone");
    }
    if (!site->has_date || !site->has_clock || !site->has_zone) {
        return murk_walk_fail(
            walk, map,
            "misses %s, must have date, clock and time_zone together",
            !site->has_date    ? "date"
            : !site->has_clock ? "clock"
                               : "time_zone");
    }
    site->unix_s = 86400.0 * murk_date_days(site->date) + site->clock_s -
                   60.0 * site->zone_min;
    site->has_time = true;
    return MURK_OK;
}

#define SITE(member) AT(murk_scene_site, member)
#define IF(member)   FLAG(murk_scene_site, member)

/* Keys are read in this order, since later ones need earlier ones. A time and a
 * date exclude each other, so that a date on the command line replaces the time
 * of the file. */
static const murk_key SITE_ROWS[] = {
    ROW("latitude_deg", NUMBER, LATITUDE, SITE(latitude_deg), IF(has_latitude)),
    ROW("longitude_deg", NUMBER, LONGITUDE, SITE(longitude_deg),
        IF(has_longitude)),
    ROW("altitude_m", NUMBER, ALTITUDE, .preset = "0", SITE(altitude_m),
        IF(has_altitude)),
    ROW("pressure_hpa", NUMBER, .min = 100, .max = 1200, .unit = "hPa",
        SITE(pressure_hpa), IF(has_pressure)),
    ROW("temperature_c", NUMBER, .min = -90, .max = 60, .unit = "C",
        .preset = "10", SITE(temperature_c)),
    ROW("time_zone", OWN, .read = read_part, IF(has_zone), TEXT_SCHEMA,
        .allowed = "an offset from UTC, such as +02:00 or Z"),
    ROW("time", OWN, .group = 1, .read = murk_read_time, IF(has_time),
        TEXT_SCHEMA, .allowed = MURK_TIME_ALLOWED),
    ROW("date", OWN, .group = 1, .read = read_part, IF(has_date), TEXT_SCHEMA,
        .allowed = "a local date, such as 2026-06-21"),
    ROW("clock", OWN, .read = read_part, IF(has_clock), TEXT_SCHEMA,
        .allowed = "a local time of day, 00:00..24:00, such as 06:30"),
    END,
};

const murk_keys murk_site_keys = {
    .noun = "site",
    .complete = murk_weather_complete_site,
    .check = check_site,
    WHERE(murk_scene_site, where),
    .key = SITE_ROWS,
};

/* ---- schedules ---- */

static const murk_word SCHEDULE_WORDS[] = {
    {"always", MURK_SCENE_ALWAYS},
    {"night", MURK_SCENE_NIGHT},
    {"never", MURK_SCENE_NEVER},
    WORDS_END,
};

static murk_status read_span(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, double *from_s, double *to_s)
{
    const bool has_two = node->kind == MURK_YAML_LIST && node->n == 2;
    if (!has_two || !is_text(node->child[0]) || !is_text(node->child[1]) ||
        !murk_clock_read(node->child[0]->text, from_s) ||
        !murk_clock_read(node->child[1]->text, to_s)) {
        return murk_value_wrong(walk, key, node);
    }
    if (*from_s == *to_s) {
        return murk_walk_fail(walk, node,
                              "from %s to %s is no time, must not be equal",
                              node->child[0]->text, node->child[1]->text);
    }
    node->child[0]->is_quoted = node->child[1]->is_quoted = true;
    return MURK_OK;
}

murk_status murk_read_schedule(murk_key_reader *walk, const murk_key *key,
                               murk_yaml *node, void *member)
{
    murk_scene_schedule *schedule = member;
    /* A word. */
    for (const murk_word *word = SCHEDULE_WORDS;
         node->kind == MURK_YAML_SCALAR && word->text; ++word) {
        if (strcmp(node->text, word->text) == 0) {
            node->is_quoted = false;
            schedule->when = (murk_scene_shining)word->value;
            return MURK_OK;
        }
    }
    if (node->kind != MURK_YAML_LIST || node->n == 0 ||
        node->n > MURK_SCENE_SPANS_MAX) {
        return murk_value_wrong(walk, key, node);
    }
    /* A list of spans of the day. */
    schedule->when = MURK_SCENE_BY_CLOCK;
    schedule->spans = node->n;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < node->n && !status; ++i) {
        status = read_span(walk, key, node->child[i], &schedule->from_s[i],
                           &schedule->to_s[i]);
    }
    return status;
}

/* ---- portals ---- */

static murk_status check_portal(murk_key_reader *walk, const murk_yaml *map,
                                void *item)
{
    const murk_scene_portal *portal = item;
    return murk_check_edges(walk, map, portal->edge1, portal->edge2);
}

static const murk_key PORTAL_ROWS[] = {
    ROW("corner_m", VECTOR, NEEDED, PLACE_M, AT(murk_scene_portal, corner)),
    ROW("edge1_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_portal, edge1)),
    ROW("edge2_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_portal, edge2)),
    END,
};

const murk_keys murk_portal_keys = {
    .noun = "portal",
    .check = check_portal,
    WHERE(murk_scene_portal, where),
    ITEMS(murk_scene_light, portal, portals),
    .max_items = 256,
    .key = PORTAL_ROWS,
};

/* ---- lights of the sky ---- */

/* Copies the parts of place and time that the light does not give from the site
 * of the scene, and always the pressure and the temperature. */
static void inherit(murk_scene_site *own, const murk_scene_site *site)
{
    if (!own->has_latitude) {
        own->has_latitude = site->has_latitude;
        own->latitude_deg = site->latitude_deg;
    }
    if (!own->has_longitude) {
        own->has_longitude = site->has_longitude;
        own->longitude_deg = site->longitude_deg;
    }
    if (!own->has_altitude) {
        own->altitude_m = site->altitude_m;
    }
    own->has_pressure = site->has_pressure;
    own->pressure_hpa = site->pressure_hpa;
    own->temperature_c = site->temperature_c;
    if (!own->has_time) {
        own->has_time = site->has_time;
        own->unix_s = site->unix_s;
        own->zone_min = site->zone_min;
    }
}

static murk_status check_place_and_time(murk_key_reader *walk,
                                        const murk_yaml *map,
                                        const murk_scene_site *site)
{
    const char *missing = !site->has_latitude    ? "latitude_deg"
                          : !site->has_longitude ? "longitude_deg"
                          : !site->has_time      ? "time"
                                                 : NULL;
    const murk_scene_weather *weather = &walk->scene->weather;
    return missing
               ? murk_walk_fail(
                     walk, map, "misses %s, must be here or in site%s", missing,
                     weather->metar   ? " (a METAR states none)"
                     : weather->synop ? " (of a SYNOP report none is "
                                        "taken)"
                                      : "")
               : MURK_OK;
}

/* Notes whether the irradiance is a total, and then stores the total in band 0.
 * Fails if the spectrum of the light would have to be spread over lines, which
 * have no width. Spreading is not needed if the irradiance is a list with one
 * value a band, or is given for a single band, by the key or by the weather. */
static murk_status check_irradiance(murk_key_reader *walk, const murk_yaml *map,
                                    murk_scene_light *light)
{
    const murk_yaml *node = murk_yaml_get(map, "irradiance_w_per_m2");
    light->irradiance_total = node && node->kind == MURK_YAML_SCALAR;
    if (light->irradiance_total) { /* the reader of the key has spread the total
                                    * evenly over the bands */
        double total = 0;
        for (int b = 0; b < walk->scene->bands; ++b) {
            total += light->power_w.band[b];
        }
        light->power_w.band[0] = total;
    }
    if (walk->scene->has_edges || (node && node->kind == MURK_YAML_LIST) ||
        ((node || light->by_weather) && walk->scene->bands == 1)) {
        return MURK_OK;
    }
    return murk_walk_fail(
        walk, map,
        "needs bands with edges (band_edges_nm) to spread its spectrum over, "
        "or irradiance_w_per_m2 for each line");
}

murk_status murk_check_sky(murk_key_reader *walk, const murk_yaml *map,
                           murk_scene_light *light)
{
    const murk_yaml *cover = murk_yaml_get(map, "cover");
    murk_status status = MURK_OK;
    inherit(&light->site, &walk->scene->site);
    if (cover && strcmp(cover->text, MURK_SCENE_BY_WEATHER) == 0) {
        status = murk_weather_check_light(walk, map);
        if (!status) {
            status = murk_weather_choose(walk, map);
        }
        light->by_weather = true;
        light->cover = murk_weather_cover(&walk->scene->weather.seen);
    }
    if (!status && light->type != MURK_SOURCE_NIGHT_SKY) {
        status = check_place_and_time(walk, map, &light->site);
    }
    return status ? status : check_irradiance(walk, map, light);
}
