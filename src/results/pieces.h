/* Surfaces in pieces of about one size, for pictures of what arrives on them.
 *
 * A triangle is cut into k * k triangles of its shape, with the least k for
 * which no edge is longer than asked for. A sphere is cut into eight octants,
 * and each of these in the same way, with corners moved outwards to the sphere;
 * of an octant k follows from an upper bound of the longest edge. Pieces are
 * numbered triangle by triangle, then sphere by sphere. Source of the areas on
 * a sphere: Van Oosterom, Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125,
 * doi:10.1109/TBME.1983.325207. */
#ifndef MURK_RESULTS_PIECES_H
#define MURK_RESULTS_PIECES_H

#include "geometry/surfaces.h"

/* Limit on the number of pieces: each takes up to 60 bytes of memory
 * (results/lit_pieces.h), and more in the files. */
#define MURK_PIECES_MAX 10000000

typedef struct murk_pieces {
    const murk_surfaces *surfaces; /* borrowed */
    size_t triangles, spheres;
    size_t wholes;   /* triangles + 8 * spheres */
    double step_m;   /* distance from the surface at which the search for the
                        piece of a photon begins */
    uint32_t *cut;   /* [wholes]; k of each triangle or octant */
    uint32_t *first; /* [wholes + 1]; number of the first piece of each triangle
                        or octant */
    size_t n;
} murk_pieces;

/* edge_m is the longest edge that a piece may have. 0: the pieces are about as
 * small as possible if there are at most `usual` more of them than triangles
 * and octants. Fails with MURK_BAD_VALUE at `where` if there would be more than
 * MURK_PIECES_MAX pieces (or than triangles and octants, if these are more), or
 * with MURK_NO_MEMORY. Release *out in any case. */
murk_status murk_pieces_create(murk_pieces *out, const murk_surfaces *surfaces,
                               double edge_m, double usual, const char *where,
                               murk_error *err);
void murk_pieces_release(murk_pieces *pieces);

typedef struct murk_piece {
    murk_vec3 corner[3];
    murk_vec3 middle; /* on the surface */
    murk_vec3 normal; /* unit; by the winding of a triangle, outward on a
                         sphere */
    double area_m2;   /* of the surface, on a sphere of the curved one */
    uint8_t material;
} murk_piece;

murk_piece murk_piece_of(const murk_pieces *pieces, size_t i);

#define MURK_NO_PIECE UINT32_MAX

/* The piece at the place of a stored photon. `normal` is the unit normal of the
 * surface on the side that the photon came from. MURK_NO_PIECE if no surface is
 * found within rounding. */
uint32_t murk_pieces_at(const murk_pieces *pieces, murk_vec3 place,
                        murk_vec3 normal);

#endif
