/* A run of the Fire Dynamics Simulator (FDS), as its .smv file describes it:
 * meshes with their grid lines, obstructions, vents, surfaces, events and the
 * names of data files. The .smv file is a text that FDS writes for the viewer
 * Smokeview; keywords that murk does not need are skipped.
 *
 * Source: FDS 6, Source/dump.f90 (github.com/firemodels/fds); FDS User's Guide,
 * NIST Special Publication 1019, doi:10.6028/NIST.SP.1019. */
#ifndef MURK_FDS_RUN_H
#define MURK_FDS_RUN_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Limits that refuse a malformed file before it fills the memory. */
#define MURK_FDS_MESHES_MAX 4096
#define MURK_FDS_ITEMS_MAX  10000000 /* obstructions, events, ... */

/* Of meshes, surfaces and quantities: FDS's own names have up to 60 characters.
 */
#define MURK_FDS_NAME_SIZE 64

/* A box of nodes, lowest and highest along x, y and z: the faces of an
 * obstruction or vent lie on grid lines of its mesh. */
typedef struct murk_fds_nodes {
    int32_t low[3], high[3];
} murk_fds_nodes;

/* An obstruction, or a vent: a face, whose nodes are equal along one axis. */
typedef struct murk_fds_item {
    murk_fds_nodes nodes;
    uint32_t surface[6]; /* of the faces -x +x -y +y -z +z, as indices into the
                          * surfaces of the run; of a vent [0] alone */
} murk_fds_item;

typedef struct murk_fds_mesh {
    char name[MURK_FDS_NAME_SIZE];
    size_t cells[3];
    double *edge[3]; /* [cells + 1], rising [m] */
    size_t obstructions, vents;
    murk_fds_item *obstruction, *vent;
} murk_fds_mesh;

/* An obstruction appears or vanishes, or a vent opens or closes, at a time. */
typedef struct murk_fds_event {
    double time_s;
    uint32_t mesh, item;
    bool is_vent;
    bool is_there; /* the obstruction appears, or the vent opens */
} murk_fds_event;

typedef enum murk_fds_kind {
    MURK_FDS_SMOKE3D,     /* .s3d: one byte for each node */
    MURK_FDS_SLICE_NODES, /* .sf, SLCF: a number for each node */
    MURK_FDS_SLICE_CELLS  /* .sf, SLCC: a number for each cell */
} murk_fds_kind;

typedef struct murk_fds_data {
    murk_fds_kind kind;
    uint32_t mesh;
    murk_fds_nodes nodes;   /* of a slice: the nodes that it spans */
    double mass_extinction; /* .s3d of soot: mass extinction coefficient
                             * [m2/kg]; otherwise 0 */
    char file[256];         /* in the folder of the .smv file */
    char quantity[MURK_FDS_NAME_SIZE], unit[MURK_FDS_NAME_SIZE];
    unsigned line; /* in the .smv file */
} murk_fds_data;

typedef struct murk_fds_run {
    size_t meshes, surfaces, events, files;
    murk_fds_mesh *mesh;
    char (*surface)[MURK_FDS_NAME_SIZE];
    char usual[MURK_FDS_NAME_SIZE]; /* SURFDEF: the surface of outer walls where
                                     * no vent gives another one */
    uint32_t usual_surface;         /* its index; 0 if there is no such */
    murk_fds_event *event;
    murk_fds_data *data; /* [files] */
    char geom[256]; /* file of triangles (fds/geom.h), in the folder of the .smv
                     * file; empty: none */
    unsigned geom_line; /* in the .smv file */
} murk_fds_run;

/* Reads a .smv file. The caller owns *out and releases it with
 * murk_fds_run_destroy(). Fails at `where`, to which the line is added, with
 * MURK_BAD_FILE if the file cannot be read or is malformed, or with
 * MURK_NO_MEMORY. */
murk_status murk_fds_run_read(murk_fds_run **out, const char *path,
                              const char *where, murk_error *err);
void murk_fds_run_destroy(murk_fds_run *run); /* NULL is fine */

/* True if a surface is an opening to the outside of the meshes. */
bool murk_fds_is_open(const murk_fds_run *run, uint32_t surface);

#endif
