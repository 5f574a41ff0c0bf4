/* Topology of triangle meshes: which parts are closed, and which triangles are
 * wound towards the same side. */
#ifndef MURK_GEOMETRY_CLOSED_H
#define MURK_GEOMETRY_CLOSED_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Sets is_closed[i] for each of n triangles: true if the connected part that
 * contains the triangle is closed, that is, if every edge of the part belongs
 * to an even number of triangles. Vertices of equal coordinates are one vertex.
 * The winding is ignored. Triangles listed twice count once. Fails with
 * MURK_NO_MEMORY. Parts are connected by edges: two closed boxes that touch at
 * a corner are two parts. vertex[3 * vertices], corner[3 * n]. */
murk_status murk_closed_parts(const float *vertex, size_t vertices,
                              const uint32_t *corner, size_t n, bool *is_closed,
                              murk_error *err);

/* Connectivity of a mesh. A patch is a maximal set of triangles that are
 * connected by edges which belong to exactly two triangles, copies not counted;
 * a copy belongs to the patch of the triangle that it repeats. In an orientable
 * patch all normals can be oriented to the same side. */
typedef struct murk_patches {
    size_t open_edges; /* edges that belong to an odd number of triangles */
    size_t patches;
    bool are_orientable; /* false: some patch is one-sided (like a Moebius
                            strip) */
    uint32_t *patch;     /* [n] 0..patches - 1 */
    bool *is_turned;     /* [n] the winding's normal is opposite to the patch's
                            orientation */
    bool *is_copy;       /* [n] the triangle repeats an earlier one */
    uint32_t *same; /* [vertices] index of the representative vertex at the same
                       place */
} murk_patches;

/* Finds the patches; the input is that of murk_closed_parts(). The caller calls
 * murk_patches_release() afterwards, also after a failure. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_patches_find(murk_patches *out, const float *vertex,
                              size_t vertices, const uint32_t *corner, size_t n,
                              murk_error *err);
void murk_patches_release(murk_patches *patches);

#endif
