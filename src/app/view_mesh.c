#include "app/view_mesh.h"

#include <stdlib.h>
#include <string.h>

#define STEPS_MAX 65535

/* A lattice point as one number, x in the highest bits. */
static uint64_t key_of(const murk_box *box, uint32_t steps, murk_vec3 p)
{
    const double low[3] = {box->min.x, box->min.y, box->min.z};
    const double high[3] = {box->max.x, box->max.y, box->max.z};
    const double at[3] = {p.x, p.y, p.z};
    uint64_t key = 0;
    for (int k = 0; k < 3; ++k) {
        const double size = high[k] - low[k];
        const double share = size > 0 ? (at[k] - low[k]) / size : 0;
        const double step = floor(fmin(fmax(share, 0), 1) * steps + 0.5);
        key = key << 16 | (uint64_t)step;
    }
    return key;
}

static int by_key(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

typedef struct face {
    uint32_t corner[3];
    uint32_t sorted[3];
} face;

static int by_corners(const void *a, const void *b)
{
    return memcmp(((const face *)a)->sorted, ((const face *)b)->sorted,
                  sizeof((const face *)a)->sorted);
}

static uint32_t find(const uint64_t *key, size_t n, uint64_t wanted)
{
    size_t low = 0, high = n;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (key[middle] <= wanted) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return (uint32_t)low;
}

static void sort3(uint32_t v[3])
{
    for (int pass = 0; pass < 2; ++pass) {
        for (int k = 0; k < 2; ++k) {
            if (v[k] > v[k + 1]) {
                const uint32_t swap = v[k];
                v[k] = v[k + 1];
                v[k + 1] = swap;
            }
        }
    }
}

/* What the triangles are on a lattice of so many steps: distinct corners in
 * key[*vertices], distinct triangles with an area in faces[return]. key has
 * room for 3 a triangle, all and faces for 3 and 1. */
static size_t cluster(const murk_surfaces *surfaces, const murk_view_mesh *mesh,
                      uint64_t *all, uint64_t *key, size_t *vertices,
                      face *faces)
{
    const size_t n = mesh->asked;
    for (size_t i = 0; i < n; ++i) {
        murk_vec3 corner[3];
        murk_surfaces_triangle(surfaces, i, corner);
        for (size_t k = 0; k < 3; ++k) {
            all[3 * i + k] = key_of(&mesh->box, mesh->steps, corner[k]);
        }
    }
    memcpy(key, all, 3 * n * sizeof *key);
    qsort(key, 3 * n, sizeof *key, by_key);
    size_t distinct = 0;
    for (size_t i = 0; i < 3 * n; ++i) {
        if (distinct == 0 || key[i] != key[distinct - 1]) {
            key[distinct++] = key[i];
        }
    }
    size_t kept = 0;
    for (size_t i = 0; i < n; ++i) {
        face f;
        for (size_t k = 0; k < 3; ++k) {
            f.corner[k] = find(key, distinct, all[3 * i + k]);
        }
        memcpy(f.sorted, f.corner, sizeof f.sorted);
        sort3(f.sorted);
        if (f.sorted[0] != f.sorted[1] && f.sorted[1] != f.sorted[2]) {
            faces[kept++] = f;
        }
    }
    qsort(faces, kept, sizeof *faces, by_corners);
    size_t once = 0;
    for (size_t i = 0; i < kept; ++i) {
        if (once == 0 || by_corners(&faces[i], &faces[once - 1]) != 0) {
            faces[once++] = faces[i];
        }
    }
    *vertices = distinct;
    return once;
}

/* Only corners that a triangle has; `all` is done with and tells their new
 * numbers. */
static bool take(murk_view_mesh *out, const uint64_t *key, size_t vertices,
                 const face *faces, size_t triangles, uint64_t *all)
{
    out->place = malloc((9 * triangles + 1) * sizeof *out->place);
    out->corner = malloc((3 * triangles + 1) * sizeof *out->corner);
    if (!out->place || !out->corner) {
        return false;
    }
    for (size_t i = 0; i < vertices; ++i) {
        all[i] = UINT64_MAX;
    }
    for (size_t i = 0; i < 3 * triangles; ++i) {
        const uint32_t old = faces[i / 3].corner[i % 3];
        if (all[old] == UINT64_MAX) {
            uint16_t *place = out->place + 3 * out->vertices;
            place[0] = (uint16_t)(key[old] >> 32);
            place[1] = (uint16_t)(key[old] >> 16);
            place[2] = (uint16_t)key[old];
            all[old] = out->vertices++;
        }
        out->corner[i] = (uint32_t)all[old];
    }
    out->triangles = triangles;
    return true;
}

murk_status murk_view_mesh_make(murk_view_mesh *out,
                                const murk_surfaces *surfaces, size_t most,
                                murk_error *err)
{
    const murk_surfaces_facts facts = murk_surfaces_describe(surfaces);
    const size_t n = facts.triangles;
    *out =
        (murk_view_mesh){.box = facts.bounds_m, .steps = STEPS_MAX, .asked = n};
    uint64_t *all = malloc((3 * n + 1) * sizeof *all);
    uint64_t *key = malloc((3 * n + 1) * sizeof *key);
    face *faces = malloc((n + 1) * sizeof *faces);
    bool is_whole = all && key && faces;
    if (is_whole) {
        size_t vertices = 0;
        size_t kept = cluster(surfaces, out, all, key, &vertices, faces);
        /* a surface has about as many lattice points as steps squared; from
         * there on by steps that shrink, until it fits */
        if (kept > most) {
            out->steps = (uint32_t)(2 * sqrt((double)most)) + 2;
        }
        while (kept > most) {
            kept = cluster(surfaces, out, all, key, &vertices, faces);
            if (kept > most) {
                const double share = sqrt((double)most / (double)kept);
                out->steps = (uint32_t)(0.95 * share * out->steps);
                out->steps = out->steps < 1 ? 1 : out->steps;
            }
        }
        is_whole = take(out, key, vertices, faces, kept, all);
    }
    free(all);
    free(key);
    free(faces);
    return is_whole ? MURK_OK
                    : murk_fail(err, MURK_NO_MEMORY, "",
                                "no memory for the view's surfaces");
}

void murk_view_mesh_release(murk_view_mesh *mesh)
{
    free(mesh->place);
    free(mesh->corner);
    *mesh = (murk_view_mesh){0};
}
