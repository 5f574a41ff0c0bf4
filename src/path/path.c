/* Straight rays through regions and surfaces: see path/path.h.
 *
 * The next boundary is the nearer of two: the one of half spaces, boxes and
 * spheres, exact in double precision, and the one of closed meshes, exact to a
 * tolerance. Within that tolerance both are crossed in one step, at the place
 * of the exact one; otherwise rounding would put a gap between regions that
 * touch, and light could be totally reflected at the gap. An optical depth
 * needs the faces of meshes only: for regions of other shapes
 * murk_media_optical_depth() finds the part of the ray inside
 * (medium/media.h). */
#include "path/path.h"

/* The box murk_path_space.grown extends beyond the domain on each side by this
 * share of the domain's largest coordinate: many times the rounding of rays in
 * single precision (6e-8), and four times the step of murk_surfaces_leave() if
 * no surface extends beyond the domain. */
#define GROWN_BY 4e-6

/* The regions around a point that may lie on a boundary are looked up at a
 * point that is moved by this many tolerances, so that rounding cannot put it
 * on the wrong side. For meshes the tolerance is mesh_tolerance_m; for other
 * shapes it is MURK_INTERFACE_NEAR times the domain's largest coordinate. */
#define OFF_TOLERANCES 2
#define OFF_NEARS      2

/* The largest number of boundaries that are followed along one ray, far more
 * than a scene is expected to have there. A ray with more is taken to be caught
 * between two boundaries by rounding: its rest counts as free of boundaries. */
#define STEPS_MAX 100000

/* Limit of the absolute cosine of the angle between the normals of a surface
 * and of a boundary within near_m of the surface. Above the limit the boundary
 * lies in the surface; otherwise boundary and surface merely cross there. */
#define ALIKE 0.9

/* ---- the space ---- */

double murk_path_margin_m(const murk_domain *domain)
{
    return GROWN_BY * murk_box_largest_coordinate(&domain->box);
}

murk_path_space murk_path_space_of(const murk_surfaces *surfaces,
                                   const murk_media *media,
                                   const murk_boundary_meshes *boundary_meshes,
                                   const murk_domain *domain)
{
    /* The domain, and a slightly larger box for surfaces. */
    const double margin_m = murk_path_margin_m(domain);
    murk_path_space space = {
        .surfaces = surfaces,
        .media = media,
        .boundary_meshes = boundary_meshes,
        .domain = domain,
        .sides = murk_path_sides_of(&domain->box, 0),
        .grown = murk_path_sides_of(&domain->box, margin_m),
        .margin_m = margin_m,
        .mesh_tolerance_m =
            boundary_meshes ? murk_boundary_meshes_tolerance_m(boundary_meshes)
                            : 0,
        .any_boundaries = murk_media_bends(media) || boundary_meshes};
    /* Tolerances and facts of the surfaces. */
    space.near_m = space.mesh_tolerance_m;
    if (surfaces) {
        const murk_surfaces_facts facts = murk_surfaces_describe(surfaces);
        space.any_surfaces = facts.triangles + facts.spheres > 0;
        space.any_solids = facts.solids > 0;
        space.near_m =
            fmax(2 * murk_surfaces_leave_step_m(surfaces), space.near_m);
    }
    return space;
}

murk_inside murk_path_inside(const murk_path_space *space, murk_vec3 point)
{
    const murk_inside meshes =
        space->boundary_meshes
            ? murk_boundary_meshes_at(space->boundary_meshes, point)
            : 0;
    return meshes | murk_media_inside(space->media, point);
}

murk_inside murk_path_inside_ahead(const murk_path_space *space,
                                   murk_vec3 point, murk_vec3 direction)
{
    const double near_m =
        MURK_INTERFACE_NEAR * murk_box_largest_coordinate(&space->domain->box);
    murk_inside inside = murk_media_inside(
        space->media, murk_along(point, OFF_NEARS * near_m, direction));
    if (space->boundary_meshes) {
        const double off_m = OFF_TOLERANCES * space->mesh_tolerance_m;
        inside |= murk_boundary_meshes_at(space->boundary_meshes,
                                          murk_along(point, off_m, direction));
    }
    return inside;
}

