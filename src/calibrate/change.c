/* Compares two sets of optics medium by medium and channel by channel, and
 * differentiates them with respect to each key by central differences of the
 * optics of the scene, which have no noise. */
#include "calibrate/change.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>

/* Ratio of the scattering coefficients. An albedo that is equal in both, such
 * as a grid, cancels. */
static double scattering_ratio(const murk_optics *traced, const murk_optics *at,
                               size_t medium, size_t band)
{
    const double t = traced->extinction_per_m[medium].band[band];
    const double a = traced->albedo[medium].band[band];
    const double t_at = at->extinction_per_m[medium].band[band];
    const double a_at = at->albedo[medium].band[band];
    return (t_at == t ? 1 : t_at / t) * (a_at == a ? 1 : a_at / a);
}

/* True if the phase functions differ. Two tables that differ by rounding alone
 * count as equal: a derivative over a small step would amplify the errors of
 * their nodes. */
static bool do_turn(const murk_optics *a, const murk_optics *b, size_t medium,
                    size_t band)
{
    const murk_phase *of_a = &a->phases->medium[medium][band];
    const murk_phase *of_b = &b->phases->medium[medium][band];
    const bool are_tables =
        of_a->kind == MURK_PHASE_TABLE && of_b->kind == MURK_PHASE_TABLE;
    return !murk_phase_is_same(of_a, of_b) &&
           !(are_tables && murk_optics_turn_alike(a, b, medium, (int)band));
}

/* Fails if the wanted optics need extinction or scattering that the traced
 * light did not have: such events are not in the histories that are
 * re-weighted. */
static murk_status check(const murk_optics *traced, const murk_optics *at,
                         size_t medium, size_t band, murk_error *err)
{
    const char *name = traced->scene->media[medium].name;
    const double t = traced->extinction_per_m[medium].band[band];
    const double a = traced->albedo[medium].band[band];
    const double t_at = at->extinction_per_m[medium].band[band];
    const double a_at = at->albedo[medium].band[band];
    char where[128];
    if ((t == 0 && t_at > 0) || (a == 0 && a_at > 0)) {
        snprintf(where, sizeof where, "media.%.80s", name);
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "%s is 0 in band %zu, which cannot be re-weighted to "
                         "%g: must start above 0",
                         t == 0 ? "extinction_per_m" : "albedo", band,
                         t == 0 ? t_at : a_at);
    }
    return MURK_OK;
}

/* Compares one medium in one band. */
static murk_status compare_medium(murk_changes *c, size_t m, size_t medium,
                                  size_t band, const murk_optics *traced,
                                  const murk_optics *at,
                                  const murk_optics_sides *sides,
                                  murk_error *err)
{
    const size_t i = m * (size_t)c->bands + band;
    const murk_phase *phase = &traced->phases->medium[medium][band];
    const murk_status status = check(traced, at, medium, band, err);
    if (status) {
        return status;
    }
    /* Values. */
    murk_medium_change *change = &c->medium[i];
    *change = (murk_medium_change){
        .scattering = scattering_ratio(traced, at, medium, band),
        .more_per_m = at->extinction_per_m[medium].band[band] -
                      traced->extinction_per_m[medium].band[band],
        .traced = phase,
        .at = &at->phases->medium[medium][band]};
    change->log_scattering =
        change->scattering > 0 ? log(change->scattering) : 0;
    change->turns = do_turn(traced, at, medium, band);
    c->any_turns |= change->turns;
    /* Derivatives. */
    for (size_t k = 0; k < c->keys; ++k) {
        if (!(c->span[k] > 0)) {
            continue;
        }
        const murk_optics *low = sides[k].low, *high = sides[k].high;
        murk_change_slope *slope =
            &c->slope[k * c->media * (size_t)c->bands + i];
        *slope = (murk_change_slope){
            .scattering = (scattering_ratio(traced, high, medium, band) -
                           scattering_ratio(traced, low, medium, band)) /
                          c->span[k],
            .more_per_m = (high->extinction_per_m[medium].band[band] -
                           low->extinction_per_m[medium].band[band]) /
                          c->span[k],
            .low = &low->phases->medium[medium][band],
            .high = &high->phases->medium[medium][band]};
        slope->turns = do_turn(low, high, medium, band);
        c->any_turns |= slope->turns;
    }
    return MURK_OK;
}

static double power_ratio(double traced_w, double at_w)
{
    return at_w == traced_w ? 1 : at_w / traced_w;
}

/* Compares the power of one channel. */
static murk_status compare_power(murk_changes *c, size_t channel,
                                 const murk_optics *traced,
                                 const murk_optics *at,
                                 const murk_optics_sides *sides,
                                 murk_error *err)
{
    /* Power cannot be created by re-weighting. */
    const double traced_w = traced->power_w[channel];
    const double at_w = at->power_w[channel];
    if (traced_w == 0 && at_w > 0) {
        char where[64];
        snprintf(where, sizeof where, "lights.%zu",
                 traced->scene->lights[channel / (size_t)c->bands].item);
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "its power is 0 in band %zu, which cannot be "
                         "re-weighted to %g W: must start above 0",
                         channel % (size_t)c->bands, at_w);
    }
    /* Ratio and derivatives. */
    c->power[channel] = power_ratio(traced_w, at_w);
    for (size_t k = 0; k < c->keys && traced_w > 0; ++k) {
        if (c->span[k] > 0) {
            c->power_slope[k * c->channels + channel] =
                (sides[k].high->power_w[channel] -
                 sides[k].low->power_w[channel]) /
                (c->span[k] * traced_w);
        }
    }
    return MURK_OK;
}

murk_status murk_changes_create(murk_changes *c,
                                const murk_histories *histories,
                                const murk_optics *traced,
                                const murk_optics *at,
                                const murk_optics_sides *sides, size_t keys,
                                murk_error *err)
{
    assert(traced->channels == histories->channels &&
           at->channels == histories->channels && at->media == traced->media);
    *c = (murk_changes){.media = histories->media,
                        .channels = histories->channels,
                        .keys = keys,
                        .bands = traced->bands};
    const size_t bands = (size_t)c->bands, cells = c->media * bands;
    murk_arena *arena = &c->arena;
    c->span = murk_arena_array(arena, keys, sizeof *c->span);
    c->medium = murk_arena_array(arena, cells, sizeof *c->medium);
    c->slope = murk_arena_array(arena, keys * cells, sizeof *c->slope);
    c->power = murk_arena_array(arena, c->channels, sizeof *c->power);
    c->power_slope =
        murk_arena_array(arena, keys * c->channels, sizeof *c->power_slope);
    if (arena->is_short) {
        return murk_no_memory(err, "fit", "for %zu parameters", keys);
    }
    /* Step of each key; 0 for keys without effect. */
    for (size_t k = 0; k < keys; ++k) {
        assert(!sides[k].low || (sides[k].high && sides[k].span > 0));
        c->span[k] = sides[k].low ? sides[k].span : 0;
    }
    /* Media, then light sources. */
    murk_status status = MURK_OK;
    for (size_t i = 0; i < cells && !status; ++i) {
        status = compare_medium(c, i / bands, histories->medium[i / bands],
                                i % bands, traced, at, sides, err);
    }
    for (size_t channel = 0; channel < c->channels && !status; ++channel) {
        status = compare_power(c, channel, traced, at, sides, err);
    }
    return status;
}

void murk_changes_release(murk_changes *c)
{
    murk_arena_release(&c->arena);
}
