/* Draws the sheet of murk check: three sections (overview/section_view.h) at
 * the places of overview/section_layout.h, everything of the scene that is no
 * surface, axes, and a legend that lists what is there. */
#include "overview/section_picture.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/source_type.h"
#include "overview/section_layout.h"
#include "overview/section_overlay.h"
#include "scene/places.h"
#include "world/section_cut.h"

/* Widths of lines at unit 1 [pixels]. */
#define CUT_WIDTH   2.6
#define FRAME_WIDTH 1.0

/* A number of an axis has at least so much space [pixels at unit 1]. */
#define TICK_SPACE 64.0

/* Lines of a legend that lists everything. */
#define LINES_MAX 24

static const murk_ink TEXT_INK = {{30, 30, 30}, 1};
static const murk_ink QUIET_INK = {{95, 95, 95}, 1};

typedef struct legend_line {
    murk_section_symbol symbol;
    char text[128];
} legend_line;

typedef struct legend {
    legend_line line[LINES_MAX];
    size_t lines;
} legend;

/* ---- numbers ---- */

/* Prints a coordinate with the decimals that its step needs. */
static void show_step(char *out, size_t size, double value, double step)
{
    const int decimals = (int)fmax(0, -floor(log10(step) + 1e-9));
    snprintf(out, size, "%.*f", decimals,
             fabs(value) < step / 1000 ? 0 : value);
}

/* A coordinate of a plane, in the coordinates of the user. */
static void show_cut(char *out, size_t size, const murk_section_request *r,
                     int axis)
{
    const murk_vec3 user = murk_scene_user(r->stage->scene, r->cut);
    snprintf(out, size, "%c = %.*g m", "xyz"[axis],
             murk_coordinate_digits(r->stage->scene, 5),
             murk_component(user, axis));
}

/* ---- the legend ---- */

__attribute__((format(printf, 3, 4))) static void
list(legend *l, murk_section_symbol symbol, const char *format, ...)
{
    va_list args;
    legend_line *line = &l->line[l->lines++];
    line->symbol = symbol;
    va_start(args, format);
    vsnprintf(line->text, sizeof line->text, format, args);
    va_end(args);
}

static const char *plural(size_t n)
{
    return n == 1 ? "" : "s";
}

static void list_surfaces(legend *l, const murk_section_request *r)
{
    const murk_surfaces_facts facts =
        murk_surfaces_describe(r->stage->surfaces);
    if (facts.triangles + facts.spheres == 0) {
        list(l, MURK_SYMBOL_NONE, "no surfaces");
        return;
    }
    list(l, MURK_SYMBOL_WALL, "surface in the cut");
    if (facts.sheets > 0) {
        list(l, MURK_SYMBOL_SHEET, "transmitting sheet in the cut");
    }
    if (facts.solids > 0) {
        list(l, MURK_SYMBOL_SOLID, "refracting solid in the cut");
    }
    list(l, MURK_SYMBOL_BEYOND, "surface beyond the cut");
}

static void list_media(legend *l, const murk_section_request *r,
                       double max_per_m)
{
    const murk_scene_desc *scene = r->stage->scene;
    bool has_bounds = false;
    for (size_t i = 0; i < scene->n_regions; ++i) {
        has_bounds |= scene->regions[i].shape != MURK_REGION_EVERYWHERE;
    }
    if (max_per_m > 0) {
        list(l, MURK_SYMBOL_MEDIUM,
             "extinction in the cut, up to %.3g /m at %.5g nm", max_per_m,
             scene->band_nm[0]);
    } else if (scene->n_regions > 0) {
        list(l, MURK_SYMBOL_NONE, "no medium in the cuts");
    }
    if (has_bounds) {
        list(l, MURK_SYMBOL_REGION, "bounds of a medium");
    }
}

static void list_lights(legend *l, const murk_section_request *r)
{
    const murk_scene_desc *scene = r->stage->scene;
    size_t lamps = 0, off = 0, distant = 0;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_scene_light *light = &scene->lights[i];
        if (!murk_scene_light_is_distant(light)) {
            ++lamps;
            off += !r->stage->sky[i].is_on;
        } else if (r->stage->sky[i].is_on) {
            distant += murk_source_type_group(light->type) != MURK_SOURCE_DOME;
        }
    }
    if (lamps > 0) {
        list(l, MURK_SYMBOL_LAMP, "%zu lamp%s%s", lamps, plural(lamps),
             off > 0 ? ", hollow: off now" : "");
    }
    if (distant > 0) {
        list(l, MURK_SYMBOL_SUN, "direction of sun, moon, parallel light");
    }
    /* Skies have no direction. */
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_source_type type = scene->lights[i].type;
        if (murk_source_type_group(type) == MURK_SOURCE_DOME) {
            list(l, MURK_SYMBOL_NONE, "light from the sky%s",
                 r->stage->sky[i].is_on ? "" : ": none now");
            break;
        }
    }
}

