/* Collects the phase function of a band as a weighted mixture; for
 * use inside src/preset only. */
#ifndef MURK_PRESET_MIXTURE_H
#define MURK_PRESET_MIXTURE_H

#include "preset/preset.h"

/* Each part of a preset adds at most two phase functions (neighbouring columns
 * of a table) at each wavelength of a band. */
#define MURK_MIXING_MAX (2 * MURK_PRESET_PARTS_MAX * MURK_PRESET_SAMPLES)

typedef struct murk_mixing {
    size_t n;
    double weight[MURK_MIXING_MAX];
    murk_preset_phase phase[MURK_MIXING_MAX];
} murk_mixing;

/* Adds a phase function with a weight. Equal phase functions are merged; a
 * weight that is not above 0 adds nothing. Tables are borrowed until
 * murk_mixing_finish(). */
void murk_mixing_add(murk_mixing *mixing, const murk_preset_phase *phase,
                     double weight);

/* Adds tabulated phase functions by wavelength, interpolated linearly between
 * the two columns next to the wavelength, which lies within the columns. A
 * table of one column is added as it is. */
void murk_mixing_add_angles(murk_mixing *mixing,
                            const murk_preset_angles *angles,
                            double wavelength_nm, double weight);

/* Returns the mixture with weights that sum to 1 and with copies of the tables.
 * An empty mixture becomes isotropic. The caller destroys *out with
 * murk_mixture_destroy(). Fails with MURK_NO_MEMORY at `where`. */
murk_status murk_mixing_finish(murk_mixture **out, const murk_mixing *mixing,
                               const char *where, murk_error *err);

#endif
