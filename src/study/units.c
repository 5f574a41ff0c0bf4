#include "study/units.h"

#include "base/log.h"
#include "light/solar_spectrum.h"

#include <math.h>
#include <stdio.h>

static const murk_units KNOWN[] = {
    [MURK_RADIOMETRIC] = {"W", "W/m2", "w", {{0}}},
    [MURK_PHOTOMETRIC] = {"lm", "lux", "lm", {{0}}},
    [MURK_PHOTONS] = {"1/s", "1/s/m2", "photons_per_s", {{0}}},
    [MURK_PAR] = {"umol/s", "umol/s/m2", "umol_per_s", {{0}}},
};

static bool is_of_the_sky(const murk_scene *scene)
{
    bool is_so = scene->n_lights > 0;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        is_so = is_so && scene->lights[i].type >= MURK_SCENE_LIGHT_SUN;
    }
    return is_so;
}

murk_units murk_units_of(const murk_scene *scene)
{
    murk_units out = KNOWN[scene->units];
    murk_solar_spectrum sunlight;
    const bool by_sun = scene->has_edges && is_of_the_sky(scene);
    if (by_sun) {
        murk_solar_spectrum_make(&sunlight, MURK_SPECTRUM_AM15_GLOBAL, NULL);
    }
    for (int i = 0; i < scene->bands; ++i) {
        const double from =
            scene->has_edges ? scene->band_edge_nm[i] : scene->band_nm[i];
        const double to =
            scene->has_edges ? scene->band_edge_nm[i + 1] : scene->band_nm[i];
        out.per_watt.band[i] =
            by_sun
                ? murk_quantity_per_watt_of(scene->units, from, to,
                                            murk_solar_spectrum_at, &sunlight)
                : murk_quantity_per_watt(scene->units, from, to);
    }
    return out;
}

murk_estimate murk_units_convert(const murk_units *units, int band,
                                 murk_estimate radiometric)
{
    const double factor = units->per_watt.band[band];
    return (murk_estimate){radiometric.value * factor,
                           radiometric.standard_error * factor};
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

void murk_units_note(const murk_scene *scene)
{
    const murk_units units = murk_units_of(scene);
    char list[16 * MURK_BANDS_MAX] = "";
    size_t used = 0;
    for (int i = 0; i < scene->bands; ++i) {
        if (!(units.per_watt.band[i] > 0)) {
            used += (size_t)snprintf(list + used, sizeof list - used, "%s%.5g",
                                     used ? ", " : "", scene->band_nm[i]);
        }
    }
    if (used > 0) {
        murk_note(scene->path, "units: light of %s nm counts 0 %s", list,
                  units.irradiance);
    }
}
