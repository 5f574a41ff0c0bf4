/* What `emit` and `store` promise: how many photons are emitted, which are
 * kept, and that the ledger is of just those; and the candidates that murk
 * lays when the scene gives none. */
#include "base/interrupt.h"
#include "base/log.h"
#include "check.h"
#include "plan/plan.h"
#include "stage_text.h"

#include <stdlib.h>
#include <string.h>

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
    return *stage ? murk_lightmap_trace(traced, *stage, 0, threads, err)
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

/* `store N` gives the first photons of a longer run, up to the photon that
 * reaches N records: the last photon is complete, and without it there are
 * fewer than N records. */
static void test_store_is_a_prefix(void)
{
    /* A run that stops at a number of records, and a longer run with the
     * same seed. */
    murk_traced *stored, *longer;
    murk_stage *stage, *longer_stage;
    murk_error err = {0};
    const uint64_t wanted = 3000;
    CHECK(!trace(&stored, &stage, "photons.store=3000", "seed=1", 2, &err));
    CHECK(
        !trace(&longer, &longer_stage, "photons.emit=9000", "seed=1", 2, &err));
    if (stored && longer) {
        /* The last photon brings the number of records to the limit. */
        const uint64_t n = stored->emitted;
        CHECK(n < 9000);
        CHECK(records(stored) >= wanted);
        CHECK(records_below(stored->surface, n - 1) +
                  records_below(stored->volume, n - 1) <
              wanted);
        /* Both runs have the same number of records of the shared photons,
         * and the ledger counts just these photons. */
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

/* ---- forecast ---- */

static murk_forecast predicted(const char *one, const char *two)
{
    const char *const overrides[] = {one, two, NULL};
    murk_stage *stage = stage_text_create(scene_text, overrides);
    murk_forecast forecast = {0};
    murk_error err = {0};
    CHECK(stage && !murk_lightmap_forecast(&forecast, stage, 0, 2, &err));
    stage_text_destroy(stage);
    return forecast;
}

/* The pilot's photons are the first of the run: of a short run all is known, of
 * a longer one as much as the pilot stands for. */
static void test_a_forecast_is_the_pilot_many_times(void)
{
    const murk_forecast brief = predicted("photons.emit=500", NULL);
    murk_traced *traced;
    murk_stage *stage;
    murk_error err = {0};
    CHECK(!trace(&traced, &stage, "photons.emit=500", NULL, 2, &err));
    CHECK(brief.pilot_photons == 500 && brief.emitted == 500);
    if (traced) {
        const double surface = (double)murk_photon_map_count(traced->surface);
        const double volume = (double)murk_photon_map_count(traced->volume);
        CHECK(surface > 100 && volume > 100 && surface != volume);
        CHECK(brief.surface == surface && brief.volume == volume);
        CHECK(brief.memory_bytes > sizeof(murk_photon) * (surface + volume));
    }
    release(traced, stage);
    const murk_forecast whole = predicted("photons.emit=1000000", NULL);
    const double n = (double)whole.pilot_photons;
    CHECK(n > 500 && n < 1000000 && whole.emitted == 1000000);
    const murk_forecast pilot = predicted("photons.emit=4000000000", NULL);
    CHECK(pilot.pilot_photons == whole.pilot_photons);
    CHECK_NEAR(pilot.surface / 4e9, whole.surface / 1e6, 1e-9);
    CHECK_NEAR(pilot.volume / 4e9, whole.volume / 1e6, 1e-9);
    CHECK_NEAR(whole.surface / 1e6, brief.surface / 500, 0.2);
    CHECK_NEAR(whole.volume / 1e6, brief.volume / 500, 0.2);
    /* store: as many photons as these records take */
    const murk_forecast stored = predicted("photons.store=5000000", NULL);
    CHECK_NEAR(stored.surface + stored.volume, 5e6, 1e-3);
    CHECK_NEAR(stored.emitted * (whole.surface + whole.volume),
               5e6 * whole.emitted, 1e-3 * whole.emitted);
    CHECK_NEAR(stored.surface / stored.volume, whole.surface / whole.volume,
               1e-9);
}

/* max_stored is of both maps together. */
static void test_max_stored_counts_both_maps(void)
{
    const murk_forecast brief = predicted("photons.emit=500", NULL);
    char max[64];
    snprintf(max, sizeof max, "photons={emit: 500, max_stored: %.0f}",
             brief.surface + brief.volume - 1);
    expect_refusal(max, NULL, MURK_BAD_VALUE, "would be stored");
    snprintf(max, sizeof max, "photons={emit: 500, max_stored: %.0f}",
             brief.surface + brief.volume);
    CHECK(predicted(max, NULL).surface == brief.surface);
    murk_traced *traced;
    murk_stage *stage;
    murk_error err = {0};
    CHECK(!trace(&traced, &stage, max, NULL, 2, &err));
    release(traced, stage);
}

static char warning[512];

static void keep_warning(const char *where, const char *text)
{
    (void)where;
    snprintf(warning, sizeof warning, "%s", text);
}

/* One beam of the given power leaves the domain, and one of 1 W meets a
 * black floor. Photons are drawn by power, but the escaped shares are known
 * for each light. */
static void check_escape(const char *watts, double share, const char *said)
{
    /* Two beams in clear air, the first upward to the open side, the second
     * down to a black floor. */
    char beam[100];
    snprintf(beam, sizeof beam, "lights.0.power_w=%s", watts);
    const char *const overrides[] = {
        "lights=[{type: beam, origin_m: [2, 2, 1], direction: [0, 0, 1], "
        "power_w: 1}, {type: beam, origin_m: [2, 2, 1], direction: [0, 0, "
        "-1], power_w: 1}]",
        "geometry=[{rect: {corner_m: [0, 0, 0.5], edge1_m: [4, 0, 0], "
        "edge2_m: [0, 4, 0]}, material: wall}]",
        "materials.wall.diffuse=0",
        "media.fog.extinction_per_m=0",
        beam,
        NULL};
    /* The forecast knows the share of power that leaves the domain. */
    murk_stage *stage = stage_text_create(scene_text, overrides);
    murk_forecast forecast = {0};
    murk_error err = {0};
    CHECK(stage && !murk_lightmap_forecast(&forecast, stage, 0, 2, &err));
    CHECK_NEAR(forecast.escaped_share, share, 1e-12);
    /* A warning is given only where one is expected. */
    const murk_warn_sink before = murk_warn_to(keep_warning);
    warning[0] = 0;
    murk_warn_of_escape(stage, forecast.escaped_share);
    (void)murk_warn_to(before);
    CHECK(said ? strstr(warning, said) != NULL : warning[0] == 0);
    stage_text_destroy(stage);
}

static void test_escaped_light_is_by_power(void)
{
    check_escape("3", 0.75, "75 % of the lamps' light escapes");
    check_escape("1.1", 1.1 / 2.1, "52 % of the lamps' light escapes");
    check_escape("0.9", 0.9 / 1.9, NULL);
}

static void test_mounted_candidates(void)
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
    CHECK(stage && murk_lightmap_forecast(&forecast, stage, 0, 2, &err) ==
                       MURK_INTERRUPTED);
    CHECK(forecast.pilot_photons == 7);
    CHECK(stage &&
          murk_lightmap_trace(&traced, stage, 0, 2, &err) == MURK_INTERRUPTED);
    CHECK(traced == NULL);
    stage_text_destroy(stage);
}

int main(void)
{
    test_store_is_a_prefix();
    test_packets_add_up_to_the_lamps();
    test_refusals();
    test_a_forecast_is_the_pilot_many_times();
    test_max_stored_counts_both_maps();
    test_escaped_light_is_by_power();
    test_mounted_candidates();
    test_interrupt_in_the_pilot();
    return check_done();
}
