/* Repeated placements: fields of JSON, columns of CSV, and lines of the
 * summary. */
#include "results/repeat.h"

#include "results/summary.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define CONFIDENCE 0.95 /* of the limits of murk_gap, cases/repeat.h */

/* ---- fields ---- */

static void list_spread(murk_results_fields *f, const void *of)
{
    const murk_spread *s = of;
    MURK_NUMBER(f, "median", "", "over the runs", s->median);
    MURK_NUMBER(f, "minimum", "", "over the runs", s->min);
    MURK_NUMBER(f, "maximum", "", "over the runs", s->max);
}

static void list_upper(murk_results_fields *f, const void *of)
{
    const murk_repeat_summary *s = of;
    list_spread(f, s ? &s->upper : NULL);
    MURK_NUMBER(f, "mean", "1", "over the runs", s->upper_mean.value);
    MURK_NUMBER(f, "standard_error", "1", "of the mean",
                s->upper_mean.standard_error);
}

static void list_plan(murk_results_fields *f, const void *of)
{
    const murk_estimate *plan = of;
    MURK_NUMBER(f, "coverage", "1",
                "of the first plan, by maps that did not choose it",
                plan->value);
    MURK_NUMBER(f, "standard_error", "1", "of coverage", plan->standard_error);
}

static void list_gap(murk_results_fields *f, const void *of)
{
    const murk_gap *gap = of;
    MURK_NUMBER(f, "value", "1", "statistical gap to the best plan",
                gap->value);
    MURK_NUMBER(f, "lower", "1", "confidence limit", gap->lower);
    MURK_NUMBER(f, "upper", "1", "confidence limit", gap->upper);
    MURK_NUMBER(f, "confidence", "1", "of the limits", CONFIDENCE);
    MURK_COUNT(f, "runs", "that tell of the gap", gap->runs);
}

void murk_results_list_repeat(murk_results_fields *f, const void *of)
{
    const murk_repeat_results *r = of;
    const murk_repeat *repeat = r ? r->repeat : NULL;
    const murk_repeat_summary *s = r ? &r->summary : NULL;
    MURK_COUNT(f, "asked", "runs asked for", repeat->asked);
    MURK_COUNT(f, "runs", "runs that were finished", repeat->runs);
    MURK_COUNT(f, "first_seed", "of the runs", repeat->run[0].seed);
    MURK_OBJECT(f, "sensors", "how many", list_spread, &s->sensors);
    MURK_OBJECT(f, "in_sample", "coverage in sample", list_spread,
                &s->in_sample);
    MURK_OBJECT(f, "held_out", "coverage held out", list_spread, &s->held_out);
    MURK_OBJECT(f, "upper", "the bound", list_upper, s);
    MURK_OBJECT(f, "plan", "the first run's plan", list_plan, &s->plan);
    MURK_OBJECT(f, "gap", "null if too few runs tell of it", list_gap,
                s->gap.runs ? &s->gap : NULL);
    MURK_NUMBER(
        f, "best_seed", "", "of the run with the greatest held-out coverage",
        s->best < repeat->runs ? (double)repeat->run[s->best].seed : NAN);
    MURK_NUMBER(f, "target_met", "",
                "runs whose held-out coverage meets the target",
                repeat->target > 0 ? (double)s->met : NAN);
}

/* repeat.csv: one line for each finished run, in order of seeds. */
void murk_results_list_run(murk_results_fields *f, const void *of, size_t i)
{
    const murk_repeat *repeat = of;
    const murk_repeat_run *run = repeat ? &repeat->run[i] : NULL;
    MURK_COUNT(f, "seed", "of the run", run->seed);
    MURK_COUNT(f, "sensors", "of the run's plan", run->sensors);
    MURK_NUMBER(f, "in_sample", "1", "coverage of the run's plan",
                run->in_sample);
    MURK_ESTIMATE(f, "held_out", "1",
                  "coverage of the run's plan on a second map", run->held_out);
    MURK_NUMBER(f, "upper", "1", "the run's bound", run->upper);
    MURK_FLAG(f, "proven_optimal", "true if the bound is met",
              run->proven_optimal);
    MURK_ESTIMATE(f, "plan", "1",
                  "coverage of the first run's plan on this map", run->plan);
}

/* ---- the summary ---- */

static void print_spread(const char *name, murk_spread s)
{
    if (isfinite(s.median)) {
        murk_print("            %-12s %8.4f %8.4f %8.4f\n", name, s.median,
                   s.min, s.max);
    }
}

void murk_print_repeat(const murk_repeat_results *results)
{
    const murk_repeat *repeat = results->repeat;
    const murk_repeat_summary s = results->summary;
    murk_print("repeat      %zu of %zu runs, seeds %lu..%lu; the plan is the "
               "first's\n",
               repeat->runs, repeat->asked, (unsigned long)repeat->run[0].seed,
               (unsigned long)repeat->run[repeat->runs - 1].seed);
    /* The table: spread over the runs. */
    murk_print("            %-12s %8s %8s %8s\n", "", "median", "least",
               "most");
    print_spread("in sample", s.in_sample);
    print_spread("held out", s.held_out);
    print_spread("upper bound", s.upper);
    if (s.sensors.min < s.sensors.max) {
        murk_print("            %-12s %8.4g %8.0f %8.0f\n", "sensors",
                   s.sensors.median, s.sensors.min, s.sensors.max);
    }
    if (repeat->target > 0 && isfinite(s.held_out.median)) {
        murk_print("            %zu of %zu meet the target, held out\n", s.met,
                   repeat->runs);
    }
    /* The plan of the first run, measured on maps that did not choose it. */
    if (isfinite(s.plan.standard_error)) {
        murk_print(
            "            the plan covers %.4f +- %.4f, by maps that did not "
            "choose it\n",
            s.plan.value, s.plan.standard_error);
    }
    if (isfinite(s.gap.lower)) {
        murk_print("            statistical gap to the best plan: %.4f (95 %%: "
                   "%.4f..%.4f)\n",
                   s.gap.value, s.gap.lower, s.gap.upper);
    }
}
