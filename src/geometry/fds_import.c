/* Import of the walls of an FDS run, inside the subprocess: each rectangle
 * becomes two triangles, and each surface of the run a material. */
#include "geometry/import.h"

#include "fds/walls.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sends the arrays of geometry/import.h. */
static murk_status send_walls(murk_subprocess *to, const murk_fds_walls *walls,
                              const murk_fds_run *run, murk_error *err)
{
    const murk_import_head head = {.vertices = 4 * walls->n,
                                   .triangles = 2 * walls->n,
                                   .materials = run->surfaces};
    float *vertex = malloc((12 * walls->n + 1) * sizeof *vertex);
    uint32_t *triangle = malloc((8 * walls->n + 1) * sizeof *triangle);
    murk_status status =
        vertex && triangle ? murk_subprocess_send(to, &head, sizeof head)
                           : murk_no_memory(err, "", "for %zu walls", walls->n);
    /* Corners of rectangles, and the two triangles of each. */
    for (size_t i = 0; i < walls->n && !status; ++i) {
        const murk_fds_wall *wall = &walls->wall[i];
        const uint32_t first = (uint32_t)(4 * i), surface = wall->surface;
        const uint32_t both[8] = {first, first + 1, first + 2, surface,
                                  first, first + 2, first + 3, surface};
        memcpy(&triangle[8 * i], both, sizeof both);
        for (size_t k = 0; k < 12; ++k) {
            vertex[12 * i + k] = (float)wall->corner_m[k / 3][k % 3];
        }
    }
    if (!status) {
        status =
            murk_subprocess_send(to, vertex, 12 * walls->n * sizeof *vertex);
    }
    if (!status) {
        status =
            murk_subprocess_send(to, triangle, 8 * walls->n * sizeof *triangle);
    }
    for (size_t i = 0; i < run->surfaces && !status; ++i) {
        char name[MURK_NAME_SIZE] = {0};
        memcpy(name, run->surface[i],
               strnlen(run->surface[i], MURK_NAME_SIZE - 1));
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
    murk_status status = murk_fds_run_read(&run, request->path, where, err);
    if (!status &&
        !murk_fds_walls_find(&walls, run, request->import.fds_time_s)) {
        status = murk_no_memory(err, where, "for its walls");
    }
    if (!status && (walls.n == 0 || walls.n > UINT32_MAX / 4)) {
        status = murk_fail(err, MURK_BAD_FILE, where,
                           "has %zu walls, must be 1 to %u", walls.n,
                           UINT32_MAX / 4);
    }
    if (!status) {
        status = send_walls(subprocess, &walls, run, err);
    }
    free(walls.wall);
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
