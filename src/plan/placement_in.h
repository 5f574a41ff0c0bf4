/* Reads a given placement of sensors from sensors.csv or plan.json. */
#ifndef MURK_PLAN_PLACEMENT_IN_H
#define MURK_PLAN_PLACEMENT_IN_H

#include "scene/scene.h"
#include "sensing/sensor.h"

/* Reads the sensors. The caller owns (*out)[*n]: free(). Fails if there are
 * fewer than min sensors, if a type is not one of the scene, if a type with a
 * view has no heading or tilt, or if a sensor lies outside the domain. A file
 * whose name ends in .json is read as a plan or a coverage result, any other
 * file as CSV. */
murk_status murk_placement_read(murk_pose **out, size_t *n, const char *path,
                                size_t min, const murk_scene_desc *scene,
                                const murk_domain *domain, murk_error *err);

#endif
