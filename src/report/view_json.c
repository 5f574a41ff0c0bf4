/* The data of the view as one JSON object, with the names that
 * tools/report/data.js and other scripts there read. */
#include "report/data.h"
#include "report/view_data.h"
#include "sensing/sensor.h"

#include <math.h>
#include <string.h>

#define SPHERES_MAX 1000 /* some 60 kB of the page */
#define LAMPS_MAX   1000 /* some 150 kB of the page */
#define DOT_SHARE   400  /* size of the view over size of a photon's dot */

/* Number of photons on surfaces, which come first, as in plan.ply. */
static size_t count_on_surfaces(const murk_plan_points *points)
{
    size_t n = 0;
    while (n < points->n && !points->point[n].is_volume) {
        ++n;
    }
    return n;
}

static void add_box(murk_data *to, const murk_box *box)
{
    murk_data_vector(to, "low", box->min);
    murk_data_vector(to, "high", box->max);
}

static double radians(double degrees)
{
    return isfinite(degrees) ? degrees * (MURK_PI / 180) : 0;
}

static void add_sensor(murk_data *item, const murk_report_scene *s,
                       const murk_shown_sensor *sensor)
{
    const murk_scene_sensor_type *type = sensor->of;
    const murk_pose pose = {.position = sensor->place,
                            .heading_rad = radians(sensor->heading_deg),
                            .tilt_rad = radians(sensor->tilt_deg)};
    const murk_sensor_frame frame =
        murk_pose_frame(&pose, s->scene ? s->scene->north : murk_vec(0, 1, 0));
    /* the pose with its axes, the view, the range, what the sensor covers */
    murk_data_begin(item, NULL, '{');
    murk_data_text(item, "type", sensor->type);
    murk_data_vector(item, "place", sensor->place);
    murk_data_vector(item, "axis", frame.axis);
    murk_data_vector(item, "right", frame.right);
    murk_data_vector(item, "up", frame.up);
    murk_data_number(item, "heading_deg", sensor->heading_deg);
    murk_data_number(item, "tilt_deg", sensor->tilt_deg);
    murk_data_text(item, "view",
                   murk_view_name(type ? type->view : MURK_VIEW_SPHERE));
    const bool is_cone = type && type->view == MURK_VIEW_CONE;
    const double angle[2] = {type ? is_cone ? type->cone_rad : type->hfov_rad
                                  : 0,
                             type ? type->vfov_rad : 0};
    murk_data_numbers(item, "angles_rad", angle, 2);
    murk_data_number(item, "range_m", type ? type->range_m : NAN);
    murk_data_number(item, "least_range_m", type ? type->least_range_m : NAN);
    murk_data_number(item, "covers", sensor->covers);
    murk_data_number(item, "only", sensor->only);
    murk_data_end(item, '}');
}

static void add_balls(murk_data *item, const murk_surfaces *surfaces)
{
    murk_data_begin(item, "balls", '[');
    const size_t n = surfaces ? murk_surfaces_describe(surfaces).spheres : 0;
    for (size_t i = 0; i < n && i < SPHERES_MAX; ++i) {
        murk_vec3 center;
        double radius_m;
        murk_surfaces_sphere(surfaces, i, &center, &radius_m);
        murk_data_begin(item, NULL, '{');
        murk_data_vector(item, "center", center);
        murk_data_number(item, "radius", radius_m);
        murk_data_end(item, '}');
    }
    murk_data_end(item, ']');
}

/* The direction in which the light of a sun or moon travels, from its azimuth
 * and elevation. */
static murk_vec3 travel_of(const murk_scene_desc *scene,
                           const murk_sky_facts *facts)
{
    const murk_pose to = {.heading_rad = radians(facts->azimuth_deg),
                          .tilt_rad = radians(facts->elevation_deg)};
    return murk_scale(-1, murk_pose_frame(&to, scene->north).axis);
}

static void add_lamp(murk_data *item, const murk_report_scene *s, size_t i)
{
    const murk_scene_light *light = &s->scene->lights[i];
    const bool is_on = !s->stage || !s->stage->sky || s->stage->sky[i].is_on;
    const murk_source_group group = murk_source_type_group(light->type);
    const bool is_body = group == MURK_SOURCE_BODY;
    if (group == MURK_SOURCE_DOME || !is_on ||
        (is_body && !(s->stage && s->stage->sky))) {
        return; /* a sky has no place and no direction; a body may be below the
                   horizon */
    }
    murk_data_begin(item, NULL, '{');
    murk_data_text(item, "type",
                   group == MURK_SOURCE_DISTANT
                       ? "distant light"
                       : murk_source_type_name(light->type));
    murk_data_bool(item, "distant", murk_scene_light_is_distant(light));
    murk_data_vector(item, "place", light->position);
    murk_data_vector(item, "direction",
                     is_body ? travel_of(s->scene, &s->stage->sky[i])
                             : light->direction);
    if (murk_length(light->edge1) > 0) {
        murk_data_vector(item, "edge1", light->edge1);
        murk_data_vector(item, "edge2", light->edge2);
    }
    murk_data_end(item, '}');
}

static void add_lamps(murk_data *item, const murk_report_scene *s)
{
    murk_data_begin(item, "lamps", '[');
    const size_t n = s->scene ? s->scene->n_lights : 0;
    for (size_t i = 0; i < n && i < LAMPS_MAX; ++i) {
        add_lamp(item, s, i);
    }
    murk_data_end(item, ']');
}

