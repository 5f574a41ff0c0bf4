/* Follows the sensors of plans from step to step. Plans have few sensors, so
 * pairs are found by comparing each sensor with each. */
#include "cases/sequence.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void murk_sequence_init(murk_sequence *out, uint64_t first)
{
    *out = (murk_sequence){.next = first};
}

void murk_sequence_release(murk_sequence *s)
{
    free(s->row);
    free(s->move);
    free(s->sensor);
    *s = (murk_sequence){0};
}

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "timeline", "for the steps");
}

murk_status murk_sequence_begin(murk_sequence *s, const murk_pose *pose,
                                const bool *has_drifted, size_t n,
                                murk_error *err)
{
    s->sensor = calloc(n + 1, sizeof *s->sensor);
    if (!s->sensor) {
        return no_memory(err);
    }
    for (size_t i = 0; i < n; ++i) {
        s->sensor[i] =
            (murk_sequence_sensor){s->next++, pose[i], has_drifted[i]};
    }
    s->sensors = n;
    return MURK_OK;
}

murk_status murk_sequence_add(murk_sequence *s, const murk_sequence_row *row,
                              murk_error *err)
{
    murk_sequence_row *grown = realloc(s->row, (s->rows + 1) * sizeof *grown);
    if (!grown) {
        return no_memory(err);
    }
    s->row = grown;
    s->row[s->rows++] = *row;
    return MURK_OK;
}

static murk_status add_move(murk_sequence *s, const murk_sequence_move *move,
                            murk_error *err)
{
    murk_sequence_move *grown =
        realloc(s->move, (s->moves + 1) * sizeof *grown);
    if (!grown) {
        return no_memory(err);
    }
    s->move = grown;
    s->move[s->moves++] = *move;
    return MURK_OK;
}

/* The index of a sensor; s->sensors if there is none of that number. */
static size_t find_sensor(const murk_sequence *s, uint64_t number)
{
    size_t i = 0;
    while (i < s->sensors && s->sensor[i].number != number) {
        ++i;
    }
    return i;
}

murk_status murk_sequence_fail(murk_sequence *s, size_t step, double t_s,
                               uint64_t number, murk_error *err)
{
    const size_t i = find_sensor(s, number);
    if (i == s->sensors) {
        return MURK_OK;
    }
    const murk_sequence_move move = {.step = step,
                                     .t_s = t_s,
                                     .sensor = number,
                                     .change = MURK_SENSOR_FAILED,
                                     .from = s->sensor[i].pose};
    memmove(&s->sensor[i], &s->sensor[i + 1],
            (s->sensors - i - 1) * sizeof *s->sensor);
    --s->sensors;
    return add_move(s, &move, err);
}

/* ---- drift ---- */

/* An angle that was turned, within -360 to 360 degrees, as files have it. */
static double turned(double angle_rad, double by_rad)
{
    return by_rad == 0 ? angle_rad : remainder(angle_rad + by_rad, 2 * MURK_PI);
}

murk_status murk_sequence_drift(murk_sequence *s, size_t step, double t_s,
                                uint64_t number, const murk_drift *by,
                                murk_error *err)
{
    const size_t i = find_sensor(s, number);
    const bool is_still = by->offset_m.x == 0 && by->offset_m.y == 0 &&
                          by->offset_m.z == 0 && by->heading_rad == 0 &&
                          by->tilt_rad == 0;
    if (i == s->sensors || is_still) {
        return MURK_OK;
    }
    murk_sequence_sensor *sensor = &s->sensor[i];
    const murk_pose from = sensor->pose;
    murk_pose *to = &sensor->pose;
    to->position = murk_add(to->position, by->offset_m);
    to->heading_rad = turned(to->heading_rad, by->heading_rad);
    /* No camera tilts beyond straight up or down. */
    to->tilt_rad =
        fmax(-MURK_PI / 2, fmin(MURK_PI / 2, to->tilt_rad + by->tilt_rad));
    sensor->has_drifted = true;
    const murk_sequence_move move = {.step = step,
                                     .t_s = t_s,
                                     .sensor = number,
                                     .change = MURK_SENSOR_DRIFTED,
                                     .from = from,
                                     .to = *to};
    return add_move(s, &move, err);
}

