/* The photon tracer: Russian roulette at surfaces and in media, an exact energy
 * ledger, and a callback for each event.
 *
 * A photon is a packet of MURK_PACKET quanta. At a surface with the shares d
 * (diffuse), s (specular) and t (transmit) one random number u decides (SPOQ
 * paper, 3.1; Arvo and Kirk, SIGGRAPH 1990, doi:10.1145/97879.97886): [0, d]
 * diffuse reflection, (d, d+s] mirror reflection, (d+s, d+s+t] transmission,
 * else absorption. At a collision in a medium the photon is scattered with the
 * probability albedo, else absorbed. At the boundary of a region or solid with
 * an index of refraction, roulette decides between reflection and refraction by
 * Snell's law and the exact unpolarised Fresnel reflectance; at a boundary with
 * waves, facet by facet (transport/facets.h). At a solid, u decides first: in
 * the range (d, d+s+t] the light is reflected or refracted in this way, and s
 * and t are not used separately. The index at a place is that of the innermost
 * solid that contains the photon, else of the last listed region that contains
 * the photon (medium/interfaces.h), else 1. Tracing cannot fail: photons that
 * cannot be followed are counted as lost, by cause.
 *
 * If least_weight is below 1, a photon that has more than that share of its
 * packet left is not absorbed by roulette: the absorbed part of the quanta is
 * left behind, and the photon continues with the rest. At that share or below,
 * roulette decides about absorption. The kind of reflection and refraction is
 * always drawn. No quantum is ever created, and no mean changes. */
#ifndef MURK_TRANSPORT_TRACE_H
#define MURK_TRANSPORT_TRACE_H

#include "base/status.h"
#include "base/tally.h"
#include "geometry/boundary_meshes.h"
#include "geometry/surfaces.h"
#include "medium/media.h"
#include "source/sources.h"
#include "transport/tallies.h"

/* The world in which photons travel. All objects behind the pointers must
 * outlive the world and are immutable. */
typedef struct murk_transport_world {
    const murk_surfaces *surfaces;
    const murk_media *media;
    const murk_sources *lights;
    murk_domain domain;
    int bands;
    const murk_boundary_meshes
        *boundary_meshes; /* of regions that are meshes; NULL: none */
    bool continues; /* the media continue outside of open sides, for light of
                     * sun and sky that enters there (transport/outside.h) */
} murk_transport_world;

typedef enum murk_event_kind {
    MURK_EVENT_EMITTED,
    MURK_EVENT_SURFACE, /* hit a material; `outcome` has the result */
    MURK_EVENT_MEDIUM,  /* a real collision */
    MURK_EVENT_WRAPPED, /* left a periodic domain through a side and entered
                         * through the opposite one */
    MURK_EVENT_ESCAPED,
    MURK_EVENT_LOST,
    MURK_EVENT_INTERFACE /* passed or reflected at the boundary of a region
                          * (whose number takes the place of that of a material)
                          * at which the index changes */
} murk_event_kind;

typedef enum murk_outcome {
    MURK_ABSORBED,
    MURK_DIFFUSE,     /* surfaces: reflected by the cosine law */
    MURK_MIRRORED,    /* surfaces and interfaces: mirror, Fresnel and total
                       * reflection */
    MURK_TRANSMITTED, /* surfaces and interfaces: transmitted by a sheet, or
                       * refracted */
    MURK_SCATTERED    /* media */
} murk_outcome;

/* The history of a photon before an event (wraps do not count): the classes of
 * the SPOQ paper and of Jensen. */
typedef enum murk_event_class {
    MURK_CLASS_FIRST,    /* first event since the emission */
    MURK_CLASS_SPECULAR, /* only MURK_MIRRORED and MURK_TRANSMITTED before */
    MURK_CLASS_LATER
} murk_event_class;

