#include "results/repeat.h"

#include "results/coverage.h"
#include "results/summary.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* ---- JSON ---- */

static cJSON *add_spread(cJSON *object, const char *key, murk_spread s)
{
    cJSON *item = cJSON_AddObjectToObject(object, key);
    murk_json_number(item, "median", s.median);
    murk_json_number(item, "minimum", s.min);
    murk_json_number(item, "maximum", s.max);
    return item;
}

static void add_gap(cJSON *object, const murk_gap *gap)
{
    if (gap->runs == 0) {
        cJSON_AddNullToObject(object, "gap");
        return;
    }
    cJSON *item = cJSON_AddObjectToObject(object, "gap");
    murk_json_number(item, "value", gap->value);
    murk_json_number(item, "lower", gap->lower);
    murk_json_number(item, "upper", gap->upper);
    murk_json_number(item, "confidence", 0.95);
    cJSON_AddNumberToObject(item, "runs", (double)gap->runs);
}

murk_status murk_json_repeat(cJSON *root, const murk_repeat *repeat,
                             murk_error *err)
{
    murk_repeat_summary s;
    const murk_status status = murk_repeat_sum_up(&s, repeat, err);
    if (status) {
        return status;
    }
    cJSON *object = cJSON_AddObjectToObject(root, "repeat");
    cJSON_AddNumberToObject(object, "asked", (double)repeat->asked);
    cJSON_AddNumberToObject(object, "runs", (double)repeat->runs);
    cJSON_AddNumberToObject(object, "first_seed", repeat->run[0].seed);
    add_spread(object, "sensors", s.sensors);
    add_spread(object, "in_sample", s.in_sample);
    add_spread(object, "held_out", s.held_out);
    cJSON *upper = add_spread(object, "upper", s.upper);
    murk_json_number(upper, "mean", s.upper_mean.value);
    murk_json_number(upper, "standard_error", s.upper_mean.standard_error);
    cJSON *plan = cJSON_AddObjectToObject(object, "plan");
    murk_json_number(plan, "coverage", s.plan.value);
    murk_json_number(plan, "standard_error", s.plan.standard_error);
    add_gap(object, &s.gap);
    if (s.best < repeat->runs) {
        cJSON_AddNumberToObject(object, "best_seed", repeat->run[s.best].seed);
    } else {
        cJSON_AddNullToObject(object, "best_seed");
    }
    if (repeat->target > 0) {
        cJSON_AddNumberToObject(object, "target_met", (double)s.met);
    } else {
        cJSON_AddNullToObject(object, "target_met");
    }
    return MURK_OK;
}

/* ---- CSV ---- */

/* ",VALUE", or "," where there is none. */
static void put(FILE *to, double value)
{
    char text[32] = "";
    if (isfinite(value)) {
        murk_number_text(text, value);
    }
    fprintf(to, ",%s", text);
}

murk_status murk_add_repeat_csv(murk_results *results,
                                const murk_repeat *repeat, murk_error *err)
{
    if (!results->folder) {
        return MURK_OK;
    }
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (to) {
        fputs("seed,sensors,in_sample,held_out,held_out_standard_error,upper,"
              "proven_optimal,plan,plan_standard_error\n",
              to);
    }
    for (size_t i = 0; to && i < repeat->runs; ++i) {
        const murk_repeat_run *run = &repeat->run[i];
        fprintf(to, "%lu,%zu", (unsigned long)run->seed, run->sensors);
        put(to, run->in_sample);
        put(to, run->held_out.value);
        put(to, run->held_out.standard_error);
        put(to, run->upper);
        fprintf(to, ",%s", run->proven_optimal ? "true" : "false");
        put(to, run->plan.value);
        put(to, run->plan.standard_error);
        fputc('\n', to);
    }
    const bool is_whole = to && fclose(to) == 0;
    const murk_status status = murk_results_add_text(
        results, "repeat.csv", is_whole ? text : NULL, err);
    free(text);
    return status;
}

/* ---- the summary ---- */

static void print_spread(const char *name, murk_spread s)
{
    if (isfinite(s.median)) {
        murk_print("            %-12s %8.4f %8.4f %8.4f\n", name, s.median,
                   s.min, s.max);
    }
}

murk_status murk_print_repeat(const murk_repeat *repeat, murk_error *err)
{
    murk_repeat_summary s;
    const murk_status status = murk_repeat_sum_up(&s, repeat, err);
    if (status) {
        return status;
    }
    murk_print("repeat      %zu of %zu runs, seeds %lu..%lu; the plan is the "
               "first's\n",
               repeat->runs, repeat->asked, (unsigned long)repeat->run[0].seed,
               (unsigned long)repeat->run[repeat->runs - 1].seed);
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
    return MURK_OK;
}
