/* The way of one photon, from its lamp to its end. Private to this room. */
#ifndef MURK_TRANSPORT_WALK_H
#define MURK_TRANSPORT_WALK_H

#include "path/path.h"
#include "transport/score.h"
#include "transport/trace.h"

#define MURK_EMISSIONS_MAX (MURK_SOURCES_MAX * MURK_BANDS_MAX)

typedef enum murk_fate {
    MURK_FATE_SURFACES, /* absorbed there */
    MURK_FATE_MEDIA,    /* likewise */
    MURK_FATE_ESCAPED,
    MURK_FATE_LOST,
    MURK_FATES
} murk_fate;

/* What all photons of a run share. */
typedef struct murk_walk_setup {
    const murk_trace *trace;
    const murk_transport_world *world;
    murk_path_space space;
    double in_plane_m; /* a plane nearer to a surface has the surface in it */
    bool any_media;
    bool jumps; /* where the domain is periodic: transport/jump.h */
    const double (*busy)[2]; /* [n_busy] heights that are not free */
    size_t n_busy;
    uint32_t purpose_shift;
    int64_t min_quanta; /* roulette from here down */
} murk_walk_setup;

murk_walk_setup murk_walk_setup_of(const murk_trace *trace);

/* Sums of one batch: adding to the shared ledger photon by photon would make
 * the threads wait for each other. */
typedef struct murk_sums {
    uint16_t emitted[MURK_EMISSIONS_MAX];          /* photons */
    int64_t ended[MURK_EMISSIONS_MAX][MURK_FATES]; /* quanta */
    uint16_t lost[MURK_LOSSES];
    uint64_t collisions;
    murk_tally *absorber; /* the ledger's, of this thread's lane, which is added
                             to at once */
    size_t materials, absorbers;
    murk_scorer *scorer;      /* NULL: no tallies */
    bool are_segments_wanted; /* by the scorer or by the trace's own sink */
} murk_sums;

/* Traces one photon, tells its events to the trace's sink, adds to sums. */
void murk_walk_photon(const murk_walk_setup *setup, murk_sums *sums,
                      uint64_t batch, uint64_t photon);

/* The same from a place in the open, which is not told: of the first light and
 * the band. */
void murk_walk_from(const murk_walk_setup *setup, murk_sums *sums,
                    uint64_t photon, int band, murk_ray ray);

#endif