static void add_readings(murk_data *item, const murk_report_scene *s)
{
    static const char *const texts[] = {"kind", "unit", "condition"};
    static const char *const numbers[][2] = {
        {"line", "line"},
        {"value", "value"},
        {"standard_error", "standard_error"},
        {"predicted", "predicted"},
        {"residual", "residual_in_standard_errors"}};
    murk_data_begin(item, "readings", '[');
    for (size_t i = 0; i < s->readings; ++i) {
        const murk_shown_reading *r = &s->reading[i];
        murk_data_begin(item, NULL, '{');
        murk_data_vector(item, "place", r->place);
        murk_data_vector(item, "to", r->to);
        /* cells of fit.csv; one that is not a number is null */
        for (size_t k = 0; k < sizeof texts / sizeof *texts; ++k) {
            murk_data_text(item, texts[k],
                           murk_table_text(s->fit, r->row, texts[k]));
        }
        murk_data_bool(
            item, "held_out",
            strcmp(murk_table_text(s->fit, r->row, "use"), "hold_out") == 0);
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; ++k) {
            murk_data_number(item, numbers[k][0],
                             murk_table_value(s->fit, r->row, numbers[k][1]));
        }
        murk_data_end(item, '}');
    }
    murk_data_end(item, ']');
}

static void add_states(murk_data *item, const murk_view_data *data)
{
    const murk_report_scene *s = data->scene;
    murk_data_begin(item, "states", '[');
    for (size_t i = 0; i < s->states; ++i) {
        const murk_shown_state *state = &s->state[i];
        const murk_box box = murk_view_photon_box(&state->points);
        murk_data_begin(item, NULL, '{');
        murk_data_text(item, "name", state->name);
        murk_data_number(item, "stored", (double)state->points.photons);
        murk_data_number(item, "photons", (double)state->points.n);
        murk_data_number(item, "surface_photons",
                         (double)count_on_surfaces(&state->points));
        murk_data_number(item, "bit_bytes", (double)murk_view_bit_bytes(state));
        add_box(item, &box);
        murk_data_number(item, "media", (double)data->media_of[i]);
        murk_data_begin(item, "sensors", '[');
        for (size_t k = 0; k < state->sensors; ++k) {
            add_sensor(item, s, &state->sensor[k]);
        }
        murk_data_end(item, ']');
        murk_data_end(item, '}');
    }
    murk_data_end(item, ']');
}

static void add_media(murk_data *item, const murk_view_data *data)
{
    murk_data_begin(item, "media", '[');
    for (size_t i = 0; i < data->medias; ++i) {
        const murk_view_media *media = &data->media[i];
        const double count[3] = {(double)media->size[0], (double)media->size[1],
                                 (double)media->size[2]};
        murk_data_begin(item, NULL, '{');
        murk_data_bool(item, "there", media->cell != NULL);
        murk_data_bool(item, "even", media->is_even);
        add_box(item, &media->box);
        murk_data_numbers(item, "size", count, 3);
        murk_data_number(item, "most_per_m", media->max_per_m);
        murk_data_end(item, '}');
    }
    murk_data_end(item, ']');
}

/* Adds facts on which texts and switches of the page's section about the view
 * depend. */
static void add_facts(murk_data *root, const murk_report_scene *s)
{
    bool has_lamps = false;
    for (size_t i = 0; s->scene && i < s->scene->n_lights; ++i) {
        has_lamps =
            has_lamps || murk_source_type_group(s->scene->lights[i].type) !=
                             MURK_SOURCE_DOME;
    }
    murk_data_bool(root, "has_lamps", has_lamps);
    murk_data_bool(root, "targets",
                   s->scene && s->scene->placement.targets.given);
    murk_data_bool(root, "study", s->is_study);
    murk_data_bool(root, "follow", s->is_follow);
    murk_data_number(root, "states_asked", (double)s->states_asked);
    murk_data_bool(root, "periodic",
                   s->stage && s->stage->world.domain.is_periodic);
    if (s->stage) {
        murk_data_begin(root, "domain", '{');
        add_box(root, &s->stage->world.domain.box);
        murk_data_end(root, '}');
    }
}

void murk_view_data_json(FILE *to, const murk_view_data *data)
{
    const murk_report_scene *s = data->scene;
    const double size = murk_length(murk_sub(data->box.max, data->box.min));
    murk_data json = murk_data_open(to, "view-data");
    murk_data *root = &json;
    add_box(root, &data->box);
    /* places in the view are relative to the local origin of the scene */
    murk_data_vector(root, "origin",
                     s->scene ? s->scene->origin : murk_vec(0, 0, 0));
    /* a view of a single place has the size 1 */
    murk_data_number(root, "size_m", size > 0 ? size : 1);
    murk_data_number(root, "dot_m", (size > 0 ? size : 1) / DOT_SHARE);
    murk_data_vector(root, "north",
                     s->scene ? s->scene->north : murk_vec(0, 1, 0));
    add_states(root, data);
    add_media(root, data);
    add_balls(root, s->stage ? s->stage->surfaces : NULL);
    add_lamps(root, s);
    add_readings(root, s);
    murk_data_begin(root, "path", '[');
    for (size_t i = 0; i < s->stops; ++i) {
        murk_data_vector(root, NULL, s->stop[i]);
    }
    murk_data_end(root, ']');
    add_facts(root, s);
    if (s->stage) {
        murk_view_sections_add(root, &data->sections);
    }
    if (data->mesh.triangles > 0) {
        murk_data_begin(root, "mesh", '{');
        murk_data_number(root, "asked", (double)data->mesh.asked);
        murk_data_number(root, "triangles", (double)data->mesh.triangles);
        murk_data_bool(root, "coarse", data->mesh.is_coarse);
        add_box(root, &data->mesh.box);
        murk_data_number(root, "steps", MURK_VIEW_STEPS);
        murk_data_bool(root, "wide", murk_view_is_wide(&data->mesh));
        murk_data_end(root, '}');
    }
    murk_data_close(root);
}
