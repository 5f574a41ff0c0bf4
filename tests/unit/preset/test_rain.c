/* What drops of rain absorb: closed forms at both ends, Mie's theory between.
 * Nothing is random. */
#include "preset/rain.h"

#include "check.h"
#include "preset/mie.h"
#include "preset/refraction.h"

#define PI 3.14159265358979323846

/* Faint absorption: reflections cancel, and what is left is the mean chord,
 * diameter * 2/3 n^2 (1 - (1 - 1/n^2)^1.5). */
static void test_faint_absorption_goes_by_the_chord(void)
{
    for (double n = 1.2; n < 1.6; n += .1) {
        const double chord = 2. / 3 * n * n * (1 - pow(1 - 1 / (n * n), 1.5));
        CHECK_NEAR(murk_drop_absorbs(.001, n, 1e-3) / 1e-6 / chord, 1, 2e-4);
    }
}

/* A black drop takes what Fresnel lets in: for an index of 1.34 all but
 * .06751061 by Walsh's closed form (Duntley, J. Opt. Soc. Am. 32 (1942) 61). */
static void test_black_drops_take_what_goes_in(void)
{
    CHECK_NEAR(murk_drop_absorbs(.001, 1.34, 1e7), 1 - .06751061, 1e-4);
}

#define SIZES 8 /* that smooth the fringes of Mie's absorption */

/* How much more drops of about that size absorb by Mie's theory than by rays,
 * as a share, when rays are worked out for an index n_rays. */
static double mie_over_rays(double nm, double diameter_m, double n_rays)
{
    const murk_mie_index index = murk_water_refraction(nm);
    const double per_m = 4 * PI * index.k / (nm * 1e-9);
    double mie_sum = 0, rays = 0;
    murk_mie *mie = NULL;
    CHECK(murk_mie_create(&mie, 1.1 * PI * diameter_m / (nm * 1e-9), NULL) ==
          MURK_OK);
    for (int k = 0; mie && k < SIZES; ++k) {
        const double size_m = diameter_m * (1 + .001 * k);
        const double x = PI * size_m / (nm * 1e-9);
        mie_sum += murk_mie_solve(mie, x, index).absorption;
        rays += murk_drop_absorbs(size_m, n_rays, per_m);
    }
    murk_mie_destroy(mie);
    return mie_sum / rays - 1;
}

/* Rays miss the light that falls just beside the edge: corrections to them go
 * as x^-2/3 (Nussenzveig and Wiscombe, Phys. Rev. Lett. 45 (1980) 1490,
 * doi:10.1103/PhysRevLett.45.1490), of which some three are found here, the
 * fewer the more a drop absorbs. Teeth: straight paths through the drop. */
static void test_mie_has_the_edge_more(void)
{
    static const double nm[] = {900, 1200, 1550};
    for (int i = 0; i < 3; ++i) {
        const double n = murk_water_refraction(nm[i]).n;
        for (double size_m = 5e-4; size_m < 3e-3; size_m *= 2.4) {
            const double edge = pow(PI * size_m / (nm[i] * 1e-9), -2. / 3);
            const double more = mie_over_rays(nm[i], size_m, n);
            CHECK(more > 0 && more < 4 * edge);
        }
        CHECK(fabs(mie_over_rays(nm[i], 5e-4, 1.0001)) >
              4 * pow(PI * 5e-4 / (nm[i] * 1e-9), -2. / 3));
    }
}

int main(void)
{
    test_faint_absorption_goes_by_the_chord();
    test_black_drops_take_what_goes_in();
    test_mie_has_the_edge_more();
    return check_done();
}
