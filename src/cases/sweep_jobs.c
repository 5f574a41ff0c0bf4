/* Packs the work on a study into a request for murk-rows, and makes the same
 * study of the request there.
 *
 * The request has what the study file and the scenes do not say: options,
 * checksums, the state of the rows and the plans that were chosen. The study
 * file and the scenes of the rows are read again; a study file that has changed
 * is refused. */
#include "cases/sweep_jobs.h"

#include "cases/sweep_work.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The numbers in a request. */
typedef struct sweep_head {
    size_t rows, groups, n_overrides, choosers;
    unsigned threads;
    bool force;
    bool wants[MURK_OUTPUTS];
    bool is_wanted[MURK_SWEEP_PLANS], is_reused[MURK_SWEEP_PLANS];
} sweep_head;

/* The state of a row. */
typedef struct row_state {
    bool is_done, has_failed, has_plans, is_chooser;
} row_state;

/* ---- packing ---- */

static void pack_rows(murk_parcel *to, const murk_sweep *sweep)
{
    const size_t rows = sweep->desc.study->rows;
    row_state *state = calloc(rows, sizeof *state);
    if (!state) {
        to->is_short = true;
        return;
    }
    for (size_t i = 0; i < rows; ++i) {
        const murk_sweep_row *row = &sweep->row[i];
        state[i] = (row_state){row->is_done, row->found.failed[0] != '\0',
                               row->has_plans, row->is_chooser};
    }
    murk_parcel_put(to, state, rows * sizeof *state);
    free(state);
}

/* A plan as the text that murk_sweep_send() would send. */
static void pack_plan(murk_parcel *to, const murk_study_row *found)
{
    char *text = murk_study_row_print(found, 0);
    to->is_short |= !text;
    murk_parcel_put_text(to, text);
    free(text);
}

static void pack_sweep(murk_parcel *to, const murk_sweep *sweep)
{
    const murk_sweep_desc *desc = &sweep->desc;
    sweep_head head = {.rows = desc->study->rows,
                       .groups = sweep->groups,
                       .n_overrides = desc->n_overrides,
                       .choosers = sweep->choosers,
                       .threads = desc->threads,
                       .force = desc->force};
    memcpy(head.wants, sweep->outputs.wants, sizeof head.wants);
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        head.is_wanted[p] = sweep->plan[p].is_wanted;
        head.is_reused[p] = sweep->plan[p].is_reused;
    }
    murk_parcel_put(to, &head, sizeof head);
    /* The study, and its scene as it was. */
    murk_parcel_put_text(to, desc->study->path);
    murk_parcel_put_text(to, desc->study->sha256);
    murk_parcel_put_text(to, sweep->scene_sha256);
    murk_parcel_put_text(to, desc->folder);
    murk_parcel_put_text(to, desc->version);
    for (size_t i = 0; i < desc->n_overrides; ++i) {
        murk_parcel_put_text(to, desc->overrides[i].text);
        murk_parcel_put_text(to, desc->overrides[i].option);
    }
    /* Rows, groups and plans. */
    pack_rows(to, sweep);
    for (size_t g = 0; g < sweep->groups; ++g) {
        const murk_sweep_group *group = &sweep->group[g];
        murk_parcel_put(to, &group->n, sizeof group->n);
        murk_parcel_put(to, group->row, group->n * sizeof *group->row);
    }
    murk_parcel_put(to, sweep->chooser, sizeof sweep->chooser);
    for (int p = 0; p < MURK_SWEEP_PLANS; ++p) {
        pack_plan(to, &sweep->plan[p].found);
    }
}

static void pack_choose(murk_parcel *to, const void *context)
{
    pack_sweep(to, context);
}

static void pack_group(murk_parcel *to, const void *context)
{
    const murk_sweep_job *job = context;
    const size_t number = (size_t)(job->group - job->sweep->group);
    pack_sweep(to, job->sweep);
    murk_parcel_put(to, &number, sizeof number);
    murk_parcel_put(to, &job->work, sizeof job->work);
}

/* ---- unpacking ---- */

/* A study that was made of a request. */
typedef struct unpacked {
    murk_study_file *study;
    murk_override *overrides;
    murk_sweep *sweep;
} unpacked;

static void release(unpacked *u)
{
    murk_sweep_destroy(u->sweep);
    murk_study_file_destroy(u->study);
    free(u->overrides);
}

static murk_status malformed(murk_error *err)
{
    return murk_fail(err, MURK_RUN_FAILED, "", "its request is malformed");
}

static murk_status read_study(unpacked *u, murk_parcel *from,
                              const sweep_head *head, murk_error *err)
{
    const char *path = murk_parcel_take_text(from),
               *sha256 = murk_parcel_take_text(from);
    if (!path || !sha256) {
        return malformed(err);
    }
    const murk_status status = murk_study_file_read(&u->study, path, err);
    if (status) {
        return status;
    }
    if (strcmp(u->study->sha256, sha256) != 0) {
        return murk_fail(err, MURK_BAD_FILE, path,
                         "has changed since it was read; must stay as it is "
                         "until all rows are done");
    }
    return u->study->rows == head->rows ? MURK_OK : malformed(err);
}

