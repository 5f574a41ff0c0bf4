/* Koschmieder's law: a black target against a level horizon loses its contrast
 * as exp(-extinction * distance) in haze that is lit alike all along the path;
 * at 3.912 / extinction, the visibility, 2 % of it is left, and 5 % at the
 * meteorological optical range, 2.996 / extinction (Koschmieder, Beitr. Phys.
 * Freien Atmos. 12 (1924) 33; Middleton, Vision through the Atmosphere, 1952,
 * ch. 4).
 *
 * What is tested: the light that haze scatters towards the eye, collected from
 * the tracer's scattering events by the phase function and the transmittance
 * from each to the eye, which is what a camera in haze sees of it. The haze
 * only scatters and lies in a room of alike walls, which holds the same
 * radiance everywhere (test_identities.c): so the horizon is the wall, and
 * lighting is as level as the law asks. The target is a thought: behind its
 * distance nothing is collected. (A real one would cast a shadow, which the law
 * leaves out.)
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). Teeth: at
 * its visibility, 5 % must be refused, and a law of a tenth more extinction. */
#include "base/stats.h"
#include "check.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS      600000
#define WALLS        0.6
#define VISIBILITY_M 8.0
#define TWO_PERCENT  3.912 /* -ln .02 */
#define FIVE_PERCENT 2.996 /* -ln .05 */
#define EYE_Z_M      1.0
#define DISTANCES    5

static const murk_box interior = {{0, 0, 0}, {2, 2, 12}};
#define WALLS_AREA_M2 104.0
#define SECTION_M2    4.0

static const double distance_m[DISTANCES] = {
    .5, 2, 4, VISIBILITY_M *FIVE_PERCENT / TWO_PERCENT, VISIBILITY_M};

#define Z_TESTS DISTANCES

/* Radiance towards the eye from nearer than each distance, per watt and photon,
 * of the photon under way and of all of them. */
typedef struct eye {
    const test_world *world;
    const murk_phase *phase;
    double now[DISTANCES], sum[DISTANCES], square[DISTANCES];
} eye;

static void close_photon(eye *e)
{
    for (int i = 0; i < DISTANCES; ++i) {
        e->sum[i] += e->now[i];
        e->square[i] += e->now[i] * e->now[i];
        e->now[i] = 0;
    }
}

/* The eye looks up from anywhere at its height: each event is seen from
 * straight below. */
static void see(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    eye *e = context;
    if (event->kind == MURK_EVENT_EMITTED) {
        close_photon(e);
    }
    const double away = event->position.z - EYE_Z_M;
    if (event->kind != MURK_EVENT_MEDIUM || !(away > 0)) {
        return;
    }
    const murk_vec3 at = event->position, eye_at = {at.x, at.y, EYE_Z_M};
    const double mu = -event->direction_in.z;
    const double radiance =
        event->leaving * murk_phase_density(e->phase, mu) *
        murk_media_transmittance(e->world->media, 0, 0, at, eye_at) /
        SECTION_M2;
    for (int i = 0; i < DISTANCES; ++i) {
        e->now[i] += away < distance_m[i] ? radiance : 0;
    }
}

int main(int argc, char **argv)
{
    /* A long closed room of grey walls that shine equally, full of haze
     * that absorbs nothing. */
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    murk_source lamps[TEST_WALLS];
    test_wall_lamps(&interior, lamps);
    const double extinction = TWO_PERCENT / VISIBILITY_M;
    const murk_medium haze = test_medium(extinction, 1, .5);
    const murk_region region = test_everywhere(0);
    const murk_surface_desc walls = test_box(interior.min, interior.max, 0);
    const murk_material white = test_material(WALLS, 0, 0, 0);
    test_world w = test_world_made(
        &(test_setup){.domain = {{{-1, -1, -1}, {3, 3, 13}}, false},
                      .lights = lamps,
                      .n_lights = TEST_WALLS,
                      .surfaces = &walls,
                      .n_surfaces = 1,
                      .materials = &white,
                      .n_materials = 1,
                      .media = &haze,
                      .n_media = 1,
                      .regions = &region,
                      .n_regions = 1});
    /* Trace photons; the eye adds the radiance that each collision sends to
     * it. */
    eye e = {.world = &w, .phase = &haze.phase[0]};
    test_world_trace(&w, PHOTONS, seed, see, &e);
    close_photon(&e);
    /* The radiance of the horizon, which follows from the equilibrium of
     * the room. */
    const double horizon = 1 / (MURK_PI * WALLS_AREA_M2 * (1 - WALLS));
    for (int i = 0; i < DISTANCES; ++i) {
        /* The contrast of a black object at this distance follows the law
         * of Koschmieder. */
        const double mean = e.sum[i] / PHOTONS;
        const double sigma =
            sqrt((e.square[i] / PHOTONS - mean * mean) / (PHOTONS - 1)) /
            horizon;
        const double contrast = mean / horizon - 1;
        const double law = -exp(-extinction * distance_m[i]);
        CHECK_WITHIN(limit, contrast, law, sigma);
        /* The comparison can fail: another extinction is refused, and so is
         * the other of the two thresholds of contrast (5 and 2 %). */
        if (i > 0 && i < 3) {
            CHECK(sigmas_off(contrast, -exp(-1.1 * extinction * distance_m[i]),
                             sigma) > limit);
        } else if (i == 3) {
            CHECK_NEAR(law, -.05, 1e-4);
            CHECK(sigmas_off(contrast, -.02, sigma) > limit);
        } else if (i == 4) {
            CHECK_NEAR(law, -.02, 1e-5);
            CHECK(sigmas_off(contrast, -.05, sigma) > limit);
        }
    }
    test_world_unmade(&w);
    return check_done();
}
