/* What was asked of a placement, and the answer: what it sees, whether a better
 * one is possible, and what else was wanted. */
#include "report/answers.h"
#include "report/html.h"

#include <math.h>

/* Half a 95 % interval, in standard errors. */
#define HALF_INTERVAL 1.96

/* A gap to the bound that hardly matters: as wide as the error of a coverage
 * from some 600 photons. */
#define HARDLY 0.02

/* ---- what the results have ---- */

static bool has(const murk_yaml *plan, const char *path)
{
    return isfinite(murk_result_number(plan, path));
}

/* Says the words if there is a number under the path. */
static void say_if(FILE *to, const murk_yaml *plan, const char *path,
                   const char *words)
{
    if (has(plan, path)) {
        murk_report_say(to, plan, words);
    }
}

static bool is_judged_by(const murk_yaml *plan, const char *how)
{
    return murk_result_is(plan, "over", how);
}

static bool is_proven(const murk_yaml *plan)
{
    return murk_result_is(plan, "bound.proven_optimal", "true");
}

static bool is_of_matrix(const murk_yaml *plan)
{
    return murk_result_text(plan, "matrix.file") != NULL;
}

static bool has_targets(const murk_yaml *plan)
{
    return murk_result_number(plan, "targets.points") > 0;
}

/* What a plan is over: light, or targets that stand in place of photons. */
static const char *object_of(const murk_yaml *plan)
{
    return has_targets(plan) ? "targets" : "light";
}

/* Of the strict question, whose shares are of light that so many see. */
static void say_by_how_many(FILE *to, const murk_yaml *plan)
{
    say_if(to, plan, "target.at_least",
           ", each part by {target.at_least} or more");
}

/* ---- the question ---- */

static void ask_sensors(FILE *to, const murk_yaml *plan)
{
    const char *object = object_of(plan);
    /* how many sensors, by which of the three goals */
    if (has(plan, "target.asked")) {
        murk_report_say(to, plan, "How few sensors see {target.asked%}");
        fprintf(to, " of the %s", object);
        say_by_how_many(to, plan);
    } else if (has(plan, "budget.asked")) {
        murk_report_say(to, plan,
                        "Which sensors, whose costs come to at most "
                        "{budget.asked}");
        fprintf(to, ", see the most %s", object);
    } else {
        murk_report_say(to, plan, "Where should {sensors[sensor|sensors}");
        fprintf(to, " be to see the most %s", object);
    }
    /* of which places, in which conditions, with which knowledge */
    say_if(to, plan, "candidates.usable",
           ", of {candidates.usable#place that is free|places "
           "that are free}");
    if (is_judged_by(plan, "mean") || is_judged_by(plan, "worst") ||
        is_judged_by(plan, "regret")) {
        murk_report_say(to, plan, ", over {conditions[condition|conditions}");
        fputs(is_judged_by(plan, "mean") ? " in the mean"
              : is_judged_by(plan, "regret")
                  ? ", so that the largest regret (what is lost to the best "
                    "plan of a condition alone) is least"
                  : ", as judged by the worst of them",
              to);
    }
    fputs(murk_result_is(plan, "placement.knowledge", "explore")
              ? ", when only what has been reached so far is known?"
              : "?",
          to);
}

static void ask_plan(FILE *to, const murk_yaml *plan, bool is_made)
{
    fputs("<div><dt>Asked</dt><dd>", to);
    if (!is_made) {
        fprintf(to, "How much of the %s do these ", object_of(plan));
        murk_report_say(to, plan, "{sensors[sensor|sensors} see?");
    } else if (is_of_matrix(plan)) {
        murk_report_say(to, plan,
                        "Which {sensors[column|columns} of the matrix "
                        "{matrix.file$} cover the most of its "
                        "{matrix.rows#row|rows}, by their weights?");
    } else {
        ask_sensors(to, plan);
    }
    fputs("</dd></div>\n", to);
}

/* ---- the answer ---- */