/* Lets the sensor of a track drift between two times. */
static murk_status drift(murk_sequence *s, const murk_scene_desc *scene,
                         const murk_scene_track *track, size_t step,
                         double from_s, double t_s, murk_error *err)
{
    const size_t i = find_sensor(s, track->sensor);
    const murk_drift before = murk_timeline_drift(track, from_s),
                     now = murk_timeline_drift(track, t_s);
    murk_drift by = {murk_sub(now.offset_m, before.offset_m),
                     now.heading_rad - before.heading_rad,
                     now.tilt_rad - before.tilt_rad};
    if (i < s->sensors &&
        scene->sensors.type[s->sensor[i].pose.type].view == MURK_VIEW_SPHERE) {
        by.heading_rad = by.tilt_rad = 0;
    }
    return murk_sequence_drift(s, step, t_s, track->sensor, &by, err);
}

murk_status murk_sequence_advance(murk_sequence *s,
                                  const murk_scene_desc *scene, double from_s,
                                  size_t step, bool warns, murk_error *err)
{
    const murk_scene_timeline *timeline = &scene->timeline;
    const double first_s = murk_timeline_time_s(timeline, 0),
                 t_s = murk_timeline_time_s(timeline, step);
    murk_status status = MURK_OK;
    for (size_t i = 0; i < timeline->tracks && !status; ++i) {
        const murk_scene_track *track = &timeline->track[i];
        if (track->kind != MURK_TRACK_SENSOR ||
            track->sensor < scene->sensors.fixed_listed) {
            continue;
        }
        /* A sensor fails once: one that gets its number later does not. */
        const bool fails = track->fails && from_s < track->fails_at_s &&
                           track->fails_at_s <= t_s;
        if (fails && warns && find_sensor(s, track->sensor) == s->sensors) {
            murk_warn(track->where,
                      "sensor: no sensor has the number %zu when it fails, at "
                      "%g s; sensors.count is lower by one only if it is more "
                      "than this number",
                      (size_t)track->sensor, track->fails_at_s);
        } else if (fails) {
            status = murk_sequence_fail(s, step, t_s, track->sensor, err);
        }
        if (!status && track->keyframes > 0) {
            status =
                drift(s, scene, track, step, fmax(from_s, first_s), t_s, err);
        }
    }
    return status;
}

murk_sequence_hindsight murk_sequence_sum_up(const murk_sequence *s)
{
    murk_sequence_hindsight out = {0};
    for (size_t i = 0; i < s->rows; ++i) {
        const murk_sequence_row *row = &s->row[i];
        if (isfinite(row->in_sample)) {
            const double cost = isfinite(row->move_cost) ? row->move_cost : 0;
            ++out.steps;
            out.value += row->in_sample - cost;
            out.held_out += row->coverage.value - cost;
            out.upper += row->upper_free;
        }
    }
    out.gap = fmax(0, out.upper - out.value); /* below 0 by rounding alone */
    return out;
}

/* ---- pairs ---- */

/* Poses that differ by less are the same: a pose that is written to a file and
 * read differs by rounding, and a sensor is not moved by a micrometre. */
#define SAME_M   1e-6
#define SAME_RAD 1e-8

bool murk_sequence_is_same_pose(const murk_pose *a, const murk_pose *b)
{
    const murk_vec3 d = murk_sub(a->position, b->position);
    return a->type == b->type && murk_dot(d, d) <= SAME_M * SAME_M &&
           fabs(remainder(a->heading_rad - b->heading_rad, 2 * MURK_PI)) <=
               SAME_RAD &&
           fabs(a->tilt_rad - b->tilt_rad) <= SAME_RAD;
}

#define NONE SIZE_MAX

/* Which sensors of two plans belong together. */
typedef struct pairs {
    const murk_sequence_sensor *old; /* [n_old] */
    const murk_pose *new;            /* [n_new] */
    size_t n_old, n_new;
    size_t *old_of; /* [n_new]; NONE: none yet */
    bool *is_taken; /* [n_old] */
} pairs;

