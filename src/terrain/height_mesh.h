/* A mesh of triangles over a grid of heights, with no more triangles than a
 * stated error of height needs: a right-triangulated irregular network. The
 * corners are points of the grid.
 *
 * The triangles are those of a binary hierarchy: a square is divided into two
 * triangles, and a triangle at the middle of its longest edge. A triangle stays
 * whole if the height of none of the points that it covers, its edges
 * included, is off by more than the error, and if none of the triangles that
 * share an edge with it requires it to be divided. So the mesh has no gaps, and
 * its largest error is known, whatever the heights.
 *
 * A grid need not have 2^k + 1 points: the hierarchy ends at the border of the
 * grid, where its points beyond are moved onto the border.
 *
 * Source: Evans, Kirkpatrick and Townsend, Algorithmica 30 (2001) 264,
 * doi:10.1007/s00453-001-0006-x. Differs from it in the error, which is that of
 * all points of a triangle and not that of the middles of edges. */
#ifndef MURK_TERRAIN_HEIGHT_MESH_H
#define MURK_TERRAIN_HEIGHT_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Points of a grid; a choice: 2^24 points, 4096 by 4096, take 8 s on one of two
 * shared processors if they are all of one height, and 0.3 GB of memory while
 * the mesh is made. */
#define MURK_HEIGHTS_MAX ((size_t)1 << 24)

/* Triangles of the ground; a choice: 2^22 take 9 s of processor time, of two
 * shared processors, from the file to surfaces that light can meet. */
#define MURK_HEIGHT_TRIANGLES_MAX ((size_t)1 << 22)

/* The grid is a map of the ground, on which its columns and rows are curves.
 * So the place of a point is not exactly where it would be in a flat triangle
 * of the grid: the difference is at most (dcc C^2 + 2 dcr C R + drr R^2) / 6
 * for triangles of C columns and R rows, with the largest second derivatives of
 * places by column and row. */
typedef struct murk_height_bend {
    double cc_m, cr_m, rr_m; /* dcc, dcr, drr; all 0: straight lines */
    double per_m;       /* largest factor from a slope by column and row to a
                         * slope in the map [1/m] */
    double shift_max_m; /* largest difference that a triangle may have */
} murk_height_bend;

typedef struct murk_height_grid {
    size_t columns, rows;   /* at least 2 */
    const double *height_m; /* [rows][columns]; NAN: not known */
    double error_m;         /* largest error of the mesh, 0 or more */
    size_t triangles_max;   /* a mesh of more ends with the next triangle */
    murk_height_bend bend;
} murk_height_grid;

typedef struct murk_height_mesh {
    size_t vertices, triangles;
    uint32_t *at;     /* [vertices] row * columns + column of the grid */
    uint32_t *corner; /* [triangles][3] indices of vertices; from x to y of the
                       * grid's columns and rows */
    double error_m;   /* the largest error of any point, with the heights of
                       * corners in single precision, as meshes have them */
    size_t known;     /* points of the grid with a height */
    size_t bare;      /* of these, in no triangle: all their triangles have a
                       * corner without a height */
} murk_height_mesh;

/* Makes the mesh. Squares with a point that has no height have a triangle less,
 * or none. False if there is no memory; then *out has nothing. The caller
 * frees the arrays with murk_height_mesh_release(). */
bool murk_height_mesh_make(murk_height_mesh *out, const murk_height_grid *grid);
void murk_height_mesh_release(murk_height_mesh *mesh);

#endif
