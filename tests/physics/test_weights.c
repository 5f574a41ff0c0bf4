/* A slab under photons that carry weights down to a least one: the same
 * reflectance and transmittance as in the tables, the ledger exact to the
 * quantum, and a smaller error where much is absorbed deep inside.
 *
 * Source of the numbers: adding-doubling (van de Hulst, Multiple Light
 * Scattering, 1980, ch. 4), 64 to 120 nodes a hemisphere, good to the last
 * digit.
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). Teeth: an
 * albedo off by 8 % must fail. */
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS 40000

typedef struct slab {
    double albedo, g, tau, reflected, transmitted;
} slab;

static const slab slabs[] = {
    {.5, 0, 1, .099119, .446058},
    {.9, .75, 2, .09739, .66096},
    {.2, 0, 5, .035230, .008082},
};

static const double min_weights[] = {1, .3, 1e-2, MURK_MIN_WEIGHT_MIN};

#define SLABS   (sizeof slabs / sizeof slabs[0])
#define WEIGHTS (sizeof min_weights / sizeof min_weights[0])
#define Z_TESTS (2 * SLABS * WEIGHTS)

typedef struct ends {
    double *back, *through; /* by photon */
} ends;

static void count_end(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    const ends *e = context;
    if (event->kind == MURK_EVENT_ESCAPED) {
        double *side = event->position.z == 0 ? e->back : e->through;
        side[event->photon] += event->weight;
    }
}

typedef struct shares {
    murk_estimate back, through;
} shares;

static shares traced(const slab *s, double albedo, double least_weight,
                     uint32_t seed)
{
    const murk_source light = test_beam(murk_vec(.1, .2, 0), murk_vec(0, 0, 1));
    const murk_medium fog = test_medium(s->tau, albedo, s->g);
    const murk_region region = test_everywhere(0);
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-.5, -.5, 0}, {.5, .5, 1}}, true},
                      .lights = &light,
                      .n_lights = 1,
                      .media = &fog,
                      .n_media = 1,
                      .regions = &region,
                      .n_regions = 1});
    ends e = {calloc(PHOTONS, sizeof *e.back), calloc(PHOTONS, sizeof *e.back)};
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.seed = seed;
    trace.last = PHOTONS;
    trace.least_weight = least_weight;
    trace.sink = count_end;
    trace.context = &e;
    murk_trace_run(&trace, w.ledger);
    const shares out = {murk_mean_estimate(e.back, PHOTONS),
                        murk_mean_estimate(e.through, PHOTONS)};
    CHECK(murk_ledger_imbalance(w.ledger) == 0);
    CHECK(test_photons(&w, w.ledger->emitted) == PHOTONS);
    /* The ledger speaks of the same quanta as the events. */
    CHECK_NEAR((double)murk_tally_read(&w.ledger->escaped[0]) /
                   (double)MURK_PACKET / PHOTONS,
               out.back.value + out.through.value, 1e-12);
    free(e.back);
    free(e.through);
    test_world_unmade(&w);
    return out;
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    double error[SLABS][WEIGHTS];
    for (size_t i = 0; i < SLABS; ++i) {
        const slab *s = &slabs[i];
        for (size_t k = 0; k < WEIGHTS; ++k) {
            const shares got = traced(s, s->albedo, min_weights[k], seed);
            CHECK_WITHIN(limit, got.back.value, s->reflected,
                         got.back.standard_error);
            CHECK_WITHIN(limit, got.through.value, s->transmitted,
                         got.through.standard_error);
            error[i][k] = got.back.standard_error;
        }
    }
    /* Much is absorbed: weights must pay, photon for photon. */
    CHECK(error[2][2] < error[2][0] / 2);
    const shares wrong = traced(&slabs[0], .54, 1e-2, seed);
    CHECK(sigmas_off(wrong.back.value, slabs[0].reflected,
                     wrong.back.standard_error) > limit);
    return check_done();
}
