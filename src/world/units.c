/* Conversion factors from watts to the quantity that the user asks for
 * (base/photometry.h), by light source and band, and sums of estimates. */
#include "world/units.h"

#include "base/log.h"

#include <math.h>
#include <stdio.h>

/* Lumens that differ by less agree: the line at 550 nm, which is that of scenes
 * without bands, has .995 of the lumens of 555 nm. */
#define LUMENS_AGREE 0.01

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

/* The ends of a band [nm], which are equal for a line. */
static void ends_of(const murk_scene_desc *scene, int band, double end[2])
{
    for (int i = 0; i < 2; ++i) {
        end[i] = scene->has_edges ? scene->band_edge_nm[band + i]
                                  : scene->band_nm[band];
    }
}

double murk_units_per_watt(murk_quantity quantity, const murk_stage *stage,
                           size_t light, int band)
{
    const murk_sky_facts *facts = &stage->sky[light];
    double end[2];
    ends_of(stage->scene, band, end);
    if (facts->spectrum.nodes > 0) {
        return murk_quantity_per_watt_of(
            quantity, end[0], end[1], murk_solar_spectrum_at, &facts->spectrum);
    }
    return facts->lamp_spectrum
               ? murk_lamp_spectrum_per_watt(facts->lamp_spectrum, quantity,
                                             end[0], end[1])
               : murk_quantity_per_watt(quantity, end[0], end[1]);
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

/* The lumens of the power of a lamp without a spectrum. */
static double lumens_of(const murk_scene_desc *scene,
                        const murk_scene_light *light)
{
    double sum = 0;
    for (int b = 0; b < scene->bands; ++b) {
        double end[2];
        ends_of(scene, b, end);
        sum += light->power_w.band[b] *
               murk_quantity_per_watt(MURK_PHOTOMETRIC, end[0], end[1]);
    }
    return sum;
}

/* Warns of the first luminaire whose lumens became watts as at 555 nm and count
 * as another flux in the bands of the scene. */
static void warn_of_lumens(const murk_scene_desc *scene)
{
    for (size_t i = 0; i < scene->n_lights; ++i) {
        const murk_scene_light *l = &scene->lights[i];
        const double counted = lumens_of(scene, l);
        if (l->luminaire && !l->spectrum && l->lumens > 0 &&
            !(fabs(counted / l->lumens - 1) <= LUMENS_AGREE)) {
            murk_warn(l->where,
                      "without a spectrum, 683 lm are 1 W in equal parts: its "
                      "%.6g lm count as %.6g lm in the bands, give "
                      "temperature_k or spectrum",
                      l->lumens, counted);
            return;
        }
    }
}

void murk_units_note(const murk_scene_desc *scene)
{
    if (scene->units == MURK_PHOTOMETRIC) {
        warn_of_lumens(scene);
    }
    char list[16 * MURK_BANDS_MAX] = "";
    size_t used = 0;
    for (int i = 0; i < scene->bands; ++i) {
        double end[2];
        ends_of(scene, i, end);
        if (!(murk_quantity_per_watt(scene->units, end[0], end[1]) > 0)) {
            used += (size_t)snprintf(list + used, sizeof list - used, "%s%.5g",
                                     used ? ", " : "", scene->band_nm[i]);
        }
    }
    if (used > 0) {
        murk_note(scene->path, "units: light of %s nm counts 0 %s", list,
                  KNOWN[scene->units].irradiance);
    }
}
