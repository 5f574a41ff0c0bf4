/* Lists the fields of follow.json, follow.csv and moves.csv, and prints the
 * summary of murk follow. */
#include "results/follow.h"

#include "results/coverage.h"
#include "results/summary.h"

#include <math.h>
#include <string.h>

void murk_results_list_follow_row(murk_results_fields *f, const void *of,
                                  size_t i)
{
    const murk_sequence *s = of;
    const murk_sequence_row *r = s ? &s->row[i] : NULL;
    MURK_COUNT(f, "step", "number, from 0", r->step);
    MURK_NUMBER(f, "t_s", "s", "time of the timeline", r->t_s);
    MURK_COUNT(f, "photons_traced",
               "photons that were traced, of lights that are on",
               r->photons_traced);
    MURK_COUNT(f, "photons_kept",
               "photons that were taken over from the step before",
               r->photons_kept);
    MURK_COUNT(f, "pairs_looked",
               "sightlines between candidates and photons that were tested",
               r->pairs_looked);
    MURK_COUNT(f, "pairs_kept",
               "sightlines whose clarity was taken over from the step before",
               r->pairs_kept);
    /* The plan. */
    MURK_NUMBER(f, "coverage", "1",
                "of the plan, on a second map if there is one",
                r->coverage.value);
    MURK_NUMBER(f, "standard_error", "1", "of coverage",
                r->coverage.standard_error);
    MURK_NUMBER(f, "upper", "1",
                "bound of the coverage in sample; with a rule on moves, of the "
                "coverage less their cost of plans that keep it",
                r->upper);
    MURK_COUNT(f, "moved", "sensors that were not in the plan before",
               r->moved);
    MURK_NUMBER(f, "seconds", "s", "of the step", r->seconds);
    MURK_NUMBER(f, "cost", "", "of the sensors", r->cost);
    MURK_TEXT(f, "failed", "why the step has no plan", r->failed);
    MURK_COUNT(f, "sensors", "of the plan, with the fixed ones", r->sensors);
    MURK_TEXT(f, "cut_by", "what ended the search, as in plan.json", r->cut_by);
    /* The rule on moves, and hindsight. */
    MURK_NUMBER(f, "in_sample", "1",
                "coverage on the light that chose the plan", r->in_sample);
    MURK_NUMBER(
        f, "upper_free", "1",
        "bound of in_sample at this step alone, without a rule on moves",
        r->upper_free);
    MURK_NUMBER(f, "moves", "",
                "with a rule on moves: pairs of a sensor that left the plan "
                "before and one that came",
                r->moves);
    MURK_NUMBER(f, "move_cost", "1", "cost of these moves, as coverage",
                r->move_cost);
}

/* ---- the start of a step ---- */

void murk_results_list_start(murk_results_fields *f, const void *of, size_t i)
{
    const murk_follow_results *r = of;
    const murk_sequence_sensor *sensor = r ? &r->sequence->sensor[i] : NULL;
    const murk_sensor_results one = {
        .scene = r ? r->scene : NULL, .pose = r ? &sensor->pose : NULL, .n = 1};
    murk_results_list_place(f, r ? &one : NULL, 0);
    MURK_COUNT(f, "drifted",
               "1: the pose is that of no candidate, and the sensor may stay",
               sensor->has_drifted);
}

/* ---- moves ---- */

static const char *change_of(const murk_sequence_move *m)
{
    static const char *const words[] = {[MURK_SENSOR_ADDED] = "added",
                                        [MURK_SENSOR_MOVED] = "moved",
                                        [MURK_SENSOR_REMOVED] = "removed",
                                        [MURK_SENSOR_FAILED] = "failed",
                                        [MURK_SENSOR_DRIFTED] = "drifted"};
    return words[m->change];
}

/* The position in the coordinates of the user; NaN if there is none. */
static murk_vec3 place_of(const murk_follow_results *r, const murk_pose *pose,
                          bool is_there)
{
    return is_there ? murk_scene_user(r->scene, pose->position)
                    : murk_vec(NAN, NAN, NAN);
}

static murk_vec3 from_of(const murk_follow_results *r, size_t i)
{
    const murk_sequence_move *m = &r->sequence->move[i];
    return place_of(r, &m->from, m->change != MURK_SENSOR_ADDED);
}

static bool goes_somewhere(const murk_sequence_move *m)
{
    return m->change != MURK_SENSOR_REMOVED && m->change != MURK_SENSOR_FAILED;
}

static murk_vec3 to_of(const murk_follow_results *r, size_t i)
{
    const murk_sequence_move *m = &r->sequence->move[i];
    return place_of(r, &m->to, goes_somewhere(m));
}

/* Degrees of an angle of the new pose; NaN without one, or if the type sees all
 * round. */
static double degrees_of(const murk_follow_results *r,
                         const murk_sequence_move *m, double angle_rad)
{
    return goes_somewhere(m) &&
                   r->scene->sensors.type[m->to.type].view != MURK_VIEW_SPHERE
               ? angle_rad * (180 / MURK_PI)
               : NAN;
}

