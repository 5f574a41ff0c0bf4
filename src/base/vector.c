/* Clipping of lines by boxes (slab method), and composition and inversion of
 * affine transformations. */
#include "base/vector.h"

/* Clips by one pair of parallel planes. A line parallel to the planes and
 * between them is not cut. */
static bool clip_slab(double min, double max, double origin, double direction,
                      double *t0, double *t1)
{
    if (direction == 0) {
        return origin >= min && origin <= max;
    }
    const double a = (min - origin) / direction;
    const double b = (max - origin) / direction;
    *t0 = fmax(*t0, fmin(a, b));
    *t1 = fmin(*t1, fmax(a, b));
    return *t0 <= *t1;
}

bool murk_box_clip(const murk_box *box, murk_vec3 origin, murk_vec3 direction,
                   double *t0, double *t1)
{
    return clip_slab(box->min.x, box->max.x, origin.x, direction.x, t0, t1) &&
           clip_slab(box->min.y, box->max.y, origin.y, direction.y, t0, t1) &&
           clip_slab(box->min.z, box->max.z, origin.z, direction.z, t0, t1);
}

murk_affine murk_affine_identity(void)
{
    return (murk_affine){.matrix = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

/* Sine and cosine of an angle in degrees, exact at multiples of 90. */
static void turn(double degrees, double *s, double *c)
{
    const double quarters = degrees / 90;
    if (quarters == floor(quarters) && fabs(quarters) < 1e9) {
        const int quadrant = (int)(((long)quarters % 4 + 4) % 4);
        *s = quadrant == 1 ? 1 : quadrant == 3 ? -1 : 0;
        *c = quadrant == 0 ? 1 : quadrant == 2 ? -1 : 0;
        return;
    }
    *s = sin(degrees * MURK_PI / 180);
    *c = cos(degrees * MURK_PI / 180);
}

murk_affine murk_affine_place(murk_vec3 rotate_deg, double scale,
                              murk_vec3 translate_m)
{
    double s, c;
    turn(rotate_deg.x, &s, &c);
    /* Rotations about the axes, applied to column vectors. */
    const murk_affine x = {.matrix = {{1, 0, 0}, {0, c, -s}, {0, s, c}}};
    turn(rotate_deg.y, &s, &c);
    const murk_affine y = {.matrix = {{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
    turn(rotate_deg.z, &s, &c);
    const murk_affine z = {.matrix = {{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};

    const murk_affine yx = murk_affine_compose(&y, &x);
    murk_affine out = murk_affine_compose(&z, &yx);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            out.matrix[i][j] *= scale;
        }
    }
    out.shift = translate_m;
    return out;
}

murk_affine murk_affine_compose(const murk_affine *outer,
                                const murk_affine *inner)
{
    murk_affine out;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            out.matrix[i][j] = outer->matrix[i][0] * inner->matrix[0][j] +
                               outer->matrix[i][1] * inner->matrix[1][j] +
                               outer->matrix[i][2] * inner->matrix[2][j];
        }
    }
    out.shift = murk_affine_point(outer, inner->shift);
    return out;
}

bool murk_affine_invert(const murk_affine *a, murk_affine *out)
{
    const double(*m)[3] = a->matrix;
    const murk_vec3 r0 = {m[0][0], m[0][1], m[0][2]};
    const murk_vec3 r1 = {m[1][0], m[1][1], m[1][2]};
    const murk_vec3 r2 = {m[2][0], m[2][1], m[2][2]};
    const double determinant = murk_dot(r0, murk_cross(r1, r2));
    if (!(fabs(determinant) > 0) || !isfinite(determinant) ||
        !isfinite(1 / determinant)) {
        return false;
    }
    const murk_vec3 c0 = murk_scale(1 / determinant, murk_cross(r1, r2));
    const murk_vec3 c1 = murk_scale(1 / determinant, murk_cross(r2, r0));
    const murk_vec3 c2 = murk_scale(1 / determinant, murk_cross(r0, r1));
    murk_affine inverse = {
        .matrix = {{c0.x, c1.x, c2.x}, {c0.y, c1.y, c2.y}, {c0.z, c1.z, c2.z}}};
    inverse.shift = murk_scale(-1, murk_affine_direction(&inverse, a->shift));
    *out = inverse;
    return true;
}

murk_box murk_affine_box(const murk_affine *a, const murk_box *box)
{
    murk_box out = murk_box_empty();
    for (int corner = 0; corner < 8; ++corner) {
        const murk_vec3 p = {corner & 1 ? box->max.x : box->min.x,
                             corner & 2 ? box->max.y : box->min.y,
                             corner & 4 ? box->max.z : box->min.z};
        out = murk_box_with(out, murk_affine_point(a, p));
    }
    return out;
}
