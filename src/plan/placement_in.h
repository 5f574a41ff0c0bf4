/* Reads a given placement of sensors from sensors.csv or plan.json. */
#ifndef MURK_PLAN_PLACEMENT_IN_H
#define MURK_PLAN_PLACEMENT_IN_H

#include "scene/scene.h"
#include "sensing/sensor.h"

/* Reads the sensors, and converts positions from the coordinates of the user to
 * those of the scene structs. The caller frees (*out)[*n]. Fails with
 * MURK_BAD_FILE if the file is missing or malformed or does not have `min` to
 * 1e6 sensors, or if a coordinate in a JSON file is no number; with
 * MURK_BAD_VALUE if a coordinate or an angle in a CSV file is no finite number,
 * if a type is not one of the scene, if a sensor lies outside the domain, or if
 * a sensor of a type that does not see all round has no heading of -360..360 or
 * no tilt of -90..90 degrees; or with MURK_NO_MEMORY. A file whose name ends in
 * .json is read as a plan or a coverage result, any other file as CSV. */
murk_status murk_placement_read(murk_pose **out, size_t *n, const char *path,
                                size_t min, const murk_scene_desc *scene,
                                const murk_domain *domain, murk_error *err);

/* The same for the plan at which a search begins: (*is_drifted)[i] is true if a
 * CSV file has 1 in the column `drifted`, for a sensor that is no longer at the
 * pose at which it was placed. It may lie outside of the domain. */
murk_status murk_placement_read_start(murk_pose **out, bool **is_drifted,
                                      size_t *n, const char *path,
                                      const murk_scene_desc *scene,
                                      const murk_domain *domain,
                                      murk_error *err);

#endif
