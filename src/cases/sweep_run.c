/* Runs a study. Each group of rows is measured in a subprocess of its own, or
 * in this process if the host says so (base/isolated.h). A row that fails
 * leaves the other rows alone. Then the plans for all rows are made, as far as
 * the study asks for them: one for the mean of the coverages and one for the
 * worst row. The rows that take part are picked, the plans are chosen in one
 * subprocess (sweep_choose.c), and a subprocess for each group measures them in
 * the rows of the group. */
#include "cases/sweep.h"

#include "base/file.h"
#include "base/progress.h"
#include "base/ranks.h"
#include "cases/scenario_mean.h"
#include "cases/sweep_jobs.h"
#include "cases/sweep_light.h"
#include "cases/sweep_part.h"
#include "cases/sweep_ranks.h"
#include "cases/sweep_store.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- rows ---- */

/* A murk_sweep_put. */
static murk_status put_row(murk_sweep *sweep, murk_sweep_message *message,
                           murk_error *err)
{
    murk_sweep_row *row = &sweep->row[message->number];
    const murk_status status = murk_sweep_keep(sweep, row->key, message, err);
    murk_sweep_ranks_add(sweep, message->number, &message->row);
    murk_study_row_release(&row->found);
    row->found = message->row;
    message->row = (murk_study_row){0};
    row->is_done = true;
    /* Report progress. */
    if (!status) {
        murk_progress_add_to_group(1);
    }
    if (!status && sweep->desc.row_done) {
        sweep->desc.row_done(sweep->desc.context, message->number);
    }
    return status;
}

/* The key of the coverages of the plans in one row: it depends on the row and
 * on the plans. */
static void sign_values(const murk_sweep *sweep, size_t i, char key[65])
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

/* Adds the coverages of the plans to row i: NaN for a plan that `from` has
 * none of. */
static murk_status add_values(murk_sweep *sweep, size_t i,
                              const murk_study_row *from, murk_error *err)
{
    murk_sweep_row *row = &sweep->row[i];
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        const char *name = murk_sweep_plan_name(p);
        const murk_study_value *value = murk_study_row_get(from, name);
        if (sweep->plan[p].is_wanted) {
            murk_study_row_add(&row->found, name, "",
                               value ? value->of : (murk_estimate){NAN, NAN});
        }
    }
    if (from->failed[0]) {
        char text[MURK_ROW_TEXT_SIZE];
        snprintf(text, sizeof text, "the plans for all rows: %.900s",
                 from->failed);
        murk_study_add_note(row->found.note, text);
    }
    row->has_plans = true;
    return murk_study_row_check(&row->found, err);
}

/* A murk_sweep_put. */
static murk_status put_values(murk_sweep *sweep, murk_sweep_message *message,
                              murk_error *err)
{
    char key[65];
    murk_progress_add_to_group(1);
    murk_sweep_ranks_add(sweep, message->number, &message->row);
    murk_status status = add_values(sweep, message->number, &message->row, err);
    if (!status) {
        sign_values(sweep, message->number, key);
        status = murk_sweep_keep(sweep, key, message, err);
    }
    return status;
}

/* Runs the subprocess of a group, unless nothing is left for it to do. Rows
 * that the subprocess does not reach have failed; with measures_plans, the
 * coverages of the plans are NaN in these rows, and the note of each row has
 * the reason. */
static murk_status run_group(murk_sweep *sweep, murk_sweep_group *group,
                             bool measures_plans, murk_error *err)
{
    murk_sweep_job job = {sweep, group,
                          measures_plans ? MURK_SWEEP_MEASURE : MURK_SWEEP_RUN};
    const murk_sweep_put put = measures_plans ? put_values : put_row;
    murk_error why = {0};
    if (murk_sweep_job_left(&job) == 0) {
        return MURK_OK;
    }
    group->was_traced = group->was_traced || !measures_plans;
    murk_status status =
        murk_sweep_process(sweep, &murk_sweep_group_job, &job,
                           sweep->desc.study->rows, put, &why, err);
    for (size_t k = 0; k < group->n && !status; ++k) {
        if (murk_sweep_job_wants(&job, k)) {
            murk_sweep_message none = {.number = group->row[k]};
            murk_study_row_fail(&none.row, &why);
            status = put(sweep, &none, err);
        }
    }
    return status;
}

