/* Coverage from re-weighted records is that of light traced anew.
 *
 * A fog's extinction and mean cosine and a smoke's extinction 5 % lower and
 * higher: both coverages, their difference, and what the slope makes of it, for
 * three groups of sensors, against another stream traced with these. All
 * errors are stated ones, which go by batches or photons; the checks share a
 * 1e-6 false-alarm budget, seeds are fixed. Teeth: a slope that leaves out what
 * the medium does on sightlines is off by more than twice the limit.
 *
 * The error by a hundred batches is the true one: of 200 seeds, as many lie
 * within one of the re-traced light's coverage as of a normal distribution. */
#include "base/stats.h"
#include "covered_case.h"
#include "plan/plan.h"

#define TURNED 3 /* FOG, SMOKE, FOG_G */
#define CHECKS (TURNED * GROUPS * 4 + GROUPS)
#define PART   0.05

enum { BATCHES = 100, SEEDS = 200 };

static const key turned[TURNED] = {FOG, SMOKE, FOG_G};
static const char *const lower[TURNED] = {
    "media.fog.extinction_per_m=[0.285, 0.19]",
    "media.smoke.extinction_per_m=0.855", "media.fog.phase={hg: 0.665}"};
static const char *const higher[TURNED] = {
    "media.fog.extinction_per_m=[0.315, 0.21]",
    "media.smoke.extinction_per_m=0.945", "media.fog.phase={hg: 0.735}"};

static void trace_anew(murk_estimate out[GROUPS], const char *override,
                       const char *emit, uint32_t stream)
{
    const char *const overrides[] = {emit, override, NULL};
    murk_stage *stage = stage_text_create(scene_text, overrides);
    murk_traced *traced = NULL;
    murk_sight *sight = NULL;
    CHECK(stage && !murk_lightmap_trace(&traced, stage, stream, 2, NULL) &&
          !murk_plan_sight(&sight, stage, traced, 2, NULL));
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
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
}

/* Of the total of a - by * b over batches; b NULL: of a. */
static double error_of(const read_out *a, const read_out *b, size_t group)
{
    double mean = 0, square = 0;
    for (int pass = 0; pass < 2; ++pass) {
        for (size_t i = group; i < BATCHES * GROUPS; i += GROUPS) {
            const double part = a->batch[i] - (b ? b->batch[i] : 0);
            mean += pass == 0 ? part / BATCHES : 0;
            square += pass == 1 ? (part - mean) * (part - mean) : 0;
        }
    }
    return sqrt(square * BATCHES / (BATCHES - 1.0));
}

/* The slope's part that is of weights alone: sightlines as they were. */
static void slopes_of_weights(double slope[GROUPS][KEYS], const lit *l)
{
    optics here, low[KEYS], high[KEYS];
    murk_optics_sides sides[KEYS] = {{0}}, still[KEYS] = {{0}};
    set_optics(&here, as_traced);
    for (size_t i = 0; i < TURNED; ++i) {
        const key k = turned[i];
        double value[KEYS];
        memcpy(value, as_traced, sizeof value);
        value[k] = as_traced[k] * (1 - STEP);
        set_optics(&low[k], value);
        value[k] = as_traced[k] * (1 + STEP);
        set_optics(&high[k], value);
        sides[k] = (murk_optics_sides){&low[k].optics, &high[k].optics,
                                       2 * STEP * as_traced[k]};
        still[k] = (murk_optics_sides){&here.optics, &here.optics, 1};
    }
    murk_reweighed reweighed =
        reweigh(l->followed, &l->traced->optics, &here.optics, sides);
    double value[GROUPS];
    CHECK(!read_covered(value, slope, NULL, 0, l, &reweighed, &here.optics,
                        still, NULL));
    murk_reweighed_release(&reweighed);
}

