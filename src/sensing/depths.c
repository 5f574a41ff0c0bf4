/* Optical depths along the sightlines of a row, with the routines that the row
 * itself uses (sensing/passage.h, sensing/segment.h), without rounding. */
#include "sensing/depths.h"

#include "path/viewpoint.h"
#include "sensing/facing.h"
#include "sensing/sight_parts.h"

/* The point from which sightlines to a photon start: off the surface of a
 * surface photon. */
static murk_vec3 start_of(const murk_photon *photon,
                          const murk_surfaces *surfaces,
                          murk_side sides[MURK_SIDES])
{
    const murk_vec3 at = murk_photon_place(photon);
    return murk_photon_is_volume(photon)
               ? at
               : murk_add(at,
                          murk_side_recall(sides, surfaces,
                                           murk_photon_packed_normal(photon))
                              ->off);
}

void murk_sight_depths(double *depth, double *sheets, const murk_sight *sight,
                       const murk_pose *pose, const uint32_t *photon, size_t n,
                       const murk_media *const *media, size_t count)
{
    const murk_sight_desc *desc = &sight->desc;
    murk_side sides[MURK_SIDES] = {{0}};
    for (size_t i = 0; i < n; ++i) {
        /* The transmittance of the sheets on each sightline. */
        sheets[i] = 1;
        if (sight->has_sheets) {
            const murk_photon *p = murk_sight_photon(sight, photon[i]);
            const murk_vec3 from = start_of(p, desc->surfaces, sides);
            const murk_vec3 to =
                murk_path_nearest_image(&desc->domain, pose->position, from);
            sheets[i] = murk_path_sheets(desc->surfaces, &desc->domain, from,
                                         to, murk_photon_band(p));
        }
    }
    /* The optical depth in each of the media. */
    for (size_t m = 0; m < count; ++m) {
        const murk_path_space space = murk_path_space_of(
            desc->surfaces, media[m], desc->boundary_meshes, &desc->domain);
        const murk_path_viewpoint viewpoint =
            murk_path_viewpoint_at(&space, pose->position);
        for (size_t i = 0; i < n; ++i) {
            const murk_photon *p = murk_sight_photon(sight, photon[i]);
            depth[i * count + m] =
                murk_path_depth_to(&viewpoint, murk_photon_band(p),
                                   start_of(p, desc->surfaces, sides));
        }
    }
}
