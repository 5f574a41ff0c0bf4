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

#endif
