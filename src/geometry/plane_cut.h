/* The intersection of all surfaces with a plane: a segment for each triangle
 * and a circle for each sphere, for drawings.
 *
 * A vertex that lies in the plane counts as lying on the side of the normal, so
 * that each triangle is either cut in one segment or not at all. A closed mesh
 * therefore gives closed outlines, also if the plane passes through vertices,
 * edges or faces: a face in the plane is outlined if the body is on the side
 * away from the normal, and gives nothing if the body is on the side of the
 * normal. Two triangles with a common edge give the same end on the edge to the
 * last bit. */
#ifndef MURK_GEOMETRY_PLANE_CUT_H
#define MURK_GEOMETRY_PLANE_CUT_H

#include "geometry/surfaces.h"

typedef struct murk_cut_plane {
    murk_vec3 point;
    murk_vec3 normal; /* unit */
} murk_cut_plane;

typedef struct murk_cut_segment {
    murk_vec3 from, to;
    uint32_t triangle; /* number as in murk_hit */
} murk_cut_segment;

typedef struct murk_cut_circle { /* about the normal of the plane */
    murk_vec3 center;
    double radius_m;
    uint32_t sphere; /* number as in murk_hit */
} murk_cut_circle;

typedef struct murk_plane_cut {
    murk_cut_segment *segment; /* [segments] in the order of the triangles */
    murk_cut_circle *circle;   /* [circles] */
    size_t segments, circles;
} murk_plane_cut;

/* Cuts one triangle. Returns false if the triangle is not cut, or touched in
 * one point only. */
bool murk_plane_cut_triangle(const murk_cut_plane *plane,
                             const murk_vec3 corner[3], murk_vec3 end[2]);

/* Cuts all surfaces. Fails with MURK_NO_MEMORY. Release *out in any case. */
murk_status murk_plane_cut_surfaces(murk_plane_cut *out,
                                    const murk_surfaces *surfaces,
                                    const murk_cut_plane *plane,
                                    murk_error *err);
void murk_plane_cut_release(murk_plane_cut *cut);

#endif
