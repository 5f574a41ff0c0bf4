/* The part of reading a mesh that runs in a subprocess, or, if the host trusts
 * the files, in the calling process (base/subprocess.h). import.c is the only
 * file of murk that calls Assimp; fds_import.c imports FDS runs.
 *
 * The work sends, in this order: murk_import_head, float[vertices][3],
 * uint32_t[triangles][4] (three corners and the material),
 * char[materials][MURK_NAME_SIZE]. */
#ifndef MURK_GEOMETRY_IMPORT_H
#define MURK_GEOMETRY_IMPORT_H

#include "base/subprocess.h"
#include "geometry/mesh.h"

typedef struct murk_import_head {
    uint64_t vertices, triangles, materials;
    murk_vec3 origin_m;    /* origin of the vertices */
    uint64_t names_others; /* 1: the file names other files, else 0 */
} murk_import_head;

typedef struct murk_import_request {
    const char *path, *where;
    murk_mesh_import import;
} murk_import_request;

/* Rotation that turns the axis 'x', 'y' or 'z' to z; the identity for other
 * letters. */
murk_affine murk_import_up_to_z(char up);

/* The import as a job of murk_subprocess_do(); the context is a
 * murk_import_request. */
extern const murk_subprocess_job murk_import_job;

/* The request and the answer are those of murk_import_job; for the walls of FDS
 * runs (fds_import.c). */
extern const murk_subprocess_job murk_import_fds_job;

/* pack() of both jobs, and the request that work_packed() takes. */
void murk_import_pack(murk_parcel *to, const void *context);
murk_status murk_import_unpack(murk_import_request *out, murk_parcel *from,
                               murk_error *err);

/* Unpacks and checks an answer; for GeoTIFF files (is_geotiff) the facts come
 * before the head. The caller owns *out. Fails with MURK_BAD_FILE at `where`,
 * or with MURK_NO_MEMORY. */
murk_status murk_import_open(murk_mesh **out, const unsigned char *bytes,
                             size_t size, bool is_geotiff, const char *path,
                             const char *where, murk_error *err);

/* A murk_subprocess_work function; `context` is a murk_import_request. */
murk_status murk_import_work(murk_subprocess *subprocess, void *context,
                             murk_error *err);

#endif
