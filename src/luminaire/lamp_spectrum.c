/* Black bodies and tables as spectra of lamps: values, integrals over bands,
 * and the luminous flux of the whole. The scale of a black body is that of 1 at
 * 555 nm, so that no temperature under- or overflows. */
#include "luminaire/lamp_spectrum.h"

#include <math.h>
#include <stdlib.h>

/* The second radiation constant h c / k [nm K] (SI 2019). */
#define C2_NM_K 1.438776877e7
/* The wavelength at which the shape of a black body is about 1. */
#define MIDDLE_NM 555.0
/* Exponents above this leave nothing: exp(-600) is 1e-261. */
#define EXPONENT_MAX 600.0

/* Steps of Simpson's rule (luminaire/lamp_spectrum.h): at 500 K the spectrum of
 * the visible changes by 5 % in 1 nm, which the rule integrates to 1e-9. */
#define STEP_NM   1.0
#define STEPS_MAX 20000.0 /* bounds the time of a band that is very wide */

/* The ends of V (base/photometry.h). */
#define VISIBLE_FROM_NM 380.0
#define VISIBLE_TO_NM   780.0

murk_status murk_lamp_spectrum_create(murk_lamp_spectrum **out,
                                      double temperature_k, size_t n,
                                      double *nm, double *power_per_nm,
                                      const char *where, murk_error *err)
{
    murk_lamp_spectrum *made = calloc(1, sizeof *made);
    if (!made) {
        free(nm);
        free(power_per_nm);
        return murk_no_memory(err, where, "for a spectrum");
    }
    *made = (murk_lamp_spectrum){.temperature_k = temperature_k,
                                 .n = n,
                                 .nm = nm,
                                 .power_per_nm = power_per_nm};
    *out = made;
    return MURK_OK;
}

murk_lamp_spectrum *murk_lamp_spectrum_share(murk_lamp_spectrum *spectrum)
{
    if (spectrum) {
        ++spectrum->further_owners;
    }
    return spectrum;
}

void murk_lamp_spectrum_destroy(murk_lamp_spectrum *spectrum)
{
    if (spectrum && spectrum->further_owners-- == 0) {
        free(spectrum->nm);
        free(spectrum->power_per_nm);
        free(spectrum);
    }
}

/* Planck's law per wavelength, divided by the value at MIDDLE_NM so that no
 * temperature under- or overflows. */
static double planck(double temperature_k, double nm)
{
    const double x = C2_NM_K / (nm * temperature_k),
                 middle = C2_NM_K / (MIDDLE_NM * temperature_k);
    if (x - middle > EXPONENT_MAX) {
        return 0;
    }
    /* (exp(middle) - 1) / (exp(x) - 1), without overflow of either */
    const double ratio = exp(middle - x) * -expm1(-middle) / -expm1(-x);
    return pow(MIDDLE_NM / nm, 5) * ratio;
}

double murk_lamp_spectrum_at(const void *spectrum, double nm)
{
    const murk_lamp_spectrum *s = spectrum;
    if (s->temperature_k > 0) {
        return planck(s->temperature_k, nm);
    }
    if (s->n == 0 || !(nm >= s->nm[0] && nm <= s->nm[s->n - 1])) {
        return 0;
    }
    size_t low = 0, high = s->n - 1;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (s->nm[middle] <= nm) {
            low = middle;
        } else {
            high = middle;
        }
    }
    const double t = (nm - s->nm[low]) / (s->nm[high] - s->nm[low]);
    return (1 - t) * s->power_per_nm[low] + t * s->power_per_nm[high];
}

/* Trapezoids between the wavelengths of the table, which are exact. */
static double table_integral(const murk_lamp_spectrum *s, double from,
                             double to)
{
    double sum = 0;
    for (size_t i = 1; i < s->n; ++i) {
        const double a = fmax(from, s->nm[i - 1]), b = fmin(to, s->nm[i]);
        if (b > a) {
            sum += (b - a) *
                   (murk_lamp_spectrum_at(s, a) + murk_lamp_spectrum_at(s, b)) /
                   2;
        }
    }
    return sum;
}

double murk_lamp_spectrum_integral(const murk_lamp_spectrum *spectrum,
                                   double from_nm, double to_nm)
{
    if (!(spectrum->temperature_k > 0)) {
        return table_integral(spectrum, from_nm, to_nm);
    }
    /* Simpson's rule. */
    const double steps =
        fmin(fmax(ceil((to_nm - from_nm) / STEP_NM), 1), STEPS_MAX);
    const double step = (to_nm - from_nm) / steps;
    double sum = 0;
    for (int i = 0; i < (int)steps; ++i) {
        const double a = from_nm + i * step;
        sum += step / 6 *
               (murk_lamp_spectrum_at(spectrum, a) +
                4 * murk_lamp_spectrum_at(spectrum, a + step / 2) +
                murk_lamp_spectrum_at(spectrum, a + step));
    }
    return sum;
}

double murk_lamp_spectrum_per_watt(const murk_lamp_spectrum *spectrum,
                                   murk_quantity quantity, double from_nm,
                                   double to_nm)
{
    return spectrum->temperature_k > 0 || from_nm == to_nm
               ? murk_quantity_per_watt_of(quantity, from_nm, to_nm,
                                           murk_lamp_spectrum_at, spectrum)
               : murk_quantity_per_watt_of_table(quantity, from_nm, to_nm,
                                                 spectrum->n, spectrum->nm,
                                                 spectrum->power_per_nm);
}

double murk_lamp_spectrum_lumens(const murk_lamp_spectrum *spectrum)
{
    return murk_lamp_spectrum_integral(spectrum, VISIBLE_FROM_NM,
                                       VISIBLE_TO_NM) *
           murk_lamp_spectrum_per_watt(spectrum, MURK_PHOTOMETRIC,
                                       VISIBLE_FROM_NM, VISIBLE_TO_NM);
}
