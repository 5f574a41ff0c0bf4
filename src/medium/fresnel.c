/* Fresnel's equations for unpolarised light, and the cosine of refraction by
 * Snell's law (medium/fresnel.h). */
#include "medium/fresnel.h"

#include <math.h>

double murk_fresnel(double n_from, double n_to, double cosine,
                    double *cosine_refracted)
{
    const double ratio = n_from / n_to;
    const double sine2 = ratio * ratio * (1 - cosine * cosine);
    *cosine_refracted = 0;
    if (!(sine2 < 1)) {
        return 1;
    }
    const double c = cosine, t = sqrt(1 - sine2);
    const double s_wave = (n_from * c - n_to * t) / (n_from * c + n_to * t);
    const double p_wave = (n_from * t - n_to * c) / (n_from * t + n_to * c);
    *cosine_refracted = t;
    return (s_wave * s_wave + p_wave * p_wave) / 2;
}
