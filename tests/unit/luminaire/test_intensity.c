/* The table of intensities: the integral equals a sum over fine steps, drawn
 * directions have exactly the density of the lookup, and the angles of the
 * three photometric types point where LM-63 says. */
#include "base/rng.h"
#include "base/stats.h"
#include "check.h"
#include "luminaire/intensity.h"

#include <stdlib.h>

#define RAD (MURK_PI / 180)

enum { VERTICALS = 5, PLANES = 4 };
static const double gamma_deg[VERTICALS] = {0, 20, 45, 90, 120};
static const double c_deg[PLANES + 1] = {0, 50, 180, 300, 360};
static const size_t plane_of[PLANES + 1] = {0, 1, 2, 3, 0};
static const double candela[PLANES * VERTICALS] = {
    100, 80, 60, 0,  5, 100, 150, 10,  20, 0,
    100, 0,  0,  40, 1, 100, 90,  300, 2,  0,
};

static murk_intensity_grid grid_of_c(void)
{
    return (murk_intensity_grid){.type = MURK_GONIOMETER_C,
                                 .verticals = VERTICALS,
                                 .horizontals = PLANES + 1,
                                 .vertical_deg = gamma_deg,
                                 .horizontal_deg = c_deg,
                                 .plane = plane_of,
                                 .candela = candela,
                                 .scale = 2};
}

