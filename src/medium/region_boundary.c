/* Boundaries of refractive regions: construction, and the test whether two of
 * them intersect.
 *
 * All boundaries but those of meshes, which are not tested here, are convex:
 * boxes (a half space is a box with all faces but one at infinity) and spheres.
 * Therefore corners, distances and separating axes decide whether two of them
 * intersect (Gottschalk, Lin and Manocha, SIGGRAPH 1996,
 * doi:10.1145/237170.237244). */
#include "medium/region_boundary.h"

#include "base/log.h"

#include <math.h>
#include <string.h>

double murk_region_boundary_near(const murk_box *domain)
{
    return MURK_INTERFACE_NEAR * murk_box_largest_coordinate(domain);
}

/* The world axis that is parallel to an axis of the region's frame, or -1.
 * Tilts too small to move a face by murk_region_boundary_near() inside the
 * domain are ignored. */
static int world_axis_of(const murk_region_boundary *boundary, int local)
{
    const double *row = boundary->to_local.matrix[local];
    for (int axis = 0; axis < 3; ++axis) {
        const double aside = hypot(row[(axis + 1) % 3], row[(axis + 2) % 3]);
        if (aside <= MURK_INTERFACE_NEAR * fabs(row[axis])) {
            return axis;
        }
    }
    return -1;
}

/* Moves a face to infinity, and returns true, if it lies on that side of the
 * domain which faces the same way, or beyond this side. */
static bool open_face(murk_region_boundary *boundary, int local, int axis,
                      bool upper, const murk_box *domain)
{
    const double along = boundary->to_local.matrix[local][axis];
    const double face =
        murk_component(upper ? boundary->box.max : boundary->box.min, local);
    const double at =
        (face - murk_component(boundary->to_local.shift, local)) / along;
    const double near = murk_region_boundary_near(domain);
    const bool faces_up = upper == (along > 0);
    const bool is_open = faces_up
                             ? at >= murk_component(domain->max, axis) - near
                             : at <= murk_component(domain->min, axis) + near;
    if (is_open) {
        murk_component_set(upper ? &boundary->box.max : &boundary->box.min,
                           local, upper ? INFINITY : -INFINITY);
    }
    return is_open;
}

static void open_faces(murk_region_boundary *boundary, const murk_box *domain)
{
    for (int local = 0; local < 3; ++local) {
        const int axis = world_axis_of(boundary, local);
        if (axis >= 0) {
            const bool low = open_face(boundary, local, axis, false, domain);
            const bool high = open_face(boundary, local, axis, true, domain);
            if (axis < 2) {
                boundary->spans[axis] = low && high;
            }
        }
    }
}

bool murk_region_boundary_make(murk_region_boundary *boundary, size_t number,
                               const murk_region *region,
                               const murk_box *domain)
{
    const murk_affine identity = murk_affine_identity();
    murk_region_boundary made = {.region = number,
                                 .shape = region->shape,
                                 .ior = region->ior,
                                 .mean_square_slope = region->mean_square_slope,
                                 .to_local = identity,
                                 .box = region->box,
                                 .center = region->center,
                                 .radius = region->radius_m};
    switch (region->shape) {
    case MURK_REGION_EVERYWHERE:
    case MURK_REGION_MESH: /* only the index matters here */
        made.spans[0] = made.spans[1] = true;
        break;
    case MURK_REGION_BELOW:
        made.box = (murk_box){{-INFINITY, -INFINITY, -INFINITY},
                              {INFINITY, INFINITY, region->below_z_m}};
        open_faces(&made, domain);
        break;
    case MURK_REGION_BOX:
    case MURK_REGION_SPHERE:
        if (!murk_affine_invert(&region->to_world, &made.to_local)) {
            return false;
        }
        made.is_moved =
            memcmp(&region->to_world, &identity, sizeof identity) != 0;
        if (region->shape == MURK_REGION_BOX) {
            open_faces(&made, domain);
        }
        break;
    case MURK_REGION_GRID:
        break;
    }
    *boundary = made;
    return true;
}

