/* Pictures by maps, by maps alone and by paths: one radiance by three methods.
 *
 * Closed rooms have exact solutions: where walls shine and reflect alike and
 * nothing else absorbs, there is one radiance everywhere, n^2 times as much
 * where the index of refraction is n (test_light_in_solids.c says by whom); a
 * hollow ball glows evenly from a lamp in its middle. The mean of each method
 * is within 2 % of these as it stands, noise and all, with 100,000 photons; 4 %
 * more or less is refused.
 *
 * In four scenes without an exact solution, a hall in smoke, a foggy room, a
 * tank of water with a ball of glass above it, and fog under sun and sky, the
 * mean over the picture of maps less paths is less than 2 % of the mean; with
 * 100,000 photons, whose own noise is as large, in excess of what both say of
 * their errors. This is a weak check: the means by paths are the program's own,
 * and the quick form refuses nothing less than 40 % off. It shows that two
 * estimators agree where there are corners, crates, mirrors, glass and a
 * periodic sun. In the room, errors fall with the number of photons, and are no
 * more than they say. Paths agree with paths of another seed, pixel by pixel,
 * and in the room block by block.
 *
 * Quick: 100,000 photons, and the means by paths are told: those of the nightly
 * form, which takes 1,000,000 photons and finds the means again.
 *
 * The z-tests share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "lightmap/lightmap.h"
#include "render/render.h"
#include "stage_text.h"
#include "world/stage_build.h"

#include <stdlib.h>
#include <string.h>

#define WIDTH  32
#define HEIGHT 24
#define PIXELS (WIDTH * HEIGHT)
#define BLOCK  4 /* pixels */
#define BLOCKS (PIXELS / BLOCK / BLOCK)
#define ZTESTS (PIXELS + BLOCKS + 40)

/* Most that maps may be off, as a share of the mean. */
#define BIAS 0.02

static double limit;
static bool is_nightly;

static const char FOGGY_BOX[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: wall}\n"
    "  - {box: {min_m: [2, 1, 0], max_m: [3, 2, 1]}, material: crate}\n"
    "materials:\n"
    "  wall: {diffuse: 0.6}\n"
    "  crate: {diffuse: 0.3}\n"
    "media: {fog: {extinction_per_m: 0.2, albedo: 0.9, phase: {hg: 0.3}}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: sphere, center_m: [1, 3, 2.5], radius_m: 0.2, power_w: 50}\n";

static const char TANK[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}, material: wall}\n"
    "  - {box: {min_m: [2.2, 1, 0], max_m: [3.2, 2, 0.8]}, material: crate}\n"
    "  - {sphere: {center_m: [1.4, 2.4, 1.9], radius_m: 0.35},\n"
    "     material: glass}\n"
    "materials:\n"
    "  wall: {diffuse: 0.5}\n"
    "  crate: {diffuse: 0.3, specular: 0.2}\n"
    "  glass: {transmit: 1, ior: 1.5}\n"
    "media: {water: {extinction_per_m: 0.4, albedo: 0.8, phase: {hg: 0.8}}}\n"
    "regions:\n"
    "  - {medium: water, box: {min_m: [0, 0, 0], max_m: [4, 4, 1.2]},\n"
    "     ior: 1.34}\n"
    "lights:\n"
    "  - {type: rect, corner_m: [0.2, 0.2, 2.99], edge1_m: [0, 3.6, 0],\n"
    "     edge2_m: [3.6, 0, 0], power_w: 50}\n";

static const char FOG[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, -0.1], max_m: [20, 20, 10], sides: periodic}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [0, 0, 0], edge1_m: [20, 0, 0],\n"
    "            edge2_m: [0, 20, 0]}, material: wall}\n"
    "  - {box: {min_m: [8, 8, -0.01], max_m: [11, 11, 3]}, material: wall}\n"
    "materials: {wall: {diffuse: 0.4}}\n"
    "media: {fog: {extinction_per_m: 0.1, albedo: 1, phase: {hg: 0.8}}}\n"
    "regions: [{medium: fog}]\n"
    "site: {latitude_deg: 52, longitude_deg: 5, time_zone: \"+02:00\",\n"
    "       date: 2026-06-21, clock: \"11:00\"}\n"
    "lights:\n"
    "  - {type: sun, irradiance_w_per_m2: 600}\n"
    "  - {type: sky, irradiance_w_per_m2: 150}\n";

