/* Arrays of the caller as files in memory (base/memory_files.h): checks shapes,
 * and the values of meshes and grids, and copies the values into the form of
 * the code that reads them, unless the caller lends the arrays. */
#include "api/handles.h"

#include "base/file.h"
#include "geometry/mesh.h"
#include "medium/grid.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The least volume of a voxel of a grid [m3]: OpenVDB refuses a transform with
 * a smaller determinant (math/Maps.h, AffineMap::updateAcceleration()). */
#define VOXEL_MIN_M3 3e-15

/* The rounding error of a determinant is at most some 10 DBL_EPSILON times the
 * product of the lengths of the columns, so that a smaller determinant cannot
 * be told from 0. */
#define SINGULAR (16 * DBL_EPSILON)

/* Ends a call that adds an array of this name. The name stands in `file` of an
 * error. */
static murk_status end(murk_call *call, const char *name, murk_status status)
{
    if (status) {
        snprintf(call->failure.file, sizeof call->failure.file, "%s", name);
    }
    return murk_call_end(call, status);
}

/* Adds a file to the scene, and takes ownership of `data`, which release(data)
 * releases, also on failure. */
static murk_status add(murk_scene *scene, const char *name,
                       murk_memory_kind kind, void *data,
                       void (*release)(void *data), const uint64_t checksum[2],
                       murk_error *err)
{
    const murk_memory_file file = {.kind = kind,
                                   .data = data,
                                   .release = release,
                                   .checksum = {checksum[0], checksum[1]}};
    return murk_memory_add(&scene->files, name, file, err);
}

/* ---- meshes ---- */

/* A mesh in memory whose vertices and corners may be arrays of the caller. The
 * materials are always a copy. */
typedef struct lent_mesh {
    murk_mesh mesh; /* the first member: the data of the file in memory */
    bool is_lent;   /* vertices and corners are the caller's */
    void (*release)(void *user); /* NULL: not to be called */
    void *user;
} lent_mesh;

/* Frees the mesh, but no array of the caller. */
static void destroy_mesh(lent_mesh *lent)
{
    murk_mesh *mesh = &lent->mesh;
    if (!lent->is_lent) {
        free(mesh->vertex_m);
        free(mesh->corner);
    }
    free(mesh->material);
    free(mesh->material_name);
    free(lent);
}

static void release_mesh(void *data)
{
    lent_mesh *lent = data;
    void (*const release)(void *user) = lent->release;
    void *const user = lent->user;
    destroy_mesh(lent);
    if (release) {
        release(user);
    }
}

/* Copies the coordinates, which must be finite as floats; `to` NULL: only
 * checks. */
static murk_status copy_vertices(float *to, const murk_array *vertices_m,
                                 murk_error *err)
{
    for (size_t i = 0; i < murk_array_count(vertices_m); ++i) {
        const double value = murk_array_number(vertices_m, i);
        if (!(fabs(value) <= (double)FLT_MAX)) {
            return murk_call_bad_argument(
                err, "vertices_m",
                "coordinate %zu of vertex %zu is %g, must be a "
                "finite number",
                i % 3, i / 3, value);
        }
        if (to) {
            to[i] = (float)value;
        }
    }
    return MURK_OK;
}

/* Copies the corners or the materials of triangles, `n` of each triangle: whole
 * numbers from 0 and below `end`; `to` NULL: only checks. */
static murk_status copy_indices(uint32_t *to, const murk_array *from, size_t n,
                                size_t end, const char *name, murk_error *err)
{
    for (size_t i = 0; i < murk_array_count(from); ++i) {
        const double value = murk_array_number(from, i);
        const bool is_whole = value == floor(value);
        if (!(value >= 0 && value < (double)end && is_whole)) {
            char place[64];
            if (n > 1) {
                snprintf(place, sizeof place, "corner %zu", i % n);
            } else {
                snprintf(place, sizeof place, "%s", name);
            }
            return murk_call_bad_argument(
                err, name, "%s of triangle %zu is %.17g, must be %s0 to %zu",
                place, i / n, value, is_whole ? "" : "a whole number, ",
                end - 1);
        }
        if (to) {
            to[i] = (uint32_t)value;
        }
    }
    return MURK_OK;
}

static murk_status copy_names(murk_mesh *mesh, const char *const *names,
                              murk_error *err)
{
    for (size_t i = 0; i < mesh->materials; ++i) {
        const char *name = names ? names[i] : "";
        if (strlen(name) >= MURK_NAME_SIZE) {
            return murk_call_bad_argument(err, "material_names",
                                          "name %zu is longer than %d bytes", i,
                                          MURK_NAME_SIZE - 1);
        }
        snprintf(mesh->material_name[i], MURK_NAME_SIZE, "%s", name);
    }
    return MURK_OK;
}

