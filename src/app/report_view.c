/* The view in space of the report: the section, and the data that its script
 * draws (tools/report/view.js reads these names). */
#include "app/page.h"
#include "app/report_scene.h"
#include "app/view_mesh.h"
#include "medium/interfaces.h"
#include "sensing/sensor.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TRIANGLES_MAX 40000
#define SPHERES_MAX   1000
#define CELLS_ALONG   40 /* of media, along the longest side */
#define STEPS         65535
#define DOT_SHARE     400 /* a photon's dot, of the view's size */

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "numbers are sent as they lie in memory");

typedef struct cells {
    murk_box box;
    size_t size[3];
    uint8_t *cell; /* extinction, of the largest; x fastest. NULL: none */
    double most_per_m;
    bool is_even;
} cells;

/* ---- how large ---- */

static murk_vec3 place_of(const murk_plan_point *point)
{
    return murk_vec((double)point->place_m[0], (double)point->place_m[1],
                    (double)point->place_m[2]);
}

static murk_box photon_box(const murk_plan_points *points)
{
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < points->n; ++i) {
        box = murk_box_with(box, place_of(&points->point[i]));
    }
    return points->n > 0 ? box : (murk_box){{0, 0, 0}, {0, 0, 0}};
}

/* All that lights reached, and the sensors: a large ground about it does not
 * count. */
static murk_box view_box(const murk_report_scene *s)
{
    murk_box box = s->points.n > 0 ? photon_box(&s->points) : murk_box_empty();
    for (size_t i = 0; i < s->sensors; ++i) {
        box = murk_box_with(box, s->sensor[i].place);
    }
    return box;
}

/* ---- media ---- */

static murk_vec3 cell_middle(const cells *c, size_t i)
{
    const size_t at[3] = {i % c->size[0], i / c->size[0] % c->size[1],
                          i / (c->size[0] * c->size[1])};
    const murk_vec3 size = murk_sub(c->box.max, c->box.min);
    return murk_add(
        c->box.min,
        murk_vec(size.x * ((double)at[0] + 0.5) / (double)c->size[0],
                 size.y * ((double)at[1] + 0.5) / (double)c->size[1],
                 size.z * ((double)at[2] + 0.5) / (double)c->size[2]));
}

