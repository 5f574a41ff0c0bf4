/* Reads a mesh: checks the request, runs the importer in a subprocess, and
 * checks and unpacks the result.
 *
 * The subprocess parses untrusted input, so nothing it sends is believed:
 * sizes, coordinates and indices are checked again. */
#include "geometry/mesh.h"

#include "base/file.h"
#include "base/memory_files.h"
#include "geometry/import.h"
#include "geometry/triangle.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Checks that the path is a readable regular file that is not empty, and gets
 * the size of the file. */
static murk_status check_file(const char *path, uint64_t *bytes,
                              const char *where, murk_error *err)
{
    struct stat is;
    if (stat(path, &is) != 0 || access(path, R_OK) != 0) {
        return murk_fail(err, MURK_BAD_FILE, where, "cannot read %s: %s", path,
                         strerror(errno));
    }
    if (!S_ISREG(is.st_mode)) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         S_ISDIR(is.st_mode) ? "%s is a folder"
                                             : "%s is not a regular file",
                         path);
    }
    if (is.st_size == 0) {
        return murk_fail(err, MURK_BAD_FILE, where, "%s is empty", path);
    }
    *bytes = (uint64_t)is.st_size;
    return MURK_OK;
}

static murk_status check_import(const murk_mesh_import *import,
                                const char *where, murk_error *err)
{
    if (!(import->unit_m >= 0 && import->unit_m <= 1e9)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "unit_m is %g, must be above 0 and at most 1e9 m",
                         import->unit_m);
    }
    if (import->up != 0 && !strchr("xyz", import->up)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "up is %c, must be x, y or z", import->up);
    }
    struct stat is;
    if (import->allow &&
        !(stat(import->allow, &is) == 0 && S_ISDIR(is.st_mode))) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "allow: %s is no folder that can be looked into",
                         import->allow);
    }
    return MURK_OK;
}

static bool allocate(murk_mesh *mesh, const murk_import_head *head)
{
    mesh->vertices = head->vertices;
    mesh->triangles = head->triangles;
    mesh->materials = head->materials;
    mesh->vertex_m = malloc((3 * mesh->vertices + 1) * sizeof(float));
    mesh->corner = malloc((3 * mesh->triangles + 1) * sizeof(uint32_t));
    mesh->material = malloc((mesh->triangles + 1) * sizeof(uint32_t));
    mesh->material_name =
        malloc((mesh->materials + 1) * sizeof *mesh->material_name);
    return mesh->vertex_m && mesh->corner && mesh->material &&
           mesh->material_name;
}

/* Checks coordinates and indices again: a malformed file may have taken over
 * the subprocess. */
static bool is_sound(const murk_mesh *mesh)
{
    for (size_t i = 0; i < 3 * mesh->vertices; ++i) {
        if (!isfinite(mesh->vertex_m[i])) {
            return false;
        }
    }
    for (size_t i = 0; i < 3 * mesh->triangles; ++i) {
        if (mesh->corner[i] >= mesh->vertices) {
            return false;
        }
    }
    for (size_t i = 0; i < mesh->triangles; ++i) {
        if (mesh->material[i] >= mesh->materials) {
            return false;
        }
    }
    for (size_t i = 0; i < mesh->materials; ++i) {
        mesh->material_name[i][MURK_NAME_SIZE - 1] = '\0';
    }
    return true;
}

static void drop_degenerate(murk_mesh *mesh)
{
    size_t remaining = 0;
    mesh->bounds_m = murk_box_empty();
    for (size_t i = 0; i < mesh->triangles; ++i) {
        /* Keep triangles with an area, and measure the bounding box. */
        const murk_triangle t =
            murk_triangle_at(mesh->vertex_m, mesh->corner + 3 * i);
        if (murk_triangle_is_degenerate(&t)) {
            ++mesh->degenerate;
            continue;
        }
        memmove(mesh->corner + 3 * remaining, mesh->corner + 3 * i,
                3 * sizeof *mesh->corner);
        mesh->material[remaining++] = mesh->material[i];
        mesh->bounds_m = murk_box_with(mesh->bounds_m, t.a);
        mesh->bounds_m = murk_box_with(mesh->bounds_m, t.b);
        mesh->bounds_m = murk_box_with(mesh->bounds_m, t.c);
    }
    mesh->triangles = remaining;
    /* The step of single precision at the largest coordinate. */
    const murk_box *b = &mesh->bounds_m;
    const double farthest = murk_box_largest_coordinate(b);
    mesh->step_m = farthest > 0 ? exp2(floor(log2(farthest))) * FLT_EPSILON : 0;
    mesh->bounds_m = (murk_box){murk_add(b->min, mesh->origin_m),
                                murk_add(b->max, mesh->origin_m)};
}

