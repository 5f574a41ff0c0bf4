/* Vectors, boxes and affine transformations in double precision.
 *
 * z is up; x is east and y is north unless a scene turns north. Lengths are in
 * metres. Directions are unit vectors along the direction of travel. */
#ifndef MURK_BASE_VECTOR_H
#define MURK_BASE_VECTOR_H

#include <math.h>
#include <stdbool.h>

#define MURK_PI 3.14159265358979323846 /* pi to 21 digits */

typedef struct murk_vec3 {
    double x, y, z;
} murk_vec3;

static inline murk_vec3 murk_vec(double x, double y, double z)
{
    return (murk_vec3){x, y, z};
}

static inline murk_vec3 murk_add(murk_vec3 a, murk_vec3 b)
{
    return (murk_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline murk_vec3 murk_sub(murk_vec3 a, murk_vec3 b)
{
    return (murk_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline murk_vec3 murk_scale(double s, murk_vec3 a)
{
    return (murk_vec3){s * a.x, s * a.y, s * a.z};
}

/* a + s b. If b is a unit vector: the point at the distance s from a in the
 * direction of b, behind a if s is negative. */
static inline murk_vec3 murk_along(murk_vec3 a, double s, murk_vec3 b)
{
    return (murk_vec3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline double murk_dot(murk_vec3 a, murk_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline murk_vec3 murk_cross(murk_vec3 a, murk_vec3 b)
{
    return (murk_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                       a.x * b.y - a.y * b.x};
}

static inline double murk_length(murk_vec3 a)
{
    return sqrt(murk_dot(a, a));
}

/* a / |a|; the zero vector gives NaN. */
static inline murk_vec3 murk_unit(murk_vec3 a)
{
    return murk_scale(1 / murk_length(a), a);
}

/* A coordinate by axis: 0 x, 1 y, 2 z. */
static inline double murk_component(murk_vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static inline void murk_component_set(murk_vec3 *v, int axis, double value)
{
    *(axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z) = value;
}

static inline bool murk_is_finite(murk_vec3 a)
{
    return isfinite(a.x) && isfinite(a.y) && isfinite(a.z);
}

/* Two unit vectors that form a right-handed orthonormal frame with the unit
 * vector n: *t x *b = n. The frame is continuous except where n.z changes sign
 * (Duff et al., J. Comput. Graph. Tech. 6 (2017) 1). */
static inline void murk_frame(murk_vec3 n, murk_vec3 *t, murk_vec3 *b)
{
    const double sign = copysign(1.0, n.z);
    const double p = -1 / (sign + n.z);
    const double q = n.x * n.y * p;
    *t = (murk_vec3){1 + sign * n.x * n.x * p, sign * q, -sign * n.x};
    *b = (murk_vec3){q, sign + n.y * n.y * p, -n.y};
}

/* The unit vector at polar cosine mu and azimuth phi [rad] around the unit
 * vector n. */
static inline murk_vec3 murk_about(murk_vec3 n, double mu, double phi)
{
    murk_vec3 t, b;
    murk_frame(n, &t, &b);
    const double s = sqrt(fmax(0, 1 - mu * mu));
    const murk_vec3 side =
        murk_along(murk_scale(s * cos(phi), t), s * sin(phi), b);
    return murk_unit(murk_along(side, mu, n));
}

/* An axis-aligned box. */
typedef struct murk_box {
    murk_vec3 min, max;
} murk_box;

static inline murk_box murk_box_empty(void)
{
    return (murk_box){{INFINITY, INFINITY, INFINITY},
                      {-INFINITY, -INFINITY, -INFINITY}};
}

static inline murk_box murk_box_with(murk_box box, murk_vec3 p)
{
    return (murk_box){
        {fmin(box.min.x, p.x), fmin(box.min.y, p.y), fmin(box.min.z, p.z)},
        {fmax(box.max.x, p.x), fmax(box.max.y, p.y), fmax(box.max.z, p.z)}};
}

/* The bounding box of a ball. */
static inline murk_box murk_box_of_ball(murk_vec3 center, double radius)
{
    const murk_vec3 r = {radius, radius, radius};
    return (murk_box){murk_sub(center, r), murk_add(center, r)};
}

/* The bounding box of a parallelogram. */
static inline murk_box
murk_box_of_parallelogram(murk_vec3 corner, murk_vec3 edge1, murk_vec3 edge2)
{
    const murk_vec3 a = murk_add(corner, edge1);
    murk_box box = murk_box_with(murk_box_empty(), corner);
    box = murk_box_with(box, a);
    box = murk_box_with(box, murk_add(corner, edge2));
    return murk_box_with(box, murk_add(a, edge2));
}

/* True if two boxes have a point in common, at least on their faces. */
static inline bool murk_box_overlaps(const murk_box *a, const murk_box *b)
{
    return a->min.x <= b->max.x && b->min.x <= a->max.x &&
           a->min.y <= b->max.y && b->min.y <= a->max.y &&
           a->min.z <= b->max.z && b->min.z <= a->max.z;
}

/* The part that two boxes have in common; min exceeds max on some axis if there
 * is none. */
static inline murk_box murk_box_meet(murk_box a, murk_box b)
{
    return (murk_box){{fmax(a.min.x, b.min.x), fmax(a.min.y, b.min.y),
                       fmax(a.min.z, b.min.z)},
                      {fmin(a.max.x, b.max.x), fmin(a.max.y, b.max.y),
                       fmin(a.max.z, b.max.z)}};
}

/* True if p is inside the box or on a face of it. */
static inline bool murk_box_contains(const murk_box *box, murk_vec3 p)
{
    return p.x >= box->min.x && p.x <= box->max.x && p.y >= box->min.y &&
           p.y <= box->max.y && p.z >= box->min.z && p.z <= box->max.z;
}

/* True if min <= p < max on each axis: the upper faces belong to the
 * neighbours, so that boxes that share a face never count a point twice. */
static inline bool murk_box_holds(const murk_box *box, murk_vec3 p)
{
    return p.x >= box->min.x && p.x < box->max.x && p.y >= box->min.y &&
           p.y < box->max.y && p.z >= box->min.z && p.z < box->max.z;
}

/* The distance of a point from a box; 0 inside. */
static inline double murk_box_distance(const murk_box *box, murk_vec3 p)
{
    const murk_vec3 off = {fmax(fmax(box->min.x - p.x, p.x - box->max.x), 0),
                           fmax(fmax(box->min.y - p.y, p.y - box->max.y), 0),
                           fmax(fmax(box->min.z - p.z, p.z - box->max.z), 0)};
    return murk_length(off);
}

/* The largest magnitude of a coordinate of the corners of the box [m]. */
static inline double murk_box_largest_coordinate(const murk_box *box)
{
    const murk_vec3 a = box->min, b = box->max;
    return fmax(fmax(fmax(fabs(a.x), fabs(a.y)), fabs(a.z)),
                fmax(fmax(fabs(b.x), fabs(b.y)), fabs(b.z)));
}

/* Cuts the interval [*t0, *t1] of the line origin + t direction to the part
 * inside the box. Returns false if nothing is left; *t0 and *t1 then have no
 * meaning. The direction may have any length, and components of it may be 0. */
bool murk_box_clip(const murk_box *box, murk_vec3 origin, murk_vec3 direction,
                   double *t0, double *t1);

/* The box of the world (scene key `domain`). A photon that reaches a face
 * leaves the world. In a periodic domain this holds for the faces in z only: a
 * photon that leaves through a face in x or y comes in again through the
 * opposite face. */
typedef struct murk_domain {
    murk_box box;
    bool is_periodic;
} murk_domain;

/* The number of images of a point: the point and its 8 neighbours in x and y if
 * the domain is periodic, else the point alone. */
static inline int murk_domain_images(const murk_domain *domain)
{
    return domain->is_periodic ? 9 : 1;
}

/* Image k of a point; in a periodic domain image 4 is the point itself. */
static inline murk_vec3 murk_domain_image(const murk_domain *domain,
                                          murk_vec3 p, int k)
{
    const murk_vec3 a = domain->box.min, b = domain->box.max;
    return domain->is_periodic ? murk_vec(p.x + (k % 3 - 1) * (b.x - a.x),
                                          p.y + (k / 3 - 1) * (b.y - a.y), p.z)
                               : p;
}

/* The map x -> matrix x + shift; matrix[row][column]. */
typedef struct murk_affine {
    double matrix[3][3];
    murk_vec3 shift;
} murk_affine;

murk_affine murk_affine_identity(void);

/* The transformation of the scene file: rotate about x, then y, then z
 * [degrees, right-handed], then scale, then translate [m]. */
murk_affine murk_affine_place(murk_vec3 rotate_deg, double scale,
                              murk_vec3 translate_m);

/* The map that applies `inner`, then `outer`. */
murk_affine murk_affine_compose(const murk_affine *outer,
                                const murk_affine *inner);

/* The inverse map. Returns false and leaves *out unchanged if the determinant
 * is 0, infinite or NaN, or so small that the reciprocal overflows. */
bool murk_affine_invert(const murk_affine *a, murk_affine *out);

static inline murk_vec3 murk_affine_direction(const murk_affine *a, murk_vec3 d)
{
    const double(*m)[3] = a->matrix;
    return (murk_vec3){m[0][0] * d.x + m[0][1] * d.y + m[0][2] * d.z,
                       m[1][0] * d.x + m[1][1] * d.y + m[1][2] * d.z,
                       m[2][0] * d.x + m[2][1] * d.y + m[2][2] * d.z};
}

static inline murk_vec3 murk_affine_point(const murk_affine *a, murk_vec3 p)
{
    return murk_add(murk_affine_direction(a, p), a->shift);
}

/* The bounding box of the images of the eight corners of a box. */
murk_box murk_affine_box(const murk_affine *a, const murk_box *box);

#endif
