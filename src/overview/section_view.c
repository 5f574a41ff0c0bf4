/* Draws one section of a scene: a ray from each pixel of the plane finds the
 * surface beyond, and the exact segments in which the plane cuts surfaces
 * (geometry/plane_cut.h) are drawn as lines. */
#include "overview/section_view.h"

#include <stdlib.h>
#include <string.h>

#include "base/pool.h"
#include "geometry/plane_cut.h"

/* Sheets that a ray passes before it takes the next surface as the last. */
#define SHEETS_MAX 8
/* A material that transmits more is drawn as one that can be looked through. */
#define CLEAR 0.3

/* Greys of surfaces beyond the plane, as shares of white: of a surface close to
 * the plane that faces it, how much darker a surface edge-on is, how much
 * darker a surface at the largest depth is, and of edges. All greys are lighter
 * than half, so that lines stand out. */
#define GREY_NEAR    0.97
#define GREY_EDGE_ON 0.14
#define GREY_FAR     0.08
#define GREY_EDGE    0.62
#define GREY_SHEET   0.05 /* how much darker red and green are for each sheet */

/* Normals of two pixels that differ by more lie on both sides of an edge: 29
 * degrees, more than between the faces of a round shape of 13 sides. */
#define EDGE_NORMAL 0.5

/* The least cosine that a slope is computed from. */
#define FACING_MIN 0.05

/* ---- places ---- */

void murk_section_find(const murk_section_view *v, murk_vec3 place,
                       double out[2])
{
    out[0] = v->left + (murk_component(place, v->right) - v->low[0]) * v->scale;
    out[1] = v->top + v->height -
             (murk_component(place, v->up) - v->low[1]) * v->scale;
}

void murk_section_direction(const murk_section_view *v, murk_vec3 direction,
                            double out[2])
{
    out[0] = murk_component(direction, v->right);
    out[1] = -murk_component(direction, v->up);
}

static murk_vec3 axis_of(int axis, double length)
{
    murk_vec3 out = {0, 0, 0};
    murk_component_set(&out, axis, length);
    return out;
}

/* The place in the plane that the center of a pixel shows. */
static murk_vec3 place_of(const murk_section_view *v, size_t x, size_t y)
{
    murk_vec3 out;
    murk_component_set(&out, v->right,
                       v->low[0] + ((double)x + 0.5) / v->scale);
    murk_component_set(&out, v->up,
                       v->low[1] + (v->height - (double)y - 0.5) / v->scale);
    murk_component_set(&out, v->along, v->cut_m);
    return out;
}

/* ---- beyond the plane ---- */

typedef struct sampling {
    murk_section_pixels *out;
    const murk_section_view *view;
    const murk_stage *stage;
    murk_path_space space;
    bool any_media;
} sampling;

static bool is_clear(const murk_surfaces *surfaces, const murk_hit *hit)
{
    const murk_material *m = murk_surfaces_material(surfaces, hit->material);
    return hit->solid == 0 && m->transmit.band[0] > CLEAR;
}

static void sample_pixel(const sampling *l, size_t at, murk_vec3 from)
{
    const murk_section_view *v = l->view;
    murk_section_pixels *out = l->out;
    const murk_surfaces *surfaces = l->stage->surfaces;
    const murk_box *box = &l->stage->world.domain.box;
    const murk_vec3 sight = axis_of(v->along, v->sign);
    const double end =
        murk_component(v->sign > 0 ? box->max : box->min, v->along);
    double gone = 0, left = fabs(end - v->cut_m);
    murk_hit hit;
    /* Go through sheets as far as the first other surface. */
    while (murk_surfaces_hit(surfaces, from, sight, left, &hit)) {
        gone += hit.distance_m;
        left -= hit.distance_m;
        if (!is_clear(surfaces, &hit) || out->sheets[at] == SHEETS_MAX) {
            out->depth_m[at] = (float)gone;
            out->facing[at] = (float)fabs(murk_dot(hit.normal, sight));
            out->normal[0][at] = (float)murk_component(hit.normal, v->right);
            out->normal[1][at] = (float)murk_component(hit.normal, v->up);
            return;
        }
        ++out->sheets[at];
        const murk_vec3 on = murk_along(from, hit.distance_m, sight);
        from = murk_surfaces_leave(surfaces, on, murk_scale(-1, hit.normal));
    }
}