bool murk_region_boundary_holds(const murk_region_boundary *boundary,
                                murk_vec3 p)
{
    if (boundary->is_moved) {
        p = murk_affine_point(&boundary->to_local, p);
    }
    if (boundary->shape == MURK_REGION_EVERYWHERE) {
        return true;
    }
    if (boundary->shape == MURK_REGION_MESH) {
        return false;
    }
    if (boundary->shape == MURK_REGION_SPHERE) {
        const murk_vec3 off = murk_sub(p, boundary->center);
        return murk_dot(off, off) < boundary->radius * boundary->radius;
    }
    return murk_box_holds(&boundary->box, p);
}

/* ---- intersection of two boundaries ---- */

/* A sphere, all of space (is_all), or a box; half[i] is the vector from the
 * middle of the box to a face. */
typedef struct body {
    bool is_sphere, is_all;
    murk_vec3 center, half[3];
    double radius;
} body;

static murk_affine world_of(const murk_region_boundary *boundary)
{
    murk_affine to_world = murk_affine_identity();
    murk_affine_invert(&boundary->to_local,
                       &to_world); /* to_local was computed by inversion */
    return to_world;
}

/* Converts a boundary to world coordinates. Faces at infinity are put at the
 * distance `far`, computed by far_of(), from the origin of the region's frame,
 * so that they lie beyond all finite faces. */
static body body_of(const murk_region_boundary *boundary, double far)
{
    const murk_affine to_world = world_of(boundary);
    body b = {.is_sphere = boundary->shape == MURK_REGION_SPHERE,
              .is_all = boundary->shape == MURK_REGION_EVERYWHERE};
    murk_vec3 middle = boundary->center;
    for (int i = 0; i < 3; ++i) {
        const murk_vec3 axis = {to_world.matrix[0][i], to_world.matrix[1][i],
                                to_world.matrix[2][i]};
        const double scale = murk_length(axis), limit = far / scale;
        b.radius = boundary->radius * scale;
        if (!b.is_sphere && !b.is_all) {
            const double low =
                fmax(murk_component(boundary->box.min, i), -limit);
            const double high =
                fmin(murk_component(boundary->box.max, i), limit);
            murk_component_set(&middle, i, (low + high) / 2);
            b.half[i] = murk_scale((high - low) / 2, axis);
        }
    }
    b.center = murk_affine_point(&to_world, middle);
    return b;
}

/* Half of the extent of a box along the unit vector n. */
static double reach(const body *box, murk_vec3 n)
{
    return fabs(murk_dot(box->half[0], n)) + fabs(murk_dot(box->half[1], n)) +
           fabs(murk_dot(box->half[2], n));
}

static murk_vec3 corner(const body *box, int i)
{
    murk_vec3 p = box->center;
    for (int axis = 0; axis < 3; ++axis) {
        p = murk_along(p, i >> axis & 1 ? 1 : -1, box->half[axis]);
    }
    return p;
}

/* Distance of p outside of the two faces across an axis of the box; negative
 * inside. */
static double beyond_faces(const body *box, int axis, murk_vec3 p)
{
    const double half = murk_length(box->half[axis]);
    const murk_vec3 off = murk_sub(p, box->center);
    return fabs(murk_dot(off, box->half[axis])) / half - half;
}

static bool is_in_box(const body *p, const body *box, double near)
{
    for (int axis = 0; axis < 3; ++axis) {
        if (p->is_sphere) {
            if (beyond_faces(box, axis, p->center) + p->radius > near) {
                return false;
            }
            continue;
        }
        for (int i = 0; i < 8; ++i) {
            if (beyond_faces(box, axis, corner(p, i)) > near) {
                return false;
            }
        }
    }
    return true;
}

static bool is_in_sphere(const body *p, const body *sphere, double near)
{
    if (p->is_sphere) {
        return murk_length(murk_sub(p->center, sphere->center)) + p->radius <=
               sphere->radius + near;
    }
    for (int i = 0; i < 8; ++i) {
        if (murk_length(murk_sub(corner(p, i), sphere->center)) >
            sphere->radius + near) {
            return false;
        }
    }
    return true;
}

static bool is_in(const body *inner, const body *outer, double near)
{
    if (inner->is_all || outer->is_all) {
        return outer->is_all;
    }
    return outer->is_sphere ? is_in_sphere(inner, outer, near)
                            : is_in_box(inner, outer, near);
}

static bool sphere_and_box_separate(const body *sphere, const body *box,
                                    double near)
{
    double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double beyond = fmax(0, beyond_faces(box, axis, sphere->center));
        square += beyond * beyond;
    }
    return sqrt(square) >= sphere->radius - near;
}

