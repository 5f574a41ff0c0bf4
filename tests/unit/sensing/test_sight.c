/* What a sensor sees, against scenes whose answer is known, and against a
 * plain twin that asks every photon in turn.
 *
 * Deterministic: never cries wolf. */
#include "sight_world.h"

static void test_a_wall_hides_what_is_behind(void)
{
    /* A lattice of photons, and a wall across the middle of the hall. */
    murk_photon photon[1000];
    for (uint32_t i = 0; i < 1000; ++i) {
        const murk_vec3 p = {0.5 + i % 10, 0.4 + 0.8 * (i / 10 % 10),
                             0.2 + 0.4 * (i / 100)};
        photon[i] = a_photon(p, none, i);
    }
    const murk_surface_desc wall =
        a_rect(murk_vec(5, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 4), WALL);
    world w = build(&wall, 1, clear_air(&hall), photon, 1000, plain(&hall));
    /* Each sensor sees the half on the same side. */
    const murk_vec3 sensors[2] = {{2.1, 4.1, 1.9}, {9.9, 0.1, 3.9}};
    for (int s = 0; s < 2; ++s) {
        murk_sparse_row row;
        murk_sight_row(w.sight, 0, partial_at(&sensors[s], 1), &row);
        CHECK(row.seen == 500 && row.clarity == NULL);
        for (size_t k = 0; k < row.seen; ++k) {
            const murk_photon *p =
                &murk_photon_map_photons(w.volume_map)[row.photon[k]];
            CHECK((p->position_m[0] < 5) == (s == 0));
        }
    }
    /* Each photon takes one shadow ray from each sensor. */
    CHECK(murk_sight_work_of(w.sight).queries == 2);
    CHECK(murk_sight_work_of(w.sight).shadow_rays == 2000);
    tear_down(&w);
}

static void test_a_surface_photon_is_seen_from_its_own_side(void)
{
    const murk_photon photon[3] = {
        a_photon(murk_vec(5, 4, 2), murk_vec(1, 0, 0), 0),
        a_photon(murk_vec(5, 4, 2), murk_vec(-1, 0, 0), 1),
        a_photon(murk_vec(5, 4, 2), murk_unit(murk_vec(1, 1, 0)), 2)};
    const murk_visibility visibilities[2] = {MURK_VISIBILITY_RAY,
                                             MURK_VISIBILITY_NORMAL};
    for (int v = 0; v < 2; ++v) {
        murk_sight_desc desc = plain(&hall);
        desc.visibility = visibilities[v];
        world w = build(NULL, 0, clear_air(&hall), photon, 3, desc);
        CHECK(seen_from(&w, murk_vec(7, 4, 2), 0) == MURK_CLEAR);
        CHECK(seen_from(&w, murk_vec(7, 4, 2), 1) == 0);
        CHECK(seen_from(&w, murk_vec(3, 4, 2), 0) == 0);
        CHECK(seen_from(&w, murk_vec(3, 4, 2), 1) == MURK_CLEAR);
        /* Behind the plane x = 5, before the tilted one. */
        CHECK(seen_from(&w, murk_vec(4, 7, 2), 2) == MURK_CLEAR);
        CHECK(seen_from(&w, murk_vec(4, 4.9, 2), 2) == 0);
        CHECK((murk_sight_work_of(w.sight).shadow_rays == 0) == (v == 1));
        tear_down(&w);
    }
}

/* Coordinates that single precision cannot hold, an axis normal and a slanted
 * one; the sensor stands in the plane of the wall, then just above it. */
