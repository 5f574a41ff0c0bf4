/* The conditions of a scene: builds the world of each condition, traces light
 * in it, or takes the light of an earlier condition whose light key is equal,
 * and turns the coverages of a plan in all conditions into one figure. */
#include "cases/conditions.h"

#include "base/machine.h"
#include "base/scratch_file.h"
#include "cases/poses_at.h"
#include "cases/scenario_mean.h"
#include "photonmap/map.h"
#include "plan/plan.h"
#include "world/stage_build.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void put_dark_last(murk_conditions *all)
{
    murk_condition dark[MURK_SCENE_CONDITIONS_MAX] = {{0}};
    const size_t every = all->n;
    bool has_say = false;
    all->n = 0;
    for (size_t c = 0; c < every; ++c) {
        if (murk_stage_has_nothing_to_see(all->condition[c].stage)) {
            dark[all->dark++] = all->condition[c];
        } else {
            has_say = has_say || all->condition[c].settings->weight > 0;
            all->condition[all->n++] = all->condition[c];
        }
    }
    memcpy(&all->condition[all->n], dark, all->dark * sizeof *dark);
    if (!has_say) {
        all->dark = every;
        all->n = 0;
    }
}

murk_status murk_conditions_create(murk_conditions **out,
                                   const murk_scene_desc *scene,
                                   murk_error *err)
{
    murk_conditions *all = calloc(1, sizeof *all);
    if (!all) {
        return murk_no_memory(err, scene->path, "for conditions");
    }
    all->scene = scene;
    all->n = scene->n_conditions;
    murk_status status = MURK_OK;
    /* Import the files of all conditions before any ray device exists, then
     * build the worlds. */
    for (size_t c = 0; !status && c < all->n; ++c) {
        all->condition[c].settings = &scene->conditions[c];
        status = murk_stage_import(&all->condition[c].stage,
                                   scene->conditions[c].scene, err);
    }
    for (size_t c = 0; !status && c < all->n; ++c) {
        status = murk_stage_build(all->condition[c].stage, err);
    }
    if (status) {
        murk_conditions_destroy(all);
        return status;
    }
    put_dark_last(all);
    *out = all;
    return MURK_OK;
}

void murk_conditions_destroy(murk_conditions *all)
{
    if (!all) {
        return;
    }
    for (size_t c = 0; c < all->n + all->dark; ++c) {
        murk_condition *one = &all->condition[c];
        murk_sight_destroy(one->sight);
        free(one->pose);
        if (!one->borrows_light) {
            murk_traced_destroy(one->traced);
        }
        if (all->again) {
            free(one->stage);
            free(one->borrowed);
        } else {
            murk_stage_destroy(one->stage);
        }
    }
    free(all->again);
    free(all);
}

/* Returns a copy of the struct of a scene, whose pointers are those of the
 * original; the caller frees the copy with free(). If `later` is above 0, the
 * seed is greater by `later`, and there is no jitter. NULL when out of memory.
 */
static murk_scene_desc *scene_again(const murk_scene_desc *scene,
                                    uint32_t later)
{
    murk_scene_desc *out = malloc(sizeof *out);
    if (out) {
        *out = *scene;
        out->seed += later;
        if (later > 0) {
            out->placement.jitter_m = out->placement.jitter_rad = 0;
        }
    }
    return out;
}

/* Copies the stages; each copy borrows the built world of the original. */
murk_status murk_conditions_again(murk_conditions **out,
                                  const murk_conditions *from, uint32_t later,
                                  murk_error *err)
{
    murk_conditions *all = calloc(1, sizeof *all);
    bool has_memory = all != NULL;
    if (has_memory) {
        all->scene = all->again = scene_again(from->scene, later);
        all->is_scene = from->is_scene;
        all->n = from->n;
        all->dark = from->dark;
        has_memory = all->again != NULL;
    }
    /* Copy the stages and their scenes. */
    for (size_t c = 0; has_memory && c < from->n + from->dark; ++c) {
        const murk_stage *stage = from->condition[c].stage;
        murk_condition *one = &all->condition[c];
        one->settings = from->condition[c].settings;
        one->stage = malloc(sizeof *one->stage);
        one->borrowed = scene_again(stage->scene, later);
        has_memory = one->stage && one->borrowed;
        if (has_memory) {
            *one->stage = *stage;
            one->stage->scene = one->borrowed;
        }
    }
    if (!has_memory) {
        murk_conditions_destroy(all);
        return murk_no_memory(err, from->scene->path, "for conditions");
    }
    *out = all;
    return MURK_OK;
}

murk_status murk_conditions_of_stage(murk_conditions **out,
                                     const murk_stage *stage,
                                     murk_traced *traced, murk_error *err)
{
    static const murk_scene_condition as_it_stands = {.weight = 1};
    murk_stage original = *stage;
    murk_conditions from = {
        .scene = stage->scene,
        .is_scene = true,
        .n = 1,
        .condition = {{.settings = &as_it_stands, .stage = &original}}};
    put_dark_last(&from);
    const murk_status status = murk_conditions_again(out, &from, 0, err);
    if (!status && traced) {
        (*out)->condition[0].traced = traced;
        (*out)->condition[0].borrows_light = true;
        (*out)->trace_s = traced->trace_s;
        (*out)->map_s = traced->map_s;
    }
    return status;
}

/* ---- light ---- */

/* The first earlier condition with an equal light key, or NULL. */
static const murk_condition *find_alike(const murk_conditions *all, size_t c)
{
    for (size_t k = 0; k < c; ++k) {
        if (strcmp(all->condition[k].stage->light_key,
                   all->condition[c].stage->light_key) == 0) {
            return &all->condition[k];
        }
    }
    return NULL;
}

