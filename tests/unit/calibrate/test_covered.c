/* Coverage from re-weighted records is what sensing measures of such records,
 * and its slopes and errors are its own. */
#include "calibrate/sightlines.h"
#include "covered_case.h"
#include "plan/plan.h"

/* Rounding of a clarity, of a worth by chances (placement/dose.h, with each
 * view's own), and of weights, both of a part and of the whole. */
#define ROUNDING (2.6 / 65535 + 0x1p-19)

/* ---- sensing's own measure, of records re-weighted one by one ---- */

static murk_photon_map *reweighed_map(const murk_photon_map *map, const lit *l,
                                      const murk_optics *at)
{
    const size_t n = murk_photon_map_count(map);
    const murk_photon *from = murk_photon_map_photons(map);
    murk_photon *photon = malloc(n * sizeof *photon + 1);
    murk_photon_map *out = NULL;
    for (size_t i = 0; i < n; ++i) {
        const size_t c = from[i].emitted;
        photon[i] = from[i];
        photon[i].emitted = l->followed->contribution[c].photon;
        photon[i].power_w *=
            (float)ratio_of(l->followed, c, &l->traced->optics, at);
    }
    CHECK(!murk_photon_map_create(&out, photon, n, 1, NULL));
    return out;
}

static void measure(murk_estimate out[GROUPS], const lit *l,
                    const char *const *overrides, const double at[KEYS])
{
    /* The stage, with maps of records that are reweighed to the optics. */
    optics here;
    set_optics(&here, at);
    murk_stage *stage = stage_text_create(scene_text, overrides);
    murk_traced traced = {
        .surface = reweighed_map(l->followed->surface, l, &here.optics),
        .volume = reweighed_map(l->followed->volume, l, &here.optics),
        .emitted = l->followed->emitted};
    /* The sight of these maps. */
    murk_sight *sight = NULL;
    CHECK(stage && !murk_plan_sight(&sight, stage, &traced, 1, NULL));
    /* The coverage by the poses of each group. */
    for (size_t g = 0, first = 0; g < GROUPS; ++g) {
        size_t n = 0;
        while (first + n < POSES && group_of[first + n] == g) {
            ++n;
        }
        murk_coverage_result coverage = {0};
        CHECK(!murk_coverage_result_measure(&coverage, sight, poses + first, n,
                                            NULL));
        out[g] = coverage.total;
        murk_coverage_result_release(&coverage);
        first += n;
    }
    murk_sight_destroy(sight);
    murk_photon_map_destroy(traced.surface);
    murk_photon_map_destroy(traced.volume);
    stage_text_destroy(stage);
}

/* Forms in which a scene may count seen photons. */
static const char *const forms[] = {
    "placement.detection=weighted",
    "placement.detection=independent",
    "placement.weights={surface: 1, volume: 3}",
    "placement.redundancy=2",
    "placement.visibility=normal",
    "placement.through=block",
    "domain.sides=periodic",
};
#define FORMS (sizeof forms / sizeof forms[0])

static void test_is_what_sensing_measures(void)
{
    /* Each scene as traced, and the same scene with other media. */
    const double thicker[KEYS] = {1.2, 0.7, 0.5, 0.6, 0};
    for (size_t w = 0; w < FORMS; ++w) {
        const char *const here[] = {forms[w], NULL};
        const char *const there[] = {forms[w],
                                     "media.fog.extinction_per_m=[0.36, 0.24]",
                                     "media.fog.phase={hg: 0.6}",
                                     "media.smoke.extinction_per_m=0.7",
                                     "media.smoke.albedo=0.5",
                                     NULL};
        /* The coverage of the light as traced. */
        murk_estimate want[GROUPS];
        lit l = lit_and_seen(here);
        read_out got = read_at(&l, as_traced, STEP, 0);
        measure(want, &l, here, as_traced);
        for (size_t g = 0; g < GROUPS; ++g) {
            CHECK_NEAR(got.value[g], want[g].value, ROUNDING);
            CHECK(want[g].value > 0.02);
        }
        free(got.batch);
        /* The coverage of the light that is reweighed to the other media. */
        got = read_at(&l, thicker, STEP, 0);
        measure(want, &l, there, thicker);
        for (size_t g = 0; g < GROUPS; ++g) {
            CHECK_NEAR(got.value[g], want[g].value, ROUNDING);
        }
        free(got.batch);
        put_out(&l);
    }
}