static void test_grazing_is_not_seen(void)
{
    const murk_vec3 normal[2] = {{1, 0, 0}, {0.28, 0.9215, 0.2689}};
    for (int k = 0; k < 2; ++k) {
        const murk_vec3 n = murk_unit(normal[k]);
        murk_vec3 t, b;
        murk_frame(n, &t, &b);
        murk_photon photon[64];
        const murk_vec3 center = {3.3, 4.1, 2.1};
        for (uint32_t i = 0; i < 64; ++i) {
            const double angle = 2 * MURK_PI * i / 64;
            const murk_vec3 p = murk_along(
                murk_along(center, 1.7 * cos(angle), t), 1.7 * sin(angle), b);
            photon[i] = a_photon(p, n, i);
        }
        world w = build(NULL, 0, clear_air(&hall), photon, 64, plain(&hall));
        murk_sparse_row row;
        murk_sight_row(w.sight, 0, partial_at(&center, 1), &row);
        CHECK(row.seen == 0);
        /* Storing moves a position by 2^-20 of 10 m at most, a normal by its
         * error times the 1.7 m between; twice, and some room. */
        const double height =
            k == 0 ? 2 * 10 * 0x1p-20 : 3 * 1.7 * MURK_DIRECTION_ERROR_RAD;
        const murk_vec3 above = murk_along(center, height, n);
        murk_sight_row(w.sight, 0, partial_at(&above, 1), &row);
        CHECK(row.seen == 64);
        tear_down(&w);
    }
}

/* A position is off by 2^-20 of the domain's largest coordinate at most: in a
 * domain of 16 km, 1.6 cm. A sensor that stands less than this above the plane
 * of a photon may be behind it. */
static void test_grazing_is_a_matter_of_the_domains_size(void)
{
    const murk_domain valley = {.box = {{0, 0, 0}, {0x1p14, 8, 4}}};
    const murk_photon photon =
        a_photon(murk_vec(5, 4, 2), murk_vec(0, 0, 1), 0);
    world w = build(NULL, 0, clear_air(&valley), &photon, 1, plain(&valley));
    CHECK(seen_from(&w, murk_vec(6, 4, 2 + 0.97 * 0x1p-6), 0) == 0);
    CHECK(seen_from(&w, murk_vec(6, 4, 2 + 1.03 * 0x1p-6), 0) == MURK_CLEAR);
    tear_down(&w);
}

static void test_range_is_inclusive(void)
{
    const murk_photon photon[2] = {
        a_photon(murk_vec(5, 4, 2), none, 0),
        a_photon(murk_vec(5, 4, 2), murk_vec(-1, 0, 0), 1)};
    const double range[3] = {3, 3 - 1e-5, INFINITY};
    for (int k = 0; k < 3; ++k) {
        murk_sight_desc desc = plain(&hall);
        const murk_sensor_type type = all_round(range[k]);
        desc.type = &type;
        world w = build(NULL, 0, clear_air(&hall), photon, 2, desc);
        for (uint32_t e = 0; e < 2; ++e) {
            CHECK(seen_from(&w, murk_vec(2, 4, 2), e) ==
                  (k == 1 ? 0 : MURK_CLEAR));
        }
        tear_down(&w);
    }
}

static void test_mist_dims_by_band_and_distance(void)
{
    murk_photon photon[16];
    for (uint32_t i = 0; i < 16; ++i) {
        photon[i] = a_photon(murk_vec(1 + (i / 2), 4, 2), none, i);
        photon[i].band = (uint8_t)(i % 2);
    }
    const double per_m[2] = {0.3, 1.7};
    for (int v = 0; v < 2; ++v) {
        murk_sight_desc desc = plain(&hall);
        desc.visibility = v ? MURK_VISIBILITY_NORMAL : MURK_VISIBILITY_RAY;
        world w =
            build(NULL, 0, mist(&hall, per_m[0], per_m[1]), photon, 16, desc);
        for (uint32_t i = 0; i < 16; ++i) {
            const double d = 0.5 + i / 2;
            CHECK(seen_from(&w, murk_vec(0.5, 4, 2), i) ==
                  clarity(exp(-per_m[i % 2] * d)));
        }
        tear_down(&w);
    }
    /* 1.7 per metre over 7.5 m: 1.9e-6 rounds to nothing. */
    CHECK(clarity(exp(-1.7 * 7.5)) == 0);
}

