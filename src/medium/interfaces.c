/* Intersections of rays with the boundaries of refractive regions
 * (medium/interfaces.h): boxes and half spaces by slabs, spheres by the
 * quadratic equation, each with rules that make the set of regions, not the
 * rounded position, decide which intersection counts. */
#include "medium/interfaces.h"

#include "medium/media_parts.h"

#include <math.h>

/* The intersection of a ray with one boundary, in world coordinates. */
typedef struct boundary_hit {
    double distance;
    murk_vec3 normal; /* any length, either side */
} boundary_hit;

/* The normal of a face in world coordinates is a row of to_local. */
static murk_vec3 face_normal(const murk_region_boundary *region_boundary,
                             int axis)
{
    const double *row = region_boundary->to_local.matrix[axis];
    return murk_vec(row[0], row[1], row[2]);
}

/* The exit of a ray inside a box: the nearest of the faces that the ray
 * approaches, whatever the position; a face already passed is hit at once.
 * Faces that are parallel to the ray, or at infinity, are not hit. False if the
 * ray hits no face. */
static bool leave_box(const murk_region_boundary *region_boundary, murk_vec3 o,
                      murk_vec3 d, boundary_hit *hit)
{
    const murk_box *box = &region_boundary->box;
    const double ahead[3] = {
        d.x == 0 ? INFINITY : ((d.x > 0 ? box->max.x : box->min.x) - o.x) / d.x,
        d.y == 0 ? INFINITY : ((d.y > 0 ? box->max.y : box->min.y) - o.y) / d.y,
        d.z == 0 ? INFINITY
                 : ((d.z > 0 ? box->max.z : box->min.z) - o.z) / d.z};
    int axis = -1;
    hit->distance = INFINITY;
    for (int i = 0; i < 3; ++i) {
        if (ahead[i] < hit->distance) {
            hit->distance = ahead[i];
            axis = i;
        }
    }
    if (axis < 0) {
        return false;
    }
    hit->distance = fmax(0, hit->distance);
    hit->normal = face_normal(region_boundary, axis);
    return true;
}

/* The entry of a ray outside of a box. A ray that starts on a face may lie
 * inside by rounding. If the exit is closer than the entry is behind, the
 * ray has just left; therefore the box is entered only if the middle of the
 * chord is ahead. */
static bool enter_box(const murk_region_boundary *region_boundary, murk_vec3 o,
                      murk_vec3 d, boundary_hit *hit)
{
    const double from[3] = {o.x, o.y, o.z}, along[3] = {d.x, d.y, d.z};
    const double min[3] = {region_boundary->box.min.x,
                           region_boundary->box.min.y,
                           region_boundary->box.min.z};
    const double max[3] = {region_boundary->box.max.x,
                           region_boundary->box.max.y,
                           region_boundary->box.max.z};
    /* Intersect the slabs of the three axes. */
    double t0 = -INFINITY, t1 = INFINITY;
    int axis = -1;
    for (int i = 0; i < 3; ++i) {
        if (along[i] == 0) {
            if (!(from[i] > min[i] && from[i] < max[i])) {
                return false;
            }
            continue;
        }
        const double a = (min[i] - from[i]) / along[i];
        const double b = (max[i] - from[i]) / along[i];
        const double enter = along[i] > 0 ? a : b;
        const double leave = along[i] > 0 ? b : a;
        if (enter > t0) {
            t0 = enter;
            axis = i;
        }
        t1 = leave < t1 ? leave : t1;
    }
    /* No overlap of the slabs, or the middle of the chord is behind. */
    if (axis < 0 || !(t0 < t1 && t0 + t1 > 0)) {
        return false;
    }
    hit->distance = fmax(0, t0);
    hit->normal = face_normal(region_boundary, axis);
    return true;
}

/* Intersection with a sphere. The middle of the chord is at `nearest`, so
 * the rule of enter_box() is that the ray heads inwards. For a grazing ray
 * inside, rounding may leave no chord: then it leaves at the nearest point. */
static bool hit_sphere(const murk_region_boundary *region_boundary,
                       bool is_inside, murk_vec3 o, murk_vec3 d,
                       boundary_hit *hit)
{
    const double square = murk_dot(d, d);
    const double nearest =
        murk_dot(murk_sub(region_boundary->center, o), d) / square;
    const murk_vec3 off =
        murk_sub(murk_along(o, nearest, d), region_boundary->center);
    const double left =
        region_boundary->radius * region_boundary->radius - murk_dot(off, off);
    const double half = left > 0 ? sqrt(left / square) : 0;
    if (!is_inside && !(half > 0 && nearest > 0)) {
        return false;
    }
    hit->distance = fmax(0, is_inside ? nearest + half : nearest - half);
    const murk_vec3 n =
        murk_sub(murk_along(o, hit->distance, d), region_boundary->center);
    const double(*m)[3] = region_boundary->to_local.matrix;
    hit->normal = murk_vec(m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
                           m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                           m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z);
    return true;
}

static bool hit_boundary(const murk_region_boundary *region_boundary,
                         bool is_inside, murk_vec3 o, murk_vec3 d,
                         boundary_hit *hit)
{
    if (region_boundary->is_moved) {
        o = murk_affine_point(&region_boundary->to_local, o);
        d = murk_affine_direction(&region_boundary->to_local, d);
    }
    switch (region_boundary->shape) {
    case MURK_REGION_BOX:
    case MURK_REGION_BELOW:
        return is_inside ? leave_box(region_boundary, o, d, hit)
                         : enter_box(region_boundary, o, d, hit);
    case MURK_REGION_SPHERE:
        return hit_sphere(region_boundary, is_inside, o, d, hit);
    case MURK_REGION_EVERYWHERE:
    case MURK_REGION_GRID:
    case MURK_REGION_MESH:
        break;
    }
    return false;
}

