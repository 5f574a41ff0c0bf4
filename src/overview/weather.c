/* The weather of a scene as murk check reports it: the observation at the time
 * of the scene, and the preset that media with `preset: weather` have. */
#include "overview/parts.h"

#include "results/summary.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/path.h"
#include "scene/weather.h"

static bool has_medium(const murk_scene_desc *scene)
{
    bool has = false;
    for (size_t i = 0; i < scene->n_media; ++i) {
        const char *preset = scene->media[i].preset;
        has = has || (preset && strcmp(preset, MURK_SCENE_BY_WEATHER) == 0);
    }
    return has;
}

static const char *format_of(const murk_scene_weather *weather)
{
    return weather->epw ? "EPW" : weather->metar ? "METAR" : "SYNOP";
}

/* Prints a number with its name and unit, or that it is not stated. */
static void print_number(const char *before, const char *name, double value,
                         const char *unit)
{
    if (isnan(value)) {
        murk_print("%s%s not stated", before, name);
    } else {
        murk_print("%s%s %.5g%s", before, name, value, unit);
    }
}

void murk_overview_print_weather(const murk_stage *stage)
{
    static const char *const limits[] = {
        [MURK_VISIBILITY_EXACT] = "",
        [MURK_VISIBILITY_AT_LEAST] = " (at least)",
        [MURK_VISIBILITY_LESS_THAN] = " (less)"};
    const murk_scene_weather *weather = &stage->scene->weather;
    const murk_observation *seen = &weather->seen;
    if (!weather->given || !weather->is_chosen) {
        return;
    }
    /* The light of a weather year, or the codes of a report; then what is in
     * the air. */
    murk_print("weather     ");
    if (weather->epw) {
        murk_print("%s, line %d: ", murk_path_name(weather->epw),
                   weather->line);
        print_number("", "sun", seen->direct_w_per_m2, " W/m2 normal");
        print_number(", ", "sky", seen->diffuse_w_per_m2, " W/m2");
    } else {
        murk_print("%s %s", format_of(weather),
                   seen->weather[0] ? seen->weather : "without weather");
        print_number(", ", "sky cover", seen->sky_cover, "");
    }
    print_number("; ", "visibility", seen->visibility_m, " m");
    murk_print("%s", limits[seen->visibility_limit]);
    murk_print(", rain %.3g mm/h%s", seen->rain_mm_per_h,
               seen->rain_is_by_word ? " (by its class)" : "");
    if (has_medium(stage->scene)) {
        murk_print("; preset: weather is %s", murk_weather_preset(seen));
    }
    murk_print("\n");
    if (seen->unknown[0]) {
        murk_print("            not known and left out: %s\n", seen->unknown);
    }
}

void murk_overview_json_weather(cJSON *root, const murk_stage *stage)
{
    static const char *const limits[] = {
        [MURK_VISIBILITY_EXACT] = "exact",
        [MURK_VISIBILITY_AT_LEAST] = "at_least",
        [MURK_VISIBILITY_LESS_THAN] = "less_than"};
    const murk_scene_weather *weather = &stage->scene->weather;
    const murk_observation *seen = &weather->seen;
    if (!weather->given || !weather->is_chosen) {
        return;
    }
    /* A number that is not stated becomes null. */
    cJSON *item = cJSON_AddObjectToObject(root, "weather");
    cJSON_AddStringToObject(item, "format", format_of(weather));
    murk_json_number(item, "line",
                     weather->line > 0 ? (double)weather->line : NAN);
    murk_json_number(item, "direct_w_per_m2", seen->direct_w_per_m2);
    murk_json_number(item, "diffuse_w_per_m2", seen->diffuse_w_per_m2);
    murk_json_number(item, "global_w_per_m2", seen->global_w_per_m2);
    murk_json_number(item, "sky_cover", seen->sky_cover);
    murk_json_number(item, "visibility_m", seen->visibility_m);
    cJSON_AddStringToObject(item, "visibility_is",
                            limits[seen->visibility_limit]);
    murk_json_number(item, "rain_mm_per_h", seen->rain_mm_per_h);
    cJSON_AddBoolToObject(item, "rain_by_class", seen->rain_is_by_word);
    murk_json_number(item, "temperature_c", seen->temperature_c);
    murk_json_number(item, "dew_point_c", seen->dew_point_c);
    murk_json_number(item, "pressure_hpa", seen->pressure_hpa);
    cJSON_AddStringToObject(item, "codes", seen->weather);
    cJSON_AddStringToObject(item, "unknown_groups", seen->unknown);
    if (has_medium(stage->scene)) {
        cJSON_AddStringToObject(item, "preset", murk_weather_preset(seen));
    }
}