static void list_sensors(legend *l, const murk_section_request *r)
{
    const murk_scene_desc *scene = r->stage->scene;
    const murk_scene_candidates *sites = &scene->sensors.candidates;
    if (r->candidates) {
        list(l, MURK_SYMBOL_CANDIDATE, "%zu usable candidate%s for sensors",
             r->candidates->usable, plural(r->candidates->usable));
    } else {
        list(l, MURK_SYMBOL_NONE,
             scene->sensors.given ? "candidates for sensors: refused"
                                  : "no sensors");
    }
    if (scene->sensors.n_fixed > 0) {
        list(l, MURK_SYMBOL_SENSOR, "%zu fixed sensor%s",
             scene->sensors.n_fixed, plural(scene->sensors.n_fixed));
    }
    if (sites->avoids > 0) {
        list(l, MURK_SYMBOL_AVOID, "zone without sensors");
    }
    if (sites->withins > 0) {
        list(l, MURK_SYMBOL_WITHIN, "zone of sensors");
    }
    if (scene->n_cameras > 0) {
        list(l, MURK_SYMBOL_CAMERA, "camera");
    }
    /* What the sensors are to see. */
    if (r->targets) {
        const size_t n = murk_photon_map_count(r->targets->surface) +
                         murk_photon_map_count(r->targets->volume);
        list(l, MURK_SYMBOL_TARGET, "target%s (%zu)", plural(n), n);
    }
    bool has_interest = false;
    for (size_t i = 0; i < scene->placement.n_interests; ++i) {
        has_interest |=
            scene->placement.interest[i].shape != MURK_REGION_EVERYWHERE;
    }
    if (has_interest) {
        list(l, MURK_SYMBOL_INTEREST, "region of interest");
    }
}

static legend legend_of(const murk_section_request *r, double max_per_m,
                        bool is_part)
{
    const murk_stage *stage = r->stage;
    const murk_vec3 size =
        murk_sub(stage->world.domain.box.max, stage->world.domain.box.min);
    legend l = {.lines = 0};
    list(&l, MURK_SYMBOL_SCALE, "%s", "");
    list(&l, MURK_SYMBOL_NORTH, "north in the plan");
    list_surfaces(&l, r);
    list_media(&l, r, max_per_m);
    list_lights(&l, r);
    list_sensors(&l, r);
    list(&l, MURK_SYMBOL_DOMAIN, "domain, %.6g x %.6g x %.6g m%s%s", size.x,
         size.y, size.z, stage->world.domain.is_periodic ? ", periodic" : "",
         is_part ? ", in part" : "");
    list(&l, MURK_SYMBOL_MARK, "the cuts of the other views");
    if (r->escaped_share > 0) {
        list(&l, MURK_SYMBOL_NONE, "%.3g %% of the light leaves the domain",
             100 * r->escaped_share);
    }
    return l;
}

/* The scale bar, a round length of 70 to 140 pixels at unit 1, which is at most
 * 0.35 of the width of the legend. */
static void draw_scale(murk_canvas *c, const murk_section_layout *l, double x,
                       double y)
{
    const double u = l->unit, scale = l->view[0].scale;
    double length_m = murk_canvas_step(70 * u / scale);
    if (length_m * scale > 140 * u) {
        length_m /= 2;
    }
    const double length = length_m * scale;
    const murk_pen pen = {.ink = TEXT_INK, .width = 1.5 * u};
    const double from[2] = {x, y}, to[2] = {x + length, y};
    const double tick = 5 * u;
    murk_canvas_line(c, from, to, &pen);
    for (int i = 0; i < 2; ++i) {
        const double low[2] = {x + i * length, y - tick};
        const double high[2] = {x + i * length, y + tick};
        murk_canvas_line(c, low, high, &pen);
    }
    char text[48];
    snprintf(text, sizeof text, "%.4g m, one scale for all views", length_m);
    murk_canvas_text(c, x + length + 10 * u, y + 0.35 * l->text, l->text,
                     MURK_TEXT_FROM, TEXT_INK, text);
}

static void draw_legend(murk_canvas *c, const murk_section_layout *l,
                        const murk_section_request *r, const legend *lines)
{
    const double u = l->unit, x = l->legend[0];
    for (size_t i = 0; i < lines->lines; ++i) {
        const legend_line *line = &lines->line[i];
        const double y = l->legend[1] + (22 * (double)i + 11) * u;
        if (line->symbol == MURK_SYMBOL_SCALE) {
            draw_scale(c, l, x, y);
            continue;
        }
        const double middle[2] = {x + 16 * u, y};
        murk_section_draw_symbol(c, line->symbol, middle, u,
                                 r->stage->scene->north);
        murk_canvas_text(c, x + 42 * u, y + 0.35 * l->text, l->text,
                         MURK_TEXT_FROM, TEXT_INK, line->text);
    }
}

