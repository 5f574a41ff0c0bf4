#include "results/over.h"

#include "results/coverage.h"
#include "results/plan_ply.h"
#include "results/run_files.h"
#include "results/summary.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MARKED_SIZE (MURK_SCENE_NAME_SIZE + MARK_LENGTH)

#define FILE_NAME_MAX (MURK_SCENE_NAME_SIZE + 16)

/* Of tables on the terminal: the column of names, and the mark of this plan. */
#define NAME_MIN    16
#define NAME_MAX    32
#define MARK_LENGTH 2
#define COLUMN      17 /* " 0.8010 (+0.0000)" */

static murk_estimate in_sample_of(const murk_condition_plans *over,
                                  const murk_condition_plan *plan,
                                  murk_scene_over by, size_t *worst)
{
    return murk_conditions_estimate(over->conditions, plan->in_sample, by,
                                    false, worst);
}

/* Held out, where it is. */
static murk_estimate best_known_of(const murk_condition_plans *over,
                                   const murk_condition_plan *plan,
                                   murk_scene_over by)
{
    size_t worst;
    return over->has_held_out
               ? murk_conditions_estimate(over->conditions, plan->held_out, by,
                                          true, &worst)
               : in_sample_of(over, plan, by, &worst);
}

static const char *const over_names[] = {[MURK_SCENE_OVER_MEAN] = "mean",
                                         [MURK_SCENE_OVER_WORST] = "worst",
                                         [MURK_SCENE_OVER_REGRET] = "regret"};

/* The criterion that selects the worst condition. */
static murk_scene_over judged_by(const murk_condition_plans *over)
{
    const murk_scene_over by = over->conditions->scene->placement.over;
    return by == MURK_SCENE_OVER_REGRET ? by : MURK_SCENE_OVER_WORST;
}

static murk_estimate seen_in(const murk_condition_plans *over,
                             const murk_condition_plan *plan, size_t c)
{
    return over->has_held_out ? plan->held_out[c] : plan->in_sample[c];
}

/* ---- files ---- */

static const char *name_file(char out[FILE_NAME_MAX], const char *begin,
                             const murk_condition *condition, const char *end)
{
    snprintf(out, FILE_NAME_MAX, "%s-%s%s", begin, condition->settings->name,
             end);
    return out;
}

static murk_status add_ledger(murk_session *session, const char *name,
                              const murk_condition *condition, murk_error *err)
{
    const murk_session one = {.scene = condition->settings->scene,
                              .stage = condition->stage,
                              .traced = condition->traced};
    cJSON *root = murk_session_ledger(&one);
    murk_json_identify(root, session->identity, NULL, NULL);
    char *text = murk_json_end(root, &session->run);
    const murk_status status =
        murk_results_add_text(&session->results, name, text, err);
    cJSON_free(text);
    return status;
}

static murk_status add_condition(murk_session *session,
                                 const murk_plan_result *plan,
                                 const murk_condition *condition,
                                 murk_error *err)
{
    murk_results *results = &session->results;
    char name[FILE_NAME_MAX];
    const murk_box *box = &condition->stage->world.domain.box;
    murk_status status = murk_results_add_light(
        results, name_file(name, "light", condition, ".murk"),
        condition->traced, condition->stage, err);
    if (!status) {
        status =
            add_ledger(session, name_file(name, "ledger", condition, ".json"),
                       condition, err);
    }
    if (!status) {
        status = murk_results_add_text(
            results, name_file(name, "scene", condition, ".yaml"),
            condition->settings->scene->resolved, err);
    }
    if (!status && condition->sight) {
        status = murk_add_plan_ply(
            results, name_file(name, "plan", condition, ".ply"),
            condition->settings->scene, condition->sight, plan->sensor,
            plan->place.count, murk_length(murk_sub(box->max, box->min)), err);
    }
    return status;
}

static murk_status write_regret(const char *path, const void *context,
                                murk_error *err)
{
    const murk_condition_plans *over = context;
    murk_file *file = NULL;
    murk_status status = murk_file_create(&file, path, err);
    if (status) {
        return status;
    }
    FILE *to = murk_file_stream(file);
    fputs("made_for,used_in,in_sample,in_sample_standard_error,held_out,"
          "held_out_standard_error,regret\n",
          to);
    for (size_t p = 0; p < over->plans; ++p) {
        const murk_condition_plan *plan = &over->plan[p];
        for (size_t c = 0; c < over->conditions->n; ++c) {
            const murk_estimate in = plan->in_sample[c];
            fprintf(to, "%s,%s,%.9g,%.6g,", plan->made_for,
                    over->conditions->condition[c].settings->name, in.value,
                    in.standard_error);
            if (over->has_held_out) {
                fprintf(to, "%.9g,%.6g,", plan->held_out[c].value,
                        plan->held_out[c].standard_error);
            } else {
                fputs(",,", to);
            }
            fprintf(to, "%.9g\n", murk_condition_plans_regret(over, plan, c));
        }
    }
    status = murk_file_commit(&file, err);
    murk_file_discard(file);
    return status;
}

