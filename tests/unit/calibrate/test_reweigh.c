/* Re-weighted light against itself: slopes are those of the values, to 1e-6 of
 * differences on the same light; no other light is asked, and nothing here
 * could cry wolf by chance. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "calibrate/reweigh.h"
#include "check.h"
#include "followed_text.h"
#include "medium/grid_write.h"
#include "optics_text.h"

#include <stdlib.h>
#include <unistd.h>

#define MEDIA     3
#define RECEIVERS 3
#define LIGHTS    2
#define BATCHES   7

/* Sums that are compared: receivers, and each map's records. */
#define SUMS (RECEIVERS + 2)

static char folder[64], scene_text[2048];

/* A haze everywhere, a preset's fog and a smoke of two voxels overlap; a floor
 * and two lamps. Scattering is split until little is left, then roulette. */
static const char scene_format[] =
    "murk: 1\n"
    "bands_nm: [450, 550]\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3], sides: periodic}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [0, 0, 0.1], edge1_m: [4, 0, 0],"
    " edge2_m: [0, 4, 0]}, material: floor}\n"
    "materials: {floor: {diffuse: 0.5}}\n"
    "media:\n"
    "  haze: {extinction_per_m: 0.6, albedo: 0.9, phase: {hg: 0.8}}\n"
    "  fog: {preset: fog/kruse, visibility_m: 10}\n"
    "  smoke: {vdb: %s/smoke.vdb, extinction_per_m: 1.5, albedo: 0.6,"
    " phase: {two_hg: [0.7, -0.4, 0.6]}}\n"
    "regions:\n"
    "  - {medium: haze}\n"
    "  - {medium: fog, box: {min_m: [0, 0, 0], max_m: [4, 4, 2]}}\n"
    "  - {medium: smoke}\n"
    "lights:\n"
    "  - {type: point, position_m: [0.5, 1, 2.5], power_w: [8, 4]}\n"
    "  - {type: point, position_m: [2, 3, 1], power_w: 2}\n"
    "photons: {emit: 4000, least_weight: 0.3}\n";

static const size_t reweighed_media[MEDIA] = {0, 1, 2};

static const murk_receiver receivers[RECEIVERS] = {
    {{1.5, 1.5, 1.5}, 0.5, {0, 0, 0}, 0, -1},
    {{2.5, 2, 1.5}, 0.6, {0, 0, 1}, 0, -1},
    {{1, 2, 2.2}, 0.4, {0, 0, 0}, 0, 1},
};

static followed_text lit_of(const char *const *overrides)
{
    return followed_text_trace(scene_text, overrides,
                               (murk_histories_desc){.medium = reweighed_media,
                                                     .media = MEDIA,
                                                     .keeps_cosines = true,
                                                     .receiver = receivers,
                                                     .receivers = RECEIVERS,
                                                     .keeps_records = true});
}

static murk_optics *varied_at(const char *key, double value)
{
    char text[96];
    snprintf(text, sizeof text, "%s=%.17g", key, value);
    const char *const overrides[] = {text, NULL};
    return optics_text_create(scene_text, overrides);
}

/* Sums over receivers and over the records of each map, and the slopes by
 * one key if there is a key. */
static void read_sums(const followed_text *l, const murk_optics *at,
                      const murk_optics_sides *sides, size_t keys,
                      double sum[SUMS], double slope[SUMS])
{
    murk_reweighed r = {0};
    /* Reweigh the light, and read the receivers. */
    murk_error err = {0};
    murk_spectrum per_watt[RECEIVERS * LIGHTS];
    double batch[BATCHES * RECEIVERS];
    for (size_t i = 0; i < RECEIVERS * LIGHTS; ++i) {
        per_watt[i] = murk_spectrum_flat(1. + (double)i, 2);
    }
    CHECK(!murk_reweigh(&r, l->followed, l->optics, at, sides, keys, 2, &err));
    double run[RECEIVERS];
    const murk_row_sums sums = {sum, slope, batch, run, RECEIVERS, BATCHES, 1};
    CHECK(!murk_receivers_read(&sums, receivers, per_watt, RECEIVERS,
                               l->followed, &r, 2, &err));
    /* Add up the records of each map, times their ratios and slopes. */
    for (size_t map = 0; map < 2; ++map) {
        sum[RECEIVERS + map] = slope[RECEIVERS + map] = 0;
        for (size_t i = 0; i < r.n; ++i) {
            const murk_contribution *c = &l->followed->contribution[i];
            if (c->receiver ==
                (map ? MURK_RECORD_OF_VOLUME : MURK_RECORD_OF_SURFACE)) {
                const double w = (double)c->value *
                                 l->followed->packet_w[c->light * 2u + c->band];
                sum[RECEIVERS + map] += w * r.ratio[i];
                slope[RECEIVERS + map] += keys ? w * r.slope[i] : 0;
            }
        }
    }
    murk_reweighed_release(&r);
}

