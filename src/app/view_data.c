#include "app/view_data.h"

#include "app/page.h"
#include "sensing/sensor.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TRIANGLES_MAX 40000
#define SPHERES_MAX   1000
#define LAMPS_MAX     1000
#define CELLS_MAX     128000 /* of all media together */
#define STEPS         65535
#define DOT_SHARE     400   /* a photon's dot, of the view's size */
#define CORNERS_SMALL 65536 /* numbers of corners in two bytes */
#define BIT_SENSORS   32

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "numbers are sent as they lie in memory");

/* ---- how large ---- */

static murk_vec3 place_of(const murk_plan_point *point)
{
    return murk_vec((double)point->place_m[0], (double)point->place_m[1],
                    (double)point->place_m[2]);
}

static murk_box points_box(murk_box box, const murk_plan_points *points)
{
    for (size_t i = 0; i < points->n; ++i) {
        box = murk_box_with(box, place_of(&points->point[i]));
    }
    return box;
}

static bool is_box(const murk_box *box)
{
    return box->min.x <= box->max.x && box->min.y <= box->max.y &&
           box->min.z <= box->max.z;
}

/* What stands there, or all the domain. */
static murk_box world_box(const murk_stage *stage)
{
    const murk_box *all = &stage->world.domain.box;
    const murk_surfaces_facts facts = murk_surfaces_describe(stage->surfaces);
    murk_box box = facts.bounds_m;
    if (!is_box(&box)) {
        return *all;
    }
    box.min = murk_vec(fmax(box.min.x, all->min.x), fmax(box.min.y, all->min.y),
                       fmax(box.min.z, all->min.z));
    box.max = murk_vec(fmin(box.max.x, all->max.x), fmin(box.max.y, all->max.y),
                       fmin(box.max.z, all->max.z));
    return is_box(&box) ? box : *all;
}

/* All that lights reached, sensors, readings and the path: a large ground about
 * it does not count. Without photons, what stands in the scene. */
static murk_box view_box(const murk_report_scene *s)
{
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < s->states; ++i) {
        box = points_box(box, &s->state[i].points);
    }
    if (!is_box(&box) && s->stage) {
        box = world_box(s->stage);
    }
    for (size_t i = 0; i < s->states; ++i) {
        for (size_t k = 0; k < s->state[i].sensors; ++k) {
            box = murk_box_with(box, s->state[i].sensor[k].place);
        }
    }
    for (size_t i = 0; i < s->readings; ++i) {
        box = murk_box_with(box, s->reading[i].place);
        box = murk_box_with(box, s->reading[i].to);
    }
    for (size_t i = 0; i < s->stops; ++i) {
        box = murk_box_with(box, s->stop[i]);
    }
    return is_box(&box) ? box : (murk_box){{0, 0, 0}, {0, 0, 0}};
}

/* ---- making ---- */

static bool same_media(const murk_view_media *a, const murk_view_media *b)
{
    const size_t n = a->size[0] * a->size[1] * a->size[2];
    return !a->cell == !b->cell && !(a->most_per_m < b->most_per_m) &&
           !(a->most_per_m > b->most_per_m) &&
           (!a->cell || (memcmp(a->size, b->size, sizeof a->size) == 0 &&
                         memcmp(a->cell, b->cell, n) == 0));
}

/* Media that states share are there once. */
static murk_status fill_media(murk_view_data *out, murk_error *err)
{
    const murk_report_scene *s = out->scene;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < s->states && !status; ++i) {
        const murk_stage *stage =
            s->state[i].stage ? s->state[i].stage : s->stage;
        murk_view_media *now = &out->media[out->medias];
        if (i > 0 && !s->state[i].stage) {
            out->media_of[i] = out->media_of[i - 1];
            continue;
        }
        status = murk_view_media_make(now, stage, &out->box,
                                      CELLS_MAX / (s->states + 1), err);
        size_t k = 0;
        while (k < out->medias && !same_media(&out->media[k], now)) {
            ++k;
        }
        out->media_of[i] = k;
        if (k == out->medias) {
            ++out->medias;
        } else {
            murk_view_media_release(now);
        }
    }
    return status;
}

