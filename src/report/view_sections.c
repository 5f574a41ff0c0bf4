/* Cuts the surfaces of a report's world by two planes (geometry/plane_cut.h)
 * and writes the lines into the page; if there are more than LINES_MAX, only
 * the longest ones, and circles last. */
#include "report/view_sections.h"

#include "world/section_cut.h"

#include <stdlib.h>

/* Lines of one drawing at most: 210 kB of the page. */
#define LINES_MAX 10000

/* Sides of the polygon that stands for a circle. */
#define CIRCLE_SIDES 48

/* The axis at right angles to the plane of each drawing, and the axes to the
 * right and up. */
static const int AXES[MURK_VIEW_SECTIONS][3] = {{2, 0, 1}, {1, 0, 2}};

/* ---- cutting ---- */

/* The normal points towards the viewer: upwards for the drawing from above, and
 * against y for the drawing from the side. */
static murk_cut_plane plane_of(murk_vec3 cut, int axis)
{
    murk_cut_plane plane = {cut, {0, 0, 0}};
    murk_component_set(&plane.normal, axis, axis == 2 ? 1 : -1);
    return plane;
}

murk_status murk_view_sections_make(murk_view_sections *out,
                                    const murk_report_scene *scene,
                                    murk_error *err)
{
    *out = (murk_view_sections){.cut = {0, 0, 0}};
    if (!scene->stage) {
        return MURK_OK;
    }
    /* The places of the sensors say where to cut. */
    const murk_shown_state *state = &scene->state[0];
    const size_t sites = scene->states > 0 ? state->sensors : 0;
    murk_vec3 *site = malloc((sites + 1) * sizeof *site);
    if (!site) {
        return murk_no_memory(err, "", "for sections");
    }
    for (size_t i = 0; i < sites; ++i) {
        site[i] = state->sensor[i].place;
    }
    out->cut = murk_stage_section_cut(scene->stage, site, sites);
    out->box = scene->stage->world.domain.box;
    free(site);
    /* The lines of both drawings. */
    murk_status status = MURK_OK;
    for (int i = 0; i < MURK_VIEW_SECTIONS && !status; ++i) {
        const murk_cut_plane plane = plane_of(out->cut, AXES[i][0]);
        status = murk_plane_cut_surfaces(&out->lines[i], scene->stage->surfaces,
                                         &plane, err);
    }
    return status;
}

void murk_view_sections_release(murk_view_sections *sections)
{
    for (int i = 0; i < MURK_VIEW_SECTIONS; ++i) {
        murk_plane_cut_release(&sections->lines[i]);
    }
}

/* ---- writing ---- */

static double length_of(const murk_cut_segment *s)
{
    return murk_length(murk_sub(s->to, s->from));
}

/* The longer line first; equal lines in the order of their triangles. */
static int by_length(const void *a, const void *b)
{
    const murk_cut_segment *x = a, *y = b;
    const double longer = length_of(y) - length_of(x);
    return longer > 0 ? 1
           : longer < 0
               ? -1
               : (x->triangle > y->triangle) - (x->triangle < y->triangle);
}

/* Two coordinates of a place, counted from the lower corner of the box. */
static void put(double out[2], const murk_box *box, murk_vec3 place,
                const int axes[3])
{
    for (int k = 0; k < 2; ++k) {
        out[k] = murk_component(place, axes[k + 1]) -
                 murk_component(box->min, axes[k + 1]);
    }
}

/* Corner i of the polygon that stands for a circle in the plane. */
static murk_vec3 on_circle(const murk_cut_circle *c, const int axes[3], int i)
{
    const double angle = 2 * MURK_PI * i / CIRCLE_SIDES;
    murk_vec3 place = c->center;
    murk_component_set(&place, axes[1],
                       murk_component(place, axes[1]) +
                           c->radius_m * cos(angle));
    murk_component_set(&place, axes[2],
                       murk_component(place, axes[2]) +
                           c->radius_m * sin(angle));
    return place;
}

static size_t fill_lines(double (*line)[4], const murk_plane_cut *cut,
                         const murk_box *box, const int axes[3])
{
    size_t n = 0;
    for (size_t i = 0; i < cut->segments && n < LINES_MAX; ++i) {
        put(line[n], box, cut->segment[i].from, axes);
        put(line[n++] + 2, box, cut->segment[i].to, axes);
    }
    for (size_t i = 0; i < cut->circles; ++i) {
        for (int k = 0; k < CIRCLE_SIDES && n < LINES_MAX; ++k) {
            put(line[n], box, on_circle(&cut->circle[i], axes, k), axes);
            put(line[n++] + 2, box, on_circle(&cut->circle[i], axes, k + 1),
                axes);
        }
    }
    return n;
}

void murk_view_sections_add(murk_data *data, const murk_view_sections *sections)
{
    double(*line)[4] = malloc(LINES_MAX * sizeof *line);
    murk_data_begin(data, "sections", '[');
    for (int i = 0; line && i < MURK_VIEW_SECTIONS; ++i) {
        const murk_plane_cut *cut = &sections->lines[i];
        if (cut->segments > LINES_MAX) {
            qsort(cut->segment, cut->segments, sizeof *cut->segment, by_length);
        }
        const size_t n = fill_lines(line, cut, &sections->box, AXES[i]);
        murk_data_begin(data, NULL, '{');
        murk_data_number(data, "axis", AXES[i][0]);
        murk_data_number(data, "at_m",
                         murk_component(sections->cut, AXES[i][0]));
        murk_data_number(
            data, "asked",
            (double)(cut->segments + cut->circles * (size_t)CIRCLE_SIDES));
        murk_data_number(data, "count", (double)n);
        murk_data_floats(data, "lines", &line[0][0], 4 * n);
        murk_data_end(data, '}');
    }
    murk_data_end(data, ']');
    free(line);
}
