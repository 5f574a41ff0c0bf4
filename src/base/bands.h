/* Wavelength bands of a scene. A photon belongs to one band, and every optical
 * property may differ from band to band. */
#ifndef MURK_BASE_BANDS_H
#define MURK_BASE_BANDS_H

/* The largest number of bands of a scene, fixed by the scene format. */
#define MURK_BANDS_MAX 16

/* One value for each band. The entries past the number of bands of the scene
 * belong to no band; their values have no effect. */
typedef struct murk_spectrum {
    double band[MURK_BANDS_MAX];
} murk_spectrum;

/* Returns a spectrum with `value` in each of the first n bands and 0 in the
 * others. */
static inline murk_spectrum murk_spectrum_flat(double value, int n)
{
    murk_spectrum out = {{0}};
    for (int i = 0; i < n; ++i) {
        out.band[i] = value;
    }
    return out;
}

#endif
