/* Chooses the plans for all rows of a study, in the process that the host
 * chooses (base/isolated.h): imports and lights the worlds of the rows that
 * take part, joins the rows as scenarios (cases/scenarios.h), and sends each
 * plan that is asked for and is not reused. */
#include "cases/sweep_work.h"

#include "base/log.h"
#include "base/machine.h"
#include "cases/scenarios.h"
#include "cases/sweep_coverage.h"
#include "cases/sweep_store.h"
#include "plan/plan.h"
#include "plan/start_plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

_Static_assert(MURK_SWEEP_CHOOSERS_MAX <= MURK_BLOCKS_MAX,
               "every row has a block");

/* A row that takes part in the choice of the plans. */
typedef struct chooser {
    const murk_stage *stage;
    murk_traced *traced;
    bool owns_light;
    murk_sight *sight; /* NULL: there is nothing to see */
} chooser;

typedef struct choosing {
    const murk_sweep *sweep;
    murk_sweep_light *light; /* [groups]; n is 0 if no row of the group takes
                                part */
    chooser row[MURK_SWEEP_CHOOSERS_MAX]; /* as sweep->chooser */
    murk_candidates *candidates;
    murk_poses *poses;
    murk_scenarios *scenarios; /* NULL: no row has anything to see */
} choosing;

/* The number of a row among the rows that take part; the count of these rows if
 * it does not take part. */
static size_t number_of(const murk_sweep *sweep, size_t row)
{
    size_t i = 0;
    while (i < sweep->choosers && sweep->chooser[i] != row) {
        ++i;
    }
    return i;
}

/* ---- worlds and light ---- */

static murk_status import_group(choosing *ch, size_t g, murk_error *err)
{
    const murk_sweep_job job = {ch->sweep, &ch->sweep->group[g],
                                MURK_SWEEP_CHOOSE};
    if (murk_sweep_job_left(&job) == 0) {
        return MURK_OK;
    }
    murk_status status = murk_sweep_light_import(&ch->light[g], &job, err);
    for (size_t k = 0; k < job.group->n && !status; ++k) {
        const murk_error *why = &ch->light[g].why[k];
        if (why->code) {
            status = murk_fail(err, why->code, why->where, "%s", why->text);
        }
    }
    return status;
}

/* Fails if a copy of the light of a group does not fit in memory: if the light
 * is scaled, each row has a copy. */
static murk_status check_memory(const murk_sweep_light *l, murk_error *err)
{
    const murk_traced *all = l->traced[0];
    if (!all || !l->lights) {
        return MURK_OK;
    }
    const double bytes = murk_photon_map_memory_for(
                     (double)murk_photon_map_count(all->surface) +
                     (double)murk_photon_map_count(all->volume)),
                 have = murk_machine_memory_bytes();
    return bytes <= have
               ? MURK_OK
               : murk_fail(err, MURK_RUN_FAILED, l->scene[0]->path,
                           "the light of all rows takes %.3g GB more than this "
                           "machine has; fewer photons or rows need less",
                           (bytes - have) / 1e9);
}

static murk_status light_row(choosing *ch, murk_sweep_light *l, size_t k,
                             murk_error *err)
{
    const unsigned threads = ch->sweep->desc.threads;
    chooser *row = &ch->row[number_of(ch->sweep, l->group->row[k])];
    murk_status status = murk_sweep_light_build(l, k, err);
    row->stage = l->stage[k];
    row->owns_light = true;
    if (status || !murk_sweep_can_see(l, k)) {
        return status;
    }
    status = check_memory(l, err);
    if (!status) {
        status = murk_sweep_light_shines(l, k)
                     ? murk_sweep_light_of(l, k, 0, &row->traced,
                                           &row->owns_light, err)
                     : murk_plan_trace_stream(&row->traced, row->stage, 0,
                                              threads, err);
    }
    return !status && murk_sweep_has_seen(row->stage, row->traced)
               ? murk_plan_sight(&row->sight, row->stage, row->traced, threads,
                                 err)
               : status;
}

/* Imports the files of all groups, before the first ray device exists, and then
 * lights the rows that take part. */
static murk_status light_all(choosing *ch, murk_error *err)
{
    const murk_sweep *sweep = ch->sweep;
    murk_status status = MURK_OK;
    for (size_t g = 0; g < sweep->groups && !status; ++g) {
        status = import_group(ch, g, err);
    }
    for (size_t g = 0; g < sweep->groups && !status; ++g) {
        murk_sweep_light *l = &ch->light[g];
        if (l->n == 0) {
            continue;
        }
        status = murk_sweep_light_prepare(l, false, err);
        for (size_t k = 0; k < l->n && !status; ++k) {
            if (murk_sweep_light_has(l, k)) {
                status = light_row(ch, l, k, err);
            }
        }
        if (l->lights) { /* the rows have scaled copies of the light */
            murk_traced_destroy(l->traced[0]);
            l->traced[0] = NULL;
        }
    }
    return status;
}

/* ---- choosing ---- */

/* Joins the rows in which something can be seen to one placement problem;
 * without such a row ch->scenarios stays NULL. */
