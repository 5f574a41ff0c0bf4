/* Triangle meshes from files of any format that Assimp reads (OBJ, PLY, STL,
 * glTF, Collada, FBX, IFC, ...).
 *
 * The file is parsed in a subprocess with limits (base/subprocess.h), checked
 * (finite coordinates, indices in range), and handed over as plain arrays in
 * metres with z up. Call murk_mesh_read() before any thread or Embree device
 * exists, because the function may fork the process. */
#ifndef MURK_GEOMETRY_MESH_H
#define MURK_GEOMETRY_MESH_H

#include "base/status.h"
#include "base/vector.h"
#include "terrain/geotiff_request.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MURK_NAME_SIZE 64 /* of materials, media, sensors, with the '\0' */

typedef struct murk_mesh {
    size_t vertices, triangles, materials;
    murk_vec3 origin_m; /* origin of the vertices: 0, unless an OBJ or PLY file
                           has vertices far from 0 (geometry/import_shift.h),
                           or ground is far from the site */
    double step_m;      /* step of single precision at the farthest vertex: the
                           accuracy of the vertices */
    float *vertex_m;    /* 3 * vertices: x y z x y z ... */
    uint32_t *corner;   /* 3 * triangles: indices of vertices */
    uint32_t *material; /* triangles: index into material_name */
    char (*material_name)[MURK_NAME_SIZE]; /* the names in the file */
    size_t degenerate; /* number of triangles without area; they are removed */
    murk_box bounds_m; /* of the corners of all triangles, with origin_m
                        * added */
    bool names_others; /* the file names other files, such as materials or
                        * buffers, so the mesh may change without the file */
    murk_terrain_facts terrain; /* of a GeoTIFF file; columns 0: another file */
    unsigned further_owners;    /* murk_mesh_share() */
} murk_mesh;

typedef struct murk_mesh_import {
    /* Length of the file's unit [m]. 0: the unit that the file states
     * (Collada, glTF, FBX, IFC), otherwise 1. */
    double unit_m;
    /* 'x', 'y' or 'z': the file's up axis. 0: the up axis that the file or
     * the format states (Collada, glTF, FBX, IFC, 3DS, ASE, DXF, X3D),
     * otherwise z. */
    char up;
    /* A further folder, besides that of the mesh, in which the mesh may name
     * other files (glTF's buffers, OBJ's mtllib). NULL: no other folder. */
    const char *allow;
    /* The file is the .smv file of an FDS run: the mesh consists of the walls
     * of the run at a time (fds/walls.h), with the names of surfaces as those
     * of materials. unit_m and up are ignored. */
    bool is_fds;
    double fds_time_s;
    /* The file is a GeoTIFF file of elevations: the mesh is the ground in the
     * frame of the request (terrain/geotiff_request.h), with triangles whose
     * corners turn counter-clockwise seen from above, and one material,
     * default. unit_m and up are ignored. */
    bool is_geotiff;
    murk_geotiff_asked geotiff;
} murk_mesh_import;

/* A path "memory:NAME" names a mesh in memory (base/memory_files.h), whose data
 * is a murk_mesh with arrays in the unit and axes of the caller.
 *
 * `import` NULL means zeros. The caller owns *out and releases it with
 * murk_mesh_destroy(). Fails at `where` with MURK_BAD_FILE if the file is
 * missing, malformed or without a triangle that has an area, or if a coordinate
 * is not finite or an index is out of range, and with MURK_BAD_VALUE if a
 * member of *import is out of range; also with MURK_NO_MEMORY and as
 * murk_subprocess_do() does. */
murk_status murk_mesh_read(murk_mesh **out, const char *path,
                           const murk_mesh_import *import, const char *where,
                           murk_error *err);

/* A checksum of vertices, triangles and names of materials. */
void murk_mesh_checksum(const murk_mesh *mesh, uint64_t out[2]);

/* Releases the mesh, and destroys it if no owner is left; NULL is fine. */
void murk_mesh_destroy(murk_mesh *mesh);

/* Adds an owner, who also calls murk_mesh_destroy(), and returns the mesh; NULL
 * is fine. Not for owners that several threads release at once. */
murk_mesh *murk_mesh_share(murk_mesh *mesh);

#endif