static void join(pairs *p, size_t new, size_t old)
{
    p->old_of[new] = old;
    p->is_taken[old] = true;
}

static void join_equal(pairs *p)
{
    for (size_t i = 0; i < p->n_new; ++i) {
        p->old_of[i] = NONE;
        for (size_t k = 0; k < p->n_old && p->old_of[i] == NONE; ++k) {
            if (!p->is_taken[k] &&
                murk_sequence_is_same_pose(&p->old[k].pose, &p->new[i])) {
                join(p, i, k);
            }
        }
    }
}

/* Joins the nearest two sensors of equal type that have no partner. False if
 * there are none. */
static bool join_nearest(pairs *p)
{
    double least2_m2 = INFINITY;
    size_t new = NONE, old = NONE;
    for (size_t i = 0; i < p->n_new; ++i) {
        for (size_t k = 0; k < p->n_old && p->old_of[i] == NONE; ++k) {
            const murk_vec3 d =
                murk_sub(p->old[k].pose.position, p->new[i].position);
            if (!p->is_taken[k] && p->old[k].pose.type == p->new[i].type &&
                murk_dot(d, d) < least2_m2) {
                least2_m2 = murk_dot(d, d);
                new = i;
                old = k;
            }
        }
    }
    if (new != NONE) {
        join(p, new, old);
    }
    return new != NONE;
}

/* ---- a plan ---- */

/* Notes what became of the sensors of the plan before, in their order, and
 * which sensors are new. Fills sensor[n_new]. */
static murk_status note_changes(murk_sequence *s, const pairs *p, size_t step,
                                double t_s, murk_sequence_sensor *sensor,
                                size_t *moved, murk_error *err)
{
    murk_status status = MURK_OK;
    /* Sensors without a partner in the new plan. */
    for (size_t k = 0; k < p->n_old && !status; ++k) {
        if (!p->is_taken[k]) {
            const murk_sequence_move move = {.step = step,
                                             .t_s = t_s,
                                             .sensor = p->old[k].number,
                                             .change = MURK_SENSOR_REMOVED,
                                             .from = p->old[k].pose};
            status = add_move(s, &move, err);
        }
    }
    /* Sensors of the new plan. */
    for (size_t i = 0; i < p->n_new && !status; ++i) {
        const size_t k = p->old_of[i];
        const bool is_added = k == NONE;
        murk_sequence_move move = {
            .step = step,
            .t_s = t_s,
            .change = is_added ? MURK_SENSOR_ADDED : MURK_SENSOR_MOVED,
            .sensor = is_added ? s->next++ : p->old[k].number,
            .to = p->new[i]};
        sensor[i] = (murk_sequence_sensor){move.sensor, p->new[i], false};
        if (!is_added) {
            move.from = p->old[k].pose;
        }
        if (is_added || !murk_sequence_is_same_pose(&move.from, &move.to)) {
            ++*moved;
            status = add_move(s, &move, err);
        } else {
            sensor[i].has_drifted = p->old[k].has_drifted;
        }
    }
    return status;
}

murk_status murk_sequence_take(murk_sequence *s, size_t step, double t_s,
                               const murk_pose *pose, size_t n, size_t *moved,
                               murk_error *err)
{
    murk_sequence_sensor *sensor = calloc(n + 1, sizeof *sensor);
    pairs p = {.old = s->sensor, .new = pose, .n_old = s->sensors, .n_new = n};
    p.old_of = calloc(n + 1, sizeof *p.old_of);
    p.is_taken = calloc(s->sensors + 1, sizeof *p.is_taken);
    murk_status status = MURK_NO_MEMORY;
    *moved = 0;
    /* Sensors that stayed, then the nearest pairs. */
    if (sensor && p.old_of && p.is_taken) {
        join_equal(&p);
        while (join_nearest(&p)) {
        }
        status = note_changes(s, &p, step, t_s, sensor, moved, err);
    } else {
        (void)no_memory(err);
    }
    free(p.old_of);
    free(p.is_taken);
    if (status) {
        free(sensor);
        return status;
    }
    free(s->sensor);
    s->sensor = sensor;
    s->sensors = n;
    return MURK_OK;
}
