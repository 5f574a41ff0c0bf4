/* Describes the regions of a scene for rays that are followed at once
 * (medium/lane_regions.h). */
#include "medium/lane_regions.h"

#include "medium/media_parts.h"

/* The shape of a place; false if it is none of the shapes that several rays are
 * clipped to at once. */
static bool shape_of(const murk_place *place, murk_lane_shape *shape)
{
    switch (place->shape) {
    case MURK_REGION_EVERYWHERE:
    case MURK_REGION_GRID:
        *shape = MURK_LANE_EVERYWHERE;
        return true;
    case MURK_REGION_BELOW:
        *shape = MURK_LANE_BELOW;
        return true;
    case MURK_REGION_BOX:
        *shape = place->is_around ? MURK_LANE_EVERYWHERE : MURK_LANE_BOX;
        return !place->is_moved;
    case MURK_REGION_SPHERE:
        *shape = MURK_LANE_SPHERE;
        return !place->is_moved;
    case MURK_REGION_MESH:
        break;
    }
    return false;
}

/* Adds the filling of a place; false if several rays cannot be followed through
 * it at once. */
static bool add_filling(const murk_place *place, murk_lane_regions *regions,
                        murk_lane_region *region)
{
    if (place->filling == MURK_FILLED_EVENLY) {
        return true;
    }
    /* A region that replaces others and is filled only in part has two
     * segments (free_flight.c). */
    const bool is_filled = !place->replaces || place->shape == MURK_REGION_GRID;
    if (place->filling != MURK_FILLED_BY_NEAREST || regions->has_grid ||
        !is_filled || !place->leaves->leaf) {
        return false;
    }
    region->is_grid = true;
    regions->has_grid = true;
    regions->grid =
        (murk_lane_grid){place->tree, place->leaves, place->to_index};
    return true;
}

/* Adds a place as a further region; false if several rays cannot be followed
 * through it at once. */
static bool add_region(const murk_media *media, const murk_place *place,
                       murk_lane_regions *regions)
{
    if (regions->n == MURK_LANE_REGIONS_MAX) {
        return false;
    }
    const murk_medium *medium = &media->media[place->medium];
    murk_lane_region *region = &regions->region[regions->n++];
    *region = (murk_lane_region){.box = place->box,
                                 .center = place->center,
                                 .radius_m = place->radius,
                                 .level_m = place->level,
                                 .replaces = place->replaces,
                                 .medium = place->medium};
    return !medium->albedo_grid && shape_of(place, &region->shape) &&
           add_filling(place, regions, region);
}

bool murk_media_lane_regions(const murk_media *media,
                             murk_lane_regions *regions)
{
    *regions = (murk_lane_regions){.n = 0};
    for (size_t i = 0; i < media->n_places; ++i) {
        if (!add_region(media, &media->places[i], regions)) {
            *regions = (murk_lane_regions){.n = 0};
            return false;
        }
    }
    return regions->n > 0;
}

murk_collision murk_media_even_collision(const murk_media *media, size_t medium,
                                         int band, double *extinction_per_m)
{
    const murk_medium *m = &media->media[medium];
    const double extinction = m->extinction_per_m.band[band];
    const double albedo = m->albedo.band[band];
    *extinction_per_m = extinction;
    return (murk_collision){.medium = medium,
                            .albedo = albedo,
                            .phase = &m->phase[band],
                            .scattering_per_m = extinction * albedo};
}
