/* Converts the media and regions of a scene file into the structs murk_medium
 * and murk_region of medium/media.h. */
#include "world/stage_build.h"

#include "medium/waves.h"

#include <stdlib.h>
#include <string.h>

static murk_region region_of(const murk_scene_region *r)
{
    return (murk_region){.medium = r->medium,
                         .shape = r->shape,
                         .box = r->solid.box,
                         .center = r->solid.center,
                         .radius_m = r->solid.radius_m,
                         .below_z_m = r->below_z_m,
                         .to_world = murk_scene_placed(&r->solid),
                         .replaces = r->replaces,
                         .ior = r->ior,
                         .mean_square_slope =
                             r->wind_m_per_s > 0
                                 ? murk_wind_mean_square_slope(r->wind_m_per_s)
                                 : 0,
                         .where = r->where};
}

static murk_medium medium_of(const murk_scene_desc *scene, size_t i,
                             const murk_fillings *fillings,
                             const murk_phases *phases)
{
    const murk_scene_medium *m = &scene->media[i];
    murk_medium medium = {
        .extinction_per_m = murk_scene_states_extinction(m)
                                ? murk_spectrum_flat(1, MURK_BANDS_MAX)
                                : m->extinction_per_m,
        .albedo = phases->source[i]->albedo,
        .interpolation = m->is_linear ? MURK_LINEAR : MURK_NEAREST,
        .where = m->where};
    murk_fillings_give(fillings, i, &medium);
    memcpy(medium.phase, phases->medium[i], sizeof medium.phase);
    return medium;
}

murk_status murk_stage_media(murk_media **out, const murk_stage *stage,
                             const murk_scene_desc *scene,
                             const murk_fillings *fillings,
                             const murk_phases *phases, murk_error *err)
{
    murk_medium *medium = calloc(scene->n_media + 1, sizeof *medium);
    murk_region *region = calloc(scene->n_regions + 1, sizeof *region);
    murk_status status = MURK_OK;
    if (!medium || !region) {
        status = murk_no_memory(err, scene->path, "for the media");
        goto done;
    }
    /* Convert the media. */
    for (size_t i = 0; i < scene->n_media; ++i) {
        medium[i] = medium_of(scene, i, fillings, phases);
    }
    /* Convert the regions. A region that is a mesh gets the bounding box of its
     * boundary mesh. */
    for (size_t i = 0; i < scene->n_regions; ++i) {
        region[i] = region_of(&scene->regions[i]);
        if (region[i].shape == MURK_REGION_MESH) {
            region[i].box =
                murk_boundary_meshes_describe(stage->boundary_meshes, (int)i)
                    .bounds_m;
        }
    }
    status = murk_media_create(out, medium, scene->n_media, region,
                               scene->n_regions, &stage->world.domain.box, err);
done:
    free(medium);
    free(region);
    return status;
}
