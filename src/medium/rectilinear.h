/* Fields on rectilinear grids: the edges of the cells lie anywhere along each
 * axis, so cells may be stretched. A field consists of one or more blocks, such
 * as the meshes of a simulation; each block fills the box of its own edges, and
 * blocks do not overlap. Values belong to cells (constant in each) or to nodes
 * (trilinear between the eight nodes of a cell). Between blocks the field is 0.
 *
 * A block contains its lower faces and not its upper faces, so a face shared by
 * two blocks belongs to one of them. Integrals along rays are exact: a ray is
 * followed from cell to cell, and the field is a cubic in each. Coordinates are
 * those of the field, in metres; the ray parameter t is the caller's.
 *
 * For use inside src/medium only.
 *
 * Source: Amanatides & Woo, "A fast voxel traversal algorithm", Eurographics
 * 1987. */
#ifndef MURK_MEDIUM_RECTILINEAR_H
#define MURK_MEDIUM_RECTILINEAR_H

#include "base/box_list.h"
#include "base/field_blocks.h"
#include "base/status.h"
#include "base/vector.h"
#include "medium/block_tree.h"
#include "medium/cubic.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Far more meshes than simulations have on one computer. */
#define MURK_RECTILINEAR_BLOCKS_MAX 4096

typedef struct murk_rectilinear_block {
    size_t cells[3];
    const double *edge[3]; /* [cells[axis] + 1], rising */
    const float *value;    /* [cells], or [cells + 1] along each axis if
                            * has_nodes; x fastest; finite, 0 or more */
    bool has_nodes;        /* values belong to nodes, otherwise to cells */
    murk_box box;
} murk_rectilinear_block;

typedef struct murk_rectilinear {
    size_t n; /* 1 or more */
    murk_rectilinear_block *block;
    murk_block_tree tree; /* over the blocks */
    murk_box box;         /* of all blocks */
    uint64_t n_values;    /* of all blocks */
    double smallest[3];   /* the smallest cell along each axis, of all blocks */
    double minimum, maximum, sum; /* of all values */
} murk_rectilinear;

/* Opens a packed field without the head (base/field_blocks.h). `bytes` is
 * borrowed, aligned to 8 bytes. Fails at `where` with MURK_BAD_FILE if the
 * bytes do not describe a field or blocks overlap, or with MURK_NO_MEMORY;
 * nothing is to be closed then. */
murk_status murk_rectilinear_open(murk_rectilinear *out,
                                  const unsigned char *bytes, size_t size,
                                  const char *where, murk_error *err);
void murk_rectilinear_close(murk_rectilinear *field);

/* True if p is in the box of the field; *density is then the value there. */
bool murk_rectilinear_density(const murk_rectilinear *field, murk_vec3 p,
                              double *density);

/* Adds boxes that contain all places at which the fields differ. All places
 * differ if the blocks have other edges. */
void murk_rectilinear_changes(murk_box_list *changed, const murk_rectilinear *a,
                              const murk_rectilinear *b);

typedef struct murk_rectilinear_walk {
    const murk_rectilinear *field;
    double origin[3], direction[3];
    double inverse[3]; /* of the direction; 0: parallel */
    double end;
    double from, to;                     /* the current segment */
    const murk_rectilinear_block *block; /* of the segment; NULL: between
                                          * blocks */
    size_t cell[3];
    int exit_axis; /* of the face at `to` by which the ray leaves the cell; -1
                    * if the segment ends elsewhere */
    /* Blocks are visited in the order of the ray parameter at which the ray
     * enters them, and of their number where that is the same. */
    size_t latest;  /* the block entered last; field->n before the first */
    double entered; /* its parameter */
    size_t next;    /* the block that begins at `to`, if block is NULL;
                     * field->n: none */
    double value;   /* the density at the collision of
                     * murk_rectilinear_integrate() */
} murk_rectilinear_walk;

/* Starts a walk from t0 to t1, which lie in the box of the field. */
void murk_rectilinear_begin(murk_rectilinear_walk *walk,
                            const murk_rectilinear *field, murk_vec3 origin,
                            murk_vec3 direction, double t0, double t1);

/* Advances to the next segment; false at the end. Segments join without gaps,
 * and some have length 0. */
bool murk_rectilinear_next(murk_rectilinear_walk *walk);

/* The field on the part [t0, t1] of the current segment. */
murk_cubic murk_rectilinear_cubic(const murk_rectilinear_walk *walk, double t0,
                                  double t1);

/* Integrates along the rest of the walk, as murk_layers_integrate() does. */
bool murk_rectilinear_integrate(murk_rectilinear_walk *walk, double scale,
                                double offset, double limit, double *sum);

#endif
