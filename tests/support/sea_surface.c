/* Estimates the reflectance of a rough sea surface from single encounters with
 * murk's facets, and evaluates the published fits that it is compared with. */
#include "sea_surface.h"

#include <math.h>

#include "medium/fresnel.h"
#include "medium/waves.h"
#include "transport/facets.h"

murk_estimate sea_reflected(double n_from, double n_to,
                            double mean_square_slope, double cosine,
                            uint64_t photons, uint32_t seed)
{
    double back = 0;
    for (uint64_t i = 0; i < photons; ++i) {
        const murk_address address = {seed, MURK_TEST, i, 3};
        const double mu =
            cosine > 0 ? cosine : sqrt(murk_random_at(&address, 0).u[0]);
        murk_bounce out;
        if (!murk_meet_facets(&address, n_from, n_to, mean_square_slope,
                              murk_vec(sqrt(1 - mu * mu), 0, -mu),
                              murk_vec(0, 0, 1), &out)) {
            return (murk_estimate){NAN, NAN};
        }
        back += out.outcome == MURK_MIRRORED;
    }
    const double share = back / (double)photons;
    return (murk_estimate){share, sqrt(share * (1 - share) / (double)photons)};
}

double sea_sun_by_jin(double cosine, double slope)
{
    double unused;
    const double c = cosine, w = slope;
    const double f =
        (.0152 - 1.7873 * c + 6.8972 * c * c - 8.5778 * c * c * c + 4.071 * w -
         7.6446 * c * w) *
        exp(.1643 - 7.8409 * c - 3.5639 * c * c - 2.3588 * w + 10.0538 * c * w);
    return murk_fresnel(1, SEA_INDEX, c, &unused) - f;
}

double sea_sky_by_walsh(double n)
{
    const double n2 = n * n, n4 = n2 * n2;
    return .5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
           n2 * (n2 - 1) * (n2 - 1) / pow(n2 + 1, 3) * log((n - 1) / (n + 1)) -
           2 * n * n2 * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
           8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * log(n);
}
