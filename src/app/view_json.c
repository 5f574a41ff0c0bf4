/* The view's data as one JSON text. */
#include "app/view_data.h"
#include "sensing/sensor.h"

#include <cjson/cJSON.h>
#include <math.h>

#define SPHERES_MAX 1000
#define LAMPS_MAX   1000
#define DOT_SHARE   400 /* a photon's dot, of the view's size */

/* Surface photons first, as they lie in plan.ply. */
static size_t count_on_surfaces(const murk_plan_points *points)
{
    size_t n = 0;
    while (n < points->n && !points->point[n].is_volume) {
        ++n;
    }
    return n;
}

static void add_number(cJSON *to, const char *key, double value)
{
    if (isfinite(value)) {
        cJSON_AddNumberToObject(to, key, value);
    } else {
        cJSON_AddNullToObject(to, key);
    }
}

static cJSON *vector(murk_vec3 v)
{
    const double number[3] = {v.x, v.y, v.z};
    return cJSON_CreateDoubleArray(number, 3);
}

static void add_vector(cJSON *to, const char *key, murk_vec3 v)
{
    cJSON_AddItemToObject(to, key, vector(v));
}

static void add_box(cJSON *to, const murk_box *box)
{
    add_vector(to, "low", box->min);
    add_vector(to, "high", box->max);
}

static double radians(double degrees)
{
    return isfinite(degrees) ? degrees * (MURK_PI / 180) : 0;
}

static cJSON *sensor_json(const murk_report_scene *s,
                          const murk_shown_sensor *sensor)
{
    static const char *const views[] = {[MURK_SCENE_VIEW_SPHERE] = "sphere",
                                        [MURK_SCENE_VIEW_CONE] = "cone",
                                        [MURK_SCENE_VIEW_FRUSTUM] = "frustum"};
    const murk_scene_sensor_type *type = sensor->of;
    const murk_pose pose = {.position = sensor->place,
                            .heading_rad = radians(sensor->heading_deg),
                            .tilt_rad = radians(sensor->tilt_deg)};
    const murk_sensor_frame frame =
        murk_pose_frame(&pose, s->scene ? s->scene->north : murk_vec(0, 1, 0));
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "type", sensor->type);
    add_vector(item, "place", sensor->place);
    add_vector(item, "axis", frame.axis);
    add_vector(item, "right", frame.right);
    add_vector(item, "up", frame.up);
    add_number(item, "heading_deg", sensor->heading_deg);
    add_number(item, "tilt_deg", sensor->tilt_deg);
    cJSON_AddStringToObject(item, "view",
                            views[type ? type->view : MURK_SCENE_VIEW_SPHERE]);
    const bool is_cone = type && type->view == MURK_SCENE_VIEW_CONE;
    const double angle[2] = {type ? is_cone ? type->cone_rad : type->hfov_rad
                                  : 0,
                             type ? type->vfov_rad : 0};
    cJSON_AddItemToObject(item, "angles_rad",
                          cJSON_CreateDoubleArray(angle, 2));
    add_number(item, "range_m", type ? type->range_m : NAN);
    add_number(item, "least_range_m", type ? type->least_range_m : NAN);
    add_number(item, "covers", sensor->covers);
    add_number(item, "only", sensor->only);
    return item;
}

static void add_balls(cJSON *root, const murk_surfaces *surfaces)
{
    cJSON *list = cJSON_AddArrayToObject(root, "balls");
    const size_t n = surfaces ? murk_surfaces_describe(surfaces).spheres : 0;
    for (size_t i = 0; i < n && i < SPHERES_MAX; ++i) {
        murk_vec3 center;
        double radius_m;
        murk_surfaces_sphere(surfaces, i, &center, &radius_m);
        cJSON *item = cJSON_CreateObject();
        add_vector(item, "center", center);
        cJSON_AddNumberToObject(item, "radius", radius_m);
        cJSON_AddItemToArray(list, item);
    }
}

/* Of a sun's or beam's light, which comes from a heading and a height. */
static murk_vec3 travel_of(const murk_scene_desc *scene,
                           const murk_sky_facts *facts)
{
    const double heading = radians(facts->azimuth_deg);
    const double height = radians(facts->elevation_deg);
    const murk_vec3 north = scene->north;
    const murk_vec3 east = murk_vec(north.y, -north.x, 0);
    const murk_vec3 level = murk_add(murk_scale(cos(heading), north),
                                     murk_scale(sin(heading), east));
    const murk_vec3 to =
        murk_add(murk_scale(cos(height), level), murk_vec(0, 0, sin(height)));
    return murk_scale(-1, to);
}

static void add_lamp(cJSON *list, const murk_report_scene *s, size_t i)
{
    static const char *const kinds[] = {[MURK_SCENE_LIGHT_SPHERE] = "sphere",
                                        [MURK_SCENE_LIGHT_RECT] = "rect",
                                        [MURK_SCENE_LIGHT_POINT] = "point",
                                        [MURK_SCENE_LIGHT_BEAM] = "beam",
                                        [MURK_SCENE_LIGHT_DIRECTIONAL] =
                                            "distant light",
                                        [MURK_SCENE_LIGHT_SUN] = "sun",
                                        [MURK_SCENE_LIGHT_MOON] = "moon"};
    const murk_scene_light *light = &s->scene->lights[i];
    const bool is_on = !s->stage || !s->stage->sky || s->stage->sky[i].is_on;
    const bool is_sky = light->type == MURK_SCENE_LIGHT_SUN ||
                        light->type == MURK_SCENE_LIGHT_MOON;
    if (light->type > MURK_SCENE_LIGHT_MOON || !is_on ||
        (is_sky && !(s->stage && s->stage->sky))) {
        return; /* a sky has no place and no direction */
    }
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "type", kinds[light->type]);
    cJSON_AddBoolToObject(item, "distant",
                          light->type >= MURK_SCENE_LIGHT_DIRECTIONAL);
    add_vector(item, "place", light->position);
    add_vector(item, "direction",
               is_sky ? travel_of(s->scene, &s->stage->sky[i])
                      : light->direction);
    if (light->type == MURK_SCENE_LIGHT_RECT) {
        add_vector(item, "edge1", light->edge1);
        add_vector(item, "edge2", light->edge2);
    }
    cJSON_AddItemToArray(list, item);
}

