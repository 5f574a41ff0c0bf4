/* Keys of the weather, the choice of the observation, and what lights of the
 * sky and media take from it (scene/weather.h). */
#include "scene/weather.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/log.h"
#include "base/number.h"
#include "scene/ground.h"
#include "scene/keys_rows.h"
#include "weather/report.h"

#define MINUTES 60      /* of an hour; seconds of a minute */
#define DAY_S   86400.0 /* seconds of a day */

/* ---- keys ---- */

static murk_status check_weather(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    murk_scene_weather *weather = item;
    (void)map;
    weather->is_chosen = !weather->epw;
    return weather->epw
               ? murk_weather_year_read(&weather->year, weather->epw, walk->err)
           : weather->metar ? murk_metar_read(&weather->seen, weather->metar,
                                              weather->where, walk->err)
                            : murk_synop_read(&weather->seen, weather->synop,
                                              weather->where, walk->err);
}

#define WEATHER(member) AT(murk_scene_weather, member)

static const murk_key WEATHER_ROWS[] = {
    ROW("epw", PATH, .group = 1, NEEDED, WEATHER(epw)),
    ROW("metar", TEXT, .group = 1, NEEDED, .max = MURK_REPORT_MAX,
        WEATHER(metar)),
    ROW("synop", TEXT, .group = 1, NEEDED, .max = MURK_REPORT_MAX,
        WEATHER(synop)),
    END,
};

const murk_keys murk_weather_keys = {
    .noun = "weather",
    .check = check_weather,
    WHERE(murk_scene_weather, where),
    .key = WEATHER_ROWS,
};

/* ---- the observation ---- */

/* Warns if the site lies elsewhere than the file says. */
static void warn_of_place(const murk_scene_desc *scene,
                          const murk_scene_weather *weather)
{
    const double far_deg = 1; /* some 100 km */
    const murk_scene_site *site = &scene->site;
    const murk_weather_year *year = weather->year;
    double east = fabs(site->longitude_deg - year->longitude_deg);
    east = fmin(east, fabs(east - 360));
    if (site->has_latitude && site->has_longitude &&
        (fabs(site->latitude_deg - year->latitude_deg) > far_deg ||
         east > far_deg)) {
        murk_warn(weather->where,
                  "the site at %.6g, %.6g is not where %s was made, at %.6g, "
                  "%.6g: sun and measured light do not belong together",
                  site->latitude_deg, site->longitude_deg, weather->epw,
                  year->latitude_deg, year->longitude_deg);
    }
}

murk_status murk_weather_choose(murk_key_reader *walk, const murk_yaml *node)
{
    const murk_scene_desc *scene = walk->scene;
    murk_scene_weather *weather = &walk->scene->weather;
    if (!weather->given) {
        return murk_walk_fail(walk, node,
                              "asks for the weather of a scene that has none, "
                              "must have the key weather");
    }
    if (weather->is_chosen) {
        return MURK_OK;
    }
    if (!scene->site.has_time) {
        return murk_walk_fail(walk, node,
                              "asks for a weather year in a scene without a "
                              "time, must have site.time (or site.date and "
                              "site.clock)");
    }
    /* The row at the time of the scene, or of its timeline. */
    const double unix_s =
        scene->site.unix_s + (scene->timeline.given ? scene->timeline.at_s : 0);
    const murk_weather_row *row = murk_weather_year_at(weather->year, unix_s);
    if (!row) {
        char time[MURK_TIME_SIZE];
        murk_time_print(time, unix_s, weather->year->zone_min);
        return murk_fail(walk->err, MURK_BAD_VALUE, weather->where,
                         "%s has no row for %s", weather->epw, time);
    }
    warn_of_place(scene, weather);
    weather->seen = row->seen;
    weather->line = row->line;
    weather->is_chosen = true;
    return MURK_OK;
}

void murk_weather_release(murk_scene_weather *weather)
{
    murk_weather_year_release(weather->year);
    weather->year = NULL;
}

void murk_weather_sign(FILE *out, const murk_scene_desc *scene)
{
    const murk_scene_weather *weather = &scene->weather;
    if (weather->given && weather->is_chosen) {
        const murk_observation *seen = &weather->seen;
        fprintf(out, "weather: %.17g %.17g %.17g\n", seen->direct_w_per_m2,
                seen->diffuse_w_per_m2, seen->sky_cover);
    }
}

/* ---- the site ---- */

static murk_status put_number(murk_key_reader *walk, murk_yaml *map,
                              const char *name, double value)
{
    char text[MURK_NUMBER_SIZE];
    if (murk_yaml_get(map, name)) {
        return MURK_OK;
    }
    murk_number_print(text, value);
    return murk_walk_put_preset(walk, map, name, text);
}

murk_status murk_weather_complete_site(murk_key_reader *walk, murk_yaml *map)
{
    const murk_weather_year *year = walk->scene->weather.year;
    if (!year) {
        return MURK_OK;
    }
    murk_status status =
        put_number(walk, map, "latitude_deg", year->latitude_deg);
    if (!status) {
        status = put_number(walk, map, "longitude_deg", year->longitude_deg);
    }
    /* Beside ground of a file, z = 0 is that of the file. */
    if (!status && !murk_ground_is_in(walk->root)) {
        status = put_number(walk, map, "altitude_m", year->altitude_m);
    }
    if (!status && !murk_yaml_get(map, "time_zone")) {
        char text[16];
        const int zone = abs(year->zone_min);
        snprintf(text, sizeof text, "\"%c%02d:%02d\"",
                 year->zone_min < 0 ? '-' : '+', zone / MINUTES % 24,
                 zone % MINUTES);
        status = murk_walk_put_preset(walk, map, "time_zone", text);
    }
    return status;
}

