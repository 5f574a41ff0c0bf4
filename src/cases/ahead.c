/* Plans that look ahead: the light of several steps, and the choice for the
 * mean of their coverages, which is one placement problem of all their photons
 * (cases/scenarios.h). */
#include "cases/ahead.h"

#include "base/progress.h"
#include "cases/poses_at.h"
#include "cases/scenarios.h"
#include "lightmap/light_update.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- light ---- */

/* The step of the plan before that has the light of this stage and is not taken
 * yet; before->n: there is none. */
static size_t find_same(const murk_ahead *a, size_t step)
{
    const murk_ahead *before = a->before;
    size_t k = 0;
    for (; before && k < before->n; ++k) {
        bool is_taken = !before->traced[k];
        for (size_t i = 0; i < step; ++i) {
            is_taken = is_taken || a->same[i] == k;
        }
        if (!is_taken && strcmp(before->stage[k]->light_key,
                                a->stage[step]->light_key) == 0) {
            return k;
        }
    }
    return k;
}

/* Traces the light of a step, from that of the step before it if there is one.
 */
static murk_status trace_step(murk_ahead *a, size_t i, bool notes_paths,
                              const murk_box *watched, unsigned threads,
                              uint64_t *reused, murk_error *err)
{
    const murk_stage *stage = a->stage[i];
    murk_traced **out = &a->traced[i];
    const murk_ahead *before = a->before;
    const bool is_last = i + 1 == a->n;
    if (!notes_paths) {
        return murk_lightmap_trace(out, stage, 0, threads, err);
    }
    if (watched && is_last) {
        return murk_lightmap_trace_watched(out, stage, watched, threads, err);
    }
    if (i > 0) {
        return murk_lightmap_update(out, reused, stage, a->traced[i - 1],
                                    a->stage[i - 1], threads, err);
    }
    return before && before->n > 0 && before->traced[before->n - 1]
               ? murk_lightmap_update(
                     out, reused, stage, before->traced[before->n - 1],
                     before->stage[before->n - 1], threads, err)
               : murk_lightmap_trace_watched(
                     out, stage, &stage->world.domain.box, threads, err);
}

/* The photons that were traced, of lights that are on. */
static uint64_t photons_of(const murk_traced *traced)
{
    return traced->ledger ? (uint64_t)murk_tally_read(&traced->ledger->photons)
                          : traced->emitted;
}

murk_status murk_ahead_trace(murk_ahead *a, bool notes_paths,
                             const murk_box *watched, unsigned threads,
                             murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < a->n; ++i) {
        a->same[i] = SIZE_MAX; /* nothing is taken over yet */
    }
    for (size_t i = 0; i < a->n && !status; ++i) {
        uint64_t reused = 0;
        a->same[i] = find_same(a, i);
        a->first[i] = SIZE_MAX;
        /* Take the light over, or make it. */
        if (a->traced[i]) { /* light that was given */
            a->same[i] = SIZE_MAX;
        } else if (a->before && a->same[i] < a->before->n) {
            a->traced[i] = a->before->traced[a->same[i]];
            reused = photons_of(a->traced[i]);
        } else {
            status =
                trace_step(a, i, notes_paths, watched, threads, &reused, err);
        }
        if (!status) {
            a->photons += photons_of(a->traced[i]);
            a->reused += reused;
        }
    }
    return status;
}

void murk_ahead_end(murk_ahead *a, bool is_done)
{
    for (size_t i = 0; i < a->n && a->before; ++i) {
        if (a->same[i] < a->before->n && is_done) {
            a->before->traced[a->same[i]] = NULL;
        } else if (a->same[i] < a->before->n) {
            a->traced[i] = NULL;
        }
    }
    a->before = NULL;
}

void murk_ahead_release(murk_ahead *a)
{
    for (size_t i = 0; i < a->n; ++i) {
        murk_traced_destroy(i > 0 ? a->traced[i] : NULL);
        free(a->pose[i]);
    }
    *a = (murk_ahead){0};
}

/* ---- candidates ---- */

/* Finds the candidates as they are at a step. */
static murk_status find_poses(murk_ahead *a, size_t i, const murk_poses *poses,
                              murk_error *err)
{
    a->poses[i] = *poses;
    const murk_status status =
        murk_poses_at(&a->pose[i], poses, a->stage[0]->scene, a->stage[i], err);
    if (!status && a->pose[i]) {
        a->poses[i].pose = a->pose[i];
    }
    return status;
}

/* ---- the choice ---- */

bool murk_ahead_earlier(murk_earlier_plan *out, const murk_ahead *a,
                        size_t step, const murk_earlier_plan *plan)
{
    const murk_ahead *before = a->before;
    if (!plan || !before || before->n == 0) {
        return false;
    }
    /* The same step, or else the last one. */
    const size_t k = a->same[step] < before->n ? a->same[step] : before->n - 1;
    *out = *plan;
    out->poses = &before->poses[k];
    out->stage = before->stage[k];
    out->traced = before->traced[k];
    out->first = before->first[k];
    if (plan->tested) {
        out->tested = plan->tested + before->block[k] * plan->poses->count;
    }
    return out->traced && out->first != SIZE_MAX;
}

/* The steps that have something to see, and their rows. */
typedef struct several {
    murk_plan_result *plan;
    size_t n;
    size_t step[MURK_SCENE_CONDITIONS_MAX]; /* [n] */
    murk_sight *sight[MURK_SCENE_CONDITIONS_MAX];
    murk_earlier_rows rows[MURK_SCENE_CONDITIONS_MAX];
    const murk_known_rows *known[MURK_SCENE_CONDITIONS_MAX];
    const murk_pose *pose[MURK_SCENE_CONDITIONS_MAX];
    murk_scenarios *scenarios;
    murk_row_counts *tested; /* [n][poses] sightlines of each row; NULL: the
                              * matrix does not stay */
} several;