/* ---- slopes ---- */

/* Largest difference of slopes from central differences of values, at other
 * parameters than those traced. */
static double slope_error(const lit *l, const double at[KEYS], const double *by)
{
    double max = 0;
    for (size_t k = 0; k < NOTHING; ++k) {
        double low[KEYS], high[KEYS];
        memcpy(low, at, sizeof low);
        memcpy(high, at, sizeof high);
        low[k] *= 1 - STEP;
        high[k] *= 1 + STEP;
        const read_out a = read_at(l, low, STEP, 0);
        const read_out b = read_at(l, high, STEP, 0);
        for (size_t g = 0; g < GROUPS; ++g) {
            const double want = (b.value[g] - a.value[g]) / (2 * STEP * at[k]);
            max = fmax(max, fabs(by[g * KEYS + k] - want));
        }
        free(a.batch);
        free(b.batch);
    }
    return max;
}

/* To 1e-6: the step's own bias is of its square. */
static void test_slopes_are_differences(void)
{
    const double at[KEYS] = {1.1, 0.8, 0.55, 0.65, 0};
    for (size_t w = 0; w < 4; ++w) {
        const char *const here[] = {forms[w], NULL};
        lit l = lit_and_seen(here);
        read_out got = read_at(&l, at, STEP, 0);
        const double off = slope_error(&l, at, got.slope[0]);
        CHECK(off < 1e-6);
        for (size_t g = 0; g < GROUPS; ++g) {
            CHECK(got.slope[g][NOTHING] == 0);
            CHECK(fabs(got.slope[g][FOG]) > 1e-3);
            CHECK(fabs(got.slope[g][SMOKE_ALBEDO]) > 1e-3);
        }
        CHECK(fabs(got.slope[1][FOG_G]) > 1e-3);
        free(got.batch);
        put_out(&l);
    }
}

/* ---- errors ---- */

static double variance(const read_out *r, size_t batches, size_t g)
{
    double mean = 0, square = 0;
    for (size_t b = 0; b < batches; ++b) {
        mean += r->batch[b * GROUPS + g] / (double)batches;
    }
    for (size_t b = 0; b < batches; ++b) {
        const double off = r->batch[b * GROUPS + g] - mean;
        square += off * off;
    }
    return square * (double)batches / ((double)batches - 1);
}

/* With one photon in each batch, the error of the ratio estimator is that
 * of sensing, except for the rounding of clarity in numerator and
 * denominator, which moves an error by no more. With a hundred batches it
 * is the same within the spread of a variance of a hundred values. */
static void test_batches_tell_the_error(void)
{
    /* Batches of one photon each, a hundred batches, and the error by
     * sensing. */
    enum { FEW = 100 };
    const double limit = murk_sidak_limit(1e-6, 3 * GROUPS);
    for (size_t w = 0; w < 3; ++w) {
        const char *const here[] = {forms[w], NULL};
        murk_estimate want[GROUPS];
        lit l = lit_and_seen(here);
        const size_t all = l.followed->emitted;
        read_out each = read_at(&l, as_traced, STEP, all);
        read_out few = read_at(&l, as_traced, STEP, FEW);
        measure(want, &l, here, as_traced);
        for (size_t g = 0; g < GROUPS; ++g) {
            /* Parts of batches add up to the coverage, however many batches
             * there are. */
            double sum = 0;
            for (size_t b = 0; b < FEW; ++b) {
                sum += few.batch[b * GROUPS + g];
            }
            CHECK_NEAR(sum, few.value[g], 1e-13);
            CHECK_NEAR(few.value[g], each.value[g], 1e-13);
            /* The variance over photons is the square of the error by sensing;
             * that over few batches agrees within chance. */
            CHECK_NEAR(sqrt(variance(&each, all, g)), want[g].standard_error,
                       2 * ROUNDING * want[g].standard_error);
            CHECK_WITHIN(limit, variance(&few, FEW, g), variance(&each, all, g),
                         variance(&each, all, g) * sqrt(2.0 / (FEW - 1)));
        }
        free(each.batch);
        free(few.batch);
        put_out(&l);
    }
}

