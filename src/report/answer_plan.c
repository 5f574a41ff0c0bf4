/* What was asked of a placement, and the answer: what it sees, whether a better
 * one is possible, and what else was wanted. */
#include "report/answers.h"
#include "report/html.h"

#include <math.h>

/* Half a 95 % interval, in standard errors. */
#define HALF_INTERVAL 1.96

/* A gap to the bound that hardly matters. */
#define HARDLY 0.02

static void strong_share(FILE *to, double share, double standard_error)
{
    fputs("<strong>", to);
    murk_page_share(to, share, standard_error);
    fputs("</strong>", to);
}

bool murk_answer_has_targets(const murk_yaml *plan)
{
    return murk_result_number(plan, "targets.points") > 0;
}

static const char *object_of(const murk_yaml *plan)
{
    return murk_answer_has_targets(plan) ? "targets" : "light";
}

static void ask_matrix(FILE *to, const murk_yaml *plan, double n)
{
    fputs("Which ", to);
    murk_page_count(to, n, "column", "columns");
    fputs(" of the matrix ", to);
    murk_page_text(to, murk_result_text(plan, "matrix.file"));
    fputs(" cover the most of its ", to);
    murk_page_count(to, murk_result_number(plan, "matrix.rows"), "row", "rows");
    fputs(", by their weights?", to);
}

/* Of the strict question, whose shares are of what so many see. */
static void say_by_how_many(FILE *to, const murk_yaml *plan)
{
    const double at_least = murk_result_number(plan, "target.at_least");
    if (isfinite(at_least)) {
        fputs(", each part by ", to);
        murk_page_number(to, at_least);
        fputs(" or more", to);
    }
}

static void ask_sensors(FILE *to, const murk_yaml *plan, double n)
{
    const double target = murk_result_number(plan, "target.asked");
    const double budget = murk_result_number(plan, "budget.asked");
    if (isfinite(target)) {
        fputs("How few sensors see ", to);
        murk_page_share(to, target, NAN);
        fprintf(to, " of the %s", object_of(plan));
        say_by_how_many(to, plan);
    } else if (isfinite(budget)) {
        fputs("Which sensors, whose costs come to at most ", to);
        murk_page_number(to, budget);
        fprintf(to, ", see the most %s", object_of(plan));
    } else {
        fputs("Where should ", to);
        murk_page_count(to, n, "sensor", "sensors");
        fprintf(to, " be to see the most %s", object_of(plan));
    }
    const double usable = murk_result_number(plan, "candidates.usable");
    if (isfinite(usable)) {
        fputs(", of ", to);
        murk_page_count(to, usable, "place that is free",
                        "places that are free");
    }
    if (murk_result_is(plan, "over", "mean") ||
        murk_result_is(plan, "over", "worst") ||
        murk_result_is(plan, "over", "regret")) {
        fputs(", over ", to);
        murk_page_count(to, (double)murk_result_count(plan, "conditions"),
                        "condition", "conditions");
        fputs(murk_result_is(plan, "over", "mean") ? " in the mean"
              : murk_result_is(plan, "over", "regret")
                  ? ", so that the largest regret (what is lost to the best "
                    "plan of a condition alone) is least"
                  : ", as judged by the worst of them",
              to);
    }
    if (murk_result_is(plan, "placement.knowledge", "explore")) {
        fputs(", when only what has been reached so far is known", to);
    }
    fputc('?', to);
}

static void ask_plan(FILE *to, const murk_yaml *plan, bool is_made)
{
    const double n = (double)murk_result_count(plan, "sensors");
    murk_page_line_begin(to, "Asked");
    if (!is_made) {
        fprintf(to, "How much of the %s do these ", object_of(plan));
        murk_page_count(to, n, "sensor", "sensors");
        fputs(" see?", to);
    } else if (murk_result_text(plan, "matrix.file")) {
        ask_matrix(to, plan, n);
    } else {
        ask_sensors(to, plan, n);
    }
    murk_page_line_end(to);
}

/* What is to be quoted of a plan: held out, where that is. */
static void quoted(double *value, double *standard_error, bool *is_held_out,
                   const murk_yaml *plan)
{
    *value = murk_result_number(plan, "coverage.held_out");
    *standard_error =
        murk_result_number(plan, "coverage.held_out_standard_error");
    *is_held_out = isfinite(*value);
    if (*is_held_out) {
        return;
    }
    *value = murk_result_number(plan, "coverage.in_sample");
    *standard_error =
        murk_result_number(plan, "coverage.in_sample_standard_error");
    if (!isfinite(*standard_error)) {
        *standard_error = murk_result_number(plan, "coverage.standard_error");
    }
}