/* Copies from the received bytes and advances. */
static void take(void *to, size_t size, const unsigned char **bytes)
{
    memcpy(to, *bytes, size);
    *bytes += size;
}

static murk_status unpack(murk_mesh *mesh, const unsigned char *bytes,
                          size_t size, const char *path, const char *where,
                          murk_error *err)
{
    /* The header must agree with the number of bytes received. size / 4
     * bounds each count, so that the products below cannot overflow. */
    murk_import_head head;
    const size_t maximum = size / 4;
    bool fits = size >= sizeof head;
    if (fits) {
        take(&head, sizeof head, &bytes);
        fits = head.vertices <= maximum && head.triangles <= maximum &&
               head.materials <= maximum &&
               size - sizeof head == head.vertices * 3 * sizeof(float) +
                                         head.triangles * 4 * sizeof(uint32_t) +
                                         head.materials * MURK_NAME_SIZE;
    }
    if (!fits) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "%s is malformed: its reader lost count", path);
    }
    /* Copy the arrays and check each value. */
    if (!allocate(mesh, &head)) {
        return murk_no_memory(err, where, "for the %zu triangles of %s",
                              mesh->triangles, path);
    }
    take(mesh->vertex_m, 3 * mesh->vertices * sizeof(float), &bytes);
    for (size_t i = 0; i < mesh->triangles; ++i) {
        take(mesh->corner + 3 * i, 3 * sizeof(uint32_t), &bytes);
        take(mesh->material + i, sizeof(uint32_t), &bytes);
    }
    take(mesh->material_name, mesh->materials * MURK_NAME_SIZE, &bytes);
    mesh->origin_m = head.origin_m;
    mesh->names_others = head.names_others != 0;
    if (!is_sound(mesh) || !murk_is_finite(mesh->origin_m)) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "%s: coordinates or indices out of range", path);
    }
    /* Remove triangles without area. */
    drop_degenerate(mesh);
    if (mesh->triangles == 0) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "%s: none of its %zu triangles has an area", path,
                         mesh->degenerate);
    }
    return MURK_OK;
}

/* Copies a mesh in memory, which the caller of the library gave, and converts
 * it from the unit and the up axis of the request to metres with z up. */
static murk_status read_memory(murk_mesh **out, const char *path,
                               const murk_mesh_import *import,
                               const char *where, murk_error *err)
{
    const murk_memory_file *file = NULL;
    murk_status status = check_import(import, where, err);
    if (!status) {
        status = murk_memory_find(&file, path, MURK_MEMORY_MESH, where, err);
    }
    if (status) {
        return status;
    }
    const murk_mesh *given = file->data;
    const murk_import_head head = {.vertices = given->vertices,
                                   .triangles = given->triangles,
                                   .materials = given->materials};
    murk_mesh *mesh = calloc(1, sizeof *mesh);
    if (!mesh || !allocate(mesh, &head)) {
        murk_mesh_destroy(mesh);
        return murk_no_memory(err, where, "for the %zu triangles of %s",
                              given->triangles, path);
    }
    /* Copy the mesh, turn the up axis to z, and scale to metres. */
    const murk_affine turn = murk_import_up_to_z(import->up ? import->up : 'z'),
                      scale = murk_affine_place(
                          murk_vec(0, 0, 0),
                          import->unit_m > 0 ? import->unit_m : 1,
                          murk_vec(0, 0, 0)),
                      place = murk_affine_compose(&scale, &turn);
    for (size_t i = 0; i < 3 * mesh->vertices; i += 3) {
        const float *v = given->vertex_m + i;
        const murk_vec3 at = murk_affine_point(
            &place, murk_vec((double)v[0], (double)v[1], (double)v[2]));
        mesh->vertex_m[i] = (float)at.x;
        mesh->vertex_m[i + 1] = (float)at.y;
        mesh->vertex_m[i + 2] = (float)at.z;
    }
    memcpy(mesh->corner, given->corner, 3 * mesh->triangles * sizeof(uint32_t));
    memcpy(mesh->material, given->material, mesh->triangles * sizeof(uint32_t));
    memcpy(mesh->material_name, given->material_name,
           mesh->materials * sizeof *mesh->material_name);
    drop_degenerate(mesh);
    if (mesh->triangles == 0) {
        murk_mesh_destroy(mesh);
        return murk_fail(err, MURK_BAD_FILE, where,
                         "%s: none of its triangles has an area", path);
    }
    *out = mesh;
    return MURK_OK;
}

