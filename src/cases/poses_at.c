/* Candidates in another state of the world: fixed sensors are found by their
 * numbers in the list of the scene, which do not change when an earlier one
 * fails. */
#include "cases/poses_at.h"

#include <stdlib.h>
#include <string.h>

/* The pose of a fixed sensor in the world of a stage, by its number;
 * MURK_POSE_OF_NONE: the sensor has failed, or left the domain. */
static murk_pose fixed_pose(const murk_stage *stage, size_t number)
{
    const murk_scene_sensors *sensors = &stage->scene->sensors;
    for (size_t i = 0; i < sensors->n_fixed; ++i) {
        const murk_scene_fixed_sensor *fixed = &sensors->fixed[i];
        if (fixed->number == number &&
            murk_box_contains(&stage->world.domain.box, fixed->position)) {
            return (murk_pose){.type = (uint32_t)fixed->type,
                               .position = fixed->position,
                               .heading_rad = fixed->heading_rad,
                               .tilt_rad = fixed->tilt_rad};
        }
    }
    return (murk_pose){.type = MURK_POSE_OF_NONE};
}

static bool are_equal(const murk_pose *a, const murk_pose *b)
{
    return a->type == b->type && a->position.x == b->position.x &&
           a->position.y == b->position.y && a->position.z == b->position.z &&
           a->heading_rad == b->heading_rad && a->tilt_rad == b->tilt_rad;
}

murk_status murk_poses_at(murk_pose **out, const murk_poses *poses,
                          const murk_scene_desc *own, const murk_stage *stage,
                          murk_error *err)
{
    murk_pose *pose = NULL;
    for (size_t k = 0; k < poses->fixed; ++k) {
        const size_t at = poses->fixed_number[k];
        const murk_pose now = fixed_pose(stage, own->sensors.fixed[k].number);
        if (are_equal(&now, &poses->pose[at])) {
            continue;
        }
        /* Copy all poses at the first difference. */
        if (!pose) {
            pose = malloc(poses->count * sizeof *pose);
            if (!pose) {
                return murk_no_memory(err, "",
                                      "for the candidates at another time");
            }
            memcpy(pose, poses->pose, poses->count * sizeof *pose);
        }
        pose[at] = now;
    }
    *out = pose;
    return MURK_OK;
}