/* ---- slopes are those of the values ---- */

#define SIDE 1e-5 /* of the value: the laws' own differences */
#define SHARE                                                          \
    3e-4 /* of the value: differences by five points, which are off by \
            h^4 / 30 times the fifth power of 50 scatterings: 4e-8 */

/* Checks slopes at a value that was not traced, so that ratios are not 1. */
static void check_slope(const followed_text *l, const char *key, double value)
{
    /* Sums and slopes, by optics at both sides of the value. */
    murk_optics *at = varied_at(key, value);
    murk_optics *low = varied_at(key, value * (1 - SIDE));
    murk_optics *high = varied_at(key, value * (1 + SIDE));
    const murk_optics_sides sides = {low, high, 2 * SIDE * value};
    double sum[SUMS], slope[SUMS], other[4][SUMS], none[SUMS];
    read_sums(l, at, &sides, 1, sum, slope);
    /* Sums at four values nearby. */
    const double steps[4] = {-2, -1, 1, 2};
    for (int s = 0; s < 4; ++s) {
        murk_optics *beside = varied_at(key, value * (1 + steps[s] * SHARE));
        read_sums(l, beside, NULL, 0, other[s], none);
        murk_optics_destroy(beside);
    }
    /* Slopes are the differences of fourth order. */
    for (size_t i = 0; i < SUMS; ++i) {
        const double difference =
            (8 * (other[2][i] - other[1][i]) - (other[3][i] - other[0][i])) /
            (12 * SHARE * value);
        const double scale = fabs(difference) + 1e-3 * sum[i] / value;
        CHECK(sum[i] > 0);
        CHECK_NEAR(slope[i], difference, 1e-6 * scale);
    }
    murk_optics_destroy(at);
    murk_optics_destroy(low);
    murk_optics_destroy(high);
}

static void test_slopes_are_the_values(const followed_text *l)
{
    check_slope(l, "media.haze.extinction_per_m", 0.5);
    check_slope(l, "media.haze.albedo", 0.95);
    check_slope(l, "media.haze.phase.hg", 0.75);
    check_slope(l, "media.fog.visibility_m", 11);
    check_slope(l, "media.smoke.extinction_per_m", 1.5);
    check_slope(l, "media.smoke.albedo", 0.5);
    check_slope(l, "media.smoke.phase.two_hg.2", 0.65);
    check_slope(l, "lights.1.power_w", 3);
}

/* ---- several keys at once, threads, batches ---- */