murk_inside murk_path_inside_wrapped(const murk_path_space *space,
                                     murk_inside inside, murk_vec3 point,
                                     int axis)
{
    inside = murk_media_wrapped(space->media, inside, point, axis);
    if (space->boundary_meshes) {
        /* Meshes are looked up at a point just inside the domain, because a
         * face of a mesh in the side does not count. */
        const murk_box *box = &space->domain->box;
        const double off = OFF_TOLERANCES * space->mesh_tolerance_m;
        const murk_vec3 middle = murk_scale(0.5, murk_add(box->min, box->max));
        const murk_vec3 in =
            axis == 0 ? murk_vec(point.x < middle.x ? off : -off, 0, 0)
                      : murk_vec(0, point.y < middle.y ? off : -off, 0);
        inside =
            (inside & ~murk_boundary_meshes_regions(space->boundary_meshes)) |
            murk_boundary_meshes_at(space->boundary_meshes,
                                    murk_add(point, in));
    }
    return inside;
}

/* ---- boundaries ---- */

murk_path murk_path_between(const murk_path_space *space, murk_vec3 from,
                            murk_vec3 to)
{
    const murk_vec3 offset = murk_sub(to, from);
    const double length_m = murk_length(offset);
    murk_path path = {.space = space,
                      .position = from,
                      .length_m = length_m,
                      .inside = murk_path_inside(space, from)};
    if (length_m > 0) {
        path.direction = murk_scale(1 / length_m, offset);
    }
    return path;
}

/* The next crossing of faces of meshes beyond path->skip_m and up to max_m;
 * false if there is none. Corrects path->inside if the faces ahead prove it
 * wrong (geometry/boundary_meshes.h). */
static bool next_face(murk_path *path, double max_m, murk_crossing *crossing)
{
    return murk_boundary_meshes_next(
        path->space->boundary_meshes, path->position, path->direction,
        path->skip_m, max_m, &path->inside, crossing);
}

static bool is_well_inside(const murk_box *box, murk_vec3 p, double margin)
{
    return p.x > box->min.x + margin && p.x < box->max.x - margin &&
           p.y > box->min.y + margin && p.y < box->max.y - margin &&
           p.z > box->min.z + margin && p.z < box->max.z - margin;
}

/* The largest number of a region in a set; 0 for the empty set. */
static size_t last_of(murk_inside set)
{
    size_t region = 0;
    while (set >>= 1) {
        ++region;
    }
    return region;
}

bool murk_path_next_boundary(murk_path *path, double mesh_max_m,
                             murk_path_boundary *boundary)
{
    const murk_path_space *space = path->space;
    murk_boundary *met = &boundary->met;
    const bool any = murk_media_boundary(
        space->media, path->inside,
        murk_along(path->position, path->gone_m, path->direction),
        path->direction, path->length_m - path->gone_m, met);
    if (any) {
        met->distance_m += path->gone_m;
    }
    boundary->has_shape = any;
    boundary->has_mesh = false;
    if (!space->boundary_meshes) {
        return any;
    }
    /* A face of a mesh counts if it lies no farther than the tolerance beyond
     * the other boundary, and not within the tolerance of a side of the
     * domain. */
    const double tolerance = space->mesh_tolerance_m;
    murk_crossing c;
    if (!next_face(path,
                   any ? fmin(mesh_max_m, met->distance_m + tolerance)
                       : mesh_max_m,
                   &c) ||
        !is_well_inside(
            &space->domain->box,
            murk_along(path->position, c.distance_m, path->direction),
            tolerance)) {
        return any;
    }
    boundary->has_mesh = true;
    boundary->mesh_m = c.distance_m;
    if (!any || c.distance_m + tolerance < met->distance_m) {
        boundary->has_shape = false;
        *met = (murk_boundary){.distance_m = fmax(0, c.distance_m),
                               .crossed = c.changed,
                               .region = last_of(c.changed),
                               .normal = c.normal};
        return true;
    }
    /* The ray crosses the mesh and the other boundary at once. Distance and
     * normal remain those of the other boundary, which is known exactly. */
    met->crossed |= c.changed;
    const size_t region = last_of(met->crossed);
    met->mean_square_slope = region == met->region ? met->mean_square_slope : 0;
    met->region = region;
    return true;
}

void murk_path_pass(murk_path *path, const murk_path_boundary *boundary)
{
    path->gone_m = boundary->met.distance_m;
    path->inside ^= boundary->met.crossed;
    if (boundary->has_mesh) {
        path->skip_m = boundary->mesh_m + path->space->mesh_tolerance_m;
    }
}

