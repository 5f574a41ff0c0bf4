/* Re-weighted light against light traced anew, and its slopes against an
 * adding-doubling table.
 *
 * A level slab of fog between a floor and a ceiling that keep nothing back
 * (they record what meets them, at a millionth) and a beam from above: records
 * are transmittance and reflectance, spheres in the slab fluence rate and
 * irradiance. Errors are of 100 batches of photons; all checks share a chance
 * of 1e-6 of a false alarm. */
#include "base/stats.h"
#include "calibrate/reweigh.h"
#include "check.h"
#include "followed_text.h"
#include "optics_text.h"

#include <stdlib.h>

#define BATCHES   100
#define RECEIVERS 4
#define SUMS      (2 + RECEIVERS) /* transmittance, reflectance, receivers */
#define FLOOR     1e-6

/* z-tests below: values at 6 places, slopes by 4 keys, conservation, the
 * table */
#define CHECKS (6 * SUMS + 4 * SUMS + 6 + 6)
#define BUDGET 1e-6

static const char *const sum_name[SUMS] = {"transmittance", "reflectance",
                                           "fluence, deep", "fluence, high",
                                           "from above",    "from below"};

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [1, 1, 3], sides: periodic}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [0, 0, 0.5], edge1_m: [1, 0, 0],"
    " edge2_m: [0, 1, 0]}, material: counter}\n"
    "  - {rect: {corner_m: [0, 0, 2.5], edge1_m: [1, 0, 0],"
    " edge2_m: [0, 1, 0]}, material: counter}\n"
    "materials: {counter: {diffuse: 1e-6}}\n"
    "media:\n"
    "  fog: {extinction_per_m: 2, albedo: 0.9, phase: {hg: 0.6}}\n"
    "regions:\n"
    "  - {medium: fog, box: {min_m: [0, 0, 1], max_m: [1, 1, 2]}}\n"
    "lights:\n"
    "  - {type: beam, origin_m: [0.5, 0.5, 2.4], direction: [0, 0, -1],"
    " radius_m: 0.3, power_w: 1}\n"
    "photons: {emit: 100000, store_when: hit, maps: surface}\n";

static const size_t reweighed_media[1] = {0};

static const murk_receiver receivers[RECEIVERS] = {
    {{0.5, 0.5, 1.25}, 0.2, {0, 0, 0}, 0, -1},
    {{0.5, 0.5, 1.75}, 0.2, {0, 0, 0}, 0, -1},
    {{0.4, 0.5, 1.5}, 0.2, {0, 0, 1}, 0, -1},
    {{0.4, 0.5, 1.5}, 0.2, {0, 0, -1}, 0, -1},
};

static followed_text lit_at(const char *const *overrides)
{
    return followed_text_trace(scene_text, overrides,
                               (murk_histories_desc){.medium = reweighed_media,
                                                     .media = 1,
                                                     .keeps_cosines = true,
                                                     .receiver = receivers,
                                                     .receivers = RECEIVERS,
                                                     .keeps_records = true});
}

/* ---- estimates by batches ---- */

typedef struct sums {
    double batch[BATCHES][SUMS];
} sums;

static murk_estimate estimate_of(const sums *s, size_t which)
{
    double total = 0, squares = 0;
    for (size_t b = 0; b < BATCHES; ++b) {
        total += s->batch[b][which];
    }
    for (size_t b = 0; b < BATCHES; ++b) {
        const double off = s->batch[b][which] - total / BATCHES;
        squares += off * off;
    }
    return (murk_estimate){total, sqrt(squares * BATCHES / (BATCHES - 1))};
}

/* Whether a record lies on the floor: below the middle of the domain. */
static bool *find_floor(const murk_histories *f)
{
    bool *is_floor = calloc(f->n + 1, sizeof *is_floor);
    for (size_t i = 0; is_floor && i < murk_photon_map_count(f->surface); ++i) {
        const murk_photon *p = &murk_photon_map_photons(f->surface)[i];
        is_floor[p->emitted] = p->position_m[2] < 1.5F;
    }
    return is_floor;
}

/* Sums of `factor` times what the contributions were worth. */
static sums sums_of(const followed_text *l, const double *factor)
{
    const murk_histories *f = l->followed;
    static sums s;
    bool *is_floor = find_floor(f);
    s = (sums){0};
    for (size_t i = 0; i < f->n; ++i) {
        const murk_contribution *c = &f->contribution[i];
        size_t which = is_floor[i] ? 0 : 1;
        double unit = FLOOR;
        if (!murk_contribution_is_record(c)) {
            const double r = receivers[c->receiver].radius_m;
            which = 2 + c->receiver;
            unit = 4. / 3 * MURK_PI * r * r * r;
        }
        const size_t b = (size_t)(c->photon * (uint64_t)BATCHES / f->emitted);
        s.batch[b][which] +=
            factor[i] * (double)c->value * f->packet_w[0] / unit;
    }
    free(is_floor);
    return s;
}

