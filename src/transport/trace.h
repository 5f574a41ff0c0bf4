/* The photon tracer: Russian roulette at surfaces and in media, an exact
 * energy ledger, and one callback an event.
 *
 * A photon is a packet of MURK_PACKET quanta. At a surface one number u
 * decides (SPOQ paper, 3.1; Arvo and Kirk, SIGGRAPH 1990,
 * doi:10.1145/97879.97886): [0, d] reflected diffusely, (d, d+s] mirrored,
 * (d+s, d+s+t] transmitted, else absorbed. At a collision in a medium it is
 * scattered with probability albedo, else absorbed. At the boundary of a region
 * or solid with an index, Snell and exact unpolarised Fresnel, by roulette; the
 * index is that of the innermost solid, else of the last listed region around
 * (medium/interfaces.h), else 1; on waves, facet by facet
 * (transport/facets.h). Nothing here can fail: what cannot be followed
 * is counted as lost, by cause.
 *
 * Where least_weight is below 1, a photon that has more than that share of its
 * packet left is not put to the roulette: it leaves the absorbed part of its
 * quanta behind and goes on with the rest; from that share down, roulette. So
 * no quantum is ever made, and no mean changes. */
#ifndef MURK_TRANSPORT_TRACE_H
#define MURK_TRANSPORT_TRACE_H

#include "base/status.h"
#include "base/tally.h"
#include "geometry/boundary_meshes.h"
#include "geometry/surfaces.h"
#include "medium/media.h"
#include "source/sources.h"
#include "transport/tallies.h"

/* Everything that a photon can meet; borrowed, immutable. */
typedef struct murk_transport_world {
    const murk_surfaces *surfaces;
    const murk_media *media;
    const murk_sources *lights;
    murk_domain domain;
    int bands;
    const murk_boundary_meshes
        *boundary_meshes; /* of the regions that are meshes; NULL: none */
    bool continues; /* outside of open sides the media go on, for light of sun
                       and sky that enters there: transport/outside.h */
} murk_transport_world;

typedef enum murk_event_kind {
    MURK_EVENT_EMITTED,
    MURK_EVENT_SURFACE, /* met a material; `outcome` says what came of it */
    MURK_EVENT_MEDIUM,  /* a real collision */
    MURK_EVENT_WRAPPED, /* left one side of a periodic domain, entered another
                         */
    MURK_EVENT_ESCAPED,
    MURK_EVENT_LOST,
    MURK_EVENT_INTERFACE /* met the boundary of a region (whose number stands
                            for a material's) where the index changes */
} murk_event_kind;

typedef enum murk_outcome {
    MURK_ABSORBED,
    MURK_DIFFUSE,     /* surfaces: reflected by cosine law */
    MURK_MIRRORED,    /* surfaces: specular, Fresnel and total reflection */
    MURK_TRANSMITTED, /* surfaces: through a sheet, or refracted */
    MURK_SCATTERED    /* media */
} murk_outcome;

/* What lay between lamp and event: the paper's and Jensen's classes. */
typedef enum murk_event_class {
    MURK_CLASS_FIRST,    /* first event since the lamp */
    MURK_CLASS_SPECULAR, /* only mirrors and transmissions before */
    MURK_CLASS_LATER
} murk_event_class;

typedef enum murk_loss {
    MURK_LOSS_EVENTS,    /* more than events_max events, or facets at waves */
    MURK_LOSS_WRAPS,     /* more than wraps_max wraps without another event */
    MURK_LOSS_NUMERICAL, /* not a finite position, or none inside the domain */
    MURK_LOSSES
} murk_loss;

