/* Import of the walls of an FDS run, inside the subprocess: each rectangle
 * becomes two triangles, the triangles of GEOM follow, and each surface of the
 * run is a material. */
#include "geometry/import.h"

#include "fds/geom.h"
#include "fds/walls.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is sent: rectangles, then triangles. */
typedef struct parts {
    const murk_fds_run *run;
    const murk_fds_walls *walls;
    const murk_fds_geom *geom;
} parts;

/* Corners of rectangles and the two triangles of each, then the triangles of
 * the geometry. */
static void fill(const parts *p, float *vertex, uint32_t *triangle)
{
    const size_t walls = p->walls->n;
    for (size_t i = 0; i < walls; ++i) {
        const murk_fds_wall *wall = &p->walls->wall[i];
        const uint32_t first = (uint32_t)(4 * i), surface = wall->surface;
        const uint32_t both[8] = {first, first + 1, first + 2, surface,
                                  first, first + 2, first + 3, surface};
        memcpy(&triangle[8 * i], both, sizeof both);
        for (size_t k = 0; k < 12; ++k) {
            vertex[12 * i + k] = (float)wall->corner_m[k / 3][k % 3];
        }
    }
    const murk_fds_geom *g = p->geom;
    if (g->vertices > 0) { /* a run without GEOM has no arrays */
        memcpy(&vertex[12 * walls], g->vertex,
               3 * g->vertices * sizeof *vertex);
    }
    for (size_t i = 0; i < g->triangles; ++i) {
        uint32_t *to = &triangle[8 * walls + 4 * i];
        for (size_t k = 0; k < 3; ++k) {
            to[k] = (uint32_t)(4 * walls) + g->corner[3 * i + k];
        }
        to[3] = g->surface[i];
    }
}

/* Sends the arrays of geometry/import.h. */
static murk_status send_parts(murk_subprocess *to, const parts *p,
                              murk_error *err)
{
    const murk_import_head head = {
        .vertices = 4 * p->walls->n + p->geom->vertices,
        .triangles = 2 * p->walls->n + p->geom->triangles,
        .materials = p->run->surfaces,
        .names_others = p->run->geom[0] != '\0'};
    /* The head, vertices, triangles, and the names of materials. */
    float *vertex = malloc((3 * head.vertices + 1) * sizeof *vertex);
    uint32_t *triangle = malloc((4 * head.triangles + 1) * sizeof *triangle);
    murk_status status =
        vertex && triangle
            ? murk_subprocess_send(to, &head, sizeof head)
            : murk_no_memory(err, "", "for %zu walls", p->walls->n);
    if (!status) {
        fill(p, vertex, triangle);
        status = murk_subprocess_send(to, vertex,
                                      3 * head.vertices * sizeof *vertex);
    }
    if (!status) {
        status = murk_subprocess_send(to, triangle,
                                      4 * head.triangles * sizeof *triangle);
    }
    for (size_t i = 0; i < p->run->surfaces && !status; ++i) {
        char name[MURK_NAME_SIZE] = {0};
        memcpy(name, p->run->surface[i],
               strnlen(p->run->surface[i], MURK_NAME_SIZE - 1));
        status = murk_subprocess_send(to, name, sizeof name);
    }
    free(vertex);
    free(triangle);
    return status;
}

static murk_status import_walls(murk_subprocess *subprocess, void *context,
                                murk_error *err)
{
    const murk_import_request *request = context;
    char where[sizeof err->where];
    snprintf(where, sizeof where, "%s: %s", request->where, request->path);
    murk_fds_run *run = NULL;
    murk_fds_walls walls = {0};
    murk_fds_geom geom = {0};
    /* The run, its walls on grid lines, and its triangles. */
    murk_status status = murk_fds_run_read(&run, request->path, where, err);
    if (!status &&
        !murk_fds_walls_find(&walls, run, request->import.fds_time_s)) {
        status = murk_no_memory(err, where, "for its walls");
    }
    if (!status) {
        status = murk_fds_geom_read(&geom, run, request->path, where, err);
    }
    if (!status && walls.n + geom.triangles == 0) {
        status = murk_fail(err, MURK_BAD_FILE, where, "has no walls");
    }
    if (!status && walls.n > (UINT32_MAX - geom.vertices) / 4) {
        status = murk_fail(err, MURK_BAD_FILE, where,
                           "has %zu walls, more than %u corners", walls.n,
                           UINT32_MAX);
    }
    if (!status) {
        const parts p = {run, &walls, &geom};
        status = send_parts(subprocess, &p, err);
    }
    free(walls.wall);
    murk_fds_geom_release(&geom);
    murk_fds_run_destroy(run);
    return status;
}

static murk_status work_packed(murk_subprocess *subprocess, murk_parcel *from,
                               murk_error *err)
{
    murk_import_request request = {0};
    const murk_status status = murk_import_unpack(&request, from, err);
    return status ? status : import_walls(subprocess, &request, err);
}

const murk_subprocess_job murk_import_fds_job = {.name = "fds walls",
                                                 .work = import_walls,
                                                 .pack = murk_import_pack,
                                                 .work_packed = work_packed};
