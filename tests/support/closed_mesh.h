/* Closed triangle meshes for tests, wound outwards unless told otherwise. Each
 * is the caller's: murk_mesh_destroy(). */
#ifndef MURK_TESTS_CLOSED_MESH_H
#define MURK_TESTS_CLOSED_MESH_H

#include "base/rng.h"
#include "geometry/mesh.h"

#include <stdlib.h>
#include <string.h>

static inline murk_mesh *closed_mesh_empty(size_t vertices, size_t triangles)
{
    murk_mesh *m = calloc(1, sizeof *m);
    m->materials = 1;
    m->vertex_m = malloc(3 * (vertices + 1) * sizeof *m->vertex_m);
    m->corner = malloc(3 * (triangles + 1) * sizeof *m->corner);
    m->material = calloc(triangles + 1, sizeof *m->material);
    m->material_name = calloc(1, sizeof *m->material_name);
    m->bounds_m = murk_box_empty();
    return m;
}

static inline uint32_t closed_mesh_vertex(murk_mesh *m, murk_vec3 p)
{
    float *v = m->vertex_m + 3 * m->vertices;
    v[0] = (float)p.x;
    v[1] = (float)p.y;
    v[2] = (float)p.z;
    m->bounds_m = murk_box_with(
        m->bounds_m, murk_vec((double)v[0], (double)v[1], (double)v[2]));
    return (uint32_t)m->vertices++;
}

static inline void closed_mesh_triangle(murk_mesh *m, uint32_t a, uint32_t b,
                                        uint32_t c)
{
    const uint32_t corner[3] = {a, b, c};
    memcpy(m->corner + 3 * m->triangles++, corner, sizeof corner);
}

/* A prism over a polygon in x and y, counter-clockwise, cut into triangles by
 * `cut` (3 * (n - 2) indices), from z = low to high. */
static inline murk_mesh *closed_prism(const double (*at)[2], size_t n,
                                      const uint32_t *cut, double low,
                                      double high)
{
    murk_mesh *m = closed_mesh_empty(2 * n, 4 * n);
    for (size_t i = 0; i < 2 * n; ++i) {
        closed_mesh_vertex(
            m, murk_vec(at[i % n][0], at[i % n][1], i < n ? low : high));
    }
    const uint32_t up = (uint32_t)n;
    for (size_t i = 0; i < n - 2; ++i) {
        const uint32_t *c = cut + 3 * i;
        closed_mesh_triangle(m, c[0], c[2], c[1]);
        closed_mesh_triangle(m, up + c[0], up + c[1], up + c[2]);
    }
    for (uint32_t i = 0; i < up; ++i) {
        const uint32_t j = (i + 1) % up;
        closed_mesh_triangle(m, i, j, up + j);
        closed_mesh_triangle(m, i, up + j, up + i);
    }
    return m;
}

static inline murk_mesh *closed_box(murk_vec3 min, murk_vec3 max)
{
    const double at[4][2] = {
        {min.x, min.y}, {max.x, min.y}, {max.x, max.y}, {min.x, max.y}};
    const uint32_t cut[6] = {0, 1, 2, 0, 2, 3};
    return closed_prism(at, 4, cut, min.z, max.z);
}

/* An octahedron whose faces are split into rows * rows triangles, every corner
 * then put at radius * (1 + bumps * u) from the middle, u even in (-1, 1): a
 * sphere that the mesh lies within, or a concave star. */
static inline murk_mesh *closed_star(murk_vec3 middle, double radius,
                                     double bumps, size_t rows, uint32_t seed)
{
    static const int sign[8][3] = {{1, 1, 1},    {-1, 1, 1}, {-1, -1, 1},
                                   {1, -1, 1},   {1, 1, -1}, {-1, 1, -1},
                                   {-1, -1, -1}, {1, -1, -1}};
    const size_t across = 2 * rows + 1;
    murk_mesh *m =
        closed_mesh_empty(8 * (rows + 1) * (rows + 2) / 2, 8 * rows * rows);
    for (int face = 0; face < 8; ++face) {
        const int *s = sign[face];
        const bool is_turned = s[0] * s[1] * s[2] < 0;
        uint32_t number[2] = {0, 0}; /* first vertex of this row, the next */
        for (size_t i = 0; i <= rows; ++i) {
            number[1] = (uint32_t)m->vertices;
            for (size_t j = 0; i + j <= rows; ++j) {
                const int x = s[0] * (int)i, y = s[1] * (int)j,
                          z = s[2] * (int)(rows - i - j);
                const uint64_t id = ((uint64_t)(x + (int)rows) * across +
                                     (uint64_t)(y + (int)rows)) *
                                        across +
                                    (uint64_t)(z + (int)rows);
                const double u =
                    2 * murk_random(seed, MURK_TEST, id, 0, 0).u[0] - 1;
                closed_mesh_vertex(m,
                                   murk_along(middle, radius * (1 + bumps * u),
                                              murk_unit(murk_vec(x, y, z))));
            }
            for (size_t j = 0; i > 0 && i + j <= rows; ++j) {
                const uint32_t below = number[0] + (uint32_t)j,
                               here = number[1] + (uint32_t)j;
                closed_mesh_triangle(m, below, is_turned ? below + 1 : here,
                                     is_turned ? here : below + 1);
                if (i + j < rows) {
                    closed_mesh_triangle(m, below + 1,
                                         is_turned ? here + 1 : here,
                                         is_turned ? here : here + 1);
                }
            }
            number[0] = number[1];
        }
    }
    return m;
}

/* Turns the winding of every other triangle or so. */
static inline void closed_mesh_mix_winding(murk_mesh *m, uint32_t seed)
{
    for (size_t i = 0; i < m->triangles; ++i) {
        if (murk_random(seed, MURK_TEST, i, 1, 0).u[0] < 0.5) {
            const uint32_t first = m->corner[3 * i];
            m->corner[3 * i] = m->corner[3 * i + 1];
            m->corner[3 * i + 1] = first;
        }
    }
}

/* Both in one, which takes and releases them. */
static inline murk_mesh *closed_mesh_join(murk_mesh *a, murk_mesh *b)
{
    murk_mesh *m = closed_mesh_empty(a->vertices + b->vertices,
                                     a->triangles + b->triangles);
    murk_mesh *const part[2] = {a, b};
    for (int k = 0; k < 2; ++k) {
        const uint32_t base = (uint32_t)m->vertices;
        for (size_t i = 0; i < part[k]->vertices; ++i) {
            const float *v = part[k]->vertex_m + 3 * i;
            closed_mesh_vertex(
                m, murk_vec((double)v[0], (double)v[1], (double)v[2]));
        }
        for (size_t i = 0; i < part[k]->triangles; ++i) {
            const uint32_t *c = part[k]->corner + 3 * i;
            closed_mesh_triangle(m, base + c[0], base + c[1], base + c[2]);
        }
        murk_mesh_destroy(part[k]);
    }
    return m;
}

#endif
