/* Points and triangles with columns of values, as PLY (for Blender and MeshLab)
 * and as VTK's poly data (.vtp, for ParaView, whose PLY reader drops the values
 * of faces, and those of points except normal and colour). Both are binary,
 * little endian. Both files have the same columns. A record has the values of
 * one point or triangle: column after column in the order of the list, without
 * padding. */
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
    const char *name; /* of the array in VTK, and of the property in PLY if it
                         has one component */
    murk_mesh_type type;
    size_t components;        /* 1..3 */
    const char *component[3]; /* names of the properties in PLY; NULL: `name` */
} murk_mesh_column;

/* The column of colours: red, green and blue, 0..255. */
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
    const murk_scene_desc *scene;    /* its origin decides how positions are
                                        written */
    size_t vertex_bytes, face_bytes; /* of a record of a vertex, of a face */
} murk_ply;

/* Writes the beginning of the header. comments: lines that begin with "comment
 * " and end with a line feed, or "". */
murk_ply murk_mesh_begin(FILE *to, const murk_scene_desc *scene,
                         const char *comments);

/* Write to the header that there are n vertices, or n faces of three vertices
 * each, with these columns; vertices also have their position. Vertices come
 * first. */
void murk_mesh_vertices(murk_ply *ply, size_t n, const murk_mesh_column *column,
                        size_t columns);
void murk_mesh_faces(murk_ply *ply, size_t n, const murk_mesh_column *column,
                     size_t columns);
void murk_mesh_end_header(const murk_ply *ply);

/* Write a vertex or a face, with as many bytes of the record as the columns
 * take. position: in the coordinates of the program, relative to the local
 * origin. The record of a face is NULL if faces have no columns. Failures show
 * when the file is committed. */
void murk_mesh_put_vertex(const murk_ply *ply, murk_vec3 position,
                          const void *record);
void murk_mesh_put_face(const murk_ply *ply, size_t a, size_t b, size_t c,
                        const void *record);

/* ---- both files from one description ---- */

/* Points, or triangles of three points each, which are points 3 i, 3 i + 1 and
 * 3 i + 2 and belong to no other triangle. */
typedef struct murk_mesh_export {
    const char *name;    /* of both files, without the endings .ply and .vtp */
    const char *comment; /* first comments of the PLY file, as for
                            murk_mesh_begin() */
    const murk_scene_desc *scene;
    const char *const *notes; /* further facts for both files: name, text, name,
                                 text, ..., NULL */
    size_t points;
    bool has_triangles;             /* points / 3 of them */
    const murk_mesh_column *column; /* [columns]; of triangles if there are any,
                                       else of points */
    size_t columns;       /* in the PLY file, vertices of triangles have the
                             first column, too */
    const uint8_t *order; /* [columns]; numbers of the columns in the order of
                             the .vtp file; the first is what ParaView shows by
                             default */
    murk_vec3 (*position)(const void *context, size_t i); /* of point i */
    /* Writes to `out` the record of triangle i, or of point i if there are no
     * triangles. */
    void (*record)(const void *context, size_t i, void *out);
    const void *context;
} murk_mesh_export;

/* Writes the .vtp file; `mesh` points to a murk_mesh_export. Values are
 * computed as they are written, so memory does not grow with their number. The
 * function can serve as a murk_results_stream (results/results.h). Fails with
 * MURK_INTERRUPTED. */
murk_status murk_vtp_write(FILE *to, const void *mesh, murk_error *err);

/* Adds NAME.ply and NAME.vtp, the latter also if the former fails. *late has
 * the first failure. */
void murk_mesh_add(murk_results *results, const murk_mesh_export *mesh,
                   murk_error *late);

#endif
