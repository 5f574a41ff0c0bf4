/* Triangles for a view: few enough for a page, with places as whole numbers.
 * Corners in the same cell of a lattice become one vertex, at the mean of their
 * places; triangles that lose their area or occur twice by that are left out
 * (vertex clustering: Rossignac & Borrel, in Modeling in Computer Graphics
 * (1993) 455, doi:10.1007/978-3-642-78114-8_29). The lattice becomes coarser
 * until there are few enough triangles. */
#ifndef MURK_REPORT_VIEW_MESH_H
#define MURK_REPORT_VIEW_MESH_H

#include "geometry/surfaces.h"

/* Steps of places along a side of the box: the largest number of two bytes. */
#define MURK_VIEW_STEPS 65535

typedef struct murk_view_mesh {
    murk_box box;   /* of all triangles */
    size_t asked;   /* number of triangles of the surfaces */
    bool is_coarse; /* corners were joined to have fewer triangles */
    size_t vertices, triangles;
    uint16_t *place;  /* [3 * vertices]; 0..MURK_VIEW_STEPS along each side */
    uint32_t *corner; /* [3 * triangles]; numbers of vertices */
} murk_view_mesh;

/* Makes a mesh of at most `max` triangles; max >= 56, which the coarsest
 * lattice may have. Spheres are left out. Fails with MURK_NO_MEMORY. Release
 * *out in any case. */
murk_status murk_view_mesh_make(murk_view_mesh *out,
                                const murk_surfaces *surfaces, size_t max,
                                murk_error *err);
void murk_view_mesh_release(murk_view_mesh *mesh);

#endif
