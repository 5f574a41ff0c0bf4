/* The ledger by absorber: each medium and each material is booked for the
 * quanta that end in it, and for no other's, by march and by delta tracking,
 * with and without weights. The shares are Beer's law, the books are compared
 * with the events to the quantum. A fixed seed; the z-tests share a 1e-6 chance
 * of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <string.h>

#define PHOTONS 20000
#define MEDIA   3
#define Z_TESTS (2 * 2 * MEDIA) /* by flight, by weight, by medium */

static const murk_domain cell = {{{0, 0, 0}, {1, 1, 3}}, false};

/* What the events say that media and materials absorbed [packets]. */
typedef struct absorbed {
    double medium[MEDIA], material[2];
    double misplaced; /* events whose medium is not at their place */
} absorbed;

/* Media 0 and 1 overlap in 1 <= z < 2, medium 2 fills 2 <= z < 3. */
static bool is_there(int medium, double z)
{
    return medium == 2 ? z >= 2 : z >= 1 && z <= 2;
}

static void note(void *context, uint64_t batch, const murk_event *e)
{
    absorbed *sums = context;
    (void)batch;
    const double lost = e->weight - e->leaving;
    if (e->kind == MURK_EVENT_MEDIUM) {
        sums->medium[e->material_or_medium] += lost;
        sums->misplaced += !is_there(e->material_or_medium, e->position.z);
    } else if (e->kind == MURK_EVENT_SURFACE) {
        sums->material[e->material_or_medium] += lost;
    }
}

/* A beam straight up through two media that overlap over 1 m, then through .75
 * m of a third up to a black lid of the second material. */
static void test_each_absorber_is_booked(bool by_delta, double least_weight)
{
    const murk_source beam = test_beam(murk_vec(.5, .5, .5), murk_vec(0, 0, 1));
    const murk_material materials[2] = {test_material(0, 0, 0, 0),
                                        test_material(0, 0, 0, 0)};
    const murk_surface_desc lid = test_rect(
        murk_vec(0, 0, 2.75), murk_vec(1, 0, 0), murk_vec(0, 1, 0), 1);
    const murk_medium media[MEDIA] = {test_medium(.6, .25, .999),
                                      test_medium(.9, .75, .999),
                                      test_medium(1.2, 0, 0)};
    const murk_region regions[MEDIA] = {
        test_box_region(0, murk_vec(0, 0, 1), murk_vec(1, 1, 2)),
        test_box_region(1, murk_vec(0, 0, 1), murk_vec(1, 1, 2)),
        test_box_region(2, murk_vec(0, 0, 2), murk_vec(1, 1, 3))};
    const test_setup setup = {.domain = cell,
                              .lights = &beam,
                              .n_lights = 1,
                              .surfaces = &lid,
                              .n_surfaces = 1,
                              .materials = materials,
                              .n_materials = 2,
                              .media = media,
                              .n_media = MEDIA,
                              .regions = regions,
                              .n_regions = MEDIA};
    test_world w = test_world_made(&setup);
    murk_error err = {0};
    CHECK(murk_media_prepare_delta(w.media, &err) == MURK_OK);
    absorbed sums = {{0}, {0}, 0};
    murk_trace trace = murk_trace_defaults();
    trace.world = &w.world;
    trace.seed = 7;
    trace.last = PHOTONS;
    trace.by_delta = by_delta;
    trace.least_weight = least_weight;
    trace.sink = note;
    trace.context = &sums;
    murk_trace_run(&trace, w.ledger);

    /* To the quantum, what the events say. A packet is 2^k quanta and an
     * event's share is exact, so are the sums. */
    CHECK(sums.misplaced == 0);
    for (size_t m = 0; m < MEDIA; ++m) {
        CHECK_NEAR((double)murk_ledger_by_medium(w.ledger, 0, m) /
                       (double)MURK_PACKET,
                   sums.medium[m], 1e-6);
        CHECK(sums.medium[m] > 0);
    }
    CHECK(murk_ledger_by_material(w.ledger, 0, 0) == 0);
    CHECK_NEAR((double)murk_ledger_by_material(w.ledger, 0, 1) /
                   (double)MURK_PACKET,
               sums.material[1], 1e-6);

    /* Beer's law with absorption alone, as g = .999 keeps the beam straight to
     * 1e-3: a = .6 * .75 and .9 * .25 together, then 1.2 over .75 m. */
    const double a0 = .45, a1 = .225, first = 1 - exp(-(a0 + a1));
    const double want[MEDIA] = {first * a0 / (a0 + a1), first * a1 / (a0 + a1),
                                (1 - first) * (1 - exp(-.9))};
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    for (size_t m = 0; m < MEDIA; ++m) {
        /* roulette is binomial; weights have less spread */
        CHECK_WITHIN(limit, sums.medium[m] / PHOTONS, want[m],
                     sqrt(want[m] * (1 - want[m]) / PHOTONS));
    }
    test_world_unmade(&w);
}

int main(void)
{
    test_each_absorber_is_booked(false, 1);
    test_each_absorber_is_booked(false, 1e-3);
    test_each_absorber_is_booked(true, 1);
    test_each_absorber_is_booked(true, 1e-3);
    return check_done();
}
