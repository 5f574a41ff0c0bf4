/* Light between surfaces: view factors of a box's faces, the integrating
 * sphere, and a closed room in which every place is as bright as any other.
 *
 * Black box: of light that the floor sends out by cosine law the ceiling and
 * the walls take the view factors of parallel rectangles and of rectangles with
 * a common edge (Howell, A Catalog of Radiation Heat Transfer Configuration
 * Factors, C-11 and C-14).
 * Sphere: diffuse walls of reflectance d light each other evenly, so a lamp of
 * 1 W in the middle makes photons hit 1 / (1 - d) times in the mean, and in a
 * ball of radius r about the middle the fluence rate is 3 / (4 pi r^2) of the
 * lamp and 4 d / (A (1 - d)) of the walls of area A.
 * Room: walls that send out M W/m2 and reflect the share d make the fluence
 * rate 4 M / (1 - d) everywhere (Kirchhoff), also among bodies that reflect
 * all light. */
#include "cases/groups.h"
#include "cases/reference.h"
#include "worlds.h"

#define CATALOGUE "Howell, configuration factors C-11, C-14"
#define SPHERE    "integrating sphere, closed form"
#define KIRCHHOFF "Kirchhoff 1860"

/* ---- a black box ---- */

static const murk_vec3 size = {3, 2, 1.5};

enum { CEILING, ACROSS_X, ACROSS_Y, FACES };

/* Directly opposed rectangles of sides x and y in units of their distance. */
static double parallel(double x, double y)
{
    const double x1 = 1 + x * x, y1 = 1 + y * y;
    return 2 / (MURK_PI * x * y) *
           (log(sqrt(x1 * y1 / (x1 + y * y))) +
            x * sqrt(y1) * atan(x / sqrt(y1)) +
            y * sqrt(x1) * atan(y / sqrt(x1)) - x * atan(x) - y * atan(y));
}

/* From a rectangle of width w to one of height h at right angles, both in units
 * of the edge that they share. */
static double perpendicular(double w, double h)
{
    const double w2 = w * w, h2 = h * h, s = w2 + h2, d = sqrt(s);
    return (w * atan(1 / w) + h * atan(1 / h) - d * atan(1 / d) +
            .25 * (log((1 + w2) * (1 + h2) / (1 + s)) +
                   w2 * log(w2 * (1 + s) / ((1 + w2) * s)) +
                   h2 * log(h2 * (1 + s) / ((1 + h2) * s)))) /
           (MURK_PI * w);
}

static void score_face(const void *context, const murk_event *before,
                       const murk_event *event, double *out)
{
    (void)context;
    (void)before;
    if (event->kind == MURK_EVENT_SURFACE) {
        const murk_vec3 p = event->position;
        out[p.z > size.z - 1e-6                 ? CEILING
            : p.x < 1e-6 || p.x > size.x - 1e-6 ? ACROSS_X
                                                : ACROSS_Y] += 1;
    }
}

static void black_box(validation *v, const char *is_wrong, double height)
{
    /* A black box whose floor emits by the cosine law. */
    const murk_surface_desc walls =
        test_box(murk_vec(0, 0, 0), murk_vec(size.x, size.y, size.z), 0);
    const murk_source floor = {.type = MURK_SOURCE_RECT,
                               .position = {0, 0, 0},
                               .edge1 = {size.x, 0, 0},
                               .edge2 = {0, size.y, 0},
                               .power_w = {{1}},
                               .where = "floor"};
    test_world w = test_world_made(&(test_setup){
        .domain = {{{-1, -1, -1}, {size.x + 1, size.y + 1, size.z + 1}}, false},
        .lights = &floor,
        .n_lights = 1,
        .surfaces = &walls,
        .n_surfaces = 1});
    /* View factors of the box; a twin has another height. */
    const validation_reference reference[FACES] = {
        {"floor to ceiling", parallel(size.x / height, size.y / height), 1e-9},
        {"floor to two walls across x",
         2 * perpendicular(size.x / size.y, height / size.y), 1e-9},
        {"floor to two walls across y",
         2 * perpendicular(size.y / size.x, height / size.x), 1e-9}};
    validation_trace(v, &(validation_case){.name = "view factors of a box",
                                           .source = CATALOGUE,
                                           .is_wrong = is_wrong,
                                           .world = &w.world,
                                           .reference = reference,
                                           .quantities = FACES,
                                           .score = score_face});
    test_world_unmade(&w);
}

/* ---- the integrating sphere ---- */

