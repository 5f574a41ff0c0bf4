/* Draws what is no surface into a view of the picture of murk check. Every kind
 * of thing has one pen or one mark, which the legend shows as well. */
#include "overview/section_overlay.h"

#include <stdio.h>

#include "sensing/sensor.h"
#include "world/extent.h"

/* The largest number of points that are drawn, evenly chosen: more would run
 * together. */
#define POINTS_MAX 20000

/* Sizes at unit 1 [pixels]. */
#define TEXT       14.0
#define CANDIDATE  1.7 /* radius */
#define TARGET     1.3
#define LAMP       6.0
#define SENSOR     6.0
#define ARROW      44.0
#define ARROW_HEAD 7.0
#define CAMERA     6.0

/* Regions whose media are named; more names would cover the view. */
#define NAMES_MAX 8

/* Projected lengths of a unit direction below this are shown as a point. */
#define HEAD_ON 0.15

static const murk_ink AMBER = {{255, 190, 0}, 1};
static const murk_ink BROWN = {{120, 80, 0}, 1};
static const murk_ink WHITE = {{255, 255, 255}, 1};
static const murk_ink GREEN = {{0, 120, 80}, 0.75};
static const murk_ink PURPLE = {{130, 40, 160}, 0.8};
static const murk_ink RED = {{200, 40, 20}, 1};
static const murk_ink INK = {{30, 30, 30}, 1};

/* ---- pens and marks ---- */

/* The pen of the bounds of one kind of thing. */
static murk_pen pen_of(murk_section_symbol symbol, double u)
{
    switch (symbol) {
    case MURK_SYMBOL_REGION:
        return (murk_pen){MURK_SECTION_MEDIUM, 1.4 * u, {7 * u, 4 * u}};
    case MURK_SYMBOL_DOMAIN:
        return (murk_pen){MURK_SECTION_DOMAIN, 1.4 * u, {3 * u, 3 * u}};
    case MURK_SYMBOL_AVOID:
        return (murk_pen){RED, 1.4 * u, {7 * u, 4 * u}};
    case MURK_SYMBOL_WITHIN:
        return (murk_pen){GREEN, 1.4 * u, {7 * u, 4 * u}};
    case MURK_SYMBOL_INTEREST:
        return (murk_pen){PURPLE, 1.4 * u, {7 * u, 4 * u}};
    case MURK_SYMBOL_MARK:
        return (murk_pen){MURK_SECTION_MARK, 1.2 * u, {14 * u, 5 * u}};
    case MURK_SYMBOL_SHEET:
        return (murk_pen){MURK_SECTION_SHEET, 2.6 * u, {0, 0}};
    case MURK_SYMBOL_SOLID:
        return (murk_pen){MURK_SECTION_SOLID, 2.6 * u, {0, 0}};
    default:
        return (murk_pen){MURK_SECTION_WALL, 2.6 * u, {0, 0}};
    }
}

static void draw_lamp(murk_canvas *c, const double at[2], double u, bool is_on)
{
    const murk_pen rim = {BROWN, 1.4 * u, {0, 0}};
    murk_canvas_disc(c, at, LAMP * u, is_on ? AMBER : WHITE);
    murk_canvas_circle(c, at, LAMP * u, &rim);
}

/* An arrow whose point is at `to`; `toward` is the direction in the picture. */
static void draw_arrow(murk_canvas *c, const double to[2],
                       const double toward[2], double length, double u,
                       murk_ink ink)
{
    const murk_pen pen = {ink, 2.2 * u, {0, 0}};
    const double head = fmin(ARROW_HEAD * u, length);
    const double from[2] = {to[0] - length * toward[0],
                            to[1] - length * toward[1]};
    const double neck[2] = {to[0] - head * toward[0], to[1] - head * toward[1]};
    const double corner[3][2] = {
        {to[0], to[1]},
        {neck[0] - 0.6 * head * toward[1], neck[1] + 0.6 * head * toward[0]},
        {neck[0] + 0.6 * head * toward[1], neck[1] - 0.6 * head * toward[0]}};
    murk_canvas_line(c, from, neck, &pen);
    murk_canvas_polygon(c, corner, 3, ink);
}

