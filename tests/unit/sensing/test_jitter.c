/* Displaced and turned sensors: the law of their places and axes, and that none
 * goes where it cannot.
 *
 * 6 z-tests share a chance of 1e-6 of a false alarm per seed (Sidak); the seed
 * is fixed, so the verdict repeats. */
#include "base/stats.h"
#include "sensing/jitter.h"
#include "world.h"

#define CHECKS 6
#define BUDGET 1e-6
#define DRAWS  20000

static const murk_domain hall = {.box = {{0, 0, 0}, {10, 10, 4}}};
static const murk_sensor_type TYPES[2] = {
    {.range_m = 5}, {.range_m = 5, .view = MURK_VIEW_CONE, .cone_rad = 1}};

static murk_jitter of(const murk_surfaces *surfaces, const murk_domain *domain,
                      double step_m, double turn_rad)
{
    return (murk_jitter){.step_m = step_m,
                         .turn_rad = turn_rad,
                         .seed = 3,
                         .surfaces = surfaces,
                         .domain = domain,
                         .north = {0, 1, 0}};
}

/* Even over a ball: (r / R)^3 and each coordinate's share are uniform, with
 * mean 1/2 and 0; a coordinate's variance is R^2 / 5. Even over a cap: the
 * cosine is uniform. */
static void test_laws(void)
{
    const double limit = murk_sidak_limit(BUDGET, CHECKS);
    const double step_m = 0.5, turn_rad = 0.3;
    murk_surfaces *none = surfaces_of(NULL, 0);
    const murk_jitter jitter = of(none, &hall, step_m, turn_rad);
    const murk_pose pose = {
        .type = 1, .position = {5, 5, 2}, .heading_rad = 1, .tilt_rad = -0.4};
    const murk_vec3 axis = murk_pose_frame(&pose, jitter.north).axis;
    double volume = 0, area = 0, x = 0, y = 0, z = 0, cap = 0;
    for (uint64_t d = 0; d < DRAWS; ++d) {
        murk_pose out;
        CHECK(murk_jitter_draw(&out, &pose, 1, TYPES, &jitter, d) == 0);
        const murk_vec3 offset = murk_sub(out.position, pose.position);
        const double r = murk_length(offset) / step_m;
        const double mu =
            murk_dot(murk_pose_frame(&out, jitter.north).axis, axis);
        CHECK(r <= 1 + 1e-12 && mu >= cos(turn_rad) - 1e-12);
        volume += r * r * r / DRAWS;
        area += r * r / DRAWS;
        x += offset.x / step_m / DRAWS;
        y += offset.y / step_m / DRAWS;
        z += offset.z / step_m / DRAWS;
        cap += (1 - mu) / (1 - cos(turn_rad)) / DRAWS;
    }
    const double even = sqrt(1.0 / 12 / DRAWS), side = sqrt(1.0 / 5 / DRAWS);
    CHECK_WITHIN(limit, volume, 0.5, even);
    CHECK_WITHIN(limit, x, 0, side);
    CHECK_WITHIN(limit, y, 0, side);
    CHECK_WITHIN(limit, z, 0, side);
    CHECK_WITHIN(limit, cap, 0.5, even);
    /* Teeth: were the ball's radius drawn as a disc's is, r^2 were even. */
    CHECK(sigmas_off(area, 0.5, even) > 2 * limit);
    murk_surfaces_destroy(none);
}

/* A wall through the ball: all places are on the sensor's side of it, also
 * those far behind, and half of the ball's tries go on. The same with a pane,
 * and with the domain's side. */
