/* What murk_media is made of; inside this room only. */
#ifndef MURK_MEDIUM_PARTS_H
#define MURK_MEDIUM_PARTS_H

#include "medium/media.h"
#include "medium/place.h"
#include "medium/region_boundary.h"

#include <stdbool.h>
#include <stddef.h>

struct murk_media {
    murk_medium *media;
    size_t n_media;
    murk_place *places;
    size_t n_places;
    murk_region_boundary
        *boundaries; /* of the regions with an index, as listed */
    size_t n_boundaries;
    bool borrows_places;          /* places and shells are another's */
    bool is_even;                 /* one region, everywhere, filled evenly */
    double near_m;                /* boundaries nearer than this are one */
    bool in_band[MURK_BANDS_MAX]; /* something extinguishes there */
    double bound_factor; /* on what delta tracking flies by; 0: not prepared */
};

/* A copy whose list of media may be changed; places and shells are borrowed
 * from `media`. NULL when out of memory. The caller's: murk_media_destroy(). */
murk_media *murk_media_borrowing(const murk_media *media);

#endif