static void add_lamps(cJSON *root, const murk_report_scene *s)
{
    cJSON *list = cJSON_AddArrayToObject(root, "lamps");
    const size_t n = s->scene ? s->scene->n_lights : 0;
    for (size_t i = 0; i < n && i < LAMPS_MAX; ++i) {
        add_lamp(list, s, i);
    }
}

static void add_readings(cJSON *root, const murk_report_scene *s)
{
    cJSON *list = cJSON_AddArrayToObject(root, "readings");
    for (size_t i = 0; i < s->readings; ++i) {
        const murk_shown_reading *r = &s->reading[i];
        cJSON *item = cJSON_CreateObject();
        add_vector(item, "place", r->place);
        add_vector(item, "to", r->to);
        cJSON_AddStringToObject(item, "kind", r->kind);
        cJSON_AddStringToObject(item, "unit", r->unit);
        cJSON_AddStringToObject(item, "condition", r->condition);
        cJSON_AddBoolToObject(item, "held_out", r->is_held_out);
        add_number(item, "line", r->line);
        add_number(item, "value", r->value);
        add_number(item, "standard_error", r->standard_error);
        add_number(item, "predicted", r->predicted);
        add_number(item, "residual", r->residual);
        cJSON_AddItemToArray(list, item);
    }
}

static void add_states(cJSON *root, const murk_view_data *data)
{
    const murk_report_scene *s = data->scene;
    cJSON *list = cJSON_AddArrayToObject(root, "states");
    for (size_t i = 0; i < s->states; ++i) {
        const murk_shown_state *state = &s->state[i];
        const murk_box box = murk_view_photon_box(&state->points);
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "name", state->name);
        add_number(item, "stored", (double)state->points.photons);
        add_number(item, "photons", (double)state->points.n);
        add_number(item, "surface_photons",
                   (double)count_on_surfaces(&state->points));
        add_number(item, "bit_bytes", (double)murk_view_bit_bytes(state));
        add_box(item, &box);
        add_number(item, "media", (double)data->media_of[i]);
        cJSON *sensors = cJSON_AddArrayToObject(item, "sensors");
        for (size_t k = 0; k < state->sensors; ++k) {
            cJSON_AddItemToArray(sensors, sensor_json(s, &state->sensor[k]));
        }
        cJSON_AddItemToArray(list, item);
    }
}

static void add_media(cJSON *root, const murk_view_data *data)
{
    cJSON *list = cJSON_AddArrayToObject(root, "media");
    for (size_t i = 0; i < data->medias; ++i) {
        const murk_view_media *media = &data->media[i];
        const double count[3] = {(double)media->size[0], (double)media->size[1],
                                 (double)media->size[2]};
        cJSON *item = cJSON_CreateObject();
        cJSON_AddBoolToObject(item, "there", media->cell != NULL);
        cJSON_AddBoolToObject(item, "even", media->is_even);
        add_box(item, &media->box);
        cJSON_AddItemToObject(item, "size", cJSON_CreateDoubleArray(count, 3));
        add_number(item, "most_per_m", media->max_per_m);
        cJSON_AddItemToArray(list, item);
    }
}

char *murk_view_data_json(const murk_view_data *data)
{
    const murk_report_scene *s = data->scene;
    const double size = murk_length(murk_sub(data->box.max, data->box.min));
    cJSON *root = cJSON_CreateObject();
    add_box(root, &data->box);
    /* places here count from there */
    add_vector(root, "origin", s->scene ? s->scene->origin : murk_vec(0, 0, 0));
    /* a single place has a view, too */
    add_number(root, "size_m", size > 0 ? size : 1);
    add_number(root, "dot_m", (size > 0 ? size : 1) / DOT_SHARE);
    add_vector(root, "north", s->scene ? s->scene->north : murk_vec(0, 1, 0));
    add_states(root, data);
    add_media(root, data);
    add_balls(root, s->stage ? s->stage->surfaces : NULL);
    add_lamps(root, s);
    add_readings(root, s);
    cJSON *path = cJSON_AddArrayToObject(root, "path");
    for (size_t i = 0; i < s->stops; ++i) {
        cJSON_AddItemToArray(path, vector(s->stop[i]));
    }
    if (data->mesh.triangles > 0) {
        cJSON *item = cJSON_AddObjectToObject(root, "mesh");
        add_box(item, &data->mesh.box);
        cJSON_AddNumberToObject(item, "steps", MURK_VIEW_STEPS);
        cJSON_AddBoolToObject(item, "wide", murk_view_is_wide(&data->mesh));
    }
    char *text = cJSON_PrintUnformatted(root);
    cJSON_Delete(root);
    return text;
}
