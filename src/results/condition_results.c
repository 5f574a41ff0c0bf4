/* Placement over conditions: fields of JSON, columns of CSV, files, and lines
 * of the summary. */
#include "results/condition_results.h"

#include "results/coverage.h"
#include "results/json.h"
#include "results/ledger.h"
#include "results/plan_ply.h"
#include "results/summary.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MARKED_SIZE (MURK_SCENE_NAME_SIZE + MARK_LENGTH)

#define FILE_NAME_MAX (MURK_SCENE_NAME_SIZE + 16) /* "ledger-NAME.json" */

/* Widths in tables on the terminal: the column of names, the mark of the chosen
 * plan, and a column of regret. */
#define NAME_MIN    16
#define NAME_MAX    32
#define MARK_LENGTH 2
#define COLUMN      17 /* " 0.8010 (+0.0000)" */

#define DIGITS       9 /* of shares in regret.csv */
#define ERROR_DIGITS 6 /* of their standard errors */

/* The coverage of a plan by one objective over the conditions; from the
 * coverages on second (held-out) maps if these were measured, else from those
 * in sample, on the maps that chose the plans. */
static murk_estimate best_known_of(const murk_condition_plans *r,
                                   const murk_condition_plan *plan,
                                   murk_scene_objective by)
{
    size_t worst;
    return murk_conditions_estimate(
        r->conditions, r->has_held_out ? plan->held_out : plan->in_sample, by,
        r->has_held_out, &worst);
}

/* True if the scene asks for the plan with the smallest largest regret. */
static bool is_for_regret(const murk_condition_plans *r)
{
    return r->conditions->scene->placement.over == MURK_SCENE_OBJECTIVE_REGRET;
}

/* The name of the condition with the largest regret (with placement.over:
 * regret), or else of the condition that the chosen plan covers least among the
 * conditions with a weight above 0, in sample. NULL if all conditions are dark.
 */
static const char *worst_of(const murk_condition_plans *r)
{
    size_t worst;
    if (r->plans == 0) {
        return NULL;
    }
    (void)murk_conditions_estimate(r->conditions, r->plan[r->chosen].in_sample,
                                   is_for_regret(r)
                                       ? MURK_SCENE_OBJECTIVE_REGRET
                                       : MURK_SCENE_OBJECTIVE_WORST,
                                   false, &worst);
    return r->conditions->condition[worst].settings->name;
}

static murk_estimate seen_in(const murk_condition_plans *r,
                             const murk_condition_plan *plan, size_t c)
{
    return r->has_held_out ? plan->held_out[c] : plan->in_sample[c];
}

/* Number of all conditions. In condition[], dark conditions (in which there is
 * no light to see) follow the lit ones. */
static size_t all_conditions(const murk_condition_plans *r)
{
    return r->conditions->n + r->conditions->dark;
}

/* ---- files ---- */

static const char *name_file(char out[FILE_NAME_MAX], const char *begin,
                             const murk_condition *condition, const char *end)
{
    snprintf(out, FILE_NAME_MAX, "%s-%s%s", begin, condition->settings->name,
             end);
    return out;
}

static murk_status add_condition(murk_session *session,
                                 const murk_condition_plans *r, size_t c,
                                 murk_error *err)
{
    murk_results *results = &session->results;
    const murk_condition *condition = &r->conditions->condition[c];
    char name[FILE_NAME_MAX];
    /* Light, ledger and scene of the condition; unless it is dark,
     * plan-NAME.ply. */
    const murk_ledger_results ledger = {condition->traced, condition->stage};
    murk_status status = murk_results_add_light(
        results, name_file(name, "light", condition, ".murk"),
        condition->traced, condition->stage, err);
    if (!status) {
        status = murk_session_add_ledger(
            session, name_file(name, "ledger", condition, ".json"), &ledger,
            err);
    }
    if (!status) {
        status = murk_results_add_text(
            results, name_file(name, "scene", condition, ".yaml"),
            condition->settings->scene->resolved, err);
    }
    if (!status && condition->sight) {
        const murk_condition_plan *plan = &r->plan[r->chosen];
        status = murk_add_plan_ply(
            results, name_file(name, "plan", condition, ".ply"),
            condition->stage, condition->sight,
            murk_condition_plan_sensors_in(plan, c), plan->count, err);
    }
    return status;
}

