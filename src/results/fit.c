/* A fit or prediction: fields of fit.json and predict.json, columns of fit.csv,
 * and the summary. */
#include "results/fit.h"

#include "calibrate/verdict.h"
#include "readings/readings.h"
#include "results/coverage.h"
#include "results/summary.h"
#include "scene/places.h"

#include <math.h>
#include <string.h>

static const char *const kinds[] = {[MURK_FREE_MEDIUM] = "medium",
                                    [MURK_FREE_LIGHT] = "light",
                                    [MURK_FREE_GAIN] = "gain",
                                    [MURK_FREE_WORLD] = "world"};

static const char *condition_of(const murk_scene_desc *scene, size_t condition)
{
    return condition == SIZE_MAX ? "" : scene->conditions[condition].name;
}

/* ---- fit.json ---- */

static void list_parameter(murk_results_fields *fields, const void *of,
                           size_t k)
{
    const murk_fit_facts *f = of;
    const murk_calibration *c = f ? f->found : NULL;
    const murk_free_key *key = f ? &f->keys->key[k] : NULL;
    MURK_TEXT(fields, "key", "path of the scene's key", key->name);
    MURK_NUMBER(fields, "value", "", "found", c->value[k]);
    if (!MURK_LISTED_IF(fields, !f->only_predicts)) {
        return;
    }
    /* A prediction does not search, so the other fields are left out. */
    MURK_NUMBER(fields, "standard_error", "", "of value", c->standard_error[k]);
    MURK_NUMBER(fields, "lower", "", "95 % confidence limit", c->lower[k]);
    MURK_NUMBER(fields, "upper", "", "95 % confidence limit", c->upper[k]);
    MURK_FLAG(fields, "at_bound", "true if value lies at a bound",
              c->at_bound[k]);
    MURK_TEXT(fields, "status",
              "determined, at its bound, or not determined by these data; "
              "only the first has an error",
              murk_calibration_status(c, k));
    MURK_NUMBER(fields, "start", "", "value that the search began at",
                key->start);
    MURK_NUMBER(fields, "bound_lower", "", "least value allowed", key->lower);
    MURK_NUMBER(fields, "bound_upper", "", "greatest value allowed",
                key->upper);
    MURK_TEXT(fields, "kind", "medium, light, world or gain", kinds[key->kind]);
    MURK_NUMBER(fields, "slope_error", "1",
                "largest error of slopes from light that was traced again",
                murk_model_slope_error(c->model, k));
}

static cJSON *matrix_json(const double *a, size_t n)
{
    cJSON *rows = cJSON_CreateArray();
    for (size_t i = 0; i < n; ++i) {
        cJSON_AddItemToArray(rows, cJSON_CreateDoubleArray(a + i * n, (int)n));
    }
    return rows;
}

/* An object with the number value[k] for each key k; null for all keys if value
 * is NULL. */
static cJSON *by_key(const murk_fit_facts *f, const double *value)
{
    cJSON *object = cJSON_CreateObject();
    for (size_t k = 0; k < f->keys->n; ++k) {
        cJSON_AddNumberToObject(object, f->keys->key[k].name,
                                value ? value[k] : NAN);
    }
    return object;
}

/* Lists a direction in the space of the parameters, with the standard error
 * along the direction. The component of a key is one of the logarithm of the
 * key, if the key is searched in logarithms, else one of the value. */
static void list_direction(murk_results_fields *fields, const void *of,
                           size_t i)
{
    const murk_fit_facts *f = of;
    const murk_certainty *c = f ? &f->found->certainty : NULL;
    MURK_NUMBER(fields, "standard_error", "", "along the direction",
                c->direction_error[i]);
    MURK_FLAG(fields, "determined", "true if the data tell of it",
              i < c->determined);
    MURK_JSON(fields, "direction", "",
              "by key; of positive keys, of the logarithm",
              by_key(f, c->direction + i * c->n));
}

static void list_identifiability(murk_results_fields *fields, const void *of)
{
    const murk_fit_facts *f = of;
    MURK_COUNT(fields, "determined", "directions that are known",
               f->found->certainty.determined);
    MURK_LIST(fields, "directions", "from the best known on", list_direction, f,
              f->found->certainty.directions);
}