static murk_status join(choosing *ch, murk_error *err)
{
    const murk_sweep *sweep = ch->sweep;
    const murk_stage *stage[MURK_SWEEP_CHOOSERS_MAX];
    const char *where[MURK_SWEEP_CHOOSERS_MAX];
    murk_sight *sight[MURK_SWEEP_CHOOSERS_MAX];
    double share[MURK_SWEEP_CHOOSERS_MAX];
    size_t n = 0;
    /* The rows in which something can be seen. */
    for (size_t i = 0; i < sweep->choosers; ++i) {
        if (ch->row[i].sight) {
            stage[n] = ch->row[i].stage;
            where[n] = stage[n]->scene->sensors.where;
            sight[n] = ch->row[i].sight;
            share[n++] = 1;
        }
    }
    if (n == 0) {
        return MURK_OK;
    }
    /* Candidates that are usable in all of these rows, and the problem of all.
     */
    const unsigned threads = sweep->desc.threads;
    murk_status status =
        murk_sites_find_common(&ch->candidates, stage, where, n, threads, err);
    if (!status) {
        status = murk_poses_create(
            &ch->poses, stage[0]->scene, &stage[0]->world.domain,
            ch->candidates->position, ch->candidates->usable, err);
    }
    if (!status) {
        status = murk_start_plan_match(ch->poses, stage[0]->scene,
                                       &stage[0]->world.domain, err);
    }
    return status ? status
                  : murk_scenarios_create(&ch->scenarios, stage[0]->scene,
                                          sight, share, n, ch->poses, err);
}

static murk_status tell(const choosing *ch, const murk_place_result *found,
                        murk_study_row *out, murk_error *err)
{
    murk_pose *sensor = calloc(found->count + 1, sizeof *sensor);
    if (!sensor) {
        return murk_no_memory(err, "", "for a plan of rows");
    }
    /* The sensors of the plan. */
    for (size_t i = 0; i < found->count; ++i) {
        sensor[i] = ch->poses->pose[found->sensor[i]];
    }
    /* Value and upper bound of the plan, as shares. */
    const double whole = (double)found->whole;
    const murk_status status = murk_study_row_set_sensors(
        out, ch->row[0].stage->scene, sensor, found->count, err);
    free(sensor);
    if (!status) {
        murk_study_row_add(out, "in_sample", "",
                           (murk_estimate){(double)found->value / whole, NAN});
        murk_study_row_add(out, "upper_bound", "",
                           (murk_estimate){(double)found->upper / whole, NAN});
    }
    return status ? status : murk_study_row_check(out, err);
}

/* Chooses one plan. If no plan is found, *out has the reason; only
 * MURK_INTERRUPTED is a failure of the function. */
static murk_status choose(choosing *ch, murk_study_row *out, int plan,
                          murk_error *err)
{
    murk_place_result found = {0};
    murk_error why = {0};
    const murk_scene_objective objective = plan == MURK_SWEEP_WORST
                                               ? MURK_SCENE_OBJECTIVE_WORST
                                               : MURK_SCENE_OBJECTIVE_MEAN;
    murk_place_desc desc = murk_scenarios_desc(ch->scenarios, objective);
    desc.with_curve = false;
    murk_status status =
        murk_scenarios_place(&found, ch->scenarios, objective, &desc, &why);
    if (!status) {
        status = tell(ch, &found, out, &why);
    }
    murk_place_release(&found);
    if (status == MURK_INTERRUPTED) {
        return murk_fail(err, status, why.where, "%s", why.text);
    }
    if (status) {
        murk_study_row_fail(out, &why);
    }
    return MURK_OK;
}

static void release(choosing *ch)
{
    murk_scenarios_destroy(ch->scenarios);
    murk_poses_destroy(ch->poses);
    murk_candidates_destroy(ch->candidates);
    for (size_t i = 0; i < ch->sweep->choosers; ++i) {
        murk_sight_destroy(ch->row[i].sight);
        if (ch->row[i].owns_light) {
            murk_traced_destroy(ch->row[i].traced);
        }
    }
    for (size_t g = 0; ch->light && g < ch->sweep->groups; ++g) {
        murk_sweep_light_release(&ch->light[g]);
    }
    free(ch->light);
}

murk_status murk_sweep_choose(murk_isolated *isolated, void *context,
                              murk_error *err)
{
    const murk_sweep *sweep = context;
    choosing ch = {.sweep = sweep,
                   .light = calloc(sweep->groups + 1, sizeof *ch.light)};
    murk_warn_to(NULL); /* the subprocesses of the rows have reported the
                           warnings */
    murk_status status = ch.light
                             ? light_all(&ch, err)
                             : murk_no_memory(err, "", "for a plan of rows");
    if (!status) {
        status = join(&ch, err);
    }
    for (int p = 0; p < MURK_SWEEP_PLANS && !status; ++p) {
        murk_study_row plan = {0};
        if (!sweep->plan[p].is_wanted || sweep->plan[p].is_reused) {
            continue;
        }
        if (ch.scenarios) {
            status = choose(&ch, &plan, p, err);
        }
        if (!status) {
            status = murk_sweep_send(isolated, (size_t)p, &plan, err);
        }
        murk_study_row_release(&plan);
    }
    release(&ch);
    return status;
}