/* ---- the rest ---- */

/* Teeth: with sides that leave sightlines as they are, or exchange the two
 * sides, the check of slopes fails by a thousand times its limit. */
static void test_slopes_need_sightlines(void)
{
    /* Slopes as they should be, from the light as traced. */
    lit l = lit_and_seen(NULL);
    const read_out got = read_at(&l, as_traced, STEP, 0);
    /* Optics at both sides of the extinction of the fog; the same
     * exchanged, and the same without a difference. */
    optics here, low, high;
    double value[KEYS];
    murk_optics_sides sides[KEYS] = {{0}}, turned[KEYS] = {{0}}, still[KEYS];
    memcpy(value, as_traced, sizeof value);
    set_optics(&here, value);
    value[FOG] = 1 - STEP;
    set_optics(&low, value);
    value[FOG] = 1 + STEP;
    set_optics(&high, value);
    sides[FOG] = (murk_optics_sides){&low.optics, &high.optics, 2 * STEP};
    turned[FOG] = (murk_optics_sides){&high.optics, &low.optics, 2 * STEP};
    memcpy(still, sides, sizeof still);
    still[FOG].low = still[FOG].high = &here.optics;
    /* Records are reweighed in the right way. */
    murk_reweighed reweighed =
        reweigh(l.followed, &l.traced->optics, &here.optics, sides);
    const murk_optics_sides *const wrong[] = {turned, still};
    for (size_t i = 0; i < 2; ++i) {
        /* Wrong sightlines leave the coverage, but not the slope by the
         * fog. */
        read_out off;
        CHECK(!read_covered(off.value, off.slope, NULL, 0, &l, &reweighed,
                            &here.optics, wrong[i], NULL));
        for (size_t g = 0; g < GROUPS; ++g) {
            CHECK(off.value[g] == got.value[g]);
            CHECK(fabs(off.slope[g][FOG] - got.slope[g][FOG]) > 1e-3);
        }
    }
    murk_reweighed_release(&reweighed);
    free(got.batch);
    put_out(&l);
}

static void test_threads_make_no_difference(void)
{
    static const unsigned threads[] = {1, 2, 5};
    const double at[KEYS] = {1.1, 0.8, 0.55, 0.65, 0};
    const char *const here[] = {"placement.detection=independent", NULL};
    read_out first = {0};
    for (size_t t = 0; t < 3; ++t) {
        lit l = lit_with(here, MEDIA);
        CHECK(!make_covered(&l, poses, POSES, threads[t], NULL));
        read_out got = read_at(&l, at, STEP, 100);
        if (t > 0) {
            CHECK(!memcmp(got.value, first.value, sizeof got.value));
            CHECK(!memcmp(got.slope, first.slope, sizeof got.slope));
            CHECK(!memcmp(got.batch, first.batch,
                          100 * GROUPS * sizeof *got.batch));
            free(got.batch);
        } else {
            first = got;
        }
        put_out(&l);
    }
    free(first.batch);
}

/* A medium whose paths are not kept counts as it was, and may not change. */
static void test_other_media_stay(void)
{
    const double clearer[KEYS] = {1, 0.7, 0.6, 0.7, 0};
    lit l = lit_with(NULL, 1);
    lit all = lit_and_seen(NULL);
    CHECK(!make_covered(&l, poses, POSES, 2, NULL));
    read_out got = read_at(&l, as_traced, STEP, 0);
    CHECK(got.status == MURK_BAD_VALUE); /* by the fog's sides */
    CHECK_MENTIONS(got.err.text, "paths through it were not kept");
    optics here, there;
    set_optics(&here, as_traced);
    set_optics(&there, clearer);
    const murk_optics_sides none[KEYS] = {{0}};
    murk_reweighed reweighed =
        reweigh(l.followed, &l.traced->optics, &there.optics, none);
    free(got.batch);
    got = read_at(&all, clearer, STEP, 0);
    double value[GROUPS], slope[GROUPS][KEYS];
    CHECK(!read_covered(value, slope, NULL, 0, &l, &reweighed, &there.optics,
                        none, NULL));
    for (size_t g = 0; g < GROUPS; ++g) {
        /* single precision of what is kept by path, or all in one */
        CHECK_NEAR(value[g], got.value[g], 1e-6);
        CHECK(slope[g][FOG] == 0);
    }
    memset(reweighed.ratio, 0, reweighed.n * sizeof *reweighed.ratio);
    murk_error err = {0};
    CHECK(read_covered(value, slope, NULL, 0, &l, &reweighed, &there.optics,
                       none, &err) == MURK_RUN_FAILED);
    CHECK_MENTIONS(err.text, "weigh 0 W on surfaces and 0 W in media");
    murk_reweighed_release(&reweighed);
    free(got.batch);
    put_out(&l);
    put_out(&all);
}

