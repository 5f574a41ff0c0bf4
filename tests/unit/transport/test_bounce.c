/* Turning, the roulette at a surface, and the stack of solids, by hand: nothing
 * here is random. */
#include "check.h"
#include "path/solids.h"
#include "transport/bounce.h"
#include "transport/turn.h"

static void test_turn_once_is_the_circle(void)
{
    double worst = 0;
    for (int i = 0; i <= 10000; ++i) {
        const double u = i / 10000.;
        double c, s;
        murk_turn_once(u, &c, &s);
        worst = fmax(worst, fabs(c - cos(2 * MURK_PI * u)));
        worst = fmax(worst, fabs(s - sin(2 * MURK_PI * u)));
    }
    CHECK(worst < 3e-14);
    CHECK(worst > 0);
}

static void test_turned_keeps_angle_and_length(void)
{
    murk_vec3 d = {0, 0, 1};
    double worst_length = 0, worst_angle = 0;
    for (int i = 0; i < 100000; ++i) {
        const double mu = 2 * fmod(i * 0.618033988749895, 1) - 1;
        const murk_vec3 next =
            murk_turned_direction(d, mu, fmod(i * 0.754877666246693, 1));
        worst_angle = fmax(worst_angle, fabs(murk_dot(d, next) - mu));
        worst_length = fmax(worst_length, fabs(murk_length(next) - 1));
        d = next;
    }
    CHECK(worst_length < 1e-15); /* never drifts */
    CHECK(worst_angle < 1e-13);
}

static const murk_material mixed = {.name = "mixed",
                                    .diffuse = {{0, 0.25}},
                                    .specular = {{0, 0.25}},
                                    .transmit = {{0, 0.25}}};

static murk_outcome outcome(double u, int band)
{
    const double four[4] = {u, 0.5, 0.5, 0.5};
    return murk_surface_bounce(&mixed, band, 0, 0, murk_vec(0, 0, -1),
                               murk_vec(0, 0, 1), four)
        .outcome;
}

static void test_roulette_has_the_papers_borders(void)
{
    CHECK(outcome(0.25, 1) == MURK_DIFFUSE);
    CHECK(outcome(0.2500001, 1) == MURK_MIRRORED);
    CHECK(outcome(0.5, 1) == MURK_MIRRORED);
    CHECK(outcome(0.5000001, 1) == MURK_TRANSMITTED);
    CHECK(outcome(0.75, 1) == MURK_TRANSMITTED);
    CHECK(outcome(0.7500001, 1) == MURK_ABSORBED);
    CHECK(outcome(1e-10, 0) == MURK_ABSORBED); /* another band: black */
}

static void test_directions_leave_on_the_right_side(void)
{
    const murk_vec3 d = murk_unit(murk_vec(1, 2, -3)), n = {0, 0, 1};
    const murk_material mirror = {.specular = {{1}}};
    const murk_material white = {.diffuse = {{1}}};
    const double u[4] = {0.5, 0.3, 0.9, 0.5};
    murk_bounce b = murk_surface_bounce(&mirror, 0, 0, 0, d, n, u);
    CHECK(b.outcome == MURK_MIRRORED);
    CHECK_NEAR(b.direction.x, d.x, 1e-15);
    CHECK_NEAR(b.direction.y, d.y, 1e-15);
    CHECK_NEAR(b.direction.z, -d.z, 1e-15);
    b = murk_surface_bounce(&white, 0, 0, 0, d, n, u);
    CHECK(b.outcome == MURK_DIFFUSE);
    CHECK_NEAR(b.direction.z, sqrt(0.3), 1e-15); /* cosine law: mu^2 = u */
}

/* At a solid, mirror and transmission together are what Fresnel splits. */
static void test_solids_split_by_fresnel(void)
{
    const murk_material glass = {.specular = {{0.5}}, .transmit = {{0.5}}};
    const murk_vec3 down = {0, 0, -1}, n = {0, 0, 1};
    double u[4] = {0.9, 0.5, 0.5, 0.0399};
    CHECK(murk_surface_bounce(&glass, 0, 1, 1.5, down, n, u).outcome ==
          MURK_MIRRORED);
    u[0] = 0.1;
    u[3] = 0.0401;
    const murk_bounce b = murk_surface_bounce(&glass, 0, 1, 1.5, down, n, u);
    CHECK(b.outcome == MURK_TRANSMITTED);
    CHECK_NEAR(b.direction.z, -1, 1e-15);
    const murk_vec3 slant = {0.6, 0, -0.8};
    u[3] = 0.99;
    CHECK_NEAR(murk_surface_bounce(&glass, 0, 1, 1.5, slant, n, u).direction.x,
               0.4, 1e-15);
}

static void test_solids_nest(void)
{
    murk_path_solids s = {0};
    CHECK(murk_path_solids_index(&s) == 1);
    CHECK(murk_path_solids_cross(&s, 3, 1.5) &&
          murk_path_solids_index(&s) == 1.5);
    CHECK(murk_path_solids_cross(&s, 1, 1.33) &&
          murk_path_solids_index(&s) == 1.33);
    CHECK(murk_path_solids_cross(&s, 3, 1.5) &&
          murk_path_solids_index(&s) == 1.33);
    CHECK(murk_path_solids_cross(&s, 1, 1.33) &&
          murk_path_solids_index(&s) == 1);
    for (uint16_t i = 1; i <= MURK_PATH_SOLIDS_MAX; ++i) {
        CHECK(murk_path_solids_cross(&s, i, 1 + i));
    }
    CHECK(!murk_path_solids_cross(&s, 99, 2));
    CHECK(s.n == MURK_PATH_SOLIDS_MAX);
}

int main(void)
{
    test_turn_once_is_the_circle();
    test_turned_keeps_angle_and_length();
    test_roulette_has_the_papers_borders();
    test_directions_leave_on_the_right_side();
    test_solids_split_by_fresnel();
    test_solids_nest();
    return check_done();
}
