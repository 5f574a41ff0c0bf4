#include "results/fit.h"

#include "calibrate/verdict.h"
#include "results/coverage.h"
#include "results/summary.h"
#include "scene/places.h"

#include <math.h>
#include <string.h>

static const char *const kinds[] = {[MURK_FREE_MEDIUM] = "medium",
                                    [MURK_FREE_LIGHT] = "light",
                                    [MURK_FREE_GAIN] = "gain",
                                    [MURK_FREE_WORLD] = "world"};
static const char *const reading_kinds[] = {
    [MURK_READ_COVERAGE] = "coverage",
    [MURK_READ_FLUENCE] = "fluence",
    [MURK_READ_IRRADIANCE] = "irradiance",
    [MURK_READ_TRANSMITTANCE] = "transmittance"};

static const char *condition_of(const murk_scene_desc *scene, size_t condition)
{
    return condition == SIZE_MAX ? "" : scene->conditions[condition].name;
}

/* ---- fit.json ---- */

static void add_parameters(cJSON *root, const murk_fit_facts *f)
{
    cJSON *list = cJSON_AddArrayToObject(root, "parameters");
    const murk_calibration *c = f->found;
    for (size_t k = 0; k < f->keys->n; ++k) {
        const murk_free_key *key = &f->keys->key[k];
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "key", key->name);
        murk_json_number(item, "value", c->value[k]);
        if (!f->only_predicts) {
            murk_json_number(item, "standard_error", c->standard_error[k]);
            murk_json_number(item, "lower", c->lower[k]);
            murk_json_number(item, "upper", c->upper[k]);
            cJSON_AddBoolToObject(item, "at_bound", c->at_bound[k]);
            cJSON_AddStringToObject(item, "status",
                                    murk_calibration_status(c, k));
            murk_json_number(item, "start", key->start);
            murk_json_number(item, "bound_lower", key->lower);
            murk_json_number(item, "bound_upper", key->upper);
            cJSON_AddStringToObject(item, "kind", kinds[key->kind]);
            murk_json_number(item, "slope_error",
                             murk_model_slope_error(c->model, k));
        }
        cJSON_AddItemToArray(list, item);
    }
}

static void add_matrix(cJSON *root, const char *name, const double *a, size_t n)
{
    cJSON *rows = cJSON_AddArrayToObject(root, name);
    for (size_t i = 0; i < n; ++i) {
        cJSON *row = cJSON_CreateArray();
        for (size_t j = 0; j < n; ++j) {
            const double value = a[i * n + j];
            cJSON_AddItemToArray(row, isfinite(value)
                                          ? cJSON_CreateNumber(value)
                                          : cJSON_CreateNull());
        }
        cJSON_AddItemToArray(rows, row);
    }
}

/* Directions in search coordinates: in d ln(key) for positive keys. */
static void add_identifiability(cJSON *root, const murk_fit_facts *f)
{
    const murk_certainty *c = &f->found->certainty;
    cJSON *object = cJSON_AddObjectToObject(root, "identifiability");
    cJSON_AddNumberToObject(object, "determined", (double)c->determined);
    cJSON *list = cJSON_AddArrayToObject(object, "directions");
    for (size_t i = 0; i < c->directions; ++i) {
        cJSON *item = cJSON_CreateObject();
        murk_json_number(item, "standard_error", c->direction_error[i]);
        cJSON_AddBoolToObject(item, "determined", i < c->determined);
        cJSON *of = cJSON_AddObjectToObject(item, "direction");
        for (size_t k = 0; k < c->n; ++k) {
            murk_json_number(of, f->keys->key[k].name,
                             c->direction[i * c->n + k]);
        }
        cJSON_AddItemToArray(list, item);
    }
}

static void add_starts(cJSON *root, const murk_fit_facts *f)
{
    const murk_calibration *c = f->found;
    cJSON *list = cJSON_AddArrayToObject(root, "starts");
    for (size_t i = 0; i < c->starts_done; ++i) {
        const murk_calibration_start *start = &c->start[i];
        cJSON *item = cJSON_CreateObject();
        cJSON *from = cJSON_AddObjectToObject(item, "from");
        cJSON *to = cJSON_AddObjectToObject(item, "to");
        for (size_t k = 0; k < c->n; ++k) {
            murk_json_number(from, f->keys->key[k].name, start->from[k]);
            murk_json_number(to, f->keys->key[k].name,
                             isnan(start->chi2) ? NAN : start->to[k]);
        }
        murk_json_number(item, "chi2", start->chi2);
        cJSON_AddBoolToObject(item, "converged", start->converged);
        cJSON_AddStringToObject(item, "why", start->why);
        cJSON_AddNumberToObject(item, "traces", (double)start->traces);
        cJSON_AddItemToArray(list, item);
    }
}

