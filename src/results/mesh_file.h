/* Points and triangles with columns of values, as PLY (Blender, MeshLab) and as
 * VTK's poly data (.vtp: ParaView, whose PLY reader drops what faces have, and
 * all that points have but normal and colour). Both are binary, little endian.
 *
 * The columns are one list for both files. A record has the values of one point
 * or triangle: column after column as the list has them, without padding. */
#ifndef MURK_RESULTS_MESH_FILE_H
#define MURK_RESULTS_MESH_FILE_H

#include "results/results.h"
#include "scene/scene.h"

#include <stdio.h>

typedef enum murk_mesh_type {
    MURK_MESH_FLOAT,
    MURK_MESH_UINT8,
    MURK_MESH_UINT16,
    MURK_MESH_UINT32
} murk_mesh_type;

typedef struct murk_mesh_column {
    const char *name; /* of the array in VTK */
    murk_mesh_type type;
    size_t components;        /* 1..3 */
    const char *component[3]; /* names in PLY; NULL: the column's name */
} murk_mesh_column;

/* The color of a point or triangle, 0..255. */
#define MURK_MESH_COLOR              \
    {                                \
        "color", MURK_MESH_UINT8, 3, \
        {                            \
            "red", "green", "blue"   \
        }                            \
    }

/* ---- PLY: header, all vertices, all faces ---- */

typedef struct murk_ply {
    FILE *to;
    const murk_scene_desc *scene;    /* positions: scene/places.h */
    size_t vertex_bytes, face_bytes; /* of records */
} murk_ply;

/* Begins the header. comments: whole lines, or "". */
murk_ply murk_mesh_begin(FILE *to, const murk_scene_desc *scene,
                         const char *comments);

/* Announces n vertices, or n faces of three vertices each. */
void murk_mesh_vertices(murk_ply *ply, size_t n, const murk_mesh_column *column,
                        size_t columns);
void murk_mesh_faces(murk_ply *ply, size_t n, const murk_mesh_column *column,
                     size_t columns);
void murk_mesh_end_header(const murk_ply *ply);

/* position: relative to the local origin. record of a face: NULL if it has no
 * columns. */
void murk_mesh_put_vertex(const murk_ply *ply, murk_vec3 position,
                          const void *record);
void murk_mesh_put_face(const murk_ply *ply, size_t a, size_t b, size_t c,
                        const void *record);

/* ---- both files from one description ---- */

/* Points, and triangles that have three of their own each, in order, or no
 * triangles: then the points are shown by themselves. */
typedef struct murk_mesh_export {
    const char *name;    /* of both files, without .ply and .vtp */
    const char *comment; /* the first of the PLY file: whole lines */
    const murk_scene_desc *scene;
    const char *const *notes; /* more facts: name, text, ..., NULL */
    size_t points;
    bool has_triangles;             /* points / 3 */
    const murk_mesh_column *column; /* [columns] of triangles, or of points */
    size_t columns;       /* vertices of triangles have the first of them */
    const uint8_t *order; /* [columns] of their arrays in the .vtp file */
    murk_vec3 (*position)(const void *context, size_t i); /* of points */
    void (*record)(const void *context, size_t i, void *out);
    const void *context;
} murk_mesh_export;

/* Streams the .vtp file of a murk_mesh_export, as murk_results_add_stream()
 * calls it: nothing is held twice. Fails with MURK_INTERRUPTED. */
murk_status murk_vtp_write(FILE *to, const void *mesh, murk_error *err);

/* Adds NAME.ply and NAME.vtp, the latter also if the former fails; late has the
 * first failure. */
void murk_mesh_add(murk_results *results, const murk_mesh_export *mesh,
                   murk_error *late);

#endif
