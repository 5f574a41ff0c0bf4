/* The simple twin of geometry: every triangle tried in turn, in double, by
 * Moeller and Trumbore, J. Graph. Tools 2 (1997) 21. */
#ifndef MURK_TESTS_PLAIN_RAYS_H
#define MURK_TESTS_PLAIN_RAYS_H

#include "base/vector.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Distance along unit d to one triangle, INFINITY when missed; *edge is the
 * smallest barycentric coordinate, how far inside it is. */
static inline double plain_triangle(murk_vec3 a, murk_vec3 b, murk_vec3 c,
                                    murk_vec3 o, murk_vec3 d, double *edge)
{
    const murk_vec3 e1 = murk_sub(b, a), e2 = murk_sub(c, a);
    const murk_vec3 p = murk_cross(d, e2);
    const double det = murk_dot(e1, p);
    const murk_vec3 s = murk_sub(o, a);
    const murk_vec3 q = murk_cross(s, e1);
    const double u = murk_dot(s, p) / det, v = murk_dot(d, q) / det;
    const double t = murk_dot(e2, q) / det;
    *edge = fmin(fmin(u, v), 1 - u - v);
    return *edge >= 0 && t > 0 ? t : INFINITY;
}

/* The nearest of n triangles; *which is its index, *edge as above. */
static inline double plain_hit(const float *vertex, const uint32_t *corner,
                               size_t n, murk_vec3 o, murk_vec3 d,
                               size_t *which, double *edge)
{
    double nearest = INFINITY;
    for (size_t i = 0; i < n; ++i) {
        murk_vec3 v[3];
        for (int k = 0; k < 3; ++k) {
            const float *f = vertex + 3 * (size_t)corner[3 * i + (size_t)k];
            v[k] = murk_vec((double)f[0], (double)f[1], (double)f[2]);
        }
        double inside;
        const double t = plain_triangle(v[0], v[1], v[2], o, d, &inside);
        if (t < nearest) {
            nearest = t;
            *which = i;
            *edge = inside;
        }
    }
    return nearest;
}

#endif
