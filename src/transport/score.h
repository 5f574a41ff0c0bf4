/* Scoring: what one photon brings to the tallies, leg by leg, until its sums
 * are added at its end. Cannot fail: all memory is there from the start.
 *
 * A photon's way is a chain of places. Planes go by that chain alone, which
 * has no gaps: where a leg ends is where the next begins, so a plane's forward
 * less backward is exactly what stays beyond it. Lengths go by the legs as they
 * were flown. Private to this room. */
#ifndef MURK_TRANSPORT_SCORE_H
#define MURK_TRANSPORT_SCORE_H

#include "transport/tallies.h"
#include "transport/wide.h"

/* A place of the chain. */
typedef struct murk_station {
    murk_vec3 place;
    double reach_m; /* a plane nearer than this has the place in it: 0 for
                       places in the open */
} murk_station;

typedef struct murk_tally_plane {
    murk_vec3 point, normal; /* unit */
    int axes[2];
    double low_m[2], bins_per_m[2]; /* along the axes */
    uint32_t bins[2], angle_bins;
    uint32_t first; /* its first cell */
} murk_tally_plane;

typedef struct murk_probe {
    murk_vec3 center;
    double radius_m;
    double per_m; /* 2^-30 of this a unit of length: 1 / diameter */
    bool hemispheres;
    uint32_t first;
} murk_probe;

typedef struct murk_lattice {
    murk_box box;
    double cells_per_m[3];
    uint32_t size[3];
    double per_m; /* 1 / a cell's diagonal */
    uint32_t first;
} murk_lattice;

typedef struct murk_tally_bin {
    murk_wide_sum sum, squares;
} murk_tally_bin;

typedef struct murk_scorer {
    const murk_tallies *tallies;
    murk_tally_bin *cell; /* of the present photon's channel */
    murk_station at;
    double *side;      /* [planes]: how far `at` is beyond each */
    double *value;     /* [cells]: of this photon; 0 between photons */
    uint32_t *touched; /* [cells]: those that are not 0 */
    size_t n_touched;
    murk_tally_bin *copy; /* [channels][cells] */
    bool is_alone;        /* no other scorer adds to it */
} murk_scorer;

struct murk_tallies {
    size_t n;
    murk_tally_desc desc[MURK_TALLIES_MAX];
    uint32_t first[MURK_TALLIES_MAX];
    murk_tally_plane plane[MURK_TALLIES_MAX];
    murk_probe probe[MURK_TALLIES_MAX];
    murk_lattice lattice[MURK_TALLIES_MAX];
    size_t planes, probes, lattices;
    size_t cells, channels;
    int bands;
    size_t scorers, copies;
    murk_scorer **scorer; /* [scorers] */
    murk_tally_bin *cell; /* [copies][channels][cells] */
};

/* Of a worker of the thread pool. */
murk_scorer *murk_tallies_scorer(murk_tallies *tallies, unsigned worker);

/* A photon of that channel starts. */
void murk_score_start(murk_scorer *scorer, size_t channel, murk_station at);

/* It went straight from here to there, along a unit direction, with so many
 * quanta; as a link of the chain the leg ends at `at`. */
void murk_score_leg(murk_scorer *scorer, murk_vec3 from, murk_vec3 direction,
                    double length_m, double quanta, murk_station at);

/* It goes on elsewhere: a periodic side. */
void murk_score_jump(murk_scorer *scorer, murk_station at);

/* It ended. takes_back: its sums are taken away instead. */
void murk_score_end(murk_scorer *scorer, bool takes_back);

/* A grid's part of a leg (score_grid.c). */
void murk_score_lattice(murk_scorer *scorer, const murk_lattice *lattice,
                        murk_vec3 from, murk_vec3 direction, double length_m,
                        double quanta);

static inline void murk_score_add(murk_scorer *scorer, uint32_t cell,
                                  double value)
{
    double *const sum = &scorer->value[cell];
    if (!(value > 0)) {
        return;
    }
    if (*sum == 0) { /* its sums are wanted at the photon's end: on their way */
        __builtin_prefetch(&scorer->cell[cell], 1);
        scorer->touched[scorer->n_touched++] = cell;
    }
    *sum += value;
}

#endif
