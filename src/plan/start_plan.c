/* Matches the sensors of a given plan to the candidates of a search. In the
 * common case the plan was made by an earlier run with the same candidates, and
 * every match is exact. If the candidates differ (another grid, other headings,
 * a wall that moved), the nearest candidate stands for the sensor. Every sensor
 * is compared with every pose: 100 sensors among a million poses take about a
 * tenth of a second. */
#include "plan/start_plan.h"

#include "base/log.h"
#include "plan/placement_in.h"

#include <math.h>
#include <stdlib.h>

/* Likeness of the directions of two poses: the trace of the rotation between
 * the frames of the poses, 1 + 2 cos(angle of the rotation). The frame is
 * compared and not the axis alone, because a camera that looks straight down
 * has the same axis for all headings. */
static double likeness(const murk_pose *a, const murk_pose *b)
{
    const murk_vec3 north = murk_vec(0, 1, 0); /* any: the angle is relative */
    const murk_sensor_frame f = murk_pose_frame(a, north),
                            g = murk_pose_frame(b, north);
    return murk_dot(f.axis, g.axis) + murk_dot(f.right, g.right) +
           murk_dot(f.up, g.up);
}

/* The number of the pose nearest to a sensor, and the distance; poses->count if
 * no pose has the type of the sensor. */
static size_t find_nearest(const murk_poses *poses, const murk_pose *sensor,
                           double *distance_m)
{
    size_t nearest = poses->count;
    double min2_m2 = INFINITY, likeness_max = -INFINITY;
    for (size_t j = 0; j < poses->count; ++j) {
        const murk_pose *pose = &poses->pose[j];
        const murk_vec3 d = murk_sub(pose->position, sensor->position);
        const double d2_m2 = murk_dot(d, d);
        if (pose->type != sensor->type || d2_m2 > min2_m2) {
            continue;
        }
        const double alike = likeness(pose, sensor);
        const bool is_fixed = j >= poses->count - poses->fixed;
        if (d2_m2 < min2_m2 || alike > likeness_max ||
            (is_fixed && !(alike < likeness_max))) {
            nearest = j;
            min2_m2 = d2_m2;
            likeness_max = alike;
        }
    }
    *distance_m = sqrt(min2_m2);
    return nearest;
}

/* The distance from pose j to the nearest pose at another position; INFINITY if
 * all poses are at one position. */
static double distance_to_next_m(const murk_poses *poses, size_t j)
{
    double min2_m2 = INFINITY;
    for (size_t k = 0; k < poses->count; ++k) {
        const murk_vec3 d =
            murk_sub(poses->pose[k].position, poses->pose[j].position);
        const double d2_m2 = murk_dot(d, d);
        min2_m2 = d2_m2 > 0 && d2_m2 < min2_m2 ? d2_m2 : min2_m2;
    }
    return sqrt(min2_m2);
}

/* The sensor that lies farthest from its candidate. */
typedef struct farthest {
    size_t sensor, pose;
    double distance_m;
} farthest;

static void note_distance(const murk_poses *poses, const char *where,
                          const farthest *far)
{
    const double next_m =
        far->distance_m > 0 ? distance_to_next_m(poses, far->pose) : INFINITY;
    if (far->distance_m > next_m) {
        murk_note(
            "placement.start_plan",
            "%s: sensor %zu lies %.3g m from the nearest candidate of its "
            "type, which is %.3g m from the next candidate; the search "
            "begins at the nearest candidates",
            where, far->sensor + 1, far->distance_m, next_m);
    }
}

/* Fills poses->start, which has space for n candidates; is_taken[poses->count]
 * is false at first. */
static void match(murk_poses *poses, bool *is_taken, const murk_pose *sensor,
                  size_t n, const char *where)
{
    farthest far = {.distance_m = 0};
    for (size_t i = 0; i < n; ++i) {
        double distance_m;
        const size_t j = find_nearest(poses, &sensor[i], &distance_m);
        if (j == poses->count) {
            continue;
        }
        if (distance_m > far.distance_m) {
            far = (farthest){i, j, distance_m};
        }
        if (!is_taken[j]) {
            is_taken[j] = true;
            poses->start[poses->starts++] = (uint32_t)j;
        }
    }
    note_distance(poses, where, &far);
}

murk_status murk_start_plan_take(murk_poses *poses, const murk_pose *sensor,
                                 size_t n, const char *where, murk_error *err)
{
    bool *is_taken = calloc(poses->count + 1, sizeof *is_taken);
    poses->start = calloc(n + 1, sizeof *poses->start);
    if (!poses->start || !is_taken) {
        free(is_taken);
        return murk_no_memory(err, where, "for a plan of %zu sensors", n);
    }
    match(poses, is_taken, sensor, n, where);
    free(is_taken);
    return MURK_OK;
}

murk_status murk_start_plan_match(murk_poses *poses,
                                  const murk_scene_desc *scene,
                                  const murk_domain *domain, murk_error *err)
{
    const char *path = scene->placement.start_plan;
    murk_pose *sensor = NULL;
    size_t n = 0;
    if (!path) {
        return MURK_OK;
    }
    /* A plan without sensors, such as that of a dark step, is a start, too. */
    murk_status status =
        murk_placement_read(&sensor, &n, path, 0, scene, domain, err);
    if (!status) {
        status = murk_start_plan_take(poses, sensor, n, path, err);
    }
    free(sensor);
    return status;
}
