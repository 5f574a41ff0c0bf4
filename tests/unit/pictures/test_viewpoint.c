/* Where a picture is taken from: a camera of the scene, or a sensor of a given
 * list, whose view and direction it has. Nothing here is random. */
#include "check.h"
#include "pictures/viewpoint.h"
#include "stage_text.h"

#include <string.h>

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "lights: [{type: point, position_m: [1, 1, 2.5], power_w: 8}]\n"
    "sensors:\n"
    "  types:\n"
    "    - {name: node, range_m: 2}\n"
    "    - {name: cam, range_m: 2, view: {hfov_deg: 90, vfov_deg: 60}}\n"
    "  candidates: {}\n"
    "  count: 1\n"
    "cameras:\n"
    "  - {name: gate, from_m: [1, 1, 1], to_m: [2, 1, 1], pixels: [64, 48],"
    " samples: 5}\n"
    "  - {name: high, from_m: [1, 1, 1], to_m: [1, 1, 2], up: [0, 1, 0]}\n"
    "  - {name: out, from_m: [9, 1, 1], to_m: [1, 1, 2]}\n";

/* A node, and a camera whose heading is south-west and tilt 30 degrees down. */
static const murk_pose sensors[] = {{.position = {1, 1, 1}, .type = 0},
                                    {.position = {2, 3, 1},
                                     .type = 1,
                                     .heading_rad = 225 * MURK_PI / 180,
                                     .tilt_rad = -30 * MURK_PI / 180}};

/* The viewpoint of a request; err has the message if there is none. */
static murk_status stand(murk_viewpoint *v, const murk_stage *stage,
                         const murk_viewpoint_request *request, murk_error *err)
{
    *err = (murk_error){0};
    *v = (murk_viewpoint){0};
    const murk_status status =
        murk_viewpoint_choose(v, stage->scene, request, err);
    return status ? status : murk_viewpoint_stand(v, stage, request, err);
}

static void test_cameras(const murk_stage *stage)
{
    murk_viewpoint v;
    murk_error err;
    murk_viewpoint_request o = {0};
    CHECK(stand(&v, stage, &o, &err) == MURK_OK); /* the first */
    CHECK_TEXT(v.name, "gate");
    CHECK(v.samples == 5);
    CHECK(v.camera.width == 64 && v.camera.height == 48);
    CHECK_NEAR(v.heading_deg, 90, 1e-9); /* clockwise from north: east */
    CHECK_NEAR(v.tilt_deg, 0, 1e-9);
    o = (murk_viewpoint_request){
        .camera = "high", .pixels = {8, 6}, .samples = 3};
    CHECK(stand(&v, stage, &o, &err) == MURK_OK);
    CHECK(v.camera.width == 8 && v.camera.height == 6);
    CHECK(v.samples == 3);
    CHECK_NEAR(v.tilt_deg, 90, 1e-6);
    o = (murk_viewpoint_request){.camera = "none"};
    CHECK(stand(&v, stage, &o, &err) == MURK_BAD_VALUE);
    o = (murk_viewpoint_request){.camera = "out"};
    CHECK(stand(&v, stage, &o, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "must be within the domain");
}

static void test_sensors(const murk_stage *stage)
{
    murk_viewpoint v;
    murk_error err;
    murk_viewpoint_request o = {
        .sensor = sensors, .sensors = 2, .from_sensor = 2};
    CHECK(stand(&v, stage, &o, &err) == MURK_OK);
    CHECK(v.sensors == 2);
    CHECK_TEXT(v.name, "sensor 2 (cam)");
    CHECK_NEAR(v.heading_deg, 225, 1e-9);
    CHECK_NEAR(v.tilt_deg, -30, 1e-9);
    CHECK_NEAR(v.camera.from.y, 3, 0);
    /* square pixels: tan 45 / tan 30 as wide as high; 640 unless asked */
    CHECK(v.camera.width == 640 && v.camera.height == 370);
    CHECK(v.samples == 16);
    o.from_sensor = 1; /* all round: level, twice as wide as high */
    CHECK(stand(&v, stage, &o, &err) == MURK_OK);
    CHECK(v.camera.width == 640 && v.camera.height == 320);
    CHECK_NEAR(v.tilt_deg, 0, 1e-9);
    o.from_sensor = 3;
    CHECK(stand(&v, stage, &o, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "must be 1..2");
}

int main(void)
{
    murk_stage *stage = stage_text_create(scene_text, NULL);
    CHECK(stage != NULL);
    if (stage) {
        test_cameras(stage);
        test_sensors(stage);
    }
    stage_text_destroy(stage);
    return check_done();
}