static void add_place(cJSON *list, const murk_fit_facts *f,
                      const murk_next_place *place)
{
    cJSON *item = cJSON_CreateObject();
    if (f->next->kind == MURK_READ_COVERAGE) {
        cJSON_AddStringToObject(item, "type",
                                f->scene->sensors.type[place->pose.type].name);
    }
    murk_json_vector(item, "position_m",
                     murk_scene_user(f->scene, place->pose.position));
    if (f->next->kind == MURK_READ_COVERAGE) {
        murk_json_heading(item, f->scene, &place->pose);
    }
    murk_json_number(item, "gain", place->gain);
    murk_json_number(item, "predicted", place->predicted);
    murk_json_number(item, "standard_error", place->standard_error);
    cJSON_AddItemToArray(list, item);
}

static void add_next(cJSON *root, const murk_fit_facts *f)
{
    if (!f->next) {
        return;
    }
    cJSON *object = cJSON_AddObjectToObject(root, "next");
    cJSON_AddStringToObject(object, "kind", reading_kinds[f->next->kind]);
    cJSON_AddStringToObject(object, "unit",
                            murk_reading_unit_name(f->next->unit));
    cJSON_AddStringToObject(object, "condition",
                            condition_of(f->scene, f->next->condition));
    if (f->next->kind == MURK_READ_IRRADIANCE) {
        murk_json_vector(object, "direction", f->next->direction);
    }
    if (f->next->kind != MURK_READ_COVERAGE) {
        murk_json_number(object, "radius_m", f->next->radius_m);
        murk_json_number(object, "band_nm",
                         f->next->band < 0 ? NAN
                                           : f->scene->band_nm[f->next->band]);
    }
    murk_json_number(object, "relative_error", f->next->relative_error);
    cJSON_AddNumberToObject(object, "candidates", (double)f->next->candidates);
    cJSON_AddNumberToObject(object, "judged", (double)f->next->judged);
    cJSON *list = cJSON_AddArrayToObject(object, "places");
    for (size_t i = 0; i < f->next->n; ++i) {
        add_place(list, f, &f->next->place[i]);
    }
    cJSON *errors = cJSON_AddObjectToObject(object, "standard_errors_with_all");
    for (size_t k = 0; k < f->keys->n; ++k) {
        murk_json_number(errors, f->keys->key[k].name,
                         f->next->standard_error[k]);
    }
}

static void add_held_out(cJSON *root, const murk_calibration *c)
{
    cJSON *object = cJSON_AddObjectToObject(root, "hold_out");
    cJSON_AddNumberToObject(object, "rows", (double)c->held_out);
    murk_json_number(object, "rms", c->held_out_rms);
    murk_json_number(object, "rms_in_standard_errors", c->held_out_rms_sigma);
}

cJSON *murk_fit_json(const murk_fit_facts *f)
{
    const murk_calibration *c = f->found;
    cJSON *root = murk_json_begin(f->scene);
    if (!f->only_predicts) { /* first, since it decides what the rest is worth
                              */
        if (isnan(c->p_value)) {
            cJSON_AddNullToObject(root, "accepted");
        } else {
            cJSON_AddBoolToObject(root, "accepted", c->is_accepted);
        }
        cJSON_AddStringToObject(root, "verdict", c->verdict);
        murk_json_number(root, "p_value", c->p_value);
    }
    cJSON *data = cJSON_AddObjectToObject(root, "data");
    cJSON_AddStringToObject(data, "file", f->measured->path);
    cJSON_AddStringToObject(data, "sha256", f->measured->sha256);
    cJSON_AddNumberToObject(data, "rows", (double)f->measured->rows);
    cJSON_AddNumberToObject(data, "photons", (double)c->photons);
    add_parameters(root, f);
    if (!f->only_predicts) {
        add_matrix(root, "covariance", c->covariance, c->n);
        add_matrix(root, "correlation", c->correlation, c->n);
        murk_json_number(root, "chi2", c->chi2);
        cJSON_AddNumberToObject(root, "degrees_of_freedom",
                                (double)c->degrees_of_freedom);
        cJSON_AddBoolToObject(root, "converged", c->converged);
        cJSON_AddStringToObject(root, "why", c->why);
        cJSON_AddNumberToObject(root, "iterations", c->iterations);
        cJSON_AddNumberToObject(root, "evaluations", (double)c->evaluations);
    }
    cJSON_AddNumberToObject(root, "traces", (double)c->traces);
    murk_json_number(root, "effective_share", c->effective_share);
    murk_json_number(root, "slope_noise", c->slope_noise);
    add_held_out(root, c);
    if (!f->only_predicts) {
        add_identifiability(root, f);
        add_starts(root, f);
    }
    add_next(root, f);
    return root;
}

