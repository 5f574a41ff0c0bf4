#include "app/check_sky.h"

#include <math.h>
#include <stdio.h>

#include "study/taken_again.h"

static const char *name_of(murk_scene_light_type type)
{
    static const char *const names[] = {
        [MURK_SCENE_LIGHT_SPHERE] = "sphere",
        [MURK_SCENE_LIGHT_RECT] = "rect",
        [MURK_SCENE_LIGHT_POINT] = "point",
        [MURK_SCENE_LIGHT_BEAM] = "beam",
        [MURK_SCENE_LIGHT_DIRECTIONAL] = "directional",
        [MURK_SCENE_LIGHT_SUN] = "sun",
        [MURK_SCENE_LIGHT_MOON] = "moon",
        [MURK_SCENE_LIGHT_SKY] = "sky",
        [MURK_SCENE_LIGHT_NIGHT_SKY] = "night_sky"};
    return names[type];
}

static void print_time(const murk_stage *stage)
{
    char text[MURK_TIME_SIZE];
    const murk_scene_site *site = &stage->scene->site;
    if (site->has_time) {
        murk_time_print(text, site->unix_s, site->zone_min);
        printf("time        %s\n", text);
    }
}

/* The irradiance above holds the weather already. */
static void print_taken(const murk_stage *stage, size_t light)
{
    const murk_taken_again taken = murk_taken_again_of(stage, light);
    if (taken.is_known && taken.share > 0) {
        printf("            the domain's media take %.3g %% of this again, "
               "before a surface or water\n",
               100 * taken.share);
    }
}

void murk_print_sky(const murk_stage *stage)
{
    const murk_scene *scene = stage->scene;
    print_time(stage);
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_sky_facts *facts = &stage->sky[i];
        const murk_scene_light *l = &scene->lights[i];
        if (l->type < MURK_SCENE_LIGHT_SUN) {
            if (!facts->is_on) {
                printf("light       %zu, %s: off\n", i, name_of(l->type));
            }
            continue;
        }
        printf("light       %zu, %s: %.4g W/m2 in the bands", i,
               name_of(l->type), facts->irradiance_w_per_m2);
        if (isfinite(facts->elevation_deg)) {
            printf("; %s at azimuth %.2f, elevation %.2f degrees",
                   l->type == MURK_SCENE_LIGHT_MOON ? "moon" : "sun",
                   facts->azimuth_deg, facts->elevation_deg);
        }
        printf("\n");
        print_taken(stage, i);
    }
}

static void add_number(cJSON *item, const char *key, double value)
{
    if (isfinite(value)) {
        cJSON_AddNumberToObject(item, key, value);
    } else {
        cJSON_AddNullToObject(item, key);
    }
}

static void add_taken(cJSON *item, const murk_stage *stage, size_t light)
{
    const int bands = stage->world.bands;
    const murk_taken_again taken = murk_taken_again_of(stage, light);
    if (!taken.is_known) {
        cJSON_AddNullToObject(item, "taken_again");
        return;
    }
    cJSON *object = cJSON_AddObjectToObject(item, "taken_again");
    cJSON_AddNumberToObject(object, "share", taken.share);
    cJSON_AddItemToObject(
        object, "optical_depth",
        cJSON_CreateDoubleArray(taken.optical_depth.band, bands));
    cJSON_AddItemToObject(
        object, "transmittance",
        cJSON_CreateDoubleArray(taken.transmittance.band, bands));
}

void murk_json_sky(cJSON *lights, const murk_stage *stage)
{
    const murk_scene *scene = stage->scene;
    cJSON *list = cJSON_AddArrayToObject(lights, "sky");
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_sky_facts *facts = &stage->sky[i];
        cJSON *item = cJSON_CreateObject();
        cJSON_AddNumberToObject(item, "light", (double)i);
        cJSON_AddStringToObject(item, "type", name_of(scene->lights[i].type));
        cJSON_AddBoolToObject(item, "on", facts->is_on);
        add_number(item, "azimuth_deg", facts->azimuth_deg);
        add_number(item, "elevation_deg", facts->elevation_deg);
        add_number(item, "irradiance_w_per_m2", facts->irradiance_w_per_m2);
        add_taken(item, stage, i);
        cJSON_AddItemToArray(list, item);
    }
}
