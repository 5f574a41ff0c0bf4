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

/* The lower or the upper halves of the integer sums of a cell and channel. */
typedef struct murk_tally_bin {
    murk_wide_half sum, squares;
} murk_tally_bin;

/* Contributions that a photon may list before the list is emptied into the sums
 * of the photon: a few cells for each of a thousand collisions. A photon whose
 * list is full is followed alone, which few photons should be. The lists of a
 * thread take 2.2 MB, of which most is never written. Lists lie 16 entries
 * further apart than their length, because lists at distances of a power of 2
 * would share few sets of the cache. */
#define MURK_SCORE_ENTRIES 4096
#define MURK_SCORE_STRIDE  (MURK_SCORE_ENTRIES + 16)

/* Photons of one thread that are under way at the same time, at most. */
#define MURK_SCORE_PATHS 32

/* The slots of the hash table in which the cells of a list are looked up: a
 * power of 2, more than the entries of a list. */
#define MURK_SCORE_SLOTS 8192

/* Entries of all lists of a thread, of which there is one more than photons:
 * the spare one is overwritten in lanes without a segment
 * (transport/score_lanes.h). */
#define MURK_SCORE_LISTS ((size_t)(MURK_SCORE_PATHS + 1) * MURK_SCORE_STRIDE)

/* No cell: the cell of entry 0 of each list, whose value is 0. So every list
 * has a last entry. */
#define MURK_SCORE_NO_CELL UINT32_MAX

/* An entry of a list: a contribution [quanta] and its cell, as long as the
 * value, so that a vector register holds a whole entry. At the end of the
 * photon, when each cell has a single entry, the offset of the bin of the cell
 * in bytes takes the place of the cell. */
typedef struct murk_score_entry {
    double value;
    uint64_t cell;
} murk_score_entry;

/* Adds whole numbers, the values of n entries and their squares, to the sums of
 * which `low` and `high` are the halves. Each entry has another cell; no other
 * thread adds to the sums. */
typedef void murk_score_adder(murk_tally_bin *low, murk_tally_bin *high,
                              const murk_score_entry *entry, size_t n);

typedef struct murk_scorer murk_scorer;

/* A photon under way. */
typedef struct murk_score_path {
    murk_scorer *scorer;
    murk_tally_bin *low, *high; /* [cells]: halves of the sums of the channel of
                                 * the photon */
    murk_station at;
    double *side; /* [planes]: signed distance of `at` beyond each plane */
    /* The list: contributions in the order of the path, entries 1 to `last`. */
    murk_score_entry *list; /* [MURK_SCORE_ENTRIES] */
    size_t last;
    bool has_sums; /* the list has been emptied: the sums of the scorer belong
                    * to this photon, and no other photon of the thread may end
                    * before */
} murk_score_path;

/* The state of one thread. */
struct murk_scorer {
    const murk_tallies *tallies;
    /* The sums of a photon whose list is its whole path: the list itself, with
     * one entry for each cell. The slot of a cell gives the entry; 0 if there
     * is none, and between photons. */
    uint16_t slot[MURK_SCORE_SLOTS];
    /* The sums of a photon whose list has been full. */
    double *sum;       /* [cells]; 0 between photons */
    uint32_t *touched; /* [cells + 1]: numbers of the cells that are not 0, or
                        * the slots in use, and one that is overwritten */
    size_t n_touched;
    murk_tally_bin *low, *high; /* [channels][cells]: halves of the sums */
    murk_score_adder *add;      /* murk_score_add_entries(), or side by side */
    bool is_alone;              /* no other scorer adds to this copy */
    double *sides;              /* [MURK_SCORE_PATHS][planes] */
    murk_score_entry *lists;    /* [MURK_SCORE_LISTS] */
    murk_score_entry *spare;    /* the last of the lists */
    murk_score_path path[MURK_SCORE_PATHS];
};

struct murk_tallies {
    size_t n;
    murk_tally_desc desc[MURK_TALLIES_MAX];
    uint32_t first[MURK_TALLIES_MAX];
    murk_tally_plane plane[MURK_TALLIES_MAX];
    murk_probe probe[MURK_TALLIES_MAX];
    murk_lattice lattice[MURK_TALLIES_MAX];
    size_t planes, probes, lattices;
    size_t entries_max; /* that a segment may list */
    size_t cells, channels;
    int bands;
    size_t scorers, copies;
    murk_scorer **scorer;       /* [scorers] */
    murk_tally_bin *low, *high; /* [copies][channels][cells]: halves of the sums
                                 */
    void *memory;               /* of low and high */
};

/* The scorer of a worker of the thread pool. */
murk_scorer *murk_tallies_scorer(murk_tallies *tallies, unsigned worker);

/* Begins a photon of a channel. */
void murk_score_start(murk_score_path *path, size_t channel, murk_station at);

/* Adds a straight segment along a unit direction with a number of quanta.
 * Lengths are taken from `from`, direction and length_m. The chain continues
 * from its last position to `at`. */
void murk_score_segment(murk_score_path *path, murk_vec3 from,
                        murk_vec3 direction, double length_m, double quanta,
                        murk_station at);

/* The part of murk_score_segment() for planes and spheres. */
void murk_score_crossings(murk_score_path *path, murk_vec3 from,
                          murk_vec3 direction, double length_m, double quanta,
                          murk_station at);

/* Continues the chain at another position, to which the photon was moved by a
 * periodic side: no crossing is scored between the two positions. */
void murk_score_jump(murk_score_path *path, murk_station at);

/* Adds what a photon has contributed to a cell to the halves of the sums of
 * that cell, rounded to a whole number, as murk_score_adder does. */
static inline void murk_score_add_alone(murk_tally_bin *low,
                                        murk_tally_bin *high, double value)
{
    /* Below 2^48: MURK_TALLY_SEGMENTS_MAX segments of a packet. */
    const uint64_t whole = (uint64_t)(int64_t)(value + 0.5);
    murk_wide_add_alone(&low->sum, &high->sum, whole);
    murk_wide_add_alone(&low->squares, &high->squares,
                        (murk_wide)whole * whole);
}

/* A murk_score_adder that adds entries one by one. */
murk_score_adder murk_score_add_entries;

/* Ends the photon: rounds the sum of each cell, and adds it to the tallies or,
 * with takes_back, subtracts it instead. */
void murk_score_end(murk_score_path *path, bool takes_back);

/* Adds the part of a segment that lies in a grid, for each cell
 * (transport/score_grid.c). */
void murk_score_lattice(murk_score_path *path, const murk_lattice *lattice,
                        murk_vec3 from, murk_vec3 direction, double length_m,
                        double quanta);

/* Empties the list of a photon into the sums of the scorer. */
void murk_score_spill(murk_score_path *path);

/* Adds a contribution, which may be 0. */
static inline void murk_score_list(murk_score_path *path, uint32_t cell,
                                   double value)
{
    /* In dense media many segments in a row lie in the same cell. */
    if (path->list[path->last].cell == cell) {
        path->list[path->last].value += value;
        return;
    }
    if (path->last == MURK_SCORE_ENTRIES - 1) {
        murk_score_spill(path);
    }
    ++path->last;
    path->list[path->last] = (murk_score_entry){value, cell};
}

/* Adds a contribution, if there is one. */
static inline void murk_score_add(murk_score_path *path, uint32_t cell,
                                  double value)
{
    if (value > 0) {
        murk_score_list(path, cell, value);
    }
}

#endif
