/* What `emit` and `store` promise: how many photons are emitted, which are
 * kept, and that the ledger is of just those; and the candidates that murk
 * lays when the scene gives none. */
#include "base/interrupt.h"
#include "check.h"
#include "stage_text.h"
#include "study/plan.h"

#include <stdlib.h>

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry: [{box: {min_m: [0.01, 0.01, 0.01], max_m: [3.99, 3.99, 2.99]},"
    " material: wall}]\n"
    "materials: {wall: {diffuse: 0.5}}\n"
    "media: {fog: {extinction_per_m: 0.3, albedo: 1}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [1, 1, 2.5], power_w: 8}\n"
    "  - {type: point, position_m: [3, 3, 2.5], power_w: 0.001}\n"
    "photons: {emit: 2000}\n"
    "sensors: {types: [{name: node, range_m: 2}], candidates: {}, count: 1}\n";

static murk_status trace(murk_traced **traced, murk_stage **stage,
                         const char *one, const char *two, unsigned threads,
                         murk_error *err)
{
    const char *const overrides[] = {one, two, NULL};
    *traced = NULL;
    *stage = stage_text_create(scene_text, overrides);
    return *stage ? murk_light_trace(traced, *stage, 0, threads, err)
                  : MURK_RUN_FAILED;
}

static void release(murk_traced *traced, murk_stage *stage)
{
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
}

static size_t records(const murk_traced *traced)
{
    return murk_photon_map_count(traced->surface) +
           murk_photon_map_count(traced->volume);
}

/* Records of photons [0, n) in one map. */
static size_t records_below(const murk_photon_map *map, uint64_t n)
{
    size_t found = 0;
    for (size_t i = 0; i < murk_photon_map_count(map); ++i) {
        found += murk_photon_map_photons(map)[i].emitted < n;
    }
    return found;
}

/* `store N` is the first photons of a longer run, cut where N is reached: the
 * last photon is whole, and without it there are fewer than N. */
static void test_store_is_a_prefix(void)
{
    murk_traced *stored, *longer;
    murk_stage *stage, *longer_stage;
    murk_error err = {0};
    const uint64_t wanted = 3000;
    CHECK(!trace(&stored, &stage, "photons.store=3000", "seed=1", 2, &err));
    CHECK(
        !trace(&longer, &longer_stage, "photons.emit=9000", "seed=1", 2, &err));
    if (stored && longer) {
        const uint64_t n = stored->emitted;
        CHECK(n < 9000);
        CHECK(records(stored) >= wanted);
        CHECK(records_below(stored->surface, n - 1) +
                  records_below(stored->volume, n - 1) <
              wanted);
        CHECK(records_below(longer->surface, n) ==
              murk_photon_map_count(stored->surface));
        CHECK(records_below(longer->volume, n) ==
              murk_photon_map_count(stored->volume));
        CHECK((uint64_t)murk_tally_read(&stored->ledger->photons) == n);
        CHECK(murk_ledger_imbalance(stored->ledger) == 0);
    }
    release(stored, stage);
    release(longer, longer_stage);
}

/* All packets of a light have its power over the number dealt to it, also the
 * one packet of a lamp that hardly shines. */
static void test_packets_add_up_to_the_lamps(void)
{
    murk_traced *traced;
    murk_stage *stage;
    murk_error err = {0};
    CHECK(!trace(&traced, &stage, "photons.emit=2000", "seed=1", 2, &err));
    if (traced) {
        for (size_t c = 0; c < 2; ++c) {
            const double packets =
                (double)murk_tally_read(&traced->ledger->emitted[c]) /
                (double)MURK_PACKET;
            CHECK(packets >= 1);
            CHECK_NEAR(packets * traced->packet_w[c], c ? 0.001 : 8, 1e-12);
        }
    }
    release(traced, stage);
}

static void expect_refusal(const char *one, const char *two, murk_status status,
                           const char *part)
{
    murk_traced *traced;
    murk_stage *stage;
    murk_error err = {0};
    CHECK(trace(&traced, &stage, one, two, 2, &err) == status);
    CHECK(traced == NULL);
    CHECK_MENTIONS(err.text, part);
    release(traced, stage);
}

static void test_refusals(void)
{
    /* dark walls, clear air: nothing to store, ever */
    expect_refusal("photons={store: 7, maps: surface}",
                   "materials.wall.diffuse=0", MURK_RUN_FAILED,
                   "of 7000 photons emitted only 0 of 7");
    expect_refusal("photons={emit: 2000, max_stored: 100}", "seed=1",
                   MURK_BAD_VALUE, "max_stored allows 100");
    expect_refusal("photons={emit: 1}", "seed=1", MURK_BAD_VALUE,
                   "must be at least 2");
    /* white walls and a white fog: light that nothing ends */
    expect_refusal("photons={emit: 2, maps: none}", "materials.wall.diffuse=1",
                   MURK_BAD_VALUE, "does not end");
    /* nearly so: half of the light is lost to the cap on events */
    expect_refusal("photons={emit: 20, maps: none}",
                   "materials.wall.diffuse=0.99998", MURK_RUN_FAILED,
                   "were lost");
}

static void test_laid_candidates(void)
{
    murk_error err = {0};
    murk_candidates *candidates = NULL;
    murk_stage *stage = stage_text_create(scene_text, NULL);
    CHECK(stage && !murk_sites_find(&candidates, stage, 2, &err));
    if (candidates) {
        /* 4 x 4 x 3 m in cells of .3634 m: 11 x 11 x 8 */
        CHECK(candidates->asked == 11 * 11 * 8);
        CHECK(candidates->usable == candidates->asked);
        CHECK_NEAR(candidates->position[0].x, 2.0 / 11, 1e-12);
        CHECK_NEAR(candidates->position[0].z, 1.5 / 8, 1e-12);
    }
    murk_candidates_destroy(candidates);
    stage_text_destroy(stage);
}

/* Ctrl-C in the pilot ends the run there, with nothing stored. Last: the flag
 * stays up. */
static void test_interrupt_in_the_pilot(void)
{
    murk_stage *stage = stage_text_create(scene_text, NULL);
    murk_forecast forecast = {.pilot_photons = 7};
    murk_traced *traced = NULL;
    murk_error err = {0};
    CHECK(stage != NULL);
    murk_interrupt_request();
    CHECK(stage && murk_light_forecast(&forecast, stage, 0, 2, &err) ==
                       MURK_INTERRUPTED);
    CHECK(forecast.pilot_photons == 7);
    CHECK(stage &&
          murk_light_trace(&traced, stage, 0, 2, &err) == MURK_INTERRUPTED);
    CHECK(traced == NULL);
    stage_text_destroy(stage);
}

int main(void)
{
    test_store_is_a_prefix();
    test_packets_add_up_to_the_lamps();
    test_refusals();
    test_laid_candidates();
    test_interrupt_in_the_pilot();
    return check_done();
}
