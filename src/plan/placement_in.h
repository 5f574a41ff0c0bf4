/* A given placement: sensors.csv or a plan.json. */
#ifndef MURK_PLAN_PLACEMENT_IN_H
#define MURK_PLAN_PLACEMENT_IN_H

#include "scene/scene.h"
#include "sensing/sensor.h"

/* *out[*n], n >= least, is the caller's to free(). Every sensor's type must be
 * one of the scene's, with a heading and tilt where that has a view, and it
 * must lie in the domain. Files that end in .json are read as a plan or
 * coverage, all others as CSV. */
murk_status murk_placement_read(murk_pose **out, size_t *n, const char *path,
                                size_t min, const murk_scene_desc *scene,
                                const murk_domain *domain, murk_error *err);

#endif
