/* The sensor types of a scene as murk check reports them, with the number of
 * their candidates. */
#include "overview/parts.h"

#include "results/summary.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Degrees in a radian. */
#define DEG_PER_RAD  (180 / MURK_PI)
#define NO_MAX_COUNT 1000000 /* what `max_count` is where none is given */

static size_t poses_of(const murk_poses *poses, size_t type)
{
    size_t n = 0;
    for (size_t j = 0; j < poses->count - poses->fixed; ++j) {
        n += poses->pose[j].type == type;
    }
    return n;
}

static size_t headings_of(const murk_scene_sensor_type *type)
{
    return type->headings_deg.n ? type->headings_deg.n : (size_t)type->headings;
}

void murk_overview_json_sensor_types(cJSON *root, const murk_scene_desc *scene,
                                     const murk_poses *poses)
{
    if (!poses) {
        cJSON_AddNullToObject(root, "sensors");
        return;
    }
    cJSON *list = cJSON_AddArrayToObject(root, "sensors");
    for (size_t k = 0; k < scene->sensors.types; ++k) {
        const murk_scene_sensor_type *type = &scene->sensors.type[k];
        cJSON *item = murk_json_item(list);
        cJSON_AddStringToObject(item, "type", type->name);
        cJSON_AddStringToObject(item, "view", murk_view_name(type->view));
        murk_json_number(item, "least_range_m", type->least_range_m);
        murk_json_number(item, "range_m", type->range_m);
        murk_json_number(item, "cost", type->cost);
        murk_json_number(item, "candidates", (double)poses_of(poses, k));
    }
}

static void print_view(const murk_scene_sensor_type *type)
{
    if (type->view == MURK_VIEW_SPHERE) {
        murk_print("all round");
        return;
    }
    if (type->view == MURK_VIEW_CONE) {
        murk_print("cone of %.4g degrees", type->cone_rad * DEG_PER_RAD);
    } else {
        murk_print("%.4g x %.4g degrees", type->hfov_rad * DEG_PER_RAD,
                   type->vfov_rad * DEG_PER_RAD);
    }
    const size_t headings = headings_of(type), tilts = type->tilts_deg.n;
    murk_print(", %zu heading%s, %zu tilt%s", headings,
               headings == 1 ? "" : "s", tilts, tilts == 1 ? "" : "s");
}

void murk_overview_print_sensor_types(const murk_scene_desc *scene,
                                      const murk_poses *poses)
{
    const murk_scene_sensors *settings = &scene->sensors;
    for (size_t k = 0; k < settings->types; ++k) {
        const murk_scene_sensor_type *type = &settings->type[k];
        murk_print("sensor      %-12s ", type->name);
        print_view(type);
        murk_print(", %.4g to %.4g m", type->least_range_m, type->range_m);
        if (type->toward) {
            murk_print(", light that travels toward it");
        }
        if (type->bands_nm.n) {
            murk_print(", %zu of %d bands", type->bands_nm.n, scene->bands);
        }
        murk_print("; cost %.10g", type->cost);
        /* Limits of the number, and the candidates that are usable. */
        if (type->min_count > 0) {
            murk_print(", at least %llu", (unsigned long long)type->min_count);
        }
        if (type->max_count < NO_MAX_COUNT) {
            murk_print(", at most %llu", (unsigned long long)type->max_count);
        }
        murk_print("; %zu candidates\n", poses_of(poses, k));
    }
    if (poses->fixed > 0) {
        murk_print("fixed       %zu sensors stand already\n", poses->fixed);
    }
}