/* A triangle that points along `toward`; if toward is short, a disc. */
static void draw_sensor(murk_canvas *c, const double at[2],
                        const double toward[2], double u)
{
    const double length = hypot(toward[0], toward[1]), size = SENSOR * u;
    if (!(length > HEAD_ON)) {
        murk_canvas_disc(c, at, 0.8 * size, RED);
        return;
    }
    const double x = toward[0] / length, y = toward[1] / length;
    const double corner[3][2] = {
        {at[0] + 1.5 * size * x, at[1] + 1.5 * size * y},
        {at[0] - size * (x + y), at[1] - size * (y - x)},
        {at[0] - size * (x - y), at[1] - size * (y + x)}};
    murk_canvas_polygon(c, corner, 3, RED);
}

static void draw_camera(murk_canvas *c, const double at[2], double u)
{
    const murk_pen pen = {INK, 1.4 * u, {0, 0}};
    const double size = CAMERA * u;
    murk_canvas_fill(c, at[0] - size, at[1] - size, 2 * size, 2 * size, WHITE);
    murk_canvas_rectangle(c, at[0] - size, at[1] - size, 2 * size, 2 * size,
                          &pen);
}

void murk_section_draw_label(murk_canvas *c, double x, double y, double u,
                             murk_ink ink, const char *text)
{
    const murk_ink paper = {{255, 255, 255}, 0.75};
    const double size = TEXT * u;
    const double width = murk_canvas_text_width(c, size, text);
    murk_canvas_fill(c, x - 2 * u, y - 0.85 * size, width + 4 * u, 1.1 * size,
                     paper);
    murk_canvas_text(c, x, y, size, MURK_TEXT_FROM, ink, text);
}

/* A short name, so that labels stay within the view. */
static void show_name(char *out, size_t size, const char *name)
{
    snprintf(out, size, "%.24s", name);
}

void murk_section_draw_symbol(murk_canvas *c, murk_section_symbol symbol,
                              const double at[2], double u, murk_vec3 north)
{
    murk_ink tint = MURK_SECTION_MEDIUM;
    const murk_ink grey = {{225, 225, 225}, 1};
    const double left[2] = {at[0] - 15 * u, at[1]};
    const double right[2] = {at[0] + 15 * u, at[1]};
    const double along[2] = {1, 0};
    const double up[2] = {north.x, -north.y};
    const double tip[2] = {at[0] + 10 * u * up[0], at[1] + 10 * u * up[1]};
    const murk_pen pen = pen_of(symbol, u);
    tint.opacity = MURK_SECTION_TINT_MAX;
    /* Arrows, areas and marks; all others are pieces of line. */
    switch (symbol) {
    case MURK_SYMBOL_NONE:
    case MURK_SYMBOL_SCALE:
        break;
    case MURK_SYMBOL_NORTH:
        draw_arrow(c, tip, up, 20 * u, u, INK);
        break;
    case MURK_SYMBOL_BEYOND:
        murk_canvas_fill(c, left[0], at[1] - 6 * u, 30 * u, 12 * u, grey);
        break;
    case MURK_SYMBOL_MEDIUM:
        murk_canvas_fill(c, left[0], at[1] - 6 * u, 30 * u, 12 * u, tint);
        break;
    case MURK_SYMBOL_LAMP:
        draw_lamp(c, at, u, true);
        break;
    case MURK_SYMBOL_SUN:
        draw_arrow(c, right, along, 30 * u, u, BROWN);
        break;
    case MURK_SYMBOL_CANDIDATE:
        murk_canvas_disc(c, at, CANDIDATE * u, GREEN);
        break;
    case MURK_SYMBOL_TARGET:
        murk_canvas_disc(c, at, TARGET * u, PURPLE);
        break;
    case MURK_SYMBOL_SENSOR:
        draw_sensor(c, at, along, u);
        break;
    case MURK_SYMBOL_CAMERA:
        draw_camera(c, at, u);
        break;
    case MURK_SYMBOL_WALL:
    case MURK_SYMBOL_SHEET:
    case MURK_SYMBOL_SOLID:
    case MURK_SYMBOL_REGION:
    case MURK_SYMBOL_DOMAIN:
    case MURK_SYMBOL_AVOID:
    case MURK_SYMBOL_WITHIN:
    case MURK_SYMBOL_INTEREST:
    case MURK_SYMBOL_MARK:
        murk_canvas_line(c, left, right, &pen);
        break;
    }
}

/* ---- bounds ---- */

