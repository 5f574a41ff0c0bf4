/* What is known of each piece of the surfaces: what arrives there by the
 * photon map, and how well a plan's sensors see it. */
#ifndef MURK_RESULTS_LIT_PIECES_H
#define MURK_RESULTS_LIT_PIECES_H

#include "lightmap/lightmap.h"
#include "results/pieces.h"
#include "sensing/sight.h"

/* The values of one piece; without sensors the last three are 0. */
typedef struct murk_lit_piece {
    uint32_t photons; /* stored on it, on either side */
    float irradiance; /* W/m2, all bands, what arrives on both sides together:
                         sum of power / diffuse, over the area */
    float error;      /* its standard error, by emitted photon; 0 without
                         photons */
    float coverage; /* 0..1: coverage of the photons or targets on the piece, by
                       weight; NaN: none lies on the piece */
    float clarity;  /* 0..1: share that a plan would count of a photon stored at
                       the middle of the piece; maximum over sides and bands */
    uint16_t sensors; /* number of sensors that see the middle of the piece from
                         either side; maximum over the bands */
} murk_lit_piece;

typedef struct murk_lit_pieces {
    const murk_pieces *pieces; /* borrowed */
    murk_lit_piece *piece;     /* [pieces->n] */
    bool is_seen;              /* there are sensors */
    uint64_t lost; /* stored photons that lie on no surface, by rounding */
} murk_lit_pieces;

/* sight NULL: no sensors. Takes 40 bytes a piece, and 8 bytes a photon of the
 * surface map and 12 more, with redundancy k 6 (k + 1), with sensors. The same
 * for any number of threads. Fails with MURK_NO_MEMORY or MURK_INTERRUPTED.
 * Release *out in any case. */
murk_status murk_lit_pieces_make(murk_lit_pieces *out,
                                 const murk_pieces *pieces,
                                 const murk_domain *domain,
                                 const murk_traced *traced, int bands,
                                 murk_sight *sight, const murk_pose *sensor,
                                 size_t n, unsigned threads, murk_error *err);
void murk_lit_pieces_release(murk_lit_pieces *lit);

/* Whether a piece is in the domain: its middle is, or lies in its sides. */
bool murk_piece_is_within(const murk_piece *piece, const murk_domain *domain);

#endif