/* The coverage that is to be quoted of a plan: held out, if that is known. */
static void find_quoted(double *value, double *standard_error,
                        const murk_yaml *plan)
{
    const bool is_held_out = has(plan, "coverage.held_out");
    *value = murk_result_number(plan, is_held_out ? "coverage.held_out"
                                                  : "coverage.in_sample");
    *standard_error = murk_result_number(
        plan, is_held_out ? "coverage.held_out_standard_error"
                          : "coverage.in_sample_standard_error");
    if (!is_held_out && !isfinite(*standard_error)) {
        *standard_error = murk_result_number(plan, "coverage.standard_error");
    }
}

/* Warns that few photons carry a map's share. */
static void say_thin(FILE *to, const murk_yaml *plan)
{
    if (!has(plan, "thin_map.photons")) {
        return;
    }
    murk_report_say(
        to, plan,
        " <strong>Beware:</strong> {thin_map.weight%} of this "
        "figure rests on {thin_map.photons#photon|photons} stored ");
    fputs(murk_result_is(plan, "thin_map.map", "volume") ? "in media"
                                                         : "on surfaces",
          to);
    say_if(to, plan, "thin_map.variance_share",
           ", and so does {thin_map.variance_share%} of its "
           "variance");
    fputs(". With placement.weights: {surface: 1, volume: 1} all photons count "
          "alike.",
          to);
}

/* What the share is of, and by which sample. */
static void say_sample(FILE *to, const murk_yaml *plan, bool is_made)
{
    const char *sample = has_targets(plan) ? "targets" : "photons";
    fprintf(to, " of the %s", object_of(plan));
    if (murk_result_number(plan, "weights_used.surface") > 0 &&
        murk_result_number(plan, "weights_used.volume") > 0) {
        murk_report_say(to, plan,
                        ", counting what lies on surfaces for "
                        "{weights_used.surface%} and what lies in media for "
                        "{weights_used.volume%}");
    }
    if (has(plan, "coverage.held_out")) {
        fprintf(to,
                ", measured with %s that had no say in the choice (held out)",
                sample);
    } else if (is_made && !murk_result_is(plan, "targets.listed", "true")) {
        fprintf(to, ", on the %s that the plan was chosen by: it may read high",
                sample);
    }
    fputc('.', to);
}

static void say_interval(FILE *to, const murk_yaml *plan, double value,
                         double error)
{
    fputs(" With 95 % confidence it is between ", to);
    murk_html_share(to, fmax(value - HALF_INTERVAL * error, 0), NAN);
    fputs(" and ", to);
    murk_html_share(to, fmin(value + HALF_INTERVAL * error, 1), NAN);
    fprintf(to, ": chance in the %s.",
            has_targets(plan) ? "targets drawn" : "photons");
}

static void answer_plan(FILE *to, const murk_yaml *plan, bool is_made)
{
    double value, error;
    find_quoted(&value, &error, plan);
    /* who sees how much */
    fputs(is_made ? "<div><dt>Answer</dt><dd>"
                  : "<div><dt>Answer</dt><dd>These ",
          to);
    murk_report_say(to, plan,
                    is_of_matrix(plan)
                        ? "{sensors[column covers|columns cover} <strong>"
                        : "{sensors[sensor sees|sensors see} <strong>");
    murk_html_share(to, value, error);
    fputs("</strong>", to);
    /* of what, by which sample, how certain */
    if (is_of_matrix(plan)) {
        fputs(" of the rows' weight.", to);
    } else {
        say_sample(to, plan, is_made);
        if (isfinite(error)) {
            say_interval(to, plan, value, error);
        }
    }
    if (is_judged_by(plan, "regret")) {
        murk_report_say(to, plan,
                        " This is the condition where the regret is largest: "
                        "{worst_condition$}.");
    }
    say_thin(to, plan);
    fputs("</dd></div>\n", to);
}

/* ---- its limits ---- */

