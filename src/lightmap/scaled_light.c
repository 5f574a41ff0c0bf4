/* Scales traced light to light sources of other powers, and chooses the powers
 * to trace with so that one traced light serves several scenes. Each channel is
 * sampled by the largest share that it has in any scene. If the number of
 * photons is multiplied by the sum of these shares, the noise of every scene is
 * at most that of a run of its own. */
#include "lightmap/scaled_light.h"

#include "world/sky.h"

#include <math.h>
#include <stdlib.h>

static murk_status no_memory(const murk_scene_desc *scene, murk_error *err)
{
    return murk_no_memory(err, scene->path, "for the lights");
}

static bool any_shines(const murk_source *light, const murk_scene_desc *scene)
{
    bool shines = false;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        for (int b = 0; b < scene->bands; ++b) {
            shines |= light[i].power_w.band[b] > 0;
        }
    }
    return shines;
}

murk_status murk_scaled_light_powers(double **out, const murk_scene_desc *scene,
                                     const murk_domain *domain, murk_error *err)
{
    const size_t channels = scene->n_lights * (size_t)scene->bands;
    murk_source *light = NULL;
    murk_sources *lights = NULL;
    double *power_w = calloc(channels + 1, sizeof *power_w);
    murk_status status = power_w ? murk_sky_lights(&light, NULL, scene, err)
                                 : no_memory(scene, err);
    const bool shines = !status && any_shines(light, scene);
    /* The power of a channel follows from the sources in the domain; all powers
     * stay 0 if no source emits. */
    if (!status && shines) {
        status = murk_sources_create(&lights, light, scene->n_lights,
                                     scene->bands, domain, err);
    }
    for (size_t c = 0; !status && shines && c < channels; ++c) {
        power_w[c] = murk_sources_channel_power_w(lights, c);
    }
    if (!status) {
        *out = power_w;
        power_w = NULL;
    }
    murk_sources_destroy(lights);
    free(light);
    free(power_w);
    return status;
}

static double sum_of(const double *power_w, size_t channels)
{
    double sum = 0;
    for (size_t c = 0; c < channels; ++c) {
        sum += power_w[c];
    }
    return sum;
}

/* Finds the largest share of each channel and the number of the scene that has
 * it; n if no scene has power in the channel. */
static void find_largest(double *share, size_t *who, double *const *power_w,
                         size_t n, size_t channels)
{
    for (size_t c = 0; c < channels; ++c) {
        share[c] = 0;
        who[c] = n;
    }
    for (size_t k = 0; k < n; ++k) {
        const double all = sum_of(power_w[k], channels);
        for (size_t c = 0; all > 0 && c < channels; ++c) {
            if (power_w[k][c] / all > share[c]) {
                share[c] = power_w[k][c] / all;
                who[c] = k;
            }
        }
    }
}

/* Sets the power of each light source so that the power of each channel [W]
 * equals its share. light[] holds the sources of the first scene. They keep
 * their portals, and a source that emits in no scene gets the power 0. The
 * power of a channel is proportional to power_w of the source, so the ratio of
 * share to channel power scales power_w, whatever quantity power_w is for that
 * type. */
static murk_status set_shares(murk_source *light, const double *share,
                              const size_t *who,
                              const murk_scene_desc *const *scene,
                              double *const *power_w, size_t n, murk_error *err)
{
    const size_t bands = (size_t)scene[0]->bands;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < scene[0]->n_lights && !status; ++i) {
        murk_source own = light[i];
        murk_sky_facts facts;
        murk_spectrum power = {{0}};
        /* Scale each band from the scene that has the largest share. */
        for (size_t b = 0; b < bands && !status; ++b) {
            const size_t c = i * bands + b, k = who[c];
            if (k < n) {
                status = murk_sky_light(&own, &facts, scene[k], i, err);
                power.band[b] =
                    own.power_w.band[b] * (share[c] / power_w[k][c]);
            }
        }
        own.power_w = power;
        own.portal = light[i].portal;
        own.portals = light[i].portals;
        light[i] = own;
    }
    return status;
}