bool murk_path_next_change(murk_path *path, murk_path_change *change)
{
    const murk_media *media = path->space->media;
    const double mesh_max_m = path->length_m - path->space->mesh_tolerance_m;
    double before = 0;
    for (int step = 0; step < STEPS_MAX; ++step) {
        murk_path_boundary b;
        const bool any = murk_path_next_boundary(path, mesh_max_m, &b);
        /* murk_path_next_boundary() has corrected path->inside by the meshes
         * ahead. */
        if (step == 0) {
            before = murk_media_index(media, path->inside);
        }
        if (!any) {
            return false;
        }
        /* Beyond the boundary another index may hold. */
        murk_path_pass(path, &b);
        const double beyond = murk_media_index(media, path->inside);
        if (beyond != before) {
            *change = (murk_path_change){.distance_m = path->gone_m,
                                         .normal = b.met.normal,
                                         .is_mesh = !b.has_shape,
                                         .before = before,
                                         .beyond = beyond,
                                         .inside = path->inside};
            return true;
        }
    }
    return false;
}

/* Optical depth of the part of the ray from gone_m to to_m, which must cross no
 * face of a mesh: path->inside tells which meshes hold this part. For regions
 * of other shapes the position decides. */
static double depth_to(const murk_path *path, int band, double to_m)
{
    return murk_media_optical_depth(
        path->space->media, band, path->inside,
        murk_along(path->position, path->gone_m, path->direction),
        path->direction, to_m - path->gone_m);
}

double murk_path_depth(const murk_path *path, int band)
{
    murk_path p = *path;
    double depth = 0;
    murk_crossing c;
    for (int step = 0; p.space->boundary_meshes && step < STEPS_MAX &&
                       next_face(&p, p.length_m, &c);
         ++step) {
        depth += depth_to(&p, band, c.distance_m);
        p.gone_m = c.distance_m;
        p.skip_m = c.distance_m + p.space->mesh_tolerance_m;
        p.inside = c.inside;
    }
    return depth + depth_to(&p, band, p.length_m);
}

/* ---- the first event ---- */

/* True if a surface lies ahead of `probe` inside the box space->grown, of which
 * surfaces farther than near_m from the position may be left out; *distance_m
 * then is the distance of the nearest one from the ray's position, not below 0.
 */
static bool meets_surface(const murk_path *path, murk_vec3 probe, double near_m,
                          murk_hit *hit, double *distance_m)
{
    const murk_path_space *space = path->space;
    const double max_m =
        murk_path_sides_ahead(&space->grown, probe, path->direction);
    /* The distance of `probe` from the position, below 0 behind it. */
    const double ahead =
        murk_dot(murk_sub(probe, path->position), path->direction);
    if (!murk_surfaces_hit_near(space->surfaces, probe, path->direction, max_m,
                                near_m - ahead, hit)) {
        return false;
    }
    const double hit_m = hit->distance_m + ahead;
    *distance_m = hit_m > 0 ? hit_m : 0; /* fmax() is a call */
    return true;
}

/* True if the boundary lies before the surface at distance surface_m by more
 * than near_m, measured along the boundary's normal. Surfaces are known in
 * single precision only, so an almost parallel boundary (ALIKE) within near_m
 * of the surface, on either side, lies in the surface: the floor of a tank is
 * wet, and light passes from water directly into the glass that holds the
 * water. For a boundary that lies in the surface *crossed becomes the set of
 * regions that are entered or left there; otherwise *crossed is unchanged. */
static bool comes_first(const murk_path *path, const murk_boundary *boundary,
                        const murk_hit *hit, double surface_m,
                        murk_inside *crossed)
{
    const double gap_m = (surface_m - boundary->distance_m) *
                         fabs(murk_dot(boundary->normal, path->direction));
    const double near_m = path->space->near_m;
    if (!(gap_m > near_m) && !(gap_m < -near_m) &&
        fabs(murk_dot(boundary->normal, hit->normal)) > ALIKE) {
        *crossed = boundary->crossed;
    }
    return gap_m > near_m;
}

bool murk_path_first_event(const murk_path *path, murk_vec3 probe,
                           const murk_path_boundary *boundary, double near_m,
                           murk_path_event *event)
{
    const murk_path_space *space = path->space;
    event->kind = MURK_PATH_SIDE;
    event->crossed = 0;
    event->distance_m =
        murk_path_sides_ahead(&space->sides, path->position, path->direction);
    /* The negated comparisons also refuse NaN. */
    if (!(murk_path_sides_contain(&space->grown, path->position) &&
          event->distance_m < INFINITY)) {
        return false;
    }
    if (space->any_surfaces &&
        meets_surface(path, probe, near_m, &event->hit, &event->distance_m)) {
        event->kind = MURK_PATH_SURFACE;
        if (boundary && !comes_first(path, &boundary->met, &event->hit,
                                     event->distance_m, &event->crossed)) {
            return true;
        }
    }
    if (boundary && boundary->met.distance_m < event->distance_m) {
        event->kind = MURK_PATH_BOUNDARY;
        event->distance_m = boundary->met.distance_m;
        event->crossed = 0;
    }
    return true;
}