static void sample_row(void *context, uint64_t row)
{
    const sampling *l = context;
    murk_section_pixels *out = l->out;
    const murk_box *box = &l->stage->world.domain.box;
    for (size_t x = 0; x < out->width; ++x) {
        const size_t at = row * out->width + x;
        const murk_vec3 from = place_of(l->view, x, row);
        out->depth_m[at] = NAN;
        if (!murk_box_contains(box, from)) {
            continue;
        }
        sample_pixel(l, at, from);
        if (l->any_media) {
            out->extinction_per_m[at] = (float)murk_media_extinction(
                l->stage->media, 0, murk_path_inside(&l->space, from), from);
        }
    }
}

murk_status murk_section_sample(murk_section_pixels *out,
                                const murk_section_view *view,
                                const murk_stage *stage, unsigned threads,
                                murk_error *err)
{
    const size_t width = (size_t)view->width, height = (size_t)view->height;
    const size_t n = width * height;
    *out = (murk_section_pixels){.width = width, .height = height};
    out->depth_m = calloc(n * 5 + 1, sizeof *out->depth_m);
    out->sheets = calloc(n + 1, sizeof *out->sheets);
    if (!out->depth_m || !out->sheets) {
        return murk_no_memory(err, "--picture", "for %zu x %zu pixels", width,
                              height);
    }
    out->facing = out->depth_m + n;
    out->normal[0] = out->facing + n;
    out->normal[1] = out->normal[0] + n;
    out->extinction_per_m = out->normal[1] + n;
    sampling l = {.out = out,
                  .view = view,
                  .stage = stage,
                  .space = murk_path_space_of(stage->surfaces, stage->media,
                                              stage->boundary_meshes,
                                              &stage->world.domain),
                  .any_media = murk_media_any(stage->media)};
    murk_pool_run(threads, height, sample_row, &l);
    /* The largest values, for greys and tints. */
    for (size_t i = 0; i < n; ++i) {
        out->depth_max_m = fmax(out->depth_max_m, (double)out->depth_m[i]);
        out->extinction_max_per_m =
            fmax(out->extinction_max_per_m, (double)out->extinction_per_m[i]);
    }
    return MURK_OK;
}

void murk_section_release(murk_section_pixels *pixels)
{
    free(pixels->depth_m); /* all arrays of floats are one block */
    free(pixels->sheets);
    *pixels = (murk_section_pixels){0};
}

/* How much a pixel allows the depth to differ from that of a neighbour on the
 * same surface: twice the size of a pixel, and twice the change of depth over a
 * pixel by the slope of the surface. */
static double step_of(const murk_section_pixels *p, size_t at, double pixel_m)
{
    const double c = fmax((double)p->facing[at], FACING_MIN);
    return 2 * pixel_m * (1 + sqrt(1 - fmin(c * c, 1)) / c);
}

/* True if there is an edge between two neighbouring pixels: only one shows a
 * surface, or normals or depths differ by more than on one surface. */
static bool is_edge(const murk_section_pixels *p, size_t a, size_t b,
                    double pixel_m)
{
    const double depth_a = (double)p->depth_m[a],
                 depth_b = (double)p->depth_m[b];
    if (isnan(depth_a) || isnan(depth_b)) {
        return isnan(depth_a) != isnan(depth_b);
    }
    const double turn = hypot((double)(p->normal[0][a] - p->normal[0][b]),
                              (double)(p->normal[1][a] - p->normal[1][b]));
    return turn > EDGE_NORMAL ||
           fabs(depth_a - depth_b) >
               step_of(p, a, pixel_m) + step_of(p, b, pixel_m);
}

static double grey_of(const murk_section_pixels *p, size_t at)
{
    const double depth =
        p->depth_max_m > 0 ? (double)p->depth_m[at] / p->depth_max_m : 0;
    return GREY_NEAR - GREY_EDGE_ON * (1 - (double)p->facing[at]) -
           GREY_FAR * depth;
}

