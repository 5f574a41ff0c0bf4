/* Irradiance of pieces from records placed by hand: what arrives is a record's
 * power over the diffuse reflectance, its error that of a sum over emitted
 * photons, each with all its records. */
#include "check.h"
#include "results/lit_pieces.h"

#include <stdlib.h>

#define EMITTED 10

static murk_photon record(double x, double y, uint32_t emitted, uint8_t band,
                          uint8_t material, float power_w)
{
    return (murk_photon){.position_m = {(float)x, (float)y, 0},
                         .direction = murk_direction_pack(murk_vec(0, 0, -1)),
                         .normal = murk_direction_pack(murk_vec(0, 0, 1)),
                         .power_w = power_w,
                         .emitted = emitted,
                         .band = band,
                         .material = material};
}

/* Two floors of 2 x 2 m, of two triangles each, one piece a triangle. */
static void test_sums_and_errors(void)
{
    const murk_material material[] = {
        {.name = "default", .diffuse = {{.5, .25}}},
        {.name = "dark", .diffuse = {{.1, .1}}}};
    const murk_surface_desc floor[] = {{.shape = MURK_SHAPE_RECT,
                                        .edge1 = {2, 0, 0},
                                        .edge2 = {0, 2, 0},
                                        .to_world = murk_affine_identity()},
                                       {.shape = MURK_SHAPE_RECT,
                                        .corner = {4, 0, 0},
                                        .edge1 = {2, 0, 0},
                                        .edge2 = {0, 2, 0},
                                        .to_world = murk_affine_identity(),
                                        .material = 1}};
    murk_surfaces *s = NULL;
    murk_pieces pieces = {0};
    murk_error err = {0};
    CHECK(!murk_surfaces_create(&s, floor, 2, material, 2, &err));
    CHECK(!murk_pieces_create(&pieces, s, 10, 1, "", &err));
    CHECK(pieces.n == 4);
    /* all on the first triangle of its floor or the second: found by asking */
    const murk_vec3 up = {0, 0, 1};
    const uint32_t first = murk_pieces_at(&pieces, murk_vec(1.5, .2, 0), up);
    const uint32_t other = murk_pieces_at(&pieces, murk_vec(.5, .8, 0), up);
    const uint32_t dark = murk_pieces_at(&pieces, murk_vec(5.5, .2, 0), up);
    CHECK(first < 4 && other < 4 && dark < 4 && first != other);
    const murk_photon given[] = {
        record(1.5, .2, 3, 0, 0, 1),   /* 2 W arrived */
        record(1.6, .2, 3, 0, 0, .5),  /* 1 W, of the same photon */
        record(1.4, .1, 7, 1, 0, .5),  /* 2 W, in the other band */
        record(5.5, .2, 1, 0, 1, .25), /* 2.5 W on the dark floor */
        record(9, .2, 2, 0, 1, 5)};    /* on no surface */
    const size_t n = sizeof given / sizeof *given;
    murk_photon *photon = malloc(sizeof given);
    memcpy(photon, given, sizeof given);
    murk_traced traced = {.emitted = EMITTED};
    CHECK(!murk_photon_map_create(&traced.surface, photon, n, 1, &err));
    CHECK(!murk_photon_map_create(&traced.volume, NULL, 0, 1, &err));
    const murk_domain domain = {.box = {{0, 0, -1}, {10, 10, 10}}};
    murk_lit_pieces lit = {0};
    CHECK(!murk_lit_pieces_make(&lit, &pieces, &domain, &traced, 2, NULL, NULL,
                                0, 1, &err));
    CHECK_TEXT(err.text, "");
    if (lit.piece) {
        CHECK(lit.lost == 1 && !lit.is_seen);
        CHECK(lit.piece[first].photons == 3 && lit.piece[other].photons == 0);
        /* a triangle of 2 m2: 3 W of photon 3, 2 W of photon 7 */
        CHECK_NEAR((double)lit.piece[first].irradiance, 5.0 / 2, 1e-6);
        const double variance = 10.0 / 9 * (9 + 4 - 25.0 / 10);
        CHECK_NEAR((double)lit.piece[first].error, sqrt(variance) / 2, 1e-6);
        CHECK(lit.piece[other].irradiance == 0 && lit.piece[other].error == 0);
        CHECK_NEAR((double)lit.piece[dark].irradiance, 2.5 / 2, 1e-6);
        CHECK_NEAR((double)lit.piece[dark].error,
                   sqrt(10.0 / 9 * (6.25 - .625)) / 2, 1e-6);
    }
    murk_lit_pieces_release(&lit);
    murk_photon_map_destroy(traced.surface);
    murk_photon_map_destroy(traced.volume);
    murk_pieces_release(&pieces);
    murk_surfaces_destroy(s);
}

static void test_pieces_in_the_sides_are_within(void)
{
    const murk_domain domain = {.box = {{0, 0, 0}, {4, 2, 1}}};
    static const struct {
        murk_vec3 middle;
        bool is_within;
    } want[] = {{{4, 1, .5}, true},      {{4 + 1e-7, 1, .5}, true},
                {{4.001, 1, .5}, false}, {{1, -.001, .5}, false},
                {{1, 2.001, .5}, false}, {{1, 1, 1.001}, false},
                {{1, 1, -.001}, false},  {{-.001, 1, .5}, false}};
    for (size_t i = 0; i < sizeof want / sizeof *want; ++i) {
        const murk_piece piece = {.middle = want[i].middle};
        CHECK(murk_piece_is_within(&piece, &domain) == want[i].is_within);
    }
}

int main(void)
{
    test_sums_and_errors();
    test_pieces_in_the_sides_are_within();
    return check_done();
}