/* The causes for which photons are lost. */
typedef enum murk_loss {
    MURK_LOSS_EVENTS, /* more than events_max segments, each up to an event or
                         to a boundary that is none; or too many facets of waves
                       */
    MURK_LOSS_WRAPS,  /* more than wraps_max wraps without another event */
    MURK_LOSS_NUMERICAL, /* a position that is not finite or not inside the
                            domain, or more than MURK_PATH_SOLIDS_MAX solids
                            that contain the photon */
    MURK_LOSSES
} murk_loss;

/* An event on the path of a photon. */
typedef struct murk_event {
    murk_event_kind kind;
    murk_outcome outcome;
    murk_event_class event_class;
    uint64_t photon;
    uint32_t number; /* 0: the emission; boundaries that are no event are
                        numbered, too */
    uint16_t light;
    uint8_t band;
    uint8_t material_or_medium;
    murk_vec3 position;      /* wrapped: where the photon left, which after a
                              * jump (transport/jump.h) may be outside of the
                              * domain */
    murk_vec3 direction_in;  /* unit, of travel, arriving; emitted: zero */
    murk_vec3 direction_out; /* unit, leaving; zero when absorbed or lost */
    murk_vec3 normal;        /* surfaces and interfaces: unit, on the side
                                from which the photon came */
    double reflectance;      /* surfaces: diffuse reflectance; media: albedo */
    double weight;           /* share of the packet that arrives */
    double leaving;          /* share of the packet that leaves; 0 when absorbed
                              * or lost */
    double path_m;           /* length since the previous event; lost photons:
                              * without the last segment */
    double scattering_per_m; /* media: scattering coefficient of all media at
                              * the position */
    murk_loss loss;
} murk_event;

/* Called in order along a photon. Photons of one batch are reported in order
 * (unless takes_any_order), on one thread; batches on any thread. */
typedef void (*murk_event_sink)(void *context, uint64_t batch,
                                const murk_event *event);

/* A straight segment of the path of a photon, up to an event or to a boundary
 * at which the index does not change. */
typedef struct murk_trace_segment {
    uint64_t photon;
    uint16_t light;
    uint8_t band;
    bool is_in_solid;          /* inside a solid, in which there are no media */
    murk_inside inside;        /* regions with a boundary that contain the
                                * segment */
    murk_vec3 from, direction; /* direction: unit */
    double length_m;
    double weight; /* share of the packet on the segment */
    double index;  /* refractive index on the segment */
} murk_trace_segment;

/* As murk_event_sink; called before the event at which the segment ends, if
 * there is one. */
typedef void (*murk_segment_sink)(void *context, uint64_t batch,
                                  const murk_trace_segment *segment);

#define MURK_BATCH_PHOTONS                              \
    1024 /* fixed, so that no result depends on threads \
          */

typedef struct murk_trace {
    const murk_transport_world *world;
    uint32_t seed;
    uint32_t stream; /* 0: the map from which a plan is chosen; other streams
                      * have independent random numbers (plan/plan.h,
                      * render/render.c) */
    uint64_t first, last; /* photons [first, last); batch 0 starts at first */
    const uint64_t
        *batch; /* [batches] only these batches: batch k of the call has the
                   photons of [first, last) that are numbered from
                   batch[k] * MURK_BATCH_PHOTONS on; NULL: all photons */
    size_t batches;
    const uint32_t *photon; /* [last]: the photons are photon[first] to
                               photon[last - 1], each at most once; NULL: the
                               numbers themselves */
    unsigned threads;
    uint32_t events_max, wraps_max;
    double least_weight; /* MURK_MIN_WEIGHT_MIN..1 */
    bool by_delta; /* free flight by delta tracking, for which the media must be
                    * prepared; otherwise by marching */
    murk_event_sink sink; /* may be NULL */
    bool takes_any_order; /* the sink takes the events of the photons of a batch
                           * in any order; the events of one photon stay in
                           * order. Such photons
                           * may be traced side by side (transport/lanes.h) */
    bool skips_surfaces, skips_media; /* the sink has no use for events of the
                                       * kind MURK_EVENT_SURFACE, or
                                       * MURK_EVENT_MEDIUM: they may be left
                                       * out */
    bool skips_ends; /* nor for emissions and for events at which nothing of
                      * the packet leaves */
    murk_segment_sink segment_sink; /* may be NULL */
    void *context;                  /* context of both callbacks */
    murk_tallies *tallies; /* may be NULL; created for at least `threads`
                            * threads */
    bool takes_back;       /* subtract the contributions of these photons from
                            * the ledger and the tallies */
} murk_trace;

