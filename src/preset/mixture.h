/* Gathers how a band's light turns, phase function by phase function; inside
 * this room only. */
#ifndef MURK_PRESET_MIXTURE_H
#define MURK_PRESET_MIXTURE_H

#include "preset/preset.h"

/* Each part of a preset gives at most two (neighbours of a table) in each
 * sample of a band. */
#define MURK_MIXING_MAX (2 * MURK_PRESET_PARTS_MAX * MURK_PRESET_SAMPLES)

typedef struct murk_mixing {
    size_t n;
    double weight[MURK_MIXING_MAX];
    murk_preset_phase phase[MURK_MIXING_MAX];
} murk_mixing;

/* Adds weight to this phase function; weight 0 is passed over. */
void murk_mixing_add(murk_mixing *mixing, const murk_preset_phase *phase,
                     double weight);

/* The same for angles by wavelength, linear between the two columns next to
 * it. The wavelength lies within the columns'. */
void murk_mixing_add_angles(murk_mixing *mixing,
                            const murk_preset_angles *angles,
                            double wavelength_nm, double weight);

/* What has been gathered, tables copied; isotropic where nothing was. *out is
 * the caller's: murk_mixture_destroy(). */
murk_status murk_mixing_finish(murk_mixture **out, const murk_mixing *mixing,
                               const char *where, murk_error *err);

#endif
