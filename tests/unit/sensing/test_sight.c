/* What a sensor sees, against scenes whose answer is known, and against a
 * plain twin that asks every photon in turn.
 *
 * Deterministic: never cries wolf. */
#include "base/rng.h"
#include "sensing/sight.h"
#include "world.h"

static const murk_domain hall = {.box = {{0, 0, 0}, {10, 8, 4}}};
static const murk_vec3 none = {0, 0, 0};

typedef struct world {
    murk_surfaces *surfaces;
    murk_media *media;
    murk_photon_map *surface_map, *volume_map;
    murk_sight *sight;
} world;

/* Photons with a normal go to the surface map. Takes over media. */
static world build(const murk_surface_desc *desc, size_t n_desc,
                   murk_media *media, const murk_photon *photons, size_t n,
                   murk_sight_desc sight)
{
    murk_photon *split = malloc(n * sizeof *split + 1);
    size_t surface = 0, volume = 0;
    for (size_t i = 0; i < n; ++i) {
        if (!murk_photon_is_volume(&photons[i])) {
            split[surface++] = photons[i];
        }
    }
    for (size_t i = 0; i < n; ++i) {
        if (murk_photon_is_volume(&photons[i])) {
            split[surface + volume++] = photons[i];
        }
    }
    world w = {.surfaces = surfaces_of(desc, n_desc), .media = media};
    w.surface_map = map_of(split, surface);
    w.volume_map = map_of(split + surface, volume);
    free(split);
    sight.surfaces = w.surfaces;
    sight.media = media;
    sight.surface_map = w.surface_map;
    sight.volume_map = w.volume_map;
    murk_error err = {0};
    CHECK(murk_sight_create(&w.sight, &sight, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return w;
}

static void tear_down(world *w)
{
    murk_sight_destroy(w->sight);
    murk_photon_map_destroy(w->surface_map);
    murk_photon_map_destroy(w->volume_map);
    murk_media_destroy(w->media);
    murk_surfaces_destroy(w->surfaces);
}

static const murk_sensor_type FAR = {.range_m = 100};

static murk_sight_desc plain(const murk_domain *domain)
{
    return (murk_sight_desc){.domain = *domain,
                             .photons_emitted = 1u << 20,
                             .type = &FAR,
                             .types = 1,
                             .through_sheets = true,
                             .weights = {.balanced = true},
                             .threads = 2};
}

/* Clarity of each photon, by emitted index. */
static int seen_from(const world *w, murk_vec3 sensor, uint32_t emitted)
{
    murk_look look;
    murk_sight_look(w->sight, 0, standing_at(&sensor, 1), &look);
    for (size_t k = 1; k < look.seen; ++k) {
        CHECK(look.photon[k - 1] < look.photon[k]);
    }
    return clarity_of(w->sight, &look, emitted);
}

static void test_a_wall_hides_what_is_behind(void)
{
    murk_photon photon[1000];
    for (uint32_t i = 0; i < 1000; ++i) {
        const murk_vec3 p = {0.5 + i % 10, 0.4 + 0.8 * (i / 10 % 10),
                             0.2 + 0.4 * (i / 100)};
        photon[i] = a_photon(p, none, i);
    }
    const murk_surface_desc wall =
        a_rect(murk_vec(5, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 4), WALL);
    world w = build(&wall, 1, clear_air(&hall), photon, 1000, plain(&hall));
    const murk_vec3 sensors[2] = {{2.1, 4.1, 1.9}, {9.9, 0.1, 3.9}};
    for (int s = 0; s < 2; ++s) {
        murk_look look;
        murk_sight_look(w.sight, 0, standing_at(&sensors[s], 1), &look);
        CHECK(look.seen == 500 && look.clarity == NULL);
        for (size_t k = 0; k < look.seen; ++k) {
            const murk_photon *p =
                &murk_photon_map_photons(w.volume_map)[look.photon[k]];
            CHECK((p->position_m[0] < 5) == (s == 0));
        }
    }
    CHECK(murk_sight_queries(w.sight) == 2);
    CHECK(murk_sight_shadow_rays(w.sight) == 2000);
    tear_down(&w);
}

static void test_a_surface_photon_is_seen_from_its_own_side(void)
{
    const murk_photon photon[3] = {
        a_photon(murk_vec(5, 4, 2), murk_vec(1, 0, 0), 0),
        a_photon(murk_vec(5, 4, 2), murk_vec(-1, 0, 0), 1),
        a_photon(murk_vec(5, 4, 2), murk_unit(murk_vec(1, 1, 0)), 2)};
    const murk_visibility ways[2] = {MURK_VISIBILITY_RAY,
                                     MURK_VISIBILITY_NORMAL};
    for (int v = 0; v < 2; ++v) {
        murk_sight_desc desc = plain(&hall);
        desc.visibility = ways[v];
        world w = build(NULL, 0, clear_air(&hall), photon, 3, desc);
        CHECK(seen_from(&w, murk_vec(7, 4, 2), 0) == MURK_CLEAR);
        CHECK(seen_from(&w, murk_vec(7, 4, 2), 1) == 0);
        CHECK(seen_from(&w, murk_vec(3, 4, 2), 0) == 0);
        CHECK(seen_from(&w, murk_vec(3, 4, 2), 1) == MURK_CLEAR);
        /* Behind the plane x = 5, before the tilted one. */
        CHECK(seen_from(&w, murk_vec(4, 7, 2), 2) == MURK_CLEAR);
        CHECK(seen_from(&w, murk_vec(4, 4.9, 2), 2) == 0);
        CHECK((murk_sight_shadow_rays(w.sight) == 0) == (v == 1));
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
        murk_look look;
        murk_sight_look(w.sight, 0, standing_at(&center, 1), &look);
        CHECK(look.seen == 0);
        /* Storing moves a position by 2^-20 of 10 m at most, a normal by its
         * error times the 1.7 m between; twice, and some room. */
        const double height =
            k == 0 ? 2 * 10 * 0x1p-20 : 3 * 1.7 * MURK_DIRECTION_ERROR_RAD;
        const murk_vec3 above = murk_along(center, height, n);
        murk_sight_look(w.sight, 0, standing_at(&above, 1), &look);
        CHECK(look.seen == 64);
        tear_down(&w);
    }
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

static int clarity(double transmittance)
{
    return (int)floor(transmittance * MURK_CLEAR + 0.5);
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
 * second alone, clear air around. */
static void test_regions_dim_where_they_are(void)
{
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
    const murk_photon photon[2] = {a_photon(murk_vec(9, 4, 2), none, 0),
                                   a_photon(murk_vec(1.5, 4, 2), none, 1)};
    world w = build(NULL, 0, m, photon, 2, plain(&hall));
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

/* A crate in a room with photons on all walls and in the air. */
#define MANY 3000
static void scatter(murk_photon *photon, uint32_t seed)
{
    for (uint32_t i = 0; i < MANY; ++i) {
        const murk_random4 r = murk_random(seed, MURK_TEST, i, 0, 0);
        murk_vec3 p = {10 * r.u[0], 8 * r.u[1], 4 * r.u[2]};
        murk_vec3 n = none;
        const int side = (int)(9 * r.u[3]);
        if (side == 0) {
            p.z = 0;
            n.z = 1;
        } else if (side == 1) {
            p.x = 10;
            n.x = -1;
        } else if (side == 2) {
            p.y = 0;
            n.y = 1;
        }
        photon[i] = a_photon(p, n, i);
        photon[i].band = (uint8_t)(i % 2);
    }
}

/* The same law, asked photon by photon, one ray at a time. */
static int twin(const world *w, murk_vec3 sensor, const murk_photon *p)
{
    const murk_sight_desc *desc = murk_sight_described(w->sight);
    murk_vec3 from = {(double)p->position_m[0], (double)p->position_m[1],
                      (double)p->position_m[2]};
    const murk_vec3 way = murk_sub(sensor, from);
    if (murk_length(way) > desc->type[0].range_m) {
        return 0;
    }
    if (!murk_photon_is_volume(p)) {
        const murk_vec3 n = murk_direction_unpack(p->normal);
        if (!(murk_dot(n, way) > 0)) {
            return 0;
        }
        from = murk_surfaces_leave(w->surfaces, from, n);
    }
    return murk_surfaces_blocked(w->surfaces, from, sensor, true)
               ? 0
               : clarity(murk_media_transmittance(w->media, p->band, 0, from,
                                                  sensor));
}

static void test_agrees_with_the_plain_twin(void)
{
    static murk_photon photon[MANY];
    scatter(photon, 3);
    const murk_surface_desc d[2] = {
        a_box(hall.box.min, hall.box.max),
        a_box(murk_vec(4.2, 3.1, 0), murk_vec(6.3, 5.2, 2.4))};
    murk_sight_desc desc = plain(&hall);
    const murk_sensor_type type = all_round(6.1);
    desc.type = &type;
    for (int misty = 0; misty < 2; ++misty) {
        murk_media *media = misty ? mist(&hall, 0.2, 0.9) : clear_air(&hall);
        world w = build(d, 2, media, photon, MANY, desc);
        size_t seen = 0;
        for (int s = 0; s < 12; ++s) {
            const murk_random4 r = murk_random(7, MURK_TEST, 0, 1, (uint32_t)s);
            const murk_vec3 sensor = {0.1 + 9.8 * r.u[0], 0.1 + 7.8 * r.u[1],
                                      0.1 + 3.8 * r.u[2]};
            murk_look look;
            murk_sight_look(w.sight, 1, standing_at(&sensor, 1), &look);
            int got[MANY] = {0};
            for (size_t k = 0; k < look.seen; ++k) {
                const size_t i = look.photon[k];
                const size_t n = murk_photon_map_count(w.surface_map);
                const murk_photon *p =
                    i < n ? &murk_photon_map_photons(w.surface_map)[i]
                          : &murk_photon_map_photons(w.volume_map)[i - n];
                got[p->emitted] = look.clarity ? look.clarity[k] : MURK_CLEAR;
            }
            int differ = 0;
            for (size_t i = 0; i < MANY; ++i) {
                differ += got[i] != twin(&w, sensor, &photon[i]);
            }
            CHECK(differ == 0);
            seen += look.seen;
        }
        CHECK(seen > MANY); /* the comparison had something to compare */
        tear_down(&w);
    }
}

/* What looks rely on: the step off a surface depends on its normal alone. */
static void test_the_step_off_is_the_same_everywhere(void)
{
    const murk_surface_desc d = a_box(hall.box.min, hall.box.max);
    murk_surfaces *surfaces = surfaces_of(&d, 1);
    const murk_vec3 n = murk_unit(murk_vec(0.3, -0.5, 0.8));
    const murk_vec3 off = murk_surfaces_leave(surfaces, none, n);
    CHECK(murk_length(off) > 0);
    for (int i = 0; i < 8; ++i) {
        const murk_vec3 p = {i & 1 ? 9.9 : 0.1, i & 2 ? 7.9 : 0.1,
                             i & 4 ? 3.9 : 0.1};
        const murk_vec3 q = murk_surfaces_leave(surfaces, p, n);
        CHECK(murk_length(murk_sub(q, murk_add(p, off))) == 0);
    }
    murk_surfaces_destroy(surfaces);
}

static void test_no_extinction_is_clear_air(void)
{
    static murk_photon photon[MANY];
    scatter(photon, 4);
    const murk_surface_desc d = a_box(hall.box.min, hall.box.max);
    world a = build(&d, 1, clear_air(&hall), photon, MANY, plain(&hall));
    world b = build(&d, 1, mist(&hall, 0, 0), photon, MANY, plain(&hall));
    murk_look x, y;
    const murk_vec3 sensor = {3, 3, 3};
    murk_sight_look(a.sight, 0, standing_at(&sensor, 1), &x);
    murk_sight_look(b.sight, 1, standing_at(&sensor, 1), &y);
    CHECK(x.seen == y.seen && x.seen == MANY);
    CHECK(memcmp(x.photon, y.photon, x.seen * sizeof *x.photon) == 0);
    CHECK(!x.clarity && !y.clarity);
    tear_down(&a);
    tear_down(&b);
}

static void test_periodic_sightlines_go_to_the_nearest_image(void)
{
    murk_domain around = hall;
    around.is_periodic = true;
    const murk_photon photon[4] = {
        a_photon(murk_vec(9.5, 4, 2), none, 0),
        a_photon(murk_vec(9.5, 7.5, 2), none, 1),
        a_photon(murk_vec(4, 4, 2), none, 2),
        a_photon(murk_vec(10, 4, 2), murk_vec(-1, 0, 0), 3)};
    const murk_surface_desc walls[2] = {
        a_rect(murk_vec(5, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 4), WALL),
        a_rect(murk_vec(9.75, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 4),
               WALL)};
    murk_surface_desc at_side =
        a_rect(murk_vec(10, 0, 0), murk_vec(0, 8, 0), murk_vec(0, 0, 4), WALL);
    murk_sight_desc desc = plain(&around);
    const murk_sensor_type type = all_round(2);
    desc.type = &type;
    world w = build(walls, 1, mist(&around, 0.3, 0.3), photon, 4, desc);
    const murk_vec3 sensor = {0.5, 0.5, 2}, level = {0.5, 4, 2};
    CHECK(seen_from(&w, level, 0) == clarity(exp(-0.3)));
    CHECK(seen_from(&w, sensor, 1) == clarity(exp(-0.3 * sqrt(2))));
    CHECK(seen_from(&w, level, 2) == 0);
    /* The wall's other side is what the sensor's image would see. */
    CHECK(seen_from(&w, level, 3) == 0);
    tear_down(&w);
    w = build(walls, 2, clear_air(&around), photon, 4, desc);
    CHECK(seen_from(&w, level, 0) == 0);
    tear_down(&w);
    w = build(&at_side, 1, clear_air(&around), photon, 4, desc);
    CHECK(seen_from(&w, level, 0) == 0);
    CHECK(seen_from(&w, sensor, 1) == 0);
    tear_down(&w);
    at_side.material = GLASS;
    w = build(&at_side, 1, clear_air(&around), photon, 4, desc);
    CHECK(seen_from(&w, level, 0) == clarity(GLASS_TRANSMIT));
    tear_down(&w);
}

/* A range past half a period: every photon once, at its nearest image. */
static void test_periodic_photons_are_found_once(void)
{
    static murk_photon photon[MANY];
    scatter(photon, 5);
    murk_domain around = hall;
    around.is_periodic = true;
    murk_sight_desc desc = plain(&around);
    const murk_sensor_type type = all_round(5.5);
    desc.type = &type;
    world w = build(NULL, 0, clear_air(&around), photon, MANY, desc);
    for (int s = 0; s < 8; ++s) {
        const murk_random4 r = murk_random(8, MURK_TEST, 0, 1, (uint32_t)s);
        const murk_vec3 o = {10 * r.u[0], 8 * r.u[1], 4 * r.u[2]};
        murk_look look;
        murk_sight_look(w.sight, 0, standing_at(&o, 1), &look);
        size_t want = 0;
        for (size_t i = 0; i < MANY; ++i) {
            const float *x = photon[i].position_m;
            murk_vec3 way = {remainder(o.x - (double)x[0], 10),
                             remainder(o.y - (double)x[1], 8),
                             o.z - (double)x[2]};
            const bool is_volume = murk_photon_is_volume(&photon[i]);
            const murk_vec3 n =
                is_volume ? none : murk_direction_unpack(photon[i].normal);
            want +=
                murk_length(way) <= 5.5 && (is_volume || murk_dot(n, way) > 0);
        }
        CHECK(look.seen == want && want > 100);
        for (size_t k = 1; k < look.seen; ++k) {
            CHECK(look.photon[k - 1] < look.photon[k]);
        }
    }
    tear_down(&w);
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
    const murk_photon good = a_photon(murk_vec(1, 1, 1), none, 0);
    murk_sight_desc desc = plain(&hall);
    murk_sensor_type type = all_round(0);
    desc.type = &type;
    check_refused(desc, good, MURK_BAD_VALUE, "range_m is 0 m");
    type.range_m = NAN;
    check_refused(desc, good, MURK_BAD_VALUE, "range_m");
    type = (murk_sensor_type){.range_m = 2, .least_range_m = 2};
    check_refused(desc, good, MURK_BAD_VALUE, "least_range_m, 2 m");
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

int main(void)
{
    test_a_wall_hides_what_is_behind();
    test_a_surface_photon_is_seen_from_its_own_side();
    test_grazing_is_not_seen();
    test_range_is_inclusive();
    test_mist_dims_by_band_and_distance();
    test_regions_dim_where_they_are();
    test_light_bends_out_of_sight();
    test_sheets_dim_or_block();
    test_agrees_with_the_plain_twin();
    test_the_step_off_is_the_same_everywhere();
    test_no_extinction_is_clear_air();
    test_periodic_sightlines_go_to_the_nearest_image();
    test_periodic_photons_are_found_once();
    test_bad_input_is_refused();
    return check_done();
}