/* ---- axes ---- */

/* The step between the numbers of an axis: numbers do not touch. `across`: the
 * numbers stand beside each other. */
static double step_of(murk_canvas *c, const murk_section_layout *l,
                      const murk_section_view *v, const double ends_m[2],
                      bool across)
{
    double step = murk_canvas_step(TICK_SPACE * l->unit / v->scale);
    for (int tries = 0; across && tries < 9; ++tries) {
        double width = 0;
        for (int i = 0; i < 2; ++i) {
            char text[48];
            show_step(text, sizeof text, ends_m[i], step);
            width = fmax(width, murk_canvas_text_width(c, l->text, text));
        }
        if (width + l->text < step * v->scale) {
            break;
        }
        step = murk_canvas_step(1.5 * step);
    }
    return step;
}

static void draw_axis(murk_canvas *c, const murk_section_layout *l,
                      const murk_section_view *v, murk_vec3 origin,
                      bool is_across)
{
    const double u = l->unit, length = is_across ? v->width : v->height;
    const int axis = is_across ? v->right : v->up;
    const double low = v->low[!is_across];
    const double offset = murk_component(origin, axis);
    const double ends_m[2] = {low + offset, low + offset + length / v->scale};
    const double step = step_of(c, l, v, ends_m, is_across);
    const murk_pen pen = {.ink = QUIET_INK, .width = FRAME_WIDTH * u};
    /* Numbers at the multiples of the step. */
    for (double k = ceil(ends_m[0] / step); k * step <= ends_m[1]; ++k) {
        const double along = (k * step - offset - low) * v->scale;
        char text[48];
        show_step(text, sizeof text, k * step, step);
        if (is_across) {
            const double x = v->left + along, y = v->top + v->height;
            const double from[2] = {x, y}, to[2] = {x, y + 5 * u};
            murk_canvas_line(c, from, to, &pen);
            murk_canvas_text(c, x, y + 5 * u + 1.1 * l->text, l->text,
                             MURK_TEXT_MIDDLE, QUIET_INK, text);
        } else {
            const double y = v->top + v->height - along;
            const double from[2] = {v->left - 5 * u, y}, to[2] = {v->left, y};
            murk_canvas_line(c, from, to, &pen);
            murk_canvas_text(c, v->left - 9 * u, y + 0.35 * l->text, l->text,
                             MURK_TEXT_TO, QUIET_INK, text);
        }
    }
    /* The name of the axis, at the end. */
    char name[16];
    snprintf(name, sizeof name, "%c [m]", "xyz"[axis]);
    if (is_across) {
        murk_canvas_text(c, v->left + v->width,
                         v->top + v->height + 5 * u + 2.2 * l->text, l->text,
                         MURK_TEXT_TO, TEXT_INK, name);
    } else {
        murk_canvas_text(c, v->left - 9 * u, v->top - 0.45 * l->text, l->text,
                         MURK_TEXT_TO, TEXT_INK, name);
    }
}

/* ---- the views ---- */

/* The plane of another view as a line, with its letter at the end. */
static void draw_mark(murk_canvas *c, const murk_section_layout *l,
                      const murk_section_view *v, const murk_section_view *of,
                      const char *letter)
{
    const double u = l->unit;
    const murk_pen pen = {
        .ink = MURK_SECTION_MARK, .width = 1.2 * u, .dash = {14 * u, 5 * u}};
    murk_vec3 place = {0, 0, 0};
    murk_component_set(&place, of->along, of->cut_m);
    double at[2];
    murk_section_find(v, place, at);
    if (of->along == v->right) {
        const double from[2] = {at[0], v->top};
        const double to[2] = {at[0], v->top + v->height};
        murk_canvas_line(c, from, to, &pen);
        murk_section_draw_label(c, at[0] + 5 * u, v->top + 1.1 * l->text, u,
                                MURK_SECTION_MARK, letter);
    } else {
        const double from[2] = {v->left, at[1]};
        const double to[2] = {v->left + v->width, at[1]};
        murk_canvas_line(c, from, to, &pen);
        murk_section_draw_label(c, v->left + v->width - 16 * u, at[1] - 5 * u,
                                u, MURK_SECTION_MARK, letter);
    }
}

