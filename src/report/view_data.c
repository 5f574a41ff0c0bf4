/* Makes the data of the view in space, reduced to what a page can have: the box
 * that is shown, triangles, media in cells, and photons with places as whole
 * numbers in a box. */
#include "report/view_data.h"

#include "report/html.h"
#include "world/extent.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TRIANGLES_MAX 40000  /* 0.5 MB of the page */
#define CELLS_MAX     128000 /* of all media together */
#define STEPS         65535  /* the largest number of two bytes */
#define CORNERS_SMALL 65536  /* numbers of vertices that two bytes have */
#define BIT_SENSORS   32     /* that have a bit in plan.ply */

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

/* The box of the surfaces within the domain; without any, the domain. */
static murk_box world_box(const murk_stage *stage)
{
    const murk_box *all = &stage->world.domain.box;
    const murk_surfaces_facts facts = murk_surfaces_describe(stage->surfaces);
    murk_box box = facts.bounds_m;
    if (!murk_extent_is_box(&box)) {
        return *all;
    }
    box = murk_box_meet(box, *all);
    return murk_extent_is_box(&box) ? box : *all;
}

/* The box of all photons (without any, of the surfaces), sensors, readings and
 * the path. A large ground that light does not reach does not count. */
static murk_box view_box(const murk_report_scene *s)
{
    murk_box box = murk_box_empty();
    for (size_t i = 0; i < s->states; ++i) {
        box = points_box(box, &s->state[i].points);
    }
    if (!murk_extent_is_box(&box) && s->stage) {
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
    return murk_extent_is_box(&box) ? box : (murk_box){{0, 0, 0}, {0, 0, 0}};
}

/* ---- making ---- */

static bool same_media(const murk_view_media *a, const murk_view_media *b)
{
    const size_t n = a->size[0] * a->size[1] * a->size[2];
    return !a->cell == !b->cell && !(a->max_per_m < b->max_per_m) &&
           !(a->max_per_m > b->max_per_m) &&
           (!a->cell || (memcmp(a->size, b->size, sizeof a->size) == 0 &&
                         memcmp(a->cell, b->cell, n) == 0));
}

/* Makes the media of each state; equal media are there once. */
static murk_status fill_media(murk_view_data *out, murk_error *err)
{
    const murk_report_scene *s = out->scene;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < s->states && !status; ++i) {
        const murk_media *base = s->stage ? s->stage->media : NULL;
        const murk_media *own = s->stage ? s->state[i].media : NULL;
        murk_view_media *now = &out->media[out->medias];
        status = murk_view_media_make(now, own ? own : base, &out->box,
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

static murk_status make(murk_view_data *out, const murk_report_scene *scene,
                        murk_error *err)
{
    *out = (murk_view_data){.scene = scene, .box = view_box(scene)};
    murk_status status = MURK_OK;
    if (scene->stage) {
        status = murk_view_mesh_make(&out->mesh, scene->stage->surfaces,
                                     TRIANGLES_MAX, err);
    }
    if (!status) {
        status = murk_view_sections_make(&out->sections, scene, err);
    }
    return status ? status : fill_media(out, err);
}

static void release(murk_view_data *data)
{
    for (size_t i = 0; i < data->medias; ++i) {
        murk_view_media_release(&data->media[i]);
    }
    murk_view_mesh_release(&data->mesh);
    murk_view_sections_release(&data->sections);
    *data = (murk_view_data){0};
}

/* ---- bytes ---- */

size_t murk_view_bit_bytes(const murk_shown_state *state)
{
    const size_t n =
        state->sensors < BIT_SENSORS ? state->sensors : BIT_SENSORS;
    return (n + 7) / 8;
}

murk_box murk_view_photon_box(const murk_plan_points *points)
{
    const murk_box box = points_box(murk_box_empty(), points);
    return murk_extent_is_box(&box) ? box : (murk_box){{0, 0, 0}, {0, 0, 0}};
}

bool murk_view_is_wide(const murk_view_mesh *mesh)
{
    return mesh->vertices > CORNERS_SMALL;
}

static void write_block(FILE *to, const char *name, size_t number,
                        const void *bytes, size_t size)
{
    fprintf(to, "<script type=\"text/plain\" id=\"%s-%zu\">", name, number);
    murk_html_base64(to, bytes, size);
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
    const murk_box box = murk_view_photon_box(points);
    const size_t bytes = murk_view_bit_bytes(state);
    uint16_t *place = malloc((3 * points->n + 1) * sizeof *place);
    uint8_t *seen = malloc(points->n + 1);
    uint8_t *who = malloc(bytes * points->n + 1);
    const bool is_whole = place && seen && who;
    /* places, the number of sensors that see each, and which of the first 32 */
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
    const bool is_wide = murk_view_is_wide(mesh);
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

static murk_status write_all(FILE *to, const murk_view_data *data,
                             murk_error *err)
{
    const murk_report_scene *s = data->scene;
    bool is_whole = true;
    murk_view_data_json(to, data);
    if (data->mesh.triangles > 0) {
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
    return is_whole ? MURK_OK : murk_no_memory(err, "", "for the view");
}

murk_status murk_view_data_write(FILE *to, const murk_report_scene *scene,
                                 murk_error *err)
{
    murk_view_data data;
    murk_status status = make(&data, scene, err);
    if (!status) {
        status = write_all(to, &data, err);
    }
    release(&data);
    return status;
}
