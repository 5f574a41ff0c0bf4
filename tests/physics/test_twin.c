/* The tracer and its simple twin (tests/support/plain_tracer.h) agree on where
 * photons end in a box of fog and around a ball of other matter, and both with
 * the published answers for the cube B1: absorbed .17700, back through the lit
 * face .81498, through the far face .000125 (an independent voxel tracer's, 1e8
 * photons).
 *
 * The z-tests of a run share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "plain_tracer.h"
#include "worlds.h"

#include <stdlib.h>

#define PHOTONS 40000
#define Z_TESTS 25

typedef struct ends {
    double escaped[6]; /* below and above on x, y, z */
} ends;

static void count_end(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    ends *e = context;
    if (event->kind != MURK_EVENT_ESCAPED) {
        return;
    }
    const murk_vec3 p = event->position;
    const bool at[6] = {p.x == 0,  p.x == 60, p.y == 0,
                        p.y == 60, p.z == 0,  p.z == 60};
    for (int side = 0; side < 6; ++side) {
        if (at[side]) {
            ++e->escaped[side];
            return;
        }
    }
}

typedef struct answer {
    double absorbed, collisions;
    ends ends;
} answer;

static answer murk_answer(const plain_box *b, uint32_t seed)
{
    /* The box of the twin as a world of murk: coefficients become
     * extinction and albedo, and the ball replaces the matter around it. */
    const double extinction =
        b->matter.absorption_per_m + b->matter.scattering_per_m;
    const murk_source beam =
        test_beam(murk_vec(b->start_m[0], b->start_m[1], b->start_m[2]),
                  murk_vec(b->direction[0], b->direction[1], b->direction[2]));
    const double in_ball = b->ball.absorption_per_m + b->ball.scattering_per_m;
    const murk_medium media[] = {
        test_medium(extinction, b->matter.scattering_per_m / extinction,
                    b->matter.mean_cosine),
        test_medium(in_ball,
                    in_ball > 0 ? b->ball.scattering_per_m / in_ball : 0,
                    b->ball.mean_cosine)};
    const murk_vec3 center = {b->center_m[0], b->center_m[1], b->center_m[2]};
    const murk_region regions[] = {test_everywhere(0),
                                   {.medium = 1,
                                    .shape = MURK_REGION_SPHERE,
                                    .center = center,
                                    .radius_m = b->radius_m,
                                    .replaces = true,
                                    .to_world = murk_affine_identity(),
                                    .where = "ball"}};
    /* Without a radius there is no ball. */
    const size_t n = b->radius_m > 0 ? 2 : 1;
    test_world w = test_world_made(
        &(test_setup){.domain = {{{0, 0, 0}, {60, 60, 60}}, false},
                      .lights = &beam,
                      .n_lights = 1,
                      .media = media,
                      .n_media = n,
                      .regions = regions,
                      .n_regions = n});
    /* Count where photons end; every photon is absorbed or escapes. */
    answer out = {0};
    test_world_trace(&w, PHOTONS, seed, count_end, &out.ends);
    out.absorbed = test_photons(&w, w.ledger->absorbed_media);
    out.collisions = (double)murk_tally_read(&w.ledger->collisions);
    double escaped = 0;
    for (int side = 0; side < 6; ++side) {
        escaped += out.ends.escaped[side];
    }
    CHECK(out.absorbed + escaped == PHOTONS);
    test_world_unmade(&w);
    return out;
}

/* Two independent counts of n photons each. */
static double sigmas_between(double a, double b)
{
    const double p = (a + b) / (2. * PHOTONS);
    return a == b ? 0 : fabs(a - b) / sqrt(2 * PHOTONS * p * (1 - p));
}

static double limit(void)
{
    return murk_sidak_limit(1e-6, Z_TESTS);
}

static void test_cube_b1(uint32_t seed)
{
    const plain_box cube = {.size_m = {60, 60, 60},
                            .start_m = {30.1, 30.2, 0},
                            .direction = {0, 0, 1},
                            .matter = {.005, 1, .01},
                            .majorant_per_m = 1.005};
    const answer a = murk_answer(&cube, seed);
    const double n = PHOTONS;
    CHECK_WITHIN(limit(), a.absorbed / n, .17700, sqrt(.177 * .823 / n));
    CHECK_WITHIN(limit(), a.ends.escaped[4] / n, .81498,
                 sqrt(.81498 * .18502 / n));
    /* Each collision absorbs with probability 1 / 201: given the collisions,
     * the absorbed count is nearly Poisson. */
    CHECK_WITHIN(limit(), a.absorbed, a.collisions / 201,
                 sqrt(a.collisions / 201));
    /* Teeth: absorption 20 % higher. */
    plain_box wrong = cube;
    wrong.matter.absorption_per_m = .006;
    CHECK(sigmas_off(murk_answer(&wrong, seed).absorbed / n, .17700,
                     sqrt(.177 * .823 / n)) > limit());
}

/* Slanted into forward-scattering fog, off the middle, with null collisions in
 * the twin: all sides get their part. */
static void test_twin_agrees(uint32_t seed)
{
    const plain_box fog = {.size_m = {60, 60, 60},
                           .start_m = {20, 35, 10},
                           .direction = {0.6, 0.48, 0.64},
                           .matter = {.004, .06, .7},
                           .majorant_per_m = .08};
    const answer a = murk_answer(&fog, seed);
    const plain_result b = plain_trace(&fog, PHOTONS, seed);
    CHECK(sigmas_between(a.absorbed, (double)b.absorbed) < limit());
    for (int side = 0; side < 6; ++side) {
        CHECK(sigmas_between(a.ends.escaped[side],
                             (double)b.escaped[side / 2][side % 2]) < limit());
    }
    /* Teeth: g off by .1 shows in the light that goes on upwards. */
    plain_box wrong = fog;
    wrong.matter.mean_cosine = .6;
    const answer c = murk_answer(&wrong, seed);
    double worst = 0;
    for (int side = 0; side < 6; ++side) {
        worst =
            fmax(worst, sigmas_between(c.ends.escaped[side],
                                       (double)b.escaped[side / 2][side % 2]));
    }
    CHECK(worst > limit());
}

/* A ball that takes the place of the cube's matter. */
static void test_a_ball_in_the_cube(uint32_t seed)
{
    const plain_box cube = {.size_m = {60, 60, 60},
                            .start_m = {30.1, 30.2, 13},
                            .direction = {0, 0, 1},
                            .matter = {.005, 1, .01},
                            .majorant_per_m = 5.002,
                            .center_m = {30, 30, 30},
                            .radius_m = 15,
                            .ball = {.002, 5, .9}};
    const answer a = murk_answer(&cube, seed);
    const plain_result b = plain_trace(&cube, PHOTONS, seed);
    CHECK(sigmas_between(a.absorbed, (double)b.absorbed) < limit());
    for (int side = 0; side < 6; ++side) {
        CHECK(sigmas_between(a.ends.escaped[side],
                             (double)b.escaped[side / 2][side % 2]) < limit());
    }
    /* Teeth: a ball that absorbs at a sixth of what it meets. */
    plain_box wrong = cube;
    wrong.ball.absorption_per_m = 1;
    CHECK(sigmas_between(murk_answer(&wrong, seed).absorbed,
                         (double)b.absorbed) > limit());
}

int main(int argc, char **argv)
{
    const uint32_t seed = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1;
    test_cube_b1(seed);
    test_twin_agrees(seed);
    test_a_ball_in_the_cube(seed);
    return check_done();
}