typedef struct reweighed {
    murk_estimate value[SUMS], slope[SUMS];
    double effective_share;
} reweighed;

/* Values at other optics; slopes where there are sides of one key. */
static reweighed reweigh(const followed_text *l, const murk_optics *at,
                         const murk_optics_sides *sides)
{
    reweighed out = {0};
    murk_reweighed r = {0};
    murk_error err = {0};
    if (murk_reweigh(&r, l->followed, l->optics, at, sides, sides != NULL, 2,
                     &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    sums s = sums_of(l, r.ratio);
    for (size_t i = 0; i < SUMS; ++i) {
        out.value[i] = estimate_of(&s, i);
    }
    if (sides) {
        s = sums_of(l, r.slope);
        for (size_t i = 0; i < SUMS; ++i) {
            out.slope[i] = estimate_of(&s, i);
        }
    }
    out.effective_share = r.effective_share;
    murk_reweighed_release(&r);
    return out;
}

static reweighed as_traced(const followed_text *l)
{
    return reweigh(l, l->optics, NULL);
}

/* The difference, in sigmas of both. */
static double sigmas(murk_estimate a, murk_estimate b)
{
    return sigmas_off(a.value, b.value,
                      hypot(a.standard_error, b.standard_error));
}

static void check(const char *what, size_t i, murk_estimate got,
                  murk_estimate want)
{
    const double off = sigmas(got, want);
    printf("%-34s %-14s %10.6f +- %.6f  %10.6f +- %.6f  %5.2f\n", what,
           sum_name[i], got.value, got.standard_error, want.value,
           want.standard_error, off);
    CHECK(off <= murk_sidak_limit(BUDGET, CHECKS));
}

/* ---- values: as far as 20 % ---- */

#define EXTINCTION "media.fog.extinction_per_m="
#define ALBEDO     "media.fog.albedo="
#define HG         "media.fog.phase.hg="

static void check_value(const followed_text *l, const char *const *overrides)
{
    followed_text other = lit_at(overrides);
    const reweighed got = reweigh(l, other.optics, NULL);
    const reweighed want = as_traced(&other);
    char what[96];
    snprintf(what, sizeof what, "%s%s%s", strchr(overrides[1], '.') + 1,
             overrides[2] ? " " : "",
             overrides[2] ? strrchr(overrides[2], '.') + 1 : "");
    for (size_t i = 0; i < SUMS; ++i) {
        check(what, i, got.value[i], want.value[i]);
    }
    followed_text_release(&other);
}

static void test_values_are_those_of_new_light(const followed_text *l)
{
    const char *const places[6][4] = {
        {"seed=2", EXTINCTION "2.4"}, {"seed=3", EXTINCTION "1.6"},
        {"seed=4", ALBEDO "0.98"},    {"seed=5", ALBEDO "0.72"},
        {"seed=6", HG "0.72"},        {"seed=7", EXTINCTION "2.3", HG "0.5"}};
    for (int i = 0; i < 6; ++i) {
        check_value(l, places[i]);
    }
}

/* Teeth: light of slightly other fog is told from required for. */
static void test_would_notice_a_wrong_weight(const followed_text *l)
{
    const char *const right[] = {"seed=2", EXTINCTION "2.4", NULL};
    const char *const wrong[][2] = {{EXTINCTION "2.5"},
                                    {EXTINCTION "2.4", ALBEDO "0.92"},
                                    {EXTINCTION "2.4", HG "0.65"}};
    followed_text other = lit_at(right);
    const reweighed want = as_traced(&other);
    for (int i = 0; i < 3; ++i) {
        const char *const overrides[] = {wrong[i][0], wrong[i][1], NULL};
        murk_optics *at = optics_text_create(scene_text, overrides);
        const reweighed got = reweigh(l, at, NULL);
        double max = 0;
        for (size_t k = 0; k < SUMS; ++k) {
            max = fmax(max, sigmas(got.value[k], want.value[k]));
        }
        CHECK(max > murk_sidak_limit(BUDGET, CHECKS));
        murk_optics_destroy(at);
    }
    followed_text_release(&other);
}

/* ---- slopes: differences of light traced at both sides ---- */

static murk_optics_sides sides_at(const char *key, double value,
                                  const char *also, murk_optics *sides[2])
{
    const double step = 1e-5 * value;
    for (int s = 0; s < 2; ++s) {
        char text[64];
        snprintf(text, sizeof text, "%s%.17g", key, value + (s ? step : -step));
        const char *const overrides[] = {text, also, NULL};
        sides[s] = optics_text_create(scene_text, overrides);
    }
    return (murk_optics_sides){sides[0], sides[1], 2 * step};
}

/* Differences over +-5 %; by Simpson's rule the mean slope between is that of
 * the ends and the middle, off by the fifth derivative. */
static void check_slope(const followed_text *l, const char *key, double value,
                        const char *seed)
{
    murk_estimate traced[2][SUMS];
    murk_estimate slope[3][SUMS];
    for (int s = 0; s < 2; ++s) {
        char text[64], own_seed[32];
        snprintf(text, sizeof text, "%s%.17g", key, value * (s ? 1.05 : 0.95));
        snprintf(own_seed, sizeof own_seed, "%s%d", seed, s);
        const char *const overrides[] = {own_seed, text, NULL};
        followed_text side = lit_at(overrides);
        const reweighed r = as_traced(&side);
        memcpy(traced[s], r.value, sizeof traced[s]);
        followed_text_release(&side);
    }
    for (int s = 0; s < 3; ++s) {
        const double at_value = value * (1 + .05 * (s - 1));
        char text[64];
        snprintf(text, sizeof text, "%s%.17g", key, at_value);
        const char *const overrides[] = {text, NULL};
        murk_optics *at = optics_text_create(scene_text, overrides), *sides[2];
        const murk_optics_sides both = sides_at(key, at_value, NULL, sides);
        const reweighed r = reweigh(l, at, &both);
        memcpy(slope[s], r.slope, sizeof slope[s]);
        murk_optics_destroy(at);
        murk_optics_destroy(sides[0]);
        murk_optics_destroy(sides[1]);
    }
    char what[64];
    snprintf(what, sizeof what, "d/d %s", strchr(key, '.') + 1);
    for (size_t i = 0; i < SUMS; ++i) {
        /* three slopes of one light: errors add up at worst */
        const murk_estimate mean = {
            (slope[0][i].value + 4 * slope[1][i].value + slope[2][i].value) / 6,
            (slope[0][i].standard_error + 4 * slope[1][i].standard_error +
             slope[2][i].standard_error) /
                6};
        const murk_estimate difference = {
            (traced[1][i].value - traced[0][i].value) / (.1 * value),
            hypot(traced[1][i].standard_error, traced[0][i].standard_error) /
                (.1 * value)};
        check(what, i, mean, difference);
    }
}

static void test_slopes_are_differences_of_new_light(const followed_text *l)
{
    check_slope(l, EXTINCTION, 2, "seed=1");
    check_slope(l, ALBEDO, 0.9, "seed=2");
    check_slope(l, HG, 0.6, "seed=3");
    check_slope(l, "lights.0.power_w=", 1, "seed=4");
}

/* ---- nothing is lost ---- */

/* If nothing is absorbed, all light comes out at any extinction and
 * asymmetry: ratios have the mean 1 over photons, and slopes the mean 0. */
static void test_all_comes_out(void)
{
    /* Trace one white medium, and re-weigh the light to two other
     * extinctions and another asymmetry. */
    const char *const white[] = {"seed=9", ALBEDO "1", NULL};
    followed_text l = lit_at(white);
    const char *const places[3][3] = {{ALBEDO "1", EXTINCTION "2.4"},
                                      {ALBEDO "1", EXTINCTION "1.6"},
                                      {ALBEDO "1", HG "0.5"}};
    for (int i = 0; i < 3; ++i) {
        murk_optics *at = optics_text_create(scene_text, places[i]), *sides[2];
        /* The slope is by the parameter that differs. */
        const bool is_hg = i == 2;
        const murk_optics_sides both = sides_at(is_hg ? HG : EXTINCTION,
                                                is_hg ? 0.5
                                                : i   ? 1.6
                                                      : 2.4,
                                                ALBEDO "1", sides);
        murk_reweighed r = {0};
        murk_error err = {0};
        CHECK(!murk_reweigh(&r, l.followed, l.optics, at, &both, 1, 2, &err));
        /* Add up transmittance and reflectance in each batch, which is all
         * light that comes out. */
        const sums value = sums_of(&l, r.ratio), slope = sums_of(&l, r.slope);
        sums out = {0};
        for (size_t b = 0; b < BATCHES; ++b) {
            out.batch[b][0] = value.batch[b][0] + value.batch[b][1];
            out.batch[b][1] = slope.batch[b][0] + slope.batch[b][1];
        }
        const murk_estimate all = estimate_of(&out, 0);
        const murk_estimate change = estimate_of(&out, 1);
        /* The sum is one, and does not change. */
        CHECK_WITHIN(murk_sidak_limit(BUDGET, CHECKS), all.value, 1,
                     all.standard_error);
        CHECK_WITHIN(murk_sidak_limit(BUDGET, CHECKS), change.value, 0,
                     change.standard_error);
        CHECK(all.standard_error < 0.005);
        murk_reweighed_release(&r);
        murk_optics_destroy(at);
        murk_optics_destroy(sides[0]);
        murk_optics_destroy(sides[1]);
    }
    followed_text_release(&l);
}

/* ---- slopes against a table ---- */

/* A slope's integral between two rows of the table, by Gauss and Legendre over
 * light traced at each place, is the difference of the rows. */
#define PLACES 5

static void check_rows(const char *key, double low, double high,
                       const char *fixed_1, const char *fixed_2,
                       const double rows[2][2])
{
    static const double place[PLACES] = {-.9061798459386640, -.5384693101056831,
                                         0, .5384693101056831,
                                         .9061798459386640};
    static const double weight[PLACES] = {.2369268850561891, .4786286704993665,
                                          .5688888888888889, .4786286704993665,
                                          .2369268850561891};
    double sum[2] = {0}, variance[2] = {0};
    for (int p = 0; p < PLACES; ++p) {
        const double value = low + (high - low) * .5 * (1 + place[p]);
        char text[64], seed[16];
        snprintf(text, sizeof text, "%s%.17g", key, value);
        snprintf(seed, sizeof seed, "seed=%d", 50 + p);
        const char *const overrides[] = {
            text, fixed_1, fixed_2, seed, "photons.emit=250000", NULL};
        followed_text l = lit_at(overrides);
        murk_optics *sides[2];
        const double step = 1e-5 * value;
        for (int s = 0; s < 2; ++s) {
            snprintf(text, sizeof text, "%s%.17g", key,
                     value + (s ? step : -step));
            const char *const side[] = {text, fixed_1, fixed_2, NULL};
            sides[s] = optics_text_create(scene_text, side);
        }
        const murk_optics_sides both = {sides[0], sides[1], 2 * step};
        const reweighed r = reweigh(&l, l.optics, &both);
        for (int i = 0; i < 2; ++i) {
            const double w = .5 * (high - low) * weight[p];
            sum[i] += w * r.slope[i].value;
            variance[i] +=
                w * w * r.slope[i].standard_error * r.slope[i].standard_error;
        }
        murk_optics_destroy(sides[0]);
        murk_optics_destroy(sides[1]);
        followed_text_release(&l);
    }
    for (size_t i = 0; i < 2; ++i) {
        const murk_estimate got = {sum[i], sqrt(variance[i])};
        const murk_estimate want = {rows[1][i] - rows[0][i], 1e-6};
        check(key, i, got, want);
        /* teeth: 6 % of a slope would be seen */
        CHECK(got.standard_error * murk_sidak_limit(BUDGET, CHECKS) <
              .06 * fabs(want.value));
    }
}

/* Transmittance and reflectance of slabs of matched index, Henyey-Greenstein,
 * straight on; adding-doubling, tests/physics/reference/slabs.csv. */
static void test_slopes_are_those_of_adding_doubling(void)
{
    check_rows(EXTINCTION, 1, 5, ALBEDO "0.9", HG "0.5",
               (const double[2][2]){{.739091, .129793}, {.171606, .270013}});
    check_rows(ALBEDO, 0.8, 0.95, EXTINCTION "5", HG "0.5",
               (const double[2][2]){{.091147, .160473}, {.256923, .374545}});
    check_rows(HG, 0.5, 0.875, EXTINCTION "5", ALBEDO "0.9",
               (const double[2][2]){{.171606, .270013}, {.430234, .072596}});
}

int main(void)
{
    followed_text l = lit_at(NULL);
    test_values_are_those_of_new_light(&l);
    test_would_notice_a_wrong_weight(&l);
    test_slopes_are_differences_of_new_light(&l);
    followed_text_release(&l);
    test_all_comes_out();
    test_slopes_are_those_of_adding_doubling();
    return check_done();
}
