/* Refracted paths: each face between sensor and photon gives one path through
 * its plane (sensing/snell.h). The path is valid if the walk along it
 * (path/path.h) meets the expected change of index at the crossing and no
 * other. The walk decides, so edges of faces, nested regions and coinciding
 * boundaries need no rules of their own. */
#include "sensing/refract.h"

#include <assert.h>

/* Tolerance between coinciding faces, as a multiple of the rounding of a single
 * crossing. */
#define NEAR_TIMES 8

void murk_interfaces_find(murk_interfaces *out, const murk_path_space *space)
{
    const murk_media *media = space->media;
    out->near_m = NEAR_TIMES * MURK_INTERFACE_NEAR *
                  murk_box_largest_coordinate(&space->domain->box);
    out->n = murk_media_flats(media, out->flat);
    out->indices = murk_media_indices(media, out->index);
    out->any_mesh = false;
    const murk_inside meshes =
        space->boundary_meshes
            ? murk_boundary_meshes_regions(space->boundary_meshes)
            : 0;
    for (int i = 0; i < MURK_REGIONS_MAX; ++i) {
        const murk_inside bit = (murk_inside)1 << i;
        /* the index inside this region alone; 1 if the region has none */
        if ((meshes & bit) && murk_media_index(media, bit) != 1) {
            out->any_mesh = true;
        }
    }
}

/* ---- one path ---- */

static murk_vec3 direction_of(murk_vec3 from, murk_vec3 to)
{
    return murk_unit(murk_sub(to, from));
}

static murk_vec3 inside_domain(const murk_path_viewpoint *v, murk_vec3 point)
{
    const murk_box *box = &v->space->domain->box;
    return murk_path_nearest_image(
        v->space->domain, point, murk_scale(0.5, murk_add(box->min, box->max)));
}

/* True if the point lies in the domain or within near_m of the domain. A tilted
 * face may extend beyond the domain, where no light is traced. */
static bool is_in_domain(const murk_interfaces *at,
                         const murk_path_viewpoint *v, murk_vec3 point)
{
    const murk_vec3 near = {at->near_m, at->near_m, at->near_m};
    const murk_box box = {murk_sub(v->space->domain->box.min, near),
                          murk_add(v->space->domain->box.max, near)};
    return murk_box_contains(&box, inside_domain(v, point));
}

/* The first of n segments along which the index changes; n if there is none. */
static int changing_segment(murk_path *segment, int n, murk_path_change *change)
{
    int i = 0;
    while (i < n && !(segment[i].length_m > 0 &&
                      murk_path_next_change(&segment[i], change))) {
        ++i;
    }
    return i;
}

/* Walks the first part of a path. True if the first change of index is the
 * crossing; *inside is then the set of regions beyond it. */
static bool reaches_crossing(const murk_interfaces *at,
                             const murk_path_viewpoint *v,
                             const murk_snell *path, const double n[2],
                             murk_inside *inside)
{
    const double tolerance = v->space->mesh_tolerance_m;
    murk_path segment[MURK_PATH_SEGMENTS_MAX];
    murk_path_change change;
    const int segments = murk_path_to(v, path->crossing, segment);
    murk_path *last = &segment[segments - 1];
    const double end = last->length_m;
    /* The index must not change before the last segment. The last segment ends
     * at the crossing; extended a little, the segment must meet the expected
     * change there. */
    if (changing_segment(segment, segments - 1, &change) < segments - 1 ||
        !(end > 0)) {
        return false;
    }
    last->length_m += at->near_m / path->cosine[0] + 3 * tolerance;
    if (!murk_path_next_change(last, &change) || change.before != n[0] ||
        change.beyond != n[1]) {
        return false;
    }
    const double off = fabs(change.distance_m - end);
    *inside = change.inside;
    return off * path->cosine[0] <= at->near_m || off <= 2 * tolerance;
}

/* Walks the second part, from the crossing on, in the regions `inside`. True if
 * no change of index is met. */