static murk_status draw_view(murk_canvas *c, const murk_section_layout *l,
                             const murk_section_request *r, int number,
                             const murk_section_pixels *pixels,
                             double max_per_m, murk_error *err)
{
    static const char *const letters[MURK_SECTIONS] = {"C", "A", "B"};
    static const char *const titles[MURK_SECTIONS] = {
        "Plan, looking down", "Front, along +y", "Side, along \xe2\x88\x92x"};
    const murk_section_view *v = &l->view[number];
    const double u = l->unit;
    murk_canvas_clip(c, v->left, v->top, v->width, v->height);
    murk_section_draw_beyond(c, v, pixels, max_per_m);
    murk_section_draw_bounds(c, v, r, u);
    murk_status status =
        murk_section_draw_cut(c, v, r->stage, CUT_WIDTH * u, err);
    murk_section_draw_items(c, v, r, u);
    for (int k = 0; k < MURK_SECTIONS; ++k) {
        if (k != number) {
            draw_mark(c, l, v, &l->view[k], letters[k]);
        }
    }
    /* The frame, its title and its axes. */
    murk_canvas_clip_nothing(c);
    const murk_pen frame = {.ink = QUIET_INK, .width = FRAME_WIDTH * u};
    murk_canvas_rectangle(c, v->left, v->top, v->width, v->height, &frame);
    char cut[64], title[128];
    show_cut(cut, sizeof cut, r, v->along);
    snprintf(title, sizeof title, "%s: cut %s at %s", titles[number],
             letters[number], cut);
    murk_canvas_text(c, v->left, v->top - 9 * u, l->text, MURK_TEXT_FROM,
                     TEXT_INK, title);
    draw_axis(c, l, v, r->stage->scene->origin, true);
    draw_axis(c, l, v, r->stage->scene->origin, false);
    return status;
}

static void draw_title(murk_canvas *c, const murk_section_layout *l,
                       const murk_section_request *r)
{
    const double u = l->unit;
    const char *path = r->stage->scene->path;
    const char *slash = strrchr(path, '/');
    murk_canvas_text(c, 16 * u, 36 * u, 1.5 * l->text, MURK_TEXT_FROM, TEXT_INK,
                     slash ? slash + 1 : path);
}

static murk_status check_cut(const murk_section_request *r, murk_error *err)
{
    const murk_box *box = &r->stage->world.domain.box;
    const murk_scene_desc *scene = r->stage->scene;
    const murk_box user = murk_scene_user_box(scene, *box);
    const murk_vec3 asked = murk_scene_user(scene, r->cut);
    for (int k = 0; k < 3; ++k) {
        const double at = murk_component(r->cut, k);
        const double low = murk_component(box->min, k);
        const double high = murk_component(box->max, k);
        if (!(at >= low && at <= high)) {
            return murk_fail(err, MURK_BAD_VALUE, "cut_m",
                             "%c is %.9g m, must be within the domain, "
                             "%.9g..%.9g m",
                             "xyz"[k], murk_component(asked, k),
                             murk_component(user.min, k),
                             murk_component(user.max, k));
        }
    }
    return MURK_OK;
}

murk_status murk_section_picture_draw(murk_canvas **out,
                                      murk_section_request *r, murk_error *err)
{
    if (!r->has_cut) {
        const murk_candidates *c = r->candidates;
        r->cut = murk_stage_section_cut(r->stage, c ? c->position : NULL,
                                        c ? c->usable : 0);
    }
    murk_status status = check_cut(r, err);
    if (status) {
        return status;
    }
    /* The largest number of lines of the legend: extinctions are not known
     * yet. */
    const size_t lines = legend_of(r, 1, false).lines;
    const murk_section_layout l = murk_section_layout_make(r, lines);
    murk_section_pixels pixels[MURK_SECTIONS] = {{0}};
    murk_canvas *canvas = NULL;
    double max_per_m = 0;
    memcpy(r->view, l.view, sizeof r->view);
    status = murk_canvas_create(&canvas, l.width, l.height, err);
    for (int i = 0; i < MURK_SECTIONS && !status; ++i) {
        status = murk_section_sample(&pixels[i], &l.view[i], r->stage,
                                     r->threads, err);
        max_per_m = fmax(max_per_m, pixels[i].extinction_max_per_m);
    }
    if (!status) {
        const legend lines_of = legend_of(r, max_per_m, l.is_part);
        draw_title(canvas, &l, r);
        draw_legend(canvas, &l, r, &lines_of);
    }
    for (int i = 0; i < MURK_SECTIONS && !status; ++i) {
        status = draw_view(canvas, &l, r, i, &pixels[i], max_per_m, err);
    }
    for (int i = 0; i < MURK_SECTIONS; ++i) {
        murk_section_release(&pixels[i]);
    }
    if (status) {
        murk_canvas_destroy(canvas);
        return status;
    }
    *out = canvas;
    return MURK_OK;
}
