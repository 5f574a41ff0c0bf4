/* Unstructured geometry of an FDS run: the triangles of `GEOM`, from the .ge
 * file that the .smv file names.
 *
 * The file consists of Fortran records (fds/records.h): the number 1; the
 * version, 2; numbers of floats and integers that follow and 1 if the first
 * frame is static; these; then for each frame a time, the numbers of vertices,
 * triangles and volumes, and, as far as there are any: coordinates (single
 * precision), three corners of each triangle (from 1 on), surfaces (from 0 on,
 * in the order of the .smv file), six texture coordinates of each triangle,
 * four corners and one material of each volume. Geometry that moves has more
 * than one frame.
 *
 * Source: firemodels/smv, Source/smokeview/IOgeometry.c (ReadGeom2); FDS 6,
 * Source/dump.f90 (WRITE_SMOKEVIEW_FILE). */
#ifndef MURK_FDS_GEOM_H
#define MURK_FDS_GEOM_H

#include "fds/run.h"

typedef struct murk_fds_geom {
    size_t vertices, triangles;
    float *vertex;     /* [vertices][3], in metres */
    uint32_t *corner;  /* [triangles][3], from 0 on */
    uint32_t *surface; /* [triangles], indices into the surfaces of the run */
} murk_fds_geom;

/* Reads the geometry of a run, whose .smv file is `path`; a run without has no
 * triangles. The caller releases *out with murk_fds_geom_release(), after a
 * failure, too. Fails at `where` with MURK_BAD_FILE if the file cannot be read,
 * is malformed or moves, or with MURK_NO_MEMORY. */
murk_status murk_fds_geom_read(murk_fds_geom *out, const murk_fds_run *run,
                               const char *path, const char *where,
                               murk_error *err);
void murk_fds_geom_release(murk_fds_geom *geom);

#endif
