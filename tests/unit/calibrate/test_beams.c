/* Transmittance of segments and extinction at points at the values of a fit.
 * Nothing here is random. */
#define _DEFAULT_SOURCE /* mkdtemp */
#include "calibrate/beams.h"

#include "check.h"
#include "medium/grid_write.h"
#include "stage_text.h"

#include <stdlib.h>
#include <unistd.h>

/* Rounding of sums of a few terms near 1. */
#define EXACT 1e-12

static const char layered[] =
    "murk: 1\n"
    "bands_nm: [450, 550]\n"
    "domain: {min_m: [-9, -9, 0], max_m: [9, 9, 9]}\n"
    "media:\n"
    "  layer: {profile: {z_m: [0, 2, 2, 5], extinction_per_m: [[0.2, 0.1], "
    "[0.1, 0.1], [0.4, 0.3], [0, 0.3]]}, albedo: 0.9, phase: {hg: 0.6}}\n"
    "  haze: {extinction_per_m: [0.05, 0.02], albedo: 0.5, phase: {hg: 0.9}}\n"
    "regions:\n"
    "  - {medium: layer}\n"
    "  - {medium: haze, box: {min_m: [-9, -9, 0], max_m: [9, 9, 3]}}\n"
    "lights: [{type: point, position_m: [0, 0, 8], power_w: 1}]\n";

static murk_reading segment(double x1, double y1, double z1, double x2,
                            double y2, double z2)
{
    return (murk_reading){.kind = MURK_READ_TRANSMITTANCE,
                          .line = 7,
                          .condition = SIZE_MAX,
                          .position = murk_vec(x1, y1, z1),
                          .to = murk_vec(x2, y2, z2),
                          .acceptance_rad = NAN,
                          .band = -1,
                          .gain = SIZE_MAX,
                          .value = 0.5,
                          .standard_error = 0.01};
}

static murk_reading point(double x, double y, double z)
{
    murk_reading out = segment(x, y, z, x, y, z);
    out.kind = MURK_READ_EXTINCTION;
    out.unit = MURK_UNIT_EXTINCTION_PER_M;
    return out;
}

/* The value of a reading in `stage`, with the numbers of `values` (the same
 * scene, overridden). */