/* regret.csv: one line for each pair of a plan and a lit condition. */
void murk_results_list_use(murk_results_fields *f, const void *of, size_t i)
{
    const murk_condition_plans *r = of;
    const size_t n = r ? r->conditions->n : 1, c = i % n;
    const murk_condition_plan *plan = r ? &r->plan[i / n] : NULL;
    MURK_TEXT(f, "made_for", "condition, or a plan's name", plan->made_for);
    MURK_TEXT(f, "used_in", "condition",
              r->conditions->condition[c].settings->name);
    MURK_ROUNDED(f, "in_sample", "1", "coverage there",
                 plan->in_sample[c].value, DIGITS);
    MURK_ROUNDED(f, "in_sample_standard_error", "1", "of in_sample",
                 plan->in_sample[c].standard_error, ERROR_DIGITS);
    MURK_ROUNDED(f, "held_out", "1", "coverage there on a second map",
                 r->has_held_out ? plan->held_out[c].value : NAN, DIGITS);
    MURK_ROUNDED(f, "held_out_standard_error", "1", "of held_out",
                 r->has_held_out ? plan->held_out[c].standard_error : NAN,
                 ERROR_DIGITS);
    MURK_ROUNDED(f, "regret", "1", "coverage lost to the condition's own plan",
                 murk_condition_plans_regret(r, plan, c), DIGITS);
}

murk_status murk_add_condition_files(murk_session *session,
                                     const murk_condition_plans *r,
                                     murk_error *err)
{
    murk_status status = MURK_OK;
    if (!session->results.folder) {
        return MURK_OK;
    }
    for (size_t c = 0; !status && c < all_conditions(r); ++c) {
        status = add_condition(session, r, c, err);
    }
    if (!status) {
        status = murk_session_add_scene(session, err);
    }
    return status ? status
                  : murk_results_add_csv(&session->results, "regret.csv",
                                         murk_results_list_use, r,
                                         r->plans * r->conditions->n, err);
}

/* ---- rows ---- */

void murk_results_list_condition_photons(murk_results_fields *f, const void *of)
{
    const murk_condition_plans *r = of;
    size_t surface = 0, volume = 0;
    uint64_t emitted = 0;
    for (size_t c = 0; c < all_conditions(r); ++c) {
        const murk_traced *traced = r->conditions->condition[c].traced;
        emitted += traced->emitted;
        surface += murk_photon_map_count(traced->surface);
        volume += murk_photon_map_count(traced->volume);
    }
    MURK_COUNT(f, "emitted", "in all conditions", emitted);
    MURK_COUNT(f, "surface", "in all conditions", surface);
    MURK_COUNT(f, "volume", "in all conditions", volume);
}

static const murk_estimate NONE = {NAN, NAN};

static void list_condition(murk_results_fields *f, const void *of, size_t c)
{
    const murk_condition_plans *r = of;
    const murk_condition_plan *chosen = r ? &r->plan[r->chosen] : NULL;
    const murk_condition *condition = r ? &r->conditions->condition[c] : NULL;
    const bool is_dark = r && c >= r->conditions->n;
    MURK_TEXT(f, "name", "of the condition", condition->settings->name);
    MURK_NUMBER(f, "weight", "1", "in the mean", condition->settings->weight);
    MURK_OBJECT(f, "photons", "photons of the condition's light",
                murk_results_list_photons, condition->traced);
    MURK_ESTIMATE(f, "in_sample", "1", "coverage of the plan",
                  is_dark ? NONE : chosen->in_sample[c]);
    MURK_ESTIMATE(f, "held_out", "1", "the same on a second map",
                  r->has_held_out && !is_dark ? chosen->held_out[c] : NONE);
    MURK_NUMBER(f, "surface", "1", "of the surface map alone",
                is_dark ? NAN : r->coverage[c].surface.value);
    MURK_NUMBER(f, "volume", "1", "of the volume map alone",
                is_dark ? NAN : r->coverage[c].volume.value);
}

typedef enum value { COVERAGE, ERROR, REGRET, BEST_KNOWN, BEST_UPPER } value;