/* Runs the groups one after the other, or deals them to ranks. */
static murk_status run_groups(murk_sweep *sweep, bool measures_plans,
                              murk_error *err)
{
    murk_deal deal;
    uint64_t g = 0;
    murk_status status = murk_ranks_deal(&deal, MURK_OK, err);
    const murk_ranks *ranks = murk_ranks_leave();
    while (!status && (g = murk_ranks_take(&deal)) < sweep->groups) {
        if (murk_sweep_owns(sweep, sweep->group[g].row[0])) {
            status = run_group(sweep, &sweep->group[g], measures_plans, err);
        }
    }
    if (status) {
        murk_ranks_take_no_more(&deal);
    }
    murk_ranks_return(ranks);
    return murk_sweep_ranks_exchange(sweep, sweep->desc.study->rows,
                                     measures_plans ? put_values : put_row,
                                     status, err);
}

/* ---- plans for all rows ---- */

/* True if the row may take part in the choice of a plan for all rows;
 * find_choosers() limits the number of rows. */
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
            /* the middle row of each of n equal parts of the rows that may take
             * part */
            const size_t next = (2 * sweep->choosers + 1) * all / (2 * n);
            if (seen++ == next) {
                sweep->row[i].is_chooser = true;
                sweep->chooser[sweep->choosers++] = i;
            }
        }
    }
}

/* The keys of the plans, by the rows that take part. */
static void sign_plans(murk_sweep *sweep)
{
    char rows[MURK_SWEEP_CHOOSERS_MAX * 65 + 1] = "", sum[65], own[128];
    for (size_t i = 0; i < sweep->choosers; ++i) {
        snprintf(rows + 65 * i, 66, "%s\n", sweep->row[sweep->chooser[i]].key);
    }
    murk_sha256_hex(rows, strlen(rows), sum);
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        snprintf(own, sizeof own, "%s\n%s", murk_sweep_plan_name(p), sum);
        murk_sha256_hex(own, strlen(own), sweep->plan[p].key);
    }
}

/* A murk_sweep_put. */
static murk_status put_plan(murk_sweep *sweep, murk_sweep_message *message,
                            murk_error *err)
{
    murk_sweep_plan *plan = &sweep->plan[message->number];
    const murk_status status = murk_sweep_keep(sweep, plan->key, message, err);
    murk_study_row_release(&plan->found);
    plan->found = message->row;
    message->row = (murk_study_row){0};
    return status;
}

/* Has the plans chosen that no earlier run stored. */
static murk_status choose_plans(murk_sweep *sweep, murk_error *err)
{
    murk_error why = {0};
    const murk_status status =
        murk_sweep_process(sweep, &murk_sweep_choose_job, sweep,
                           MURK_SWEEP_PLANS, put_plan, &why, err);
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        murk_sweep_plan *plan = &sweep->plan[p];
        if (!plan->is_wanted || plan->is_reused) {
            continue;
        }
        /* A plan that the subprocess did not reach has failed. */
        if (why.code && plan->found.sensors == 0) {
            murk_study_row_fail(&plan->found, &why);
        }
        murk_sweep_ranks_add(sweep, (size_t)p, &plan->found);
    }
    return status;
}

/* Takes over the plans that an earlier run stored and has the others chosen. */
static murk_status make_plans(murk_sweep *sweep, murk_error *err)
{
    bool is_any_missing = false;
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        murk_sweep_plan *plan = &sweep->plan[p];
        plan->is_reused =
            plan->is_wanted && murk_sweep_load(sweep, plan->key, &plan->found);
        is_any_missing |= plan->is_wanted && !plan->is_reused;
    }
    /* No rank stores a plan before all have looked for stored ones. */
    murk_status status =
        murk_ranks_check_same("folder of the study", &is_any_missing,
                              sizeof is_any_missing, MURK_OK, err);
    if (sweep->choosers == 0 || !is_any_missing || status) {
        return status;
    }
    if (murk_ranks_number() == 0) {
        status = choose_plans(sweep, err);
    }
    return murk_sweep_ranks_exchange(sweep, MURK_SWEEP_PLANS, put_plan, status,
                                     err);
}

/* Takes over the coverages of the plans that an earlier run stored; if no plan
 * was made, the coverages are NaN. */
