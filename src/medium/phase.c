#include "medium/phase.h"

#include <assert.h>
#include <math.h>

#define FOUR_PI 12.566370614359172

/* Below this the inverse CDF loses digits to cancellation (error ~ eps / |g|),
 * while treating the phase function as isotropic costs at most |g|. */
#define G_ISOTROPIC 1e-8

double murk_hg_density(double g, double mu)
{
    assert(g > -1 && g < 1 && mu >= -1 && mu <= 1);
    const double d = 1 + g * g - 2 * g * mu;
    return (1 - g * g) / (FOUR_PI * d * sqrt(d));
}

double murk_hg_sample(double g, double u)
{
    assert(g > -1 && g < 1 && u > 0 && u < 1);
    if (fabs(g) < G_ISOTROPIC) {
        return 2 * u - 1;
    }
    const double s = (1 - g * g) / (1 - g + 2 * g * u);
    const double mu = (1 + g * g - s * s) / (2 * g);
    return fmin(1, fmax(-1, mu)); /* rounding near the ends of u */
}

murk_phase murk_phase_hg(double g)
{
    return (murk_phase){.kind = MURK_PHASE_HG, .g = g};
}

double murk_phase_density(const murk_phase *phase, double mu)
{
    return murk_hg_density(phase->g, mu);
}

double murk_phase_sample(const murk_phase *phase, double u)
{
    return murk_hg_sample(phase->g, u);
}

double murk_phase_mean_cosine(const murk_phase *phase)
{
    return phase->g;
}