static void test_threads_and_batches_do_not_matter(const followed_text *l)
{
    const char *const keys[] = {"media.haze.extinction_per_m",
                                "media.haze.phase.hg", "lights.0.power_w.1"};
    const double values[] = {0.6, 0.8, 4};
    murk_optics *low[3], *high[3];
    murk_optics_sides sides[4];
    for (int k = 0; k < 3; ++k) {
        low[k] = varied_at(keys[k], values[k] * .999);
        high[k] = varied_at(keys[k], values[k] * 1.001);
        sides[k] = (murk_optics_sides){low[k], high[k], .002 * values[k]};
    }
    sides[3] = (murk_optics_sides){NULL, NULL, 0}; /* has no say */
    murk_optics *at = varied_at(keys[0], 0.7);
    murk_reweighed one = {0};
    murk_error err = {0};
    CHECK(!murk_reweigh(&one, l->followed, l->optics, at, sides, 4, 1, &err));
    for (unsigned threads = 2; threads < 6; threads += 3) {
        murk_reweighed many = {0};
        CHECK(!murk_reweigh(&many, l->followed, l->optics, at, sides, 4,
                            threads, &err));
        CHECK(!memcmp(one.ratio, many.ratio, one.n * sizeof *one.ratio));
        CHECK(!memcmp(one.slope, many.slope, 4 * one.n * sizeof *one.slope));
        CHECK(one.effective_share == many.effective_share);
        murk_reweighed_release(&many);
    }
    size_t said = 0;
    for (size_t i = 0; i < one.n; ++i) {
        said += one.slope[3 * one.n + i] != 0;
    }
    CHECK(said == 0);
    CHECK(one.effective_share > 0.3 && one.effective_share < 1);

    /* batches add up to the value, however many */
    const murk_spectrum flat[RECEIVERS * LIGHTS] = {
        {{1, 1}}, {{1, 1}}, {{1, 1}}, {{1, 1}}, {{1, 1}}, {{1, 1}}};
    double value[RECEIVERS], slope[RECEIVERS * 4], batch[100 * RECEIVERS];
    double run[RECEIVERS * 4];
    const murk_row_sums hundred = {value, slope, batch, run, RECEIVERS, 100, 1};
    CHECK(!murk_receivers_read(&hundred, receivers, flat, RECEIVERS,
                               l->followed, &one, 2, &err));
    double single[RECEIVERS], single_slope[RECEIVERS * 4], whole[RECEIVERS];
    const murk_row_sums all = {single, single_slope, whole, run, RECEIVERS, 1,
                               1};
    CHECK(!murk_receivers_read(&all, receivers, flat, RECEIVERS, l->followed,
                               &one, 2, &err));
    for (size_t r = 0; r < RECEIVERS; ++r) {
        CHECK(whole[r] == single[r]);
        CHECK_NEAR(value[r], single[r], 1e-12 * single[r]);
        CHECK(single_slope[4 * r] == slope[4 * r] && slope[4 * r + 3] == 0);
        size_t empty = 0;
        for (size_t b = 0; b < 100; ++b) {
            empty += !(batch[b * RECEIVERS + r] > 0);
        }
        CHECK(empty < 50);
    }
    murk_reweighed_release(&one);
    murk_optics_destroy(at);
    for (int k = 0; k < 3; ++k) {
        murk_optics_destroy(low[k]);
        murk_optics_destroy(high[k]);
    }
}

/* ---- nothing changed, and too much ---- */

static void test_the_same_is_the_same(const followed_text *l)
{
    murk_reweighed r = {0};
    murk_error err = {0};
    murk_optics *same = varied_at("seed", 7);
    CHECK(!murk_reweigh(&r, l->followed, l->optics, same, NULL, 0, 2, &err));
    size_t off = 0;
    for (size_t i = 0; i < r.n; ++i) {
        off += r.ratio[i] != 1;
    }
    CHECK(off == 0);
    CHECK_NEAR(r.effective_share, 1, 1e-12);
    murk_reweighed_release(&r);
    murk_optics_destroy(same);
}

/* Powers are factors: the lamp's own share counts twice as much. */
static void test_power_scales(const followed_text *l)
{
    murk_reweighed r = {0};
    murk_error err = {0};
    murk_optics *twice = varied_at("lights.1.power_w", 4);
    CHECK(!murk_reweigh(&r, l->followed, l->optics, twice, NULL, 0, 2, &err));
    size_t off = 0;
    for (size_t i = 0; i < r.n; ++i) {
        off += r.ratio[i] != 1. + l->followed->contribution[i].light;
    }
    CHECK(off == 0);
    murk_reweighed_release(&r);
    murk_optics_destroy(twice);
}

/* Black haze: what it scattered is gone, and what it scattered once is what
 * grows first. */