/* A value of one lit condition. BEST_KNOWN and BEST_UPPER do not depend on the
 * plan and are NaN for a condition of weight 0. */
static double value_in(const murk_condition_plans *r,
                       const murk_condition_plan *plan, size_t c, value wanted)
{
    const murk_condition *condition = &r->conditions->condition[c];
    const bool counts = condition->settings->weight > 0;
    switch (wanted) {
    case COVERAGE:
        return seen_in(r, plan, c).value;
    case ERROR:
        return seen_in(r, plan, c).standard_error;
    case REGRET:
        return murk_condition_plans_regret(r, plan, c);
    case BEST_KNOWN:
        return counts ? condition->best_known : NAN;
    case BEST_UPPER:
        return counts ? condition->best_upper : NAN;
    }
    return NAN;
}

static cJSON *all_of(const murk_condition_plans *r,
                     const murk_condition_plan *plan, value wanted)
{
    double all[MURK_SCENE_CONDITIONS_MAX] = {0};
    for (size_t c = 0; c < r->conditions->n; ++c) {
        all[c] = value_in(r, plan, c, wanted);
    }
    return cJSON_CreateDoubleArray(all, (int)r->conditions->n);
}

static cJSON *positions_of(const murk_condition_plans *r,
                           const murk_condition_plan *plan)
{
    cJSON *list = cJSON_CreateArray();
    for (size_t k = 0; k < plan->count; ++k) {
        const murk_vec3 x =
            murk_scene_user(r->conditions->condition[0].settings->scene,
                            plan->sensor[k].position);
        const double place[3] = {x.x, x.y, x.z};
        cJSON_AddItemToArray(list, cJSON_CreateDoubleArray(place, 3));
    }
    return list;
}

static void list_made(murk_results_fields *f, const void *of, size_t i)
{
    const murk_condition_plans *r = of;
    const murk_condition_plan *plan = r ? &r->plan[i] : NULL;
    MURK_TEXT(f, "made_for", "condition, or a plan's name", plan->made_for);
    MURK_JSON(f, "positions_m", "m", "of the sensors", positions_of(r, plan));
    MURK_JSON(f, "coverage", "1", "in each condition",
              all_of(r, plan, COVERAGE));
    MURK_JSON(f, "standard_error", "1", "of coverage", all_of(r, plan, ERROR));
    MURK_JSON(f, "regret", "1", "in each condition", all_of(r, plan, REGRET));
    MURK_ESTIMATE(f, "mean", "1", "over the conditions",
                  best_known_of(r, plan, MURK_SCENE_OBJECTIVE_MEAN));
    MURK_ESTIMATE(f, "worst", "1", "of the conditions",
                  best_known_of(r, plan, MURK_SCENE_OBJECTIVE_WORST));
}

/* Lists how regret is measured, the largest regret of the chosen plan in sample
 * with two bounds, and for each lit condition the coverage that its regret is
 * measured against, with an upper bound. */
static void list_largest(murk_results_fields *f, const murk_condition_plans *r)
{
    const bool is_lit = r && r->plans > 0;
    MURK_TEXT(f, "measure", "absolute or relative",
              r->conditions->scene->placement.relative_regret ? "relative"
                                                              : "absolute");
    MURK_NUMBER(f, "largest", "1",
                "of the plan, to the best plan found for each condition alone",
                is_lit ? r->regret : NAN);
    MURK_NUMBER(f, "largest_at_least", "1",
                "no plan has less, compared with these or with the true optima",
                is_lit ? r->regret_lower : NAN);
    MURK_NUMBER(f, "largest_to_optimum_at_most", "1",
                "of this plan, to the true optima",
                is_lit ? r->regret_upper : NAN);
    MURK_JSON(f, "best_known", "1",
              "coverage of the best plan found for each condition alone",
              all_of(r, NULL, BEST_KNOWN));
    MURK_JSON(f, "best_at_most", "1", "upper bound on best_known",
              all_of(r, NULL, BEST_UPPER));
}

/* Lists whether the coverages are measured on second (held-out) maps; if the
 * scene asks for the smallest largest regret, the fields of list_largest(); and
 * the plans, one for each condition and the chosen one, each with its coverage
 * and its regret in every lit condition, in the order of
 * r->conditions->condition[]. */
