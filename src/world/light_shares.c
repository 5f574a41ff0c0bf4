/* Reads the scene at each time from the text of the resolved scene, which holds
 * the timeline, and computes the powers of the channels there. */
#include "world/light_shares.h"

#include "base/log.h"
#include "scene/timeline.h"
#include "scene/variant.h"
#include "world/sky.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Raises share[channels] to the shares of powers; nothing if all are 0. */
static void raise(double *share, const murk_sources *lights)
{
    const double all_w = murk_sources_power_w(lights);
    for (size_t c = 0; all_w > 0 && c < murk_sources_channels(lights); ++c) {
        const double own = murk_sources_channel_power_w(lights, c) / all_w;
        share[c] = own > share[c] ? own : share[c];
    }
}

/* Raises the shares to those at a time. A scene that is wrong at that time,
 * such as one whose file is missing, counts as dark. */
static void raise_at(double *share, const murk_scene_desc *now, double t_s,
                     const murk_domain *domain)
{
    murk_scene_desc *scene = NULL;
    murk_source *light = NULL;
    murk_sources *lights = NULL;
    murk_error why = {0};
    const bool is_good = !murk_scene_desc_read_at(&scene, now, t_s, &why) &&
                         scene->n_lights == now->n_lights &&
                         !murk_sky_lights(&light, NULL, scene, &why) &&
                         !murk_sources_create(&lights, light, scene->n_lights,
                                              scene->bands, domain, &why);
    if (is_good) {
        raise(share, lights);
    }
    murk_sources_destroy(lights);
    free(light);
    murk_scene_desc_destroy(scene);
}

/* Raises the shares to those at all times. */
static void raise_at_all(double *share, const murk_scene_desc *scene,
                         const murk_domain *domain)
{
    const murk_scene_timeline *t = &scene->timeline;
    const size_t steps = murk_timeline_steps(t);
    const size_t n =
        steps < MURK_LIGHT_SHARES_MAX ? steps : MURK_LIGHT_SHARES_MAX;
    for (size_t i = 0; i < n; ++i) {
        const size_t step = n > 1 ? i * (steps - 1) / (n - 1) : 0;
        raise_at(share, scene, murk_timeline_time_s(t, step), domain);
    }
    /* Keyframes, between which no value is larger. */
    size_t left = MURK_LIGHT_SHARES_MAX;
    for (size_t i = 0; i < t->tracks; ++i) {
        const murk_scene_track *track = &t->track[i];
        for (size_t k = 0; track->key && k < track->keyframes && left > 0;
             ++k, --left) {
            raise_at(share, scene, track->keyframe[k].t_s, domain);
        }
    }
}

murk_status murk_light_shares(double **share, const murk_scene_desc *scene,
                              const murk_sources *lights,
                              const murk_domain *domain, murk_error *err)
{
    const size_t channels = murk_sources_channels(lights);
    *share = NULL;
    if (!murk_timeline_changes_power(scene)) {
        return MURK_OK;
    }
    double *all = calloc(channels, sizeof *all);
    if (!all) {
        return murk_no_memory(err, scene->path, "for the lights");
    }
    const bool was_silent = murk_warn_quiet(true);
    raise_at_all(all, scene, domain);
    murk_warn_quiet(was_silent);
    /* Light sources that shine now alone. */
    double sum = 0;
    for (size_t c = 0; c < channels; ++c) {
        const double own_w = murk_sources_channel_power_w(lights, c);
        if (own_w > 0 && !(all[c] > 0)) {
            all[c] = own_w / murk_sources_power_w(lights);
        }
        sum += all[c];
    }
    if (!(sum > 0)) {
        free(all);
        all = NULL;
    }
    *share = all;
    return MURK_OK;
}
