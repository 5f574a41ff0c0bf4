/* How robust a placement is, where it can be worked out.
 *
 * 3 z-tests share a chance of 1e-6 of a false alarm per seed (Sidak); the seed
 * is fixed, so the verdict repeats. */
#include "plan/robust.h"

#include "../sensing/world.h"
#include "base/rng.h"
#include "base/stats.h"

#define CHECKS 3
#define BUDGET 1e-6
#define DRAWS  4000

static const murk_domain hall = {.box = {{0, 0, 0}, {20, 20, 20}}};
static const murk_vec3 none = {0, 0, 0};

typedef struct world {
    murk_scene_desc scene;
    murk_stage stage;
    murk_photon_map *surface_map, *volume_map;
    murk_sight *sight;
} world;

static void build(world *w, const murk_sensor_type *type,
                  const murk_photon *photon, size_t n, double jitter_m,
                  double jitter_rad, unsigned threads)
{
    /* Volume records alone, in an empty hall with clear air. */
    *w = (world){.surface_map = map_of(NULL, 0),
                 .volume_map = map_of(photon, n)};
    /* The jitter of poses that the test asks for. */
    w->scene.seed = 11;
    w->scene.north = murk_vec(0, 1, 0);
    w->scene.placement.jitter_m = jitter_m;
    w->scene.placement.jitter_rad = jitter_rad;
    w->scene.placement.jitter_draws = DRAWS;
    w->stage = (murk_stage){.scene = &w->scene,
                            .world.domain = hall,
                            .surfaces = surfaces_of(NULL, 0),
                            .media = clear_air(&hall)};
    /* A sight of all records. */
    const murk_sight_desc desc = {.surfaces = w->stage.surfaces,
                                  .media = w->stage.media,
                                  .domain = hall,
                                  .surface_map = w->surface_map,
                                  .volume_map = w->volume_map,
                                  .photons_emitted = n,
                                  .type = type,
                                  .types = 1,
                                  .through_sheets = true,
                                  .weights = {.balanced = true},
                                  .threads = threads};
    murk_error err = {0};
    CHECK(murk_sight_create(&w->sight, &desc, &err) == MURK_OK);
}

static void tear_down(world *w)
{
    murk_sight_destroy(w->sight);
    murk_photon_map_destroy(w->surface_map);
    murk_photon_map_destroy(w->volume_map);
    murk_media_destroy(w->stage.media);
    murk_surfaces_destroy(w->stage.surfaces);
}

static murk_robust measure(world *w, const murk_pose *pose, size_t n,
                           murk_coverage_result *coverage)
{
    murk_robust robust = {0};
    murk_error err = {0};
    CHECK(!murk_coverage_result_measure(coverage, w->sight, pose, n, &err));
    CHECK(!murk_robust_begin(&robust, &w->stage, pose, n, coverage, &err));
    CHECK(!murk_robust_jitter(&robust, &w->stage, w->sight, pose, coverage,
                              false, &err));
    CHECK_TEXT(err.text, "");
    return robust;
}

/* Volume of what a ball of radius s and one of radius r have in common, their
 * middles d apart (Weisstein, Sphere-Sphere Intersection, MathWorld). */
static double lens(double s, double r, double d)
{
    const double h = r + s - d;
    return MURK_PI * h * h *
           (d * d + 2 * d * s - 3 * s * s + 2 * d * r + 6 * s * r - 3 * r * r) /
           (12 * d);
}

/* One photon at 1.6 m, range 2 m: in sight as planned, and from as much of the
 * ball of 0.8 m as lies within 2 m of the photon. */
