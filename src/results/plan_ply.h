/* plan.ply, and plan-NAME.ply and coverage.ply of the same form: sensors and
 * photons as points and marks, for ParaView, MeshLab and Blender. */
#ifndef MURK_RESULTS_PLAN_PLY_H
#define MURK_RESULTS_PLAN_PLY_H

#include "results/results.h"
#include "sensing/sight.h"
#include "world/stage.h"

#define MURK_PLAN_PLY_SENSORS 32 /* that have a bit */

/* Adds the file. Its vertices are the sensors, in order; the corners of the
 * mark of each (results/mark.h), whose triangles are the faces (a point alone
 * is hard to see); and the stored photons or targets, those of the surface map
 * first, in the order of the maps. A vertex has
 *
 *     x y z           float, m
 *     red green blue  uchar: sensors yellow; photons red unseen, blue seen by
 *                     one, green by more
 *     kind            uchar: 0 sensor, 1 surface photon, 2 volume photon,
 *                     3 corner of a sensor's mark
 *     seen_by         ushort: of a photon, how many sensors see it
 *     quality         float, 0..1: largest clarity of a photon; else 1
 *     sensors         uint: of a photon, who sees it: bit k is sensor k, from
 *                     0, of the first 32
 *
 * Binary, little endian. Octahedra are 1/100 of the diagonal of the domain
 * wide, and the edges of views are 1/50 of the diagonal long. Fails with
 * MURK_NO_MEMORY or MURK_INTERRUPTED, or as murk_results_add() does. */
murk_status murk_add_plan_ply(murk_results *results, const char *name,
                              const murk_stage *stage, murk_sight *sight,
                              const murk_pose *sensor, size_t n,
                              murk_error *err);

#endif
