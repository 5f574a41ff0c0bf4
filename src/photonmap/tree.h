/* What a photon map is made of.
 *
 * Leaves of 32 photons in an implicit kd-tree (order.h); over them, boxes by
 * sixteen: level 0 has a box a leaf, level k a box for 16 boxes of level k - 1.
 * Sixteen boxes are tested at once (scan.h), and since a group of sixteen is
 * four levels of the binary tree, that costs less than one a step. A box costs
 * 24 bytes: 0.8 bytes a photon in all. */
#ifndef MURK_PHOTONMAP_TREE_H
#define MURK_PHOTONMAP_TREE_H

#include "photonmap/map.h"
#include "photonmap/scan.h"

/* 32 * 16^7 = 2^33 photons. */
#define MURK_KDTREE_LEVELS 7

struct murk_photon_map {
    murk_photon *photons;
    size_t n;
    const murk_scan *scan;
    unsigned levels; /* 0 when empty; the last level is one group */
    murk_boxes *boxes[MURK_KDTREE_LEVELS]; /* into memory, by level */
    size_t n_boxes[MURK_KDTREE_LEVELS];    /* boxes in use, not groups */
    murk_boxes *memory;
};

static inline size_t murk_groups_of(size_t boxes)
{
    return (boxes + MURK_WIDE - 1) / MURK_WIDE;
}

/* The first record of a box of that level, or n. */
static inline size_t murk_first_of(const murk_photon_map *map, unsigned level,
                                   size_t box)
{
    const uint64_t first = (uint64_t)box * MURK_LEAF << 4 * level;
    return first < map->n ? (size_t)first : map->n;
}

#endif