static bool goes_on(const murk_path_viewpoint *v, const murk_snell *path,
                    murk_vec3 photon, murk_inside inside)
{
    murk_path_viewpoint beyond = *v;
    beyond.position = inside_domain(v, path->crossing);
    const murk_vec3 to =
        murk_add(photon, murk_sub(beyond.position, path->crossing));
    murk_path segment[MURK_PATH_SEGMENTS_MAX];
    murk_path_change change;
    const int segments = murk_path_to(&beyond, to, segment);
    segment[0].inside = inside;
    segment[0].skip_m = v->space->mesh_tolerance_m;
    return changing_segment(segment, segments, &change) == segments;
}

/* Adds the path through a plane to the `had` found ones, if there is a valid
 * path that has not been found already. Returns the number of found paths. */
static size_t add_path(const murk_interfaces *at, const murk_path_viewpoint *v,
                       const murk_interface_plane *plane, murk_vec3 photon,
                       const double n[2], murk_refracted_path *found,
                       size_t had)
{
    murk_snell path;
    murk_inside inside;
    if (had == MURK_REFRACTED_PATHS_MAX ||
        !murk_snell_path(v->position, photon, plane, n, &path)) {
        return had;
    }
    /* Drop a path whose crossing has been found with another face. */
    for (size_t i = 0; i < had; ++i) {
        const murk_vec3 offset =
            murk_sub(found[i].snell.crossing, path.crossing);
        if (murk_length(offset) * path.cosine[0] <= at->near_m) {
            return had;
        }
    }
    /* Both parts must run without a further change of the index. */
    if (!is_in_domain(at, v, path.crossing) ||
        !reaches_crossing(at, v, &path, n, &inside) ||
        !goes_on(v, &path, photon, inside)) {
        return had;
    }
    found[had] = (murk_refracted_path){path, photon};
    return had + 1;
}

/* ---- all paths ---- */

/* Finds the place at which the straight line first meets another index. False
 * if it does not. */
static bool first_change(const murk_path_viewpoint *v, murk_vec3 photon,
                         murk_path_change *change, murk_vec3 *place)
{
    murk_path segment[MURK_PATH_SEGMENTS_MAX];
    const int segments = murk_path_to(v, photon, segment);
    const int at = changing_segment(segment, segments, change);
    if (at == segments) {
        return false;
    }
    double gone = 0;
    for (int i = 0; i < at; ++i) {
        gone += segment[i].length_m;
    }
    *place = murk_along(v->position, gone + change->distance_m,
                        direction_of(v->position, photon));
    return true;
}

static bool is_beyond_critical(const murk_path_change *change,
                               murk_vec3 direction)
{
    const double ratio = fmax(change->before, change->beyond) /
                         fmin(change->before, change->beyond);
    const double sine = murk_length(murk_cross(change->normal, direction));
    return sine * ratio >= 1;
}

size_t murk_refracted_paths_find(
    const murk_interfaces *at, const murk_path_viewpoint *v, murk_vec3 photon,
    double photon_index, murk_refracted_path path[MURK_REFRACTED_PATHS_MAX],
    bool *is_reflected)
{
    const murk_vec3 image =
        murk_path_nearest_image(v->space->domain, photon, v->position);
    const murk_vec3 shift = murk_sub(image, photon);
    const bool is_here = murk_dot(shift, shift) == 0;
    const double n[2] = {v->index, photon_index};
    assert(n[0] != n[1]);
    size_t paths = 0;
    for (size_t i = 0; i < at->n; ++i) {
        /* In a periodic domain the nearest image of the photon may lie in
         * another period than the sensor. The path may then cross the face in
         * the period of the sensor, or the copy of the face in the period of
         * the image. */
        murk_interface_plane plane = {at->flat[i].point, at->flat[i].normal};
        paths = add_path(at, v, &plane, image, n, path, paths);
        if (!is_here) {
            plane.point = murk_add(plane.point, shift);
            paths = add_path(at, v, &plane, image, n, path, paths);
        }
    }
    /* Of meshes, the face at which the straight line first changes the index is
     * tried. If there is no path and the straight line meets that boundary, of
     * a mesh or flat, beyond the critical angle, the light is taken to be
     * totally reflected. */
    *is_reflected = false;
    murk_path_change change;
    murk_vec3 place;
    if ((at->any_mesh || paths == 0) &&
        first_change(v, image, &change, &place)) {
        if (change.is_mesh) {
            const murk_interface_plane plane = {place, change.normal};
            paths = add_path(at, v, &plane, image, n, path, paths);
        }
        *is_reflected =
            paths == 0 &&
            is_beyond_critical(&change, direction_of(v->position, image));
    }
    return paths;
}