static bool separates(const body *a, const body *b, murk_vec3 n, double near)
{
    const double distance = fabs(murk_dot(murk_sub(b->center, a->center), n));
    return distance >= reach(a, n) + reach(b, n) - near;
}

/* Sine of the angle below which two edges count as parallel. The common
 * normal of parallel edges is no further separating axis: the normals of the
 * faces suffice. */
#define PARALLEL 1e-9

static bool box_pair_separate(const body *a, const body *b, double near)
{
    murk_vec3 side[2][3];
    for (int i = 0; i < 3; ++i) {
        side[0][i] = murk_unit(a->half[i]);
        side[1][i] = murk_unit(b->half[i]);
        if (separates(a, b, side[0][i], near) ||
            separates(a, b, side[1][i], near)) {
            return true;
        }
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const murk_vec3 n = murk_cross(side[0][i], side[1][j]);
            if (murk_length(n) > PARALLEL &&
                separates(a, b, murk_unit(n), near)) {
                return true;
            }
        }
    }
    return false;
}

static bool are_separate(const body *a, const body *b, double near)
{
    if (a->is_sphere && b->is_sphere) {
        return murk_length(murk_sub(a->center, b->center)) >=
               a->radius + b->radius - near;
    }
    return a->is_sphere   ? sphere_and_box_separate(a, b, near)
           : b->is_sphere ? sphere_and_box_separate(b, a, near)
                          : box_pair_separate(a, b, near);
}

/* Four times an upper limit of the finite coordinates of all boundaries and of
 * the domain. */
static double far_of(const murk_region_boundary *boundaries, size_t n,
                     const murk_box *domain)
{
    double maximum = murk_region_boundary_near(domain) / MURK_INTERFACE_NEAR;
    for (size_t i = 0; i < n; ++i) {
        const murk_region_boundary *s = &boundaries[i];
        const murk_vec3 corner_of[] = {
            s->box.min, s->box.max,
            murk_along(s->center, s->radius, murk_vec(1, 1, 1)),
            murk_along(s->center, -s->radius, murk_vec(1, 1, 1))};
        const murk_affine to_world = world_of(s);
        for (size_t k = 0; k < sizeof corner_of / sizeof *corner_of; ++k) {
            double far = murk_length(to_world.shift);
            for (int axis = 0; axis < 3; ++axis) {
                const double at = murk_component(corner_of[k], axis);
                const double *row = to_world.matrix[axis];
                const double scale = hypot(row[0], hypot(row[1], row[2]));
                far += isfinite(at) ? fabs(at) * scale : 0;
            }
            maximum = fmax(maximum, far);
        }
    }
    return 4 * maximum;
}

static const char *where_of(const murk_region *regions,
                            const murk_region_boundary *boundary)
{
    const char *where = regions[boundary->region].where;
    return where ? where : "region";
}

/* True if the region is a mesh, whose triangles src/medium does not know. */
static bool is_mesh(const murk_region_boundary *boundary)
{
    return boundary->shape == MURK_REGION_MESH;
}

murk_status murk_region_boundaries_check(const murk_region_boundary *boundaries,
                                         size_t n, const murk_region *regions,
                                         const murk_box *domain,
                                         murk_error *err)
{
    const double far = far_of(boundaries, n, domain);
    const double near = murk_region_boundary_near(domain);
    for (size_t later = 0; later < n; ++later) {
        const body b = body_of(&boundaries[later], far);
        for (size_t i = 0; i < later; ++i) {
            if (is_mesh(&boundaries[i]) || is_mesh(&boundaries[later])) {
                continue;
            }
            /* Nested and separate boundaries are allowed; the order of
             * nested ones matters. */
            const body a = body_of(&boundaries[i], far);
            if (is_in(&a, &b, near)) {
                murk_warn(where_of(regions, &boundaries[i]),
                          "lies wholly in %s, which is listed after it and "
                          "takes its place",
                          where_of(regions, &boundaries[later]));
            } else if (!is_in(&b, &a, near) && !are_separate(&a, &b, near)) {
                return murk_fail(err, MURK_BAD_VALUE,
                                 where_of(regions, &boundaries[later]),
                                 "crosses %s, must lie in it, hold it or lie "
                                 "apart: both have an index of refraction",
                                 where_of(regions, &boundaries[i]));
            }
        }
    }
    return MURK_OK;
}
