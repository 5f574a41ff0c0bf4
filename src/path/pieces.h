/* A long straight ray through a domain, piece by piece: each piece lies in the
 * domain, and if the domain repeats, the ray goes on at the opposite side.
 *
 * Where nothing depends on x and y, a piece may be a jump: however often the
 * ray would go through the sides there, the piece is the upright line to the
 * height at which the jump ends, and `stretch` tells how much longer the ray
 * is than that line. */
#ifndef MURK_PATH_PIECES_H
#define MURK_PATH_PIECES_H

#include "path/path.h"

/* What all rays through a domain share. */
typedef struct murk_path_tiling {
    murk_path_space space;
    bool repeats;          /* in x and y */
    double sideways_max_m; /* largest extent in x and in y of a piece that is no
                              jump; may be INFINITY */
    /* Nothing depends on x and y at heights up to free_below_m and from
     * free_above_m on, so rays may jump there; -INFINITY and INFINITY: no such
     * heights. */
    double free_below_m, free_above_m;
} murk_path_tiling;

typedef struct murk_path_piece {
    murk_vec3 from, to;
    double stretch; /* length of the ray over the length of the piece; 1 unless
                       the piece is a jump */
    bool leaves;    /* the piece ends at an open side of the domain */
} murk_path_piece;

typedef struct murk_path_pieces {
    const murk_path_tiling *tiling;
    murk_vec3 at, direction; /* where the next piece begins; unit vector */
    double left_m;           /* length of the ray from `at` to the end */
    murk_path_piece piece;   /* the present piece */
} murk_path_pieces;

/* The ray from a point in the domain; length_m may be INFINITY. */
murk_path_pieces murk_path_pieces_of(const murk_path_tiling *tiling,
                                     murk_vec3 from, murk_vec3 direction,
                                     double length_m);

/* Sets pieces->piece to the next piece. False, with pieces->piece unchanged, at
 * the end of the ray or if the present piece leaves the domain. */
bool murk_path_next_piece(murk_path_pieces *pieces);

/* The free part of a piece, before the first surface or change of index. */
typedef struct murk_path_stop {
    double length_m; /* of the free part */
    bool is_surface; /* the free part ends at a surface */
    bool is_bend;    /* the free part ends at a change of the index of
                      * refraction */
    murk_hit hit;    /* of a surface */
} murk_path_stop;

/* The free part of the present piece. Surfaces count up to margin_m beyond the
 * end of the piece; a jump meets no surface. */
murk_path_stop murk_path_piece_stop(const murk_path_pieces *pieces,
                                    double margin_m);

#endif