static murk_intensity *made(const murk_intensity_grid *grid)
{
    murk_intensity *t = NULL;
    murk_error err = {0};
    CHECK(murk_intensity_create(&t, grid, "a.ies", &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
    return t;
}

static void test_listed_angles_are_exact(void)
{
    const murk_intensity_grid grid = grid_of_c();
    murk_intensity *t = made(&grid);
    for (size_t h = 0; h <= PLANES; ++h) {
        for (size_t v = 0; v < VERTICALS; ++v) {
            CHECK(murk_intensity_at_angles(t, gamma_deg[v], c_deg[h]) ==
                  2 * candela[plane_of[h] * VERTICALS + v]);
        }
    }
    /* Bilinear between; periodic in C; dark beyond the last gamma. */
    CHECK_NEAR(murk_intensity_at_angles(t, 10, 25), 2 * 107.5, 1e-12);
    CHECK_NEAR(murk_intensity_at_angles(t, 10, 25 + 360), 2 * 107.5, 1e-9);
    CHECK_NEAR(murk_intensity_at_angles(t, 10, 25 - 360), 2 * 107.5, 1e-9);
    CHECK(murk_intensity_at_angles(t, 121, 0) == 0);
    CHECK(murk_intensity_max_candela(t) == 600);
    murk_intensity_destroy(t);
}

/* The sum of the lookup times the solid angle over fine steps. */
static double summed(const murk_intensity *t, double g0, double g1, double c0,
                     double c1)
{
    enum { STEPS = 160 };
    double sum = 0;
    for (int i = 0; i < STEPS; ++i) {
        const double g = g0 + (g1 - g0) * (i + 0.5) / STEPS;
        for (int k = 0; k < STEPS; ++k) {
            const double c = c0 + (c1 - c0) * (k + 0.5) / STEPS;
            sum += murk_intensity_at_angles(t, g, c) * sin(g * RAD);
        }
    }
    return sum * (g1 - g0) * (c1 - c0) * RAD * RAD / STEPS / STEPS;
}

static void test_flux_is_the_integral(void)
{
    const murk_intensity_grid grid = grid_of_c();
    murk_intensity *t = made(&grid);
    double sum = 0;
    for (size_t v = 1; v < VERTICALS; ++v) {
        for (size_t h = 1; h <= PLANES; ++h) {
            sum += summed(t, gamma_deg[v - 1], gamma_deg[v], c_deg[h - 1],
                          c_deg[h]);
        }
    }
    CHECK_NEAR(murk_intensity_lumens(t) / sum, 1, 1e-5);
    murk_intensity_destroy(t);
}

/* An even intensity has the flux 4 pi I, and the directions are even. */
static void test_even_lamp(void)
{
    const double v[] = {0, 180}, h[] = {0, 360}, one[] = {3, 3};
    const size_t plane[] = {0, 0};
    const murk_intensity_grid grid = {
        MURK_GONIOMETER_C, 2, 2, v, h, plane, one, 1};
    murk_intensity *t = made(&grid);
    CHECK_NEAR(murk_intensity_lumens(t), 12 * MURK_PI, 1e-13);
    for (double u = 0.01; u < 1; u += 0.07) {
        const murk_vec3 d = murk_intensity_draw(t, u, 0.25);
        CHECK_NEAR(d.z, 2 * u - 1, 1e-13);
        CHECK_NEAR(d.x, 0, 1e-13);
        CHECK(d.y > 0);
    }
    murk_intensity_destroy(t);
}

/* Drawn angles invert the two cumulative distributions: the flux of the table
 * that ends at the drawn gamma is u of the whole, and the integral over C up to
 * the drawn C is u of the row. */
static void test_drawn_angles_invert_the_distribution(void)
{
    const murk_intensity_grid grid = grid_of_c();
    murk_intensity *t = made(&grid);
    double off = 0, off_c = 0;
    for (double u = 1e-9; u < 1; u += 0.0137) {
        const double u_c = fmod(7 * u + 0.05, 1);
        const murk_vec3 d = murk_intensity_draw(t, u, u_c);
        const double g = atan2(hypot(d.x, d.y), -d.z) / RAD;
        double c = atan2(d.y, d.x) / RAD;
        c += c < 0 ? 360 : 0;
        /* The table up to gamma, with the row at gamma from the lookup. */
        double cut_deg[VERTICALS + 1], cut[PLANES * (VERTICALS + 1)];
        size_t n = 0;
        while (n < VERTICALS && gamma_deg[n] < g - 1e-9) {
            cut_deg[n] = gamma_deg[n];
            ++n;
        }
        cut_deg[n++] = g;
        for (size_t p = 0; p < PLANES; ++p) {
            for (size_t v = 0; v < n; ++v) {
                cut[p * n + v] =
                    murk_intensity_at_angles(t, cut_deg[v], c_deg[p]);
            }
        }
        murk_intensity_grid part = grid;
        part.verticals = n;
        part.vertical_deg = cut_deg;
        part.candela = cut;
        part.scale = 1;
        murk_intensity *below = made(&part);
        off = fmax(
            off,
            fabs(murk_intensity_lumens(below) / murk_intensity_lumens(t) - u));
        /* The integral over C up to c, by trapezoids, which are exact. */
        double sum = 0, all = 0;
        for (size_t h = 1; h <= PLANES; ++h) {
            const double a = murk_intensity_at_angles(t, g, c_deg[h - 1]);
            const double b = murk_intensity_at_angles(t, g, c_deg[h]);
            const double width = c_deg[h] - c_deg[h - 1];
            const double end = fmin(fmax(c - c_deg[h - 1], 0), width);
            all += width * (a + b) / 2;
            sum += end * (a + (b - a) * end / width / 2);
        }
        off_c = fmax(off_c, fabs(sum / all - u_c));
        murk_intensity_destroy(below);
    }
    printf("inversion off by %.1e and %.1e\n", off, off_c);
    CHECK(off < 1e-13);
    CHECK(off_c < 1e-12);
    murk_intensity_destroy(t);
}

/* The share of drawn directions in each cell of the table, against the flux of
 * the cell. wrong: a factor of the expected flux of the brightest cell. Returns
 * the largest number of sigmas. */
static double worst_cell(uint32_t seed, double wrong)
{
    enum { CELLS = (VERTICALS - 1) * PLANES };
    const uint64_t samples = 200000;
    const murk_intensity_grid grid = grid_of_c();
    murk_intensity *t = made(&grid);
    double flux[CELLS];
    uint64_t count[CELLS] = {0};
    for (size_t i = 0; i < CELLS; ++i) {
        const size_t v = i / PLANES, h = i % PLANES;
        flux[i] =
            summed(t, gamma_deg[v], gamma_deg[v + 1], c_deg[h], c_deg[h + 1]);
    }
    size_t largest = 0;
    for (size_t i = 1; i < CELLS; ++i) {
        largest = flux[i] > flux[largest] ? i : largest;
    }
    flux[largest] *= wrong;
    /* Count draws by cell. */
    for (uint64_t i = 0; i < samples; ++i) {
        const murk_random4 u = murk_random(seed, MURK_TEST, i, 0, 0);
        const murk_vec3 d = murk_intensity_draw(t, u.u[0], u.u[1]);
        const double g = atan2(hypot(d.x, d.y), -d.z) / RAD;
        double c = atan2(d.y, d.x) / RAD;
        c += c < 0 ? 360 : 0;
        size_t v = 0, h = 0;
        while (v + 2 < VERTICALS && g >= gamma_deg[v + 1]) {
            ++v;
        }
        while (h + 1 < PLANES && c >= c_deg[h + 1]) {
            ++h;
        }
        ++count[v * PLANES + h];
    }
    double worst = 0;
    for (size_t i = 0; i < CELLS; ++i) {
        const double share = flux[i] / murk_intensity_lumens(t);
        const double sigma = sqrt(share * (1 - share) * (double)samples);
        worst = fmax(worst, sigmas_off((double)count[i],
                                       share * (double)samples, sigma));
    }
    murk_intensity_destroy(t);
    return worst;
}

static void test_drawn_directions_have_the_density(void)
{
    CHECK(worst_cell(11, 1) < murk_sidak_limit(1e-6, 16));
    CHECK(worst_cell(11, 1.03) > murk_sidak_limit(1e-6, 16)); /* teeth */
}

/* The direction of V and H is what LM-63 says: V towards x, H towards -y. */
static void test_types_a_and_b(void)
{
    const double v_deg[] = {-90, -30, 0, 60, 90}, h_deg[] = {-90, 0, 45, 90};
    const size_t plane[] = {0, 1, 2, 3};
    double cd[20];
    for (int i = 0; i < 20; ++i) {
        cd[i] = 10 + 7 * i % 13;
    }
    for (int type = MURK_GONIOMETER_B; type <= MURK_GONIOMETER_A; ++type) {
        const bool is_a = type == MURK_GONIOMETER_A;
        const murk_intensity_grid grid = {
            (murk_goniometer)type, 5, 4, v_deg, h_deg, plane, cd, 1};
        murk_intensity *t = made(&grid);
        for (int i = 0; i < 20; ++i) {
            const double v = v_deg[i % 5] * RAD, h = h_deg[i / 5] * RAD;
            const murk_vec3 d =
                is_a ? murk_vec(sin(v), -cos(v) * sin(h), -cos(v) * cos(h))
                     : murk_vec(cos(h) * sin(v), -sin(h), -cos(h) * cos(v));
            CHECK(murk_intensity_at_angles(t, v_deg[i % 5], h_deg[i / 5]) ==
                  cd[i]);
            if (fabs(is_a ? cos(v) : cos(h)) > 1e-9) { /* no pole */
                CHECK_NEAR(murk_intensity_candela(t, d), cd[i], 1e-9);
            }
        }
        /* The rear half is dark, and no direction is drawn there. */
        CHECK(murk_intensity_candela(t, murk_vec(0.6, 0, 0.8)) == 0);
        bool is_front = true;
        for (double u = 0.003; u < 1; u += 0.01) {
            is_front =
                is_front && murk_intensity_draw(t, u, fmod(3 * u, 1)).z < 1e-12;
        }
        CHECK(is_front);
        murk_intensity_destroy(t);
    }
}

/* An even front half has the flux 2 pi I in types A and B. */
static void test_flux_of_half_a_sphere(void)
{
    const double angle[] = {-90, 90}, one[] = {1, 1, 1, 1};
    const size_t plane[] = {0, 1};
    for (int type = MURK_GONIOMETER_B; type <= MURK_GONIOMETER_A; ++type) {
        const murk_intensity_grid grid = {
            (murk_goniometer)type, 2, 2, angle, angle, plane, one, 1};
        murk_intensity *t = made(&grid);
        CHECK_NEAR(murk_intensity_lumens(t), 2 * MURK_PI, 1e-13);
        murk_intensity_destroy(t);
    }
}

static void test_dark_tables_are_refused(void)
{
    const double none[PLANES * VERTICALS] = {0};
    murk_intensity_grid grid = grid_of_c();
    murk_intensity *t = NULL;
    murk_error err = {0};
    grid.candela = none;
    CHECK(murk_intensity_create(&t, &grid, "dark.ies", &err) == MURK_BAD_FILE);
    CHECK_MENTIONS(err.text, "add up to 0 lm");
}

int main(void)
{
    test_listed_angles_are_exact();
    test_flux_is_the_integral();
    test_even_lamp();
    test_drawn_angles_invert_the_distribution();
    test_drawn_directions_have_the_density();
    test_types_a_and_b();
    test_flux_of_half_a_sphere();
    test_dark_tables_are_refused();
    return check_done();
}