/* The photon in a place of [first, last). */
static inline uint64_t murk_trace_photon(const murk_trace *trace,
                                         uint64_t place)
{
    return trace->photon ? trace->photon[place] : place;
}

murk_trace murk_trace_defaults(
    void); /* threads 1; caps 1e5 events, 1e4 wraps; least weight 1 */

/* Below this weight, rounding to whole quanta would be noticeable. */
#define MURK_MIN_WEIGHT_MIN 1e-5

/* Energy by channel (light * bands + band), in quanta. */
typedef struct murk_ledger {
    size_t channels, materials, media;
    murk_tally *emitted, *absorbed_surfaces, *absorbed_media, *escaped,
        *lost;            /* [channels] each */
    murk_tally *absorber; /* [lanes][channels][materials + media]: threads add
                           * to different lanes, so that they do not wait for
                           * each other */
    size_t lanes;
    murk_tally lost_photons[MURK_LOSSES];
    murk_tally photons, collisions; /* plain counts; collisions: real ones */
} murk_ledger;

/* Creates an empty ledger for a world with at least one light and one material.
 * The caller destroys it with murk_ledger_destroy(). Fails with
 * MURK_NO_MEMORY. */
murk_status murk_ledger_create(murk_ledger **out,
                               const murk_transport_world *world,
                               murk_error *err);
void murk_ledger_destroy(murk_ledger *ledger); /* NULL is fine */

/* The energy that one material or medium absorbed in a channel. The sum over
 * all materials is absorbed_surfaces, the sum over all media is
 * absorbed_media. */
int64_t murk_ledger_by_material(const murk_ledger *ledger, size_t channel,
                                size_t material);
int64_t murk_ledger_by_medium(const murk_ledger *ledger, size_t channel,
                              size_t medium);

/* The sum over channels of |emitted - absorbed - escaped - lost|: always 0. */
int64_t murk_ledger_imbalance(const murk_ledger *ledger);

/* All sums of a ledger as one array of murk_ledger_cells() numbers, by which
 * ledgers of parts of a run are stored and added: emitted, absorbed by surfaces
 * and by media, escaped, lost ([channels] each); absorbed by each material and
 * medium ([channels][materials + media]); lost photons by cause, photons,
 * collisions. */
size_t murk_ledger_cells(const murk_ledger *ledger);
void murk_ledger_read(const murk_ledger *ledger, int64_t *cell);
void murk_ledger_add(murk_ledger *ledger, const int64_t *cell);

/* The numbers of cells before the absorbers, and of absorbers. */
size_t murk_ledger_accounts(const murk_ledger *ledger);
size_t murk_ledger_absorbers(const murk_ledger *ledger);

/* Traces the photons and adds to the ledger and the tallies; does nothing if
 * all lights are dark or there is no photon to trace. Ends early after an
 * interrupt: the caller checks murk_interrupted(). */
void murk_trace_run(const murk_trace *trace, murk_ledger *ledger);

/* False if no photon that travels along this direction jumps in a periodic
 * domain (transport/jump.h), whatever surfaces, regions and lamps there are: it
 * passes the sides too few times between bottom and top. */
bool murk_trace_may_jump(const murk_domain *domain, murk_vec3 direction);

#endif
