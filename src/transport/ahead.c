#include "transport/ahead.h"

/* Further from a mesh than its tolerance, a point is on one side of it. */
#define OFF_TOLERANCES 2
#define OFF_NEARS      2 /* likewise from other shapes */

static bool is_well_inside(const murk_box *box, murk_vec3 p, double margin)
{
    return p.x > box->min.x + margin && p.x < box->max.x - margin &&
           p.y > box->min.y + margin && p.y < box->max.y - margin &&
           p.z > box->min.z + margin && p.z < box->max.z - margin;
}

/* The region listed last among those of a set. */
static size_t last_of(murk_inside set)
{
    size_t region = 0;
    while (set >>= 1) {
        ++region;
    }
    return region;
}

bool murk_look_ahead(const murk_transport_world *world, murk_inside *inside,
                     murk_vec3 origin, murk_vec3 direction, double skip_m,
                     double max_m, murk_ahead *ahead)
{
    murk_boundary *b = &ahead->boundary;
    bool any = murk_media_boundary(world->media, *inside, origin, direction,
                                   INFINITY, b);
    ahead->is_mesh = false;
    if (!world->boundary_meshes) {
        return any;
    }
    const double tolerance =
        murk_boundary_meshes_tolerance_m(world->boundary_meshes);
    murk_crossing c;
    if (!murk_boundary_meshes_next(
            world->boundary_meshes, origin, direction, skip_m,
            any ? fmin(max_m, b->distance_m + tolerance) : max_m, inside, &c) ||
        !is_well_inside(&world->domain.box,
                        murk_along(origin, c.distance_m, direction),
                        tolerance)) {
        return any;
    }
    ahead->is_mesh = true;
    if (!any || c.distance_m + tolerance < b->distance_m) {
        *b = (murk_boundary){.distance_m = fmax(0, c.distance_m),
                             .crossed = c.changed,
                             .region = last_of(c.changed),
                             .normal = c.normal};
        return true;
    }
    /* Together: at the place of the shape's, which is exact. */
    b->crossed |= c.changed;
    const size_t region = last_of(b->crossed);
    b->mean_square_slope = region == b->region ? b->mean_square_slope : 0;
    b->region = region;
    return true;
}

murk_inside murk_inside_at(const murk_transport_world *world, murk_vec3 point,
                           murk_vec3 direction)
{
    const murk_box *box = &world->domain.box;
    const double size =
        fmax(fmax(fmax(fabs(box->min.x), fabs(box->min.y)), fabs(box->min.z)),
             fmax(fmax(fabs(box->max.x), fabs(box->max.y)), fabs(box->max.z)));
    murk_inside inside = murk_media_inside(
        world->media,
        murk_along(point, OFF_NEARS * MURK_INTERFACE_NEAR * size, direction));
    if (world->boundary_meshes) {
        const double off = OFF_TOLERANCES * murk_boundary_meshes_tolerance_m(
                                                world->boundary_meshes);
        inside |= murk_boundary_meshes_at(world->boundary_meshes,
                                          murk_along(point, off, direction));
    }
    return inside;
}

murk_inside murk_inside_wrapped(const murk_transport_world *world,
                                murk_inside inside, murk_vec3 point, int axis)
{
    inside = murk_media_wrapped(world->media, inside, point, axis);
    if (world->boundary_meshes) {
        /* Just inside the domain, where a face in its side does not count. */
        const murk_box *box = &world->domain.box;
        const double off = OFF_TOLERANCES * murk_boundary_meshes_tolerance_m(
                                                world->boundary_meshes);
        const murk_vec3 middle = murk_scale(0.5, murk_add(box->min, box->max));
        const murk_vec3 in =
            axis == 0 ? murk_vec(point.x < middle.x ? off : -off, 0, 0)
                      : murk_vec(0, point.y < middle.y ? off : -off, 0);
        inside =
            (inside & ~murk_boundary_meshes_regions(world->boundary_meshes)) |
            murk_boundary_meshes_at(world->boundary_meshes,
                                    murk_add(point, in));
    }
    return inside;
}
