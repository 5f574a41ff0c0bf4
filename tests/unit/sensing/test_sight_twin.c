/* What a sensor sees of many photons, against a plain twin, and in periodic
 * domains. Deterministic: never cries wolf. */
#include "sight_world.h"

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
    const murk_vec3 offset = murk_sub(sensor, from);
    if (murk_length(offset) > desc->type[0].range_m) {
        return 0;
    }
    if (!murk_photon_is_volume(p)) {
        const murk_vec3 n = murk_direction_unpack(p->normal);
        if (!(murk_dot(n, offset) > 0)) {
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
            murk_sparse_row row;
            murk_sight_row(w.sight, 1, partial_at(&sensor, 1), &row);
            int got[MANY] = {0};
            for (size_t k = 0; k < row.seen; ++k) {
                const size_t i = row.photon[k];
                const size_t n = murk_photon_map_count(w.surface_map);
                const murk_photon *p =
                    i < n ? &murk_photon_map_photons(w.surface_map)[i]
                          : &murk_photon_map_photons(w.volume_map)[i - n];
                got[p->emitted] = row.clarity ? row.clarity[k] : MURK_CLEAR;
            }
            int differ = 0;
            for (size_t i = 0; i < MANY; ++i) {
                differ += got[i] != twin(&w, sensor, &photon[i]);
            }
            CHECK(differ == 0);
            seen += row.seen;
        }
        CHECK(seen > MANY); /* the comparison had something to compare */
        tear_down(&w);
    }
}

/* A part of a row has the needed entries of the row, in the same order, and
 * perhaps others. It is given up only if the entries of the row add less than
 * the least amount, and then always. In clear air and in mist, with a view of
 * half a sphere, and in a periodic domain. */
static void test_parts_have_the_needed_entries(void)
{
    static murk_photon photon[MANY];
    static uint64_t entry_max[MANY];
    scatter(photon, 9);
    const murk_surface_desc d =
        a_box(murk_vec(4.2, 3.1, 0.1), murk_vec(6.3, 5.2, 2.4));
    const murk_sensor_type type = all_round(6.1);
    size_t given_up = 0, left_out = 0;
    for (int k = 0; k < 4; ++k) {
        murk_domain domain = hall;
        domain.is_periodic = k / 2;
        murk_sight_desc desc = plain(&domain);
        desc.type = &type;
        murk_media *media =
            k % 2 ? mist(&domain, 0.2, 0.9) : clear_air(&domain);
        world w = build(&d, 1, media, photon, MANY, desc);
        for (uint32_t s = 0; s < 12; ++s) {
            const murk_random4 r = murk_random(7, MURK_TEST, 0, 1, s);
            const murk_vec3 sensor = {0.1 + 9.8 * r.u[0], 0.1 + 7.8 * r.u[1],
                                      2.5 + 1.4 * r.u[2]};
            /* The whole row, and what the needed entries add at most. */
            murk_sparse_row whole, part;
            murk_sight_row(w.sight, 1, partial_at(&sensor, 1), &whole);
            for (uint32_t i = 0; i < MANY; ++i) {
                const murk_random4 q = murk_random(8, MURK_TEST, i, 1, s);
                entry_max[i] = q.u[0] < 0.7 ? 0 : (uint64_t)(1000 * q.u[1]);
            }
            uint64_t sum = 0;
            for (size_t i = 0; i < whole.seen; ++i) {
                sum += entry_max[whole.photon[i]];
            }
            /* One step more than the sum may be given up, and nothing else. */
            const murk_row_need need = {entry_max,
                                        s % 3 == 0 ? 0 : sum + s % 3 - 1};
            if (!murk_sight_part(w.sight, 0, partial_at(&sensor, 1), &need,
                                 &part)) {
                CHECK(need.gain_min > sum);
                ++given_up;
                continue;
            }
            CHECK(need.gain_min <= sum);
            size_t at = 0;
            for (size_t i = 0; i < whole.seen; ++i) {
                while (at < part.seen && part.photon[at] < whole.photon[i]) {
                    ++at;
                }
                const bool is_there =
                    at < part.seen && part.photon[at] == whole.photon[i];
                CHECK(is_there || entry_max[whole.photon[i]] == 0);
                CHECK(!is_there ||
                      (part.clarity ? part.clarity[at] : MURK_CLEAR) ==
                          (whole.clarity ? whole.clarity[i] : MURK_CLEAR));
                left_out += !is_there;
            }
            CHECK(part.seen <= whole.seen);
        }
        tear_down(&w);
    }
    CHECK(given_up > 0 && left_out > MANY);
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
    murk_sparse_row x, y;
    const murk_vec3 sensor = {3, 3, 3};
    murk_sight_row(a.sight, 0, partial_at(&sensor, 1), &x);
    murk_sight_row(b.sight, 1, partial_at(&sensor, 1), &y);
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

/* With a range beyond half a period, every photon is seen once, at the
 * nearest image. */
static void test_periodic_photons_are_found_once(void)
{
    /* Random records in a periodic hall. */
    static murk_photon photon[MANY];
    scatter(photon, 5);
    murk_domain around = hall;
    around.is_periodic = true;
    murk_sight_desc desc = plain(&around);
    const murk_sensor_type type = all_round(5.5);
    desc.type = &type;
    world w = build(NULL, 0, clear_air(&around), photon, MANY, desc);
    for (int s = 0; s < 8; ++s) {
        /* The row of a sensor at a random position. */
        const murk_random4 r = murk_random(8, MURK_TEST, 0, 1, (uint32_t)s);
        const murk_vec3 o = {10 * r.u[0], 8 * r.u[1], 4 * r.u[2]};
        murk_sparse_row row;
        murk_sight_row(w.sight, 0, partial_at(&o, 1), &row);
        /* As many records are in range at the nearest image and face the
         * sensor. */
        size_t want = 0;
        for (size_t i = 0; i < MANY; ++i) {
            const float *x = photon[i].position_m;
            murk_vec3 offset = {remainder(o.x - (double)x[0], 10),
                                remainder(o.y - (double)x[1], 8),
                                o.z - (double)x[2]};
            const bool is_volume = murk_photon_is_volume(&photon[i]);
            const murk_vec3 n =
                is_volume ? none : murk_direction_unpack(photon[i].normal);
            want += murk_length(offset) <= 5.5 &&
                    (is_volume || murk_dot(n, offset) > 0);
        }
        CHECK(row.seen == want && want > 100);
        /* No record is in the row twice. */
        for (size_t k = 1; k < row.seen; ++k) {
            CHECK(row.photon[k - 1] < row.photon[k]);
        }
    }
    tear_down(&w);
}

int main(void)
{
    test_agrees_with_the_plain_twin();
    test_parts_have_the_needed_entries();
    test_the_step_off_is_the_same_everywhere();
    test_no_extinction_is_clear_air();
    test_periodic_sightlines_go_to_the_nearest_image();
    test_periodic_photons_are_found_once();
    return check_done();
}