void murk_results_list_move(murk_results_fields *f, const void *of, size_t i)
{
    const murk_follow_results *r = of;
    const murk_sequence_move *m = r ? &r->sequence->move[i] : NULL;
    MURK_COUNT(f, "step", "number, from 0", m->step);
    MURK_NUMBER(f, "t_s", "s", "time of the timeline", m->t_s);
    MURK_COUNT(f, "sensor",
               "number, which a sensor keeps when it moves; those of the first "
               "plan follow those of sensors.fixed",
               m->sensor);
    MURK_TEXT(f, "change", "added, moved, removed, failed or drifted",
              change_of(m));
    MURK_TEXT(
        f, "type", "of the sensor",
        r->scene->sensors.type[goes_somewhere(m) ? m->to.type : m->from.type]
            .name);
    /* From and to, in the coordinates of the scene file. */
    MURK_NUMBER(f, "from_x_m", "m", "where it was", from_of(r, i).x);
    MURK_NUMBER(f, "from_y_m", "m", "", from_of(r, i).y);
    MURK_NUMBER(f, "from_z_m", "m", "", from_of(r, i).z);
    MURK_NUMBER(f, "to_x_m", "m", "where it is", to_of(r, i).x);
    MURK_NUMBER(f, "to_y_m", "m", "", to_of(r, i).y);
    MURK_NUMBER(f, "to_z_m", "m", "", to_of(r, i).z);
    MURK_NUMBER(f, "heading_deg", "degrees", "where it looks now",
                degrees_of(r, m, m->to.heading_rad));
    MURK_NUMBER(f, "tilt_deg", "degrees", "where it looks now",
                degrees_of(r, m, m->to.tilt_rad));
}

/* ---- follow.json ---- */

static size_t count_failed(const murk_sequence *s)
{
    size_t failed = 0;
    for (size_t i = 0; i < s->rows; ++i) {
        failed += s->row[i].failed[0] != '\0';
    }
    return failed;
}

/* The object "hindsight". */
static void list_hindsight(murk_results_fields *f, const void *of)
{
    const murk_follow_results *r = of;
    const murk_sequence_hindsight h =
        r ? murk_sequence_sum_up(r->sequence) : (murk_sequence_hindsight){0};
    MURK_COUNT(f, "steps", "that have coverage", h.steps);
    MURK_NUMBER(f, "value", "1",
                "sum over these steps of in_sample less the cost of moves",
                h.value);
    MURK_NUMBER(f, "mean_value", "1", "of a step", h.value / (double)h.steps);
    MURK_NUMBER(f, "mean_held_out", "1",
                "the same of the coverage on the second maps",
                h.held_out / (double)h.steps);
    MURK_NUMBER(f, "upper", "1",
                "no plans have a larger value, whatever they know and move: "
                "sum of upper_free, bounds of each step alone without a rule "
                "on moves",
                h.upper);
    MURK_NUMBER(f, "gap", "1", "upper - value", h.gap);
}

/* True if the sequence is compared with hindsight: not with a target, for which
 * steps have numbers of sensors of their own. */
static bool has_hindsight(const murk_follow_results *r)
{
    return !(r->scene->sensors.target > 0) &&
           murk_sequence_sum_up(r->sequence).steps > 0;
}

void murk_results_list_follow(murk_results_fields *f, const void *of)
{
    const murk_follow_results *r = of;
    murk_results_list_head(f, r ? r->scene : NULL);
    MURK_COUNT(f, "steps_asked", "of the timeline", r->steps);
    MURK_COUNT(f, "steps_done", "those with a row", r->sequence->rows);
    MURK_COUNT(f, "steps_failed", "of them, without a plan",
               count_failed(r->sequence));
    MURK_COUNT(f, "moves", "changes of sensors, in moves.csv",
               r->sequence->moves);
    if (MURK_LISTED_IF(f, has_hindsight(r))) {
        MURK_OBJECT(f, "hindsight", "what knowledge of all steps could add",
                    list_hindsight, r);
    }
    MURK_LIST(f, "steps", "a row a step, as in follow.csv",
              murk_results_list_follow_row, r->sequence, r->sequence->rows);
}

/* ---- lines ---- */

/* Prints how many steps were made, between which values the coverage lies, and
 * how often a sensor moved. */
void murk_print_follow(const void *of)
{
    const murk_follow_results *r = of;
    const murk_sequence *s = r->sequence;
    const murk_sequence_row *lowest = NULL, *highest = NULL;
    size_t moved = 0, late = 0;
    /* The first step places all sensors, which is no move. */
    for (size_t i = 0; i < s->rows; ++i) {
        const murk_sequence_row *row = &s->row[i];
        moved += i > 0 ? row->moved : 0;
        late += strcmp(row->cut_by, "time") == 0;
        if (isfinite(row->coverage.value)) {
            lowest = !lowest || row->coverage.value < lowest->coverage.value
                         ? row
                         : lowest;
            highest = !highest || row->coverage.value > highest->coverage.value
                          ? row
                          : highest;
        }
    }
    murk_print("steps       %zu of %zu, of which %zu kept from before and %zu "
               "failed\n",
               s->rows, r->steps, r->reused, count_failed(s));
    if (lowest) {
        murk_print("coverage    %.4f +- %.4f at %.6g s, the lowest, to %.4f +- "
                   "%.4f at %.6g s\n",
                   lowest->coverage.value, lowest->coverage.standard_error,
                   lowest->t_s, highest->coverage.value,
                   highest->coverage.standard_error, highest->t_s);
    }
    murk_print("moved       %zu times a sensor after the first step\n", moved);
    if (late > 0) {
        murk_print("time limit  ended the search of %zu steps: another run may "
                   "give other plans\n",
                   late);
    }
    if (has_hindsight(r)) {
        const murk_sequence_hindsight h = murk_sequence_sum_up(s);
        const double n = (double)h.steps;
        murk_print("hindsight   %.4f a step in sample, less moves; plans that "
                   "know all steps reach no more than %.4f\n",
                   h.value / n, h.upper / n);
    }
}
