/* Scales traced light to light sources of other powers, and chooses the powers
 * to trace with so that one traced light serves several scenes. Each channel is
 * sampled by the largest share that it has in any scene. If the number of
 * photons is multiplied by the sum of these shares, the noise of every scene is
 * at most that of a run of its own. */
#include "lightmap/scaled_light.h"

#include "world/sky.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

struct murk_scaled_shares {
    const murk_scene_desc *first;
    size_t channels, added;
    bool shine, differ;
    double *share;       /* [channels] the largest */
    double *power;       /* [channels] power_w of the source that has the share
                          * as channel power */
    double *first_power; /* [channels] of the first scene that was added */
    murk_source *light;  /* [lights] of the scene `first`; a source that shines
                          * in others has the shape that it has there */
    int *band;           /* [lights] the last band with power; -1: none */
};

murk_status murk_scaled_shares_create(murk_scaled_shares **out,
                                      const murk_scene_desc *first,
                                      murk_error *err)
{
    murk_scaled_shares *s = calloc(1, sizeof *s);
    if (!s) {
        return no_memory(first, err);
    }
    s->first = first;
    s->channels = first->n_lights * (size_t)first->bands;
    s->share = calloc(s->channels + 1, sizeof *s->share);
    s->power = calloc(s->channels + 1, sizeof *s->power);
    s->first_power = calloc(s->channels + 1, sizeof *s->first_power);
    s->band = calloc(first->n_lights + 1, sizeof *s->band);
    murk_status status = s->share && s->power && s->first_power && s->band
                             ? murk_sky_lights(&s->light, NULL, first, err)
                             : no_memory(first, err);
    if (status) {
        murk_scaled_shares_destroy(s);
        return status;
    }
    /* No source has shone yet. */
    for (size_t i = 0; i < first->n_lights; ++i) {
        s->band[i] = -1;
    }
    *out = s;
    return MURK_OK;
}

void murk_scaled_shares_destroy(murk_scaled_shares *shares)
{
    if (shares) {
        free(shares->share);
        free(shares->power);
        free(shares->first_power);
        free(shares->band);
        free(shares->light);
        free(shares);
    }
}

/* Takes over the shares of light i that are larger than those before. A light
 * source in place of another has its shape, but portals, intensities and place
 * in the file of the first scene, which lives on. The power of a channel is
 * proportional to power_w of the source, so the ratio of share to channel power
 * scales power_w, whatever quantity power_w is for that type. */
static void take_light(murk_scaled_shares *s, size_t i, const murk_source *own,
                       const double *power_w, double all)
{
    const int bands = s->first->bands;
    murk_source *light = &s->light[i];
    for (int b = 0; b < bands; ++b) {
        const size_t c = i * (size_t)bands + (size_t)b;
        if (!(power_w[c] / all > s->share[c])) {
            continue;
        }
        s->share[c] = power_w[c] / all;
        s->power[c] = own->power_w.band[b] * (s->share[c] / power_w[c]);
        if (b >= s->band[i]) {
            const murk_source before = *light;
            *light = *own;
            light->where = before.where;
            light->intensity = before.intensity;
            light->portal = before.portal;
            light->portals = before.portals;
            s->band[i] = b;
        }
    }
}

murk_status murk_scaled_shares_add(murk_scaled_shares *s,
                                   const murk_scene_desc *scene,
                                   const double *power_w, murk_error *err)
{
    const size_t bytes = s->channels * sizeof *power_w;
    const double all = sum_of(power_w, s->channels);
    murk_source *light = NULL;
    bool has_larger = false;
    if (s->added++ == 0) {
        memcpy(s->first_power, power_w, bytes);
    }
    s->differ = s->differ || memcmp(s->first_power, power_w, bytes) != 0;
    s->shine = s->shine || all > 0;
    for (size_t c = 0; all > 0 && c < s->channels; ++c) {
        has_larger = has_larger || power_w[c] / all > s->share[c];
    }
    const murk_status status =
        has_larger ? murk_sky_lights(&light, NULL, scene, err) : MURK_OK;
    for (size_t i = 0; has_larger && !status && i < scene->n_lights; ++i) {
        take_light(s, i, &light[i], power_w, all);
    }
    free(light);
    return status;
}

bool murk_scaled_shares_shine(const murk_scaled_shares *shares)
{
    return shares->shine;
}

bool murk_scaled_shares_differ(const murk_scaled_shares *shares)
{
    return shares->differ;
}

murk_status murk_scaled_shares_sources(murk_sources **out, double *grow,
                                       const murk_scaled_shares *s,
                                       const murk_domain *domain,
                                       murk_error *err)
{
    const int bands = s->first->bands;
    const size_t n = s->first->n_lights;
    *grow = sum_of(s->share, s->channels);
    for (size_t i = 0; i < n; ++i) {
        s->light[i].power_w = (murk_spectrum){{0}};
        for (int b = 0; b < bands; ++b) {
            s->light[i].power_w.band[b] =
                s->power[i * (size_t)bands + (size_t)b];
        }
    }
    return murk_sources_create(out, s->light, n, bands, domain, err);
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
