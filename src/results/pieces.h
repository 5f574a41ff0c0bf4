/* Surfaces in pieces of about one size, for pictures of what arrives on them.
 *
 * A triangle is cut into k * k of its own shape, k so that no edge is longer
 * than asked; a sphere into eight octants, and each of these likewise, its
 * corners drawn out to the sphere. Pieces are numbered triangle by triangle,
 * then sphere by sphere. Source of a sphere's areas: Van Oosterom, Strackee,
 * IEEE Trans. Biomed. Eng. 30 (1983) 125, doi:10.1109/TBME.1983.325207. */
#ifndef MURK_RESULTS_PIECES_H
#define MURK_RESULTS_PIECES_H

#include "geometry/surfaces.h"

/* 40 bytes each in memory (results/lit_pieces.h), and more in the files. */
#define MURK_PIECES_MAX 10000000

typedef struct murk_pieces {
    const murk_surfaces *surfaces; /* borrowed */
    size_t triangles, spheres;
    size_t wholes;   /* triangles + 8 * spheres */
    double step_m;   /* from where a photon is looked for on its surface */
    uint32_t *cut;   /* [wholes] k */
    uint32_t *first; /* [wholes + 1] piece */
    size_t n;
} murk_pieces;

/* edge_m: the longest edge of a piece; 0: such that cutting makes `usual` more
 * of them than there are triangles, at most. Fails with
 * MURK_BAD_VALUE at `where` (more than MURK_PIECES_MAX pieces, and more than
 * there are triangles) or MURK_NO_MEMORY. Release *out in any case. */
murk_status murk_pieces_create(murk_pieces *out, const murk_surfaces *surfaces,
                               double edge_m, double usual, const char *where,
                               murk_error *err);
void murk_pieces_release(murk_pieces *pieces);

typedef struct murk_piece {
    murk_vec3 corner[3];
    murk_vec3 middle; /* on the surface */
    murk_vec3 normal; /* unit, by the winding; of spheres outward */
    double area_m2;   /* of the surface, on spheres the round one */
    uint8_t material;
} murk_piece;

murk_piece murk_piece_of(const murk_pieces *pieces, size_t i);

#define MURK_NO_PIECE UINT32_MAX

/* The piece that a stored photon lies on, whose normal faces where it came
 * from; MURK_NO_PIECE where no surface is that near. */
uint32_t murk_pieces_at(const murk_pieces *pieces, murk_vec3 place,
                        murk_vec3 normal);

#endif
