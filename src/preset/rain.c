/* Rain by its rate R [mm/h].
 *
 * rain_power: attenuation of k R^power dB/km, as radio engineers state it.
 *
 * marshall_palmer: N(D) = 8000 exp(-slope D) drops per m3 and mm of diameter,
 * slope = 4.1 R^-.21 per mm. Drops are so much larger than the wavelength that
 * each takes twice its cross section, half by rays and half by diffraction:
 * extinction = pi 8000 / slope^3 mm2/m3. At rate 0 there is none.
 *
 * Source: Marshall & Palmer, J. Meteorol. 5 (1948) 165,
 * doi:10.1175/1520-0469(1948)005<0165:TDORWS>2.0.CO;2; van de Hulst, Light
 * Scattering by Small Particles, Wiley (1957), ch. 8. */
#include "preset/laws.h"

#include <math.h>

#define PI         3.14159265358979323846
#define DROPS      8000.0 /* per m3 and mm */
#define SLOPE      4.1    /* per mm, at 1 mm/h */
#define SLOPE_FALL .21
#define M2_PER_MM2 1e-6

static murk_status fill(murk_optics *out, const murk_law_call *call,
                        double extinction_per_m)
{
    for (size_t i = 0; i < call->n; ++i) {
        out->scattering_per_m[i] = extinction_per_m;
    }
    return MURK_OK;
}

murk_status murk_law_rain_power(murk_optics *out, const murk_law_call *call,
                                murk_error *err)
{
    (void)err;
    const double rate = call->words->value[MURK_WORD_RAIN][0];
    const double db_per_km = call->parameter[0] * pow(rate, call->parameter[1]);
    return fill(out, call, db_per_km * log(10) / 10 / 1000);
}

murk_status murk_law_marshall_palmer(murk_optics *out,
                                     const murk_law_call *call, murk_error *err)
{
    (void)err;
    const double rate = call->words->value[MURK_WORD_RAIN][0];
    /* 1 / slope, so that no rain is no trouble */
    const double mm = pow(rate, SLOPE_FALL) / SLOPE;
    return fill(out, call, PI * DROPS * mm * mm * mm * M2_PER_MM2);
}
