/* Bands do not touch each other: a run of three bands that differ in
 * extinction, albedo, phase function, material and power gives in each what a
 * run of that band alone gives, light by light, and its ledger balances band
 * by band.
 *
 * A photon has one fate, so shares of fates are binomial. The z-tests share a
 * 1e-6 chance of a false alarm per seed (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "stage_text.h"

#include <stdlib.h>

#define PHOTONS 200000 /* of three bands; as many of each alone */
#define BANDS   3
#define LIGHTS  2
#define FATES   3
#define Z_TESTS (LIGHTS * BANDS * FATES + 2 * BANDS)

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

#define WORLD(bands, diffuse, extinction, albedo, phase, power1, power2)      \
    "murk: 1\nbands_nm: " bands "\n"                                          \
    "domain: {min_m: [-2, -2, 0], max_m: [2, 2, 3]}\n"                        \
    "geometry: [{rect: {corner_m: [-2, -2, .5], edge1_m: [4, 0, 0],\n"        \
    "  edge2_m: [0, 4, 0]}}]\n"                                               \
    "materials: {default: {diffuse: " diffuse "}}\n"                          \
    "media: {sea: {extinction_per_m: " extinction ", albedo: " albedo ",\n"   \
    "  phase: " phase "}}\n"                                                  \
    "regions: [{medium: sea, box: {min_m: [-2, -2, 1], max_m: [2, 2, 2]}}]\n" \
    "lights:\n"                                                               \
    "  - {type: point, position_m: [0, 0, 1.5], power_w: " power1 "}\n"       \
    "  - {type: beam, origin_m: [0, 0, 2.9], direction: [0, 0, -1],\n"        \
    "     power_w: " power2 "}\n"

static const char ALL[] =
    WORLD("[450, 532, 650]", "[.2, .5, .8]", "[.5, 1.5, 4]", "[.9, .5, .97]",
          "[rayleigh, {two_hg: [.9, -.4, .8]}, {fournier_forand: [1.1, 4]}]",
          "6", "[3, 2, 1]");
static const char *const ALONE[BANDS] = {
    WORLD("[450]", ".2", ".5", ".9", "rayleigh", "2", "3"),
    WORLD("[532]", ".5", "1.5", ".5", "{two_hg: [.9, -.4, .8]}", "2", "2"),
    WORLD("[650]", ".8", "4", ".97", "{fournier_forand: [1.1, 4]}", "2", "1")};
/* Teeth: a band's albedo and its phase function a little off. */
static const char WRONG_ALBEDO[] =
    WORLD("[650]", ".8", "4", ".95", "{fournier_forand: [1.1, 4]}", "2", "1");
static const char WRONG_PHASE[] =
    WORLD("[650]", ".8", "4", ".97", "{fournier_forand: [1.11, 4]}", "2", "1");

/* Cosines of scattering, by band. */
typedef struct turns {
    double n[BANDS], sum[BANDS], squares[BANDS];
} turns;

static void note(void *context, uint64_t batch, const murk_event *event)
{
    turns *t = context;
    (void)batch;
    if (event->kind == MURK_EVENT_MEDIUM && event->outcome == MURK_SCATTERED) {
        const double mu = murk_dot(event->direction_in, event->direction_out);
        t->n[event->band] += 1;
        t->sum[event->band] += mu;
        t->squares[event->band] += mu * mu;
    }
}

typedef struct run {
    size_t bands;
    uint64_t photons[LIGHTS * BANDS];
    double share[FATES][LIGHTS * BANDS];
    turns turns;
    double mean_cosine[BANDS]; /* as the phase functions tell it */
} run;

static run run_of(const char *text, uint32_t seed)
{
    /* Trace the scene; note the cosines of scattering. */
    run r = {0};
    murk_error err = {0};
    murk_ledger *ledger = NULL;
    murk_stage *stage = stage_text_create(text, NULL);
    CHECK(stage != NULL);
    if (!stage || murk_ledger_create(&ledger, &stage->world, &err)) {
        exit(check_done());
    }
    r.bands = (size_t)stage->world.bands;
    murk_trace trace = murk_stage_trace(stage);
    trace.seed = seed;
    trace.last = PHOTONS;
    trace.sink = note;
    trace.context = &r.turns;
    murk_trace_run(&trace, ledger);
    /* Each light emits the photons dealt to it in each band; every channel
     * balances, and no energy is lost. */
    murk_sources_deal(stage->lights, PHOTONS, r.photons);
    for (size_t c = 0; c < LIGHTS * r.bands; ++c) {
        const int64_t all = ledger->emitted[c];
        CHECK(all == (int64_t)r.photons[c] * MURK_PACKET);
        CHECK(all == ledger->escaped[c] + ledger->absorbed_media[c] +
                         ledger->absorbed_surfaces[c] + ledger->lost[c]);
        CHECK(ledger->lost[c] == 0);
        r.share[0][c] = (double)ledger->escaped[c] / (double)all;
        r.share[1][c] = (double)ledger->absorbed_media[c] / (double)all;
        r.share[2][c] = (double)ledger->absorbed_surfaces[c] / (double)all;
    }
    /* The mean cosine that the phase function states, for comparison with
     * the scattered photons. */
    for (size_t band = 0; band < r.bands; ++band) {
        r.mean_cosine[band] =
            murk_phase_mean_cosine(&stage->phases->medium[0][band]);
    }
    murk_ledger_destroy(ledger);
    stage_text_destroy(stage);
    return r;
}

static double off(const run *all, size_t band, const run *alone, size_t light,
                  int fate)
{
    const size_t c = light * BANDS + band;
    const double n = (double)all->photons[c];
    const double m = (double)alone->photons[light];
    const double a = all->share[fate][c], b = alone->share[fate][light];
    const double p = (a * n + b * m) / (n + m);
    return sigmas_off(a, b, sqrt(p * (1 - p) * (1 / n + 1 / m)));
}

/* The farthest of a band's shares. */
static double farthest(const run *all, size_t band, const run *alone)
{
    double max = 0;
    for (size_t light = 0; light < LIGHTS; ++light) {
        for (int fate = 0; fate < FATES; ++fate) {
            max = fmax(max, off(all, band, alone, light, fate));
        }
    }
    return max;
}

static double mean_off(const run *r, size_t band, double want)
{
    const turns *t = &r->turns;
    const double mean = t->sum[band] / t->n[band];
    const double variance = t->squares[band] / t->n[band] - mean * mean;
    return sigmas_off(mean, want, sqrt(variance / t->n[band]));
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    const run all = run_of(ALL, seed);
    CHECK(all.bands == BANDS);
    for (size_t band = 0; band < BANDS; ++band) {
        const run alone = run_of(ALONE[band], seed + 1 + (uint32_t)band);
        CHECK(alone.bands == 1);
        CHECK(farthest(&all, band, &alone) < limit());
        CHECK(mean_off(&all, band, all.mean_cosine[band]) < limit());
        CHECK(mean_off(&alone, 0, alone.mean_cosine[0]) < limit());
        CHECK(alone.mean_cosine[0] == all.mean_cosine[band]);
    }
    const run wrong = run_of(WRONG_ALBEDO, seed);
    CHECK(farthest(&all, 2, &wrong) > 2 * limit());
    const run turned = run_of(WRONG_PHASE, seed);
    CHECK(mean_off(&turned, 0, all.mean_cosine[2]) > 2 * limit());
    return check_done();
}