murk_status murk_view_data_make(murk_view_data *out,
                                const murk_report_scene *scene, murk_error *err)
{
    *out = (murk_view_data){.scene = scene, .box = view_box(scene)};
    murk_status status = MURK_OK;
    if (scene->stage) {
        status = murk_view_mesh_make(&out->mesh, scene->stage->surfaces,
                                     TRIANGLES_MAX, err);
    }
    return status ? status : fill_media(out, err);
}

void murk_view_data_release(murk_view_data *data)
{
    for (size_t i = 0; i < data->medias; ++i) {
        murk_view_media_release(&data->media[i]);
    }
    murk_view_mesh_release(&data->mesh);
    *data = (murk_view_data){0};
}

/* ---- JSON ---- */

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

/* Those that have a place; sun and sky have none. */
static void add_lamps(cJSON *root, const murk_scene *scene)
{
    static const char *const kinds[] = {[MURK_SCENE_LIGHT_SPHERE] = "sphere",
                                        [MURK_SCENE_LIGHT_RECT] = "rect",
                                        [MURK_SCENE_LIGHT_POINT] = "point",
                                        [MURK_SCENE_LIGHT_BEAM] = "beam"};
    cJSON *list = cJSON_AddArrayToObject(root, "lamps");
    size_t lamps = 0;
    for (size_t i = 0; scene && i < scene->n_lights; ++i) {
        const murk_scene_light *light = &scene->lights[i];
        if (light->type > MURK_SCENE_LIGHT_BEAM || lamps == LAMPS_MAX) {
            continue;
        }
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "type", kinds[light->type]);
        add_vector(item, "place", light->position);
        if (light->type == MURK_SCENE_LIGHT_RECT) {
            add_vector(item, "edge1", light->edge1);
            add_vector(item, "edge2", light->edge2);
        } else if (light->type == MURK_SCENE_LIGHT_BEAM) {
            add_vector(item, "direction", light->direction);
        }
        cJSON_AddItemToArray(list, item);
        ++lamps;
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

/* Surface photons first, as they lie in plan.ply. */
static size_t count_on_surfaces(const murk_plan_points *points)
{
    size_t n = 0;
    while (n < points->n && !points->point[n].is_volume) {
        ++n;
    }
    return n;
}

static size_t bit_bytes(const murk_shown_state *state)
{
    const size_t n =
        state->sensors < BIT_SENSORS ? state->sensors : BIT_SENSORS;
    return (n + 7) / 8;
}

static murk_box photon_box(const murk_plan_points *points)
{
    const murk_box box = points_box(murk_box_empty(), points);
    return is_box(&box) ? box : (murk_box){{0, 0, 0}, {0, 0, 0}};
}

static void add_states(cJSON *root, const murk_view_data *data)
{
    const murk_report_scene *s = data->scene;
    cJSON *list = cJSON_AddArrayToObject(root, "states");
    for (size_t i = 0; i < s->states; ++i) {
        const murk_shown_state *state = &s->state[i];
        const murk_box box = photon_box(&state->points);
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "name", state->name);
        add_number(item, "stored", (double)state->points.photons);
        add_number(item, "photons", (double)state->points.n);
        add_number(item, "surface_photons",
                   (double)count_on_surfaces(&state->points));
        add_number(item, "bit_bytes", (double)bit_bytes(state));
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
        add_number(item, "most_per_m", media->most_per_m);
        cJSON_AddItemToArray(list, item);
    }
}

static char *data_json(const murk_view_data *data)
{
    const murk_report_scene *s = data->scene;
    const double size = murk_length(murk_sub(data->box.max, data->box.min));
    cJSON *root = cJSON_CreateObject();
    add_box(root, &data->box);
    /* a single place has a view, too */
    add_number(root, "size_m", size > 0 ? size : 1);
    add_number(root, "dot_m", (size > 0 ? size : 1) / DOT_SHARE);
    add_vector(root, "north", s->scene ? s->scene->north : murk_vec(0, 1, 0));
    add_states(root, data);
    add_media(root, data);
    add_balls(root, s->stage ? s->stage->surfaces : NULL);
    add_lamps(root, s->scene);
    add_readings(root, s);
    cJSON *path = cJSON_AddArrayToObject(root, "path");
    for (size_t i = 0; i < s->stops; ++i) {
        cJSON_AddItemToArray(path, vector(s->stop[i]));
    }
    if (data->mesh.triangles > 0) {
        cJSON *item = cJSON_AddObjectToObject(root, "mesh");
        add_box(item, &data->mesh.box);
        cJSON_AddNumberToObject(item, "steps", MURK_VIEW_STEPS);
        cJSON_AddBoolToObject(item, "wide",
                              data->mesh.vertices > CORNERS_SMALL);
    }
    char *text = cJSON_PrintUnformatted(root);
    cJSON_Delete(root);
    return text;
}

