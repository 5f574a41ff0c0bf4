/* Triangles for a view: few enough to be sent along, places as whole numbers.
 *
 * Corners in one cell of a lattice become one, in their middle; triangles that
 * lose their area by that or are there twice are left out (vertex clustering:
 * Rossignac & Borrel, in Modeling in Computer Graphics (1993) 455,
 * doi:10.1007/978-3-642-78114-8_29). The lattice is as fine as the number of
 * triangles allows. */
#ifndef MURK_REPORT_VIEW_MESH_H
#define MURK_REPORT_VIEW_MESH_H

#include "geometry/surfaces.h"

/* Whole steps along a side: the largest number of two bytes. */
#define MURK_VIEW_STEPS 65535

typedef struct murk_view_mesh {
    murk_box box;   /* of all triangles */
    size_t asked;   /* triangles that there were */
    bool is_coarse; /* corners were joined to have fewer */
    size_t vertices, triangles;
    uint16_t *place;  /* [3 * vertices] 0..MURK_VIEW_STEPS along each side */
    uint32_t *corner; /* [3 * triangles] */
} murk_view_mesh;

/* At most `most` triangles, most >= 56 (what the coarsest lattice has). Fails
 * with MURK_NO_MEMORY. Release *out in any case. */
murk_status murk_view_mesh_make(murk_view_mesh *out,
                                const murk_surfaces *surfaces, size_t max,
                                murk_error *err);
void murk_view_mesh_release(murk_view_mesh *mesh);

#endif
