/* The sea's surface: what it sends back, and the light below it. */
#include "library/library.h"

#include <math.h>

#include "base/vector.h"
#include "cases/reference.h"
#include "medium/waves.h"
#include "mobley_sea.h"
#include "sea_surface.h"

/* Rows hold for the seed that they are made with; 5 of their standard errors is
 * what chance may do. */
#define SEED   1
#define SIGMAS 5

static void compare_reflectance(murk_library *library)
{
    /* The nightly form has more photons. */
    static const double zenith_deg[] = {0, 30, 60, 70, 80, 85};
    static const double wind[] = {5, 10, 20};
    const uint64_t photons = library->is_nightly ? 400000 : 20000;
    murk_library_title(
        library, "Reflectance of a wind-blown sea",
        "Of the sun by its zenith angle and the wind, against a fit to the "
        "computed albedos of Cox and Munk's sea; of an even sky on level "
        "water. Models of the surface differ by 10 to 18 % among themselves "
        "(Mobley 2015).");
    /* Direct light, by zenith angle of the sun and wind speed; the
     * tolerance is wider for a low sun and for strong wind, for which
     * models differ more. */
    for (int i = 0; i < 6; ++i) {
        for (int k = 0; k < 3; ++k) {
            const bool is_usual = zenith_deg[i] <= 70 && wind[k] <= 10;
            const double share = is_usual ? .10 : .18;
            const double mu = cos(zenith_deg[i] * MURK_PI / 180);
            const double slope = murk_wind_mean_square_slope(wind[k]);
            const double jin = sea_sun_by_jin(mu, sqrt(slope));
            const murk_estimate e =
                sea_reflected(1, SEA_INDEX, slope, mu, photons, SEED);
            char name[80];
            snprintf(name, sizeof name,
                     "sun at %g degrees, %g m/s (error %.1f %%, off %+.1f %%)",
                     zenith_deg[i], wind[k], 100 * e.standard_error / e.value,
                     100 * (e.value / jin - 1));
            murk_library_row(library, name, "", jin, e.value,
                             share * jin + SIGMAS * e.standard_error,
                             is_usual ? "10 % and 5 sigma" : "18 % and 5 sigma",
                             "Jin et al. 2011, eq. 1, 2 and 4, at second hand");
        }
    }
    /* Diffuse light on water that is nearly level. */
    const murk_estimate level =
        sea_reflected(1, SEA_INDEX, 1e-10, 0, 10 * photons, SEED);
    murk_library_row(library, "even sky, no wind", "",
                     sea_sky_by_walsh(SEA_INDEX), level.value,
                     SIGMAS * level.standard_error, "5 sigma",
                     "Walsh, in Duntley 1942");
}

static void compare_depth(murk_library *library, const murk_table *t,
                          size_t row, const char *water, double tau,
                          const char *what, const char *column,
                          const char *published, const char *differ,
                          murk_estimate e)
{
    const double computed = reference_number(t, row, column);
    const double models = reference_number(t, row, published);
    char name[100];
    snprintf(name, sizeof name, "%s, %s at tau %g (error %.2g %%)", water, what,
             tau, 100 * e.standard_error / e.value);
    murk_library_row(library, name, "W/m2", computed, e.value,
                     SIGMAS * e.standard_error + 1.5e-3 * computed,
                     "5 sigma and .15 %", "adding-doubling");
    murk_library_row(library, name, "W/m2", models, e.value,
                     SIGMAS * hypot(e.standard_error,
                                    models * reference_number(t, row, differ)) +
                         1.5e-3 * models,
                     "5 sigma, the models' among them, and .15 %",
                     "Mobley et al. 1993, table 5");
}

static void compare_mobley(murk_library *library)
{
    /* Photons, reference and title. */
    const uint64_t photons = library->is_nightly ? 2000000 : 60000;
    murk_table *t = reference_read("sea.csv");
    murk_library_title(
        library, "Under the sea by a scene's words",
        "Canonical problems 1 (Rayleigh) and 2 (Petzold) of Mobley et al. "
        "1993: a sun by place and time 30 degrees high, a half space of index "
        "1.34 without wind, water by a preset whose coefficients are said.");
    /* Light each of the two seas once. */
    for (int problem = 1; problem <= 2; ++problem) {
        const mobley_sea sea = {problem, .9, 1.34, NULL};
        const mobley_light light = mobley_sea_lit(&sea, photons, SEED);
        const char *water =
            problem == 1 ? "Rayleigh, albedo .9" : "Petzold, albedo .9";
        /* Compare both irradiances at the depths that the reference has. */
        for (size_t row = 0; row < t->rows; ++row) {
            const double tau = reference_number(t, row, "tau");
            for (int k = 0; k < MOBLEY_DEPTHS; ++k) {
                if (reference_number(t, row, "problem") == problem &&
                    reference_number(t, row, "albedo") == sea.albedo &&
                    tau == mobley_tau[k]) {
                    compare_depth(library, t, row, water, tau, "Ed", "ed",
                                  "published_ed", "differ_ed", light.ed[k]);
                    compare_depth(library, t, row, water, tau, "Eou", "eou",
                                  "published_eou", "differ_eou", light.eou[k]);
                }
            }
        }
    }
    murk_table_destroy(t);
}

void murk_library_surface(murk_library *library)
{
    compare_reflectance(library);
    compare_mobley(library);
}
