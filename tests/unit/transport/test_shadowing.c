/* How often light leaves a wind-blown boundary after its first facet, against
 * closed forms of Smith's theory with heights that do not go with slopes.
 *
 * With L(d) = (area seen)/|cosine| - 1 on the way down and (area seen)/|cosine|
 * on the way up, light that comes down from d0 meets its first facet where the
 * share of the surface that lies lower is h, of density (1 + L0) h^L0. Light
 * thrown back up towards d1 is not shadowed with probability h^L1, light that
 * goes through and on below with probability (1 - h)^L1. The means over h are
 *
 *   reflected:  (1 + L0) / (1 + L0 + L1)
 *   refracted:  (1 + L0) B(1 + L0, 1 + L1),  B the beta function
 *
 * Source: Smith, IEEE Trans. Antennas Propag. 15 (1967) 668,
 * doi:10.1109/TAP.1967.1138991; Heitz, Hanika, d'Eon and Dachsbacher, ACM
 * Trans. Graph. 35 (2016) 58, doi:10.1145/2897824.2925943.
 *
 * The first facet is drawn by slot 2 of the address, so the test knows the
 * direction after it: light that leaves in another one has met a second facet.
 * A fixed seed; the z-tests share a 1e-6 chance of a false alarm (Sidak).
 * Shadowing 3 % off is refused: a factor on every exponent, which reflected
 * light alone cannot tell, as it takes h to a power on the way down that the
 * way up undoes. */
#include "base/log_gamma.h"
#include "base/stats.h"
#include "check.h"
#include "medium/waves.h"
#include "transport/facets.h"

#define PHOTONS 250000
#define RAYS    4
#define Z_TESTS (2 * RAYS) /* reflected, refracted */

#define WATER  1.34
#define MIRROR 1e9 /* reflects all but 4e-9 */

/* Steeper than any sea, so that shadowing matters. */
static const double mean_square_slope = .5;

/* Counts of one outcome at the first facet and what is expected of them. */
typedef struct shadowing {
    double left, want, variance;
    double off_want; /* with exponents 3 % larger */
} shadowing;

static double share_reflected(double down, double up)
{
    return (1 + down) / (1 + down + up);
}

static double share_refracted(double down, double on)
{
    return (1 + down) * exp(murk_log_gamma(1 + down) + murk_log_gamma(1 + on) -
                            murk_log_gamma(2 + down + on));
}

/* The same with the logarithm of heights times k on every way: h^((1 + L0) / k)
 * lies below, L1 / k takes the place of L1. */
static double share_refracted_off(double down, double on, double k)
{
    const double a = (1 + down) / k, b = 1 + on / k;
    return a *
           exp(murk_log_gamma(a) + murk_log_gamma(b) - murk_log_gamma(a + b));
}

static void add(shadowing *s, bool has_left, double want, double off_want)
{
    s->left += has_left;
    s->want += want;
    s->off_want += off_want;
    s->variance += want * (1 - want);
}

/* As facets.c lays its facets out: u[0] the slope along the ray, u[1] and u[2]
 * across it. */
static murk_bounce first_facet(const murk_address *address, murk_vec3 direction,
                               double cosine, double n_from, double n_to)
{
    const murk_vec3 up = {0, 0, 1};
    const murk_random4 r = murk_random_at(address, 2);
    const murk_slope slope =
        murk_facet_sample(sqrt(mean_square_slope), cosine, r.u);
    const murk_vec3 along = murk_unit(murk_along(direction, cosine, up));
    const murk_vec3 across = murk_cross(up, along);
    const murk_vec3 facet = murk_unit(
        murk_along(murk_along(up, -slope.along, along), -slope.across, across));
    return murk_refract(n_from, n_to, direction, facet, r.u[3]);
}

/* Sigmas between what is refracted and shadowing 3 % off. */
static double test_light_is_shadowed(double cosine, double n_from, double n_to,
                                     double limit)
{
    const murk_vec3 up = {0, 0, 1};
    const murk_vec3 in = {sqrt(1 - cosine * cosine), 0, -cosine};
    const double width = sqrt(mean_square_slope);
    const double down = murk_facets_projected_area(width, cosine) / cosine - 1;
    shadowing reflected = {0, 0, 0, 0}, refracted = {0, 0, 0, 0};
    for (uint64_t i = 0; i < PHOTONS; ++i) {
        const murk_address address = {11, MURK_TEST, i, 0};
        const murk_bounce first =
            first_facet(&address, in, cosine, n_from, n_to);
        murk_bounce last;
        CHECK(murk_meet_facets(&address, n_from, n_to, mean_square_slope, in,
                               up, &last));
        const bool is_through = first.outcome == MURK_TRANSMITTED;
        const double z = is_through ? -first.direction.z : first.direction.z;
        if (!(z > 0)) {
            continue; /* it must meet another facet */
        }
        const double on = murk_facets_projected_area(width, -z) / z;
        const bool has_left =
            last.outcome == first.outcome &&
            murk_length(murk_sub(last.direction, first.direction)) < 1e-12;
        if (is_through) {
            add(&refracted, has_left, share_refracted(down, on),
                share_refracted_off(down, on, 1.03));
        } else {
            const double want = share_reflected(down, on);
            add(&reflected, has_left, want, want);
        }
    }
    CHECK_WITHIN(limit, reflected.left, reflected.want,
                 sqrt(reflected.variance));
    if (n_to < MIRROR) {
        CHECK_WITHIN(limit, refracted.left, refracted.want,
                     sqrt(refracted.variance));
    }
    return sigmas_off(refracted.left, refracted.off_want,
                      sqrt(refracted.variance));
}

int main(void)
{
    /* Water; an index so near that grazing light goes through and on at grazing
     * angles, where shadowing is strong on both ways; and a mirror. */
    static const struct {
        double cosine, n_from, n_to;
        bool has_teeth;
    } ray[RAYS] = {{.2, 1, WATER, false},
                   {.9, WATER, 1, false},
                   {.1, 1, 1.01, true},
                   {.1, 1, MIRROR, false}};
    const double limit = murk_sidak_limit(1e-6, Z_TESTS);
    for (int i = 0; i < RAYS; ++i) {
        const double off = test_light_is_shadowed(ray[i].cosine, ray[i].n_from,
                                                  ray[i].n_to, limit);
        CHECK(!ray[i].has_teeth || off > limit);
    }
    return check_done();
}