/* Fails if the maps of the first all->n conditions, those of conditions with
 * the same light counted once, and the largest additional memory of one trace
 * together exceed the free memory, or their scratch files the disk. Dark
 * conditions are not counted. */
static murk_status check_memory(const murk_conditions *all, unsigned threads,
                                murk_error *err)
{
    double stay = 0, more = 0, scratch = 0;
    size_t lights = 0;
    /* Add up the maps that stay in memory; find the largest amount that one
     * trace needs besides. */
    for (size_t c = 0; c < all->n; ++c) {
        if (find_alike(all, c)) {
            continue;
        }
        murk_forecast f;
        const murk_status status = murk_lightmap_forecast(
            &f, all->condition[c].stage, 0, threads, err);
        if (status) {
            return status;
        }
        const double mine =
            f.scratch_bytes > 0
                ? f.memory_bytes
                : murk_photon_map_memory_for(f.surface + f.volume);
        stay += mine;
        more = fmax(more, f.memory_bytes - mine);
        scratch += f.scratch_bytes;
        ++lights;
    }
    /* Compare with the free memory and the disk. */
    const double have = murk_machine_memory_bytes();
    const double disk = murk_scratch_free_bytes();
    return stay + more <= have && scratch <= disk
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, all->scene->placement.where,
                           "over: the light of %zu conditions takes about "
                           "%.3g GB of memory and %.3g GB of disk space; this "
                           "machine has %.3g GB and, in %s, %.3g GB free",
                           lights, (stay + more) / 1e9, scratch / 1e9,
                           have / 1e9, murk_scratch_folder(), disk / 1e9);
}

/* Traces the light of one condition unless it has light already, or takes the
 * light of an earlier condition, and builds the sight unless the condition is
 * dark. If targets replace photons, the scene as it stands is not traced
 * (unless detection needs light), but conditions are, because their light is
 * part of the results. */
static murk_status light_one(murk_conditions *all, size_t c, unsigned threads,
                             murk_error *err)
{
    murk_condition *one = &all->condition[c];
    const murk_condition *alike = find_alike(all, c);
    murk_status status = MURK_OK;
    if (alike) {
        one->traced = alike->traced;
        one->borrows_light = true;
    } else if (!one->traced) {
        status = all->is_scene ? murk_plan_trace_stream(
                                     &one->traced, one->stage, 0, threads, err)
                               : murk_lightmap_trace(&one->traced, one->stage,
                                                     0, threads, err);
        if (!status) {
            all->trace_s += one->traced->trace_s;
            all->map_s += one->traced->map_s;
        }
    }
    return status || c >= all->n
               ? status
               : murk_plan_sight_and_targets(&one->sight, &one->targets,
                                             one->stage, one->traced, threads,
                                             err);
}

murk_status murk_conditions_light(murk_conditions *all, unsigned threads,
                                  murk_error *err)
{
    uint64_t seen = 0;
    murk_status status =
        all->is_scene ? MURK_OK : check_memory(all, threads, err);
    for (size_t c = 0; !status && c < all->n + all->dark; ++c) {
        status = light_one(all, c, threads, err);
        if (!status && c < all->n) {
            seen |= murk_goals_seen(all->condition[c].sight);
        }
    }
    return status || all->n == 0
               ? status
               : murk_goals_check_seen(all->condition[0].stage->goals, seen,
                                       err);
}

/* ---- sensors ---- */

murk_status murk_conditions_take_poses(murk_conditions *all,
                                       const murk_poses *poses, murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t c = 0; c < all->n && !status; ++c) {
        murk_condition *one = &all->condition[c];
        free(one->pose);
        one->pose = NULL;
        status = murk_poses_at(&one->pose, poses, all->scene, one->stage, err);
    }
    return status;
}

murk_pose *murk_condition_sensors(const murk_condition *condition,
                                  const murk_poses *poses,
                                  const size_t *candidate, size_t n)
{
    const murk_pose *pose = condition->pose ? condition->pose : poses->pose;
    murk_pose *out = calloc(n + 1, sizeof *out);
    for (size_t k = 0; out && k < n; ++k) {
        out[k] = pose[candidate[k]];
    }
    return out;
}

/* ---- one figure of all conditions ---- */

double murk_condition_regret(const murk_scene_desc *scene,
                             const murk_condition *c, double coverage)
{
    const double lack = c->best_known - coverage;
    if (!scene->placement.relative_regret) {
        return lack;
    }
    return c->best_known > 0 ? lack / c->best_known : 0;
}

murk_estimate murk_conditions_estimate(const murk_conditions *all,
                                       const murk_estimate *of,
                                       murk_scene_objective objective,
                                       bool are_independent, size_t *worst)
{
    murk_mean mean = {0};
    double min = 0;
    *worst = all->n;
    /* Find the condition with the least coverage or the largest regret. */
    for (size_t c = 0; c < all->n; ++c) {
        const murk_condition *one = &all->condition[c];
        const double weight = one->settings->weight;
        const double less =
            objective == MURK_SCENE_OBJECTIVE_REGRET
                ? -murk_condition_regret(all->scene, one, of[c].value)
                : of[c].value;
        if (weight > 0 && (*worst == all->n || less < min)) {
            *worst = c;
            min = less;
        }
        murk_mean_add(&mean, of[c], weight);
    }
    /* The condition of the largest regret is fixed once the plan is measured
     * in sample. */
    if (objective == MURK_SCENE_OBJECTIVE_REGRET && all->has_regret_at) {
        *worst = all->regret_at;
    }
    return objective == MURK_SCENE_OBJECTIVE_MEAN
               ? murk_mean_of(&mean, are_independent)
               : of[*worst];
}
