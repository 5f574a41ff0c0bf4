/* Directions packed into 32 bits. The bound is derived, not estimated, so
 * nothing here cries wolf. */
#include "check.h"

#include "base/rng.h"
#include "photonmap/photon.h"

static double angle(murk_vec3 a, murk_vec3 b)
{
    return atan2(murk_length(murk_cross(a, b)), murk_dot(a, b));
}

static double error_at(double x, double y, double z)
{
    const murk_vec3 d = murk_unit(murk_vec(x, y, z));
    return angle(d, murk_direction_unpack(murk_direction_pack(d)));
}

static void test_axes_are_exact(void)
{
    for (int i = 0; i < 6; ++i) {
        double d[3] = {0, 0, 0};
        d[i / 2] = i % 2 ? -1 : 1;
        const murk_vec3 got = murk_direction_unpack(
            murk_direction_pack(murk_vec(d[0], d[1], d[2])));
        CHECK(got.x == d[0] && got.y == d[1] && got.z == d[2]);
    }
}

/* Teeth: the bound is met nearly everywhere a face's middle is looked at
 * finely, so one a hundredth smaller would be wrong. */
static void test_error_is_bounded_and_the_bound_is_tight(void)
{
    double max = 0;
    for (uint64_t i = 0; i < 200000; ++i) {
        const murk_random4 r = murk_random(1, MURK_TEST, i, 0, 0);
        const murk_vec3 d =
            murk_about(murk_vec(0, 0, 1), 2 * r.u[0] - 1, 2 * MURK_PI * r.u[1]);
        max = fmax(max, error_at(d.x, d.y, d.z));
        const double h = 1e-3; /* near the middle of a face */
        max = fmax(max, error_at(1 + h * r.u[1], 1 + h * r.u[2],
                                 i % 2 ? 1 : -1 - h * r.u[3]));
    }
    CHECK(max <= MURK_DIRECTION_ERROR_RAD);
    CHECK(max > 0.99 * MURK_DIRECTION_ERROR_RAD);
}

static void test_packing_is_stable(void)
{
    for (uint64_t i = 0; i < 20000; ++i) {
        uint32_t w[4];
        murk_random_words(2, MURK_TEST, i, 0, 0, w);
        const murk_vec3 d = murk_direction_unpack(w[0]); /* any bits */
        CHECK(fabs(murk_length(d) - 1) < 4e-16);
        const uint32_t packed = murk_direction_pack(d);
        CHECK(packed != 0);
        CHECK(murk_direction_pack(murk_direction_unpack(packed)) == packed);
    }
}

static void test_folds_and_signs(void)
{
    CHECK(error_at(1, 0, -1e-12) < MURK_DIRECTION_ERROR_RAD);
    CHECK(error_at(-1, -0.0, -1e-12) < MURK_DIRECTION_ERROR_RAD);
    CHECK(error_at(0, 1, -0.0) < MURK_DIRECTION_ERROR_RAD);
    CHECK(error_at(-1, -1, -1e-9) < MURK_DIRECTION_ERROR_RAD);
    CHECK(error_at(1e-9, -1e-9, -1) < MURK_DIRECTION_ERROR_RAD);
}

static void test_nothing_packs_to_zero(void)
{
    const murk_vec3 none = murk_direction_unpack(0);
    CHECK(none.x == 0 && none.y == 0 && none.z == 0);
    CHECK(murk_direction_pack(none) == 0);
    CHECK(murk_direction_pack(murk_vec(NAN, 0, 1)) == 0);
    CHECK(murk_direction_pack(murk_vec(0, INFINITY, 1)) == 0);
}

static void test_kinds_say_map_and_class(void)
{
    for (int volume = 0; volume <= 1; ++volume) {
        for (int class = 0; class <= 2; ++class) {
            const murk_photon p = murk_photon_make(&(murk_photon_values){
                .is_volume = volume, .event_class = class});
            CHECK(murk_photon_tag(&p) == murk_photon_kind(volume, class));
            CHECK(murk_photon_is_volume(&p) == volume);
            CHECK(murk_photon_class(&p) == class);
        }
    }
}

static bool is_same(murk_vec3 a, murk_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static void test_values_come_back(void)
{
    /* Values at or near the limits of the fields. */
    const murk_photon_values stored = {.position_m = {1.5, -2.25, 3},
                                       .direction = {0, 0, -1},
                                       .normal = {0, 1, 0},
                                       .power_w = 0.375,
                                       .emitted = 4000000000U,
                                       .band = 15,
                                       .light = 200,
                                       .material = 255,
                                       .event_class = 2};
    murk_photon p = murk_photon_make(&stored);
    /* Each comes back exactly. */
    CHECK(is_same(murk_photon_place(&p), stored.position_m));
    CHECK(is_same(murk_photon_direction(&p), stored.direction));
    CHECK(is_same(murk_photon_normal(&p), stored.normal));
    CHECK(murk_photon_packed_direction(&p) ==
          murk_direction_pack(stored.direction));
    CHECK(murk_photon_packed_normal(&p) == murk_direction_pack(stored.normal));
    CHECK(murk_photon_power_w(&p) == 0.375);
    CHECK(murk_photon_emitted(&p) == 4000000000U);
    CHECK(murk_photon_band(&p) == 15 && murk_photon_light(&p) == 200);
    CHECK(murk_photon_material(&p) == 255 && murk_photon_class(&p) == 2);
    /* A value that is set leaves the others as they were. */
    murk_photon_set_power_w(&p, 2);
    murk_photon_set_emitted(&p, 7);
    murk_photon_set_material(&p, 9);
    CHECK(murk_photon_power_w(&p) == 2 && murk_photon_emitted(&p) == 7);
    CHECK(murk_photon_material(&p) == 9 && murk_photon_band(&p) == 15);
}

/* A record of the volume has no normal, whatever is given. */
static void test_the_volume_has_no_normal(void)
{
    const murk_photon p = murk_photon_make(
        &(murk_photon_values){.normal = {0, 0, 1}, .is_volume = true});
    CHECK(murk_photon_packed_normal(&p) == 0);
    CHECK(is_same(murk_photon_normal(&p), murk_vec(0, 0, 0)));
}

int main(void)
{
    test_axes_are_exact();
    test_error_is_bounded_and_the_bound_is_tight();
    test_packing_is_stable();
    test_folds_and_signs();
    test_nothing_packs_to_zero();
    test_kinds_say_map_and_class();
    test_values_come_back();
    test_the_volume_has_no_normal();
    return check_done();
}
