/* Triangle meshes from files of any format that Assimp reads (OBJ, PLY, STL,
 * glTF, Collada, FBX, IFC, ...).
 *
 * The file is parsed in a child process with limits (base/subprocess.h),
 * checked (finite coordinates, indices in range), and handed over as plain
 * arrays in metres with z up. Call before any thread or ray device exists. */
#ifndef MURK_GEOMETRY_MESH_H
#define MURK_GEOMETRY_MESH_H

#include "base/status.h"
#include "base/vector.h"

#include <stddef.h>
#include <stdint.h>

#define MURK_NAME_SIZE 64 /* of materials, media, sensors, with the '\0' */

typedef struct murk_mesh {
    size_t vertices, triangles, materials;
    murk_vec3 origin_m; /* that the vertices count from: 0, unless an OBJ or PLY
                           file has them far from 0 (geometry/import_shift.h) */
    double step_m;      /* of single precision at the farthest vertex: how far
                           off the vertices may be */
    float *vertex_m;    /* 3 * vertices: x y z x y z ... */
    uint32_t *corner;   /* 3 * triangles: indices of vertices */
    uint32_t *material; /* triangles: index into material_name */
    char (*material_name)[MURK_NAME_SIZE]; /* as the file calls them */
    size_t degenerate; /* triangles of no area: counted, left out */
    murk_box bounds_m; /* with the origin */
} murk_mesh;

typedef struct murk_mesh_import {
    /* Length of the file's unit; 0: what the file says (Collada, glTF, FBX,
     * IFC), else 1. */
    double unit_m;
    /* 'x', 'y', 'z': the file's up axis; 0: what the file or its format says
     * (Collada, glTF, FBX, IFC, 3DS, ASE, DXF, X3D), else z. */
    char up;
    /* A folder in which the mesh may name other files (glTF's buffers, OBJ's
     * mtllib), beside its own; NULL: its own alone. */
    const char *allow;
} murk_mesh_import;

/* *out is the caller's: murk_mesh_destroy(). Fails with MURK_BAD_FILE (missing,
 * malformed, no triangles, not finite, an index out of range) at `where`. */
murk_status murk_mesh_read(murk_mesh **out, const char *path,
                           const murk_mesh_import *import, const char *where,
                           murk_error *err);
void murk_mesh_destroy(murk_mesh *mesh); /* NULL is fine */

#endif