/* The outline of a shape: of a mesh its bounding box. */
static void draw_solid(murk_canvas *c, const murk_section_view *v,
                       murk_region_shape shape, const murk_scene_solid *solid,
                       const murk_mesh *mesh, const murk_pen *pen)
{
    const murk_affine placed = murk_scene_placed(solid);
    if (shape == MURK_REGION_BOX) {
        murk_section_draw_box(c, v, &solid->box, &placed, pen);
    } else if (shape == MURK_REGION_SPHERE) {
        murk_section_draw_ball(c, v, murk_affine_point(&placed, solid->center),
                               solid->radius_m * solid->scale, pen);
    } else if (shape == MURK_REGION_MESH && mesh) {
        murk_section_draw_box(c, v, &mesh->bounds_m, &placed, pen);
    }
}

/* The bounding box of a region; of an unbounded region the part in the
 * domain. */
static murk_box region_box(const murk_stage *stage, size_t i)
{
    const murk_scene_region *r = &stage->scene->regions[i];
    murk_box box = stage->world.domain.box;
    if (murk_extent_is_bounded(r)) {
        return murk_extent_region(stage->scene, r, stage->grid[r->medium],
                                  stage->region_mesh[i]);
    }
    if (r->shape == MURK_REGION_BELOW) {
        box.max.z = r->below_z_m;
    }
    return box;
}

static void draw_region(murk_canvas *c, const murk_section_view *v,
                        const murk_stage *stage, size_t i, double u)
{
    const murk_scene_region *r = &stage->scene->regions[i];
    const murk_pen pen = pen_of(MURK_SYMBOL_REGION, u);
    if (r->shape == MURK_REGION_BOX || r->shape == MURK_REGION_SPHERE) {
        draw_solid(c, v, r->shape, &r->solid, NULL, &pen);
    } else if (r->shape != MURK_REGION_EVERYWHERE) {
        const murk_box box = region_box(stage, i);
        murk_section_draw_box(c, v, &box, NULL, &pen);
    }
}

/* Draws the name of the medium of region i at the upper left corner of the
 * region's bounding box in the view; a side of the box that lies left of or
 * above the view is replaced by the edge of the view. For each earlier region
 * whose corner is nearer than 60 u sideways and 16 u upwards or downwards the
 * name moves down by one line (18 u). */
static void draw_medium_name(murk_canvas *c, const murk_section_view *v,
                             const murk_stage *stage, size_t i, double u)
{
    const murk_scene_desc *scene = stage->scene;
    const murk_box box = region_box(stage, i);
    double at[2], other[2];
    char name[32];
    murk_section_find(v, box.min, at);
    murk_section_find(v, box.max, other);
    const double left = fmax(fmin(at[0], other[0]), v->left);
    const double top = fmax(fmin(at[1], other[1]), v->top);
    size_t above = 0;
    for (size_t k = 0; k < i; ++k) {
        const murk_box before = region_box(stage, k);
        murk_section_find(v, before.min, at);
        murk_section_find(v, before.max, other);
        above += fabs(fmax(fmin(at[0], other[0]), v->left) - left) < 60 * u &&
                 fabs(fmax(fmin(at[1], other[1]), v->top) - top) < 16 * u;
    }
    show_name(name, sizeof name, scene->media[scene->regions[i].medium].name);
    murk_section_draw_label(c, left + 6 * u,
                            top + (18 + 18 * (double)above) * u, u, INK, name);
}

void murk_section_draw_bounds(murk_canvas *c, const murk_section_view *v,
                              const murk_section_request *request, double u)
{
    const murk_stage *stage = request->stage;
    const murk_scene_desc *scene = stage->scene;
    const murk_scene_candidates *sites = &scene->sensors.candidates;
    murk_pen pen = pen_of(MURK_SYMBOL_DOMAIN, u);
    murk_section_draw_box(c, v, &stage->world.domain.box, NULL, &pen);
    for (size_t i = 0; i < scene->n_regions; ++i) {
        draw_region(c, v, stage, i, u);
    }
    /* Zones: those to avoid come first, as in stage->zone_mesh. */
    for (size_t i = 0; i < sites->avoids + sites->withins; ++i) {
        const bool is_avoided = i < sites->avoids;
        const murk_scene_site_zone *zone =
            is_avoided ? &sites->avoid[i] : &sites->within[i - sites->avoids];
        pen = pen_of(is_avoided ? MURK_SYMBOL_AVOID : MURK_SYMBOL_WITHIN, u);
        draw_solid(c, v, zone->shape, &zone->solid,
                   stage->zone_mesh ? stage->zone_mesh[i] : NULL, &pen);
    }
    pen = pen_of(MURK_SYMBOL_INTEREST, u);
    for (size_t i = 0; i < scene->placement.n_interests; ++i) {
        const murk_scene_interest *one = &scene->placement.interest[i];
        draw_solid(c, v, one->shape, &one->solid,
                   stage->goal_mesh ? stage->goal_mesh[i] : NULL, &pen);
    }
}

