/* The plan that is in force before the first step of a timeline, at which the
 * search of each step begins with the key search_from: start_plan. The steps
 * then do not depend on each other. */
#include "api/follow.h"

#include "plan/placement_in.h"

#include <stdlib.h>
#include <string.h>

/* True if the sensor is one of the fixed ones of the scene. */
static bool is_fixed(const murk_scene_sensors *sensors, const murk_pose *pose)
{
    size_t i = 0;
    while (i < sensors->n_fixed &&
           (sensors->fixed[i].type != pose->type ||
            murk_length(murk_sub(sensors->fixed[i].position, pose->position)) >
                0)) {
        ++i;
    }
    return i < sensors->n_fixed;
}

murk_status murk_follow_read_start(murk_follow *follow,
                                   const murk_scene_desc *desc, murk_error *err)
{
    murk_pose *pose = NULL;
    bool *has_drifted = NULL;
    size_t n = 0, own = 0;
    if (!desc->timeline.from_start_plan || !desc->placement.start_plan) {
        return MURK_OK;
    }
    murk_status status = murk_placement_read_start(&pose, &has_drifted, &n,
                                                   desc->placement.start_plan,
                                                   desc, &desc->domain, err);
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