static void test_a_lens(void)
{
    const double limit = murk_sidak_limit(BUDGET, CHECKS);
    const double ball = 4 * MURK_PI / 3 * 0.8 * 0.8 * 0.8;
    const double share = lens(0.8, 2, 1.6) / ball;
    const double sigma = sqrt(share * (1 - share) / DRAWS);
    const murk_sensor_type type = all_round(2);
    const murk_photon photon = a_photon(murk_vec(10, 11.6, 10), none, 0);
    const murk_pose pose = {.position = {10, 10, 10}};
    world w;
    murk_coverage_result c = {0};
    build(&w, &type, &photon, 1, 0.8, 0, 2);
    murk_robust r = measure(&w, &pose, 1, &c);
    CHECK(r.jittered.draws == DRAWS && !r.jittered.on_held_out);
    CHECK(r.jittered.as_planned == 1 && r.jittered.unmoved == 0);
    CHECK_WITHIN(limit, r.jittered.mean.value, share, sigma);
    CHECK(r.jittered.quantile == 0);
    /* Teeth: a shell in place of a ball. */
    const double boundary =
        (2 * 2 - (1.6 - 0.8) * (1.6 - 0.8)) / (4 * 0.8 * 1.6);
    CHECK(sigmas_off(r.jittered.mean.value, boundary, sigma) > 2 * limit);
    murk_robust_release(&r);
    murk_coverage_result_release(&c);
    tear_down(&w);
}

/* A cone of 60 degrees, turned by up to 40: a photon on its axis at first is
 * in view while the turn is 30 degrees at most, (1 - cos 30) / (1 - cos 40) of
 * the cap. */
static void test_a_cap(void)
{
    const double limit = murk_sidak_limit(BUDGET, CHECKS);
    const double deg = MURK_PI / 180;
    const double share = (1 - cos(30 * deg)) / (1 - cos(40 * deg));
    const double sigma = sqrt(share * (1 - share) / DRAWS);
    const murk_sensor_type type = {
        .range_m = 5, .view = MURK_VIEW_CONE, .cone_rad = 60 * deg};
    const murk_pose pose = {
        .position = {10, 10, 10}, .heading_rad = 0, .tilt_rad = 50 * deg};
    const murk_photon photon = a_photon(
        murk_vec(10, 10 + 2 * cos(50 * deg), 10 + 2 * sin(50 * deg)), none, 0);
    world w;
    murk_coverage_result c = {0};
    build(&w, &type, &photon, 1, 0, 40 * deg, 1);
    murk_robust r = measure(&w, &pose, 1, &c);
    CHECK(r.jittered.as_planned == 1);
    CHECK_WITHIN(limit, r.jittered.mean.value, share, sigma);
    /* Teeth: evenly by angle in place of area. */
    CHECK(sigmas_off(r.jittered.mean.value, 30.0 / 40, sigma) > 2 * limit);
    murk_robust_release(&r);
    murk_coverage_result_release(&c);
    tear_down(&w);
}

/* 400 photons in a cube, four sensors. */
static void scatter(murk_photon photon[400], murk_pose pose[4])
{
    for (uint32_t i = 0; i < 400; ++i) {
        const murk_random4 r = murk_random(1, MURK_TEST, i, 0, 0);
        photon[i] = a_photon(
            murk_vec(8 + 4 * r.u[0], 8 + 4 * r.u[1], 8 + 4 * r.u[2]), none, i);
    }
    for (int k = 0; k < 4; ++k) {
        pose[k] =
            (murk_pose){.position = {9 + 2 * (k % 2), 9 + 2 * (k / 2), 10}};
    }
}

/* Off, nothing is drawn; too small to see, every draw is the plan's coverage to
 * the bit; and what is drawn does not depend on threads. */