/* A profile whose paths are not kept attenuates sightlines as in sensing: the
 * extinction of its optics is a factor of its values. */
static void test_other_profile_attenuates(void)
{
    const char *const here[] = {
        "media.fog={profile: {z_m: [0, 3], extinction_per_m: [0.4, 0.2]},"
        " albedo: 0.95, phase: {hg: 0.7}}",
        NULL};
    lit l = lit_with(here, 1);
    l.traced->extinction[0] = murk_spectrum_flat(1, 2);
    CHECK(!make_covered(&l, poses, POSES, 2, NULL));
    /* The coverage of the light as traced. */
    const murk_optics_sides none[KEYS] = {{0}};
    murk_reweighed reweighed =
        reweigh(l.followed, &l.traced->optics, &l.traced->optics, none);
    double value[GROUPS], slope[GROUPS][KEYS];
    CHECK(!read_covered(value, slope, NULL, 0, &l, &reweighed,
                        &l.traced->optics, none, NULL));
    murk_estimate want[GROUPS];
    measure(want, &l, here, as_traced);
    for (size_t g = 0; g < GROUPS; ++g) {
        CHECK_NEAR(value[g], want[g].value, ROUNDING);
        CHECK(want[g].value > 0.02);
    }
    murk_reweighed_release(&reweighed);
    put_out(&l);
}

static void check_refused(const char *override, const murk_pose *pose,
                          const char *why)
{
    const char *const here[] = {override, NULL};
    lit l = lit_with(here, MEDIA);
    murk_error err = {0};
    CHECK(make_covered(&l, pose, 1, 1, &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, why);
    CHECK(!l.covered);
    put_out(&l);
}

static void test_what_has_no_slope_is_refused(void)
{
    check_refused("placement.detection=threshold", poses,
                  "detection: threshold cannot be fitted to");
    check_refused("placement.through=refract", poses,
                  "through: refract cannot be fitted to");
}

/* Lines are counted before they are kept: what would take more than there is
 * room for is not even begun. */
static void test_memory_is_bounded(void)
{
    lit l = lit_with(NULL, MEDIA);
    const murk_traced traced = {.surface = l.followed->surface,
                                .volume = l.followed->volume,
                                .emitted = l.followed->n};
    murk_sight *sight = NULL;
    murk_sparse_row row;
    CHECK(!murk_plan_sight(&sight, l.stage, &traced, 1, NULL));
    murk_sight_row(sight, 0, &poses[0], &row);
    const double needed = (double)(row.seen * sizeof(uint32_t));
    const murk_sightlines_through through = {.sight = sight};
    for (int is_enough = 0; is_enough < 2; ++is_enough) {
        murk_sightlines lines = {0};
        murk_sightlines_memory memory = {.max_bytes = needed - !is_enough};
        CHECK(murk_sightlines_find(&lines, &through, 0, &poses[0], &memory) ==
              is_enough);
        CHECK(lines.n == (is_enough ? row.seen : 0));
        CHECK(!lines.contribution == !is_enough);
        murk_sightlines_release(&lines);
    }
    murk_sight_destroy(sight);
    put_out(&l);
}

int main(void)
{
    test_is_what_sensing_measures();
    test_slopes_are_differences();
    test_batches_tell_the_error();
    test_slopes_need_sightlines();
    test_threads_make_no_difference();
    test_other_media_stay();
    test_other_profile_attenuates();
    test_what_has_no_slope_is_refused();
    test_memory_is_bounded();
    return check_done();
}