static void list_start(murk_results_fields *fields, const void *of, size_t i)
{
    const murk_fit_facts *f = of;
    const murk_calibration_start *start = f ? &f->found->start[i] : NULL;
    MURK_JSON(fields, "from", "", "by key", by_key(f, start->from));
    MURK_JSON(fields, "to", "", "by key",
              by_key(f, isnan(start->chi2) ? NULL : start->to));
    MURK_NUMBER(fields, "chi2", "", "at the end", start->chi2);
    MURK_FLAG(fields, "converged", "true if the search did", start->converged);
    MURK_TEXT(fields, "why", "the search ended", start->why);
    MURK_COUNT(fields, "traces",
               "lights traced; 0: on the light of the first start",
               start->traces);
}

static void list_next_place(murk_results_fields *fields, const void *of,
                            size_t i)
{
    const murk_fit_facts *f = of;
    const murk_proposed_place *place = f ? &f->next->place[i] : NULL;
    const murk_posed p =
        f ? (murk_posed){f->scene, &place->pose} : (murk_posed){NULL, NULL};
    const bool is_coverage =
        MURK_LISTED_IF(fields, f->next->kind == MURK_READ_COVERAGE);
    if (is_coverage) {
        murk_results_list_type(fields, p);
    }
    murk_results_list_position(fields, p);
    if (is_coverage) {
        murk_results_list_heading(fields, p);
    }
    MURK_NUMBER(fields, "gain", "",
                "in knowledge of the parameters, natural logarithm",
                place->gain);
    MURK_NUMBER(fields, "predicted", "", "reading", place->predicted);
    MURK_NUMBER(fields, "standard_error", "", "of predicted",
                place->standard_error);
}

static void list_next(murk_results_fields *fields, const void *of)
{
    const murk_fit_facts *f = of;
    const murk_proposals *next = f ? f->next : NULL;
    MURK_TEXT(fields, "kind", "coverage, fluence, irradiance or transmittance",
              murk_reading_kinds[next->kind]);
    MURK_TEXT(fields, "unit", "of the reading",
              murk_reading_unit_name(next->unit));
    MURK_TEXT(fields, "condition", "of the reading",
              condition_of(f->scene, next->condition));
    /* Fields that depend on the kind of reading. */
    if (MURK_LISTED_IF(fields, next->kind == MURK_READ_IRRADIANCE)) {
        MURK_VECTOR(fields, "direction", "", "the irradiated face looks to",
                    next->direction);
    }
    if (MURK_LISTED_IF(fields, next->kind != MURK_READ_COVERAGE)) {
        MURK_NUMBER(fields, "radius_m", "m", "of the receiver", next->radius_m);
        MURK_NUMBER(fields, "band_nm", "nm", "of the reading",
                    next->band < 0 ? NAN : f->scene->band_nm[next->band]);
    }
    MURK_NUMBER(fields, "relative_error", "1", "of a reading",
                next->relative_error);
    MURK_COUNT(fields, "candidates", "places looked at", next->candidates);
    MURK_COUNT(fields, "judged", "places that were compared", next->judged);
    MURK_LIST(fields, "places", "the best, in order", list_next_place, f,
              next->n);
    MURK_JSON(fields, "standard_errors_with_all", "",
              "of the parameters, by key, once all of these are measured",
              by_key(f, next->standard_error));
}

static void list_data(murk_results_fields *fields, const void *of)
{
    const murk_fit_facts *f = of;
    MURK_TEXT(fields, "file", "of the measurements", f->measured->path);
    MURK_TEXT(fields, "sha256", "of the file; with a mapping, of both",
              f->measured->sha256);
    MURK_COUNT(fields, "rows", "of the file", f->measured->rows);
    MURK_COUNT(fields, "photons", "of each light", f->found->photons);
}

static void list_held_out(murk_results_fields *fields, const void *of)
{
    const murk_calibration *c = of;
    MURK_COUNT(fields, "rows", "that were not fitted", c->held_out);
    MURK_NUMBER(fields, "rms", "", "residual in the rows' unit",
                c->held_out_rms);
    MURK_NUMBER(fields, "rms_in_standard_errors", "1", "residual",
                c->held_out_rms_sigma);
}

/* The verdict comes first, because the other values are of use only if the
 * model is accepted. */