/* Makes the sights of the later steps, and finds the rows that all can take
 * over. */
static murk_status make_sights(several *l, murk_sight *sight, unsigned threads,
                               murk_error *err)
{
    murk_ahead *a = l->plan->ahead;
    murk_status status = MURK_OK;
    for (size_t i = 0; i < a->n && !status; ++i) {
        murk_earlier_plan earlier;
        status = find_poses(a, i, l->plan->poses, err);
        if (status) {
            return status;
        }
        if (i > 0 && murk_stage_has_nothing_to_see(a->stage[i])) {
            continue;
        }
        /* The sight. */
        const size_t k = l->n;
        l->step[k] = i;
        l->pose[k] = a->poses[i].pose;
        l->sight[k] = sight;
        status = i == 0 ? MURK_OK
                        : murk_plan_sight(&l->sight[k], a->stage[i],
                                          a->traced[i], threads, err);
        l->n += !status;
        /* The rows. */
        if (!status) {
            const bool has_rows =
                murk_ahead_earlier(&earlier, a, i, l->plan->earlier);
            status = murk_earlier_rows_create(
                &l->rows[k], has_rows ? &earlier : NULL, &a->poses[i],
                a->stage[i], l->sight[k], murk_plan_sight_again, err);
            l->known[k] = l->rows[k].known.get ? &l->rows[k].known : NULL;
        }
    }
    return status;
}

/* Releases all but the own sight, which comes first. */
static void end_sights(several *l)
{
    murk_scenarios_destroy(l->scenarios);
    free(l->tested);
    for (size_t k = 0; k < l->n; ++k) {
        murk_earlier_rows_release(&l->rows[k]);
        if (l->step[k] > 0) {
            murk_sight_destroy(l->sight[k]);
        }
    }
}

/* The best plan found for the own time alone, without a rule on moves. */
static murk_status choose_free(several *l, murk_place_desc desc,
                               murk_error *err)
{
    murk_constraints rules;
    murk_place_result any = {0};
    if (desc.target) {
        return MURK_OK;
    }
    desc.constraints = murk_poses_constraints_of_any(l->plan->poses, &rules);
    desc.with_curve = false;
    const murk_status status =
        murk_scenarios_place_one(&any, l->scenarios, 0, false, &desc, err);
    return murk_plan_take_free(l->plan, &any, status);
}

/* Chooses the plan, and leaves the matrix to the plan that follows. */
static murk_status choose(several *l, murk_error *err)
{
    murk_plan_result *plan = l->plan;
    murk_ahead *a = plan->ahead;
    murk_scenarios *j = l->scenarios;
    murk_place_desc desc = murk_scenarios_desc(j, MURK_SCENE_OBJECTIVE_MEAN);
    const double begun_s = murk_clock_s();
    desc.with_curve = desc.with_curve && !plan->without_curve;
    a->seen = l->n;
    murk_status status = murk_scenarios_place(
        &plan->place, j, MURK_SCENE_OBJECTIVE_MEAN, &desc, err);
    if (!status) {
        status = choose_free(l, desc, err);
    }
    plan->place_s = murk_clock_s() - begun_s;
    /* Leave half of the memory for the rows of the next plan. */
    if (!status && l->tested &&
        murk_matrix_bytes(j->matrix) <= desc.row_memory / 2) {
        plan->matrix = j->matrix;
        plan->tested = l->tested;
        j->matrix = NULL;
        l->tested = NULL;
        for (size_t k = 0; k < l->n; ++k) {
            a->first[l->step[k]] = j->blocks.first[k];
            a->block[l->step[k]] = k;
        }
    }
    return status;
}

murk_status murk_ahead_choose(murk_plan_result *plan, murk_sight *sight,
                              murk_error *err)
{
    const murk_scene_desc *scene = plan->ahead->stage[0]->scene;
    const unsigned threads = murk_sight_described(sight)->threads;
    double share[MURK_SCENE_CONDITIONS_MAX];
    several *l = calloc(1, sizeof *l);
    if (!l) {
        return murk_no_memory(err, scene->path, "for the steps ahead");
    }
    l->plan = plan;
    murk_status status = make_sights(l, sight, threads, err);
    for (size_t k = 0; k < l->n; ++k) {
        share[k] = 1;
    }
    if (!status) {
        const uint64_t memory = murk_plan_desc(scene).row_memory;
        l->tested = plan->keeps_matrix
                        ? murk_plan_note_sightlines(l->n * plan->poses->count)
                        : NULL;
        const murk_scenarios_rows rows = {
            .known = l->known,
            .tested = l->tested,
            .pose = l->pose,
            .memory_taken = murk_plan_memory_taken(
                plan->earlier ? *plan->earlier->matrix : NULL, memory),
            .has_columns = plan->keeps_matrix};
        status =
            murk_scenarios_create_from(&l->scenarios, scene, l->sight, share,
                                       l->n, plan->poses, &rows, err);
    }
    for (size_t k = 0; k < l->n && !status; ++k) {
        murk_sight_problem_know(&l->scenarios->part[k], NULL);
    }
    murk_plan_forget_earlier(plan);
    /* Place. */
    if (!status) {
        plan->sense_s = l->scenarios->sense_s;
        status = choose(l, err);
    }
    for (size_t k = 0; k < l->n && !status; ++k) {
        murk_plan_add_work(plan, l->sight[k]);
    }
    murk_plan_count_queries(plan, plan->place.queries);
    end_sights(l);
    free(l);
    if (status && err && !err->where[0]) {
        snprintf(err->where, sizeof err->where, "%s", scene->sensors.where);
    }
    return status ? status : murk_plan_take_sensors(plan, scene, err);
}