static void list_regret(murk_results_fields *f, const void *of)
{
    const murk_condition_plans *r = of;
    MURK_FLAG(f, "held_out", "true if measured on second maps",
              r->has_held_out);
    if (MURK_LISTED_IF(f, is_for_regret(r))) {
        list_largest(f, r);
    }
    MURK_LIST(f, "plans", "each condition's own plan, and this one", list_made,
              r, r->plans);
}

void murk_results_list_conditions(murk_results_fields *f, const void *of)
{
    const murk_condition_plans *r = of;
    MURK_TEXT(f, "over", "over conditions: mean, worst or regret",
              murk_scene_word("placement.over",
                              (int)r->conditions->scene->placement.over));
    MURK_TEXT(f, "worst_condition", "covered least, or with the largest regret",
              worst_of(r));
    MURK_LIST(f, "conditions", "the conditions, dark ones last", list_condition,
              r, all_conditions(r));
    MURK_OBJECT(f, "regret", "coverage of each plan in each condition",
                list_regret, r);
}

/* ---- lines ---- */

static void print_objective(const murk_condition_plans *r)
{
    const size_t n = r->conditions->n;
    const char *worst = worst_of(r);
    if (is_for_regret(r)) {
        murk_print("over        the largest regret of %zu conditions, which is "
                   "in %s: coverage below is of that condition\n",
                   n, worst);
    } else if (r->conditions->scene->placement.over ==
               MURK_SCENE_OBJECTIVE_WORST) {
        murk_print("over        the worst of %zu conditions: %s, of which all "
                   "below speaks\n",
                   n, worst);
    } else {
        murk_print("over        the mean of %zu conditions, of which all below "
                   "speaks\n",
                   n);
    }
}

/* Width of the column of names: that of the longest name with the mark of the
 * chosen plan, but NAME_MIN at least and NAME_MAX at most. */
static int name_width(const murk_condition_plans *r)
{
    size_t width = NAME_MIN;
    for (size_t c = 0; c < all_conditions(r); ++c) {
        const size_t length =
            strlen(r->conditions->condition[c].settings->name) + MARK_LENGTH;
        width = length > width ? length : width;
    }
    return width < NAME_MAX ? (int)width : NAME_MAX;
}

/* Prints the conditions as two tables, because one table with all columns would
 * be wider than a terminal. */
static void print_conditions(const murk_condition_plans *r)
{
    const murk_condition_plan *chosen = &r->plan[r->chosen];
    const int width = name_width(r);
    /* The first table: the light of each condition. */
    murk_print("conditions  %-*s %8s %9s %9s %9s\n", width, "", "weight",
               "emitted", "surface", "volume");
    const size_t lit = r->conditions->n;
    for (size_t c = 0; c < all_conditions(r); ++c) {
        const murk_condition *condition = &r->conditions->condition[c];
        const murk_traced *traced = condition->traced;
        murk_print("            %-*s %8.4g %9llu %9zu %9zu\n", width,
                   condition->settings->name, condition->settings->weight,
                   (unsigned long long)traced->emitted,
                   murk_photon_map_count(traced->surface),
                   murk_photon_map_count(traced->volume));
    }
    /* The second table: coverage of the plan in each condition. */
    murk_print("covered     %-*s %9s  %s\n", width, "", "in sample",
               r->has_held_out ? "held out" : "");
    for (size_t c = 0; c < all_conditions(r); ++c) {
        murk_print("            %-*s ", width,
                   r->conditions->condition[c].settings->name);
        if (c >= lit) {
            murk_print("nothing to see: it counts for nothing\n");
            continue;
        }
        murk_print("%9.4f", chosen->in_sample[c].value);
        if (r->has_held_out) {
            murk_print("  ");
            murk_print_estimate(chosen->held_out[c]);
        }
        murk_print("\n");
    }
}

/* Prints the columns first .. end - 1 of the table, beside the names of the
 * plans. The table has one column for each lit condition, then one for the mean
 * and the worst together. */
