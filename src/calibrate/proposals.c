/* Predicts a reading and slopes at every candidate with a forward model of its
 * own, and selects candidates by the determinant of the information, greedily
 * and then by exchanges (fit/optimal.h). */
#include "calibrate/proposals.h"

#include "base/quantile.h"
#include "plan/poses.h"
#include "plan/sites.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The error that is assumed for a reading is at least that of a reading of this
 * share of the largest predicted one. Otherwise places where almost nothing is
 * measured would seem best. */
#define FLOOR_SHARE .01

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "for proposals");
}

void murk_proposals_release(murk_proposals *out)
{
    free(out->place);
    free(out->standard_error);
    *out = (murk_proposals){0};
}

/* Determines the most frequent kind of the fitted readings of light and
 * coverage, the median of the relative errors of these readings, and the first
 * of them as an example. */
static murk_status choose_kind(murk_proposals *out,
                               const murk_reading **example,
                               const murk_readings *measured, murk_error *err)
{
    /* Count the kinds. */
    size_t count[MURK_READING_KINDS] = {0};
    for (size_t i = 0; i < measured->rows; ++i) {
        const murk_reading *reading = murk_reading_of_row(measured, i);
        count[reading->kind] +=
            !reading->is_held_out && murk_reading_needs_light(reading->kind);
    }
    out->kind = MURK_READ_COVERAGE;
    for (int kind = 0; kind < MURK_READING_KINDS; ++kind) {
        out->kind = count[kind] > count[out->kind] ? (murk_reading_kind)kind
                                                   : out->kind;
    }
    const size_t n = count[out->kind];
    if (n == 0) {
        return murk_fail(err, MURK_BAD_VALUE, measured->path,
                         "no reading of coverage, fluence or irradiance is "
                         "fitted: new places are proposed for such readings");
    }
    /* Median of the relative errors. */
    double *error = malloc(n * sizeof *error);
    if (!error) {
        return no_memory(err);
    }
    const murk_reading *first = NULL;
    for (size_t i = 0, k = 0; i < measured->rows; ++i) {
        const murk_reading *reading = murk_reading_of_row(measured, i);
        if (reading->kind == out->kind && !reading->is_held_out) {
            first = first ? first : reading;
            error[k++] = reading->standard_error /
                         fmax(fabs(reading->value), reading->standard_error);
        }
    }
    murk_sort(error, n);
    out->relative_error = error[n / 2];
    free(error);
    /* Properties of the example; n readings were counted. */
    assert(first);
    out->unit = first->unit;
    out->condition = first->condition;
    out->direction = first->direction;
    out->radius_m = first->radius_m;
    out->band = first->band;
    *example = first;
    return MURK_OK;
}

static murk_status check_sensors(const murk_scene_desc *scene, murk_error *err)
{
    return scene->sensors.given
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, scene->path,
                           "sensors: the scene has none, and new places are "
                           "chosen among its candidates");
}

murk_status murk_proposals_check(const murk_readings *measured,
                                 const murk_scene_desc *scene, murk_error *err)
{
    murk_proposals kind;
    const murk_reading *example;
    const murk_status status = choose_kind(&kind, &example, measured, err);
    return status ? status : check_sensors(scene, err);
}

/* Lists the candidates of the scene, poses (without those of fixed sensors) for
 * coverage and positions else, or every k-th of them if there are too many. The
 * caller owns *pose, which has out->judged elements. */
static murk_status list_poses(murk_pose **pose, murk_proposals *out,
                              const murk_stage *stage, unsigned threads,
                              murk_error *err)
{
    murk_candidates *sites = NULL;
    murk_poses *poses = NULL;
    murk_status status = murk_sites_find(&sites, stage, threads, err);
    const bool has_poses = out->kind == MURK_READ_COVERAGE;
    if (!status && has_poses) {
        status = murk_poses_create(&poses, stage->scene, &stage->world.domain,
                                   sites->position, sites->usable, err);
    }
    /* Thin to the limit. */
    if (!status) {
        const size_t all =
            has_poses ? poses->count - poses->fixed : sites->usable;
        const size_t every = (all + MURK_PROPOSALS_CANDIDATES_MAX - 1) /
                             MURK_PROPOSALS_CANDIDATES_MAX;
        const size_t n = (all + every - 1) / every;
        out->candidates = all;
        out->judged = n;
        *pose = calloc(n + 1, sizeof **pose);
        status = *pose ? MURK_OK : no_memory(err);
        for (size_t i = 0; i < n && !status; ++i) {
            (*pose)[i] =
                has_poses ? poses->pose[i * every]
                          : (murk_pose){.position = sites->position[i * every]};
        }
    }
    murk_poses_destroy(poses);
    murk_candidates_destroy(sites);
    return status;
}

