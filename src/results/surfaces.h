/* What --export surfaces writes: the scene's surfaces in pieces, each with
 * what arrives on it and who sees it, as surfaces.ply (Blender, MeshLab) and
 * surfaces.vtp (ParaView, whose PLY reader drops what faces have). Pieces whose
 * middle is outside of the domain are left out; each has three corners of its
 * own, so that colours stay within it. A face has
 *
 *     red green blue   uchar (its corners, too): coverage, else irradiance,
 *                      from dark violet to yellow; grey where nothing is known
 *     irradiance       float, W/m2: results/lit_pieces.h, as are the others
 *     irradiance_error float
 *     photons          uint
 *     material         uchar: number, in the comments by name
 *     coverage, clarity float; sensors ushort: with sensors only
 */
#ifndef MURK_RESULTS_SURFACES_H
#define MURK_RESULTS_SURFACES_H

#include "results/session.h"
#include "sensing/sight.h"

/* Whether --voxel suits the surfaces: fails with MURK_BAD_VALUE. */
murk_status murk_surfaces_check(const murk_session *session, murk_error *err);

/* sight NULL: no sensors. Files that cannot be had, and an interrupt, are told
 * in *late. */
void murk_surfaces_add(murk_session *session, murk_sight *sight,
                       const murk_pose *sensor, size_t n, murk_error *late);

#endif