static void print_regret_columns(const murk_condition_plans *r, int width,
                                 size_t first, size_t end)
{
    const size_t n = r->conditions->n;
    murk_print("            %-*s", width, "");
    /* The heading: names of conditions. */
    for (size_t c = first; c < end && c < n; ++c) {
        murk_print(" %16.16s", r->conditions->condition[c].settings->name);
    }
    murk_print("%s\n", end > n ? "    mean    worst" : "");
    /* A line for each plan: coverage and regret in each condition. */
    for (size_t p = 0; p < r->plans; ++p) {
        const murk_condition_plan *plan = &r->plan[p];
        char name[MARKED_SIZE];
        snprintf(name, sizeof name, "%s%s", plan->made_for,
                 p == r->chosen ? " *" : "");
        murk_print("            %-*s", width, name);
        for (size_t c = first; c < end && c < n; ++c) {
            murk_print(" %.4f (%+.4f)", seen_in(r, plan, c).value,
                       murk_condition_plans_regret(r, plan, c));
        }
        if (end > n) {
            murk_print(
                " %7.4f %8.4f",
                best_known_of(r, plan, MURK_SCENE_OBJECTIVE_MEAN).value,
                best_known_of(r, plan, MURK_SCENE_OBJECTIVE_WORST).value);
        }
        murk_print("\n");
    }
}

/* Prints the table of regret. Columns that do not fit a line follow in further
 * tables below the first. */
static void print_regret(const murk_condition_plans *r)
{
    murk_print("regret      coverage%s of a plan made for one condition (down) "
               "and used in each (across), and what it loses there to that "
               "condition's own plan\n",
               r->has_held_out ? ", held out," : "");
    const int width = name_width(r);
    const int fitting = (80 - 12 - width) / COLUMN;
    const size_t across = fitting > 1 ? (size_t)fitting : 1;
    /* the last column has mean and worst */
    const size_t columns = r->conditions->n + 1;
    for (size_t first = 0; first < columns; first += across) {
        const size_t end = first + across;
        print_regret_columns(r, width, first, end < columns ? end : columns);
    }
    double largest = 0;
    for (size_t p = 0; p < r->plans; ++p) {
        for (size_t c = 0; c < r->conditions->n; ++c) {
            largest = fmax(largest, seen_in(r, &r->plan[p], c).standard_error);
        }
    }
    murk_print("            * this plan; standard errors up to %.4f\n",
               largest);
}

void murk_print_conditions(const murk_condition_plans *r)
{
    print_conditions(r);
    if (r->plans > 0) {
        print_regret(r);
        print_objective(r);
    }
}

void murk_print_regret_bound(const murk_condition_plans *r, const char *sample)
{
    const murk_conditions *all = r->conditions;
    const bool is_below_0 = r->regret_lower < 0;
    murk_print("bound       largest regret%s %.4f in sample, to the best plan "
               "found for each condition alone; no plan has less than %.4f%s "
               "on this %s; to the true optima it is %.4f at most; guarantee: "
               "none\n",
               all->scene->placement.relative_regret ? " (relative)" : "",
               r->regret, is_below_0 ? 0 : r->regret_lower,
               is_below_0                    ? " to the true optima"
               : r->regret_lower < r->regret ? ""
                                             : " (proven optimal)",
               sample, r->regret_upper);
}

void murk_print_asked_conditions(const murk_scene_desc *scene)
{
    static const char *const objective[] = {
        [MURK_SCENE_OBJECTIVE_NONE] = "placement is of the scene as it stands",
        [MURK_SCENE_OBJECTIVE_MEAN] = "placement is over their mean",
        [MURK_SCENE_OBJECTIVE_WORST] = "placement is over the worst of them",
        [MURK_SCENE_OBJECTIVE_REGRET] =
            "placement is for the least largest regret over them"};
    for (size_t c = 0; c < scene->n_conditions; ++c) {
        murk_print("%s%s", c ? ", " : "conditions  ",
                   scene->conditions[c].name);
        if (scene->conditions[c].weight != 1) {
            murk_print(" (weight %.6g)", scene->conditions[c].weight);
        }
    }
    if (scene->n_conditions > 0) {
        murk_print("; %s\n", objective[scene->placement.over]);
    }
}