murk_status murk_over_add_files(murk_session *session,
                                const murk_plan_result *plan,
                                const murk_condition_plans *over,
                                murk_error *err)
{
    murk_status status = MURK_OK;
    if (!session->results.folder) {
        return MURK_OK;
    }
    const size_t every = over->conditions->n + over->conditions->dark;
    for (size_t c = 0; !status && c < every; ++c) {
        status =
            add_condition(session, plan, &over->conditions->condition[c], err);
    }
    if (!status) {
        status = murk_results_add_text(&session->results, MURK_SCENE_NAME,
                                       session->scene->resolved, err);
    }
    return status ? status
                  : murk_results_add(&session->results, "regret.csv",
                                     write_regret, over, err);
}

/* ---- JSON ---- */

void murk_over_json_photons(cJSON *root, const murk_condition_plans *over)
{
    double emitted = 0, surface = 0, volume = 0;
    const size_t every = over->conditions->n + over->conditions->dark;
    for (size_t c = 0; c < every; ++c) {
        const murk_traced *traced = over->conditions->condition[c].traced;
        emitted += (double)traced->emitted;
        surface += (double)murk_photon_map_count(traced->surface);
        volume += (double)murk_photon_map_count(traced->volume);
    }
    cJSON *object = cJSON_AddObjectToObject(root, "photons");
    cJSON_AddNumberToObject(object, "emitted", emitted);
    cJSON_AddNumberToObject(object, "surface", surface);
    cJSON_AddNumberToObject(object, "volume", volume);
}

static void add_estimate(cJSON *object, const char *key, murk_estimate of)
{
    char error[80];
    snprintf(error, sizeof error, "%s_standard_error", key);
    murk_json_number(object, key, of.value);
    murk_json_number(object, error, of.standard_error);
}

static const murk_estimate NONE = {NAN, NAN};

static void add_conditions(cJSON *root, const murk_condition_plans *over)
{
    const murk_condition_plan *chosen = &over->plan[over->chosen];
    cJSON *list = cJSON_AddArrayToObject(root, "conditions");
    const size_t lit = over->conditions->n;
    for (size_t c = 0; c < lit + over->conditions->dark; ++c) {
        const murk_condition *condition = &over->conditions->condition[c];
        const bool is_dark = c >= lit;
        const murk_coverage_result *coverage = &over->coverage[c];
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "name", condition->settings->name);
        murk_json_number(item, "weight", condition->settings->weight);
        cJSON *photons = cJSON_AddObjectToObject(item, "photons");
        const murk_traced *traced = condition->traced;
        cJSON_AddNumberToObject(photons, "emitted", (double)traced->emitted);
        cJSON_AddNumberToObject(photons, "surface",
                                (double)murk_photon_map_count(traced->surface));
        cJSON_AddNumberToObject(photons, "volume",
                                (double)murk_photon_map_count(traced->volume));
        add_estimate(item, "in_sample", is_dark ? NONE : chosen->in_sample[c]);
        add_estimate(item, "held_out",
                     over->has_held_out && !is_dark ? chosen->held_out[c]
                                                    : NONE);
        murk_json_number(item, "surface",
                         is_dark ? NAN : coverage->surface.value);
        murk_json_number(item, "volume",
                         is_dark ? NAN : coverage->volume.value);
        cJSON_AddItemToArray(list, item);
    }
}

static cJSON *add_list(cJSON *object, const char *key)
{
    return cJSON_AddArrayToObject(object, key);
}

static void add_item(cJSON *list, double value)
{
    cJSON_AddItemToArray(list, isfinite(value) ? cJSON_CreateNumber(value)
                                               : cJSON_CreateNull());
}

/* What was minimised, in sample, and what it is measured from. */
static void add_largest_regret(cJSON *object, const murk_condition_plans *over)
{
    const murk_conditions *all = over->conditions;
    if (all->scene->placement.over != MURK_SCENE_OVER_REGRET) {
        return;
    }
    const bool is_lit = over->plans > 0;
    cJSON_AddStringToObject(object, "measure",
                            all->scene->placement.relative_regret ? "relative"
                                                                  : "absolute");
    murk_json_number(object, "largest", is_lit ? over->regret : NAN);
    murk_json_number(object, "largest_at_least",
                     is_lit ? over->regret_lower : NAN);
    murk_json_number(object, "largest_to_optimum_at_most",
                     is_lit ? over->regret_upper : NAN);
    cJSON *known = add_list(object, "best_known");
    cJSON *upper = add_list(object, "best_at_most");
    for (size_t c = 0; c < all->n; ++c) {
        const murk_condition *one = &all->condition[c];
        const bool has_say = one->settings->weight > 0;
        add_item(known, has_say ? one->best_known : NAN);
        add_item(upper, has_say ? one->best_upper : NAN);
    }
}

