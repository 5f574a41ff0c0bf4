/* Sensors of plans that follow each other: which is which, what moved, and that
 * numbers are kept. Nothing here is random. */
#include "cases/sequence.h"
#include "check.h"

#include <math.h>

static murk_pose at(double x, uint32_t type)
{
    return (murk_pose){.type = type, .position = {x, 0, 0}};
}

static void take(murk_sequence *s, size_t step, const murk_pose *pose, size_t n,
                 size_t want_moved)
{
    size_t moved = 99;
    CHECK(murk_sequence_take(s, step, (double)step, pose, n, &moved, NULL) ==
          MURK_OK);
    CHECK(moved == want_moved);
    CHECK(s->sensors == n);
}

static void test_sensors_keep_their_numbers(void)
{
    murk_sequence s;
    murk_sequence_init(&s, 2); /* two fixed sensors before them */
    const murk_pose first[] = {at(0, 0), at(5, 0), at(9, 1)};
    take(&s, 0, first, 3, 3);
    CHECK(s.moves == 3 && s.move[0].change == MURK_SENSOR_ADDED);
    CHECK(s.sensor[0].number == 2 && s.sensor[2].number == 4);
    /* In another order, one of them moved: it is the nearest of its type. */
    const murk_pose second[] = {at(9, 1), at(8, 0), at(0, 0)};
    take(&s, 1, second, 3, 1);
    CHECK(s.moves == 4 && s.move[3].change == MURK_SENSOR_MOVED);
    CHECK(s.move[3].sensor == 3 && s.move[3].step == 1);
    CHECK(s.move[3].from.position.x == 5 && s.move[3].to.position.x == 8);
    CHECK(s.sensor[0].number == 4 && s.sensor[1].number == 3 &&
          s.sensor[2].number == 2);
    /* Nothing changes. */
    take(&s, 2, second, 3, 0);
    CHECK(s.moves == 4);
    murk_sequence_release(&s);
}

/* A plan in force before the first step has the first numbers; nothing of it is
 * added by a step. */
static void test_begins_with_a_plan(void)
{
    murk_sequence s;
    murk_sequence_init(&s, 1);
    const murk_pose start[] = {at(0, 0), at(4, 0)},
                    first[] = {at(5, 0), at(0, 0), at(9, 1)};
    const bool has_drifted[] = {false, true};
    CHECK(murk_sequence_begin(&s, start, has_drifted, 2, NULL) == MURK_OK);
    CHECK(!s.sensor[0].has_drifted && s.sensor[1].has_drifted);
    CHECK(s.moves == 0 && s.sensors == 2 && s.sensor[1].number == 2);
    take(&s, 0, first, 3, 2);
    CHECK(s.moves == 2 && s.move[0].sensor == 2 &&
          s.move[0].change == MURK_SENSOR_MOVED);
    CHECK(s.move[1].sensor == 3 && s.move[1].change == MURK_SENSOR_ADDED);
    murk_sequence_release(&s);
}

/* The nearest pair is joined first, whatever the order: 0 -> 1 and 4 -> 9, not
 * 4 -> 1. */
static void test_nearest_pairs(void)
{
    murk_sequence s;
    murk_sequence_init(&s, 0);
    const murk_pose first[] = {at(0, 0), at(4, 0)},
                    second[] = {at(9, 0), at(1, 0)};
    take(&s, 0, first, 2, 2);
    take(&s, 1, second, 2, 2);
    CHECK(s.sensor[0].number == 1 && s.sensor[1].number == 0);
    murk_sequence_release(&s);
}

/* A sensor that drifts is no sensor that moves, and stays marked until it is
 * moved. Rounding is no move. */