/* Makes a reading and a row for each candidate, with the properties of the
 * example. */
static murk_status make_rows(murk_readings *out, const murk_readings *measured,
                             const murk_reading *example, const murk_pose *pose,
                             size_t n, murk_error *err)
{
    *out = *measured;
    out->reading = calloc(n + 1, sizeof *out->reading);
    out->row = calloc(n + 1, sizeof *out->row);
    out->readings = out->rows = n;
    out->held_out = 0;
    if (!out->reading || !out->row) {
        return no_memory(err);
    }
    for (size_t i = 0; i < n; ++i) {
        out->reading[i] = *example;
        out->reading[i].position = pose[i].position;
        out->reading[i].pose = pose[i];
        out->row[i] = (murk_reading_row){i, 1};
    }
    return MURK_OK;
}

/* Slopes are reduced by this many standard errors, because the best of hundreds
 * of candidates would otherwise be the one with the largest error. */
#define SIGMAS_LESS 2

/* Moves the slopes of the last prediction towards 0 by a number of standard
 * errors. */
static murk_status discount(double *slope, const murk_model *model, size_t n,
                            murk_error *err)
{
    double *part;
    const murk_status status = murk_model_parts(model, &part, err);
    if (status) {
        return status;
    }
    const murk_model_facts *facts = murk_model_facts_of(model);
    const size_t runs = facts->runs, lights = facts->lights;
    /* The standard error of a slope from the contributions of the runs. */
    for (size_t i = 0; i < lights * n; ++i) {
        const size_t row = i / n, k = i % n;
        const double *of_row = part + row * (n + 1) + 1 + k;
        double sum = 0, squares = 0;
        for (size_t run = 0; run < runs; ++run) {
            sum += of_row[run * lights * (n + 1)];
        }
        for (size_t run = 0; run < runs; ++run) {
            const double off =
                of_row[run * lights * (n + 1)] - sum / (double)runs;
            squares += off * off;
        }
        const double error = sqrt((double)runs / ((double)runs - 1) * squares);
        double *s = &slope[facts->light[row] * n + k];
        *s = copysign(fmax(0, fabs(*s) - SIGMAS_LESS * error), *s);
    }
    free(part);
    return MURK_OK;
}

/* Fills error[rows] with the error that is assumed for each reading, and
 * row[rows][n] with the slopes in search coordinates divided by that error (0
 * if the error is 0). */
static void weigh_rows(double *row, double *error, const double *predicted,
                       const double *slope, size_t rows, double relative_error,
                       const murk_free_keys *keys, const double *value)
{
    double max = 0;
    for (size_t i = 0; i < rows; ++i) {
        max = fmax(max, fabs(predicted[i]));
    }
    for (size_t i = 0; i < rows; ++i) {
        error[i] = relative_error * fmax(fabs(predicted[i]), FLOOR_SHARE * max);
        for (size_t k = 0; k < keys->n; ++k) {
            const double by_x = keys->key[k].is_log ? value[k] : 1;
            const double at = slope[i * keys->n + k] * by_x;
            row[i * keys->n + k] = error[i] > 0 ? at / error[i] : 0;
        }
    }
}

/* Predicts the standard errors of the parameters with the selected readings. */
static murk_status predict_errors(murk_proposals *out,
                                  const murk_calibration *found,
                                  const murk_free_keys *keys, const double *row,
                                  const murk_optimal_pick *pick,
                                  murk_error *err)
{
    const size_t n = keys->n, fitted = found->fitted;
    /* Append the selected rows to those of the fit. */
    double *all = malloc((fitted + out->n) * n * sizeof *all);
    murk_certainty certainty = {0};
    if (!all) {
        return no_memory(err);
    }
    memcpy(all, found->jacobian, fitted * n * sizeof *all);
    for (size_t i = 0; i < out->n; ++i) {
        memcpy(all + (fitted + i) * n, row + pick[i].candidate * n,
               n * sizeof *all);
    }
    /* Covariance of all rows. */
    const murk_status status = murk_certainty_create(
        &certainty, all, fitted + out->n, n, found->at_bound, found->scale,
        MURK_UNDETERMINED, err);
    for (size_t k = 0; k < n && !status; ++k) {
        out->standard_error[k] = certainty.standard_error[k] *
                                 (keys->key[k].is_log ? found->value[k] : 1);
    }
    murk_certainty_release(&certainty);
    free(all);
    return status;
}