/* All walls shine, so that paths have little noise. */
static const char LANTERN[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 4]}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 4]}, material: wall}\n"
    "  - {box: {min_m: [2, 1, 0], max_m: [3, 2, 1]}, material: wall}\n"
    "materials: {wall: {diffuse: 0.3}}\n"
    "lights:\n"
    "  - {type: rect, corner_m: [0, 0, 0], edge1_m: [4, 0, 0],\n"
    "     edge2_m: [0, 4, 0], power_w: 16}\n"
    "  - {type: rect, corner_m: [0, 0, 4], edge1_m: [0, 4, 0],\n"
    "     edge2_m: [4, 0, 0], power_w: 16}\n"
    "  - {type: rect, corner_m: [0, 0, 0], edge1_m: [0, 4, 0],\n"
    "     edge2_m: [0, 0, 4], power_w: 16}\n"
    "  - {type: rect, corner_m: [4, 0, 0], edge1_m: [0, 0, 4],\n"
    "     edge2_m: [0, 4, 0], power_w: 16}\n";

typedef struct view {
    const char *name;
    const char *yaml, *path; /* of the scene: one of them */
    double mean, error;      /* radiance by paths, of the nightly form */
    murk_vec3 from, to;
    size_t samples; /* by maps, of a pixel */
    bool is_round;  /* the camera sees all round */
} view;

static const view pictures[] = {
    {.name = "hall",
     .path = "scenes/smoke-hall.yaml",
     .mean = 0.108844,
     .error = 0.00044,
     .from = {27.5, 2.5, 4},
     .to = {19, 8, 0.5},
     .samples = 96},
    {.name = "room",
     .yaml = FOGGY_BOX,
     .mean = 0.258573,
     .error = 0.00026,
     .from = {0.5, 3.5, 1.6},
     .to = {3, 1, 0.5},
     .samples = 16},
    {.name = "tank",
     .yaml = TANK,
     .mean = 0.171086,
     .error = 0.00016,
     .from = {0.3, 0.4, 2.3},
     .to = {3, 2.4, 0.8},
     .samples = 32},
    {.name = "fog",
     .yaml = FOG,
     .mean = 99.9396,
     .error = 0.083,
     .from = {1, 3, 2},
     .to = {10, 10, 2.5},
     .samples = 32},
};

static murk_stage *made(const view *v)
{
    murk_stage *stage = NULL;
    if (v->yaml) {
        stage = stage_text_create(v->yaml, NULL);
    } else {
        murk_error err = {0};
        murk_scene_desc *scene = NULL;
        if (murk_scene_desc_read(&scene, v->path, NULL, 0, &err) ||
            murk_stage_create(&stage, scene, &err)) {
            printf("%s: %s\n", err.where, err.text);
        }
    }
    if (!stage) {
        exit(1);
    }
    return stage;
}

