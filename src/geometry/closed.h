/* Which parts of a triangle mesh enclose something. */
#ifndef MURK_GEOMETRY_CLOSED_H
#define MURK_GEOMETRY_CLOSED_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* is_closed[i] for each of n triangles: whether the connected part that it
 * belongs to is closed, that is, each edge of it joins exactly two triangles.
 * Vertices of equal coordinates are one; winding means nothing; triangles
 * listed twice count once. Parts are connected by edges: two closed boxes that
 * touch at a corner stay two. vertex[3 * vertices], corner[3 * n]. */
murk_status murk_closed_parts(const float *vertex, size_t vertices,
                              const uint32_t *corner, size_t n, bool *is_closed,
                              murk_error *err);

/* How the triangles of a mesh hang together. A patch is what edges of exactly
 * two triangles join; within one, all normals can be turned to one side. */
typedef struct murk_patches {
    size_t open_edges; /* with an odd number of triangles around */
    size_t patches;
    bool are_orientable; /* false: some patch has no two sides */
    uint32_t *patch;     /* [n] 0..patches - 1 */
    bool *is_turned;     /* [n] normal by winding against the patch's own */
    bool *is_copy;       /* [n] of a triangle listed before it */
    uint32_t *same;      /* [vertices] one number for vertices of one place */
} murk_patches;

/* Same input and meanings as above. murk_patches_release() afterwards, also
 * when it fails. */
murk_status murk_patches_find(murk_patches *out, const float *vertex,
                              size_t vertices, const uint32_t *corner, size_t n,
                              murk_error *err);
void murk_patches_release(murk_patches *patches);

#endif
