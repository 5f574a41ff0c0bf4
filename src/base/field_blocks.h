/* Fields on rectilinear grids as readers of files hand them over: one or more
 * blocks, each with its grid lines and values. murk_field_send() packs them in
 * a subprocess (base/subprocess.h), and medium/rectilinear.h opens the packed
 * form. */
#ifndef MURK_BASE_FIELD_BLOCKS_H
#define MURK_BASE_FIELD_BLOCKS_H

#include "base/status.h"
#include "base/subprocess.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Limits of a field: cells along an axis, and values. A choice, which keeps all
 * products of sizes in range; 2^31 values take 8 GB. */
#define MURK_FIELD_CELLS_MAX  ((1 << 20) - 1)
#define MURK_FIELD_VALUES_MAX ((uint64_t)1 << 31)

typedef struct murk_field_block {
    size_t cells[3];
    double *edge[3]; /* [cells + 1] along each axis, rising */
    float *value;    /* of nodes ([cells + 1] along each axis) or cells, x
                      * fastest */
    bool has_nodes;
} murk_field_block;

/* The first part of the packed form: texts for users, and facts. */
typedef struct murk_field_head {
    char name[128];    /* what the values are */
    char note[256];    /* how they were obtained */
    char warning[256]; /* of values that are limits or missing; empty: none */
    double effective_radius_um; /* of droplets, the mean by extinction; 0: no
                                 * droplets */
} murk_field_head;

/* The size of a block as it is packed. */
typedef struct murk_field_size {
    uint64_t cells[3];
    uint64_t has_nodes; /* 0 or 1 */
} murk_field_size;

/* The number of values of a block. */
uint64_t murk_field_values(const murk_field_size *size);

/* Sends the head, the number n of blocks as a uint64_t, the sizes of all
 * blocks, their edges (x, y, z of each block), and their values. Fails as
 * murk_subprocess_send(). */
murk_status murk_field_send(murk_subprocess *to, const murk_field_head *head,
                            const murk_field_block *block, size_t n);

/* True if the ranges of two rising lists of edges, of a cells and of b cells,
 * have more in common than rounding of edges in files explains. */
bool murk_field_overlap(const double *a, size_t a_cells, const double *b,
                        size_t b_cells);

/* Frees the arrays of n blocks and the blocks; NULL is fine. */
void murk_field_blocks_destroy(murk_field_block *block, size_t n);

#endif