/* Two boxes that overlap: 1 m of the first alone, 1 m of both, 2 m of the
 * second alone, and clear air around. */
static void test_regions_dim_where_they_are(void)
{
    /* Two media, and two boxes that overlap. */
    const murk_medium media[2] = {
        {.extinction_per_m = {{0.5, 0.5}}, .where = "thin"},
        {.extinction_per_m = {{0.25, 0.25}}, .where = "thinner"}};
    const murk_region regions[2] = {{.medium = 0,
                                     .shape = MURK_REGION_BOX,
                                     .box = {{2, 0, 0}, {4, 8, 4}},
                                     .to_world = murk_affine_identity(),
                                     .where = "first"},
                                    {.medium = 1,
                                     .shape = MURK_REGION_BOX,
                                     .box = {{3, 0, 0}, {6, 8, 4}},
                                     .to_world = murk_affine_identity(),
                                     .where = "second"}};
    murk_media *m = NULL;
    murk_error err = {0};
    CHECK(murk_media_create(&m, media, 2, regions, 2, &hall.box, &err) ==
          MURK_OK);
    /* One photon behind both boxes, and one before them. */
    const murk_photon photon[2] = {a_photon(murk_vec(9, 4, 2), none, 0),
                                   a_photon(murk_vec(1.5, 4, 2), none, 1)};
    world w = build(NULL, 0, m, photon, 2, plain(&hall));
    /* The first is dimmed by the sum of optical depths, the second not at
     * all. */
    CHECK(seen_from(&w, murk_vec(1, 4, 2), 0) ==
          clarity(exp(-(0.5 * 2 + 0.25 * 3))));
    CHECK(seen_from(&w, murk_vec(1, 4, 2), 1) == MURK_CLEAR);
    tear_down(&w);
}

/* Water below z = 2 with a bubble in it, and a photon on its floor, which lies
 * in the lower face of the water: each side sees its own, in periodic domains
 * too, and by normals alone everything. */
static void test_light_bends_out_of_sight(void)
{
    const murk_medium clear = {.where = "clear"};
    const murk_region regions[2] = {{.shape = MURK_REGION_BOX,
                                     .box = {{0, 0, 0.1}, {10, 8, 2}},
                                     .to_world = murk_affine_identity(),
                                     .ior = 1.34,
                                     .where = "water"},
                                    {.shape = MURK_REGION_SPHERE,
                                     .center = {5, 4, 1},
                                     .radius_m = 0.5,
                                     .to_world = murk_affine_identity(),
                                     .ior = 1,
                                     .where = "bubble"}};
    const murk_surface_desc floor =
        a_rect(murk_vec(0, 0, 0.1), murk_vec(10, 0, 0), murk_vec(0, 8, 0), 0);
    const murk_photon photon[5] = {
        a_photon(murk_vec(3, 4, 1), none, 0),
        a_photon(murk_vec(3, 4, 3), none, 1),
        a_photon(murk_vec(5, 4, 1.2), none, 2),
        a_photon(murk_vec(3, 4, 0.1), murk_vec(0, 0, 1), 3),
        a_photon(murk_vec(9.5, 4, 1), none, 4)};
    /* who sees what, from air, water, the bubble, water behind the bubble; from
     * the second the last photon is behind the bubble, or across the side */
    const murk_vec3 sensor[4] = {
        {3.5, 4, 2.5}, {3.5, 4, 1.5}, {5.1, 4, 1}, {7, 4, 1}};
    const char *const sees[4] = {"01000", "10010", "00100", "00001"};
    const char *const around[4] = {"01000", "10011", "00100", "00001"};
    for (int v = 0; v < 3; ++v) {
        murk_sight_desc desc = plain(&hall);
        desc.domain.is_periodic = v == 1;
        desc.visibility = v == 2 ? MURK_VISIBILITY_NORMAL : MURK_VISIBILITY_RAY;
        murk_media *m = NULL;
        murk_error err = {0};
        CHECK(murk_media_create(&m, &clear, 1, regions, 2, &hall.box, &err) ==
              MURK_OK);
        CHECK_TEXT(err.text, "");
        world w = build(&floor, 1, m, photon, 5, desc);
        for (int k = 0; k < 4; ++k) {
            const char *want = v == 0 ? sees[k] : v == 1 ? around[k] : "11111";
            for (uint32_t i = 0; i < 5; ++i) {
                CHECK(seen_from(&w, sensor[k], i) ==
                      (want[i] == '1' ? MURK_CLEAR : 0));
            }
        }
        tear_down(&w);
    }
}