/* The unit normal on the side of the ray's origin. */
static murk_vec3 facing(const boundary_hit *hit, bool is_inside,
                        murk_vec3 direction,
                        const murk_region_boundary *region_boundary)
{
    const murk_vec3 n = murk_unit(hit->normal);
    const bool flips = region_boundary->shape == MURK_REGION_SPHERE
                           ? is_inside
                           : murk_dot(n, direction) > 0;
    return flips ? murk_scale(-1, n) : n;
}

/* A face as a plane in world coordinates: the points p with row . p + shift =
 * at, where row and shift are those of to_local for this axis, and `at` is the
 * coordinate of the face in the frame of the region. */
static murk_flat flat_of(const murk_region_boundary *region_boundary, int axis,
                         double at, bool is_upper)
{
    const murk_vec3 row = face_normal(region_boundary, axis);
    const double shift = murk_component(region_boundary->to_local.shift, axis);
    return (murk_flat){.region = region_boundary->region,
                       .point =
                           murk_scale((at - shift) / murk_dot(row, row), row),
                       .normal = murk_scale(is_upper ? 1 : -1, murk_unit(row))};
}

size_t murk_media_flats(const murk_media *media, murk_flat flat[MURK_FLATS_MAX])
{
    size_t n = 0;
    for (size_t i = 0; i < media->n_boundaries; ++i) {
        const murk_region_boundary *region_boundary = &media->boundaries[i];
        if (region_boundary->shape != MURK_REGION_BOX &&
            region_boundary->shape != MURK_REGION_BELOW) {
            continue;
        }
        const murk_vec3 a = region_boundary->box.min,
                        b = region_boundary->box.max;
        const double at[6] = {a.x, b.x, a.y, b.y, a.z, b.z};
        for (int k = 0; k < 6; ++k) {
            if (isfinite(at[k])) {
                flat[n++] = flat_of(region_boundary, k / 2, at[k], k % 2 == 1);
            }
        }
    }
    return n;
}

size_t murk_media_indices(const murk_media *media,
                          double index[MURK_REGIONS_MAX + 1])
{
    size_t n = 0;
    index[n++] = 1;
    for (size_t i = 0; i < media->n_boundaries; ++i) {
        index[n++] = media->boundaries[i].ior;
    }
    return n;
}

bool murk_media_bends(const murk_media *media)
{
    return media->n_boundaries > 0;
}

murk_inside murk_media_inside(const murk_media *media, murk_vec3 point)
{
    murk_inside inside = 0;
    for (size_t i = 0; i < media->n_boundaries; ++i) {
        const murk_region_boundary *region_boundary = &media->boundaries[i];
        if (murk_region_boundary_holds(region_boundary, point)) {
            inside |= (murk_inside)1 << region_boundary->region;
        }
    }
    return inside;
}

double murk_media_index(const murk_media *media, murk_inside inside)
{
    for (size_t i = media->n_boundaries; i-- > 0;) {
        if (inside >> media->boundaries[i].region & 1) {
            return media->boundaries[i].ior;
        }
    }
    return 1;
}

bool murk_media_boundary(const murk_media *media, murk_inside inside,
                         murk_vec3 origin, murk_vec3 direction, double max_m,
                         murk_boundary *boundary)
{
    boundary_hit hit[MURK_REGIONS_MAX];
    double nearest = max_m;
    bool any = false;
    if (isnan(origin.x + origin.y + origin.z + direction.x + direction.y +
              direction.z)) {
        return false; /* a NaN hits nothing; no shape needs to handle it */
    }
    /* The nearest boundary. */
    for (size_t i = 0; i < media->n_boundaries; ++i) {
        const murk_region_boundary *region_boundary = &media->boundaries[i];
        const bool is_inside = inside >> region_boundary->region & 1;
        if (!hit_boundary(region_boundary, is_inside, origin, direction,
                          &hit[i])) {
            hit[i].distance = INFINITY;
        } else if (hit[i].distance < nearest) {
            nearest = hit[i].distance;
            any = true;
        }
    }
    if (!any) {
        return false;
    }
    /* Combine all boundaries that lie at most near_m beyond the nearest one,
     * measured along their normals. */
    *boundary = (murk_boundary){.distance_m = nearest};
    for (size_t i = 0; i < media->n_boundaries; ++i) {
        const murk_region_boundary *region_boundary = &media->boundaries[i];
        const double behind = hit[i].distance - nearest;
        if (!(behind < INFINITY)) {
            continue;
        }
        const bool is_inside = inside >> region_boundary->region & 1;
        const murk_vec3 normal =
            facing(&hit[i], is_inside, direction, region_boundary);
        if (behind * fabs(murk_dot(normal, direction)) <= media->near_m) {
            boundary->crossed |= (murk_inside)1 << region_boundary->region;
            boundary->region = region_boundary->region;
            boundary->normal = normal;
            boundary->mean_square_slope = region_boundary->mean_square_slope;
        }
    }
    return true;
}

murk_inside murk_media_wrapped(const murk_media *media, murk_inside inside,
                               murk_vec3 point, int axis)
{
    murk_inside wrapped = inside;
    for (size_t i = 0; i < media->n_boundaries; ++i) {
        const murk_region_boundary *region_boundary = &media->boundaries[i];
        const murk_inside bit = (murk_inside)1 << region_boundary->region;
        if (!region_boundary->spans[axis]) {
            wrapped = murk_region_boundary_holds(region_boundary, point)
                          ? wrapped | bit
                          : wrapped & ~bit;
        }
    }
    return wrapped;
}
