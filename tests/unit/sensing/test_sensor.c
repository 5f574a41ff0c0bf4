/* Frames, fields of view and arrival, against angles worked out apart. Nothing
 * here but directions is random, and no check depends on which they are. */
#include "world.h"

#include "base/rng.h"
#include "sensing/sensor.h"

static const murk_vec3 north = {0, 1, 0};

static bool is_near(murk_vec3 a, murk_vec3 b)
{
    return murk_length(murk_sub(a, b)) < 1e-14;
}

static murk_pose looking(double heading_deg, double tilt_deg)
{
    return (murk_pose){.heading_rad = heading_deg * MURK_PI / 180,
                       .tilt_rad = tilt_deg * MURK_PI / 180};
}

static void test_headings_are_clockwise_from_north(void)
{
    const struct {
        double heading_deg, tilt_deg;
        murk_vec3 axis, right, up;
    } want[] = {{0, 0, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                {90, 0, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                {180, 0, {0, -1, 0}, {-1, 0, 0}, {0, 0, 1}},
                {270, 0, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                {0, 90, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
                {90, -90, {0, 0, -1}, {0, -1, 0}, {1, 0, 0}}};
    for (size_t k = 0; k < sizeof want / sizeof *want; ++k) {
        const murk_pose pose = looking(want[k].heading_deg, want[k].tilt_deg);
        const murk_sensor_frame f = murk_pose_frame(&pose, north);
        CHECK(is_near(f.axis, want[k].axis));
        CHECK(is_near(f.right, want[k].right));
        CHECK(is_near(f.up, want[k].up));
    }
    /* Where north is west, a heading of 90 looks north. */
    const murk_pose pose = looking(90, 0);
    const murk_vec3 west = {-1, 0, 0}, y = {0, 1, 0};
    CHECK(is_near(murk_pose_frame(&pose, west).axis, y));
}

static murk_vec3 direction(uint32_t k)
{
    const murk_random4 r = murk_random(3, MURK_TEST, 0, 0, k);
    const double z = 2 * r.u[0] - 1, a = 2 * MURK_PI * r.u[1];
    return murk_scale(1 + 4 * r.u[2], murk_vec(sqrt(1 - z * z) * cos(a),
                                               sqrt(1 - z * z) * sin(a), z));
}

/* The fields of view by azimuth and elevation. In a level frustum, the
 * horizontal angle is the azimuth, and the vertical slope is taken over the
 * distance along the heading. */
static void test_fields_hold_what_their_angles_say(void)
{
    /* A narrow and a wide cone, both tilted, and a level frustum. */
    const murk_sensor_type cone = {.view = MURK_VIEW_CONE,
                                   .cone_rad = 70 * MURK_PI / 180};
    const murk_sensor_type wide = {.view = MURK_VIEW_CONE,
                                   .cone_rad = 250 * MURK_PI / 180};
    const murk_sensor_type frustum = {.view = MURK_VIEW_FRUSTUM,
                                      .hfov_rad = 80 * MURK_PI / 180,
                                      .vfov_rad = 30 * MURK_PI / 180};
    const murk_pose pose = looking(30, 0), tilted = looking(30, 50);
    const murk_field narrow = murk_field_of(&cone, &tilted, north);
    const murk_field broad = murk_field_of(&wide, &tilted, north);
    const murk_field level = murk_field_of(&frustum, &pose, north);
    size_t in[3] = {0};
    for (uint32_t k = 0; k < 20000; ++k) {
        /* Cones contain directions within half the angle of the axis. */
        const murk_vec3 offset = direction(k);
        const double off =
            acos(murk_dot(offset, narrow.frame.axis) / murk_length(offset)) *
            180 / MURK_PI;
        CHECK(murk_field_contains(&narrow, offset) == (off < 35));
        CHECK(murk_field_contains(&broad, offset) == (off < 125));
        /* The frustum compares the azimuth, and the vertical slope over the
         * distance ahead. */
        const double azimuth =
            remainder(atan2(offset.x, offset.y) * 180 / MURK_PI - 30, 360);
        const double ahead =
            hypot(offset.x, offset.y) * cos(azimuth * MURK_PI / 180);
        const bool is_in = fabs(azimuth) < 40 &&
                           fabs(atan(offset.z / ahead)) * 180 / MURK_PI < 15;
        CHECK(murk_field_contains(&level, offset) == is_in);
        in[0] += off < 35;
        in[1] += off < 125;
        in[2] += is_in;
    }
    /* Enough directions lie in each field. */
    CHECK(in[0] > 1000 && in[1] > 10000 && in[2] > 500);
}

static void test_what_is_too_near_is_not_seen(void)
{
    const murk_sensor_type type = {.least_range_m = 2};
    const murk_pose pose = looking(0, 0);
    const murk_field field = murk_field_of(&type, &pose, north);
    CHECK(murk_field_contains(&field, murk_vec(0, -2, 0)));
    CHECK(!murk_field_contains(&field, murk_vec(0, 1.999999, 0)));
    CHECK(!murk_field_contains(&field, murk_vec(NAN, 0, 0)));
}

static void test_arrival(void)
{
    const murk_sensor_type any = {.view = MURK_VIEW_CONE, .cone_rad = 1};
    murk_sensor_type toward = any;
    toward.toward = true;
    const murk_sensor_type all_round_toward = {.toward = true};
    const murk_pose pose = looking(0, 0);
    const murk_vec3 offset = {3, 1, 0}, along = {0, 1, 0}, against = {0, -1, 0},
                    across = {-1, 0.1, 0};
    const murk_field a = murk_field_of(&any, &pose, north),
                     t = murk_field_of(&toward, &pose, north),
                     r = murk_field_of(&all_round_toward, &pose, north);
    CHECK(murk_field_takes(&a, offset, along));
    CHECK(murk_field_takes(&t, offset, against));
    CHECK(!murk_field_takes(&t, offset, along));
    CHECK(
        !murk_field_takes(&t, offset, across)); /* by the axis, not the place */
    CHECK(murk_field_takes(&r, offset, across));
    CHECK(!murk_field_takes(&r, offset, along));
}

/* The rows of a sight with several sensor types hold the photons that
 * range, field of view, band and direction allow. */
static void test_rows_keep_to_the_field(void)
{
    /* Three types: one without limits, a frustum with a least range, and a type
     * for one band that takes only light toward the sensor. */
    const murk_domain hall = {.box = {{0, 0, 0}, {10, 8, 4}}};
    const murk_sensor_type types[3] = {
        {.range_m = 100},
        {.range_m = 5,
         .view = MURK_VIEW_FRUSTUM,
         .hfov_rad = 1.2,
         .vfov_rad = 0.9,
         .least_range_m = 1},
        {.range_m = 7, .bands = 2, .toward = true}};
    /* Random photons with directions and bands. */
    enum { N = 4000 };
    static murk_photon photon[N];
    for (uint32_t i = 0; i < N; ++i) {
        const murk_random4 r = murk_random(5, MURK_TEST, 1, 0, i);
        const murk_vec3 none = {0, 0, 0};
        photon[i] =
            a_photon(murk_vec(10 * r.u[0], 8 * r.u[1], 4 * r.u[2]), none, i);
        photon[i].direction = murk_direction_pack(murk_unit(direction(i)));
        photon[i].band = i % 2;
    }
    /* A sight with all types, in clear air. */
    murk_surfaces *surfaces = surfaces_of(NULL, 0);
    murk_media *media = clear_air(&hall);
    murk_photon_map *empty = map_of(NULL, 0), *map = map_of(photon, N);
    const murk_sight_desc desc = {.surfaces = surfaces,
                                  .media = media,
                                  .domain = hall,
                                  .surface_map = empty,
                                  .volume_map = map,
                                  .photons_emitted = N,
                                  .type = types,
                                  .types = 3,
                                  .weights = {.balanced = true},
                                  .threads = 1};
    murk_sight *sight = NULL;
    murk_error err = {0};
    CHECK(murk_sight_create(&sight, &desc, &err) == MURK_OK);
    const murk_photon *stored = murk_photon_map_photons(map);
    for (uint32_t type = 0; type < 3; ++type) {
        /* The row of each type. */
        murk_pose pose = looking(140, -20);
        pose.type = type;
        pose.position = murk_vec(4, 5, 2);
        const murk_field field = murk_field_of(&types[type], &pose, north);
        murk_sparse_row row;
        murk_sight_row(sight, 0, &pose, &row);
        size_t at = 0;
        for (uint32_t i = 0; i < N; ++i) {
            /* A photon is in the row if range, field, band and direction
             * allow it. */
            const murk_photon *p = &stored[i];
            const murk_vec3 offset = murk_sub(
                murk_vec((double)p->position_m[0], (double)p->position_m[1],
                         (double)p->position_m[2]),
                pose.position);
            const bool is_seen =
                murk_length(offset) <= types[type].range_m &&
                murk_field_contains(&field, offset) &&
                (types[type].bands == 0 || p->band == 1) &&
                murk_field_takes(&field, offset,
                                 murk_direction_unpack(p->direction));
            CHECK(is_seen == (at < row.seen && row.photon[at] == i));
            at += is_seen;
        }
        CHECK(at == row.seen && at > 50 && (type == 0) == (at == N));
    }
    murk_sight_destroy(sight);
    murk_photon_map_destroy(empty);
    murk_photon_map_destroy(map);
    murk_media_destroy(media);
    murk_surfaces_destroy(surfaces);
}

int main(void)
{
    test_headings_are_clockwise_from_north();
    test_fields_hold_what_their_angles_say();
    test_what_is_too_near_is_not_seen();
    test_arrival();
    test_rows_keep_to_the_field();
    return check_done();
}
