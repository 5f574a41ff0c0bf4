/* The lights of a scene as murk check reports them: power, the position of sun
 * and moon, irradiance, and the share of the light from outside that the media
 * of the domain absorb or scatter before it meets a surface or water. */
#include "overview/parts.h"

#include "results/summary.h"

#include <math.h>
#include <stdio.h>

#include "world/daylight_loss.h"
#include "world/units.h"

static void print_time(const murk_stage *stage)
{
    char text[MURK_TIME_SIZE];
    const murk_scene_site *site = &stage->scene->site;
    if (site->has_time) {
        murk_time_print(text, site->unix_s, site->zone_min);
        murk_print("time        %s\n", text);
    }
}

/* The irradiance of a light of the sky, summed over the bands, in the units of
 * the scene. */
static double irradiance_of(const murk_stage *stage, size_t light)
{
    const murk_scene_desc *scene = stage->scene;
    const murk_source *of = murk_sources_get(stage->lights, light);
    double sum = 0;
    for (int b = 0; b < scene->bands; ++b) {
        sum += of->power_w.band[b] *
               murk_units_per_watt(scene->units, stage, light, b);
    }
    return sum;
}

/* Prints the share of the irradiance on the line above that the media of the
 * domain absorb or scatter. The weather is part of that irradiance already, so
 * fog in the scene may dim the light a second time. */
static void print_taken(const murk_stage *stage, size_t light)
{
    const murk_daylight_loss taken = murk_daylight_loss_of(stage, light);
    if (taken.is_known && taken.share > 0) {
        murk_print("            the domain's media take %.3g %% of this again, "
                   "before a surface or water\n",
                   100 * taken.share);
    }
}

/* The power of all lights together, in the unit of a quantity. */
static double power_of(const murk_stage *stage, murk_quantity quantity)
{
    const size_t bands = (size_t)stage->scene->bands;
    double sum = 0;
    for (size_t c = 0; c < murk_sources_channels(stage->lights); ++c) {
        sum +=
            murk_sources_channel_power_w(stage->lights, c) *
            murk_units_per_watt(quantity, stage, c / bands, (int)(c % bands));
    }
    return sum;
}

static void print_power(const murk_stage *stage)
{
    const murk_quantity quantity = stage->scene->units;
    murk_print("lights      %zu, %.6g W", murk_sources_count(stage->lights),
               murk_sources_power_w(stage->lights));
    if (quantity != MURK_RADIOMETRIC) {
        murk_print(" or %.6g %s", power_of(stage, quantity),
                   murk_units_of(quantity).power);
    }
    murk_print(" together\n");
}

void murk_overview_print_lights(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    print_power(stage);
    print_time(stage);
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_sky_facts *facts = &stage->sky[i];
        const murk_scene_light *l = &scene->lights[i];
        /* Lamps have a line only when they are off. */
        if (!murk_scene_light_is_of_sky(l)) {
            if (!facts->is_on) {
                murk_print("light       %zu, %s: off\n", i,
                           murk_source_type_name(l->type));
            }
            continue;
        }
        /* Lights of the sky: irradiance and direction. */
        murk_print("light       %zu, %s: %.4g %s in the bands", i,
                   murk_source_type_name(l->type), irradiance_of(stage, i),
                   murk_units_of(scene->units).irradiance);
        if (isfinite(facts->elevation_deg)) {
            murk_print("; %s at azimuth %.2f, elevation %.2f degrees",
                       l->type == MURK_SOURCE_MOON ? "moon" : "sun",
                       facts->azimuth_deg, facts->elevation_deg);
        }
        murk_print("\n");
        print_taken(stage, i);
    }
}

static void add_taken(cJSON *item, const murk_stage *stage, size_t light)
{
    const int bands = stage->world.bands;
    const murk_daylight_loss taken = murk_daylight_loss_of(stage, light);
    if (!taken.is_known) {
        cJSON_AddNullToObject(item, "taken_again");
        return;
    }
    cJSON *object = cJSON_AddObjectToObject(item, "taken_again");
    murk_json_number(object, "share", taken.share);
    murk_json_numbers(object, "optical_depth", taken.optical_depth.band, bands);
    murk_json_numbers(object, "transmittance", taken.transmittance.band, bands);
}

void murk_overview_json_lights(cJSON *root, const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    /* All lights together, also in the units of the scene. */
    const murk_units units = murk_units_of(scene->units);
    cJSON *lights = cJSON_AddObjectToObject(root, "lights");
    murk_json_number(lights, "count",
                     (double)murk_sources_count(stage->lights));
    murk_json_number(lights, "power_w", murk_sources_power_w(stage->lights));
    if (scene->units != MURK_RADIOMETRIC) {
        char key[40];
        snprintf(key, sizeof key, "power_%s", units.suffix);
        murk_json_number(lights, key, power_of(stage, scene->units));
    }
    /* Each light, with its place in the sky. */
    cJSON *list = cJSON_AddArrayToObject(lights, "sky");
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_sky_facts *facts = &stage->sky[i];
        cJSON *item = murk_json_item(list);
        murk_json_number(item, "light", (double)i);
        cJSON_AddStringToObject(item, "type",
                                murk_source_type_name(scene->lights[i].type));
        cJSON_AddBoolToObject(item, "on", facts->is_on);
        murk_json_number(item, "azimuth_deg", facts->azimuth_deg);
        murk_json_number(item, "elevation_deg", facts->elevation_deg);
        murk_json_number(item, "irradiance_w_per_m2",
                         facts->irradiance_w_per_m2);
        if (isfinite(facts->irradiance_w_per_m2)) {
            murk_json_number(item, "irradiance", irradiance_of(stage, i));
            cJSON_AddStringToObject(item, "unit", units.irradiance);
        } else {
            cJSON_AddNullToObject(item, "irradiance");
            cJSON_AddNullToObject(item, "unit");
        }
        add_taken(item, stage, i);
    }
}
