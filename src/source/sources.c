/* The set of light sources of a scene: copies and checks the lights, computes
 * the power of each channel, deals photons to channels (source/deal.h) and
 * draws the start of each photon from numbers addressed by the photon index. */
#include "source/sources.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/position.h"
#include "base/rng.h"
#include "source/deal.h"
#include "source/source_state.h"

struct murk_sources {
    murk_domain domain;
    size_t n, bands;
    murk_source_state *sources; /* [n] */
    double *power_w;            /* [n * bands] */
    double all_power_w;
    size_t n_lit;    /* number of channels with power */
    size_t n_dealt;  /* number of channels that photons are dealt to */
    size_t *dealt;   /* [n_dealt] numbers of these channels */
    uint64_t *limit; /* [n_dealt] limits of source/deal.h */
};

static murk_status check_set(size_t n_lights, const murk_domain *domain,
                             murk_error *err)
{
    const murk_vec3 a = domain->box.min, b = domain->box.max;
    if (!(n_lights >= 1 && n_lights <= MURK_SOURCES_MAX)) {
        return murk_fail(err, MURK_BAD_VALUE, "lights",
                         "%zu lights, must be 1..%d", n_lights,
                         MURK_SOURCES_MAX);
    }
    if (!(murk_is_finite(a) && murk_is_finite(b) && a.x < b.x && a.y < b.y &&
          a.z < b.z)) {
        return murk_fail(err, MURK_BAD_VALUE, "domain",
                         "%s .. %s m, min must be below max on each axis",
                         murk_position_show(a).text,
                         murk_position_show(b).text);
    }
    return MURK_OK;
}

/* Copies and prepares one light, and sets the powers of its channels. */
static murk_status add(murk_sources *lights, size_t i, const murk_source *light,
                       murk_error *err)
{
    murk_source_state *s = &lights->sources[i];
    const char *where = light->where ? light->where : "lights";
    const bool aimed = murk_source_is_distant(light) && light->portals > 0;
    const size_t portals = aimed ? light->portals : 0;
    /* Copy everything that the light refers to. */
    char *copy = malloc(strlen(where) + 1);
    murk_portal *portal = malloc((portals + 1) * sizeof *portal);
    if (!copy || !portal) {
        free(copy);
        free(portal);
        return murk_no_memory(err, where, "for a light");
    }
    s->light = *light;
    s->light.intensity = murk_intensity_share(light->intensity);
    s->light.where = strcpy(copy, where);
    if (portals > 0) {
        memcpy(portal, light->portal, portals * sizeof *portal);
    }
    s->light.portal = portal;
    s->light.portals = portals;
    lights->n = i + 1;

    /* Check the light and convert power or irradiance to watts. */
    s->domain = &lights->domain;
    const murk_status status = murk_source_state_prepare(s, lights->bands, err);
    if (status) {
        return status;
    }
    for (size_t b = 0; b < lights->bands; ++b) {
        const double power = s->power_scale * light->power_w.band[b];
        lights->power_w[i * lights->bands + b] = power;
        lights->all_power_w += power;
    }
    return MURK_OK;
}

/* Deals photons in proportion to weight_of[channels]. */
static murk_status deal_by(murk_sources *lights, const double *weight_of,
                           murk_error *err)
{
    const size_t channels = lights->n * lights->bands;
    double *weight = calloc(channels, sizeof *weight);
    if (!weight) {
        return murk_no_memory(err, "lights", "for %zu channels", channels);
    }
    lights->n_dealt = 0;
    for (size_t c = 0; c < channels; ++c) {
        if (weight_of[c] > 0) {
            weight[lights->n_dealt] = weight_of[c];
            lights->dealt[lights->n_dealt++] = c;
        }
    }
    murk_deal_limits(weight, lights->n_dealt, lights->limit);
    free(weight);
    return MURK_OK;
}

static murk_status deal_out(murk_sources *lights, murk_error *err)
{
    if (!isfinite(lights->all_power_w)) {
        return murk_fail(err, MURK_BAD_VALUE, "lights",
                         "power of all lights is %g W, must be finite",
                         lights->all_power_w);
    }
    for (size_t c = 0; c < lights->n * lights->bands; ++c) {
        lights->n_lit += lights->power_w[c] > 0;
    }
    return deal_by(lights, lights->power_w, err);
}

murk_status murk_sources_deal_by(murk_sources *lights, const double *weight,
                                 murk_error *err)
{
    for (size_t c = 0; c < lights->n * lights->bands; ++c) {
        assert(weight[c] > 0 || !(lights->power_w[c] > 0));
    }
    return deal_by(lights, weight, err);
}

