/* The plan that is in force before the first step of a timeline, at which the
 * search of each step begins with the key search_from: start_plan. The steps
 * then do not depend on each other. */
#include "api/follow.h"

#include "plan/placement_in.h"

#include <stdlib.h>
#include <string.h>

/* True if the sensor is one of the fixed ones of the scene, which may have
 * failed before the first step. */
static bool is_fixed(const murk_scene_sensors *sensors, const murk_pose *pose)
{
    bool is_one = false;
    for (size_t i = 0; i < sensors->fixed_listed && !is_one; ++i) {
        const murk_scene_fixed_sensor *fixed = &sensors->fixed[i];
        const murk_pose own = {.type = (uint32_t)fixed->type,
                               .position = fixed->position,
                               .heading_rad = fixed->heading_rad,
                               .tilt_rad = fixed->tilt_rad};
        is_one = murk_sequence_is_same_pose(&own, pose);
    }
    return is_one;
}

murk_status murk_follow_read_start(murk_follow *follow,
                                   const murk_scene_desc *desc, murk_error *err)
{
    murk_pose *pose = NULL;
    bool *has_drifted = NULL;
    size_t n = 0, own = 0;
    if (!desc->placement.start_plan) {
        return MURK_OK;
    }
    murk_status status = murk_placement_read_start(&pose, &has_drifted, &n,
                                                   desc->placement.start_plan,
                                                   desc, &desc->domain, err);
    if (!desc->timeline.from_start_plan) { /* that it can be read is all */
        free(has_drifted);
        free(pose);
        return status;
    }
    /* The fixed sensors are not planned. */
    for (size_t i = 0; i < n; ++i) {
        if (!is_fixed(&desc->sensors, &pose[i])) {
            has_drifted[own] = has_drifted[i];
            pose[own++] = pose[i];
        }
    }
    if (!status) {
        status =
            murk_sequence_begin(&follow->sequence, pose, has_drifted, own, err);
    }
    free(has_drifted);
    free(pose);
    follow->start = status ? NULL : calloc(own + 1, sizeof *follow->start);
    if (!status && !follow->start) {
        status = murk_no_memory(err, "", "for the start of the steps");
    }
    if (!status) {
        memcpy(follow->start, follow->sequence.sensor,
               own * sizeof *follow->start);
        follow->starts = own;
        follow->has_start = true;
    }
    return status;
}