/* ---- light sources ---- */

/* The direction in which distant light travels. */
static murk_vec3 travel_of(const murk_stage *stage, size_t i)
{
    const murk_scene_light *light = &stage->scene->lights[i];
    if (light->type == MURK_SOURCE_DIRECTIONAL) {
        return murk_unit(light->direction);
    }
    const double azimuth = stage->sky[i].azimuth_deg * MURK_PI / 180;
    const double elevation = stage->sky[i].elevation_deg * MURK_PI / 180;
    const murk_vec3 north = stage->scene->north;
    const murk_vec3 east = murk_cross(north, murk_vec(0, 0, 1));
    murk_vec3 to = murk_scale(cos(azimuth), north);
    to = murk_along(to, sin(azimuth), east);
    to = murk_along(murk_scale(cos(elevation), to), sin(elevation),
                    murk_vec(0, 0, 1));
    return murk_scale(-1, to);
}

/* An arrow in the upper right corner, below the letter of the cut; more than
 * one stand beside each other. */
static void draw_distant(murk_canvas *c, const murk_section_view *v,
                         const murk_stage *stage, size_t i, size_t number,
                         double u)
{
    double toward[2];
    murk_section_direction(v, travel_of(stage, i), toward);
    const double length = hypot(toward[0], toward[1]);
    const double middle[2] = {
        v->left + v->width - (36 + 84 * (double)number) * u, v->top + 40 * u};
    if (length > HEAD_ON) {
        const double unit[2] = {toward[0] / length, toward[1] / length};
        const double half = ARROW * u * length / 2;
        const double tip[2] = {middle[0] + half * unit[0],
                               middle[1] + half * unit[1]};
        draw_arrow(c, tip, unit, 2 * half, u, BROWN);
    } else {
        draw_lamp(c, middle, u, true);
    }
    const char *name = murk_source_type_name(stage->scene->lights[i].type);
    const double width = murk_canvas_text_width(c, TEXT * u, name);
    const double end = v->left + v->width - 4 * u;
    /* The name, where the view has room for it. */
    if (v->width > width + 8 * u && v->height > 90 * u) {
        murk_section_draw_label(c, fmin(middle[0] - width / 2, end - width),
                                middle[1] + 38 * u, u, INK, name);
    }
}

static void draw_light(murk_canvas *c, const murk_section_view *v,
                       const murk_stage *stage, size_t i, double u)
{
    const murk_scene_light *light = &stage->scene->lights[i];
    const bool is_on = stage->sky[i].is_on;
    const murk_pen pen = {AMBER, 3 * u, {0, 0}};
    double at[2];
    murk_vec3 middle = light->position;
    if (light->type == MURK_SOURCE_RECT) {
        /* The rectangle itself, and the mark in the middle. */
        const murk_vec3 corner[4] = {
            light->position, murk_add(light->position, light->edge1),
            murk_add(murk_add(light->position, light->edge1), light->edge2),
            murk_add(light->position, light->edge2)};
        for (int k = 0; k < 4; ++k) {
            double from[2], to[2];
            murk_section_find(v, corner[k], from);
            murk_section_find(v, corner[(k + 1) % 4], to);
            murk_canvas_line(c, from, to, &pen);
        }
        middle = murk_scale(0.5, murk_add(corner[0], corner[2]));
    }
    murk_section_find(v, middle, at);
    if (light->type == MURK_SOURCE_BEAM ||
        light->type == MURK_SOURCE_LUMINAIRE) {
        double toward[2];
        murk_section_direction(v, murk_unit(light->direction), toward);
        const double length = hypot(toward[0], toward[1]);
        if (length > HEAD_ON) {
            const double unit[2] = {toward[0] / length, toward[1] / length};
            const double tip[2] = {at[0] + ARROW * u * toward[0],
                                   at[1] + ARROW * u * toward[1]};
            draw_arrow(c, tip, unit, ARROW * u * length, u, BROWN);
        }
    }
    draw_lamp(c, at, u, is_on);
}

