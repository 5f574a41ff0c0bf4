/* Follows the sensors of plans from step to step. Plans have few sensors, so
 * pairs are found by comparing each sensor with each. */
#include "cases/sequence.h"

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

murk_status murk_sequence_fail(murk_sequence *s, size_t step, double t_s,
                               uint64_t number, murk_error *err)
{
    size_t i = 0;
    while (i < s->sensors && s->sensor[i].number != number) {
        ++i;
    }
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

/* ---- pairs ---- */

static bool is_same(const murk_pose *a, const murk_pose *b)
{
    return a->type == b->type && a->position.x == b->position.x &&
           a->position.y == b->position.y && a->position.z == b->position.z &&
           a->heading_rad == b->heading_rad && a->tilt_rad == b->tilt_rad;
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
            if (!p->is_taken[k] && is_same(&p->old[k].pose, &p->new[i])) {
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
        sensor[i] = (murk_sequence_sensor){move.sensor, p->new[i]};
        if (!is_added) {
            move.from = p->old[k].pose;
        }
        if (is_added || !is_same(&move.from, &move.to)) {
            ++*moved;
            status = add_move(s, &move, err);
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
