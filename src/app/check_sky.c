#include "app/check_sky.h"

#include <math.h>
#include <stdio.h>

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
        cJSON_AddItemToArray(list, item);
    }
}