/* ---- bytes ---- */

static void write_block(FILE *to, const char *name, size_t number,
                        const void *bytes, size_t size)
{
    fprintf(to, "<script type=\"text/plain\" id=\"%s-%zu\">", name, number);
    murk_page_base64(to, bytes, size);
    fputs("</script>\n", to);
}

static uint16_t step_of(double value, double low, double high)
{
    const double share = high > low ? (value - low) / (high - low) : 0;
    return (uint16_t)floor(fmin(fmax(share, 0), 1) * STEPS + 0.5);
}

static bool write_photons(FILE *to, const murk_shown_state *state,
                          size_t number)
{
    const murk_plan_points *points = &state->points;
    const murk_box box = photon_box(points);
    const size_t bytes = bit_bytes(state);
    uint16_t *place = malloc((3 * points->n + 1) * sizeof *place);
    uint8_t *seen = malloc(points->n + 1);
    uint8_t *who = malloc(bytes * points->n + 1);
    const bool is_whole = place && seen && who;
    for (size_t i = 0; is_whole && i < points->n; ++i) {
        const murk_plan_point *point = &points->point[i];
        const murk_vec3 p = place_of(point);
        place[3 * i] = step_of(p.x, box.min.x, box.max.x);
        place[3 * i + 1] = step_of(p.y, box.min.y, box.max.y);
        place[3 * i + 2] = step_of(p.z, box.min.z, box.max.z);
        seen[i] = (uint8_t)(point->seen_by < 255 ? point->seen_by : 255);
        memcpy(who + bytes * i, &point->sensors, bytes);
    }
    if (is_whole) {
        write_block(to, "photon-places", number, place,
                    3 * points->n * sizeof *place);
        write_block(to, "photon-seen", number, seen, points->n);
        write_block(to, "photon-sensors", number, who, bytes * points->n);
    }
    free(place);
    free(seen);
    free(who);
    return is_whole;
}

static bool write_mesh(FILE *to, const murk_view_mesh *mesh)
{
    const size_t n = 3 * mesh->triangles;
    uint16_t *small = malloc((n + 1) * sizeof *small);
    const bool is_wide = mesh->vertices > CORNERS_SMALL;
    if (!small) {
        return false;
    }
    for (size_t i = 0; i < n; ++i) {
        small[i] = (uint16_t)mesh->corner[i];
    }
    write_block(to, "mesh-places", 0, mesh->place,
                3 * mesh->vertices * sizeof *mesh->place);
    write_block(to, "mesh-corners", 0,
                is_wide ? (const void *)mesh->corner : small,
                n * (is_wide ? sizeof *mesh->corner : sizeof *small));
    free(small);
    return true;
}

murk_status murk_view_data_write(FILE *to, const murk_view_data *data,
                                 murk_error *err)
{
    const murk_report_scene *s = data->scene;
    char *json = data_json(data);
    bool is_whole = json != NULL;
    if (is_whole) {
        fputs("<script type=\"application/json\" id=\"view-data\">", to);
        murk_page_json(to, json);
        fputs("</script>\n", to);
        cJSON_free(json);
    }
    if (is_whole && data->mesh.triangles > 0) {
        is_whole = write_mesh(to, &data->mesh);
    }
    for (size_t i = 0; i < data->medias && is_whole; ++i) {
        const murk_view_media *m = &data->media[i];
        write_block(to, "media-cells", i, m->cell,
                    m->cell ? m->size[0] * m->size[1] * m->size[2] : 0);
    }
    for (size_t i = 0; i < s->states && is_whole; ++i) {
        is_whole = write_photons(to, &s->state[i], i);
    }
    return is_whole
               ? MURK_OK
               : murk_fail(err, MURK_NO_MEMORY, "", "no memory for the view");
}
