/* One plan for all rows of a study, for the mean of their coverages or for the
 * worst row: picks the rows that take part, has the plans chosen in one
 * process (cases/sweep_choose.h), and has each group measure them in its rows.
 */
#include "cases/sweep_plans.h"

#include "base/file.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "cases/sweep_choose.h"
#include "cases/sweep_store.h"
#include "cases/sweep_work.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool any(const murk_sweep *sweep,
                bool (*is_so)(const murk_sweep_plan *plan))
{
    return is_so(&sweep->plan[MURK_SWEEP_MEAN]) ||
           is_so(&sweep->plan[MURK_SWEEP_WORST]);
}

static bool is_wanted(const murk_sweep_plan *plan)
{
    return plan->is_wanted;
}

static bool is_to_be_made(const murk_sweep_plan *plan)
{
    return plan->is_wanted && !plan->is_reused;
}

/* ---- who has a say ---- */

static bool has_say(const murk_sweep *sweep, const murk_sweep_row *row)
{
    return row->is_done && !row->found.failed[0] &&
           (row->found.emitted > 0 || sweep->sees_in_the_dark);
}

static void find_choosers(murk_sweep *sweep)
{
    const size_t rows = sweep->desc.study->rows;
    size_t all = 0, seen = 0;
    for (size_t i = 0; i < rows; ++i) {
        all += has_say(sweep, &sweep->row[i]);
    }
    const size_t n =
        all < MURK_SWEEP_CHOOSERS_MAX ? all : MURK_SWEEP_CHOOSERS_MAX;
    sweep->choosers = 0;
    for (size_t i = 0; i < rows && sweep->choosers < n; ++i) {
        if (has_say(sweep, &sweep->row[i])) {
            /* the middle of each of n equal parts */
            const size_t next = (2 * sweep->choosers + 1) * all / (2 * n);
            if (seen++ == next) {
                sweep->chooser[sweep->choosers++] = i;
            }
        }
    }
}

/* ---- what is kept ---- */

/* By the rows that have a say. */
static murk_status sign_plans(murk_sweep *sweep, murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for plans");
    }
    for (size_t i = 0; i < sweep->choosers; ++i) {
        fprintf(out, "%s\n", sweep->row[sweep->chooser[i]].key);
    }
    const bool failed = ferror(out) != 0;
    if (fclose(out) != 0 || failed) {
        free(text);
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for plans");
    }
    char sum[65], own[128];
    murk_sha256_hex(text, size, sum);
    free(text);
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        snprintf(own, sizeof own, "%s\n%s", murk_sweep_plan_name(p), sum);
        murk_sha256_hex(own, strlen(own), sweep->plan[p].key);
    }
    return MURK_OK;
}

/* A row's values hang on the row and on the plans. */
static void sign_row(const murk_sweep *sweep, size_t i, char key[65])
{
    char text[3 * 65 + 1] = "";
    snprintf(text, sizeof text, "%s", sweep->row[i].key);
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        if (murk_sweep_plan_stands(&sweep->plan[p])) {
            const size_t n = strlen(text);
            snprintf(text + n, sizeof text - n, "\n%s", sweep->plan[p].key);
        }
    }
    murk_sha256_hex(text, strlen(text), key);
}

/* ---- the plans ---- */

static murk_status take_plan(void *context, const char *bytes, size_t size,
                             murk_error *err)
{
    murk_sweep *sweep = context;
    murk_study_row found;
    const char *text = NULL;
    size_t p = 0;
    murk_status status = murk_sweep_receive(&found, &p, MURK_SWEEP_PLANS, bytes,
                                            size, &text, err);
    if (status) {
        murk_study_row_release(&found);
        return status;
    }
    murk_study_row_release(&sweep->plan[p].found);
    sweep->plan[p].found = found;
    if (!found.failed[0]) {
        status = murk_sweep_keep(sweep, sweep->plan[p].key, text,
                                 size - (size_t)(text - bytes), err);
        sweep->cannot_keep = status != MURK_OK;
    }
    return status;
}

/* In which process it was, it is the study that ends. */
static murk_status after(const murk_sweep *sweep, murk_status status,
                         const murk_error *why, murk_error *err)
{
    if (status == MURK_INTERRUPTED || murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    return status && sweep->cannot_keep
               ? murk_fail(err, why->status, why->where, "%s", why->text)
               : MURK_OK;
}

static murk_status make_plans(murk_sweep *sweep, murk_error *err)
{
    murk_error why = {0};
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        murk_sweep_plan *plan = &sweep->plan[p];
        plan->is_reused =
            plan->is_wanted && murk_sweep_load(sweep, plan->key, &plan->found);
    }
    if (sweep->choosers == 0 || !any(sweep, is_to_be_made)) {
        return MURK_OK;
    }
    const murk_status made =
        murk_isolated_run(murk_sweep_choose, sweep, take_plan, sweep, &why);
    const murk_status status = after(sweep, made, &why, err);
    for (int p = 0; p < MURK_SWEEP_PLANS && made; ++p) {
        murk_sweep_plan *plan = &sweep->plan[p];
        if (is_to_be_made(plan) && plan->found.sensors == 0) {
            murk_study_row_fail(&plan->found, &why);
        }
    }
    return status;
}

