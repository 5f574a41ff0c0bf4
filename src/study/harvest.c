#include "study/harvest.h"

#include <stdlib.h>

#define FIRST_ROOM 256

static murk_photon record_of(const murk_event *event, double share)
{
    const bool is_volume = event->kind == MURK_EVENT_MEDIUM;
    return (murk_photon){
        .position_m = {(float)event->position.x, (float)event->position.y,
                       (float)event->position.z},
        .direction = murk_direction_pack(event->direction_in),
        .normal = is_volume ? 0 : murk_direction_pack(event->normal),
        .power_w = (float)share,
        .emitted = (uint32_t)event->photon,
        .band = event->band,
        .light = (uint8_t)event->light,
        .material = event->material_or_medium,
        .kind = murk_photon_kind(is_volume, (int)event->event_class)};
}

static bool put(murk_pile *pile, const murk_photon *photon)
{
    if (pile->n == pile->room) {
        const size_t room =
            pile->room ? pile->room + pile->room / 2 : FIRST_ROOM;
        murk_photon *grown = realloc(pile->photon, room * sizeof *grown);
        if (!grown) {
            return false;
        }
        pile->photon = grown;
        pile->room = room;
    }
    pile->photon[pile->n++] = *photon;
    return true;
}

murk_harvest *murk_harvest_create(const murk_scene_photons *wish)
{
    murk_harvest *h = calloc(1, sizeof *h);
    if (h) {
        h->wish = wish;
        h->keeps_surface = wish->maps == MURK_SCENE_MAPS_BOTH ||
                           wish->maps == MURK_SCENE_MAPS_SURFACE;
        h->keeps_volume = wish->maps == MURK_SCENE_MAPS_BOTH ||
                          wish->maps == MURK_SCENE_MAPS_VOLUME;
    }
    return h;
}

void murk_harvest_destroy(murk_harvest *h)
{
    if (h) {
        for (size_t i = 0; i < MURK_WAVE_BATCHES; ++i) {
            free(h->pile[i].photon);
        }
        free(h->surface.photon);
        free(h->volume.photon);
        free(h);
    }
}

double murk_harvest_share(const murk_harvest *h, const murk_event *event)
{
    if (event->kind == MURK_EVENT_SURFACE && h->keeps_surface) {
        return h->wish->store_hits ? event->weight * event->reflectance
               : event->outcome == MURK_DIFFUSE ? event->leaving
                                                : 0;
    }
    if (event->kind == MURK_EVENT_MEDIUM && h->keeps_volume) {
        return h->wish->store_hits ? event->weight * event->reflectance
               : event->outcome == MURK_SCATTERED ? event->leaving
                                                  : 0;
    }
    return 0;
}

void murk_harvest_event(void *context, uint64_t batch, const murk_event *event)
{
    murk_harvest *h = context;
    const double share = murk_harvest_share(h, event);
    if (share > 0) {
        const murk_photon photon = record_of(event, share);
        murk_pile *pile = &h->pile[batch];
        pile->is_short_of_memory |= !put(pile, &photon);
    }
}

uint64_t murk_harvest_photon_of(const murk_harvest *h, uint64_t wanted)
{
    uint64_t before = 0;
    for (size_t b = 0; b < MURK_WAVE_BATCHES; ++b) {
        const murk_pile *pile = &h->pile[b];
        if (before + pile->n >= wanted) {
            return pile->photon[wanted - before - 1].emitted;
        }
        before += pile->n;
    }
    return UINT64_MAX;
}

murk_status murk_harvest_gather(murk_harvest *h, uint64_t last, murk_error *err)
{
    for (size_t b = 0; b < MURK_WAVE_BATCHES; ++b) {
        murk_pile *pile = &h->pile[b];
        bool fits = !pile->is_short_of_memory;
        for (size_t i = 0;
             fits && i < pile->n && pile->photon[i].emitted <= last; ++i) {
            const murk_photon *photon = &pile->photon[i];
            fits = put(murk_photon_is_volume(photon) ? &h->volume : &h->surface,
                       photon);
        }
        if (!fits) {
            return murk_fail(err, MURK_NO_MEMORY, h->wish->where,
                             "no memory for more than %.3g stored photons",
                             (double)(h->surface.n + h->volume.n));
        }
        pile->n = 0;
    }
    if (h->surface.n + h->volume.n > h->wish->max_stored) {
        return murk_fail(err, MURK_RUN_FAILED, h->wish->where,
                         "max_stored: more than %llu photons were stored",
                         (unsigned long long)h->wish->max_stored);
    }
    return MURK_OK;
}

static void price(murk_pile *pile, const double *packet_w, int bands)
{
    for (size_t i = 0; i < pile->n; ++i) {
        murk_photon *p = &pile->photon[i];
        const size_t channel = (size_t)p->light * (size_t)bands + p->band;
        p->power_w = (float)((double)p->power_w * packet_w[channel]);
    }
}

void murk_harvest_price(murk_harvest *h, const double *packet_w, int bands)
{
    price(&h->surface, packet_w, bands);
    price(&h->volume, packet_w, bands);
}

murk_status murk_harvest_map(murk_photon_map **out, murk_pile *pile,
                             unsigned threads, murk_error *err)
{
    murk_photon *photons = pile->photon;
    const size_t n = pile->n;
    if (n == 0) {
        free(photons);
        photons = NULL;
    } else if (n < pile->room) {
        murk_photon *fitted = realloc(photons, n * sizeof *fitted);
        if (fitted) {
            photons = fitted;
        }
    }
    *pile = (murk_pile){0};
    return murk_photon_map_create(out, photons, n, threads, err);
}
