/* The plan at which a search begins (key placement.start_plan). */
#ifndef MURK_PLAN_START_PLAN_H
#define MURK_PLAN_START_PLAN_H

#include "plan/poses.h"

/* Fills poses->start with the candidates that are nearest to sensor[n], in this
 * order: of the poses of the same type those at the least distance, of these
 * the one with the nearest direction, a fixed sensor on ties, else the first.
 * Sensors whose candidate is already in the list are left out, and so are
 * sensors of a type without candidates. A note tells if a sensor lies farther
 * from its candidate than the nearest other candidate does, with `where` as
 * its place. Fails with MURK_NO_MEMORY. */
murk_status murk_start_plan_take(murk_poses *poses, const murk_pose *sensor,
                                 size_t n, const char *where, murk_error *err);

/* The same for the sensors in the file of scene->placement.start_plan. Does
 * nothing without the key. Fails as murk_placement_read(). */
murk_status murk_start_plan_match(murk_poses *poses,
                                  const murk_scene_desc *scene,
                                  const murk_domain *domain, murk_error *err);

#endif