/* ---- sensors, cameras, targets ---- */

static void draw_targets(murk_canvas *c, const murk_section_view *v,
                         const murk_photon_map *map, double u)
{
    const size_t n = murk_photon_map_count(map);
    const size_t step = n / POINTS_MAX + 1;
    for (size_t i = 0; i < n; i += step) {
        double at[2];
        murk_section_find(
            v, murk_photon_place(&murk_photon_map_photons(map)[i]), at);
        murk_canvas_disc(c, at, TARGET * u, PURPLE);
    }
}

static void draw_candidates(murk_canvas *c, const murk_section_view *v,
                            const murk_candidates *candidates, double u)
{
    const size_t step = candidates->usable / POINTS_MAX + 1;
    for (size_t i = 0; i < candidates->usable; i += step) {
        double at[2];
        murk_section_find(v, candidates->position[i], at);
        murk_canvas_disc(c, at, CANDIDATE * u, GREEN);
    }
}

static void draw_fixed(murk_canvas *c, const murk_section_view *v,
                       const murk_scene_desc *scene, size_t i, double u)
{
    const murk_scene_fixed_sensor *s = &scene->sensors.fixed[i];
    const bool has_view = scene->sensors.type[s->type].view != MURK_VIEW_SPHERE;
    const murk_pose pose = {.heading_rad = s->heading_rad,
                            .tilt_rad = s->tilt_rad};
    double at[2], shown[2] = {0, 0};
    char number[24];
    murk_section_find(v, s->position, at);
    if (has_view) {
        murk_section_direction(v, murk_pose_frame(&pose, scene->north).axis,
                               shown);
    }
    draw_sensor(c, at, shown, u);
    snprintf(number, sizeof number, "%zu", i + 1);
    murk_section_draw_label(c, at[0] + 9 * u, at[1] - 7 * u, u, INK, number);
}

static void draw_scene_camera(murk_canvas *c, const murk_section_view *v,
                              const murk_scene_camera *camera, double u)
{
    double at[2], toward[2];
    char name[32];
    murk_section_find(v, camera->from, at);
    if (camera->has_to) {
        murk_section_direction(v, murk_unit(murk_sub(camera->to, camera->from)),
                               toward);
        const double length = hypot(toward[0], toward[1]);
        if (length > HEAD_ON) {
            const double unit[2] = {toward[0] / length, toward[1] / length};
            const double tip[2] = {at[0] + ARROW * u * toward[0],
                                   at[1] + ARROW * u * toward[1]};
            draw_arrow(c, tip, unit, ARROW * u * length, u, INK);
        }
    }
    draw_camera(c, at, u);
    show_name(name, sizeof name, camera->name);
    murk_section_draw_label(c, at[0] - CAMERA * u, at[1] + 22 * u, u, INK,
                            name);
}

void murk_section_draw_items(murk_canvas *c, const murk_section_view *v,
                             const murk_section_request *r, double u)
{
    const murk_stage *stage = r->stage;
    const murk_scene_desc *scene = stage->scene;
    if (r->targets) {
        draw_targets(c, v, r->targets->surface, u);
        draw_targets(c, v, r->targets->volume, u);
    }
    if (r->candidates) {
        draw_candidates(c, v, r->candidates, u);
    }
    /* Light sources: lamps at their places, others by their directions. */
    size_t distant = 0;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_source_group group =
            murk_source_type_group(scene->lights[i].type);
        if (group == MURK_SOURCE_LAMP) {
            draw_light(c, v, stage, i, u);
        } else if (group != MURK_SOURCE_DOME && stage->sky[i].is_on) {
            draw_distant(c, v, stage, i, distant++, u);
        }
    }
    for (size_t i = 0; i < scene->n_cameras; ++i) {
        draw_scene_camera(c, v, &scene->cameras[i], u);
    }
    for (size_t i = 0; i < scene->sensors.n_fixed; ++i) {
        draw_fixed(c, v, scene, i, u);
    }
    for (size_t i = 0; i < scene->n_regions && i < NAMES_MAX; ++i) {
        draw_medium_name(c, v, stage, i, u);
    }
}