static murk_status check_mesh(const murk_array *vertices_m,
                              const murk_array *triangles,
                              const murk_array *material, murk_error *err)
{
    murk_status status = murk_array_check(vertices_m, 2, "vertices_m", err);
    status = status ? status : murk_array_check(triangles, 2, "triangles", err);
    if (!status && material) {
        status = murk_array_check(material, 1, "material", err);
    }
    if (status) {
        return status;
    }
    /* Compare the shapes. */
    const murk_array *const lists[] = {vertices_m, triangles};
    static const char *const names[] = {"vertices_m", "triangles"};
    for (int i = 0; i < 2; ++i) {
        if (lists[i]->shape[0] == 0 || lists[i]->shape[1] != 3) {
            return murk_call_bad_argument(
                err, names[i], "is %zu x %zu, must be n x 3 with n above 0",
                lists[i]->shape[0], lists[i]->shape[1]);
        }
    }
    if (material && material->shape[0] != triangles->shape[0]) {
        return murk_call_bad_argument(
            err, "material",
            "has %zu elements, must have %zu, one for each "
            "triangle",
            material->shape[0], triangles->shape[0]);
    }
    return MURK_OK;
}

/* True if the array has this type, and the values of its two dimensions lie one
 * behind the other, in the order of C. */
static bool is_dense(const murk_array *values, murk_type type)
{
    const ptrdiff_t bytes = (ptrdiff_t)murk_type_bytes(type);
    return values->type == type && values->stride[1] == bytes &&
           values->stride[0] == bytes * (ptrdiff_t)values->shape[1];
}

/* Checks the values of all arrays of a mesh and copies the arrays; with `lends`
 * takes the arrays of vertices and triangles as they are. The materials are
 * always copied; material NULL: all triangles have material 0. */
static murk_status fill_mesh(murk_mesh *mesh, const murk_array *vertices_m,
                             const murk_array *triangles,
                             const murk_array *material,
                             const char *const *names, bool lends,
                             murk_error *err)
{
    if (!lends) {
        mesh->vertex_m = calloc(3 * mesh->vertices, sizeof(float));
        mesh->corner = calloc(3 * mesh->triangles, sizeof(uint32_t));
    }
    mesh->material = calloc(mesh->triangles, sizeof(uint32_t));
    mesh->material_name = calloc(mesh->materials, sizeof *mesh->material_name);
    if ((!lends && (!mesh->vertex_m || !mesh->corner)) || !mesh->material ||
        !mesh->material_name) {
        return murk_no_memory(err, "", "for the mesh");
    }
    /* Check and copy; lent arrays are only checked, and taken as they are. */
    murk_status status = copy_vertices(mesh->vertex_m, vertices_m, err);
    if (!status) {
        status = copy_indices(mesh->corner, triangles, 3, mesh->vertices,
                              "triangles", err);
    }
    if (!status && material) {
        status = copy_indices(mesh->material, material, 1, mesh->materials,
                              "material", err);
    }
    if (!status && lends) {
        mesh->vertex_m = (float *)vertices_m->data;
        mesh->corner = (uint32_t *)triangles->data;
    }
    return status ? status : copy_names(mesh, names, err);
}

/* Adds the mesh as a file in memory, and takes ownership of the mesh. The
 * checksum of the file is that of the checksums of all arrays. */
static murk_status add_lent_mesh(murk_scene *scene, const char *name,
                                 lent_mesh *lent, murk_error *err)
{
    const murk_mesh *mesh = &lent->mesh;
    uint64_t sums[4][2], sum[2];
    murk_checksum(mesh->vertex_m, 3 * mesh->vertices * sizeof(float), sums[0]);
    murk_checksum(mesh->corner, 3 * mesh->triangles * sizeof(uint32_t),
                  sums[1]);
    murk_checksum(mesh->material, mesh->triangles * sizeof(uint32_t), sums[2]);
    murk_checksum(mesh->material_name,
                  mesh->materials * sizeof *mesh->material_name, sums[3]);
    murk_checksum(sums, sizeof sums, sum);
    return add(scene, name, MURK_MEMORY_MESH, lent, release_mesh, sum, err);
}