static void list_verdict(murk_results_fields *fields, const murk_calibration *c)
{
    if (MURK_LISTED_IF(fields, !isnan(c->p_value))) {
        MURK_FLAG(fields, "accepted",
                  "false: chi-squared refuses the model (p_value below "
                  "1e-4), so the values are not to be used; null: no more "
                  "readings than values",
                  c->is_accepted);
    } else {
        MURK_NULL(fields, "accepted", "", "");
    }
    MURK_TEXT(fields, "verdict",
              "whether the model fits, and which parameters the data do not "
              "determine, in words",
              c->verdict);
    MURK_NUMBER(fields, "p_value", "1",
                "chance of so large a chi2, or a larger one, if model and "
                "errors are right",
                c->p_value);
}

static void list_search(murk_results_fields *fields, const murk_calibration *c)
{
    MURK_JSON(fields, "covariance", "", "in the parameters' order",
              matrix_json(c->covariance, c->n));
    MURK_JSON(fields, "correlation", "1", "in the parameters' order",
              matrix_json(c->correlation, c->n));
    MURK_NUMBER(fields, "chi2", "",
                "sum of squared residuals in "
                "standard errors",
                c->chi2);
    MURK_NUMBER(fields, "degrees_of_freedom", "", "of chi2",
                (double)c->degrees_of_freedom);
    MURK_FLAG(fields, "converged", "true if the search did", c->converged);
    MURK_TEXT(fields, "why", "the search ended", c->why);
    MURK_COUNT(fields, "iterations", "of the search", (uint64_t)c->iterations);
    MURK_COUNT(fields, "evaluations", "of the model", c->evaluations);
}

void murk_results_list_fit(murk_results_fields *fields, const void *of)
{
    const murk_fit_facts *f = of;
    const murk_calibration *c = f ? f->found : NULL;
    /* predict.json has no fields about the search. */
    const bool fits = MURK_LISTED_IF(fields, !f->only_predicts);
    murk_results_list_head(fields, f ? f->scene : NULL);
    if (fits) {
        list_verdict(fields, c);
    }
    MURK_OBJECT(fields, "data", "the measurements", list_data, f);
    MURK_LIST(fields, "parameters", "the free keys", list_parameter, f,
              f->keys->n);
    if (fits) {
        list_search(fields, c);
    }
    MURK_COUNT(fields, "traces", "lights traced", c->traces);
    MURK_NUMBER(fields, "effective_share", "1",
                "effective sample of the re-weighted light over its photons",
                c->effective_share);
    MURK_NUMBER(fields, "slope_noise", "1",
                "share of the errors that photons' noise in slopes makes up",
                c->slope_noise);
    MURK_OBJECT(fields, "hold_out", "rows that were not fitted", list_held_out,
                c);
    if (fits) {
        MURK_OBJECT(fields, "identifiability",
                    "how well the data determine the parameters",
                    list_identifiability, f);
        MURK_LIST(fields, "starts", "of the search, restarts last", list_start,
                  f, c->starts_done);
    }
    if (MURK_LISTED_IF(fields, f->next)) {
        MURK_OBJECT(fields, "next", "with --next", list_next, f);
    }
}

/* ---- fit.csv ---- */

static murk_vec3 position_of(const murk_fit_facts *f, const murk_reading *r)
{
    return murk_scene_user(f->scene, r->kind == MURK_READ_COVERAGE
                                         ? r->pose.position
                                         : r->position);
}

/* The second end of the segment of a reading of transmittance; NaN for other
 * kinds. */
static murk_vec3 end_of(const murk_fit_facts *f, const murk_reading *r)
{
    return r->kind == MURK_READ_TRANSMITTANCE ? murk_scene_user(f->scene, r->to)
                                              : murk_vec(NAN, NAN, NAN);
}