static murk_status load_values(murk_sweep *sweep, murk_error *err)
{
    const bool is_any_made = murk_sweep_plan_stands(&sweep->plan[0]) ||
                             murk_sweep_plan_stands(&sweep->plan[1]);
    murk_status status = MURK_OK;
    for (size_t i = 0; i < sweep->desc.study->rows && !status; ++i) {
        const murk_sweep_row *row = &sweep->row[i];
        murk_study_row found = {0};
        char key[65];
        sign_values(sweep, i, key);
        if (row->is_done && !row->found.failed[0] &&
            (!is_any_made || murk_sweep_load(sweep, key, &found))) {
            status = add_values(sweep, i, &found, err);
        }
        murk_study_row_release(&found);
    }
    return status;
}

/* The mean and the worst coverage of a plan over the rows. */
static void sum_up(murk_sweep *sweep, int p)
{
    murk_sweep_plan *plan = &sweep->plan[p];
    const size_t rows = sweep->desc.study->rows;
    murk_mean mean = {0};
    plan->worst = (murk_estimate){NAN, NAN};
    plan->worst_row = rows;
    for (size_t i = 0; i < rows; ++i) {
        const murk_study_value *v =
            murk_study_row_get(&sweep->row[i].found, murk_sweep_plan_name(p));
        if (v && isfinite(v->of.value)) {
            murk_mean_add(&mean, v->of, 1);
            if (plan->worst_row == rows || v->of.value < plan->worst.value) {
                plan->worst = v->of;
                plan->worst_row = i;
            }
        }
    }
    plan->mean = murk_mean_of(&mean, false);
}

/* All ranks must have the same stored values, and no rank stores one before all
 * have read theirs. */
static murk_status check_values(const murk_sweep *sweep, murk_status status,
                                murk_error *err)
{
    const size_t rows = sweep->desc.study->rows;
    bool *has = calloc(rows + 1, sizeof *has);
    if (!status && !has) {
        status = murk_no_memory(err, "", "for %zu rows", rows);
    }
    for (size_t i = 0; i < rows && !status; ++i) {
        has[i] = sweep->row[i].has_plans;
    }
    status = murk_ranks_check_same("folder of the study", has,
                                   rows * sizeof *has, status, err);
    free(has);
    return status;
}

static murk_status plan_for_all(murk_sweep *sweep, murk_error *err)
{
    if (!murk_outputs_plan_for_all(&sweep->outputs)) {
        return MURK_OK;
    }
    find_choosers(sweep);
    sign_plans(sweep);
    murk_status status = make_plans(sweep, err);
    if (!status) {
        status = load_values(sweep, err);
        status = check_values(sweep, status, err);
    }
    if (!status) {
        status = run_groups(sweep, true, err);
    }
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        sum_up(sweep, p);
    }
    return status;
}

/* Rows that murk_sweep_owns() and that are done. */
static size_t owned_done(const murk_sweep *sweep)
{
    size_t done = 0;
    for (size_t i = 0; i < sweep->desc.study->rows; ++i) {
        done += sweep->row[i].is_done && murk_sweep_owns(sweep, i);
    }
    return done;
}

murk_status murk_sweep_run(murk_sweep *sweep, murk_error *err)
{
    const size_t rows = murk_sweep_owned(sweep), done = owned_done(sweep);
    murk_status status = done < rows ? murk_isolated_check(err) : MURK_OK;
    const bool is_first = murk_ranks_number() == 0;
    if (!status && is_first) {
        status = murk_sweep_open(sweep, err);
    }
    if (!status && is_first) {
        status = murk_sweep_parts_copy(sweep, err);
    }
    status = murk_sweep_ranks_begin(sweep, status, err);
    if (status) {
        return status;
    }
    /* The rows, of which a shard has its own alone. */
    murk_progress_begin_group("study", rows, "rows");
    murk_progress_add_to_group(done);
    murk_progress_part(0, rows, done);
    status = run_groups(sweep, false, err);
    murk_progress_part(0, 0, 0);
    murk_progress_end();
    if (!status && sweep->desc.shard.count) {
        return is_first ? murk_sweep_part_write(sweep, err) : MURK_OK;
    }
    if (!status) {
        murk_progress_begin_group("plans for all", rows, "rows");
        status = plan_for_all(sweep, err);
        murk_progress_part(0, 0, 0);
        murk_progress_end();
    }
    return status;
}