static double value_of(const murk_stage *stage, const murk_stage *values,
                       const murk_reading *reading)
{
    murk_error err = {0};
    murk_beams *beams = NULL;
    double out = NAN;
    /* only read: a stage's scene is const for others */
    const murk_optics optics = {
        .phases = values->phases,
        .scene = (murk_scene_desc *)(uintptr_t)values->scene};
    CHECK(murk_beams_create(&beams, stage, &optics, &err) == MURK_OK);
    CHECK(murk_beam_read(&out, beams, reading, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    murk_beams_destroy(beams);
    return out;
}

static void test_layers_by_hand(void)
{
    murk_stage *stage = stage_text_create(layered, NULL);
    if (!stage) {
        CHECK(stage != NULL);
        return;
    }
    /* From z = 1 to z = 5, 3 across: each metre of height is 5/4 m of path. */
    murk_reading r = segment(0, 0, 1, 3, 0, 5);
    const double blue = (0.15 + 0.1) / 2 + 0.4 / 2 * 3 + 2 * 0.05;
    const double green = 0.1 + 0.3 * 3 + 2 * 0.02;
    r.band = 0;
    CHECK_NEAR(value_of(stage, stage, &r), exp(-1.25 * blue), EXACT);
    r.band = 1;
    CHECK_NEAR(value_of(stage, stage, &r), exp(-1.25 * green), EXACT);
    r.band = -1;
    CHECK_NEAR(value_of(stage, stage, &r),
               (exp(-1.25 * blue) + exp(-1.25 * green)) / 2, EXACT);
    /* and as the world itself has it, the other way round */
    const murk_reading back = segment(3, 0, 5, 0, 0, 1);
    CHECK_NEAR(
        value_of(stage, stage, &back),
        (murk_media_transmittance(stage->media, 0, 0, r.position, r.to) +
         murk_media_transmittance(stage->media, 1, 0, r.position, r.to)) /
            2,
        EXACT);
    stage_text_destroy(stage);
}

/* Numbers of the other scene, layers and heights of regions among them. */
static void test_values_of_another_scene(void)
{
    static const char *const changed[] = {
        "media.layer.profile.extinction_per_m.2=[0.8, 0.3]",
        "media.layer.profile.z_m=[0, 2, 2, 4]",
        "media.haze.extinction_per_m=0.1", "regions.1.box.max_m=[9, 9, 2.5]",
        NULL};
    murk_stage *stage = stage_text_create(layered, NULL);
    murk_stage *other = stage_text_create(layered, changed);
    if (stage && other) {
        murk_reading r = segment(0, 0, 0, 0, 0, 5);
        r.band = 0;
        CHECK_NEAR(value_of(stage, other, &r),
                   exp(-(0.3 + 0.8 / 2 * 2 + 2.5 * 0.1)), EXACT);
        CHECK_NEAR(value_of(stage, stage, &r),
                   exp(-(0.3 + 0.4 / 2 * 3 + 3 * 0.05)), EXACT);
    }
    CHECK(stage && other);
    stage_text_destroy(stage);
    stage_text_destroy(other);
}

/* Of Henyey and Greenstein's law, what turns by less than theta. */
static double accepted(double g, double theta)
{
    return (1 - g * g) / (2 * g) *
           (1 / (1 - g) - 1 / sqrt(1 + g * g - 2 * g * cos(theta)));
}

static void test_acceptance(void)
{
    static const char *const clear[] = {"media.haze.phase.hg=0.8", NULL};
    murk_stage *stage = stage_text_create(layered, NULL);
    murk_stage *other = stage_text_create(layered, clear);
    if (stage && other) {
        murk_reading r = segment(0, 0, 0.5, 4, 0, 0.5);
        r.band = 1;
        r.acceptance_rad = 0.1;
        const double layer = 0.1 * (1 - 0.9 * accepted(0.6, 0.1));
        CHECK_NEAR(value_of(stage, stage, &r),
                   exp(-4 * (layer + 0.02 * (1 - 0.5 * accepted(0.9, 0.1)))),
                   1e-9);
        CHECK_NEAR(value_of(stage, other, &r),
                   exp(-4 * (layer + 0.02 * (1 - 0.5 * accepted(0.8, 0.1)))),
                   1e-9);
        r.acceptance_rad = 0;
        CHECK_NEAR(value_of(stage, stage, &r), exp(-4 * 0.12), EXACT);
    }
    CHECK(stage && other);
    stage_text_destroy(stage);
    stage_text_destroy(other);
}

/* The extinction at a point is the sum of all media there, at the values of the
 * other scene. */
static void test_extinction_at_points(void)
{
    static const char *const changed[] = {
        "media.layer.profile.extinction_per_m.2=[0.8, 0.3]",
        "media.haze.extinction_per_m=0.1", NULL};
    murk_stage *stage = stage_text_create(layered, NULL);
    murk_stage *other = stage_text_create(layered, changed);
    if (stage && other) {
        murk_reading r = point(1, 2, 2.75); /* a quarter of the upper layer */
        r.band = 0;
        CHECK_NEAR(value_of(stage, stage, &r), .3 + .05, EXACT);
        CHECK_NEAR(value_of(stage, other, &r), .6 + .1, EXACT);
        r.band = -1;
        CHECK_NEAR(value_of(stage, stage, &r), (.35 + .32) / 2, EXACT);
        r.unit = MURK_UNIT_VISIBILITY_M;
        CHECK_NEAR(value_of(stage, stage, &r), 3.912 / .335, 1e-10);
        r = point(0, 0, 8); /* above all media */
        CHECK(value_of(stage, stage, &r) == 0);
        r.unit = MURK_UNIT_MOR_M;
        CHECK(value_of(stage, stage, &r) > 1e16);
        CHECK(isfinite(value_of(stage, stage, &r)));
        /* Light that is scattered forward is not lost. */
        r = point(0, 0, 0.5);
        r.band = 1;
        r.acceptance_rad = 0.1;
        CHECK_NEAR(value_of(stage, stage, &r),
                   .1 * (1 - .9 * accepted(.6, .1)) +
                       .02 * (1 - .5 * accepted(.9, .1)),
                   1e-9);
    }
    CHECK(stage && other);
    stage_text_destroy(stage);
    stage_text_destroy(other);
}

static murk_error refusal(const char *yaml, murk_reading reading)
{
    murk_error err = {0};
    char path[] = "beams.csv";
    murk_stage *stage = stage_text_create(yaml, NULL);
    const murk_readings measured = {
        .path = path, .reading = &reading, .readings = 1};
    CHECK(stage != NULL);
    if (stage) {
        const murk_status status =
            murk_beams_check(stage, &measured, SIZE_MAX, &err);
        CHECK(status == err.code);
        /* another condition's readings are not its business */
        CHECK(murk_beams_check(stage, &measured, 0, NULL) == MURK_OK);
    }
    stage_text_destroy(stage);
    return err;
}

static const char walled[] =
    "murk: 1\n"
    "domain: {min_m: [-9, -9, -9], max_m: [9, 9, 9]}\n"
    "materials: {glass: {transmit: 0.9}, ball: {transmit: 1, ior: 1.5}}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [1, -1, -1], edge1_m: [0, 2, 0], edge2_m: [0, 0, "
    "2]}}\n"
    "  - {rect: {corner_m: [-1, -1, -1], edge1_m: [0, 2, 0], edge2_m: [0, 0, "
    "2]}, material: glass}\n"
    "  - {sphere: {center_m: [0, 5, 0], radius_m: 1}, material: ball}\n"
    "media:\n"
    "  sea: {extinction_per_m: 0.1, albedo: 0.5}\n"
    "regions: [{medium: sea, below_z_m: -3, ior: 1.34}]\n"
    "lights: [{type: point, position_m: [0, 0, 8], power_w: 1}]\n";

static void test_refusals(void)
{
    murk_error err = refusal(walled, segment(0, 0, 0, 3, 0, 0));
    CHECK(err.code == MURK_BAD_VALUE);
    CHECK_TEXT(err.where, "beams.csv:7");
    CHECK_TEXT(err.text, "a surface stands across the segment [0, 0, 0] to "
                         "[3, 0, 0] m, which must be open");
    err = refusal(walled, segment(0, 0, 0, -3, 0, 0)); /* a sheet */
    CHECK_MENTIONS(err.text, "a surface stands across");
    err = refusal(walled, segment(0, 0, 0, 0, 0, -4));
    CHECK_TEXT(err.where, "beams.csv:7");
    CHECK_MENTIONS(err.text, "index of refraction changes");
    err = refusal(walled, segment(0, 5, 0.1, 0, 5, 0.2));
    CHECK_MENTIONS(err.text, "inside a solid");
    err = refusal(walled, point(0, 5, 0.1));
    CHECK_TEXT(err.where, "beams.csv:7");
    CHECK_TEXT(err.text, "the point [0, 5, 0.1] m is inside a solid, must be "
                         "outside of all");
    CHECK_TEXT(refusal(walled, point(0, 0, -4)).text, "");
    /* from wall to sheet, through water, beside the walls: all open */
    CHECK_TEXT(refusal(walled, segment(1, 0, 0, -1, 0, 0)).text, "");
    CHECK_TEXT(refusal(walled, segment(0, 0, -4, 5, 5, -8)).text, "");
    CHECK_TEXT(refusal(walled, segment(0, 2, 0, 3, 2, 0)).text, "");
}

static void test_acceptance_needs_one_albedo(void)
{
    char folder[] = "/tmp/murk_beams_XXXXXX", path[64], text[512];
    const float density[1] = {1}, albedo[1] = {0.5F};
    const murk_grid_field fields[] = {{"density", density, NULL},
                                      {"albedo", albedo, NULL}};
    const size_t size[3] = {1, 1, 1};
    const murk_affine place = murk_affine_identity();
    murk_error err = {0};
    CHECK(mkdtemp(folder) != NULL);
    snprintf(path, sizeof path, "%s/g.vdb", folder);
    CHECK(murk_grid_write(path, fields, 2, size, &place, &err) == MURK_OK);
    snprintf(
        text, sizeof text,
        "murk: 1\n"
        "domain: {min_m: [-9, -9, -9], max_m: [9, 9, 9]}\n"
        "media: {m: {vdb: %s, extinction_per_m: 3, albedo: {grid: albedo}, "
        "grid: density}}\n"
        "regions: [{medium: m}]\n"
        "lights: [{type: point, position_m: [5, 0, 0], power_w: 1}]\n",
        path);
    murk_reading r = segment(-2, 0, 0, 2, 0, 0);
    CHECK_TEXT(refusal(text, r).text, "");
    r.acceptance_rad = 0.01;
    CHECK_MENTIONS(refusal(text, r).text, "albedo is a grid");
    murk_reading p = point(0.1, 0, 0);
    CHECK_TEXT(refusal(text, p).text, "");
    p.acceptance_rad = 0.01;
    CHECK_MENTIONS(refusal(text, p).text, "albedo is a grid");
    /* grids are the stage's: half a metre and one and a half of density 1 */
    murk_stage *stage = stage_text_create(text, NULL);
    r = segment(-2, 0, 0, 2, 0, 0);
    if (stage) {
        CHECK_NEAR(
            value_of(stage, stage, &r),
            murk_media_transmittance(stage->media, 0, 0, r.position, r.to),
            EXACT);
        CHECK(value_of(stage, stage, &r) < 0.9);
        p = point(0.1, 0, 0);
        CHECK(value_of(stage, stage, &p) == 3);
        p = point(4, 0, 0);
        CHECK(value_of(stage, stage, &p) == 0);
    }
    stage_text_destroy(stage);
    unlink(path);
    rmdir(folder);
}

/* A cube of 2 m as a file; its triangles are sorted out by themselves. */
static void write_cube(const char *path)
{
    static const int face[6][4] = {{1, 2, 4, 3}, {5, 6, 8, 7}, {1, 2, 6, 5},
                                   {3, 4, 8, 7}, {1, 3, 7, 5}, {2, 4, 8, 6}};
    FILE *file = fopen(path, "w");
    CHECK(file != NULL);
    for (int i = 0; file && i < 8; ++i) {
        fprintf(file, "v %d %d %d\n", i & 1 ? 1 : -1, i & 2 ? 1 : -1,
                i & 4 ? 1 : -1);
    }
    for (int i = 0; file && i < 6; ++i) {
        fprintf(file, "f %d %d %d %d\n", face[i][0], face[i][1], face[i][2],
                face[i][3]);
    }
    if (file) {
        fclose(file);
    }
}

/* A region that is a mesh: the length within the mesh counts. A mesh with
 * an index bends the path, which is refused. */
static void test_in_a_mesh(void)
{
    /* A scene with a cube as a mesh, and the same scene with a denser
     * medium. */
    static const char *const dense[] = {"media.m.extinction_per_m=0.7", NULL};
    char folder[] = "/tmp/murk_beams_XXXXXX", path[64], text[512];
    CHECK(mkdtemp(folder) != NULL);
    snprintf(path, sizeof path, "%s/cube.obj", folder);
    write_cube(path);
    snprintf(text, sizeof text,
             "murk: 1\n"
             "domain: {min_m: [-9, -9, -9], max_m: [9, 9, 9]}\n"
             "media: {m: {extinction_per_m: 0.3, albedo: 0.5}}\n"
             "regions: [{medium: m, mesh: %s}]\n"
             "lights: [{type: point, position_m: [5, 0, 0], power_w: 1}]\n",
             path);
    murk_stage *stage = stage_text_create(text, NULL);
    murk_stage *other = stage_text_create(text, dense);
    /* Only the length within the cube attenuates, also from a position
     * inside. */
    const murk_reading across = segment(-3, 0.1, 0.2, 3, 0.1, 0.2);
    const murk_reading from_within = segment(0.5, 0.1, 0.2, 3, 0.1, 0.2);
    if (stage && other) {
        CHECK_NEAR(value_of(stage, stage, &across), exp(-2 * 0.3), 1e-6);
        CHECK_NEAR(value_of(stage, other, &across), exp(-2 * 0.7), 1e-6);
        CHECK_NEAR(value_of(stage, other, &from_within), exp(-0.5 * 0.7), 1e-6);
        const murk_reading within = point(0.5, 0.1, 0.2);
        const murk_reading beside = point(1.5, 0.1, 0.2);
        CHECK(value_of(stage, other, &within) == 0.7);
        CHECK(value_of(stage, other, &beside) == 0);
    }
    CHECK(stage && other);
    stage_text_destroy(stage);
    stage_text_destroy(other);
    CHECK_TEXT(refusal(text, across).text, "");
    /* With an index of refraction, a segment through the mesh is refused. */
    char *end = strstr(text, "obj}");
    CHECK(end != NULL);
    snprintf(end, sizeof text - (size_t)(end - text), "%s",
             "obj, ior: 1.3}]\nlights: [{type: point, position_m: [5, 0, 0], "
             "power_w: 1}]\n");
    CHECK_MENTIONS(refusal(text, across).text, "index of refraction changes");
    unlink(path);
    rmdir(folder);
}

/* Straight from end to end, though the other way round would be nearer. */
static void test_periodic(void)
{
    murk_stage *stage = stage_text_create(
        "murk: 1\n"
        "domain: {min_m: [-9, -9, -9], max_m: [9, 9, 9], sides: periodic}\n"
        "media: {m: {extinction_per_m: 0.1, albedo: 0.5}}\n"
        "regions: [{medium: m}]\n"
        "lights: [{type: point, position_m: [5, 0, 0], power_w: 1}]\n",
        NULL);
    const murk_reading r = segment(-8, 0, 0, 8, 0, 0);
    CHECK(stage != NULL);
    if (stage) {
        CHECK_NEAR(value_of(stage, stage, &r), exp(-1.6), EXACT);
    }
    stage_text_destroy(stage);
}

int main(void)
{
    test_in_a_mesh();
    test_periodic();
    test_acceptance_needs_one_albedo();
    test_layers_by_hand();
    test_values_of_another_scene();
    test_acceptance();
    test_extinction_at_points();
    test_refusals();
    return check_done();
}