/* Of a plan for the least largest regret. */
static void limit_regret(FILE *to, const murk_yaml *plan)
{
    const double bound = murk_result_number(plan, "regret.largest_at_least");
    murk_report_say(to, plan,
                    is_proven(plan) ? "No: its largest regret is "
                                      "<strong>{regret.largest%}</strong>"
                                    : "Perhaps: its largest regret is "
                                      "<strong>{regret.largest%}</strong>");
    fputs(murk_result_is(plan, "regret.measure", "relative")
              ? " of what the best plan found for that condition alone covers"
              : ", in coverage, to the best plan found for that condition "
                "alone",
          to);
    fputs(is_proven(plan) ? ", and no plan has less, which is proven"
                          : ", and no plan has less than ",
          to);
    if (!is_proven(plan)) { /* to the true optima, no plan wins */
        murk_html_share(to, fmax(bound, 0), NAN);
    }
    murk_report_say(to, plan,
                    ". To the true optima it is "
                    "{regret.largest_to_optimum_at_most%} at most.");
}

static void limit_gap(FILE *to, const murk_yaml *plan)
{
    const double gap = murk_result_number(plan, "bound.gap");
    fputs(gap < HARDLY ? "Hardly: " : "Perhaps: ", to);
    fputs(is_of_matrix(plan) ? "" : "on the sample that it was chosen by, ",
          to);
    murk_report_say(to, plan,
                    has(plan, "target.reached")
                        ? "the plan has {target.reached%}"
                        : "the plan has {coverage.in_sample%}");
    say_by_how_many(to, plan);
    murk_report_say(to, plan,
                    ", and no plan of this kind more than "
                    "<strong>{bound.upper%}</strong> (a gap of {bound.gap%}).");
}

static void limit_plan(FILE *to, const murk_yaml *plan)
{
    if (!has(plan, "bound.upper")) {
        return;
    }
    fputs("<div><dt>Could it be better?</dt><dd>", to);
    /* by the bound on the plan's own goal */
    if (is_judged_by(plan, "regret")) {
        limit_regret(to, plan);
    } else if (is_proven(plan)) {
        murk_report_say(
            to, plan,
            is_of_matrix(plan)
                ? "No: none of this kind covers more, which is proven."
                : "No: on the sample that it was chosen by, no plan of this "
                  "kind sees more, which is proven ({bound.upper%} there).");
    } else {
        limit_gap(to, plan);
    }
    if (has(plan, "coverage.ceiling")) {
        murk_report_say(to, plan,
                        is_of_matrix(plan)
                            ? " All columns together: {coverage.ceiling%}."
                            : " All places together: {coverage.ceiling%}.");
    }
    fputs("</dd></div>\n", to);
}

/* Target, budget, seeds: what else was wanted, and came out. */
static void extra_plan(FILE *to, const murk_yaml *plan)
{
    if (has(plan, "target.fewest_possible")) {
        fputs("<div><dt>Target</dt><dd>", to);
        if (has(plan, "target.confirmed")) {
            murk_report_say(
                to, plan, "Confirmed with a third map: {target.confirmed~}. ");
        }
        murk_report_say(to, plan,
                        "It cannot be met by fewer than "
                        "{target.fewest_possible}.</dd></div>\n");
    }
    say_if(to, plan, "budget.spent",
           "<div><dt>Budget</dt><dd>{budget.spent} of "
           "{budget.asked} spent.</dd></div>\n");
    say_if(to, plan, "repeat.runs",
           "<div><dt>With other seeds</dt><dd>The whole job with "
           "{repeat.runs#seed|seeds} gives, held out, "
           "{repeat.held_out.minimum%} to "
           "{repeat.held_out.maximum%}.</dd></div>\n");
}

void murk_answer_plan(FILE *to, const murk_yaml *plan, bool is_made)
{
    ask_plan(to, plan, is_made);
    answer_plan(to, plan, is_made);
    limit_plan(to, plan);
    extra_plan(to, plan);
}
