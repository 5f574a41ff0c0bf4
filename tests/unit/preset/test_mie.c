/* Spheres against published values, limits and identities. Nothing here is
 * drawn by chance: a check fails or holds for good. */
#include "check.h"
#include "preset/mie.h"

#include <stdlib.h>

#define PI 3.141592653589793

typedef struct known {
    double n, k, x;
    double extinction, scattering, mean_cosine;
} known;

/* Wiscombe, Mie Scattering Calculations: Advances in Technique and Fast,
 * Vector-speed Computer Codes, NCAR/TN-140+STR (1979, revised 1996),
 * doi:10.5065/D6ZP4414, the test cases of MIEV0, at second hand from the tests
 * of miepython (Prahl); and Bohren & Huffman 1983, appendix A, likewise. Six
 * digits each. */
static const known SPHERES[] = {
    {.75, 0, .099, 7.417859e-6, 7.417859e-6, .001448},
    {.75, 0, 10, 2.232265, 2.232265, .896473},
    {.75, 0, 1000, 1.997908, 1.997908, .844944},
    {1.33, 1e-5, 1, .093952, .093923, .184517},
    {1.33, 1e-5, 100, 2.101321, 2.096594, .868959},
    {1.33, 1e-5, 10000, 2.004089, 1.723857, .907840},
    {1.5, 1, .055, .101491, 1.131687e-5, .000491},
    {1.5, 1, 1, 2.336321, .663454, .192136},
    {1.5, 1, 100, 2.097502, 1.283697, .850252},
    {1.5, 1, 10000, 2.004368, 1.236574, .846309},
    {10, 10, 1, 2.532993, 2.049405, -.110664},
    {10, 10, 100, 2.071124, 1.836785, .556215},
    {10, 10, 10000, 2.005914, 1.795393, .548194},
    {1.55, 0, 5.2128182, 3.10543, 3.10543, .63314},
};

static murk_mie_sphere sphere(murk_mie *mie, double n, double k, double x)
{
    return murk_mie_solve(mie, x, (murk_mie_index){n, k});
}

static void test_published_spheres(murk_mie *mie)
{
    for (size_t i = 0; i < sizeof SPHERES / sizeof *SPHERES; ++i) {
        const known *want = &SPHERES[i];
        const double digits = want->n == 1.55 ? 2e-5 : 1e-6;
        const murk_mie_sphere got = sphere(mie, want->n, want->k, want->x);
        CHECK_NEAR(got.extinction, want->extinction, digits);
        CHECK_NEAR(got.scattering, want->scattering, digits);
        CHECK_NEAR(got.mean_cosine, want->mean_cosine, digits);
        CHECK_NEAR(got.absorption, got.extinction - got.scattering, 1e-12);
    }
    /* teeth: an index off by .001 is seen */
    const murk_mie_sphere off = sphere(mie, 1.331, 1e-5, 100);
    CHECK(fabs(off.extinction - 2.101321) > 1e-4);
}

/* Far smaller than the wavelength: Rayleigh's formulas, whose next term is
 * x^2 of these (Bohren & Huffman 1983, 5.2). */
static void test_small_spheres_are_rayleighs(murk_mie *mie)
{
    const double n = 1.33, k = 1e-9, min = MURK_MIE_SIZE_MIN;
    const double re = n * n - k * k - 1, im = 2 * n * k, down = re + 3;
    const double size = down * down + im * im;
    for (double x = min; x < 2e-3; x *= 10) {
        const murk_mie_sphere got = sphere(mie, n, k, x);
        const double absorption = 4 * x * (im * down - re * im) / size;
        const double scattering =
            8. / 3 * x * x * x * x * (re * re + im * im) / size;
        CHECK_NEAR(got.absorption / absorption, 1, 10 * x * x + 1e-9);
        CHECK_NEAR(got.scattering / scattering, 1, 10 * x * x + 1e-9);
        CHECK_NEAR(got.mean_cosine / (x * x), .18328, 1e-4);
    }
}

/* No difference of large numbers: a millionth of the absorption at a millionth
 * of k, which subtraction would lose at 1e-15. Off resonance. */
static void test_faint_absorption_keeps_its_digits(murk_mie *mie)
{
    for (double x = 1e-3; x < 20; x *= 3) {
        const double at = sphere(mie, 1.33, 1e-8, x).absorption;
        const double faint = sphere(mie, 1.33, 1e-15, x).absorption;
        CHECK_NEAR(faint / at * 1e7, 1, 1e-4);
    }
    CHECK(sphere(mie, 1.33, 0, 10).absorption == 0);
}

/* The phase function agrees with the efficiencies in integral and mean
 * cosine, and the optical theorem holds forward of a single sphere, |S|^2
 * >= (Q x^2 / 4)^2. The midpoint rule on 1e5 cosines is good to 2e-4 at x =
 * 30. */
static void test_intensity_is_the_scattering(murk_mie *mie)
{
    /* Cosines in the middles of equal steps. */
    enum { N = 100000 };
    double *mu = calloc(N, sizeof *mu), *f = calloc(N, sizeof *f);
    for (int i = 0; i < N; ++i) {
        mu[i] = -1 + (i + .5) * 2 / N;
    }
    for (double x = .3; x < 40; x *= 10) {
        /* Integrate the intensity and the mean cosine. */
        const murk_mie_sphere got = sphere(mie, 1.33, 1e-4, x);
        memset(f, 0, N * sizeof *f);
        murk_mie_add_intensity(mie, 1, N, mu, f);
        double sum = 0, turned = 0;
        for (int i = 0; i < N; ++i) {
            sum += f[i] * 2 / N;
            turned += f[i] * mu[i] * 2 / N;
        }
        CHECK_NEAR(2 * PI * sum / (PI * x * x * got.scattering), 1, 2e-4);
        CHECK_NEAR(turned / sum, got.mean_cosine, 2e-4);
        /* The real part alone is a lower limit of the forward intensity. */
        double forward = 0;
        const double ahead = 1, real = got.extinction * x * x / 4;
        murk_mie_add_intensity(mie, 1, 1, &ahead, &forward);
        CHECK(forward >= real * real);
    }
    free(mu);
    free(f);
}

/* Stable over ten orders of magnitude and with any absorption. */
static void test_stable_everywhere(murk_mie *mie)
{
    static const double index[][2] = {{1.33, 0}, {1.33, 1e-9}, {1.6, .5},
                                      {.5, 0},   {3, 3},       {50, 50}};
    for (size_t i = 0; i < sizeof index / sizeof *index; ++i) {
        for (double x = MURK_MIE_SIZE_MIN; x <= 1.01e4; x *= 4.7) {
            const murk_mie_sphere got =
                sphere(mie, index[i][0], index[i][1], x);
            CHECK(got.scattering > 0 && got.scattering < 10);
            CHECK(got.absorption >= 0 && got.extinction < 10);
            CHECK(fabs(got.mean_cosine) < 1);
        }
    }
}

int main(void)
{
    murk_mie *mie = NULL;
    CHECK(murk_mie_create(&mie, 1e4 * 1.1, NULL) == MURK_OK);
    test_published_spheres(mie);
    test_small_spheres_are_rayleighs(mie);
    test_faint_absorption_keeps_its_digits(mie);
    test_intensity_is_the_scattering(mie);
    test_stable_everywhere(mie);
    murk_mie_destroy(mie);
    return check_done();
}
