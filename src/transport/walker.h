/* The state of a photon under way, and what every event needs: random numbers,
 * the report to the sink, the score of a segment, the split of the packet.
 * For use inside src/transport only. */
#ifndef MURK_TRANSPORT_WALKER_H
#define MURK_TRANSPORT_WALKER_H

#include "base/rng.h"
#include "path/path.h"
#include "path/solids.h"
#include "transport/score.h"
#include "transport/trace.h"

#define MURK_EMISSIONS_MAX (MURK_SOURCES_MAX * MURK_BANDS_MAX)

/* The end of a photon, in the order of the accounts absorbed_surfaces,
 * absorbed_media, escaped and lost of the ledger (transport/trace.h). */
typedef enum murk_fate {
    MURK_FATE_SURFACES, /* absorbed by a surface */
    MURK_FATE_MEDIA,    /* absorbed by a medium */
    MURK_FATE_ESCAPED,
    MURK_FATE_LOST,
    MURK_FATES,
    MURK_FATE_NONE = MURK_FATES /* the photon continues */
} murk_fate;

/* The data that all photons of a run share. */
typedef struct murk_walk_setup {
    const murk_trace *trace;
    const murk_transport_world *world;
    murk_path_space space;
    double in_plane_m; /* a surface nearer than this to the plane of a tally
                          counts as lying in that plane */
    bool any_media;
    bool jumps;              /* the domain is periodic, and the ray may jump:
                              * transport/jump.h */
    const double (*busy)[2]; /* [n_busy] ranges of heights that are
                              * not free */
    size_t n_busy;
    uint32_t purpose_shift;
    int64_t min_quanta; /* roulette decides about a photon that has at most this
                         * number of quanta left */
} murk_walk_setup;

/* Sums of one batch: adding to the shared ledger photon by photon would make
 * the threads wait for each other. */
typedef struct murk_sums {
    uint16_t emitted[MURK_EMISSIONS_MAX];          /* photons */
    int64_t ended[MURK_EMISSIONS_MAX][MURK_FATES]; /* quanta */
    uint16_t lost[MURK_LOSSES];
    uint64_t collisions;
    murk_tally
        *absorber; /* cells of the ledger, in the lane of this thread: changed
                      at each absorption, not at the end of the batch */
    size_t materials, absorbers;
    murk_scorer *scorer; /* NULL: no tallies */
} murk_sums;

/* A photon under way. */
typedef struct murk_walker {
    const murk_walk_setup *setup;
    murk_sums *sums;
    uint64_t batch, photon;
    int64_t quanta; /* of the packet that are left */
    size_t channel, light;
    size_t absorber; /* the material or medium met most recently: materials are
                      * numbered first, then media */
    int band;
    uint32_t number, wraps;
    murk_event_class event_class;
    murk_path path;  /* begins at the position of the photon */
    murk_vec3 probe; /* start of the search for surfaces */
    murk_path_solids solids;
    double silent_m;        /* length flown since the last event, up to the last
                             * boundary that was no event */
    bool is_beyond;         /* the surface met last transmitted the photon */
    murk_score_path *score; /* NULL: no tallies */
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

/* Adds quanta that a material or medium absorbs to the ledger. */
static inline void murk_walker_keep(const murk_walker *w, size_t absorber,
                                    int64_t quanta)
{
    murk_tally_add(
        &w->sums->absorber[w->channel * w->sums->absorbers + absorber],
        w->setup->trace->takes_back ? -quanta : quanta);
}

/* Splits the packet: the absorber keeps all but the share `survival` of the
 * quanta; u in (0, 1) rounds without bias. False, without a change, if the
 * packet has too few quanta: then roulette must decide. */
static inline bool murk_walker_splits(murk_walker *w, double survival, double u,
                                      murk_fate fate, size_t absorber)
{
    if (w->quanta <= w->setup->min_quanta) {
        return false;
    }
    const int64_t left = (int64_t)floor((double)w->quanta * survival + u);
    const int64_t quanta = left < w->quanta ? left : w->quanta;
    w->sums->ended[w->channel][fate] += w->quanta - quanta;
    murk_walker_keep(w, absorber, w->quanta - quanta);
    w->quanta = quanta;
    return true;
}

/* Sets the members of an event that all events have in common; the others are
 * 0. Member by member and in place, because compilers clear or copy a whole
 * event with instructions that take longer than all the rest. */
static inline void murk_walker_event(murk_event *event, const murk_walker *w,
                                     murk_event_kind kind)
{
    const murk_vec3 none = {0, 0, 0};
    event->kind = kind;
    event->outcome = MURK_ABSORBED;
    event->event_class = w->event_class;
    event->photon = w->photon;
    event->number = w->number;
    event->light = (uint16_t)w->light;
    event->band = (uint8_t)w->band;
    event->material_or_medium = 0;
    event->position = w->path.position;
    event->direction_in = w->path.direction;
    event->direction_out = none;
    event->normal = none;
    event->reflectance = 0;
    event->weight = event->leaving = murk_packet_share(w->quanta);
    event->path_m = 0;
    event->scattering_per_m = 0;
    event->loss = MURK_LOSS_EVENTS;
}

static inline void murk_walker_tell(murk_walker *w, murk_event *event)
{
    event->path_m += w->silent_m;
    w->silent_m = 0;
    w->setup->trace->sink(w->setup->trace->context, w->batch, event);
}

/* True if the events are reported to a sink. */
static inline bool murk_walker_is_heard(const murk_walker *w)
{
    return w->setup->trace->sink != NULL;
}

/* The index of refraction inside these solids, that of the innermost one; if
 * there are none, that inside these regions. */
static inline double murk_walker_index(const murk_walker *w,
                                       const murk_path_solids *solids,
                                       murk_inside inside)
{
    return solids->n > 0 ? murk_path_solids_index(solids)
                         : murk_media_index(w->setup->world->media, inside);
}

/* Scores a segment of the path, if there are tallies, and reports the segment
 * to the sink of segments, if there is one. Plane tallies take `end` as the end
 * of the segment: at a side of the domain `end` lies slightly outside, so that
 * a plane in the side counts the photon. reach_m as in murk_station
 * (transport/score.h). */
static inline void murk_walker_score(const murk_walker *w, murk_vec3 from,
                                     double length_m, int64_t quanta,
                                     murk_vec3 end, double reach_m)
{
    const murk_trace *trace = w->setup->trace;
    if (w->score) {
        murk_score_segment(w->score, from, w->path.direction, length_m,
                           (double)quanta, (murk_station){end, reach_m});
    }
    /* The sink of segments. */
    if (trace->segment_sink) {
        const murk_trace_segment segment = {
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
        trace->segment_sink(trace->context, w->batch, &segment);
    }
}

static inline murk_fate murk_walker_lose(murk_walker *w, murk_loss loss)
{
    ++w->sums->lost[loss];
    if (murk_walker_is_heard(w)) {
        murk_event event;
        murk_walker_event(&event, w, MURK_EVENT_LOST);
        event.loss = loss;
        event.leaving = 0;
        murk_walker_tell(w, &event);
    }
    return MURK_FATE_LOST;
}

#endif
