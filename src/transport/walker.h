/* A photon under way, and what it does wherever it is: draws its numbers, tells
 * its events, leaves quanta behind. Private to this room. */
#ifndef MURK_TRANSPORT_WALKER_H
#define MURK_TRANSPORT_WALKER_H

#include "base/rng.h"
#include "path/path.h"
#include "path/solids.h"
#include "transport/walk.h"

/* A photon under way. */
typedef struct murk_walker {
    const murk_walk_setup *setup;
    murk_sums *sums;
    uint64_t batch, photon;
    int64_t quanta; /* what is left of its packet */
    size_t channel, light;
    size_t absorber; /* that took it, where it ended so */
    int band;
    uint32_t number, wraps;
    murk_event_class event_class;
    murk_path path;  /* begins at the photon's place */
    murk_vec3 probe; /* surfaces are looked for from here on */
    murk_path_solids solids;
    double silent_m; /* flown to boundaries that were no event, since one */
    bool is_beyond;  /* the surface met last let it through */
} murk_walker;

static inline murk_address murk_walker_address(const murk_walker *w,
                                               murk_purpose purpose)
{
    return (murk_address){w->setup->trace->seed,
                          (uint32_t)purpose + w->setup->purpose_shift,
                          w->photon, w->number};
}

static inline murk_random4 murk_walker_draw(const murk_walker *w,
                                            murk_purpose purpose)
{
    const murk_address address = murk_walker_address(w, purpose);
    return murk_random_at(&address, 0);
}

static inline double murk_packet_share(int64_t quanta)
{
    return (double)quanta / (double)MURK_PACKET;
}

/* Quanta that a material or, counted on from the last of them, a medium keeps.
 */
static inline void murk_walker_keep(const murk_walker *w, size_t absorber,
                                    int64_t quanta)
{
    murk_tally_add(
        &w->sums->absorber[w->channel * w->sums->absorbers + absorber],
        w->setup->trace->takes_back ? -quanta : quanta);
}

/* Leaves behind all but the share `kept` of the photon's quanta, where it has
 * enough of them to be split; u in (0, 1) rounds without bias. False where the
 * roulette must decide instead. */
static inline bool murk_walker_splits(murk_walker *w, double kept, double u,
                                      murk_fate fate, size_t absorber)
{
    if (w->quanta <= w->setup->min_quanta) {
        return false;
    }
    const int64_t left = (int64_t)floor((double)w->quanta * kept + u);
    const int64_t quanta = left < w->quanta ? left : w->quanta;
    w->sums->ended[w->channel][fate] += w->quanta - quanta;
    murk_walker_keep(w, absorber, w->quanta - quanta);
    w->quanta = quanta;
    return true;
}

/* What all events tell. */
static inline murk_event murk_walker_event(const murk_walker *w,
                                           murk_event_kind kind)
{
    return (murk_event){.kind = kind,
                        .event_class = w->event_class,
                        .photon = w->photon,
                        .number = w->number,
                        .light = (uint16_t)w->light,
                        .band = (uint8_t)w->band,
                        .weight = murk_packet_share(w->quanta),
                        .leaving = murk_packet_share(w->quanta),
                        .position = w->path.position,
                        .direction_in = w->path.direction};
}

static inline void murk_walker_tell(murk_walker *w, murk_event *event)
{
    event->path_m += w->silent_m;
    w->silent_m = 0;
    w->setup->trace->sink(w->setup->trace->context, w->batch, event);
}

static inline bool murk_walker_is_heard(const murk_walker *w)
{
    return w->setup->trace->sink != NULL;
}

/* The index of refraction in these solids and regions. */
static inline double murk_walker_index(const murk_walker *w,
                                       const murk_path_solids *solids,
                                       murk_inside inside)
{
    return solids->n > 0 ? murk_path_solids_index(solids)
                         : murk_media_index(w->setup->world->media, inside);
}

/* A leg for the tallies, which ends for planes at `end`, and for who else wants
 * to know; reach_m: murk_station. */
static inline void murk_walker_score(const murk_walker *w, murk_vec3 from,
                                     double length_m, int64_t quanta,
                                     murk_vec3 end, double reach_m)
{
    const murk_trace *trace = w->setup->trace;
    if (w->sums->scorer) {
        murk_score_segment(w->sums->scorer, from, w->path.direction, length_m,
                           (double)quanta, (murk_station){end, reach_m});
    }
    if (trace->leg) {
        const murk_trace_leg leg = {
            .photon = w->photon,
            .light = (uint16_t)w->light,
            .band = (uint8_t)w->band,
            .is_in_solid = w->solids.n > 0,
            .inside = w->path.inside,
            .from = from,
            .direction = w->path.direction,
            .length_m = length_m,
            .weight = murk_packet_share(quanta),
            .index = murk_walker_index(w, &w->solids, w->path.inside)};
        trace->leg(trace->context, w->batch, &leg);
    }
}

static inline murk_fate murk_walker_lose(murk_walker *w, murk_loss loss)
{
    ++w->sums->lost[loss];
    if (murk_walker_is_heard(w)) {
        murk_event event = murk_walker_event(w, MURK_EVENT_LOST);
        event.loss = loss;
        event.leaving = 0;
        murk_walker_tell(w, &event);
    }
    return MURK_FATE_LOST;
}

#endif