static murk_status
add_mesh(murk_scene *scene, const char *name, const murk_array *vertices_m,
         const murk_array *triangles, const murk_array *material,
         const char *const *names, size_t n_names, void (*release)(void *user),
         void *user, murk_error *err)
{
    murk_status status = check_mesh(vertices_m, triangles, material, err);
    if (!status) {
        status = murk_call_check_texts(err, "material_names", names, n_names);
    }
    if (!status && release &&
        (!is_dense(vertices_m, MURK_TYPE_FLOAT32) ||
         !is_dense(triangles, MURK_TYPE_UINT32))) {
        status = murk_call_bad_argument(
            err, "vertices_m",
            "must be dense float32, and triangles dense uint32, to be used in "
            "place");
    }
    lent_mesh *lent = status ? NULL : calloc(1, sizeof *lent);
    if (!lent) {
        return murk_fail(err, status ? status : MURK_NO_MEMORY, name,
                         "no memory for the mesh");
    }
    murk_mesh *mesh = &lent->mesh;
    mesh->vertices = vertices_m->shape[0];
    mesh->triangles = triangles->shape[0];
    mesh->materials = n_names > 0 ? n_names : 1;
    /* The arrays of a mesh that is refused stay the caller's: lent->release is
     * not set before the mesh is added. */
    lent->is_lent = release != NULL;
    status = fill_mesh(mesh, vertices_m, triangles, material,
                       n_names > 0 ? names : NULL, lent->is_lent, err);
    if (status) {
        destroy_mesh(lent);
        return status;
    }
    status = add_lent_mesh(scene, name, lent, err);
    if (!status && release) { /* from now on the arrays are the scene's */
        lent->release = release;
        lent->user = user;
    }
    return status;
}

murk_status murk_scene_add_mesh(murk_scene *scene, const char *name,
                                const murk_array *vertices_m,
                                const murk_array *triangles,
                                const murk_array *material,
                                const char *const *material_names,
                                size_t n_materials, void (*release)(void *user),
                                void *user, murk_error *error)
{
    if (!scene || !name) {
        return murk_call_refuse(error, "scene or name is NULL");
    }
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    return end(&call, name,
               add_mesh(scene, name, vertices_m, triangles, material,
                        material_names, n_materials, release, user,
                        &call.failure));
}

/* ---- grids ---- */

static void release_grid(void *data)
{
    murk_grid_samples *samples = data;
    if (samples->release) {
        samples->release(samples->user);
    } else {
        free(samples->user);
    }
    free(samples);
}

/* True if the values are floats, and value (i, j, k) is element
 * i + shape[0] (j + shape[1] k) of the data. */
static bool is_x_fastest(const murk_array *values)
{
    const ptrdiff_t bytes = sizeof(float);
    return values->type == MURK_TYPE_FLOAT32 && values->stride[0] == bytes &&
           values->stride[1] == bytes * (ptrdiff_t)values->shape[0] &&
           values->stride[2] ==
               bytes * (ptrdiff_t)(values->shape[0] * values->shape[1]);
}

/* A copy of the values with x fastest; NULL when out of memory. */
static float *copy_values(const murk_array *values)
{
    const size_t *n = values->shape;
    float *copy = malloc((murk_array_count(values) + 1) * sizeof *copy);
    /* Walk a view that has the axes in reverse order. */
    murk_array turned = *values;
    for (int axis = 0; axis < 3; ++axis) {
        turned.shape[axis] = n[2 - axis];
        turned.stride[axis] = values->stride[2 - axis];
    }
    for (size_t i = 0; copy && i < murk_array_count(values); ++i) {
        copy[i] = (float)murk_array_number(&turned, i);
    }
    return copy;
}

static murk_status check_values(const murk_grid_samples *samples,
                                murk_error *err)
{
    const size_t *n = samples->size;
    for (size_t i = 0; i < n[0] * n[1] * n[2]; ++i) {
        if (!(samples->value[i] >= 0 && isfinite(samples->value[i]))) {
            return murk_call_bad_argument(
                err, "values",
                "value [%zu, %zu, %zu] is %g, must be finite and "
                "at least 0",
                i % n[0], i / n[0] % n[1], i / n[0] / n[1],
                (double)samples->value[i]);
        }
    }
    return MURK_OK;
}

/* Fails if the map has a number that is not finite, or cannot be inverted. */
static murk_status check_transform(const murk_affine *index_to_world,
                                   const double rows[12], murk_error *err)
{
    static const char name[] = "index_to_world";
    for (int i = 0; i < 12; ++i) {
        if (!isfinite(rows[i])) {
            return murk_call_bad_argument(
                err, name, "row %d, column %d is %g, must be a finite number",
                i / 4, i % 4, rows[i]);
        }
    }
    /* The columns are the edges of a voxel, which span its volume. */
    const double(*m)[3] = index_to_world->matrix;
    murk_vec3 edge[3];
    for (int i = 0; i < 3; ++i) {
        edge[i] = murk_vec(m[0][i], m[1][i], m[2][i]);
    }
    const double volume = fabs(murk_dot(edge[0], murk_cross(edge[1], edge[2])));
    if (!(volume > SINGULAR * murk_length(edge[0]) * murk_length(edge[1]) *
                       murk_length(edge[2]))) {
        return murk_call_bad_argument(
            err, name,
            "is singular: the edges of a voxel (columns 0 to 2) lie in one "
            "plane, must span a volume");
    }
    if (!(volume >= VOXEL_MIN_M3)) {
        return murk_call_bad_argument(
            err, name, "voxels have a volume of %g m3, must be at least %g m3",
            volume, VOXEL_MIN_M3);
    }
    return MURK_OK;
}