/* What the share is of, where both maps are in it. */
static void say_weights(FILE *to, const murk_yaml *plan)
{
    const double surface = murk_result_number(plan, "weights_used.surface");
    const double volume = murk_result_number(plan, "weights_used.volume");
    if (surface > 0 && volume > 0) {
        fputs(", counting what lies on surfaces for ", to);
        murk_page_share(to, surface, NAN);
        fputs(" and what lies in media for ", to);
        murk_page_share(to, volume, NAN);
    }
}

/* That few photons carry a map's share. */
static void say_thin(FILE *to, const murk_yaml *plan)
{
    const double photons = murk_result_number(plan, "thin_map.photons");
    const bool is_volume = murk_result_is(plan, "thin_map.map", "volume");
    if (!isfinite(photons)) {
        return;
    }
    fputs(" <strong>Beware:</strong> ", to);
    murk_page_share(to, murk_result_number(plan, "thin_map.weight"), NAN);
    fputs(" of this figure rests on ", to);
    murk_page_count(to, photons, "photon stored ", "photons stored ");
    fputs(is_volume ? "in media" : "on surfaces", to);
    const double variance = murk_result_number(plan, "thin_map.variance_share");
    if (isfinite(variance)) {
        fputs(", and so does ", to);
        murk_page_share(to, variance, NAN);
        fputs(" of its variance", to);
    }
    fputs(". With placement.weights: {surface: 1, volume: 1} all photons count "
          "alike.",
          to);
}

static void answer_plan(FILE *to, const murk_yaml *plan, bool is_made)
{
    const bool is_matrix = murk_result_text(plan, "matrix.file") != NULL;
    const double n = (double)murk_result_count(plan, "sensors");
    double value, error;
    bool is_held_out;
    quoted(&value, &error, &is_held_out, plan);
    murk_page_line_begin(to, "Answer");
    fputs(is_made ? "" : "These ", to);
    if (is_matrix) {
        murk_page_count(to, n, "column covers ", "columns cover ");
    } else {
        murk_page_count(to, n, "sensor sees ", "sensors see ");
    }
    strong_share(to, value, error);
    if (is_matrix) {
        fputs(" of the rows' weight.", to);
    } else {
        const char *sample =
            murk_answer_has_targets(plan) ? "targets" : "photons";
        const bool is_list = murk_result_is(plan, "targets.listed", "true");
        fprintf(to, " of the %s", object_of(plan));
        say_weights(to, plan);
        if (is_held_out) {
            fprintf(to,
                    ", measured with %s that had no say in the choice (held "
                    "out)",
                    sample);
        } else if (is_made && !is_list) {
            fprintf(to,
                    ", on the %s that the plan was chosen by: it may read high",
                    sample);
        }
        fputc('.', to);
    }
    if (!is_matrix && isfinite(error)) {
        fputs(" With 95 % confidence it is between ", to);
        murk_page_share(to, fmax(value - HALF_INTERVAL * error, 0), NAN);
        fputs(" and ", to);
        murk_page_share(to, fmin(value + HALF_INTERVAL * error, 1), NAN);
        fprintf(to, ": chance in the %s.",
                murk_answer_has_targets(plan) ? "targets drawn" : "photons");
    }
    if (murk_result_is(plan, "over", "regret")) {
        fputs(" This is the condition where the regret is largest: ", to);
        murk_page_text(to, murk_result_text(plan, "worst_condition"));
        fputc('.', to);
    }
    say_thin(to, plan);
    murk_page_line_end(to);
}

/* Of a plan for the least largest regret. */
static void limit_regret(FILE *to, const murk_yaml *plan)
{
    const double bound = murk_result_number(plan, "regret.largest_at_least");
    const double min = fmax(bound, 0); /* to the true optima, no plan wins */
    const bool is_proven = murk_result_is(plan, "bound.proven_optimal", "true");
    fputs(is_proven ? "No: its largest regret is "
                    : "Perhaps: its largest "
                      "regret is ",
          to);
    strong_share(to, murk_result_number(plan, "regret.largest"), NAN);
    fputs(murk_result_is(plan, "regret.measure", "relative")
              ? " of what the best plan found for that condition alone covers"
              : ", in coverage, to the best plan found for that condition "
                "alone",
          to);
    fputs(is_proven ? ", and no plan has less, which is proven"
                    : ", and no plan has less than ",
          to);
    if (!is_proven) {
        murk_page_share(to, min, NAN);
    }
    fputs(". To the true optima it is ", to);
    murk_page_share(
        to, murk_result_number(plan, "regret.largest_to_optimum_at_most"), NAN);
    fputs(" at most.", to);
}