static void test_walls(void)
{
    const murk_vec3 place = {4.9, 5, 2};
    for (int material = WALL; material <= GLASS; ++material) {
        const murk_surface_desc wall = a_rect(
            murk_vec(5, 0, 0), murk_vec(0, 10, 0), murk_vec(0, 0, 4), material);
        murk_surfaces *surfaces = surfaces_of(&wall, 1);
        const murk_jitter jitter = of(surfaces, &hall, 1, 0);
        const murk_pose pose = {.position = place};
        double farthest_m = 0;
        for (uint64_t d = 0; d < 500; ++d) {
            murk_pose out;
            CHECK(murk_jitter_draw(&out, &pose, 1, TYPES, &jitter, d) == 0);
            CHECK(out.position.x < 5);
            farthest_m = fmax(farthest_m, place.x - out.position.x);
        }
        CHECK(farthest_m > 0.8);
        murk_surfaces_destroy(surfaces);
    }
    murk_surfaces *none = surfaces_of(NULL, 0);
    murk_domain domain = {.box = {{0, 0, 0}, {5, 10, 4}}};
    murk_jitter jitter = of(none, &domain, 1, 0);
    const murk_pose pose = {.position = place};
    for (uint64_t d = 0; d < 500; ++d) {
        murk_pose out;
        murk_jitter_draw(&out, &pose, 1, TYPES, &jitter, d);
        CHECK(murk_box_contains(&domain.box, out.position));
    }
    /* Through a periodic side: some come in again on the other. */
    domain.is_periodic = true;
    int wrapped = 0;
    for (uint64_t d = 0; d < 500; ++d) {
        murk_pose out;
        murk_jitter_draw(&out, &pose, 1, TYPES, &jitter, d);
        CHECK(murk_box_contains(&domain.box, out.position));
        wrapped += out.position.x < 1;
    }
    CHECK(wrapped > 150 && wrapped < 350);

    /* The same in a domain that does not begin at 0: a step over a side comes
     * in again as far behind the other side. */
    const murk_box away = {{20, 30, 0}, {25, 34, 4}};
    const murk_domain still = {.box = {{10, 10, 0}, {40, 50, 4}}};
    const murk_domain tiled = {.box = away, .is_periodic = true};
    const murk_jitter through = of(none, &tiled, 1, 0);
    const murk_jitter free_step = of(none, &still, 1, 0);
    const murk_pose corner = {.position = {24.9, 30.1, 2}};
    int around[2] = {0};
    for (uint64_t d = 0; d < 500; ++d) {
        murk_pose out, straight;
        CHECK(murk_jitter_draw(&out, &corner, 1, TYPES, &through, d) == 0);
        CHECK(murk_jitter_draw(&straight, &corner, 1, TYPES, &free_step, d) ==
              0);
        const double dx = straight.position.x - out.position.x;
        const double dy = straight.position.y - out.position.y;
        around[0] += dx > 1;
        around[1] += dy < -1;
        CHECK_NEAR(dx, straight.position.x > 25 ? 5 : 0, 1e-12);
        CHECK_NEAR(dy, straight.position.y < 30 ? -4 : 0, 1e-12);
    }
    CHECK(around[0] > 150 && around[1] > 150);
    murk_surfaces_destroy(none);
}

/* In a crate so tight that the ball is nearly all outside, it stays; many
 * periods across, it ends. */
static void test_no_place(void)
{
    const murk_surface_desc crate =
        a_box(murk_vec(4.99, 4.99, 1.99), murk_vec(5.01, 5.01, 2.01));
    murk_surfaces *surfaces = surfaces_of(&crate, 1);
    const murk_jitter jitter = of(surfaces, &hall, 3, 0);
    const murk_pose pose[2] = {{.position = {5, 5, 2}},
                               {.position = {1, 1, 1}}};
    murk_pose out[2];
    CHECK(murk_jitter_draw(out, pose, 2, TYPES, &jitter, 0) == 1);
    CHECK(out[0].position.x == 5 && out[0].position.y == 5);
    CHECK(out[1].position.x != 1);
    murk_domain periodic = hall;
    periodic.is_periodic = true;
    const murk_jitter far = of(surfaces, &periodic, 1e9, 0);
    CHECK(murk_jitter_draw(out, pose, 2, TYPES, &far, 0) == 2);
    murk_surfaces_destroy(surfaces);
}

/* No jitter changes nothing at all; all-round sensors are not turned; straight
 * up is no matter; draws and sensors differ, a draw repeats. */
static void test_bounds(void)
{
    murk_surfaces *none = surfaces_of(NULL, 0);
    const murk_pose pose[3] = {
        {.type = 1, .position = {5, 5, 2}, .heading_rad = 6, .tilt_rad = 1},
        {.type = 0, .position = {5, 5, 2}},
        {.type = 1, .position = {5, 5, 2}, .tilt_rad = MURK_PI / 2}};
    murk_pose out[3], again[3];
    const murk_jitter still = of(none, &hall, 0, 0);
    CHECK(murk_jitter_draw(out, pose, 3, TYPES, &still, 7) == 0);
    CHECK(memcmp(out, pose, sizeof pose) == 0);
    const murk_jitter jitter = of(none, &hall, 0.1, 0.01);
    murk_jitter_draw(out, pose, 3, TYPES, &jitter, 7);
    CHECK(out[1].heading_rad == 0 && out[1].tilt_rad == 0);
    CHECK(out[0].heading_rad != 6 && fabs(out[0].heading_rad - 6) < 0.03);
    CHECK(out[0].position.x != out[1].position.x);
    const murk_vec3 up = {0, 0, 1};
    CHECK(murk_dot(murk_pose_frame(&out[2], jitter.north).axis, up) >
          cos(0.0101));
    murk_jitter_draw(again, pose, 3, TYPES, &jitter, 7);
    CHECK(memcmp(out, again, sizeof out) == 0);
    murk_jitter_draw(again, pose, 3, TYPES, &jitter, 8);
    CHECK(again[0].position.x != out[0].position.x);
    murk_surfaces_destroy(none);
}

int main(void)
{
    test_laws();
    test_walls();
    test_no_place();
    test_bounds();
    return check_done();
}