static murk_status add_grid(murk_scene *scene, const char *name,
                            const murk_array *values, const double rows[12],
                            void (*release)(void *user), void *user,
                            murk_error *err)
{
    murk_status status = murk_array_check(values, 3, "values", err);
    if (!status && murk_array_count(values) == 0) {
        status = murk_call_bad_argument(err, "values", "has no values");
    }
    if (!status && !rows) {
        status = murk_call_bad_argument(err, "index_to_world", "is NULL");
    }
    if (!status && release && !is_x_fastest(values)) {
        status = murk_call_bad_argument(
            err, "values",
            "must be dense floats with x fastest to be used in "
            "place");
    }
    if (status) {
        return status;
    }
    murk_grid_samples *samples = calloc(1, sizeof *samples);
    float *copy = release ? NULL : copy_values(values);
    if (!samples || (!release && !copy)) {
        free(samples);
        free(copy);
        return murk_no_memory(err, name, "for the grid");
    }
    memcpy(samples->size, values->shape, sizeof samples->size);
    samples->value = release ? values->data : copy;
    samples->user = copy;
    for (int i = 0; i < 3; ++i) {
        memcpy(samples->index_to_world.matrix[i], rows + 4 * i,
               3 * sizeof *rows);
    }
    samples->index_to_world.shift = murk_vec(rows[3], rows[7], rows[11]);
    status = check_transform(&samples->index_to_world, rows, err);
    status = status ? status : check_values(samples, err);
    if (status) { /* the values stay the caller's */
        free(samples);
        free(copy);
        return status;
    }
    /* The checksum covers the values, the size and index_to_world. */
    uint64_t sums[3][2], sum[2];
    murk_checksum(samples->value, murk_array_count(values) * sizeof(float),
                  sums[0]);
    murk_checksum(samples->size, sizeof samples->size, sums[1]);
    murk_checksum(rows, 12 * sizeof *rows, sums[2]);
    murk_checksum(sums, sizeof sums, sum);
    status =
        add(scene, name, MURK_MEMORY_GRID, samples, release_grid, sum, err);
    if (!status && release) { /* from now on the values are the scene's */
        samples->release = release;
        samples->user = user;
    }
    return status;
}

murk_status murk_scene_add_grid(murk_scene *scene, const char *name,
                                const murk_array *values,
                                const double index_to_world[12],
                                void (*release)(void *user), void *user,
                                murk_error *error)
{
    if (!scene || !name) {
        return murk_call_refuse(error, "scene or name is NULL");
    }
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    return end(&call, name,
               add_grid(scene, name, values, index_to_world, release, user,
                        &call.failure));
}

/* ---- tables ---- */

/* The table as CSV text; NULL when out of memory. */
static char *table_text(const char *const *columns, const murk_array *values)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (!to) {
        return NULL;
    }
    const size_t n = values->shape[1];
    for (size_t k = 0; k < n; ++k) {
        fprintf(to, "%s%s", columns[k], k + 1 < n ? "," : "\n");
    }
    for (size_t i = 0; i < murk_array_count(values); ++i) {
        fprintf(to, "%.17g%s", murk_array_number(values, i),
                (i + 1) % n ? "," : "\n");
    }
    if (fclose(to) != 0) {
        free(text);
        text = NULL;
    }
    return text;
}

static murk_status add_table(murk_scene *scene, const char *name,
                             const char *const *columns,
                             const murk_array *values, murk_error *err)
{
    murk_status status = murk_array_check(values, 2, "values", err);
    if (!status) {
        status =
            murk_call_check_texts(err, "columns", columns, values->shape[1]);
    }
    if (status) {
        return status;
    }
    char *text = table_text(columns, values);
    if (!text) {
        return murk_no_memory(err, name, "for the table");
    }
    uint64_t sum[2];
    murk_checksum(text, strlen(text), sum);
    return add(scene, name, MURK_MEMORY_TABLE, text, free, sum, err);
}

murk_status murk_scene_add_table(murk_scene *scene, const char *name,
                                 const char *const *columns,
                                 const murk_array *values, murk_error *error)
{
    if (!scene || !name) {
        return murk_call_refuse(error, "scene or name is NULL");
    }
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    return end(&call, name,
               add_table(scene, name, columns, values, &call.failure));
}