murk_status murk_sources_create(murk_sources **out, const murk_source *lights,
                                size_t n_lights, int bands,
                                const murk_domain *domain, murk_error *err)
{
    assert(out && domain && bands >= 1 && bands <= MURK_BANDS_MAX);
    murk_sources *made = NULL;
    murk_status status = check_set(n_lights, domain, err);
    if (status) {
        goto done;
    }
    /* Memory for all lights and channels. */
    made = calloc(1, sizeof *made);
    if (made) {
        const size_t channels = n_lights * (size_t)bands;
        made->domain = *domain;
        made->bands = (size_t)bands;
        made->sources = calloc(n_lights, sizeof *made->sources);
        made->power_w = calloc(channels, sizeof *made->power_w);
        made->dealt = calloc(channels, sizeof *made->dealt);
        made->limit = calloc(channels, sizeof *made->limit);
    }
    if (!made || !made->sources || !made->power_w || !made->dealt ||
        !made->limit) {
        status = murk_no_memory(err, "lights", "for %zu lights", n_lights);
        goto done;
    }
    /* Prepare each light, then the shares of the channels. */
    for (size_t i = 0; i < n_lights; ++i) {
        status = add(made, i, &lights[i], err);
        if (status) {
            goto done;
        }
    }
    status = deal_out(made, err);
    if (status) {
        goto done;
    }
    *out = made;
    made = NULL;
done:
    murk_sources_destroy(made);
    return status;
}

void murk_sources_destroy(murk_sources *lights)
{
    if (lights) {
        for (size_t i = 0; i < lights->n; ++i) {
            murk_source_state_release(&lights->sources[i]);
        }
        free(lights->sources);
        free(lights->power_w);
        free(lights->dealt);
        free(lights->limit);
        free(lights);
    }
}

size_t murk_sources_channels(const murk_sources *lights)
{
    return lights->n * lights->bands;
}

double murk_sources_channel_power_w(const murk_sources *lights, size_t channel)
{
    assert(channel < murk_sources_channels(lights));
    return lights->power_w[channel];
}

double murk_sources_power_w(const murk_sources *lights)
{
    return lights->all_power_w;
}

size_t murk_sources_lit(const murk_sources *lights)
{
    return lights->n_lit;
}

bool murk_sources_deal_alike(const murk_sources *a, const murk_sources *b)
{
    const size_t n = a->n_dealt;
    return n == b->n_dealt && n > 0 &&
           memcmp(a->dealt, b->dealt, n * sizeof *a->dealt) == 0 &&
           memcmp(a->limit, b->limit, (n - 1) * sizeof *a->limit) == 0;
}

size_t murk_sources_dealt(const murk_sources *lights)
{
    return lights->n_dealt;
}

size_t murk_sources_channel_of(const murk_sources *lights, uint64_t photon)
{
    assert(lights->n_dealt > 0);
    return lights->dealt[murk_deal_one(lights->limit, lights->n_dealt, photon)];
}

void murk_sources_deal(const murk_sources *lights, uint64_t n, uint64_t *count)
{
    /* The counts of the channels that are dealt to are written to the front of
     * the array. These channels are in ascending order, so moving them from the
     * last to the first needs no copy. */
    murk_deal_count(lights->limit, lights->n_dealt, n, count);
    size_t k = lights->n_dealt;
    for (size_t c = murk_sources_channels(lights); c-- > 0;) {
        count[c] = k > 0 && lights->dealt[k - 1] == c ? count[--k] : 0;
        count[c] = lights->power_w[c] > 0 ? count[c] : 0;
    }
}

murk_ray murk_sources_emit(const murk_sources *lights, uint32_t seed,
                           uint32_t stream, uint64_t photon)
{
    return murk_sources_emit_in(lights, murk_sources_channel_of(lights, photon),
                                seed, stream, photon);
}

murk_ray murk_sources_emit_in(const murk_sources *lights, size_t channel,
                              uint32_t seed, uint32_t stream, uint64_t photon)
{
    const murk_source_state *source = &lights->sources[channel / lights->bands];
    const uint32_t purpose = MURK_EMIT + MURK_STREAM * stream;
    double u[MURK_ENTRY_FACES_NUMBERS] = {0};
    const murk_random4 four = murk_random(seed, purpose, photon, 0, 0);
    memcpy(u, four.u, sizeof four.u);
    if (source->entry_faces) {
        const murk_random4 more = murk_random(seed, purpose, photon, 0, 1);
        memcpy(u + 4, more.u, sizeof more.u);
    }
    return murk_source_state_emit(source, u);
}

bool murk_sources_portal_is_lit(const murk_sources *lights, size_t light,
                                size_t portal)
{
    assert(light < lights->n);
    const murk_source_state *source = &lights->sources[light];
    assert(portal < source->light.portals);
    return murk_entry_faces_one_m2(source->entry_faces, portal) > 0;
}

bool murk_sources_place(const murk_sources *lights, size_t light,
                        murk_vec3 *out)
{
    assert(light < lights->n);
    const murk_source *l = &lights->sources[light].light;
    if (murk_source_is_distant(l)) {
        return false;
    }
    const murk_source_row *row = murk_source_row_of(l);
    *out = row->middle ? row->middle(l) : l->position;
    return true;
}

const murk_source_state *murk_sources_state(const murk_sources *lights,
                                            size_t light)
{
    assert(light < lights->n);
    return &lights->sources[light];
}

size_t murk_sources_count(const murk_sources *lights)
{
    return lights->n;
}

const murk_source *murk_sources_get(const murk_sources *lights, size_t light)
{
    assert(light < lights->n);
    return &lights->sources[light].light;
}