void murk_section_draw_beyond(murk_canvas *canvas, const murk_section_view *v,
                              const murk_section_pixels *p, double max_per_m)
{
    const murk_ink medium = MURK_SECTION_MEDIUM;
    murk_raster *raster = murk_canvas_raster(canvas);
    for (size_t y = 0; y < p->height; ++y) {
        uint8_t *row = raster->rgb + 3 * (((size_t)v->top + y) * raster->width +
                                          (size_t)v->left);
        for (size_t x = 0; x < p->width; ++x) {
            /* The surface, or an edge of it. */
            const size_t at = y * p->width + x;
            double grey = isnan(p->depth_m[at]) ? 1 : grey_of(p, at);
            if ((x + 1 < p->width && is_edge(p, at, at + 1, 1 / v->scale)) ||
                (y + 1 < p->height &&
                 is_edge(p, at, at + p->width, 1 / v->scale))) {
                grey = GREY_EDGE;
            }
            /* Sheets and the medium before it; the square root shows thin haze
             * beside dense smoke. */
            const double tint =
                max_per_m > 0
                    ? MURK_SECTION_TINT_MAX *
                          sqrt((double)p->extinction_per_m[at] / max_per_m)
                    : 0;
            const double sheets = GREY_SHEET * p->sheets[at];
            for (int k = 0; k < 3; ++k) {
                const double base = 255 * fmax(0, grey - (k < 2 ? sheets : 0));
                row[3 * x + (size_t)k] =
                    (uint8_t)(base + tint * (medium.rgb[k] - base) + 0.5);
            }
        }
    }
}

/* ---- in the plane ---- */

static murk_ink ink_of(const murk_surfaces *surfaces, size_t primitive)
{
    const murk_material *m = murk_surfaces_material(
        surfaces, murk_surfaces_material_of(surfaces, primitive));
    return !(m->transmit.band[0] > CLEAR) ? MURK_SECTION_WALL
           : m->ior > 0                   ? MURK_SECTION_SOLID
                                          : MURK_SECTION_SHEET;
}

murk_status murk_section_draw_cut(murk_canvas *canvas,
                                  const murk_section_view *v,
                                  const murk_stage *stage, double line_width,
                                  murk_error *err)
{
    const murk_cut_plane plane = {axis_of(v->along, v->cut_m),
                                  axis_of(v->along, -v->sign)};
    murk_plane_cut cut;
    const murk_status status =
        murk_plane_cut_surfaces(&cut, stage->surfaces, &plane, err);
    murk_pen pen = {.width = line_width};
    /* Segments of triangles, then circles of spheres. */
    for (size_t i = 0; !status && i < cut.segments; ++i) {
        double from[2], to[2];
        murk_section_find(v, cut.segment[i].from, from);
        murk_section_find(v, cut.segment[i].to, to);
        pen.ink = ink_of(stage->surfaces, cut.segment[i].triangle);
        murk_canvas_line(canvas, from, to, &pen);
    }
    for (size_t i = 0; !status && i < cut.circles; ++i) {
        pen.ink = ink_of(stage->surfaces, cut.circle[i].sphere);
        murk_section_draw_ball(canvas, v, cut.circle[i].center,
                               cut.circle[i].radius_m, &pen);
    }
    murk_plane_cut_release(&cut);
    return status;
}

/* ---- outlines ---- */

void murk_section_draw_box(murk_canvas *canvas, const murk_section_view *v,
                           const murk_box *box, const murk_affine *placed,
                           const murk_pen *pen)
{
    double at[8][2];
    for (int i = 0; i < 8; ++i) {
        murk_vec3 corner = {i & 1 ? box->max.x : box->min.x,
                            i & 2 ? box->max.y : box->min.y,
                            i & 4 ? box->max.z : box->min.z};
        corner = placed ? murk_affine_point(placed, corner) : corner;
        murk_section_find(v, corner, at[i]);
    }
    for (int i = 0; i < 8; ++i) {
        for (int bit = 1; bit < 8; bit *= 2) {
            const int other = i | bit;
            const bool has_length =
                hypot(at[i][0] - at[other][0], at[i][1] - at[other][1]) > 0.5;
            if (other != i && has_length) {
                murk_canvas_line(canvas, at[i], at[other], pen);
            }
        }
    }
}

void murk_section_draw_ball(murk_canvas *canvas, const murk_section_view *v,
                            murk_vec3 center, double radius_m,
                            const murk_pen *pen)
{
    double at[2];
    murk_section_find(v, center, at);
    murk_canvas_circle(canvas, at, radius_m * v->scale, pen);
}