/* Rows are plans, columns the conditions in their order, but for dark ones. */
static void add_regret(cJSON *root, const murk_condition_plans *over)
{
    cJSON *object = cJSON_AddObjectToObject(root, "regret");
    cJSON_AddBoolToObject(object, "held_out", over->has_held_out);
    add_largest_regret(object, over);
    cJSON *plans = cJSON_AddArrayToObject(object, "plans");
    for (size_t p = 0; p < over->plans; ++p) {
        const murk_condition_plan *plan = &over->plan[p];
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "made_for", plan->made_for);
        cJSON *positions = add_list(item, "positions_m");
        for (size_t k = 0; k < plan->count; ++k) {
            const murk_vec3 x =
                murk_scene_user(over->conditions->condition[0].settings->scene,
                                plan->sensor[k].position);
            const double place[3] = {x.x, x.y, x.z};
            cJSON_AddItemToArray(positions, cJSON_CreateDoubleArray(place, 3));
        }
        cJSON *coverage = add_list(item, "coverage");
        cJSON *errors = add_list(item, "standard_error");
        cJSON *regret = add_list(item, "regret");
        for (size_t c = 0; c < over->conditions->n; ++c) {
            const murk_estimate seen = seen_in(over, plan, c);
            add_item(coverage, seen.value);
            add_item(errors, seen.standard_error);
            add_item(regret, murk_condition_plans_regret(over, plan, c));
        }
        add_estimate(item, "mean",
                     best_known_of(over, plan, MURK_SCENE_OVER_MEAN));
        add_estimate(item, "worst",
                     best_known_of(over, plan, MURK_SCENE_OVER_WORST));
        cJSON_AddItemToArray(plans, item);
    }
}

void murk_over_json(cJSON *root, const murk_condition_plans *over)
{
    const murk_condition_plan *chosen = &over->plan[over->chosen];
    cJSON_AddStringToObject(
        root, "over", over_names[over->conditions->scene->placement.over]);
    if (over->plans > 0) {
        size_t worst;
        in_sample_of(over, chosen, judged_by(over), &worst);
        cJSON_AddStringToObject(
            root, "worst_condition",
            over->conditions->condition[worst].settings->name);
    } else {
        cJSON_AddNullToObject(root, "worst_condition");
    }
    add_conditions(root, over);
    add_regret(root, over);
}

/* ---- lines ---- */

static void print_over(const murk_condition_plans *over)
{
    size_t worst;
    const murk_condition_plan *chosen = &over->plan[over->chosen];
    in_sample_of(over, chosen, judged_by(over), &worst);
    if (judged_by(over) == MURK_SCENE_OVER_REGRET) {
        murk_print("over        the largest regret of %zu conditions, which is "
                   "in %s: coverage below is of that condition\n",
                   over->conditions->n,
                   over->conditions->condition[worst].settings->name);
    } else if (over->conditions->scene->placement.over ==
               MURK_SCENE_OVER_WORST) {
        murk_print("over        the worst of %zu conditions: %s, of which all "
                   "below speaks\n",
                   over->conditions->n,
                   over->conditions->condition[worst].settings->name);
    } else {
        murk_print("over        the mean of %zu conditions, of which all below "
                   "speaks\n",
                   over->conditions->n);
    }
}

/* The column of names: as wide as the longest, within reason. */
static int name_width(const murk_condition_plans *over)
{
    size_t width = NAME_MIN;
    const size_t every = over->conditions->n + over->conditions->dark;
    for (size_t c = 0; c < every; ++c) {
        const size_t length =
            strlen(over->conditions->condition[c].settings->name) + MARK_LENGTH;
        width = length > width ? length : width;
    }
    return width < NAME_MAX ? (int)width : NAME_MAX;
}

/* Two tables, since one with all columns is wider than a terminal. */
static void print_conditions(const murk_condition_plans *over)
{
    const murk_condition_plan *chosen = &over->plan[over->chosen];
    const int width = name_width(over);
    murk_print("conditions  %-*s %8s %9s %9s %9s\n", width, "", "weight",
               "emitted", "surface", "volume");
    const size_t lit = over->conditions->n;
    for (size_t c = 0; c < lit + over->conditions->dark; ++c) {
        const murk_condition *condition = &over->conditions->condition[c];
        const murk_traced *traced = condition->traced;
        murk_print("            %-*s %8.4g %9llu %9zu %9zu\n", width,
                   condition->settings->name, condition->settings->weight,
                   (unsigned long long)traced->emitted,
                   murk_photon_map_count(traced->surface),
                   murk_photon_map_count(traced->volume));
    }
    murk_print("covered     %-*s %9s  %s\n", width, "", "in sample",
               over->has_held_out ? "held out" : "");
    for (size_t c = 0; c < lit + over->conditions->dark; ++c) {
        murk_print("            %-*s ", width,
                   over->conditions->condition[c].settings->name);
        if (c >= lit) {
            murk_print("nothing to see: it counts for nothing\n");
            continue;
        }
        murk_print("%9.4f", chosen->in_sample[c].value);
        if (over->has_held_out) {
            murk_print("  ");
            murk_print_estimate(chosen->held_out[c]);
        }
        murk_print("\n");
    }
}

