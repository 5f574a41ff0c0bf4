/* The members of murk_media. For use inside src/medium only. */
#ifndef MURK_MEDIUM_MEDIA_PARTS_H
#define MURK_MEDIUM_MEDIA_PARTS_H

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
    murk_region_boundary *boundaries; /* boundaries of the regions with an
                                         index, in the order of the scene */
    size_t n_boundaries;
    bool
        borrows_places; /* places and boundaries belong to another murk_media */
    bool is_even;       /* one homogeneous region that fills the domain */
    double near_m;      /* boundaries closer than this are one */
    bool in_band[MURK_BANDS_MAX]; /* false: in this band the extinction is 0 in
                                     all regions */
    double bound_factor; /* factor on the majorants of delta tracking; 0: no
                            majorants yet */
};

#endif
