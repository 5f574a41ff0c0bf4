/* Joins corners of triangles on lattices that become coarser until there are
 * few enough triangles: vertex clustering (Rossignac, Borrel, in Modeling in
 * Computer Graphics (1993) 455, doi:10.1007/978-3-642-78114-8_29). */
#include "report/view_mesh.h"

#include "base/sort.h"

#include <stdlib.h>
#include <string.h>

/* A lattice of cubic cells in a box. The size of the box is also used to
 * convert places to steps, of which each side of the box has the same number.
 */
typedef struct lattice {
    double low[3], size[3];
    double cell_m;
} lattice;

static lattice lattice_of(const murk_box *box, uint32_t cells)
{
    const murk_vec3 size = murk_sub(box->max, box->min);
    const double longest = fmax(fmax(size.x, size.y), size.z);
    return (lattice){{box->min.x, box->min.y, box->min.z},
                     {size.x, size.y, size.z},
                     longest / cells};
}

static double within(double value, double maximum)
{
    return floor(fmin(fmax(value, 0), maximum) + 0.5);
}

/* The cell of a place as one number, with x in the highest bits. */
static uint64_t key_of(const lattice *l, murk_vec3 p)
{
    const double at[3] = {p.x, p.y, p.z};
    uint64_t key = 0;
    for (int k = 0; k < 3; ++k) {
        const double cells =
            l->cell_m > 0 ? (at[k] - l->low[k]) / l->cell_m : 0;
        key = key << 16 | (uint64_t)within(cells, MURK_VIEW_STEPS);
    }
    return key;
}

static uint64_t step_of(const lattice *l, murk_vec3 p, int axis)
{
    const double at[3] = {p.x, p.y, p.z};
    const double share =
        l->size[axis] > 0 ? (at[axis] - l->low[axis]) / l->size[axis] : 0;
    return (uint64_t)within(share * MURK_VIEW_STEPS, MURK_VIEW_STEPS);
}

typedef struct face {
    uint32_t corner[3];
    uint32_t sorted[3];
    size_t triangle; /* that it is made of */
} face;

static int by_corners(const void *a, const void *b)
{
    return memcmp(((const face *)a)->sorted, ((const face *)b)->sorted,
                  sizeof((const face *)a)->sorted);
}

static void order(uint32_t v[2])
{
    if (v[0] > v[1]) {
        const uint32_t swap = v[0];
        v[0] = v[1];
        v[1] = swap;
    }
}

/* Joins corners on a lattice. Fills key[] with the distinct cells of corners,
 * sorted, and faces[] with the distinct triangles that keep three corners, as
 * indices into key[]. Returns the number of these triangles. all[3 * n] and
 * key[3 * n] are workspaces; faces[n]. */
static size_t cluster(const murk_surfaces *surfaces, size_t n, const lattice *l,
                      uint64_t *all, uint64_t *key, face *faces)
{
    for (size_t i = 0; i < n; ++i) {
        murk_vec3 corner[3];
        murk_surfaces_triangle(surfaces, i, corner);
        for (size_t k = 0; k < 3; ++k) {
            all[3 * i + k] = key_of(l, corner[k]);
        }
    }
    /* distinct cells, sorted: the joined corners */
    memcpy(key, all, 3 * n * sizeof *key);
    qsort(key, 3 * n, sizeof *key, murk_by_uint64);
    size_t distinct = 0;
    for (size_t i = 0; i < 3 * n; ++i) {
        if (distinct == 0 || key[i] != key[distinct - 1]) {
            key[distinct++] = key[i];
        }
    }
    /* triangles that keep three different corners, each of them once */
    size_t remaining = 0;
    for (size_t i = 0; i < n; ++i) {
        face f = {.triangle = i};
        for (size_t k = 0; k < 3; ++k) {
            const uint64_t *at = bsearch(&all[3 * i + k], key, distinct,
                                         sizeof *key, murk_by_uint64);
            f.corner[k] = (uint32_t)(at - key);
        }
        memcpy(f.sorted, f.corner, sizeof f.sorted);
        order(f.sorted);
        order(f.sorted + 1);
        order(f.sorted);
        if (f.sorted[0] != f.sorted[1] && f.sorted[1] != f.sorted[2]) {
            faces[remaining++] = f;
        }
    }
    qsort(faces, remaining, sizeof *faces, by_corners);
    size_t once = 0;
    for (size_t i = 0; i < remaining; ++i) {
        if (once == 0 || by_corners(&faces[i], &faces[once - 1]) != 0) {
            faces[once++] = faces[i];
        }
    }
    return once;
}

