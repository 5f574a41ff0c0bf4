/* Memory of presets and of the results of presets, and interpolation in tables
 * by wavelength. */
#include "preset/preset.h"

#include <stdlib.h>

murk_status murk_preset_angles_create(murk_preset_angles **out, size_t angles,
                                      size_t columns, bool by_wavelength,
                                      murk_error *err)
{
    murk_preset_angles *made = calloc(1, sizeof *made);
    if (made) {
        made->angles = angles;
        made->columns = columns;
        made->angle_deg = calloc(angles, sizeof *made->angle_deg);
        made->phase_per_sr =
            calloc(columns, angles * sizeof *made->phase_per_sr);
        made->wavelength_nm =
            by_wavelength ? calloc(columns, sizeof *made->wavelength_nm) : NULL;
    }
    if (!made || !made->angle_deg || !made->phase_per_sr ||
        (by_wavelength && !made->wavelength_nm)) {
        murk_preset_angles_destroy(made);
        return murk_no_memory(err, "", "for a phase function");
    }
    *out = made;
    return MURK_OK;
}

void murk_preset_angles_destroy(murk_preset_angles *angles)
{
    if (angles) {
        free(angles->wavelength_nm);
        free(angles->angle_deg);
        free(angles->phase_per_sr);
        free(angles);
    }
}

size_t murk_preset_interval(const double *at, size_t n, double wavelength_nm,
                            double *share)
{
    size_t right = 1;
    while (right + 1 < n && at[right] < wavelength_nm) {
        ++right;
    }
    *share = (wavelength_nm - at[right - 1]) / (at[right] - at[right - 1]);
    return right - 1;
}

double murk_preset_table_at(const murk_preset_table *table,
                            const double *column, double wavelength_nm)
{
    if (table->n == 1) {
        return column[0];
    }
    double share;
    const size_t left = murk_preset_interval(table->wavelength_nm, table->n,
                                             wavelength_nm, &share);
    return column[left] * (1 - share) + column[left + 1] * share;
}

static void release_part(murk_preset_part *part)
{
    free(part->table.wavelength_nm);
    free(part->table.absorption_per_m);
    free(part->table.scattering_per_m);
    free(part->table.mean_cosine);
    free(part->table.diffuse_attenuation_per_m);
    murk_preset_angles_destroy(part->angles);
}

void murk_preset_destroy(murk_preset *preset)
{
    if (!preset) {
        return;
    }
    for (size_t i = 0; i < preset->sources; ++i) {
        free(preset->source[i].what);
        free(preset->source[i].from);
        free(preset->source[i].quoted_by);
    }
    for (size_t i = 0; i < preset->doubts.n; ++i) {
        free(preset->doubts.text[i]);
    }
    for (size_t i = 0; i < preset->parts; ++i) {
        release_part(&preset->part[i]);
    }
    free(preset->source);
    free(preset->doubts.text);
    free(preset->name);
    free(preset->about);
    free(preset);
}

void murk_preset_result_release(murk_preset_result *result)
{
    for (int i = 0; i < MURK_BANDS_MAX; ++i) {
        murk_mixture_destroy(result->mixture[i]);
        result->mixture[i] = NULL;
    }
}