static murk_status unpack_desc(unpacked *u, murk_parcel *from,
                               const sweep_head *head, murk_error *err)
{
    murk_sweep *sweep = u->sweep;
    /* Texts, which stay in the request. */
    const char *scene_sha256 = murk_parcel_take_text(from);
    const char *folder = murk_parcel_take_text(from),
               *version = murk_parcel_take_text(from);
    u->overrides = calloc(head->n_overrides + 1, sizeof *u->overrides);
    if (!u->overrides) {
        return murk_no_memory(err, "", "for the keys of a study");
    }
    for (size_t i = 0; i < head->n_overrides; ++i) {
        u->overrides[i].text = murk_parcel_take_text(from);
        u->overrides[i].option = murk_parcel_take_text(from);
    }
    if (from->is_short || !scene_sha256 ||
        strlen(scene_sha256) >= sizeof sweep->scene_sha256) {
        return malformed(err);
    }
    /* The description of the study. */
    memcpy(sweep->scene_sha256, scene_sha256, strlen(scene_sha256));
    sweep->desc = (murk_sweep_desc){.study = u->study,
                                    .overrides = u->overrides,
                                    .n_overrides = head->n_overrides,
                                    .folder = folder,
                                    .force = head->force,
                                    .version = version,
                                    .threads = head->threads};
    sweep->outputs.study = u->study;
    memcpy(sweep->outputs.wants, head->wants, sizeof head->wants);
    return MURK_OK;
}

static murk_status unpack_rows(murk_sweep *sweep, murk_parcel *from,
                               const sweep_head *head, murk_error *err)
{
    const row_state *state = murk_parcel_take(from, head->rows * sizeof *state);
    sweep->row = calloc(head->rows, sizeof *sweep->row);
    sweep->group = calloc(head->groups + 1, sizeof *sweep->group);
    if (!sweep->row || !sweep->group) {
        return murk_no_memory(err, "", "for %zu rows", head->rows);
    }
    for (size_t i = 0; state && i < head->rows; ++i) {
        murk_sweep_row *row = &sweep->row[i];
        row->is_done = state[i].is_done;
        row->has_plans = state[i].has_plans;
        row->is_chooser = state[i].is_chooser;
        snprintf(row->found.failed, sizeof row->found.failed, "%s",
                 state[i].has_failed ? "failed" : "");
    }
    /* The groups, with numbers of rows that exist. */
    for (size_t g = 0; g < head->groups; ++g) {
        murk_sweep_group *group = &sweep->group[g];
        const size_t *n = murk_parcel_take(from, sizeof *n);
        const size_t *row = n ? murk_parcel_take(from, *n * sizeof *row) : NULL;
        group->row = row ? malloc(*n * sizeof *row) : NULL;
        if (!group->row) {
            return row ? murk_no_memory(err, "", "for %zu rows", *n)
                       : malformed(err);
        }
        memcpy(group->row, row, *n * sizeof *row);
        group->n = *n;
        ++sweep->groups;
    }
    return from->is_short ? malformed(err) : MURK_OK;
}

static murk_status unpack_plans(murk_sweep *sweep, murk_parcel *from,
                                const sweep_head *head, murk_error *err)
{
    const size_t *chooser = murk_parcel_take(from, sizeof sweep->chooser);
    murk_status status = chooser ? MURK_OK : malformed(err);
    if (!status) {
        memcpy(sweep->chooser, chooser, sizeof sweep->chooser);
        sweep->choosers = head->choosers;
    }
    for (int p = 0; p < MURK_SWEEP_PLANS && !status; ++p) {
        murk_sweep_plan *plan = &sweep->plan[p];
        const char *text = murk_parcel_take_text(from),
                   *end = text ? strchr(text, '\n') : NULL;
        plan->is_wanted = head->is_wanted[p];
        plan->is_reused = head->is_reused[p];
        status = end ? murk_study_row_read(&plan->found, end + 1,
                                           strlen(end + 1), "a plan", err)
                     : malformed(err);
    }
    return status;
}

/* Makes the study of a request. Release *out also after a failure. */
static murk_status unpack(unpacked *out, murk_parcel *from, murk_error *err)
{
    const sweep_head *head = murk_parcel_take(from, sizeof *head);
    out->sweep = calloc(1, sizeof *out->sweep);
    if (!out->sweep) {
        return murk_no_memory(err, "", "for a study");
    }
    murk_status status =
        head ? read_study(out, from, head, err) : malformed(err);
    if (!status) {
        status = unpack_desc(out, from, head, err);
    }
    if (!status) {
        status = unpack_rows(out->sweep, from, head, err);
    }
    return status ? status : unpack_plans(out->sweep, from, head, err);
}

/* ---- the jobs ---- */

static murk_status choose_packed(murk_isolated *process, murk_parcel *from,
                                 murk_error *err)
{
    unpacked u = {0};
    murk_status status = unpack(&u, from, err);
    if (!status) {
        status = murk_sweep_choose(process, u.sweep, err);
    }
    release(&u);
    return status;
}

static murk_status work_packed(murk_isolated *process, murk_parcel *from,
                               murk_error *err)
{
    unpacked u = {0};
    murk_sweep_job job = {0};
    murk_status status = unpack(&u, from, err);
    if (!status) {
        const size_t *number = murk_parcel_take(from, sizeof *number);
        const void *work = murk_parcel_take(from, sizeof job.work);
        if (!number || !work || *number >= u.sweep->groups) {
            status = malformed(err);
        } else {
            job.sweep = u.sweep;
            job.group = &u.sweep->group[*number];
            memcpy(&job.work, work, sizeof job.work);
        }
    }
    if (!status) {
        status = murk_sweep_work(process, &job, err);
    }
    release(&u);
    return status;
}

const murk_isolated_job murk_sweep_group_job = {"rows", murk_sweep_work,
                                                pack_group, work_packed};

const murk_isolated_job murk_sweep_choose_job = {"plans", murk_sweep_choose,
                                                 pack_choose, choose_packed};
