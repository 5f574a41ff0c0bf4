/* The light that arrives on each piece of the surfaces, by the photon map, and
 * how well the sensors of a plan see the piece. */
#ifndef MURK_RESULTS_LIT_PIECES_H
#define MURK_RESULTS_LIT_PIECES_H

#include "lightmap/lightmap.h"
#include "results/pieces.h"
#include "sensing/sight.h"

/* The values of one piece. Without sensors, coverage, clarity and `sensors` are
 * 0. */
typedef struct murk_lit_piece {
    uint32_t photons; /* photons stored on the piece, on either side */
    float irradiance; /* W/m2, all bands, arriving on both sides together: the
                         sum of stored power / diffuse coefficient of the
                         material, divided by the area */
    float error;      /* standard error of irradiance, by emitted photon; 0
                         without photons */
    float coverage; /* 0..1: coverage of the photons or targets on the piece, by
                       weight; NaN: none with weight lies on the piece */
    float clarity;  /* 0..1: share that a plan would count of a photon stored at
                       the middle of the piece; maximum over sides and bands. 0
                       for a piece outside of the domain */
    uint16_t sensors; /* number of sensors that see the middle of the piece from
                         either side; maximum over the bands. 0 for a piece
                         outside of the domain */
} murk_lit_piece;

typedef struct murk_lit_pieces {
    const murk_pieces *pieces; /* borrowed */
    murk_lit_piece *piece;     /* [pieces->n] */
    bool is_seen;              /* there are sensors */
    uint64_t
        lost; /* stored photons for which no surface is found within rounding */
} murk_lit_pieces;

/* Computes the values of all pieces; those of the sensors sensor[n] unless
 * sight is NULL. Takes about 32 bytes a piece and 8 bytes a photon of the
 * surface map; with sensors, 60 bytes a piece, and up to 6 (k + 1) bytes more
 * for each record of the sight, k its redundancy. The result is the same for
 * any number of threads. Fails with MURK_NO_MEMORY or MURK_INTERRUPTED. Release
 * *out in any case. */
murk_status murk_lit_pieces_make(murk_lit_pieces *out,
                                 const murk_pieces *pieces,
                                 const murk_domain *domain,
                                 const murk_traced *traced, int bands,
                                 murk_sight *sight, const murk_pose *sensor,
                                 size_t n, unsigned threads, murk_error *err);
void murk_lit_pieces_release(murk_lit_pieces *lit);

/* True if the middle of the piece lies in the domain, or on its sides within
 * rounding. */
bool murk_piece_is_within(const murk_piece *piece, const murk_domain *domain);

#endif