static void test_sheets_dim_or_block(void)
{
    const murk_surface_desc d[3] = {
        a_rect(murk_vec(3, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 4), GLASS),
        a_rect(murk_vec(6, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 4), GLASS),
        a_rect(murk_vec(8, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 4), WALL)};
    const murk_photon photon[4] = {a_photon(murk_vec(2, 4, 2), none, 0),
                                   a_photon(murk_vec(4, 4, 2), none, 1),
                                   a_photon(murk_vec(7, 4, 2), none, 2),
                                   a_photon(murk_vec(9, 4, 2), none, 3)};
    for (int through = 0; through < 2; ++through) {
        murk_sight_desc desc = plain(&hall);
        desc.through_sheets = through;
        world w = build(d, 3, clear_air(&hall), photon, 4, desc);
        const double t = through ? GLASS_TRANSMIT : 0;
        CHECK(seen_from(&w, murk_vec(1, 4, 2), 0) == MURK_CLEAR);
        CHECK(seen_from(&w, murk_vec(1, 4, 2), 1) == clarity(t));
        CHECK(seen_from(&w, murk_vec(1, 4, 2), 2) == clarity(t * t));
        CHECK(seen_from(&w, murk_vec(1, 4, 2), 3) == 0);
        tear_down(&w);
    }
}

static void check_refused(murk_sight_desc desc, murk_photon photon,
                          murk_status want, const char *why)
{
    murk_surfaces *surfaces = surfaces_of(NULL, 0);
    murk_media *media = clear_air(&hall);
    murk_photon_map *empty = map_of(NULL, 0), *map = map_of(&photon, 1);
    desc.surfaces = surfaces;
    desc.media = media;
    desc.surface_map = empty;
    desc.volume_map = map;
    murk_sight *sight = NULL;
    murk_error err = {0};
    CHECK(murk_sight_create(&sight, &desc, &err) == want && !sight);
    CHECK_MENTIONS(err.text, why);
    if (want == MURK_RUN_FAILED) {
        CHECK_TEXT(err.where, desc.where ? desc.where : "");
    }
    murk_photon_map_destroy(empty);
    murk_photon_map_destroy(map);
    murk_media_destroy(media);
    murk_surfaces_destroy(surfaces);
}

static void test_bad_input_is_refused(void)
{
    /* Sensor types with a bad range. */
    const murk_photon good = a_photon(murk_vec(1, 1, 1), none, 0);
    murk_sight_desc desc = plain(&hall);
    murk_sensor_type type = all_round(0);
    desc.type = &type;
    check_refused(desc, good, MURK_BAD_VALUE, "range_m is 0 m");
    type.range_m = NAN;
    check_refused(desc, good, MURK_BAD_VALUE, "range_m");
    type = (murk_sensor_type){.range_m = 2, .least_range_m = 2};
    check_refused(desc, good, MURK_BAD_VALUE, "least_range_m, 2 m");
    /* Weights of maps that are negative, all 0, or leave nothing to see. */
    desc = plain(&hall);
    desc.weights = (murk_map_weights){false, -1, 2};
    check_refused(desc, good, MURK_BAD_VALUE, "surface -1 and volume 2");
    desc.weights = (murk_map_weights){false, 0, 0};
    check_refused(desc, good, MURK_BAD_VALUE, "not both 0");
    desc.weights = (murk_map_weights){false, 1, 0};
    check_refused(desc, good, MURK_RUN_FAILED, "nothing to see");
    desc.where = "hall.yaml:7: placement";
    check_refused(desc, good, MURK_RUN_FAILED, "nothing to see");
    desc = plain(&hall);
    /* Records with a bad power, band or number, or without power. */
    murk_photon bad = good;
    bad.power_w = NAN;
    check_refused(desc, bad, MURK_BAD_FILE, "record 0");
    bad = good;
    bad.power_w = -1;
    check_refused(desc, bad, MURK_BAD_FILE, "power -1 W");
    bad = good;
    bad.band = MURK_BANDS_MAX;
    check_refused(desc, bad, MURK_BAD_FILE, "band 16");
    bad = good;
    bad.emitted = 1u << 20;
    check_refused(desc, bad, MURK_BAD_FILE, "photon 1048576 of 1048576");
    bad = good;
    bad.power_w = 0;
    check_refused(desc, bad, MURK_RUN_FAILED, "nothing to see");
}