static void limit_plan(FILE *to, const murk_yaml *plan)
{
    const double upper = murk_result_number(plan, "bound.upper");
    const bool is_matrix = murk_result_text(plan, "matrix.file") != NULL;
    if (!isfinite(upper)) {
        return;
    }
    murk_page_line_begin(to, "Could it be better?");
    if (murk_result_is(plan, "over", "regret")) {
        limit_regret(to, plan);
    } else if (murk_result_is(plan, "bound.proven_optimal", "true")) {
        fputs(is_matrix ? "No: none of this kind covers more, which is proven."
                        : "No: on the sample that it was chosen by, no plan of "
                          "this kind sees more, which is proven (",
              to);
        if (!is_matrix) {
            murk_page_share(to, upper, NAN);
            fputs(" there).", to);
        }
    } else {
        const double gap = murk_result_number(plan, "bound.gap");
        fputs(gap < HARDLY ? "Hardly: " : "Perhaps: ", to);
        if (!is_matrix) {
            fputs("on the sample that it was chosen by, ", to);
        }
        fputs("the plan has ", to);
        const double reached = murk_result_number(plan, "target.reached");
        murk_page_share(to,
                        isfinite(reached)
                            ? reached
                            : murk_result_number(plan, "coverage.in_sample"),
                        NAN);
        say_by_how_many(to, plan);
        fputs(", and no plan of this kind more than ", to);
        strong_share(to, upper, NAN);
        fputs(" (a gap of ", to);
        murk_page_share(to, gap, NAN);
        fputs(").", to);
    }
    const double ceiling = murk_result_number(plan, "coverage.ceiling");
    if (isfinite(ceiling)) {
        fputs(is_matrix ? " All columns together: " : " All places together: ",
              to);
        murk_page_share(to, ceiling, NAN);
        fputc('.', to);
    }
    murk_page_line_end(to);
}

/* Target, budget, seeds: what else was wanted, and came out. */
static void extra_plan(FILE *to, const murk_yaml *plan)
{
    const double confirmed = murk_result_number(plan, "target.confirmed");
    const double fewest = murk_result_number(plan, "target.fewest_possible");
    const double spent = murk_result_number(plan, "budget.spent");
    const double runs = murk_result_number(plan, "repeat.runs");
    if (isfinite(fewest)) {
        murk_page_line_begin(to, "Target");
        if (isfinite(confirmed)) {
            fputs("Confirmed with a third map: ", to);
            murk_page_share(
                to, confirmed,
                murk_result_number(plan, "target.confirmed_standard_error"));
            fputs(". ", to);
        }
        fputs("It cannot be met by fewer than ", to);
        murk_page_number(to, fewest);
        fputc('.', to);
        murk_page_line_end(to);
    }
    if (isfinite(spent)) {
        murk_page_line_begin(to, "Budget");
        murk_page_number(to, spent);
        fputs(" of ", to);
        murk_page_number(to, murk_result_number(plan, "budget.asked"));
        fputs(" spent.", to);
        murk_page_line_end(to);
    }
    if (isfinite(runs)) {
        murk_page_line_begin(to, "With other seeds");
        fputs("The whole job with ", to);
        murk_page_count(to, runs, "seed", "seeds");
        fputs(" gives, held out, ", to);
        murk_page_share(to, murk_result_number(plan, "repeat.held_out.minimum"),
                        NAN);
        fputs(" to ", to);
        murk_page_share(to, murk_result_number(plan, "repeat.held_out.maximum"),
                        NAN);
        fputc('.', to);
        murk_page_line_end(to);
    }
}

void murk_answer_plan(FILE *to, const murk_yaml *plan, bool is_made)
{
    ask_plan(to, plan, is_made);
    answer_plan(to, plan, is_made);
    limit_plan(to, plan);
    extra_plan(to, plan);
}
