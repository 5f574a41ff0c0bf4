/* Extinction by visibility V, by the two laws that are used in free-space
 * optics:
 *
 *   extinction = (-ln .02 / V) (wavelength / 550 nm)^-q
 *
 * Kruse: q = .585 V^(1/3) (V in km) up to 6 km, 1.3 above and up to 50 km, 1.6
 * above. Kim: q = 0 up to .5 km (fog, equal for all wavelengths), V - .5 to 1
 * km, .16 V + .34 to 6 km, and as Kruse above.
 *
 * Sources: Kruse, McGlauchlin & McQuistan, Elements of Infrared Technology,
 * Wiley (1962); Kim, McArthur & Korevaar, Proc. SPIE 4214 (2001) 26,
 * doi:10.1117/12.417512. */
#include "preset/laws.h"

#include "preset/visibility.h"

#include <math.h>

double murk_visibility_extinction(double visibility_m)
{
    return -log(.02) / visibility_m;
}

double murk_visibility_of_mor(double mor_m)
{
    return mor_m * (log(.02) / log(.05));
}

double murk_visibility_kruse_q(double visibility_km)
{
    return visibility_km > 50  ? 1.6
           : visibility_km > 6 ? 1.3
                               : .585 * cbrt(visibility_km);
}

double murk_visibility_kim_q(double visibility_km)
{
    return visibility_km > 50   ? 1.6
           : visibility_km > 6  ? 1.3
           : visibility_km >= 1 ? .16 * visibility_km + .34
           : visibility_km > .5 ? visibility_km - .5
                                : 0;
}

void murk_law_power(murk_law_result *out, const murk_law_call *call,
                    double extinction_per_m, double at_nm, double exponent,
                    double albedo)
{
    for (size_t i = 0; i < call->n; ++i) {
        const double extinction =
            extinction_per_m * pow(call->wavelength_nm[i] / at_nm, -exponent);
        out->scattering_per_m[i] = albedo * extinction;
        out->absorption_per_m[i] = (1 - albedo) * extinction;
    }
}

static murk_status run(murk_law_result *out, const murk_law_call *call,
                       double (*q_of)(double))
{
    const double visibility_m = call->words->value[MURK_WORD_VISIBILITY][0];
    murk_law_power(out, call, murk_visibility_extinction(visibility_m),
                   MURK_VISIBILITY_NM, q_of(visibility_m / 1000),
                   call->parameter[0]);
    return MURK_OK;
}

murk_status murk_law_kruse(murk_law_result *out, const murk_law_call *call,
                           murk_error *err)
{
    (void)err;
    return run(out, call, murk_visibility_kruse_q);
}

murk_status murk_law_kim(murk_law_result *out, const murk_law_call *call,
                         murk_error *err)
{
    (void)err;
    return run(out, call, murk_visibility_kim_q);
}
