/* Surfaces of an FDS run at one time: the faces of obstructions, and the outer
 * walls of the meshes except open vents.
 *
 * FDS places obstructions on grid lines, and a cell is solid or not; so the
 * surfaces here are the faces between cells that are solid and cells that are
 * not, joined to rectangles. Where obstructions overlap, the last one counts.
 * An obstruction without thickness is a plate, which has one face. A face
 * between two meshes is drawn once, on the finer of both. Outer walls have the
 * surface that SURFDEF names. A vent gives the
 * faces that it covers its own surface. Outer walls covered by a vent that is
 * open, a mirror or periodic are left out: light may pass there. */
#ifndef MURK_FDS_WALLS_H
#define MURK_FDS_WALLS_H

#include "fds/run.h"

/* A rectangle across an axis. */
typedef struct murk_fds_wall {
    double corner_m[4][3]; /* in order around the rectangle */
    uint32_t surface;      /* index into the surfaces of the run */
} murk_fds_wall;

typedef struct murk_fds_walls {
    size_t n;
    murk_fds_wall *wall;
} murk_fds_walls;

/* Finds the surfaces at a time. The caller frees out->wall. False without
 * memory; nothing is to be freed then. */
bool murk_fds_walls_find(murk_fds_walls *out, const murk_fds_run *run,
                         double time_s);

#endif