static void test_drift(void)
{
    murk_sequence s;
    murk_sequence_init(&s, 3);
    const murk_drift by = {{0.5, 0, -1}, 0.25, 3}, none = {0};
    const murk_pose first[] = {at(0, 0), at(7, 0)},
                    second[] = {at(7, 0),
                                {.position = {0.5 + 1e-9, 0, -1},
                                 .heading_rad = 0.25 + 2 * MURK_PI,
                                 .tilt_rad = MURK_PI / 2}},
                    third[] = {at(7, 0), at(1, 0)};
    take(&s, 0, first, 2, 2);
    CHECK(murk_sequence_drift(&s, 1, 10, 3, &by, NULL) == MURK_OK);
    CHECK(murk_sequence_drift(&s, 1, 10, 4, &none, NULL) == MURK_OK);
    CHECK(murk_sequence_drift(&s, 1, 10, 8, &by, NULL) == MURK_OK);
    CHECK(s.moves == 3 && s.move[2].change == MURK_SENSOR_DRIFTED);
    CHECK(s.move[2].sensor == 3 && s.move[2].step == 1 && s.move[2].t_s == 10);
    CHECK(s.move[2].from.position.x == 0 && s.move[2].to.position.x == 0.5 &&
          s.move[2].to.position.z == -1 && s.move[2].to.heading_rad == 0.25);
    CHECK(s.sensor[0].has_drifted && !s.sensor[1].has_drifted);
    /* The sensor stays where it has drifted to, then it moves. */
    take(&s, 1, second, 2, 0);
    CHECK(s.sensor[1].number == 3 && s.sensor[1].has_drifted);
    CHECK(s.sensor[1].pose.position.x == 0.5 + 1e-9);
    take(&s, 2, third, 2, 1);
    CHECK(s.sensor[1].number == 3 && !s.sensor[1].has_drifted);
    CHECK(s.moves == 4 && s.move[3].change == MURK_SENSOR_MOVED);
    murk_sequence_release(&s);
}

static void test_other_types_are_added_and_removed(void)
{
    murk_sequence s;
    murk_sequence_init(&s, 0);
    const murk_pose first[] = {at(0, 0)}, second[] = {at(0, 1)};
    take(&s, 0, first, 1, 1);
    take(&s, 1, second, 1, 1);
    CHECK(s.moves == 3);
    CHECK(s.move[1].change == MURK_SENSOR_REMOVED && s.move[1].sensor == 0);
    CHECK(s.move[2].change == MURK_SENSOR_ADDED && s.move[2].sensor == 1);
    /* The same pose with another heading is another one. */
    murk_pose turned = second[0];
    turned.heading_rad = 1;
    take(&s, 2, &turned, 1, 1);
    CHECK(s.move[3].change == MURK_SENSOR_MOVED && s.move[3].sensor == 1);
    /* No plan: all are removed. */
    take(&s, 3, NULL, 0, 0);
    CHECK(s.move[4].change == MURK_SENSOR_REMOVED);
    murk_sequence_release(&s);
}

static void test_failures(void)
{
    murk_sequence s;
    murk_sequence_init(&s, 0);
    const murk_pose first[] = {at(0, 0), at(5, 0)};
    take(&s, 0, first, 2, 2);
    CHECK(murk_sequence_fail(&s, 1, 1, 7, NULL) == MURK_OK);
    CHECK(s.moves == 2); /* there is no sensor 7 */
    CHECK(murk_sequence_fail(&s, 1, 1, 0, NULL) == MURK_OK);
    CHECK(s.sensors == 1 && s.sensor[0].number == 1);
    CHECK(s.moves == 3 && s.move[2].change == MURK_SENSOR_FAILED);
    CHECK(s.move[2].from.position.x == 0);
    CHECK(murk_sequence_fail(&s, 2, 2, 0, NULL) == MURK_OK);
    CHECK(s.moves == 3); /* it fails once */
    /* A sensor at the place of one that has failed is a new one. */
    take(&s, 2, first, 2, 1);
    CHECK(s.sensor[0].number == 2 && s.sensor[1].number == 1);
    murk_sequence_release(&s);
}

/* Sums over the steps that have coverage: a dark step has none. */
static void test_hindsight(void)
{
    murk_sequence s;
    murk_sequence_init(&s, 0);
    const murk_sequence_row rows[] = {{.in_sample = .8,
                                       .coverage = {.75, 0},
                                       .upper_free = .9,
                                       .move_cost = NAN},
                                      {.in_sample = NAN,
                                       .coverage = {NAN, NAN},
                                       .upper_free = NAN,
                                       .move_cost = NAN},
                                      {.in_sample = .5,
                                       .coverage = {.5, 0},
                                       .upper_free = .625,
                                       .move_cost = .25}};
    for (size_t i = 0; i < 3; ++i) {
        CHECK(murk_sequence_add(&s, &rows[i], NULL) == MURK_OK);
    }
    const murk_sequence_hindsight h = murk_sequence_sum_up(&s);
    CHECK(h.steps == 2);
    CHECK(fabs(h.value - 1.05) < 1e-15 && fabs(h.held_out - 1) < 1e-15);
    CHECK(fabs(h.upper - 1.525) < 1e-15 && fabs(h.gap - .475) < 1e-15);
    murk_sequence_release(&s);
}

int main(void)
{
    test_hindsight();
    test_begins_with_a_plan();
    test_sensors_keep_their_numbers();
    test_nearest_pairs();
    test_drift();
    test_other_types_are_added_and_removed();
    test_failures();
    return check_done();
}
