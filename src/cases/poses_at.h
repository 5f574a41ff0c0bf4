/* The candidates of a plan in another state of the world: at a later step, or
 * in a condition that is a time. Fixed sensors stand there where the state has
 * them, and are absent once they have failed or left the domain; all other
 * candidates are the same. Planned sensors have no number before the plan is
 * chosen, so it is not known which would fail or drift. */
#ifndef MURK_CASES_POSES_AT_H
#define MURK_CASES_POSES_AT_H

#include "plan/poses.h"
#include "world/stage.h"

/* *out receives an array of poses->count poses, which is the caller's (free()),
 * or NULL if all are as in poses->pose. An absent sensor is of
 * MURK_POSE_OF_NONE (sensing/sensor.h). `own` is the scene that the poses were
 * made from, `stage` the other state of the same scene. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_poses_at(murk_pose **out, const murk_poses *poses,
                          const murk_scene_desc *own, const murk_stage *stage,
                          murk_error *err);

#endif