/* ---- the rows ---- */

/* Values of plans that stand; others have none. */
static murk_status put_values(murk_sweep *sweep, size_t i,
                              const murk_study_row *from, murk_error *err)
{
    murk_sweep_row *row = &sweep->row[i];
    murk_status status = MURK_OK;
    for (int p = 0; p < MURK_SWEEP_PLANS && !status; ++p) {
        const char *name = murk_sweep_plan_name(p);
        const murk_study_value *value =
            from ? murk_study_row_get(from, name) : NULL;
        if (sweep->plan[p].is_wanted) {
            status = murk_study_row_add(
                &row->found, name, "",
                value ? value->of : (murk_estimate){NAN, NAN}, err);
        }
    }
    if (from && from->failed[0]) {
        char text[MURK_ROW_TEXT_SIZE];
        snprintf(text, sizeof text, "the plans for all rows: %.900s",
                 from->failed);
        murk_study_row_add_note(&row->found, text);
    }
    row->has_plans = true;
    return status;
}

static murk_status take_values(void *context, const char *bytes, size_t size,
                               murk_error *err)
{
    murk_sweep *sweep = context;
    murk_study_row found;
    const char *text = NULL;
    size_t i = 0;
    murk_status status = murk_sweep_receive(&found, &i, sweep->desc.study->rows,
                                            bytes, size, &text, err);
    if (!status) {
        murk_progress_add_to_group(1);
        status = put_values(sweep, i, &found, err);
    }
    if (!status && !found.failed[0]) {
        char key[65];
        sign_row(sweep, i, key);
        status = murk_sweep_keep(sweep, key, text,
                                 size - (size_t)(text - bytes), err);
        sweep->cannot_keep = status != MURK_OK;
    }
    murk_study_row_release(&found);
    return status;
}

static murk_status load_values(murk_sweep *sweep, murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < sweep->desc.study->rows && !status; ++i) {
        murk_study_row found = {0};
        char key[65];
        const murk_sweep_row *row = &sweep->row[i];
        if (!row->is_done || row->found.failed[0]) {
            continue;
        }
        sign_row(sweep, i, key);
        if (!any(sweep, murk_sweep_plan_stands)) {
            status = put_values(sweep, i, NULL, err);
        } else if (murk_sweep_load(sweep, key, &found)) {
            status = put_values(sweep, i, &found, err);
        }
        murk_study_row_release(&found);
    }
    return status;
}

static murk_status measure_group(murk_sweep *sweep,
                                 const murk_sweep_group *group, murk_error *err)
{
    murk_sweep_job job = {
        .sweep = sweep, .group = group, .measures_plans = true};
    murk_error why = {0};
    size_t lack = 0;
    /* Nothing is left to do if every row has its values. */
    for (size_t k = 0; k < group->n; ++k) {
        lack += murk_sweep_lacks_values(&sweep->row[group->row[k]]);
    }
    if (lack == 0) {
        return MURK_OK;
    }
    /* The process of the group measures; rows that it did not reach have
     * failed. */
    const murk_status made =
        murk_isolated_run(murk_sweep_work, &job, take_values, sweep, &why);
    murk_status status = after(sweep, made, &why, err);
    for (size_t k = 0; k < group->n && !status; ++k) {
        const size_t i = group->row[k];
        if (murk_sweep_lacks_values(&sweep->row[i])) {
            murk_study_row none = {0};
            murk_study_row_fail(&none, &why);
            status = put_values(sweep, i, &none, err);
        }
    }
    return status;
}

/* ---- all ---- */

static void sum_up(murk_sweep *sweep, int p)
{
    murk_sweep_plan *plan = &sweep->plan[p];
    const size_t rows = sweep->desc.study->rows;
    double n = 0, sum = 0, errors = 0;
    plan->mean = plan->worst = (murk_estimate){NAN, NAN};
    plan->worst_row = rows;
    for (size_t i = 0; i < rows; ++i) {
        const murk_study_value *v =
            murk_study_row_get(&sweep->row[i].found, murk_sweep_plan_name(p));
        if (v && isfinite(v->of.value)) {
            ++n;
            sum += v->of.value;
            errors += v->of.standard_error;
            if (plan->worst_row == rows || v->of.value < plan->worst.value) {
                plan->worst = v->of;
                plan->worst_row = i;
            }
        }
    }
    if (n > 0) {
        plan->mean = (murk_estimate){sum / n, errors / n};
    }
}

murk_status murk_sweep_plan_all(murk_sweep *sweep, murk_error *err)
{
    if (!any(sweep, is_wanted)) {
        return MURK_OK;
    }
    find_choosers(sweep);
    murk_status status = sign_plans(sweep, err);
    if (!status) {
        status = make_plans(sweep, err);
    }
    if (!status) {
        status = load_values(sweep, err);
    }
    for (size_t g = 0; g < sweep->groups && !status; ++g) {
        status = measure_group(sweep, &sweep->group[g], err);
    }
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        sum_up(sweep, p);
    }
    return status;
}
