/* The files that --export surfaces writes: surfaces.ply (Blender, MeshLab) and
 * surfaces.vtp (ParaView, whose PLY reader drops the properties of faces). Both
 * have the surfaces of the scene in triangular pieces, with the irradiance and
 * the coverage of each piece. Pieces whose middle is outside of the domain are
 * left out. Pieces share no corners, so that a color belongs to one piece only.
 * A face has these properties (results/lit_pieces.h):
 *
 *     red green blue   uchar, also of the corners: coverage, or without sensors
 *                      irradiance, from dark violet to yellow; grey if nothing
 *                      is known
 *     irradiance       float, W/m2
 *     irradiance_error float, W/m2
 *     photons          uint
 *     material         uchar: number; a note in the file lists the names
 *     coverage         float, with sensors only
 *     clarity          float, with sensors only
 *     sensors          ushort, with sensors only
 */
#ifndef MURK_RESULTS_SURFACES_H
#define MURK_RESULTS_SURFACES_H

#include "results/session.h"
#include "sensing/sight.h"

/* Checks --voxel, the longest edge of a piece, if it is given: fails with
 * MURK_BAD_VALUE if it is not a number above 0, or makes too many pieces; or
 * with MURK_NO_MEMORY. */
murk_status murk_surfaces_check(const murk_session *session, murk_error *err);

/* Adds both files; with coverage by sensor[n] unless sight is NULL. If a file
 * cannot be made, or on an interrupt, *late has the first reason. */
void murk_surfaces_add(murk_session *session, murk_sight *sight,
                       const murk_pose *sensor, size_t n, murk_error *late);

#endif