/* ---- fit.csv ---- */

static void write_number(FILE *file, double value)
{
    char text[32] = "";
    if (isfinite(value)) {
        murk_number_text(text, value);
    }
    fprintf(file, ",%s", text);
}

static void write_row(FILE *file, const murk_fit_facts *f, size_t i)
{
    const murk_measured_row *row = &f->measured->row[i];
    const murk_reading *r = &f->measured->reading[row->first];
    const murk_calibrated_row *c = &f->found->row[i];
    const bool is_coverage = r->kind == MURK_READ_COVERAGE;
    const murk_vec3 at =
        murk_scene_user(f->scene, is_coverage ? r->pose.position : r->position);
    fprintf(file, "%zu,%s,%s,%s", r->line, reading_kinds[r->kind],
            condition_of(f->scene, r->condition), f->measured->group[i]);
    write_number(file, at.x);
    write_number(file, at.y);
    write_number(file, at.z);
    write_number(file, r->band < 0 ? NAN : f->scene->band_nm[r->band]);
    fprintf(file, ",%s,%s", murk_reading_unit_name(r->unit),
            r->is_held_out ? "hold_out" : "fit");
    write_number(file, r->value);
    write_number(file, r->standard_error);
    write_number(file, c->predicted);
    write_number(file, c->photon_error);
    write_number(file, c->residual);
    const bool is_line = r->kind == MURK_READ_TRANSMITTANCE;
    const murk_vec3 to = murk_scene_user(f->scene, r->to);
    write_number(file, is_line ? to.x : NAN);
    write_number(file, is_line ? to.y : NAN);
    write_number(file, is_line ? to.z : NAN);
    fputc('\n', file);
}

static murk_status write_csv(const char *path, const void *context,
                             murk_error *err)
{
    const murk_fit_facts *f = context;
    murk_file *out = NULL;
    const murk_status status = murk_file_create(&out, path, err);
    if (status) {
        return status;
    }
    FILE *file = murk_file_stream(out);
    fputs("line,kind,condition,group,x_m,y_m,z_m,band_nm,unit,use,value,"
          "standard_error,predicted,photon_standard_error,residual_in_"
          "standard_errors,x2_m,y2_m,z2_m\n",
          file);
    for (size_t i = 0; i < f->measured->rows; ++i) {
        write_row(file, f, i);
    }
    const murk_status ended = murk_file_commit(&out, err);
    murk_file_discard(out);
    return ended;
}

murk_status murk_add_fit_csv(murk_results *results, const murk_fit_facts *facts,
                             murk_error *err)
{
    return murk_results_add(results, "fit.csv", write_csv, facts, err);
}

/* ---- the terminal ---- */

/* A value without a standard error is shown to two digits: more would look like
 * knowledge. */
static void print_parameter(const murk_fit_facts *f, size_t k)
{
    const murk_calibration *c = f->found;
    const char *name = f->keys->key[k].name;
    if (murk_calibration_determines(c, k)) {
        murk_print("%-11s %s = %.6g +- %.2g (95 %%: %.4g to %.4g)",
                   k ? "" : "found", name, c->value[k], c->standard_error[k],
                   c->lower[k], c->upper[k]);
    } else {
        murk_print("%-11s %s = %.2g (%s)", k ? "" : "found", name, c->value[k],
                   murk_calibration_status(c, k));
    }
    const double off = murk_model_slope_error(c->model, k);
    if (isfinite(off)) {
        murk_print(", its slopes by re-traced light within %.1g", off);
    }
    murk_print("\n");
}

