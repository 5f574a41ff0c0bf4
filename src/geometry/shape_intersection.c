/* Test whether a closed mesh intersects a half space, box or sphere.
 *
 * Mesh and shape intersect if some triangle of the mesh reaches into the shape
 * and some corner lies outside of the shape. The shapes are convex, so corners
 * suffice for the second condition. For triangles and boxes the first is the
 * separating axis test (Akenine-Moeller, J. Graph. Tools 6 (2001) 29,
 * doi:10.1080/10867651.2001.10487535). */
#include "geometry/boundary_mesh.h"
#include "geometry/boundary_meshes.h"

#include "geometry/triangle.h"

/* True if `axis` separates the triangle from the open box. */
static bool is_separating_axis(const murk_triangle *t, murk_vec3 half,
                               murk_vec3 axis)
{
    const double a = murk_dot(t->a, axis), b = murk_dot(t->b, axis),
                 c = murk_dot(t->c, axis);
    const double reach =
        half.x * fabs(axis.x) + half.y * fabs(axis.y) + half.z * fabs(axis.z);
    return fmin(a, fmin(b, c)) >= reach || fmax(a, fmax(b, c)) <= -reach;
}

/* True if part of the triangle, given relative to the middle of the box, is
 * in the open box. */
static bool reaches_box(const murk_triangle *t, murk_vec3 half)
{
    const murk_vec3 own[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const murk_vec3 side[3] = {murk_sub(t->b, t->a), murk_sub(t->c, t->b),
                               murk_sub(t->a, t->c)};
    if (!(half.x > 0 && half.y > 0 && half.z > 0) ||
        is_separating_axis(t, half, murk_cross(side[0], side[1]))) {
        return false;
    }
    for (int i = 0; i < 3; ++i) {
        if (is_separating_axis(t, half, own[i])) {
            return false;
        }
        for (int k = 0; k < 3; ++k) {
            const murk_vec3 axis = murk_cross(own[i], side[k]);
            if (murk_dot(axis, axis) > 0 && is_separating_axis(t, half, axis)) {
                return false;
            }
        }
    }
    return true;
}

static murk_vec3 half_of(const murk_box *box, double more)
{
    const murk_vec3 half = murk_scale(0.5, murk_sub(box->max, box->min));
    return murk_add(half, murk_vec(more, more, more));
}

static murk_vec3 middle_of(const murk_box *box)
{
    return murk_scale(0.5, murk_add(box->min, box->max));
}

/* True if part of the triangle is inside the shape by more than the
 * tolerance. */
static bool reaches_in(const murk_plain_shape *s, const murk_triangle *t,
                       double tolerance)
{
    const double radius = s->radius_m - tolerance;
    const murk_vec3 middle = middle_of(&s->box);
    const murk_triangle from_middle = {
        murk_sub(t->a, middle), murk_sub(t->b, middle), murk_sub(t->c, middle)};
    switch (s->shape) {
    case MURK_REGION_BELOW:
        return fmin(t->a.z, fmin(t->b.z, t->c.z)) < s->box.max.z - tolerance;
    case MURK_REGION_BOX:
        return reaches_box(&from_middle, half_of(&s->box, -tolerance));
    default: /* a sphere */
        return radius > 0 &&
               murk_triangle_distance2(t, s->center) < radius * radius;
    }
}

/* True if the point is outside of the shape by more than the tolerance. */
static bool is_out(const murk_plain_shape *s, murk_vec3 p, double tolerance)
{
    const murk_vec3 half = half_of(&s->box, tolerance);
    const murk_vec3 off = murk_sub(p, middle_of(&s->box));
    switch (s->shape) {
    case MURK_REGION_BELOW:
        return p.z > s->box.max.z + tolerance;
    case MURK_REGION_BOX:
        return fabs(off.x) > half.x || fabs(off.y) > half.y ||
               fabs(off.z) > half.z;
    default: /* a sphere */
        return murk_length(murk_sub(p, s->center)) > s->radius_m + tolerance;
    }
}

bool murk_boundary_meshes_meet_plain(const murk_boundary_meshes *b, int region,
                                     const murk_plain_shape *shape,
                                     murk_vec3 *place)
{
    const murk_soup *soup = &murk_boundary_mesh_of(b, region)->shape->soup;
    /* Work in the coordinates of the shape; the tolerance is scaled to these
     * coordinates. */
    murk_affine to_local = murk_affine_identity();
    if (shape->shape != MURK_REGION_BELOW &&
        !murk_affine_invert(&shape->to_world, &to_local)) {
        return false;
    }
    const double *row = to_local.matrix[0];
    const double tolerance =
        b->tolerance_m * murk_length(murk_vec(row[0], row[1], row[2]));
    bool any_in = false, any_out = false;
    for (size_t i = 0; i < soup->triangles && !(any_in && any_out); ++i) {
        const murk_triangle t = murk_soup_placed_triangle(soup, i);
        const murk_triangle local = {murk_affine_point(&to_local, t.a),
                                     murk_affine_point(&to_local, t.b),
                                     murk_affine_point(&to_local, t.c)};
        /* Look for a part inside and a corner outside. */
        const bool in = reaches_in(shape, &local, tolerance);
        const bool out = is_out(shape, local.a, tolerance) ||
                         is_out(shape, local.b, tolerance) ||
                         is_out(shape, local.c, tolerance);
        if ((in && !any_in) || (out && !any_out)) {
            *place = t.a;
        }
        any_in |= in;
        any_out |= out;
    }
    return any_in && any_out;
}