/* Predicts all candidates and selects k of them. */
static murk_status judge(murk_proposals *out, size_t k, murk_model *model,
                         const murk_pose *pose, const murk_calibration *found,
                         const murk_calibration_desc *desc, murk_error *err)
{
    const murk_free_keys *keys = desc->keys;
    const size_t n = keys->n, rows = out->judged;
    double share;
    murk_arena arena = {0};
    double *predicted = murk_arena_array(&arena, rows, sizeof(double));
    double *error = murk_arena_array(&arena, rows, sizeof(double));
    double *slope = murk_arena_array(&arena, rows * n, sizeof(double));
    double *row = murk_arena_array(&arena, rows * n, sizeof(double));
    murk_optimal_pick *pick = murk_arena_array(&arena, k, sizeof *pick);
    murk_status status = arena.is_short ? no_memory(err) : MURK_OK;
    /* Predict, with slopes reduced by their errors. */
    if (status || (status = murk_model_trace(model, found->value, err)) ||
        (status = murk_model_predict(model, found->value, predicted, slope,
                                     &share, err)) ||
        (status = discount(slope, model, n, err))) {
        goto done;
    }
    /* Select. */
    weigh_rows(row, error, predicted, slope, rows, out->relative_error, keys,
               found->value);
    out->n = k < rows ? k : rows;
    status = murk_optimal_choose(pick, out->n, found->information, row, rows, n,
                                 err);
    /* Fill the result. */
    for (size_t i = 0; i < out->n && !status; ++i) {
        const size_t c = pick[i].candidate;
        out->place[i] = (murk_proposed_place){pose[c], pick[i].gain,
                                              predicted[c], error[c]};
    }
    status = status ? status : predict_errors(out, found, keys, row, pick, err);
done:
    murk_arena_release(&arena);
    return status;
}

/* Lists the candidates in the condition of the example. */
static murk_status list_candidates(murk_pose **pose, murk_proposals *out,
                                   const murk_calibration *found,
                                   const murk_calibration_desc *desc,
                                   murk_error *err)
{
    size_t c = 0;
    while (desc->keys->condition[c] != out->condition) {
        ++c;
    }
    const murk_stage *stage = murk_model_stage(found->model, c);
    const murk_status status = check_sensors(stage->scene, err);
    return status ? status : list_poses(pose, out, stage, desc->threads, err);
}

murk_status murk_proposals_create(murk_proposals *out, size_t k,
                                  const murk_calibration *found,
                                  const murk_calibration_desc *desc,
                                  murk_error *err)
{
    *out =
        (murk_proposals){.place = calloc(k + 1, sizeof *out->place),
                         .standard_error = calloc(desc->keys->n + 1,
                                                  sizeof *out->standard_error)};
    const murk_reading *example = NULL;
    murk_readings rows = {0};
    const murk_model_desc of = {.keys = desc->keys,
                                .measured = &rows,
                                .imported = desc->imported,
                                .threads = desc->threads};
    murk_model *model = NULL;
    murk_pose *pose = NULL;
    murk_status status =
        out->place && out->standard_error ? MURK_OK : no_memory(err);
    /* Kind of reading, candidates, and a forward model of them. */
    if (status || (status = choose_kind(out, &example, desc->measured, err)) ||
        (status = list_candidates(&pose, out, found, desc, err)) ||
        (status = make_rows(&rows, desc->measured, example, pose, out->judged,
                            err)) ||
        (status = murk_model_create(&model, &of, err))) {
        goto done;
    }
    status = judge(out, k, model, pose, found, desc, err);
done:
    murk_model_destroy(model);
    free(rows.reading);
    free(rows.row);
    free(pose);
    return status;
}
