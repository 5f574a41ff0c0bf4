/* The members of murk_media. For use inside src/medium only. */
#ifndef MURK_MEDIUM_MEDIA_PARTS_H
#define MURK_MEDIUM_MEDIA_PARTS_H

#include "medium/media.h"
#include "medium/place.h"
#include "medium/region_boundary.h"

#include <stdbool.h>
#include <stddef.h>

/* The tables for walks through the grid of a medium, by the interpolation. The
 * first region of the medium makes them. */
typedef struct murk_grid_tables {
    bool are_made;
    murk_leaf_table leaves;    /* nearest neighbour; may be empty */
    murk_linear_blocks blocks; /* linear */
} murk_grid_tables;

struct murk_media {
    murk_medium *media;
    size_t n_media;
    murk_grid_tables *tables; /* [n_media] */
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
