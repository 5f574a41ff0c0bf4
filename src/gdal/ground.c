/* Makes the mesh of the ground (gdal/ground.h): heights of the file, the bend
 * of its lines on the map, the triangles, and the places of their corners. */
#include "gdal/ground.h"

#include "gdal/read.h"
#include "geometry/import.h"
#include "terrain/height_mesh.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Lines of a coarse lattice over the file, on which the map is looked at: it is
 * smooth, so 9 each way show its derivatives. */
#define LATTICE 9

/* The second derivatives between the points of the lattice may be larger than
 * at them, by far less than this factor: a map has no bends as short as an
 * eighth of a file. */
#define RESERVE 2

/* Of the distance between lines of the grid, by which triangles may shift a
 * point: far below the half that would bring it to another triangle. */
#define SHIFT_MAX 0.1

/* A mesh whose middle is further from the origin than this multiple of its
 * extent has an origin of its own, as in geometry/import_shift.h: single
 * precision is that of small coordinates. */
#define FAR 4

typedef struct ground {
    const murk_geotiff_request *request;
    murk_gdal_file *file;
    murk_gdal_window window;
    double *height_m;
    murk_height_bend bend;
    bool is_mirrored; /* columns, rows and up make a left-handed system */
    double middle_m[2], extent_m; /* in the frame */
    murk_height_mesh mesh;
    murk_terrain_facts facts;
} ground;

/* ---- the map ---- */

/* Largest second derivatives, and the first ones, on the lattice at[][][2]. */
static murk_status measure_map(ground *g, double x[LATTICE][LATTICE],
                               double y[LATTICE][LATTICE], murk_error *err)
{
    const double dc = ((double)g->window.columns - 1) / (LATTICE - 1),
                 dr = ((double)g->window.rows - 1) / (LATTICE - 1);
    double smallest = INFINITY, largest = 0;
    int turns = 0;
    murk_height_bend *bend = &g->bend;
    for (int i = 0; i < LATTICE; ++i) {
        for (int k = 0; k < LATTICE; ++k) {
            /* One-sided at the last lines. */
            const int i0 = i < LATTICE - 1 ? i : i - 1,
                      k0 = k < LATTICE - 1 ? k : k - 1;
            const double u[2] = {(x[i][k0 + 1] - x[i][k0]) / dc,
                                 (y[i][k0 + 1] - y[i][k0]) / dc},
                         v[2] = {(x[i0 + 1][k] - x[i0][k]) / dr,
                                 (y[i0 + 1][k] - y[i0][k]) / dr};
            const double area = u[0] * v[1] - u[1] * v[0],
                         sum = hypot(u[0], u[1]) + hypot(v[0], v[1]);
            turns += area > 0 ? 1 : area < 0 ? -1 : 0;
            /* Distance of lines of the grid, diagonals included. */
            smallest = fmin(smallest, fabs(area) / sum);
            largest = fmax(largest, sum / fabs(area));
            if (k > 0 && k < LATTICE - 1) {
                bend->cc_m = fmax(
                    bend->cc_m, hypot(x[i][k + 1] - 2 * x[i][k] + x[i][k - 1],
                                      y[i][k + 1] - 2 * y[i][k] + y[i][k - 1]) /
                                    (dc * dc));
            }
            if (i > 0 && i < LATTICE - 1) {
                bend->rr_m = fmax(
                    bend->rr_m, hypot(x[i + 1][k] - 2 * x[i][k] + x[i - 1][k],
                                      y[i + 1][k] - 2 * y[i][k] + y[i - 1][k]) /
                                    (dr * dr));
            }
            if (i > 0 && k > 0) {
                bend->cr_m =
                    fmax(bend->cr_m, hypot(x[i][k] - x[i - 1][k] - x[i][k - 1] +
                                               x[i - 1][k - 1],
                                           y[i][k] - y[i - 1][k] - y[i][k - 1] +
                                               y[i - 1][k - 1]) /
                                         (dc * dr));
            }
        }
    }
    if (abs(turns) != LATTICE * LATTICE || !(smallest > 0)) {
        return murk_fail(err, MURK_BAD_FILE, g->request->where,
                         "has pixels that lie one above another on the map");
    }
    bend->cc_m *= RESERVE;
    bend->cr_m *= RESERVE;
    bend->rr_m *= RESERVE;
    bend->per_m = largest;
    bend->shift_max_m = SHIFT_MAX * smallest;
    g->is_mirrored = turns < 0;
    return MURK_OK;
}

static murk_status find_map(ground *g, murk_error *err)
{
    double x[LATTICE][LATTICE], y[LATTICE][LATTICE];
    for (int i = 0; i < LATTICE; ++i) {
        for (int k = 0; k < LATTICE; ++k) {
            x[i][k] = (double)g->window.column +
                      ((double)g->window.columns - 1) * k / (LATTICE - 1);
            y[i][k] = (double)g->window.row +
                      ((double)g->window.rows - 1) * i / (LATTICE - 1);
        }
    }
    murk_status status =
        murk_gdal_places(g->file, x[0], y[0], (size_t)LATTICE * LATTICE, err);
    if (!status) {
        g->middle_m[0] = x[LATTICE / 2][LATTICE / 2];
        g->middle_m[1] = y[LATTICE / 2][LATTICE / 2];
        g->extent_m = hypot(x[LATTICE - 1][LATTICE - 1] - x[0][0],
                            y[LATTICE - 1][LATTICE - 1] - y[0][0]);
        status = measure_map(g, x, y, err);
    }
    return status;
}

/* ---- the mesh ---- */