/* Values at the ends of their ranges are allowed, and values a hundredth
 * beyond are not. */
static void test_ends_of_ranges(void)
{
    /* Settings at the ends of their ranges, and beyond. */
    const murk_photon photon = a_photon(murk_vec(1, 1, 1), none, 0);
    const struct {
        double threshold, acceptance_rad, least_range_m;
        murk_combining combining;
        unsigned redundancy;
        bool is_allowed;
    } cases[] = {
        {0, 0, 0, MURK_COMBINE_CLEAREST, 1, true},
        {1, MURK_PI, 1.98, MURK_COMBINE_CLEAREST, MURK_REDUNDANCY_MAX, true},
        {-0.01, 0, 0, MURK_COMBINE_CLEAREST, 1, false},
        {1.01, 0, 0, MURK_COMBINE_CLEAREST, 1, false},
        {0, -0.01, 0, MURK_COMBINE_CLEAREST, 1, false},
        {0, 1.01 * MURK_PI, 0, MURK_COMBINE_CLEAREST, 1, false},
        {0, 0, -0.01, MURK_COMBINE_CLEAREST, 1, false},
        {0, 0, 2.02, MURK_COMBINE_CLEAREST, 1, false},
        {0, 0, 0, MURK_COMBINE_CLEAREST, MURK_REDUNDANCY_MAX + 1, false},
        {0, 0, 0, MURK_COMBINE_INDEPENDENT, 1, true},
        {0, 0, 0, MURK_COMBINE_INDEPENDENT, 2, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        /* A sight with these settings. */
        const murk_sensor_type type = {.range_m = 2,
                                       .least_range_m = cases[i].least_range_m,
                                       .acceptance_rad =
                                           cases[i].acceptance_rad};
        murk_sight_desc desc = plain(&hall);
        desc.type = &type;
        desc.detection = cases[i].threshold > 0 ? MURK_DETECTION_THRESHOLD
                                                : MURK_DETECTION_WEIGHTED;
        desc.threshold = cases[i].threshold;
        desc.combining = cases[i].combining;
        desc.redundancy = cases[i].redundancy;
        /* The sight is made, or refused with a message. */
        if (cases[i].is_allowed) {
            world w = build(NULL, 0, clear_air(&hall), &photon, 1, desc);
            tear_down(&w);
        } else {
            check_refused(desc, photon, MURK_BAD_VALUE, "must be");
        }
    }
}

int main(void)
{
    test_a_wall_hides_what_is_behind();
    test_a_surface_photon_is_seen_from_its_own_side();
    test_grazing_is_not_seen();
    test_grazing_is_a_matter_of_the_domains_size();
    test_range_is_inclusive();
    test_mist_dims_by_band_and_distance();
    test_regions_dim_where_they_are();
    test_light_bends_out_of_sight();
    test_sheets_dim_or_block();
    test_bad_input_is_refused();
    test_ends_of_ranges();
    return check_done();
}
