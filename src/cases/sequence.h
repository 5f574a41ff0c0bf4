/* Plans that follow each other in time: which sensor of a plan is which of the
 * plan before, what moved, and a row of figures for each step.
 *
 * Sensors of the scene's `fixed` are not part of it: they have the numbers
 * before `first`, the number of the first sensor that is planned. */
#ifndef MURK_CASES_SEQUENCE_H
#define MURK_CASES_SEQUENCE_H

#include "base/stats.h"
#include "base/status.h"
#include "scene/timeline.h"
#include "sensing/sensor.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum murk_sequence_change {
    MURK_SENSOR_ADDED,
    MURK_SENSOR_MOVED,
    MURK_SENSOR_REMOVED,
    MURK_SENSOR_FAILED,
    MURK_SENSOR_DRIFTED
} murk_sequence_change;

/* A change of one sensor at a step. */
typedef struct murk_sequence_move {
    size_t step;
    double t_s;
    uint64_t sensor; /* number, which a sensor keeps when it moves */
    murk_sequence_change change;
    murk_pose from, to; /* `from` has no meaning for ADDED, `to` none for
                         * REMOVED and FAILED */
} murk_sequence_move;

/* A sensor of the last plan. */
typedef struct murk_sequence_sensor {
    uint64_t number;
    murk_pose pose;
    bool has_drifted; /* since it was placed or moved: the pose is then that of
                       * no candidate */
} murk_sequence_sensor;

/* The figures of a step; numbers that a step does not have are NaN. */
typedef struct murk_sequence_row {
    size_t step;
    double t_s;
    uint64_t photons_traced, photons_kept; /* emitted photons */
    uint64_t pairs_looked, pairs_kept;     /* sightlines of candidates */
    murk_estimate coverage;
    double upper, cost;
    /* In sample: the coverage; the bound on any plan of as many sensors at this
     * step alone, without a rule on moves. By the rule on moves: the moves from
     * the plan before, and their cost as coverage. */
    double in_sample, upper_free, moves, move_cost;
    size_t moved; /* sensors of the plan that were not in the plan before */
    double seconds;
    char failed[256]; /* why the step has no plan; empty: it has one */
    size_t sensors;   /* of the plan, with the fixed ones */
    char cut_by[16];  /* what ended the search; empty: nothing did */
} murk_sequence_row;

typedef struct murk_sequence {
    murk_sequence_row *row; /* [rows] */
    size_t rows;
    murk_sequence_move *move; /* [moves], in the order of steps and sensors */
    size_t moves;
    murk_sequence_sensor *sensor; /* [sensors] of the last plan */
    size_t sensors;
    uint64_t next; /* number of the next sensor that is added */
} murk_sequence;

/* The sequence compared with the best that plans could have reached with
 * knowledge of all steps: sums over the steps that have coverage. */
typedef struct murk_sequence_hindsight {
    size_t steps;
    double value, held_out; /* coverage less the cost of moves, in sample and on
                             * the second maps, if there are any */
    double upper; /* no sequence of plans of as many sensors has a larger value
                   * in sample, even if all may move at each step at no cost */
    double gap;   /* upper - value */
} murk_sequence_hindsight;

murk_sequence_hindsight murk_sequence_sum_up(const murk_sequence *sequence);

void murk_sequence_init(murk_sequence *out, uint64_t first);
void murk_sequence_release(murk_sequence *sequence);

/* Begins with the sensors pose[n] of a plan that is in force before the first
 * step, of which some have drifted; none of them is added by a step. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_sequence_begin(murk_sequence *sequence, const murk_pose *pose,
                                const bool *has_drifted, size_t n,
                                murk_error *err);

/* Appends a row. Fails with MURK_NO_MEMORY. */
murk_status murk_sequence_add(murk_sequence *sequence,
                              const murk_sequence_row *row, murk_error *err);

/* Removes a sensor that has failed at the step. Does nothing if there is none
 * of that number. Fails with MURK_NO_MEMORY. */
murk_status murk_sequence_fail(murk_sequence *sequence, size_t step, double t_s,
                               uint64_t number, murk_error *err);

/* Displaces a sensor until the step. Does nothing if there is none of that
 * number, or if the pose stays. Fails with MURK_NO_MEMORY. */
murk_status murk_sequence_drift(murk_sequence *sequence, size_t step,
                                double t_s, uint64_t number,
                                const murk_drift *by, murk_error *err);

/* Lets the sensors fail as the tracks of the timeline say after the time from_s
 * and until the step, and drift in the same time, as far as it belongs to the
 * timeline. warns: a warning tells of a sensor that fails at the step but does
 * not exist. Fails with MURK_NO_MEMORY. */
murk_status murk_sequence_advance(murk_sequence *sequence,
                                  const murk_scene_desc *scene, double from_s,
                                  size_t step, bool warns, murk_error *err);

/* True if two poses differ by no more than the rounding of files. */
bool murk_sequence_is_same_pose(const murk_pose *a, const murk_pose *b);

/* Makes pose[n] the sensors of the step. A sensor at the pose of one of the
 * plan before, but for rounding, is this sensor. Of the others, the pair of
 * equal type at the least distance is a sensor that moved, and so on; what is
 * left over was added or removed. *moved becomes the number of sensors that
 * were added or moved. Fails with MURK_NO_MEMORY. */
murk_status murk_sequence_take(murk_sequence *sequence, size_t step, double t_s,
                               const murk_pose *pose, size_t n, size_t *moved,
                               murk_error *err);

#endif