static murk_traced *lit(const murk_stage *stage, uint64_t photons)
{
    /* the stage is the test's own */
    murk_scene_desc *scene = (murk_scene_desc *)(uintptr_t)stage->scene;
    scene->photons.emit = photons;
    murk_error err = {0};
    murk_traced *traced = NULL;
    if (murk_lightmap_trace(&traced, stage, 0, 2, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return traced;
}

static murk_image *taken(const view *v, const murk_stage *stage,
                         const murk_traced *traced, murk_render_method method,
                         size_t samples, uint32_t seed)
{
    /* A camera of all directions, or one that looks at a point. */
    murk_trace trace = murk_stage_trace(stage);
    trace.seed = seed;
    const murk_camera camera =
        v->is_round
            ? murk_camera_around(v->from, murk_vec(1, 0, 0), WIDTH, HEIGHT)
            : murk_camera_aimed(v->from, v->to, murk_vec(0, 0, 1), 1, WIDTH,
                                HEIGHT);
    /* Render by the method; methods without maps have no traced light. */
    const murk_render render = {.trace = &trace,
                                .camera = camera,
                                .samples = samples,
                                .method = method,
                                .surface = traced ? traced->surface : NULL,
                                .volume = traced ? traced->volume : NULL,
                                .from_nm = {550},
                                .to_nm = {550},
                                .threads = 2};
    murk_error err = {0};
    murk_image *picture = NULL;
    if (murk_render_run(&picture, &render, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return picture;
}

/* ---- exact solutions ---- */

/* Most that a mean may be off, noise included, as a share. */
#define OFF 0.02

/* Reflectance of all walls. */
#define WALLS 0.5

/* A lamp that covers a part of a wall, a watt a square metre times `bright`. */
static void add_lamp(char *yaml, size_t size, const double corner[3],
                     const double edge1[3], const double edge2[3],
                     double bright)
{
    double area = 1;
    for (int axis = 0; axis < 3; ++axis) {
        area *= fmax(1e-9, fabs(edge1[axis]) + fabs(edge2[axis]));
    }
    area *= 1e9; /* one of the axes has neither edge */
    const size_t used = strlen(yaml);
    snprintf(yaml + used, size - used,
             "  - {type: rect, corner_m: [%g, %g, %g], edge1_m: [%g, %g, %g],"
             " edge2_m: [%g, %g, %g], power_w: %.12g}\n",
             corner[0], corner[1], corner[2], edge1[0], edge1[1], edge1[2],
             edge2[0], edge2[1], edge2[2], area * bright);
}

/* Writes the scene of a box of 4 m with walls that shine inwards. If n > 1,
 * water lies below z = 2, and walls under water shine n^2 as much. The air
 * is clear: shadow rays from fog next to the face of a light source would
 * give the method by maps an unbounded variance. */
static void furnace_of(char *yaml, size_t size, double n)
{
    /* The box, with the water as a second region. */
    snprintf(yaml, size,
             "murk: 1\n"
             "domain: {min_m: [0, 0, 0], max_m: [4, 4, 4]}\n"
             "geometry:\n"
             "  - {box: {min_m: [0, 0, 0], max_m: [4, 4, 4]},"
             " material: wall}\n"
             "materials: {wall: {diffuse: %g}}\n"
             "media:\n"
             "  clear: {extinction_per_m: 0, albedo: 1}\n"
             "regions:\n"
             "  - {medium: clear}\n%s"
             "lights:\n",
             WALLS,
             n > 1 ? "  - {medium: clear, below_z_m: 2, ior: 1.34}\n" : "");
    /* Five light sources in each half: floor or ceiling, and four walls. */
    for (int half = 0; half < 2; ++half) {
        const double z = 2 * half, bright = half == 0 ? n * n : 1;
        const double flat[3] = {0, 0, 4 * half};
        const double x[3] = {4, 0, 0}, y[3] = {0, 4, 0}, up[3] = {0, 0, 2};
        add_lamp(yaml, size, flat, half ? y : x, half ? x : y, bright);
        add_lamp(yaml, size, (const double[3]){0, 0, z}, y, up, bright);
        add_lamp(yaml, size, (const double[3]){4, 0, z}, up, y, bright);
        add_lamp(yaml, size, (const double[3]){0, 0, z}, up, x, bright);
        add_lamp(yaml, size, (const double[3]){0, 4, z}, x, up, bright);
    }
}

static void check_exact(const view *v, double want)
{
    static const char *const name[] = {"maps", "paths", "maps alone"};
    murk_stage *stage = made(v);
    murk_traced *traced = lit(stage, 100000);
    for (murk_render_method m = MURK_BY_MAPS; m <= MURK_BY_MAPS_ONLY; ++m) {
        murk_image *p = taken(v, stage, traced, m, v->samples, 6);
        const double ratio = p->mean[0] / want;
        printf("%s, exact, %s: %+.4f +- %.4f\n", v->name, name[m], ratio - 1,
               p->mean_error[0] / want);
        CHECK(fabs(ratio - 1) < OFF);
        CHECK(fabs(1.04 * ratio - 1) >= OFF && fabs(0.96 * ratio - 1) >= OFF);
        CHECK(p->lost == 0);
        murk_image_destroy(p);
    }
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
}

static void test_exact_solutions(void)
{
    static char yaml[4000];
    const double n = 1.34, radiance = 1 / (MURK_PI * (1 - WALLS));
    furnace_of(yaml, sizeof yaml, 1);
    view v = {.name = "furnace",
              .yaml = yaml,
              .from = {2, 2, 1.2}, /* all round photons are most */
              .is_round = true,
              .samples = 16};
    check_exact(&v, radiance);
    furnace_of(yaml, sizeof yaml, n);
    v.name = "furnace, under water";
    check_exact(&v, n * n * radiance);
    v.name = "furnace, over water";
    v.from = murk_vec(2, 2, 2.8);
    check_exact(&v, radiance);
    const view ball = {
        .name = "hollow ball",
        .yaml = "murk: 1\n"
                "domain: {min_m: [-2, -2, -2], max_m: [2, 2, 2]}\n"
                "geometry:\n"
                "  - {sphere: {center_m: [0, 0, 0], radius_m: 1.5},"
                " material: wall}\n"
                "materials: {wall: {diffuse: 0.7}}\n"
                "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n",
        .from = {0.9, 0.4, 0},
        .is_round = true,
        .samples = 32};
    check_exact(&ball, 0.7 / (1 - 0.7) / (4 * MURK_PI * MURK_PI * 1.5 * 1.5));
}

/* ---- scenes without ---- */

/* What a picture's mean is off by, beyond its error and that of the truth, as
 * a share. */
static double off_by(const murk_image *picture, double mean, double error)
{
    const double all = hypot(picture->mean_error[0], error);
    return fmax(0, fabs(picture->mean[0] - mean) - limit * all) / mean;
}

/* By 1,000,000 photons the mean is off by less than 2 % as it stands, noise and
 * all, and knows it. Teeth: a truth 5 % off is not met. */
static void check_flat(const view *v, const murk_image *map)
{
    const double ratio = map->mean[0] / v->mean;
    CHECK(fabs(ratio - 1) < BIAS);
    CHECK(map->mean_error[0] / v->mean < BIAS);
    CHECK(fabs(ratio * 1.05 - 1) >= BIAS);
    CHECK(fabs(ratio / 1.05 - 1) >= BIAS);
}

/* Teeth: another truth is not met. */
static void check_maps(const view *v, const char *name, const murk_image *map)
{
    printf("%s, %s: %+.4f +- %.4f\n", v->name, name, map->mean[0] / v->mean - 1,
           hypot(map->mean_error[0], v->error) / v->mean);
    CHECK(off_by(map, v->mean, v->error) < BIAS);
    const double other = is_nightly ? 1.2 : 1.4;
    CHECK(off_by(map, v->mean * other, v->error) >= BIAS);
    CHECK(off_by(map, v->mean / other, v->error) >= BIAS);
    CHECK(map->lost == 0);
    if (is_nightly) {
        check_flat(v, map);
    }
}

static void test_three_methods_agree(const view *v)
{
    murk_stage *stage = made(v);
    murk_image *path =
        taken(v, stage, NULL, MURK_BY_PATHS, is_nightly ? 6000 : 16, 5);
    printf("%s, paths: %.6g +- %.2g, told %.6g +- %.2g\n", v->name,
           path->mean[0], path->mean_error[0], v->mean, v->error);
    CHECK_WITHIN(limit, path->mean[0], v->mean,
                 hypot(path->mean_error[0], v->error));
    CHECK(path->lost == 0);
    murk_image_destroy(path);
    murk_traced *traced = lit(stage, is_nightly ? 1000000 : 100000);
    murk_image *maps = taken(v, stage, traced, MURK_BY_MAPS,
                             v->samples * (is_nightly ? 8 : 1), 2);
    check_maps(v, "maps", maps);
    murk_image *alone = taken(v, stage, traced, MURK_BY_MAPS_ONLY,
                              v->samples * (is_nightly ? 8 : 1), 2);
    check_maps(v, "maps alone", alone);
    murk_image_destroy(maps);
    murk_image_destroy(alone);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
}

/* Of two pictures' pixels, or blocks of them. */
typedef struct compared {
    double count;   /* of blocks */
    double worst;   /* largest |z| */
    double mean;    /* of z, in its own standard error */
    double squares; /* mean of z squared */
} compared;

/* z of what a block of size * size pixels is off by. */
static double z_of_block(const murk_image *a, const murk_image *b, size_t left,
                         size_t top, size_t size, double brighter)
{
    double off = 0, squares = 0;
    for (size_t y = top; y < top + size; ++y) {
        for (size_t x = left; x < left + size; ++x) {
            const size_t i = y * WIDTH + x;
            off += brighter * (double)a->radiance[0][i] -
                   (double)b->radiance[0][i];
            squares += (double)a->error[0][i] * (double)a->error[0][i] +
                       (double)b->error[0][i] * (double)b->error[0][i];
        }
    }
    return off / sqrt(squares);
}

static compared compare(const murk_image *a, const murk_image *b, size_t size,
                        double brighter, double surer)
{
    compared c = {.count = (double)(PIXELS / size / size)};
    for (size_t y = 0; y < HEIGHT; y += size) {
        for (size_t x = 0; x < WIDTH; x += size) {
            const double z = z_of_block(a, b, x, y, size, brighter) * surer;
            c.worst = fmax(c.worst, fabs(z));
            c.mean += z / sqrt(c.count);
            c.squares += z * z / c.count;
        }
    }
    return c;
}

/* z of the mean of so many squares of normal numbers. */
static double z_of_squares(compared c)
{
    return (c.squares - 1) * sqrt(c.count / 2);
}

static bool is_like(compared c)
{
    return c.worst < limit && fabs(c.mean) < limit &&
           fabs(z_of_squares(c)) < limit;
}

static void check_seeds(const view *v, size_t samples, size_t size,
                        double brighter)
{
    murk_stage *stage = made(v);
    murk_image *a = taken(v, stage, NULL, MURK_BY_PATHS, samples, 3);
    murk_image *b = taken(v, stage, NULL, MURK_BY_PATHS, samples, 4);
    const compared c = compare(a, b, size, 1, 1);
    printf("paths, seed by seed, %s: worst %.2f, mean %.2f (%g times brighter: "
           "%.2f), squares %.3f\n",
           v->name, c.worst, c.mean, brighter,
           compare(a, b, size, brighter, 1).mean, c.squares);
    CHECK(is_like(c));
    CHECK(!is_like(compare(a, b, size, brighter, 1)));
    CHECK(!is_like(compare(a, b, size, 1, 2))); /* errors halved */
    murk_image_destroy(a);
    murk_image_destroy(b);
    stage_text_destroy(stage);
}

/* In fog, what few paths bring to a pixel is far from normal: there the means
 * of blocks are compared. 3 % is the least whole share that they tell apart. */
static void test_paths_agree_with_other_seeds(void)
{
    const view lantern = {.name = "lantern",
                          .yaml = LANTERN,
                          .from = {0.5, 3.5, 1.6},
                          .to = {3, 1, 0.5}};
    check_seeds(&lantern, 250, 1, 1.01);
    check_seeds(&pictures[1], 700, BLOCK, 1.03);
}

/* Sixteen times the photons leave a quarter of the standard error of the
 * mean, to which rays and the few groups of photons add noise: two thirds
 * at most. The deviation of the mean is within the standard error stated.
 * Errors of pixels fall more slowly, as kernels become smaller at the same
 * time. */
static void test_errors_fall_with_photons(void)
{
    /* Render one view from photon maps of more and more photons. */
    const view *foggy_box = &pictures[1];
    murk_stage *stage = made(foggy_box);
    double before = INFINITY, pixels_before = INFINITY;
    for (uint64_t photons = 500; photons <= 128000; photons *= 16) {
        murk_traced *traced = lit(stage, photons);
        murk_image *map =
            taken(foggy_box, stage, traced, MURK_BY_MAPS_ONLY, 24, 2);
        /* Root mean square of the errors of the pixels. */
        double squares = 0;
        for (size_t i = 0; i < PIXELS; ++i) {
            squares += (double)map->error[0][i] * (double)map->error[0][i];
        }
        const double pixels = sqrt(squares / PIXELS);
        printf("%6.0f photons: %+.4f +- %.4f, pixels +- %.4f\n",
               (double)photons, map->mean[0] / foggy_box->mean - 1,
               map->mean_error[0] / foggy_box->mean, pixels / foggy_box->mean);
        /* The mean is right, and both errors are smaller than those with
         * fewer photons. */
        CHECK_WITHIN(limit, map->mean[0], foggy_box->mean, map->mean_error[0]);
        CHECK(map->mean_error[0] < before / 1.5);
        CHECK(pixels < pixels_before);
        before = map->mean_error[0];
        pixels_before = pixels;
        murk_image_destroy(map);
        murk_traced_destroy(traced);
    }
    stage_text_destroy(stage);
}

int main(int argc, char **argv)
{
    limit = murk_sidak_limit(1e-6, ZTESTS);
    is_nightly = argc > 1 && strcmp(argv[1], "nightly") == 0;
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; ++i) {
        test_three_methods_agree(&pictures[i]);
    }
    test_exact_solutions();
    test_paths_agree_with_other_seeds();
    test_errors_fall_with_photons();
    return check_done();
}
