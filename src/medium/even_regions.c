/* Describes the regions of a scene in which each region has one density
 * (medium/even_regions.h). */
#include "medium/even_regions.h"

#include "medium/media_parts.h"

/* The shape of a place that has one density; false if it is none of the shapes
 * that several rays are clipped to at once. */
static bool shape_of(const murk_place *place, murk_even_shape *shape)
{
    switch (place->shape) {
    case MURK_REGION_EVERYWHERE:
        *shape = MURK_EVEN_EVERYWHERE;
        return true;
    case MURK_REGION_BELOW:
        *shape = MURK_EVEN_BELOW;
        return true;
    case MURK_REGION_BOX:
        *shape = place->is_around ? MURK_EVEN_EVERYWHERE : MURK_EVEN_BOX;
        return !place->is_moved;
    case MURK_REGION_SPHERE:
        *shape = MURK_EVEN_SPHERE;
        return !place->is_moved;
    case MURK_REGION_GRID:
    case MURK_REGION_MESH:
        break;
    }
    return false;
}

size_t murk_media_even_regions(const murk_media *media,
                               murk_even_region region[MURK_EVEN_REGIONS_MAX])
{
    for (size_t i = 0; i < media->n_places; ++i) {
        const murk_place *place = &media->places[i];
        murk_even_shape shape;
        if (i == MURK_EVEN_REGIONS_MAX ||
            place->filling != MURK_FILLED_EVENLY ||
            media->media[place->medium].albedo_grid ||
            !shape_of(place, &shape)) {
            return 0;
        }
        region[i] = (murk_even_region){.shape = shape,
                                       .box = place->box,
                                       .center = place->center,
                                       .radius_m = place->radius,
                                       .level_m = place->level,
                                       .replaces = place->replaces,
                                       .medium = place->medium};
    }
    return media->n_places;
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