/* What of a direction is worth naming. */
static void print_direction(const murk_fit_facts *f, const double *direction)
{
    bool is_first = true;
    for (size_t k = 0; k < f->keys->n; ++k) {
        if (fabs(direction[k]) < .1) {
            continue;
        }
        murk_print("%s%.2f %s%s%s",
                   is_first           ? ""
                   : direction[k] < 0 ? " - "
                                      : " + ",
                   is_first ? direction[k] : fabs(direction[k]),
                   f->keys->key[k].is_log ? "ln(" : "", f->keys->key[k].name,
                   f->keys->key[k].is_log ? ")" : "");
        is_first = false;
    }
}

/* Beyond this two parameters are hard to tell apart. */
#define CONFOUNDED .98

static void print_identifiability(const murk_fit_facts *f)
{
    const murk_certainty *c = &f->found->certainty;
    for (size_t i = c->determined; i < c->directions; ++i) {
        murk_print("undetermined ");
        print_direction(f, c->direction + i * c->n);
        if (isfinite(c->direction_error[i])) {
            murk_print(" (to +- %.2g only)", c->direction_error[i]);
        }
        murk_print("\n");
    }
    for (size_t i = 0; i < c->n; ++i) {
        for (size_t j = i + 1; j < c->n; ++j) {
            const double r = c->correlation[i * c->n + j];
            if (fabs(r) > CONFOUNDED) {
                murk_print("confounded  %s and %s (correlation %.3f)\n",
                           f->keys->key[i].name, f->keys->key[j].name, r);
            }
        }
    }
    const bool is_hard = c->determined < c->directions;
    for (size_t i = 0; is_hard && i < c->determined; ++i) {
        murk_print("determined  ");
        print_direction(f, c->direction + i * c->n);
        murk_print(", to +- %.2g\n", c->direction_error[i]);
    }
}

static void print_next(const murk_fit_facts *f)
{
    for (size_t i = 0; f->next && i < f->next->n; ++i) {
        const murk_next_place *p = &f->next->place[i];
        const murk_vec3 d = f->next->direction;
        const murk_vec3 at = murk_scene_user(f->scene, p->pose.position);
        const int digits = murk_coordinate_digits(f->scene, 4);
        murk_print("%-11s %s at (%.*g, %.*g, %.*g) m", i ? "" : "next",
                   reading_kinds[f->next->kind], digits, at.x, digits, at.y,
                   digits, at.z);
        if (f->next->kind == MURK_READ_IRRADIANCE) {
            murk_print(" on a face to (%.3g, %.3g, %.3g)", d.x, d.y, d.z);
        }
        murk_print(", which should read %.4g %s\n", p->predicted,
                   murk_reading_unit_name(f->next->unit));
    }
    for (size_t k = 0; f->next && k < f->keys->n; ++k) {
        murk_print("%-11s %s to +- %.2g\n", k ? "" : "with these",
                   f->keys->key[k].name, f->next->standard_error[k]);
    }
}

/* Beyond this more photons would pay. */
#define MUCH_NOISE .5

void murk_print_fit(const murk_fit_facts *f)
{
    const murk_calibration *c = f->found;
    if (!f->only_predicts && !c->is_accepted) {
        murk_print("fit         %s\n", c->verdict);
    }
    murk_print("data        %s: %zu rows, %zu of them held out\n",
               f->measured->path, f->measured->rows, c->held_out);
    if (c->photons) {
        murk_print(
            "light       %llu photons, traced %zu times; effective share of "
            "the last %.2f\n",
            (unsigned long long)c->photons, c->traces, c->effective_share);
    }
    if (c->slope_noise > MUCH_NOISE) {
        murk_print(
            "            %.0f %% of what they seem to tell of something is "
            "their noise: --emit more\n",
            100 * c->slope_noise);
    }
    if (!f->only_predicts) {
        for (size_t k = 0; k < f->keys->n; ++k) {
            print_parameter(f, k);
        }
        print_identifiability(f);
        if (c->is_accepted) {
            murk_print("fit         %s\n", c->verdict);
        }
        murk_print("search      %s: %s\n",
                   c->converged ? "converged" : "NOT converged", c->why);
    }
    if (c->held_out) {
        murk_print("held out    %zu rows, rms %.4g", c->held_out,
                   isfinite(c->held_out_rms) ? c->held_out_rms
                                             : c->held_out_rms_sigma);
        murk_print("%s\n", isfinite(c->held_out_rms) ? " in their unit"
                                                     : " of their errors");
    }
    print_next(f);
}
