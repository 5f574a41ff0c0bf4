/* Wavelength bands: a photon belongs to one; every optical property may differ
 * from band to band. */
#ifndef MURK_BASE_BANDS_H
#define MURK_BASE_BANDS_H

#define MURK_BANDS_MAX 16

/* One value a band; the entries past the scene's number of bands are 0. */
typedef struct murk_spectrum {
    double band[MURK_BANDS_MAX];
} murk_spectrum;

/* The same value in each of the first n bands. */
static inline murk_spectrum murk_spectrum_flat(double value, int n)
{
    murk_spectrum out = {{0}};
    for (int i = 0; i < n; ++i) {
        out.band[i] = value;
    }
    return out;
}

#endif