#define RADIUS 2.0
#define BALL   .5

static void score_hits(const void *context, const murk_event *before,
                       const murk_event *event, double *out)
{
    (void)context;
    (void)before;
    out[0] += event->kind == MURK_EVENT_SURFACE;
}

static void sphere(validation *v, const char *is_wrong, double diffuse)
{
    /* A white sphere around a point source; a twin has another albedo. */
    const double d = .8;
    const murk_surface_desc wall = test_sphere(murk_vec(0, 0, 0), RADIUS, 0);
    const murk_material white = test_material(diffuse, 0, 0, 0);
    const murk_source lamp = test_point(murk_vec(0, 0, 0));
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-3, -3, -3}, {3, 3, 3}}, false},
                      .lights = &lamp,
                      .n_lights = 1,
                      .surfaces = &wall,
                      .n_surfaces = 1,
                      .materials = &white,
                      .n_materials = 1});
    /* Hits of a photon, and the fluence rate in a small ball in the middle. */
    const murk_tally_desc ball = {
        .name = "ball", .type = MURK_TALLY_SPHERE, .radius_m = BALL};
    const validation_cell cell = {0, 0, 0};
    const double area = 4 * MURK_PI * RADIUS * RADIUS;
    const validation_reference reference[2] = {
        {"hits of a photon", 1 / (1 - d), 1e-9},
        {"fluence rate in the middle",
         3 / (4 * MURK_PI * BALL * BALL) + 4 * d / (area * (1 - d)), 1e-9}};
    validation_trace(v, &(validation_case){.name = "integrating sphere",
                                           .source = SPHERE,
                                           .is_wrong = is_wrong,
                                           .world = &w.world,
                                           .reference = reference,
                                           .quantities = 2,
                                           .score = score_hits,
                                           .tally = &ball,
                                           .tallies = 1,
                                           .cell = &cell,
                                           .cells = 1});
    test_world_unmade(&w);
}

/* ---- a room of one brightness ---- */

#define REFLECTED .6

static void furnished_enclosure(validation *v, const char *is_wrong,
                                double absorbed)
{
    const murk_box walls = {{0, 0, 0}, {4, 3, 2}};
    murk_source lamp[TEST_WALLS];
    test_wall_lamps(&walls, lamp);
    const murk_material materials[3] = {test_material(REFLECTED, 0, 0, 0),
                                        test_material(1 - absorbed, 0, 0, 0),
                                        test_material(0, 1 - absorbed, 0, 0)};
    const murk_surface_desc surfaces[3] = {
        test_box(walls.min, walls.max, 0),
        test_box(murk_vec(.5, .5, .3), murk_vec(1.7, 1.2, 1.4), 1),
        test_sphere(murk_vec(3, 1, .9), .6, 2)};
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-1, -1, -1}, {5, 4, 3}}, false},
                      .lights = lamp,
                      .n_lights = TEST_WALLS,
                      .surfaces = surfaces,
                      .n_surfaces = 3,
                      .materials = materials,
                      .n_materials = 3});
    const murk_tally_desc balls[2] = {{.name = "among",
                                       .type = MURK_TALLY_SPHERE,
                                       .center = {2.1, 1.4, .9},
                                       .radius_m = .3},
                                      {.name = "behind",
                                       .type = MURK_TALLY_SPHERE,
                                       .center = {.6, 2.2, .5},
                                       .radius_m = .4}};
    const validation_cell cells[2] = {{0, 0, 0}, {1, 0, 0}};
    const double want = 4. / 52 / (1 - REFLECTED); /* 1 W from 52 m2 */
    const validation_reference reference[2] = {
        {"fluence rate between box and sphere", want, 1e-9},
        {"fluence rate behind the box", want, 1e-9}};
    validation_trace(v, &(validation_case){.name = "furnished room",
                                           .source = KIRCHHOFF,
                                           .is_wrong = is_wrong,
                                           .world = &w.world,
                                           .reference = reference,
                                           .quantities = 2,
                                           .tally = balls,
                                           .tallies = 2,
                                           .cell = cells,
                                           .cells = 2});
    test_world_unmade(&w);
}

void cases_enclosures(validation *v)
{
    black_box(v, NULL, size.z);
    sphere(v, NULL, .8);
    furnished_enclosure(v, NULL, 0);
    black_box(v, "height 1.55 m for 1.5", 1.55);
    sphere(v, "reflectance .81 for .8", .81);
    furnished_enclosure(v, "furniture that keeps 3 %", .03);
}