murk_status murk_import_open(murk_mesh **out, const unsigned char *bytes,
                             size_t size, bool is_geotiff, const char *path,
                             const char *where, murk_error *err)
{
    murk_terrain_facts facts = {.columns = 0};
    if (is_geotiff && !murk_terrain_facts_take(&facts, &bytes, &size)) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "%s is malformed: its reader lost count", path);
    }
    murk_mesh *mesh = calloc(1, sizeof *mesh);
    const murk_status status = mesh
                                   ? unpack(mesh, bytes, size, path, where, err)
                                   : murk_no_memory(err, where, "for %s", path);
    if (status) {
        murk_mesh_destroy(mesh);
        return status;
    }
    mesh->terrain = facts;
    *out = mesh;
    return MURK_OK;
}

/* Imports a file in a subprocess, by the program of the format. */
static murk_status import_file(unsigned char **bytes, size_t *size,
                               murk_import_request *request,
                               const murk_subprocess_limits *limits,
                               murk_error *err)
{
    const char *where = request->where;
    if (!request->import.is_geotiff) {
        return murk_subprocess_do(bytes, size,
                                  request->import.is_fds ? &murk_import_fds_job
                                                         : &murk_import_job,
                                  request, limits, where, err);
    }
    char place[sizeof err->where];
    snprintf(place, sizeof place, "%s: %s", where, request->path);
    murk_geotiff_request terrain = {.path = request->path,
                                    .where = place,
                                    .asked = request->import.geotiff};
    return murk_subprocess_do(bytes, size, &murk_geotiff_job, &terrain, limits,
                              place, err);
}

murk_status murk_mesh_read(murk_mesh **out, const char *path,
                           const murk_mesh_import *how, const char *where,
                           murk_error *err)
{
    murk_import_request request = {.path = path, .where = where};
    if (how) {
        request.import = *how;
    }
    uint64_t file_bytes = 0;
    unsigned char *bytes = NULL;
    size_t size = 0;
    if (murk_memory_is(path) && !request.import.is_geotiff) {
        return read_memory(out, path, &request.import, where, err);
    }
    /* Check the request and the file. */
    murk_status status = check_import(&request.import, where, err);
    if (!status) {
        status = check_file(path, &file_bytes, where, err);
    }
    if (!status) {
        /* Import in a subprocess, with limits that follow the size of the
         * file. */
        const murk_subprocess_limits limits =
            request.import.is_geotiff ? murk_geotiff_limits(file_bytes)
                                      : murk_subprocess_limits_for(file_bytes);
        status = import_file(&bytes, &size, &request, &limits, err);
    }
    if (!status) {
        status = murk_import_open(out, bytes, size, request.import.is_geotiff,
                                  path, where, err);
    }
    free(bytes);
    return status;
}

void murk_mesh_checksum(const murk_mesh *mesh, uint64_t out[2])
{
    /* The sum of the sums of all parts. */
    uint64_t sum[5][2];
    murk_checksum(mesh->vertex_m, 3 * mesh->vertices * sizeof *mesh->vertex_m,
                  sum[0]);
    murk_checksum(mesh->corner, 3 * mesh->triangles * sizeof *mesh->corner,
                  sum[1]);
    murk_checksum(mesh->material, mesh->triangles * sizeof *mesh->material,
                  sum[2]);
    murk_checksum(mesh->material_name,
                  mesh->materials * sizeof *mesh->material_name, sum[3]);
    murk_checksum(&mesh->origin_m, sizeof mesh->origin_m, sum[4]);
    murk_checksum(sum, sizeof sum, out);
}

murk_mesh *murk_mesh_share(murk_mesh *mesh)
{
    if (mesh) {
        ++mesh->further_owners;
    }
    return mesh;
}

void murk_mesh_destroy(murk_mesh *mesh)
{
    if (mesh && mesh->further_owners > 0) {
        --mesh->further_owners;
    } else if (mesh) {
        free(mesh->vertex_m);
        free(mesh->corner);
        free(mesh->material);
        free(mesh->material_name);
        free(mesh);
    }
}