murk_status murk_scaled_light_sources(murk_sources **out, double *grow,
                                      const murk_scene_desc *const *scene,
                                      double *const *power_w, size_t n,
                                      const murk_domain *domain,
                                      murk_error *err)
{
    const size_t channels = scene[0]->n_lights * (size_t)scene[0]->bands;
    murk_source *light = NULL;
    double *share = calloc(channels + 1, sizeof *share);
    size_t *who = calloc(channels + 1, sizeof *who);
    murk_status status = MURK_OK;
    if (!share || !who) {
        status = no_memory(scene[0], err);
        goto done;
    }
    /* Find the shares, then build sources of these powers. */
    find_largest(share, who, power_w, n, channels);
    *grow = sum_of(share, channels);
    status = murk_sky_lights(&light, NULL, scene[0], err);
    if (!status) {
        status = set_shares(light, share, who, scene, power_w, n, err);
    }
    if (!status) {
        status = murk_sources_create(out, light, scene[0]->n_lights,
                                     scene[0]->bands, domain, err);
    }
done:
    free(light);
    free(share);
    free(who);
    return status;
}

/* Copies the records that have power in the wanted scene, with the power
 * multiplied by factor[channel]. */
static murk_status scale_map(murk_photon_map **out, const murk_photon_map *map,
                             const double *factor, int bands, unsigned threads,
                             murk_error *err)
{
    const murk_photon *from = murk_photon_map_photons(map);
    const size_t n = murk_photon_map_count(map);
    murk_photon *photon = n ? malloc(n * sizeof *photon) : NULL;
    size_t remaining = 0;
    if (n && !photon) {
        return murk_no_memory(err, "", "for %zu stored photons", n);
    }
    /* The factor depends on the channel of the record. */
    for (size_t i = 0; i < n; ++i) {
        const size_t channel =
            (size_t)murk_photon_light(&from[i]) * (size_t)bands +
            murk_photon_band(&from[i]);
        const float power_w =
            (float)(murk_photon_power_w(&from[i]) * factor[channel]);
        if (power_w > 0) {
            photon[remaining] = from[i];
            murk_photon_set_power_w(&photon[remaining++], (double)power_w);
        }
    }
    if (remaining == 0) {
        free(photon);
        photon = NULL;
    }
    return murk_photon_map_create(out, photon, remaining, threads, err);
}

murk_status murk_scaled_light_make(murk_traced **out, const murk_traced *traced,
                                   const murk_sources *lights,
                                   const double *power_w, int bands,
                                   unsigned threads, murk_error *err)
{
    const size_t channels = traced->channels;
    double *factor = calloc(channels + 1, sizeof *factor);
    murk_traced *made = calloc(1, sizeof *made);
    murk_status status = MURK_OK;
    /* Allocate; the properties of the emission are those of the traced light.
     */
    if (made) {
        made->emitted = traced->emitted;
        made->seed = traced->seed;
        made->stream = traced->stream;
        made->channels = channels;
        made->packet_w = calloc(channels + 1, sizeof *made->packet_w);
    }
    if (!factor || !made || !made->packet_w) {
        status = murk_no_memory(err, "", "for light");
        goto done;
    }
    /* Ratio of the wanted to the traced power of each channel; 0 for a channel
     * that was traced without power. */
    for (size_t c = 0; c < channels; ++c) {
        const double traced_w = murk_sources_channel_power_w(lights, c);
        factor[c] = traced_w > 0 ? power_w[c] / traced_w : 0;
        made->packet_w[c] = traced->packet_w[c] * factor[c];
    }
    /* Scale both maps. */
    status =
        scale_map(&made->surface, traced->surface, factor, bands, threads, err);
    if (!status) {
        status = scale_map(&made->volume, traced->volume, factor, bands,
                           threads, err);
    }
    if (!status) {
        *out = made;
        made = NULL;
    }
done:
    murk_traced_destroy(made);
    free(factor);
    return status;
}
