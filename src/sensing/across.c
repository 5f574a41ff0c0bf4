/* Sightlines across one interface: takes the refracted paths
 * (sensing/refract.h), tests range, field of view, normal, direction of travel
 * and surfaces for each, and multiplies the transmittances of boundary, sheets
 * and media. A photon without a refracted path is counted, as totally reflected
 * or as blocked by interfaces, if range, field of view and normal admit the
 * straight line to the photon. */
#include "sensing/across.h"

/* Counts a photon that no refracted path reaches, if range, field of view and
 * normal admit the straight line. Surfaces are not tested. */
static void count_lost(const murk_across *a, const murk_side *facing,
                       murk_vec3 from, bool is_reflected)
{
    const murk_path_viewpoint *p = a->sensor;
    const murk_vec3 image =
        murk_path_nearest_image(p->space->domain, from, p->position);
    const murk_vec3 offset = murk_sub(image, p->position);
    if (murk_dot(offset, offset) <= a->range_m * a->range_m &&
        murk_field_contains(a->field, offset) &&
        (!facing || murk_side_faces(facing, image, p->position,
                                    a->sight->position_error_m))) {
        ++*(is_reflected ? &a->counts->reflected : &a->counts->bent);
    }
}

/* True if range, field of view, normal and direction of travel admit a
 * refracted path, and no surface blocks the path (with through_sheets, thin
 * sheets do not block). */
static bool is_open(const murk_across *a, const murk_photon *photon,
                    const murk_side *facing, const murk_refracted_path *path,
                    murk_vec3 apparent)
{
    const murk_snell *s = &path->snell;
    if (!(s->apparent_m <= a->range_m) ||
        !murk_field_contains(a->field, apparent) ||
        (facing && !murk_side_faces(facing, path->photon, s->crossing,
                                    a->sight->position_error_m))) {
        return false;
    }
    if (a->field->toward &&
        !murk_field_takes(a->field, murk_sub(path->photon, s->crossing),
                          murk_photon_direction(photon))) {
        return false;
    }
    ++a->counts->tested;
    return !murk_refracted_path_blocked(path, a->sensor,
                                        a->sight->desc.surfaces,
                                        a->sight->desc.through_sheets);
}

size_t murk_across_sightlines(const murk_across *a, const murk_photon *photon,
                              const murk_side *facing, murk_vec3 from,
                              double index,
                              murk_sightline line[MURK_REFRACTED_PATHS_MAX])
{
    const murk_path_viewpoint *p = a->sensor;
    murk_refracted_path path[MURK_REFRACTED_PATHS_MAX];
    bool is_reflected;
    const size_t paths = murk_refracted_paths_find(
        a->sight->interfaces, p, from, index, path, &is_reflected);
    /* Without a path the photon is lost. */
    if (paths == 0) {
        count_lost(a, facing, from, is_reflected);
    }
    /* Each open path makes a sightline. */
    size_t lines = 0;
    for (size_t i = 0; i < paths; ++i) {
        const murk_snell *s = &path[i].snell;
        const murk_vec3 to = murk_sub(s->crossing, p->position);
        const murk_vec3 apparent =
            murk_scale(s->apparent_m / murk_length(to), to);
        if (!is_open(a, photon, facing, &path[i], apparent)) {
            continue;
        }
        const double ratio = p->index / index;
        line[lines++] = (murk_sightline){
            .transmittance =
                s->transmittance *
                murk_refracted_path_sheets(&path[i], p, a->sight->desc.surfaces,
                                           murk_photon_band(photon)) *
                murk_refracted_path_transmittance(&path[i], p,
                                                  murk_photon_band(photon)),
            .apparent = apparent,
            .leaving = murk_unit(murk_sub(s->crossing, path[i].photon)),
            .gain = ratio * ratio};
    }
    return lines;
}
