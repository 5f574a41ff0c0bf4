/* Conversion factors from watts to the quantity that the user asks for
 * (base/photometry.h), by light source and band, and sums of estimates. */
#include "world/units.h"

#include "base/log.h"

#include <math.h>
#include <stdio.h>

static const murk_units KNOWN[] = {
    [MURK_RADIOMETRIC] = {"W", "W/m2", "w"},
    [MURK_PHOTOMETRIC] = {"lm", "lux", "lm"},
    [MURK_PHOTONS] = {"1/s", "1/s/m2", "photons_per_s"},
    [MURK_PAR] = {"umol/s", "umol/s/m2", "umol_per_s"},
};

murk_units murk_units_of(murk_quantity quantity)
{
    return KNOWN[quantity];
}

/* shape is NULL for a light source that is even in wavelength. */
static double per_watt(murk_quantity quantity, const murk_scene_desc *scene,
                       int band, murk_spectral_shape shape,
                       const void *spectrum)
{
    const double line = scene->band_nm[band];
    const double from = scene->has_edges ? scene->band_edge_nm[band] : line;
    const double to = scene->has_edges ? scene->band_edge_nm[band + 1] : line;
    return shape
               ? murk_quantity_per_watt_of(quantity, from, to, shape, spectrum)
               : murk_quantity_per_watt(quantity, from, to);
}

double murk_units_per_watt(murk_quantity quantity, const murk_stage *stage,
                           size_t light, int band)
{
    const murk_sky_facts *facts = &stage->sky[light];
    if (facts->spectrum.nodes > 0) {
        return per_watt(quantity, stage->scene, band, murk_solar_spectrum_at,
                        &facts->spectrum);
    }
    return per_watt(quantity, stage->scene, band,
                    facts->lamp_spectrum ? murk_lamp_spectrum_at : NULL,
                    facts->lamp_spectrum);
}

void murk_units_packets(double *out, murk_quantity quantity,
                        const murk_stage *stage, const double *packet_w)
{
    const size_t bands = (size_t)stage->scene->bands;
    for (size_t c = 0; c < stage->scene->n_lights * bands; ++c) {
        out[c] = packet_w[c] * murk_units_per_watt(quantity, stage, c / bands,
                                                   (int)(c % bands));
    }
}

murk_estimate murk_units_sum(const murk_estimate *value, int n)
{
    murk_estimate sum = {0, 0};
    for (int i = 0; i < n; ++i) {
        sum.value += value[i].value;
        sum.standard_error = hypot(sum.standard_error, value[i].standard_error);
    }
    return sum;
}

void murk_units_note(const murk_scene_desc *scene)
{
    char list[16 * MURK_BANDS_MAX] = "";
    size_t used = 0;
    for (int i = 0; i < scene->bands; ++i) {
        if (!(per_watt(scene->units, scene, i, NULL, NULL) > 0)) {
            used += (size_t)snprintf(list + used, sizeof list - used, "%s%.5g",
                                     used ? ", " : "", scene->band_nm[i]);
        }
    }
    if (used > 0) {
        murk_note(scene->path, "units: light of %s nm counts 0 %s", list,
                  KNOWN[scene->units].irradiance);
    }
}