static void test_small_and_same(void)
{
    murk_photon photon[400];
    murk_pose pose[4];
    const murk_sensor_type type = all_round(1.5);
    scatter(photon, pose);
    world w;
    murk_coverage_result c = {0};
    build(&w, &type, photon, 400, 0, 0, 2);
    murk_robust r = measure(&w, pose, 4, &c);
    CHECK(r.jittered.draws == 0);
    murk_robust_release(&r);
    murk_coverage_result_release(&c);
    tear_down(&w);

    build(&w, &type, photon, 400, 1e-12, 0, 2);
    w.scene.placement.jitter_draws = 30;
    r = measure(&w, pose, 4, &c);
    CHECK(r.jittered.as_planned == c.total.value);
    CHECK(r.jittered.quantile == c.total.value);
    CHECK(r.jittered.quantile_upper == c.total.value);
    CHECK(isnan(r.jittered.quantile_lower)); /* 30 draws are too few */
    CHECK_NEAR(r.jittered.mean.value, c.total.value, 1e-15);
    CHECK_NEAR(r.jittered.mean.standard_error, c.total.standard_error, 1e-12);
    murk_robust_release(&r);
    murk_coverage_result_release(&c);
    tear_down(&w);

    murk_jittered jittered[2];
    for (unsigned k = 0; k < 2; ++k) {
        build(&w, &type, photon, 400, 0.5, 0, 1 + 4 * k);
        w.scene.placement.jitter_draws = 100;
        r = measure(&w, pose, 4, &c);
        jittered[k] = r.jittered;
        CHECK(r.jittered.quantile < r.jittered.mean.value);
        CHECK(r.jittered.quantile_lower <= r.jittered.quantile &&
              r.jittered.quantile <= r.jittered.quantile_upper);
        murk_robust_release(&r);
        murk_coverage_result_release(&c);
        tear_down(&w);
    }
    CHECK(jittered[0].mean.value == jittered[1].mean.value);
    CHECK(jittered[0].mean.standard_error == jittered[1].mean.standard_error);
    CHECK(jittered[0].quantile == jittered[1].quantile);
}

/* Without each sensor: as measured without it. */
static void test_drop_one(void)
{
    murk_photon photon[400];
    murk_pose pose[4];
    const murk_sensor_type type = all_round(1.5);
    scatter(photon, pose);
    pose[3].position.x = 9.5; /* less useful than the others */
    world w;
    murk_coverage_result c = {0};
    build(&w, &type, photon, 400, 0, 0, 2);
    murk_robust r = measure(&w, pose, 4, &c);
    double worst = 0, sum = 0;
    for (size_t k = 0; k < 4; ++k) {
        murk_pose left[3];
        murk_coverage_result without = {0};
        for (size_t i = 0, at = 0; i < 4; ++i) {
            if (i != k) {
                left[at++] = pose[i];
            }
        }
        CHECK(!murk_coverage_result_measure(&without, w.sight, left, 3, NULL));
        CHECK_NEAR(r.without[k], without.total.value, 1e-15);
        const double loss = c.total.value - without.total.value;
        worst = fmax(worst, loss);
        sum += loss;
        murk_coverage_result_release(&without);
    }
    murk_drop_one drop = murk_robust_drop_one(&r);
    CHECK_NEAR(drop.worst_loss, worst, 1e-15);
    CHECK_NEAR(drop.mean_loss, sum / 4, 1e-15);
    CHECK(drop.worst != 3 && worst > 0 && worst < 0.5);
    CHECK(r.links.groups == 1 && r.links.n == 3);

    /* The second map, where there is one, has the say. */
    murk_coverage_result other = c;
    double only[4] = {0.01, 0.02, 0.03, 0.2};
    other.only_it_covers = only;
    CHECK(!murk_robust_hold_out(&r, &other, NULL));
    drop = murk_robust_drop_one(&r);
    CHECK(drop.worst == 3);
    CHECK_NEAR(drop.worst_loss, 0.2, 1e-15);
    CHECK_NEAR(drop.mean_loss, 0.065, 1e-15);
    murk_robust_release(&r);
    murk_coverage_result_release(&c);
    tear_down(&w);
}

/* Of no sensor, of one, and of equal losses, of which the first is named. */
static void test_drop_one_of_few(void)
{
    double without[] = {0.25, 0.125, 0.125};
    murk_robust r = {.without = without, .total = 0.5};
    murk_drop_one drop = murk_robust_drop_one(&r);
    CHECK(isnan(drop.worst_loss) && isnan(drop.mean_loss));
    r.sensors = 1;
    drop = murk_robust_drop_one(&r);
    CHECK(drop.worst == 0 && drop.worst_loss == 0.25 && drop.mean_loss == 0.25);
    r.sensors = 3;
    drop = murk_robust_drop_one(&r);
    CHECK(drop.worst == 1 && drop.worst_loss == 0.375);
    CHECK_NEAR(drop.mean_loss, 1. / 3, 1e-15);
}

int main(void)
{
    test_drop_one_of_few();
    test_a_lens();
    test_a_cap();
    test_small_and_same();
    test_drop_one();
    return check_done();
}
