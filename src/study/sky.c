#include "study/sky.h"

#include <math.h>

#define DAY_S 86400.0

/* Whether the local clock is within one of the spans; one that ends before it
 * begins passes midnight. */
static bool is_within_spans(const murk_scene_schedule *schedule,
                            const murk_scene_site *site)
{
    const double local_s = site->unix_s + 60.0 * site->zone_min;
    const double clock_s = local_s - DAY_S * floor(local_s / DAY_S);
    for (size_t i = 0; i < schedule->spans; ++i) {
        const double from = schedule->from_s[i], to = schedule->to_s[i];
        const bool is_after = clock_s >= from, is_before = clock_s < to;
        if (from < to ? is_after && is_before : is_after || is_before) {
            return true;
        }
    }
    return false;
}

static murk_status shines(bool *out, const murk_scene *scene,
                          const murk_scene_light *light, murk_error *err)
{
    switch (light->schedule.when) {
    case MURK_SCENE_ALWAYS:
        *out = true;
        break;
    case MURK_SCENE_NEVER:
        *out = false;
        break;
    case MURK_SCENE_BY_CLOCK:
        *out = is_within_spans(&light->schedule, &scene->site);
        break;
    case MURK_SCENE_NIGHT:
        return murk_fail(err, MURK_UNSUPPORTED, light->where,
                         "schedule: night is not supported yet");
    }
    return MURK_OK;
}

murk_status murk_sky_light(murk_light *out, murk_sky_facts *facts,
                           const murk_scene *scene, size_t light,
                           murk_error *err)
{
    static const murk_light_type type_of[] = {
        [MURK_SCENE_LIGHT_SPHERE] = MURK_LIGHT_SPHERE,
        [MURK_SCENE_LIGHT_RECT] = MURK_LIGHT_RECT,
        [MURK_SCENE_LIGHT_POINT] = MURK_LIGHT_POINT,
        [MURK_SCENE_LIGHT_BEAM] = MURK_LIGHT_BEAM,
        [MURK_SCENE_LIGHT_DIRECTIONAL] = MURK_LIGHT_DIRECTIONAL};
    const murk_scene_light *l = &scene->lights[light];
    *facts = (murk_sky_facts){.is_on = true};
    if (l->type >= MURK_SCENE_LIGHT_SUN) {
        return murk_fail(err, MURK_UNSUPPORTED, l->where,
                         "lights of the sky are not supported yet");
    }
    const murk_status status = shines(&facts->is_on, scene, l, err);
    *out = (murk_light){.type = type_of[l->type],
                        .position = l->position,
                        .edge1 = l->edge1,
                        .edge2 = l->edge2,
                        .direction = l->direction,
                        .radius_m = l->radius_m,
                        .divergence_rad = l->divergence_rad,
                        .power_w = l->power_w,
                        .where = l->where};
    if (!facts->is_on) {
        out->power_w = murk_spectrum_flat(0, MURK_BANDS_MAX);
    }
    return status;
}