/* ---- lights of the sky ---- */

murk_status murk_weather_complete_light(murk_key_reader *walk, murk_yaml *map)
{
    static const char *const of_sky[] = {"sun", "moon", "sky", "daylight"};
    const murk_yaml *type = murk_yaml_get(map, "type");
    bool is_of_sky = false;
    for (size_t i = 0; i < sizeof of_sky / sizeof *of_sky; ++i) {
        is_of_sky = is_of_sky || strcmp(type->text, of_sky[i]) == 0;
    }
    return is_of_sky && walk->scene->weather.given &&
                   !murk_yaml_get(map, "cover")
               ? murk_walk_put_preset(walk, map, "cover", MURK_SCENE_BY_WEATHER)
               : MURK_OK;
}

/* Seconds from a time to the nearest one at a day of the month and a minute of
 * that day, UTC, as reports have them: of the month before, that month, or the
 * month behind it. */
static double seconds_to(const murk_observation *seen, double unix_s)
{
    const murk_date now = murk_date_of_days(unix_s / DAY_S);
    double nearest = INFINITY;
    for (int step = -1; step <= 1; ++step) {
        const int month = now.month + step;
        const murk_date date = {now.year + (month > 12) - (month < 1),
                                month < 1    ? 12
                                : month > 12 ? 1
                                             : month,
                                seen->day};
        const double days = murk_date_days(date);
        const double off_s =
            DAY_S * days + MINUTES * (double)seen->minute - unix_s;
        /* A month may lack the day. */
        if (murk_date_of_days(days).day == seen->day) {
            nearest = fmin(nearest, fabs(off_s));
        }
    }
    return nearest;
}

/* Warns if a report is of another time than the scene; once, at the first light
 * that takes it. */
static void warn_of_time(const murk_scene_desc *scene)
{
    const murk_observation *seen = &scene->weather.seen;
    const double hour_s = 3600;
    const double unix_s =
        scene->site.unix_s + (scene->timeline.given ? scene->timeline.at_s : 0);
    bool is_first = true;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        is_first = is_first && !scene->lights[i].by_weather;
    }
    if (is_first && seen->day > 0 && scene->site.has_time &&
        seconds_to(seen, unix_s) > hour_s) {
        char time[MURK_TIME_SIZE];
        murk_time_print(time, unix_s, 0);
        murk_warn(
            scene->weather.where,
            "the report is of day %02d of a month, %02d:%02d UTC, and not "
            "within an hour of the time of the scene, %s",
            seen->day, seen->minute / MINUTES, seen->minute % MINUTES, time);
    }
}

murk_status murk_weather_check_light(murk_key_reader *walk,
                                     const murk_yaml *map)
{
    static const char *const own[] = {"time", "latitude_deg", "longitude_deg"};
    for (size_t i = 0; i < sizeof own / sizeof *own; ++i) {
        if (murk_yaml_get(map, own[i])) {
            return murk_walk_fail(walk, map,
                                  "%s beside cover: weather, which is that of "
                                  "site; must be one of them",
                                  own[i]);
        }
    }
    warn_of_time(walk->scene);
    return MURK_OK;
}

murk_scene_cover murk_weather_cover(const murk_observation *seen)
{
    const double clear = .25, overcast = .875;
    return seen->sky_cover > overcast ? MURK_SCENE_OVERCAST
           : seen->sky_cover > clear  ? MURK_SCENE_INTERMEDIATE
                                      : MURK_SCENE_CLEAR;
}

/* ---- media ---- */

const char *murk_weather_preset(const murk_observation *seen)
{
    const double fog_m = 1000; /* fog is a visibility below 1 km (WMO) */
    const bool is_thick =
        seen->visibility_m < fog_m && seen->rain_mm_per_h == 0;
    switch (seen->kind) {
    case MURK_WEATHER_SNOW:
        return "weather/snow";
    case MURK_WEATHER_FOG:
        return "weather/fog";
    case MURK_WEATHER_HAZE:
        return "weather/haze";
    case MURK_WEATHER_NONE:
        break;
    }
    return is_thick ? "weather/fog" : "weather/haze";
}

murk_status murk_weather_words(murk_words *words, murk_key_reader *walk,
                               const murk_yaml *map)
{
    const murk_observation *seen = &walk->scene->weather.seen;
    bool has_amount = false;
    /* Refuse a medium whose amount nobody states; then add amount and rain. */
    for (int i = 0; i < MURK_WORDS; ++i) {
        has_amount =
            has_amount || (words->given[i] && murk_word_rows[i].is_amount);
    }
    if (!has_amount && isnan(seen->visibility_m) && seen->unknown[0]) {
        return murk_walk_fail(walk, map,
                              "takes the weather, which states no visibility "
                              "that can be read (not known: %s); must have "
                              "visibility_m or mor_m",
                              seen->unknown);
    }
    if (!has_amount && isnan(seen->visibility_m)) {
        return murk_walk_fail(walk, map,
                              "takes the weather, which states no visibility; "
                              "must have visibility_m or mor_m");
    }
    if (!has_amount) {
        words->given[MURK_WORD_MOR] = true;
        words->value[MURK_WORD_MOR][0] = seen->visibility_m;
    }
    if (!words->given[MURK_WORD_RAIN]) {
        words->given[MURK_WORD_RAIN] = true;
        words->value[MURK_WORD_RAIN][0] = seen->rain_mm_per_h;
    }
    return MURK_OK;
}
