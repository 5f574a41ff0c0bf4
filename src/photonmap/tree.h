/* The structure of a photon map.
 *
 * Leaves of 32 photons form an implicit kd-tree (order.h). Above them are
 * levels of bounding boxes: level 0 has a box for each leaf, level k a box for
 * 16 boxes of level k - 1. Sixteen boxes are tested at once (range_test.h). A
 * group of sixteen replaces four levels of the binary tree, at less cost than
 * one box at each step. A box takes 24 bytes: 0.8 bytes for each photon in
 * all. */
#ifndef MURK_PHOTONMAP_TREE_H
#define MURK_PHOTONMAP_TREE_H

#include "base/block.h"
#include "photonmap/range_test.h"

/* The largest number of levels: 32 * 16^7 = 2^33 photons. */
#define MURK_KDTREE_LEVELS 7

struct murk_photon_map {
    murk_block block, bounds_memory; /* of the records, and of the boxes */
    murk_photon *photons;
    size_t n;
    const murk_range_test *test;
    unsigned levels; /* 0 if the map is empty; the last level is one group */
    murk_bounds *bounds[MURK_KDTREE_LEVELS]; /* in bounds_memory, by
                                              * level */
    size_t n_bounds[MURK_KDTREE_LEVELS];     /* number of boxes in use, not of
                                              * groups */
};

static inline size_t murk_groups_of(size_t bounds)
{
    return (bounds + MURK_WIDE - 1) / MURK_WIDE;
}

/* The index of the first record of a box of a level; n if the box begins behind
 * the last record. */
static inline size_t murk_first_of(const struct murk_photon_map *map,
                                   unsigned level, size_t box)
{
    const uint64_t first = (uint64_t)box * MURK_LEAF << 4 * level;
    return first < map->n ? (size_t)first : map->n;
}

#endif