static murk_status make_mesh(ground *g, murk_error *err)
{
    const murk_height_grid grid = {.columns = g->window.columns,
                                   .rows = g->window.rows,
                                   .height_m = g->height_m,
                                   .error_m = g->request->asked.error_m,
                                   .triangles_max = MURK_HEIGHT_TRIANGLES_MAX,
                                   .bend = g->bend};
    if (!murk_height_mesh_make(&g->mesh, &grid)) {
        return murk_no_memory(err, g->request->where,
                              "for a mesh of %zu by %zu heights", grid.columns,
                              grid.rows);
    }
    if (g->mesh.triangles == 0) {
        return murk_fail(err, MURK_BAD_FILE, g->request->where,
                         "has no three heights side by side");
    }
    /* The mesh has ended there. */
    if (g->mesh.triangles > grid.triangles_max) {
        return murk_fail(err, MURK_BAD_VALUE, g->request->where,
                         "needs more than %zu triangles for error_m %g m: "
                         "error_m must be larger, or within_m must cut out a "
                         "part",
                         grid.triangles_max, grid.error_m);
    }
    g->facts.columns = grid.columns;
    g->facts.rows = grid.rows;
    g->facts.error_m = g->mesh.error_m;
    g->facts.bare = g->mesh.bare;
    return MURK_OK;
}

/* The corners of triangles: places[2 vertices] and single precision [3
 * vertices], relative to the origin. */
static murk_status place_vertices(ground *g, double *x, double *y,
                                  float *vertex, murk_vec3 origin,
                                  murk_error *err)
{
    const size_t n = g->mesh.vertices, columns = g->window.columns;
    for (size_t i = 0; i < n; ++i) {
        x[i] = (double)(g->window.column + g->mesh.at[i] % columns);
        y[i] = (double)(g->window.row + g->mesh.at[i] / columns);
    }
    const murk_status status = murk_gdal_places(g->file, x, y, n, err);
    for (size_t i = 0; i < n && !status; ++i) {
        vertex[3 * i] = (float)(x[i] - origin.x);
        vertex[3 * i + 1] = (float)(y[i] - origin.y);
        vertex[3 * i + 2] = (float)g->height_m[g->mesh.at[i]];
    }
    return status;
}

/* Triangles whose corners turn counter-clockwise seen from above. */
static void turn_triangles(const ground *g, uint32_t *triangle)
{
    for (size_t i = 0; i < g->mesh.triangles; ++i) {
        const uint32_t *corner = g->mesh.corner + 3 * i;
        uint32_t *t = triangle + 4 * i;
        t[0] = corner[0];
        t[1] = corner[g->is_mirrored ? 2 : 1];
        t[2] = corner[g->is_mirrored ? 1 : 2];
        t[3] = 0; /* the only material */
    }
}

static murk_status send_mesh(murk_subprocess *to, ground *g, murk_error *err)
{
    /* Without a material of the item, that of the scene. */
    static const char name[MURK_NAME_SIZE] = "default";
    const bool is_far =
        hypot(g->middle_m[0], g->middle_m[1]) > FAR * g->extent_m;
    const murk_import_head head = {
        .vertices = g->mesh.vertices,
        .triangles = g->mesh.triangles,
        .materials = 1,
        .origin_m = is_far ? murk_vec(nearbyint(g->middle_m[0]),
                                      nearbyint(g->middle_m[1]), 0)
                           : murk_vec(0, 0, 0)};
    const size_t n = head.vertices;
    double *place = malloc(2 * n * sizeof *place);
    float *vertex = malloc(3 * n * sizeof *vertex);
    uint32_t *triangle = malloc(4 * head.triangles * sizeof *triangle);
    murk_status status =
        place && vertex && triangle
            ? place_vertices(g, place, place + n, vertex, head.origin_m, err)
            : murk_no_memory(err, g->request->where, "for %zu triangles",
                             (size_t)head.triangles);
    /* Facts, then the parts of a mesh in their order. */
    if (!status) {
        turn_triangles(g, triangle);
        status = murk_subprocess_send(to, &g->facts, sizeof g->facts);
    }
    if (!status) {
        status = murk_subprocess_send(to, &head, sizeof head);
    }
    if (!status) {
        status = murk_subprocess_send(to, vertex, 3 * n * sizeof *vertex);
    }
    if (!status) {
        status = murk_subprocess_send(to, triangle,
                                      4 * head.triangles * sizeof *triangle);
    }
    if (!status) {
        status = murk_subprocess_send(to, name, sizeof name);
    }
    free(place);
    free(vertex);
    free(triangle);
    return status;
}

/* Heights, map and mesh of an open file. */
static murk_status make_ground(murk_subprocess *to, ground *g, murk_error *err)
{
    murk_status status = murk_gdal_window_of(g->file, &g->window, err);
    const size_t n = g->window.columns * g->window.rows;
    if (!status) {
        g->height_m = malloc(n * sizeof *g->height_m);
        status = g->height_m ? find_map(g, err)
                             : murk_no_memory(err, g->request->where,
                                              "for %zu heights", n);
    }
    if (!status) {
        status =
            murk_gdal_heights(g->file, &g->window, g->height_m, &g->facts, err);
    }
    if (!status) {
        status = make_mesh(g, err);
    }
    return status ? status : send_mesh(to, g, err);
}

murk_status murk_gdal_answer(murk_subprocess *to,
                             const murk_geotiff_request *request,
                             murk_error *err)
{
    ground g = {.request = request};
    murk_status status = murk_gdal_open(&g.file, request, err);
    if (!status) {
        status = murk_gdal_facts(g.file, &g.facts, err);
    }
    if (!status && !request->asked.has_frame) {
        status = murk_subprocess_send(to, &g.facts, sizeof g.facts);
    } else if (!status) {
        status = make_ground(to, &g, err);
    }
    murk_gdal_close(g.file);
    murk_height_mesh_release(&g.mesh);
    free(g.height_m);
    return status;
}
