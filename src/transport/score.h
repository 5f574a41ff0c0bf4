/* Scoring: sums the contributions of one photon to the tallies, segment by
 * segment, and adds the sums to the tallies at the end of the photon. Cannot
 * fail: all memory is allocated in advance.
 *
 * The path of a photon is a chain of positions. Planes use only this chain.
 * Each segment begins at the end of the previous one, except where the photon
 * enters through a periodic side, where the chain continues without a crossing
 * (murk_score_jump()). The forward minus the backward power of a plane is
 * therefore exactly the power that has gone to the other side and stayed there,
 * apart from such jumps. Spheres and grids use the lengths of the segments as
 * flown. For use inside src/transport only. */
#ifndef MURK_TRANSPORT_SCORE_H
#define MURK_TRANSPORT_SCORE_H

#include "transport/tallies.h"
#include "transport/wide.h"

/* A position of the chain. */
typedef struct murk_station {
    murk_vec3 place;
    double reach_m; /* a plane nearer than this contains the position: 0 for
                     * positions away from surfaces */
} murk_station;

/* A plane tally, prepared for scoring. */
typedef struct murk_tally_plane {
    murk_vec3 point, normal; /* unit */
    int axes[2];
    double low_m[2], bins_per_m[2]; /* along the axes */
    uint32_t bins[2], angle_bins;
    uint32_t first; /* number of the first cell */
} murk_tally_plane;

/* A sphere tally. */
typedef struct murk_probe {
    murk_vec3 center;
    double radius_m;
    double per_m; /* weight of a unit of length: 1 / diameter */
    bool hemispheres;
    uint32_t first;
} murk_probe;

/* A grid tally. */
typedef struct murk_lattice {
    murk_box box;
    double cells_per_m[3];
    uint32_t size[3];
    double per_m; /* weight of a unit of length: 1 / diagonal of a cell */
    uint32_t first;
} murk_lattice;

/* The integer sums of a cell and channel. */
typedef struct murk_tally_bin {
    murk_wide_sum sum, squares;
} murk_tally_bin;

/* The state of one thread. */
typedef struct murk_scorer {
    const murk_tallies *tallies;
    murk_tally_bin
        *cell; /* [cells] of the channel of the current photon, in `copy` */
    murk_station at;
    double *side;      /* [planes]: signed distance of `at` beyond each plane */
    double *value;     /* [cells]: sums of the current photon; 0 between
                        * photons */
    uint32_t *touched; /* [cells]: numbers of the cells that are not 0 */
    size_t n_touched;
    murk_tally_bin *copy; /* [channels][cells] */
    bool is_alone;        /* no other scorer adds to this copy */
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

/* The scorer of a worker of the thread pool. */
murk_scorer *murk_tallies_scorer(murk_tallies *tallies, unsigned worker);

/* Begins a photon of a channel. */
void murk_score_start(murk_scorer *scorer, size_t channel, murk_station at);

/* Adds a straight segment along a unit direction with a number of quanta.
 * Lengths are taken from `from`, direction and length_m. The chain continues
 * from its last position to `at`. */
void murk_score_segment(murk_scorer *scorer, murk_vec3 from,
                        murk_vec3 direction, double length_m, double quanta,
                        murk_station at);

/* Continues the chain at another position, to which the photon was moved by a
 * periodic side. No plane counts as crossed in between. */
void murk_score_jump(murk_scorer *scorer, murk_station at);

/* Ends the photon and adds the sums to the tallies. takes_back: subtracts them
 * instead. */
void murk_score_end(murk_scorer *scorer, bool takes_back);

/* Adds the part of a segment that lies in a grid, for each cell
 * (transport/score_grid.c). */
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
    if (*sum == 0) { /* the sums of the cell will be needed at the end of the
                      * photon: load these sums in advance */
        __builtin_prefetch(&scorer->cell[cell], 1);
        scorer->touched[scorer->n_touched++] = cell;
    }
    *sum += value;
}

#endif