double murk_refracted_paths_range(const murk_interfaces *at,
                                  const murk_path_viewpoint *v, double range_m)
{
    double reach = range_m;
    if (at->any_mesh || v->space->domain->is_periodic) {
        return INFINITY;
    }
    for (size_t i = 0; i < at->n; ++i) {
        const murk_flat *flat = &at->flat[i];
        const double height =
            fabs(murk_dot(murk_sub(v->position, flat->point), flat->normal));
        for (size_t k = 0; k < at->indices; ++k) {
            const double n[2] = {v->index, at->index[k]};
            if (n[0] != n[1]) {
                reach = fmax(reach, murk_snell_reach(range_m, height, n));
            }
        }
    }
    return reach;
}

/* ---- along a path ---- */

/* The crossing, moved to the period of the photon. */
static murk_vec3 crossing_near(const murk_refracted_path *path,
                               murk_vec3 photon)
{
    return murk_add(path->snell.crossing, murk_sub(photon, path->photon));
}

double murk_refracted_path_transmittance(const murk_refracted_path *path,
                                         const murk_path_viewpoint *v, int band)
{
    const murk_vec3 photon = inside_domain(v, path->photon);
    const murk_path_viewpoint back = murk_path_viewpoint_at(v->space, photon);
    const murk_vec3 crossing = inside_domain(v, path->snell.crossing);
    return murk_path_transmittance_to(v, band, crossing) *
           murk_path_transmittance_to(&back, band, crossing);
}

/* The end of the test of the part of a path from `from` to the crossing:
 * tolerance_m beyond the crossing, or length_m beyond it if the other part of
 * the path, of this length, is shorter. */
static murk_vec3 beyond(murk_vec3 from, murk_vec3 crossing, double tolerance_m,
                        double length_m)
{
    return murk_along(crossing, fmin(tolerance_m, length_m),
                      direction_of(from, crossing));
}

bool murk_refracted_path_blocked(const murk_refracted_path *path,
                                 const murk_path_viewpoint *v,
                                 const murk_surfaces *surfaces,
                                 bool through_sheets)
{
    const murk_snell *s = &path->snell;
    const double sight_tolerance =
        murk_path_surface_tolerance_m(surfaces, v->space->domain);
    const murk_vec3 photon = inside_domain(v, path->photon);
    const murk_vec3 crossing = crossing_near(path, photon);
    /* each part is tested a little beyond the crossing, so that neither misses
     * a surface that lies in the boundary */
    return murk_path_blocked(surfaces, v->space->domain, v->position,
                             beyond(v->position, s->crossing, sight_tolerance,
                                    s->length_m[1]),
                             through_sheets) ||
           murk_path_blocked(
               surfaces, v->space->domain, photon,
               beyond(photon, crossing, sight_tolerance, s->length_m[0]),
               through_sheets);
}

double murk_refracted_path_sheets(const murk_refracted_path *path,
                                  const murk_path_viewpoint *v,
                                  const murk_surfaces *surfaces, int band)
{
    const murk_snell *s = &path->snell;
    const double sight_tolerance =
        murk_path_surface_tolerance_m(surfaces, v->space->domain);
    const murk_vec3 photon = inside_domain(v, path->photon);
    const murk_vec3 crossing = crossing_near(path, photon);
    double through = murk_path_sheets(
        surfaces, v->space->domain, v->position,
        beyond(v->position, s->crossing, sight_tolerance, s->length_m[1]),
        band);
    if (s->length_m[1] > sight_tolerance) {
        through *= murk_path_sheets(surfaces, v->space->domain, photon,
                                    murk_along(crossing, sight_tolerance,
                                               direction_of(crossing, photon)),
                                    band);
    }
    return through;
}
