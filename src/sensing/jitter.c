/* Random deviations of poses by rejection: positions uniform in the ball are
 * drawn until one is free and joined to the planned position. Random numbers
 * are addressed by seed, draw, sensor and try, so every draw can be repeated.
 */
#include "sensing/jitter.h"

#include "base/rng.h"
#include "sensing/free_segments.h"

/* Tries for a free position. If a share f of the ball is free, a sensor stays
 * in place with probability (1 - f)^100: 0.37 for f = 0.01 (a choice). */
#define TRIES 100

/* Slots of the random numbers of a sensor: one for the rotation of the axis,
 * then one for each try of a position. */
#define TURN_SLOT       0
#define FIRST_STEP_SLOT 1

static murk_vec3 step_of(const murk_random4 *r, double step_m)
{
    const murk_vec3 up = {0, 0, 1};
    return murk_scale(step_m * cbrt(r->u[0]),
                      murk_about(up, 2 * r->u[1] - 1, 2 * MURK_PI * r->u[2]));
}

/* Wraps a coordinate into the domain. */
static double wrap(double x, double min, double max)
{
    const double period = max - min;
    const double in = x - period * floor((x - min) / period);
    return in < min || in > max ? min : in; /* rounding may leave the domain */
}

static bool move_within_ball(murk_vec3 *place, const murk_jitter *j,
                             const murk_free_segments *segments,
                             const murk_address *address)
{
    const murk_box *box = &j->domain->box;
    /* Draw a position, wrap it, and test it. */
    for (uint32_t k = 0; k < TRIES; ++k) {
        const murk_random4 r = murk_random_at(address, FIRST_STEP_SLOT + k);
        const murk_vec3 step = step_of(&r, j->step_m);
        const murk_vec3 to = murk_add(*place, step);
        murk_vec3 at = to;
        if (j->domain->is_periodic) {
            if (!(fabs(step.x) < box->max.x - box->min.x &&
                  fabs(step.y) < box->max.y - box->min.y)) {
                continue; /* segments are shorter than one period */
            }
            at.x = wrap(to.x, box->min.x, box->max.x);
            at.y = wrap(to.y, box->min.y, box->max.y);
        }
        if (murk_box_contains(box, at) &&
            !murk_surfaces_near(j->surfaces, at, segments->tolerance_m) &&
            murk_free_segment_is_open(segments, *place, to)) {
            *place = at;
            return true;
        }
    }
    return false;
}

static void turn(murk_pose *pose, const murk_jitter *j,
                 const murk_address *address)
{
    const murk_random4 r = murk_random_at(address, TURN_SLOT);
    const double half = sin(j->turn_rad / 2);
    const double mu =
        1 - 2 * half * half * r.u[0]; /* uniform over the cap: mu is uniform */
    const murk_vec3 axis = murk_about(murk_pose_frame(pose, j->north).axis, mu,
                                      2 * MURK_PI * r.u[1]);
    const murk_vec3 up = {0, 0, 1}, east = murk_cross(j->north, up);
    const double to_east = murk_dot(axis, east),
                 to_north = murk_dot(axis, j->north);
    pose->tilt_rad = atan2(axis.z, hypot(to_east, to_north));
    pose->heading_rad = atan2(to_east, to_north);
    if (pose->heading_rad < 0) {
        pose->heading_rad += 2 * MURK_PI;
    }
}

size_t murk_jitter_draw(murk_pose *out, const murk_pose *pose, size_t n,
                        const murk_sensor_type *type, const murk_jitter *jitter,
                        uint64_t draw)
{
    murk_free_segments segments =
        murk_free_segments_of(jitter->surfaces, jitter->domain);
    segments.by_sheets = true;
    size_t unmoved = 0;
    for (size_t i = 0; i < n; ++i) {
        const murk_address address = {jitter->seed, MURK_JITTER, draw,
                                      (uint32_t)i};
        out[i] = pose[i];
        if (pose[i].type == MURK_POSE_OF_NONE) { /* nothing to displace */
            continue;
        }
        if (jitter->step_m > 0 &&
            !move_within_ball(&out[i].position, jitter, &segments, &address)) {
            ++unmoved;
        }
        if (jitter->turn_rad > 0 &&
            type[pose[i].type].view != MURK_VIEW_SPHERE) {
            turn(&out[i], jitter, &address);
        }
    }
    return unmoved;
}