typedef struct murk_event {
    murk_event_kind kind;
    murk_outcome outcome;
    murk_event_class event_class;
    uint64_t photon;
    uint32_t number; /* 0 is the emission */
    uint16_t light;
    uint8_t band;
    uint8_t material_or_medium;
    murk_vec3 position;      /* wrapped: where it left */
    murk_vec3 direction_in;  /* unit, of travel, arriving; emitted: zero */
    murk_vec3 direction_out; /* unit, leaving; zero when absorbed or lost */
    murk_vec3 normal;        /* boundaries: unit, faces where it came from */
    double reflectance;      /* surfaces: diffuse share; media: albedo */
    double weight;           /* share of its packet that arrives */
    double leaving;          /* share that leaves; 0 when absorbed or lost */
    double path_m;           /* since the event before */
    double scattering_per_m; /* media: of all media at the place */
    murk_loss loss;
} murk_event;

/* Called in order along a photon; photons of one batch come in order, on one
 * thread; batches on any. */
typedef void (*murk_event_sink)(void *context, uint64_t batch,
                                const murk_event *event);

/* A straight leg of a photon's way, up to an event or to a boundary that is
 * none. */
typedef struct murk_trace_leg {
    uint64_t photon;
    uint16_t light;
    uint8_t band;
    bool is_in_solid;          /* where no media are */
    murk_inside inside;        /* regions with a boundary that it lies in */
    murk_vec3 from, direction; /* direction: unit */
    double length_m;
    double weight; /* share of its packet that flies */
    double index;  /* of refraction, where it flies */
} murk_trace_leg;

/* As murk_event_sink; told before the event that the leg ends in. */
typedef void (*murk_leg_sink)(void *context, uint64_t batch,
                              const murk_trace_leg *leg);

#define MURK_BATCH_PHOTONS                            \
    1024 /* fixed, so that no result knows of threads \
          */

typedef struct murk_trace {
    const murk_transport_world *world;
    uint32_t seed;
    uint32_t stream; /* 0: the map that chooses; 1: held out; 2: confirms */
    uint64_t first, last; /* photons [first, last); batch 0 starts at first */
    unsigned threads;
    uint32_t events_max, wraps_max;
    double least_weight; /* MURK_MIN_WEIGHT_MIN..1 */
    bool by_delta; /* free flight by delta tracking, for which the media must be
                      prepared; else by march */
    murk_event_sink sink;  /* may be NULL */
    murk_leg_sink leg;     /* may be NULL */
    void *context;         /* of both */
    murk_tallies *tallies; /* may be NULL; made for `threads` or more */
    bool takes_back;       /* the ledger and the tallies lose what these photons
                              brought them */
} murk_trace;

murk_trace murk_trace_defaults(
    void); /* threads 1; caps 1e5 events, 1e4 wraps; least weight 1 */

/* Below it, what rounding to whole quanta does could be seen. */
#define MURK_MIN_WEIGHT_MIN 1e-5

/* Energy by channel (light * bands + band), in quanta. */
typedef struct murk_ledger {
    size_t channels, materials, media;
    murk_tally *emitted, *absorbed_surfaces, *absorbed_media, *escaped,
        *lost;            /* [channels] each */
    murk_tally *absorber; /* [lanes][channels][materials + media]: each thread
                             adds to one lane, or they wait for each other */
    size_t lanes;
    murk_tally lost_photons[MURK_LOSSES];
    murk_tally photons, collisions; /* plain counts; collisions: real ones */
} murk_ledger;

/* Empty books of a world; the caller's: murk_ledger_destroy(). */
murk_status murk_ledger_create(murk_ledger **out,
                               const murk_transport_world *world,
                               murk_error *err);
void murk_ledger_destroy(murk_ledger *ledger); /* NULL is fine */

/* What one material or medium took: over all of them, absorbed_surfaces and
 * absorbed_media of that channel. */
int64_t murk_ledger_by_material(const murk_ledger *ledger, size_t channel,
                                size_t material);
int64_t murk_ledger_by_medium(const murk_ledger *ledger, size_t channel,
                              size_t medium);

/* Sum over channels of |emitted - absorbed - escaped - lost|: 0 always. */
int64_t murk_ledger_imbalance(const murk_ledger *ledger);

/* Traces and adds to the ledger and the tallies; nothing where all lights are
 * dark. Ends early when interrupted: ask murk_interrupted(). */
void murk_trace_run(const murk_trace *trace, murk_ledger *ledger);

#endif
