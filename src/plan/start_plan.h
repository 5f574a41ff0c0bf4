/* The plan at which a search begins (key placement.start_plan). */
#ifndef MURK_PLAN_START_PLAN_H
#define MURK_PLAN_START_PLAN_H

#include "plan/poses.h"

/* Reads the file of scene->placement.start_plan, and fills poses->start with
 * the candidates that are nearest to the sensors of the file, in the order of
 * the file: of the poses of the same type those at the least distance, of these
 * the one with the nearest direction, a fixed sensor on ties, else the first.
 * Sensors whose candidate is already in the list are left out, and so are
 * sensors of a type without candidates. A note tells if a sensor lies farther
 * from its candidate than the nearest other candidate does. Does nothing
 * without the key. Fails as murk_placement_read(). */
murk_status murk_start_plan_match(murk_poses *poses,
                                  const murk_scene_desc *scene,
                                  const murk_domain *domain, murk_error *err);

#endif