static void test_light_traced_anew(double limit)
{
    /* Re-weigh one traced light: the coverage and the slopes as traced, and
     * the part of the slopes that is due to weights alone. */
    const char *const emit[] = {"photons.emit=60000", NULL};
    lit l = lit_and_seen(emit);
    const read_out here = read_at(&l, as_traced, STEP, BATCHES);
    double of_weights[GROUPS][KEYS], worst = 0;
    slopes_of_weights(of_weights, &l);
    /* Re-weigh to a smaller and a larger value of each key, and trace new
     * light at both. */
    for (size_t i = 0; i < TURNED; ++i) {
        const key k = turned[i];
        double value[KEYS];
        memcpy(value, as_traced, sizeof value);
        value[k] = as_traced[k] * (1 - PART);
        const read_out low = read_at(&l, value, STEP, BATCHES);
        value[k] = as_traced[k] * (1 + PART);
        const read_out high = read_at(&l, value, STEP, BATCHES);
        const double span = 2 * PART * as_traced[k];
        murk_estimate anew_low[GROUPS], anew_high[GROUPS];
        trace_anew(anew_low, lower[i], emit[0], 1);
        trace_anew(anew_high, higher[i], emit[0], 2);
        /* Values, their difference, and the slope times the difference of
         * the key agree with the new light. */
        for (size_t g = 0; g < GROUPS; ++g) {
            const double by_low = anew_low[g].standard_error;
            const double by_high = anew_high[g].standard_error;
            const double anew = anew_high[g].value - anew_low[g].value;
            const double sigma =
                hypot(hypot(by_low, by_high), error_of(&high, &low, g));
            CHECK_WITHIN(limit, low.value[g], anew_low[g].value,
                         hypot(by_low, error_of(&low, NULL, g)));
            CHECK_WITHIN(limit, high.value[g], anew_high[g].value,
                         hypot(by_high, error_of(&high, NULL, g)));
            CHECK_WITHIN(limit, high.value[g] - low.value[g], anew, sigma);
            CHECK_WITHIN(limit, here.slope[g][k] * span, anew, sigma);
            printf("key %d, group %zu: %.5f by slope, %.5f re-weighted, %.5f "
                   "+- %.5f traced anew, %.5f by weights alone\n",
                   (int)k, g, here.slope[g][k] * span,
                   high.value[g] - low.value[g], anew, sigma,
                   of_weights[g][k] * span);
            worst =
                fmax(worst, sigmas_off(of_weights[g][k] * span, anew, sigma));
        }
        free(low.batch);
        free(high.batch);
    }
    /* Teeth: slopes that leave out the sightlines are refused. */
    CHECK(worst > 2 * limit);
    free(here.batch);
    put_out(&l);
}

static void test_batches_tell_the_true_error(double limit)
{
    const double p = erf(sqrt(0.5));
    double hits[GROUPS] = {0};
    murk_estimate truth[GROUPS];
    trace_anew(truth, NULL, "photons.emit=200000", 1);
    for (unsigned seed = 1; seed <= SEEDS; ++seed) {
        char text[32];
        snprintf(text, sizeof text, "seed=%u", seed + 100);
        const char *const overrides[] = {"photons.emit=2000", text, NULL};
        lit l = lit_and_seen(overrides);
        const read_out got = read_at(&l, as_traced, STEP, BATCHES);
        for (size_t g = 0; g < GROUPS; ++g) {
            hits[g] += fabs(got.value[g] - truth[g].value) <
                       hypot(error_of(&got, NULL, g), truth[g].standard_error);
        }
        free(got.batch);
        put_out(&l);
    }
    for (size_t g = 0; g < GROUPS; ++g) {
        printf("group %zu: %g of %d within one stated sigma\n", g, hits[g],
               SEEDS);
        CHECK_WITHIN(limit, hits[g], SEEDS * p, sqrt(SEEDS * p * (1 - p)));
    }
}

int main(void)
{
    const double limit = murk_sidak_limit(1e-6, CHECKS);
    test_light_traced_anew(limit);
    test_batches_tell_the_true_error(limit);
    return check_done();
}