void murk_results_list_fit_row(murk_results_fields *fields, const void *of,
                               size_t i)
{
    const murk_fit_facts *f = of;
    const murk_reading *r = f ? murk_reading_of_row(f->measured, i) : NULL;
    const murk_calibrated_row *c = f ? &f->found->row[i] : NULL;
    MURK_COUNT(fields, "line", "of the data", r->line);
    MURK_TEXT(fields, "kind",
              "coverage, fluence, irradiance, transmittance or extinction",
              murk_reading_kinds[r->kind]);
    MURK_TEXT(fields, "condition", "of the reading",
              condition_of(f->scene, r->condition));
    MURK_TEXT(fields, "group", "of readings", f->measured->group[i]);
    /* The place; the second end of a segment is in the last columns. */
    MURK_NUMBER(fields, "x_m", "m", "place", position_of(f, r).x);
    MURK_NUMBER(fields, "y_m", "m", "place", position_of(f, r).y);
    MURK_NUMBER(fields, "z_m", "m", "place", position_of(f, r).z);
    MURK_NUMBER(fields, "band_nm", "nm", "of the reading",
                r->band < 0 ? NAN : f->scene->band_nm[r->band]);
    MURK_TEXT(fields, "unit", "of value", murk_reading_unit_name(r->unit));
    MURK_TEXT(fields, "use", "fit or hold_out",
              r->is_held_out ? "hold_out" : "fit");
    MURK_NUMBER(fields, "value", "", "reading", r->value);
    MURK_NUMBER(fields, "standard_error", "", "of value", r->standard_error);
    MURK_NUMBER(fields, "predicted", "", "by the model", c->predicted);
    MURK_NUMBER(fields, "photon_standard_error", "", "of predicted",
                c->photon_error);
    MURK_NUMBER(fields, "residual_in_standard_errors", "1", "of the reading",
                c->residual);
    MURK_NUMBER(fields, "x2_m", "m", "end of a line", end_of(f, r).x);
    MURK_NUMBER(fields, "y2_m", "m", "end of a line", end_of(f, r).y);
    MURK_NUMBER(fields, "z2_m", "m", "end of a line", end_of(f, r).z);
}

/* ---- the terminal ---- */

/* A value that the data do not determine is shown with two digits, because more
 * would look like knowledge. */
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

/* Prints the components of a direction whose absolute value is at least 0.1. */
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

/* Two parameters with a correlation above this, or below its negative, are hard
 * to tell apart. */
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
    /* Pairs of parameters that are hard to tell apart. */
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

/* Prints the root mean square of the residuals of a prediction. */
static void print_prediction(const murk_fit_facts *f)
{
    double squares = 0;
    for (size_t i = 0; i < f->measured->rows; ++i) {
        const double residual = f->found->row[i].residual;
        squares += residual * residual;
    }
    murk_print("predicted   %zu rows, rms residual %.4g standard errors; each "
               "row is in fit.csv\n",
               f->measured->rows, sqrt(squares / (double)f->measured->rows));
}

static void print_next(const murk_fit_facts *f)
{
    for (size_t i = 0; f->next && i < f->next->n; ++i) {
        const murk_proposed_place *p = &f->next->place[i];
        const murk_vec3 d = f->next->direction;
        const murk_vec3 at = murk_scene_user(f->scene, p->pose.position);
        const int digits = murk_coordinate_digits(f->scene, 4);
        murk_print("%-11s %s at (%.*g, %.*g, %.*g) m", i ? "" : "next",
                   murk_reading_kinds[f->next->kind], digits, at.x, digits,
                   at.y, digits, at.z);
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

/* If noise in slopes is more than this share of the apparent information, more
 * photons would help. */
#define MUCH_NOISE .5

void murk_print_fit(const void *of)
{
    const murk_fit_facts *f = of;
    const murk_calibration *c = f->found;
    if (!f->only_predicts && !c->is_accepted) {
        murk_print("fit         %s\n", c->verdict);
    }
    murk_print("data        %s: %zu rows, %zu of them held out\n",
               f->measured->path, f->measured->rows, c->held_out);
    /* The light of the search. */
    if (c->photons) {
        murk_print(
            "light       %llu photons, traced %zu times; effective share of "
            "the last %.2f\n",
            (unsigned long long)c->photons, c->traces, c->effective_share);
    }
    if (c->slope_noise > MUCH_NOISE) {
        murk_print(
            "noise       of what the readings seem to say about a parameter, "
            "or a combination of parameters, up to %.0f %% is photon noise: "
            "take more photons, or readings that separate the parameters, "
            "such as transmittance\n",
            100 * c->slope_noise);
    }
    /* Parameters, and how the search ended. */
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
    if (f->only_predicts) {
        print_prediction(f);
    }
    print_next(f);
}
