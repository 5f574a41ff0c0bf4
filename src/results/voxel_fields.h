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

/* Voxels times bands, at most. */
#define MURK_FIELDS_MAX 10000000

/* The domain in voxels of --voxel, each edge made a little less so that they
 * fill it; without that option some 100,000 voxels, of many bands fewer. Fails
 * with MURK_BAD_VALUE at --voxel. To be asked as soon as the world is built. */
murk_status murk_fields_box(murk_field_box *out, const murk_session *session,
                            murk_error *err);

/* Adds the files of the domain. sight NULL: no plan, extinction alone. Files
 * that cannot be had, and an interrupt, are told in *late. */
void murk_fields_add(murk_session *session, const murk_sight *sight,
                     const murk_pose *sensor, size_t n, murk_error *late);

#endif