/* Fills the mesh: vertices that a face uses, each at the mean of the corners
 * that were joined, and the faces. number[] is a workspace by corner. False
 * when out of memory. */
static bool take(murk_view_mesh *out, const murk_surfaces *surfaces,
                 const face *faces, size_t triangles, uint64_t *number)
{
    const lattice l = lattice_of(&out->box, 1);
    uint64_t(*sum)[4] = calloc(3 * triangles + 1, sizeof *sum);
    out->place = malloc((9 * triangles + 1) * sizeof *out->place);
    out->corner = malloc((3 * triangles + 1) * sizeof *out->corner);
    const bool is_whole = sum && out->place && out->corner;
    /* vertices are numbered as they occur; sums of places give their means */
    for (size_t i = 0; is_whole && i < 3 * triangles; ++i) {
        number[faces[i / 3].corner[i % 3]] = UINT64_MAX;
    }
    for (size_t i = 0; is_whole && i < 3 * triangles; ++i) {
        murk_vec3 place[3];
        uint64_t *vertex = &number[faces[i / 3].corner[i % 3]];
        murk_surfaces_triangle(surfaces, faces[i / 3].triangle, place);
        if (*vertex == UINT64_MAX) {
            *vertex = out->vertices++;
        }
        for (int k = 0; k < 3; ++k) {
            sum[*vertex][k] += step_of(&l, place[i % 3], k);
        }
        ++sum[*vertex][3];
        out->corner[i] = (uint32_t)*vertex;
    }
    for (size_t i = 0; is_whole && i < 3 * out->vertices; ++i) {
        const uint64_t *of = sum[i / 3];
        out->place[i] = (uint16_t)((of[i % 3] + of[3] / 2) / of[3]);
    }
    out->triangles = is_whole ? triangles : 0;
    free(sum);
    return is_whole;
}

murk_status murk_view_mesh_make(murk_view_mesh *out,
                                const murk_surfaces *surfaces, size_t maximum,
                                murk_error *err)
{
    const murk_surfaces_facts facts = murk_surfaces_describe(surfaces);
    const size_t n = facts.triangles;
    *out = (murk_view_mesh){.box = facts.bounds_m, .asked = n};
    uint64_t *all = malloc((3 * n + 1) * sizeof *all);
    uint64_t *key = malloc((3 * n + 1) * sizeof *key);
    face *faces = malloc((n + 1) * sizeof *faces);
    bool is_whole = all && key && faces;
    if (is_whole && n > 0) {
        uint32_t cells = MURK_VIEW_STEPS;
        lattice l = lattice_of(&out->box, cells);
        size_t triangles = cluster(surfaces, n, &l, all, key, faces);
        out->is_coarse = triangles > maximum;
        /* A surface crosses about n^2 of the cells of a lattice with n cells
         * along a side. The search begins at n = 2 sqrt(maximum) + 2, so with
         * about four times as many crossed cells as triangles are allowed, and
         * n shrinks until there are few enough triangles. */
        cells =
            out->is_coarse ? (uint32_t)(2 * sqrt((double)maximum)) + 2 : cells;
        while (triangles > maximum) {
            l = lattice_of(&out->box, cells);
            triangles = cluster(surfaces, n, &l, all, key, faces);
            const double share =
                sqrt((double)maximum / (double)(triangles + 1));
            cells = (uint32_t)fmax(1, 0.95 * share * cells);
        }
        is_whole = take(out, surfaces, faces, triangles, all);
    }
    free(all);
    free(key);
    free(faces);
    return is_whole ? MURK_OK
                    : murk_no_memory(err, "", "for the view's surfaces");
}

void murk_view_mesh_release(murk_view_mesh *mesh)
{
    free(mesh->place);
    free(mesh->corner);
    *mesh = (murk_view_mesh){0};
}