static void test_zero_is_a_value_like_others(const followed_text *l)
{
    const double step = 1e-7;
    murk_optics *black = varied_at("media.haze.albedo", 0);
    murk_optics *grey = varied_at("media.haze.albedo", step);
    const murk_optics_sides sides = {black, grey, step};
    double sum[SUMS], slope[SUMS], other[SUMS], none[SUMS];
    read_sums(l, black, &sides, 1, sum, slope);
    read_sums(l, grey, NULL, 0, other, none);
    for (size_t i = 0; i < SUMS; ++i) {
        const double difference = (other[i] - sum[i]) / step;
        CHECK(difference > 0);
        CHECK_NEAR(slope[i], difference, 1e-4 * difference);
    }
    murk_optics_destroy(black);
    murk_optics_destroy(grey);
}

static void test_too_far_is_cut_off(const followed_text *l)
{
    murk_reweighed r = {0};
    murk_error err = {0};
    murk_optics *far = varied_at("media.haze.extinction_per_m", 1e9);
    CHECK(!murk_reweigh(&r, l->followed, l->optics, far, NULL, 0, 2, &err));
    size_t wrong = 0;
    for (size_t i = 0; i < r.n; ++i) {
        wrong += !(r.ratio[i] >= 0 && r.ratio[i] <= MURK_RATIO_MAX);
    }
    CHECK(wrong == 0);
    CHECK(r.effective_share >= 0 && r.effective_share < 0.01);
    murk_reweighed_release(&r);
    murk_optics_destroy(far);
}

/* ---- refusals ---- */

static void check_refused(const char *traced_key, const char *key, double value,
                          const char *where, const char *part)
{
    const char *const overrides[] = {traced_key, NULL};
    followed_text l = lit_of(overrides);
    murk_optics *at = varied_at(key, value);
    murk_reweighed r = {0};
    murk_error err = {0};
    CHECK(murk_reweigh(&r, l.followed, l.optics, at, NULL, 0, 1, &err) ==
          MURK_BAD_VALUE);
    CHECK_TEXT(err.where, where);
    CHECK_MENTIONS(err.text, part);
    murk_optics_destroy(at);
    followed_text_release(&l);
}

static void test_nothing_comes_of_nothing(void)
{
    check_refused("media.haze.albedo=0", "media.haze.albedo", .5, "media.haze",
                  "albedo is 0 in band 0, which cannot be re-weighted to 0.5");
    check_refused("media.smoke.extinction_per_m=0",
                  "media.smoke.extinction_per_m", 2, "media.smoke",
                  "extinction_per_m is 0 in band 0");
    check_refused("lights.1.power_w=0", "lights.1.power_w", 2, "lights.1",
                  "power is 0 in band 0");
}

static void write_smoke(void)
{
    const float density[2] = {1, 2};
    const murk_grid_field fields[] = {{"density", density, NULL}};
    const size_t size[3] = {2, 1, 1};
    murk_affine place = murk_affine_identity();
    place.shift = murk_vec(1.5, 1.5, 1.5);
    char path[96];
    murk_error err = {0};
    snprintf(path, sizeof path, "%s/smoke.vdb", folder);
    CHECK(!murk_grid_write(path, fields, 1, size, &place, &err));
}

int main(void)
{
    snprintf(folder, sizeof folder, "%s/murk-test-XXXXXX", P_tmpdir);
    if (!mkdtemp(folder)) {
        return 1;
    }
    write_smoke();
    snprintf(scene_text, sizeof scene_text, scene_format, folder);
    followed_text l = lit_of(NULL);
    test_slopes_are_the_values(&l);
    test_threads_and_batches_do_not_matter(&l);
    test_the_same_is_the_same(&l);
    test_power_scales(&l);
    test_zero_is_a_value_like_others(&l);
    test_too_far_is_cut_off(&l);
    test_nothing_comes_of_nothing();
    followed_text_release(&l);
    char path[96];
    snprintf(path, sizeof path, "%s/smoke.vdb", folder);
    unlink(path);
    rmdir(folder);
    return check_done();
}
