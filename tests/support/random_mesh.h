/* Meshes of random triangles from addressed random numbers, for tests that
 * compare a routine with its simple version. */
#ifndef MURK_TESTS_RANDOM_MESH_H
#define MURK_TESTS_RANDOM_MESH_H

#include "base/rng.h"
#include "geometry/mesh.h"

#include <stdlib.h>

/* A point of the box [-1, 1]^3. */
static inline murk_vec3 random_point(uint32_t seed, uint64_t i)
{
    const murk_random4 r = murk_random(seed, MURK_TEST, i, 0, 0);
    return murk_vec(2 * r.u[0] - 1, 2 * r.u[1] - 1, 2 * r.u[2] - 1);
}

static inline murk_vec3 random_direction(uint32_t seed, uint64_t i)
{
    const murk_random4 r = murk_random(seed, MURK_TEST, i, 1, 0);
    return murk_about(murk_vec(0, 0, 1), 2 * r.u[0] - 1, 2 * MURK_PI * r.u[1]);
}

/* n triangles of about `size` in the box [-1, 1]^3, none sharing a vertex, of
 * one material named "soup". murk_mesh_destroy() releases it. */
static inline murk_mesh *random_mesh(size_t n, double size, uint32_t seed)
{
    murk_mesh *m = calloc(1, sizeof *m);
    m->vertices = 3 * n;
    m->triangles = n;
    m->materials = 1;
    m->vertex_m = malloc(9 * n * sizeof *m->vertex_m);
    m->corner = malloc(3 * n * sizeof *m->corner);
    m->material = calloc(n, sizeof *m->material);
    m->material_name = calloc(1, sizeof *m->material_name);
    m->material_name[0][0] = 's';
    for (size_t i = 0; i < 3 * n; ++i) {
        const murk_vec3 middle = random_point(seed, i / 3);
        const murk_vec3 v = murk_along(middle, size, random_point(seed + 1, i));
        m->vertex_m[3 * i] = (float)v.x;
        m->vertex_m[3 * i + 1] = (float)v.y;
        m->vertex_m[3 * i + 2] = (float)v.z;
        m->corner[i] = (uint32_t)i;
    }
    return m;
}

#endif