/* Columns [first, end) of the table: the conditions', and behind them the mean
 * and the worst. */
static void print_regret_columns(const murk_condition_plans *over, int width,
                                 size_t first, size_t end)
{
    const size_t n = over->conditions->n;
    murk_print("            %-*s", width, "");
    for (size_t c = first; c < end && c < n; ++c) {
        murk_print(" %16.16s", over->conditions->condition[c].settings->name);
    }
    murk_print("%s\n", end > n ? "    mean    worst" : "");
    for (size_t p = 0; p < over->plans; ++p) {
        const murk_condition_plan *plan = &over->plan[p];
        char name[MARKED_SIZE];
        snprintf(name, sizeof name, "%s%s", plan->made_for,
                 p == over->chosen ? " *" : "");
        murk_print("            %-*s", width, name);
        for (size_t c = first; c < end && c < n; ++c) {
            murk_print(" %.4f (%+.4f)", seen_in(over, plan, c).value,
                       murk_condition_plans_regret(over, plan, c));
        }
        if (end > n) {
            murk_print(" %7.4f %8.4f",
                       best_known_of(over, plan, MURK_SCENE_OVER_MEAN).value,
                       best_known_of(over, plan, MURK_SCENE_OVER_WORST).value);
        }
        murk_print("\n");
    }
}

/* As many columns below each other as the line has room for. */
static void print_regret(const murk_condition_plans *over)
{
    murk_print("regret      coverage%s of a plan made for one condition (down) "
               "and used in each (across), and what it loses there to that "
               "condition's own plan\n",
               over->has_held_out ? ", held out," : "");
    const int width = name_width(over);
    const int room = (80 - 12 - width) / COLUMN;
    const size_t across = room > 1 ? (size_t)room : 1;
    /* the last column has mean and worst */
    const size_t columns = over->conditions->n + 1;
    for (size_t first = 0; first < columns; first += across) {
        const size_t end = first + across;
        print_regret_columns(over, width, first, end < columns ? end : columns);
    }
    double largest = 0;
    for (size_t p = 0; p < over->plans; ++p) {
        for (size_t c = 0; c < over->conditions->n; ++c) {
            largest =
                fmax(largest, seen_in(over, &over->plan[p], c).standard_error);
        }
    }
    murk_print("            * this plan; standard errors up to %.4f\n",
               largest);
}

void murk_over_print(const murk_condition_plans *over)
{
    print_conditions(over);
    if (over->plans > 0) {
        print_regret(over);
        print_over(over);
    }
}

void murk_over_print_bound(const murk_condition_plans *over, const char *sample)
{
    const murk_conditions *all = over->conditions;
    const bool is_below_0 = over->regret_lower < 0;
    murk_print("bound       largest regret%s %.4f in sample, to the best plan "
               "found for each condition alone; no plan has less than %.4f%s "
               "on this %s; to the true optima it is %.4f at most; guarantee: "
               "none\n",
               all->scene->placement.relative_regret ? " (relative)" : "",
               over->regret, is_below_0 ? 0 : over->regret_lower,
               is_below_0                          ? " to the true optima"
               : over->regret_lower < over->regret ? ""
                                                   : " (proven optimal)",
               sample, over->regret_upper);
}

void murk_over_print_asked(const murk_scene_desc *scene)
{
    static const char *const over[] = {
        [MURK_SCENE_OVER_NONE] = "placement is of the scene as it stands",
        [MURK_SCENE_OVER_MEAN] = "placement is over their mean",
        [MURK_SCENE_OVER_WORST] = "placement is over the worst of them",
        [MURK_SCENE_OVER_REGRET] =
            "placement is for the least largest regret over them"};
    for (size_t c = 0; c < scene->n_conditions; ++c) {
        murk_print("%s%s", c ? ", " : "conditions  ",
                   scene->conditions[c].name);
        if (scene->conditions[c].weight != 1) {
            murk_print(" (weight %.6g)", scene->conditions[c].weight);
        }
    }
    if (scene->n_conditions > 0) {
        murk_print("; %s\n", over[scene->placement.over]);
    }
}
