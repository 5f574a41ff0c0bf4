/* The files that --export fields writes: fields over the domain, and the photon
 * density of each grid tally.
 *
 * extinction.vdb     extinction_Bnm [1/m] at the middle of each voxel; no file
 *                    if there are no media
 * coverage.vdb       coverage_Bnm and sensors_Bnm for the sensors of a plan;
 *                    also clarity_Bnm if the detections of several sensors
 *                    combine (sensing/places_seen.h)
 * optical_depth.vdb  optical_depth_Bnm for the sensors of a plan; -1: no
 *                    sightline
 * fields.vti         all fields of these three files, for ParaView
 * NAME_photons.vdb   photon_density_Bnm [1/s/m2] and photon_density_error_Bnm
 *                    of the grid tally NAME; with several bands also the sum
 *                    over the bands (results/tallies.h)
 * NAME.vti           the fields of NAME_photons.vdb and the fluence rate of the
 *                    tally with the standard error, for ParaView
 *
 * B is the wavelength of a band of the scene, such as 532 in coverage_532nm. */
#ifndef MURK_RESULTS_VOXEL_FIELDS_H
#define MURK_RESULTS_VOXEL_FIELDS_H

#include "results/field_files.h"
#include "results/session.h"
#include "sensing/sight.h"

/* Limit on voxels times bands, with --voxel. */
#define MURK_FIELDS_MAX 10000000

/* Divides the domain into voxels with edges of at most --voxel, as many along
 * each axis as fill it exactly. Without that option up to some 100,000 voxels,
 * with more than four bands up to 400,000 values. Fails with MURK_BAD_VALUE at
 * --voxel: not a number above 0 and up to 1e9, or too many voxels. To be called
 * as soon as the world is built. */
murk_status murk_fields_box(murk_field_box *out, const murk_session *session,
                            murk_error *err);

/* Adds the files of the domain; sight NULL: no sensors, only extinction. If a
 * file cannot be made, or on an interrupt, *late has the first reason. */
void murk_fields_add(murk_session *session, const murk_sight *sight,
                     const murk_pose *sensor, size_t n, murk_error *late);

#endif
