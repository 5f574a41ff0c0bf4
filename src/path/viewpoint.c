/* Straight paths from one point to many: see path/viewpoint.h. If no region is
 * a mesh, murk_media_optical_depth() needs no set of regions, so one call for
 * each segment gives the optical depth. */
#include "path/viewpoint.h"

murk_path_viewpoint murk_path_viewpoint_at(const murk_path_space *space,
                                           murk_vec3 position)
{
    const murk_inside meshes =
        space->boundary_meshes
            ? murk_boundary_meshes_at(space->boundary_meshes, position)
            : 0;
    return (murk_path_viewpoint){
        .space = space,
        .position = position,
        .meshes = meshes,
        .index = murk_media_index(
            space->media, meshes | murk_media_inside(space->media, position))};
}

double murk_path_index_at(const murk_path_space *space, murk_vec3 point)
{
    return murk_media_index(space->media, murk_path_inside(space, point));
}

/* The path along a segment, number `i` (from 0) of the line from the viewpoint.
 * All segments but the first begin in a side of the domain, in which a face of
 * a mesh is no boundary: the meshes that contain such a segment are looked up a
 * little farther along the segment. */
static murk_path path_of(const murk_path_viewpoint *v, int i,
                         const murk_path_segment *segment)
{
    const murk_path_space *space = v->space;
    const murk_vec3 offset = murk_sub(segment->to, segment->from);
    const double length = murk_length(offset);
    murk_path p = {.space = space,
                   .position = segment->from,
                   .length_m = length,
                   .inside = v->meshes};
    if (length > 0) {
        p.direction = murk_scale(1 / length, offset);
    }
    if (i > 0 && space->boundary_meshes) {
        p.skip_m = space->mesh_tolerance_m;
        p.inside = murk_boundary_meshes_at(
            space->boundary_meshes,
            murk_along(p.position, 2 * p.skip_m, p.direction));
    }
    p.inside |= murk_media_inside(space->media, p.position);
    return p;
}

int murk_path_to(const murk_path_viewpoint *v, murk_vec3 point,
                 murk_path path[MURK_PATH_SEGMENTS_MAX])
{
    const murk_domain *domain = v->space->domain;
    murk_path_segment segment[MURK_PATH_SEGMENTS_MAX];
    const int n = murk_path_cut(
        domain, v->position,
        murk_path_nearest_image(domain, point, v->position), 0, segment);
    for (int i = 0; i < n; ++i) {
        path[i] = path_of(v, i, &segment[i]);
    }
    return n;
}

/* ---- media ---- */

/* Optical depths of the segments of the line between the viewpoint and the
 * nearest image of a point; returns the number of segments. The segments are
 * listed from the viewpoint on if a region is a mesh, otherwise from the point
 * on. */
static int depths_to(const murk_path_viewpoint *v, int band, murk_vec3 point,
                     double depth[MURK_PATH_SEGMENTS_MAX])
{
    const murk_path_space *space = v->space;
    if (!space->boundary_meshes) {
        /* Without meshes the line is followed from the point to the viewpoint,
         * and no set of regions is needed. */
        murk_path_segment segment[MURK_PATH_SEGMENTS_MAX];
        const murk_vec3 to =
            murk_path_nearest_image(space->domain, v->position, point);
        const int n = murk_path_cut(space->domain, point, to, 0, segment);
        for (int i = 0; i < n; ++i) {
            const murk_vec3 offset = murk_sub(segment[i].to, segment[i].from);
            const double length = murk_length(offset);
            depth[i] = length > 0 ? murk_media_optical_depth(
                                        space->media, band, 0, segment[i].from,
                                        murk_scale(1 / length, offset), length)
                                  : 0;
        }
        return n;
    }
    murk_path path[MURK_PATH_SEGMENTS_MAX];
    const int n = murk_path_to(v, point, path);
    for (int i = 0; i < n; ++i) {
        depth[i] = path[i].length_m > 0 ? murk_path_depth(&path[i], band) : 0;
    }
    return n;
}

double murk_path_depth_to(const murk_path_viewpoint *v, int band,
                          murk_vec3 point)
{
    double segment[MURK_PATH_SEGMENTS_MAX], depth = 0;
    const int n = depths_to(v, band, point, segment);
    for (int i = 0; i < n; ++i) {
        depth += segment[i];
    }
    return depth;
}

double murk_path_transmittance_to(const murk_path_viewpoint *v, int band,
                                  murk_vec3 point)
{
    double segment[MURK_PATH_SEGMENTS_MAX], through = 1;
    const int n = depths_to(v, band, point, segment);
    for (int i = 0; i < n; ++i) {
        through *= exp(-segment[i]);
    }
    return through;
}

/* ---- the index of refraction ---- */

/* True if the index of refraction changes between two points, which lie in one
 * segment; false if the points are equal. Only for worlds in which no region is
 * a mesh. Different indices at the points decide at once; between equal ones
 * there may still be a change. */
static bool bends_between(const murk_path_space *space, murk_vec3 from,
                          murk_vec3 to)
{
    if (!(murk_length(murk_sub(to, from)) > 0)) {
        return false;
    }
    murk_path path = murk_path_between(space, from, to);
    murk_path_change change;
    return murk_path_index_at(space, to) !=
               murk_media_index(space->media, path.inside) ||
           murk_path_next_change(&path, &change);
}

bool murk_path_bends_to(const murk_path_viewpoint *v, murk_vec3 point)
{
    const murk_path_space *space = v->space;
    if (!murk_media_bends(space->media)) {
        return false;
    }
    if (!space->boundary_meshes) {
        /* Without meshes the line is followed from the point on. */
        murk_path_segment segment[MURK_PATH_SEGMENTS_MAX];
        const int n = murk_path_cut(
            space->domain, point,
            murk_path_nearest_image(space->domain, v->position, point), 0,
            segment);
        for (int i = 0; i < n; ++i) {
            if (bends_between(space, segment[i].from, segment[i].to)) {
                return true;
            }
        }
        return false;
    }
    /* If a region is a mesh, the line is followed from the viewpoint on. */
    murk_path path[MURK_PATH_SEGMENTS_MAX];
    const int n = murk_path_to(v, point, path);
    for (int i = 0; i < n; ++i) {
        murk_path_change change;
        if (path[i].length_m > 0 && murk_path_next_change(&path[i], &change)) {
            return true;
        }
    }
    return false;
}
