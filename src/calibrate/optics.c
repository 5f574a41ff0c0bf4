/* Extracts the optical properties of a scene for re-weighting. */
#include "calibrate/optics.h"

#include "base/log.h"
#include "lightmap/scaled_light.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static murk_status no_memory(const murk_scene_desc *scene, murk_error *err)
{
    return murk_no_memory(err, scene->path, "for its optics");
}

static murk_status fill_media(murk_optics *o, const murk_fillings *fillings,
                              murk_error *err)
{
    const murk_scene_desc *scene = o->scene;
    o->extinction_per_m = calloc(o->media + 1, sizeof *o->extinction_per_m);
    o->albedo = calloc(o->media + 1, sizeof *o->albedo);
    if (!o->extinction_per_m || !o->albedo) {
        return no_memory(scene, err);
    }
    const murk_status status =
        murk_phases_create(&o->phases, scene, fillings, err);
    if (status) {
        return status;
    }
    for (size_t i = 0; i < o->media; ++i) {
        const murk_scene_medium *m = &scene->media[i];
        o->albedo[i] = o->phases->source[i]->albedo;
        o->extinction_per_m[i] = murk_scene_states_extinction(m)
                                     ? murk_spectrum_flat(1, scene->bands)
                                     : m->extinction_per_m;
    }
    return MURK_OK;
}

static murk_status copy_power(murk_optics *o, const double *power_w,
                              murk_error *err)
{
    o->power_w = calloc(o->channels + 1, sizeof *o->power_w);
    if (!o->power_w) {
        return no_memory(o->scene, err);
    }
    memcpy(o->power_w, power_w, o->channels * sizeof *power_w);
    return MURK_OK;
}

murk_status murk_optics_create(murk_optics **out, murk_scene_desc *scene,
                               const murk_domain *domain,
                               const murk_fillings *fillings,
                               const double *power_w, murk_error *err)
{
    murk_optics *o = calloc(1, sizeof *o);
    if (!o) {
        const murk_status status = no_memory(scene, err);
        murk_scene_desc_destroy(scene);
        return status;
    }
    /* Fill media and power without warnings. */
    const bool was_silent = murk_warn_quiet(true);
    o->scene = scene;
    o->media = scene->n_media;
    o->bands = scene->bands;
    o->channels = scene->n_lights * (size_t)scene->bands;
    murk_status status = fill_media(o, fillings, err);
    if (!status) {
        status =
            power_w ? copy_power(o, power_w, err)
                    : murk_scaled_light_powers(&o->power_w, scene, domain, err);
    }
    murk_warn_quiet(was_silent);
    if (status) {
        murk_optics_destroy(o);
        return status;
    }
    *out = o;
    return MURK_OK;
}

void murk_optics_destroy(murk_optics *optics)
{
    if (optics) {
        free(optics->extinction_per_m);
        free(optics->albedo);
        murk_phases_destroy(optics->phases);
        free(optics->power_w);
        murk_scene_desc_destroy(optics->scene);
        free(optics);
    }
}

/* Number of steps between the angles at which phase functions are compared; the
 * steps are logarithmic because of the diffraction peak. */
#define ANGLES 60

/* Relative tolerance, above rounding. A parameter that changes a phase function
 * by less than this when the parameter changes by a thousandth changes the
 * weight of a path by at most 1e-4 for each scattering when the parameter
 * doubles. Example: the absorbed share of rain in the visible. */
#define ALIKE 1e-7

bool murk_optics_turn_alike(const murk_optics *a, const murk_optics *b,
                            size_t medium, int band)
{
    const murk_phase *p = &a->phases->medium[medium][band];
    const murk_phase *q = &b->phases->medium[medium][band];
    bool is_alike = true;
    for (int k = 0; k <= ANGLES && is_alike; ++k) {
        const double angle_rad = MURK_PI * pow(10, -5 + 5. * k / ANGLES);
        const double x = murk_phase_density(p, cos(angle_rad));
        const double y = murk_phase_density(q, cos(angle_rad));
        is_alike = fabs(x - y) <= ALIKE * fmax(x, y);
    }
    return is_alike;
}