/* Extinction in the first band, cell by cell; nothing in clear air. */
static bool fill_cells(cells *out, const murk_report_scene *s)
{
    const murk_media *media = s->stage ? s->stage->media : NULL;
    *out = (cells){.box = view_box(s)};
    if (!media || !murk_media_any(media)) {
        return true;
    }
    const murk_vec3 size = murk_sub(out->box.max, out->box.min);
    const double along[3] = {size.x, size.y, size.z};
    const double longest = fmax(fmax(size.x, size.y), size.z);
    for (int k = 0; k < 3; ++k) {
        const double share = longest > 0 ? along[k] / longest : 0;
        out->size[k] = (size_t)fmax(1, ceil(CELLS_ALONG * share));
    }
    const size_t n = out->size[0] * out->size[1] * out->size[2];
    double *value = malloc(n * sizeof *value);
    out->cell = malloc(n);
    if (!value || !out->cell) {
        free(value);
        return false;
    }
    double least = INFINITY;
    for (size_t i = 0; i < n; ++i) {
        const murk_vec3 p = cell_middle(out, i);
        value[i] =
            murk_media_extinction(media, 0, murk_media_inside(media, p), p);
        out->most_per_m = fmax(out->most_per_m, value[i]);
        least = fmin(least, value[i]);
    }
    for (size_t i = 0; i < n; ++i) {
        const double share =
            out->most_per_m > 0 ? value[i] / out->most_per_m : 0;
        out->cell[i] = (uint8_t)floor(255 * share + 0.5);
    }
    out->is_even = !(least < 0.99 * out->most_per_m);
    free(value);
    return true;
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

static void add_vector(cJSON *to, const char *key, murk_vec3 v)
{
    const double number[3] = {v.x, v.y, v.z};
    cJSON_AddItemToObject(to, key, cJSON_CreateDoubleArray(number, 3));
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

static void add_sensor(cJSON *list, const murk_report_scene *s,
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
    cJSON_AddStringToObject(item, "view",
                            views[type ? type->view : MURK_SCENE_VIEW_SPHERE]);
    const bool is_cone = type && type->view == MURK_SCENE_VIEW_CONE;
    const double angle[2] = {type ? is_cone ? type->cone_rad : type->hfov_rad
                                  : 0,
                             type ? type->vfov_rad : 0};
    cJSON_AddItemToObject(item, "angles_rad",
                          cJSON_CreateDoubleArray(angle, 2));
    add_number(item, "range_m", type ? type->range_m : NAN);
    add_number(item, "covers", sensor->covers);
    add_number(item, "only", sensor->only);
    cJSON_AddItemToArray(list, item);
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

static char *data_json(const murk_report_scene *s, const murk_view_mesh *mesh,
                       const cells *media, size_t surface_photons)
{
    const murk_box all = view_box(s), photons = photon_box(&s->points);
    const double size = murk_length(murk_sub(all.max, all.min));
    cJSON *root = cJSON_CreateObject();
    add_vector(root, "middle", murk_scale(0.5, murk_add(all.min, all.max)));
    /* a single place has a view, too */
    add_number(root, "size_m", size > 0 ? size : 1);
    add_number(root, "dot_m", (size > 0 ? size : 1) / DOT_SHARE);
    add_number(root, "photons", (double)s->points.n);
    add_number(root, "surface_photons", (double)surface_photons);
    add_box(cJSON_AddObjectToObject(root, "photon_box"), &photons);
    cJSON *sensors = cJSON_AddArrayToObject(root, "sensors");
    for (size_t i = 0; i < s->sensors; ++i) {
        add_sensor(sensors, s, &s->sensor[i]);
    }
    add_balls(root, s->stage ? s->stage->surfaces : NULL);
    if (mesh->triangles > 0) {
        cJSON *item = cJSON_AddObjectToObject(root, "mesh");
        add_box(item, &mesh->box);
        cJSON_AddNumberToObject(item, "steps", MURK_VIEW_STEPS);
    }
    if (media->cell) {
        const double count[3] = {(double)media->size[0], (double)media->size[1],
                                 (double)media->size[2]};
        cJSON *item = cJSON_AddObjectToObject(root, "media");
        add_box(item, &media->box);
        cJSON_AddItemToObject(item, "size", cJSON_CreateDoubleArray(count, 3));
    }
    char *text = cJSON_PrintUnformatted(root);
    cJSON_Delete(root);
    return text;
}

/* ---- bytes ---- */

static void write_block(FILE *to, const char *id, const void *bytes,
                        size_t size)
{
    fprintf(to, "<script type=\"text/plain\" id=\"%s\">", id);
    murk_page_base64(to, bytes, size);
    fputs("</script>\n", to);
}

static uint16_t step_of(double value, double low, double high)
{
    const double share = high > low ? (value - low) / (high - low) : 0;
    return (uint16_t)floor(fmin(fmax(share, 0), 1) * STEPS + 0.5);
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

static bool write_photons(FILE *to, const murk_plan_points *points)
{
    const murk_box box = photon_box(points);
    uint16_t *place = malloc((3 * points->n + 1) * sizeof *place);
    uint8_t *seen = malloc(points->n + 1);
    const bool is_whole = place && seen;
    for (size_t i = 0; is_whole && i < points->n; ++i) {
        const murk_plan_point *point = &points->point[i];
        const murk_vec3 p = place_of(point);
        place[3 * i] = step_of(p.x, box.min.x, box.max.x);
        place[3 * i + 1] = step_of(p.y, box.min.y, box.max.y);
        place[3 * i + 2] = step_of(p.z, box.min.z, box.max.z);
        seen[i] = (uint8_t)(point->seen_by < 255 ? point->seen_by : 255);
    }
    if (is_whole) {
        write_block(to, "photon-places", place, 3 * points->n * sizeof *place);
        write_block(to, "photon-seen", seen, points->n);
    }
    free(place);
    free(seen);
    return is_whole;
}

/* ---- the section ---- */

static void write_switch(FILE *to, const char *value, const char *text,
                         bool is_on)
{
    fprintf(to, "<label><input type=\"checkbox\" value=\"%s\"%s> %s</label>\n",
            value, is_on ? " checked" : "", text);
}

static void write_controls(FILE *to, const murk_report_scene *s,
                           const cells *media)
{
    fputs("<div class=\"switches interactive\">\n", to);
    write_switch(to, "surfaces", "surfaces", true);
    write_switch(to, "surface-photons", "photons on surfaces", true);
    write_switch(to, "volume-photons", "photons in media", true);
    write_switch(to, "sensors", "sensors", true);
    write_switch(to, "ranges", "ranges and views", true);
    write_switch(to, "media", "media", media->cell && !media->is_even);
    fputs("<label>sensor <select id=\"view-sensor\">"
          "<option value=\"-1\">none</option>",
          to);
    for (size_t i = 0; i < s->sensors; ++i) {
        fprintf(to, "<option value=\"%zu\">%zu: ", i, i + 1);
        murk_page_text(to, s->sensor[i].type);
        fputs("</option>", to);
    }
    fputs("</select></label>\n"
          "<button type=\"button\" value=\"corner\">from a corner</button>\n"
          "<button type=\"button\" value=\"above\">from above</button>\n"
          "<button type=\"button\" value=\"side\">from the side</button>\n"
          "</div>\n",
          to);
}

static void write_notes(FILE *to, const murk_report_scene *s,
                        const murk_view_mesh *mesh, const cells *media)
{
    fputs("<p class=\"note\">", to);
    if (s->points.n < s->points.photons) {
        fprintf(to, "Of %llu stored photons %zu are shown, evenly chosen. ",
                (unsigned long long)s->points.photons, s->points.n);
    }
    if (mesh->is_coarse) {
        fprintf(to,
                "Of %zu triangles %zu are shown: surfaces are coarser here "
                "than in the simulation. ",
                mesh->asked, mesh->triangles);
    }
    if (media->cell) {
        fputs("Media: extinction, at most ", to);
        murk_page_number(to, media->most_per_m);
        fputs(" per m in the first band. ", to);
    }
    fputs("<span class=\"interactive\">Drag to turn, scroll to go nearer; or "
          "the arrow keys, + and -, with the picture in focus.</span></p>\n",
          to);
}

static bool write_section(FILE *to, const murk_report_scene *s,
                          const murk_view_mesh *mesh, const cells *media)
{
    char *json = data_json(s, mesh, media, count_on_surfaces(&s->points));
    if (!json) {
        return false;
    }
    fputs("<div id=\"view\" hidden>\n", to);
    write_controls(to, s, media);
    fputs("<canvas id=\"view-canvas\" tabindex=\"0\" role=\"img\" "
          "aria-label=\"The scene in space; the drawings and the table of "
          "sensors say the same\"></canvas>\n"
          "<p class=\"picked\" id=\"view-picked\" role=\"status\"></p>\n",
          to);
    write_notes(to, s, mesh, media);
    fputs("</div>\n<script type=\"application/json\" id=\"view-data\">", to);
    murk_page_json(to, json);
    fputs("</script>\n", to);
    cJSON_free(json);
    if (mesh->triangles > 0) {
        write_block(to, "mesh-places", mesh->place,
                    3 * mesh->vertices * sizeof *mesh->place);
        write_block(to, "mesh-corners", mesh->corner,
                    3 * mesh->triangles * sizeof *mesh->corner);
    }
    if (media->cell) {
        write_block(to, "media-cells", media->cell,
                    media->size[0] * media->size[1] * media->size[2]);
    }
    return write_photons(to, &s->points);
}

murk_status murk_report_view(FILE *to, const murk_report_scene *scene,
                             murk_error *err)
{
    murk_view_mesh mesh = {0};
    cells media = {0};
    murk_status status = MURK_OK;
    if (scene->points.n + scene->sensors == 0) {
        return MURK_OK;
    }
    if (scene->stage) {
        status = murk_view_mesh_make(&mesh, scene->stage->surfaces,
                                     TRIANGLES_MAX, err);
    }
    if (!status && (!fill_cells(&media, scene) ||
                    !write_section(to, scene, &mesh, &media))) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory for the view");
    }
    free(media.cell);
    murk_view_mesh_release(&mesh);
    return status;
}
