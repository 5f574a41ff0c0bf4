/* The light of a group of rows: reads and imports their scenes, and traces one
 * light whose records are scaled to the powers of each row. */
#include "cases/sweep_light.h"

#include "base/log.h"
#include "lightmap/scaled_light.h"
#include "world/stage_build.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static murk_status allocate(murk_sweep_light *l, murk_error *err)
{
    l->scene = calloc(l->n, sizeof *l->scene);
    l->stage = calloc(l->n, sizeof *l->stage);
    l->is_late = calloc(l->n, sizeof *l->is_late);
    l->why = calloc(l->n, sizeof *l->why);
    l->power_w = calloc(l->n, sizeof *l->power_w);
    return l->scene && l->stage && l->is_late && l->why && l->power_w
               ? MURK_OK
               : murk_no_memory(err, "", "for rows");
}

bool murk_sweep_job_wants(const murk_sweep_job *job, size_t k)
{
    const murk_sweep_row *row = &job->sweep->row[job->group->row[k]];
    return job->work == MURK_SWEEP_RUN       ? !row->is_done
           : job->work == MURK_SWEEP_MEASURE ? murk_sweep_lacks_values(row)
                                             : row->is_chooser;
}

size_t murk_sweep_job_left(const murk_sweep_job *job)
{
    size_t left = 0;
    for (size_t k = 0; k < job->group->n; ++k) {
        left += murk_sweep_job_wants(job, k);
    }
    return left;
}

/* Reads the scene of row k. Fails if the file of the base scene has changed
 * since the study was read, because the keys of the rows belong to the scene as
 * it was then. */
static murk_status read_scene(murk_sweep_light *l, size_t k, murk_error *err)
{
    const murk_sweep_desc *desc = &l->sweep->desc;
    const murk_status status =
        murk_study_row_scene(&l->scene[k], desc->study, l->group->row[k],
                             desc->overrides, desc->n_overrides, err);
    return status || strcmp(l->scene[k]->sha256, l->sweep->scene_sha256) == 0
               ? status
               : murk_fail(err, MURK_BAD_FILE, l->scene[k]->path,
                           "has changed since it was read; must stay as it is "
                           "until all rows are done");
}

static void drop_scene(murk_sweep_light *l, size_t k)
{
    murk_scene_desc_destroy(l->scene[k]);
    l->scene[k] = NULL;
}

murk_status murk_sweep_light_import(murk_sweep_light *l,
                                    const murk_sweep_job *job, murk_error *err)
{
    const murk_sweep_group *group = job->group;
    *l = (murk_sweep_light){.sweep = job->sweep, .group = group, .n = group->n};
    murk_status status = allocate(l, err);
    for (size_t k = 0; k < l->n && !status; ++k) {
        const bool is_wanted = murk_sweep_job_wants(job, k);
        status = read_scene(l, k, err);
        if (status) {
            break;
        }
        /* The first wanted row is imported, and rows with files of their own.
         */
        l->is_late[k] =
            is_wanted && l->other && murk_stage_shares_all(l->scene[k]);
        if (is_wanted && !l->is_late[k] &&
            murk_stage_import_beside(&l->stage[k], l->scene[k], l->other,
                                     &l->why[k])) {
            l->stage[k] = NULL;
        }
        l->other = l->other ? l->other : l->stage[k];
        if (k > 0 && !l->stage[k]) { /* read again when it is needed */
            drop_scene(l, k);
        }
    }
    return status;
}

void murk_sweep_light_release(murk_sweep_light *l)
{
    for (int s = 0; s < MURK_SWEEP_STREAMS; ++s) {
        murk_traced_destroy(l->traced[s]);
    }
    murk_row_tallies_release(&l->row_tallies);
    murk_sources_destroy(l->lights);
    for (size_t k = 0; k < l->n; ++k) {
        murk_stage_destroy(l->stage ? l->stage[k] : NULL);
        murk_scene_desc_destroy(l->scene ? l->scene[k] : NULL);
        free(l->power_w ? l->power_w[k] : NULL);
    }
    free(l->scene);
    free(l->stage);
    free(l->is_late);
    free(l->why);
    free(l->power_w);
    *l = (murk_sweep_light){0};
}

/* ---- what is traced ---- */

static size_t channels_of(const murk_sweep_light *l)
{
    return l->scene[0]->n_lights * (size_t)l->scene[0]->bands;
}

bool murk_sweep_light_shines(const murk_sweep_light *l, size_t k)
{
    for (size_t c = 0; c < channels_of(l); ++c) {
        if (l->power_w[k][c] > 0) {
            return true;
        }
    }
    return false;
}

static uint64_t grown(uint64_t photons, double grow)
{
    const double n = floor((double)photons * grow + .5);
    return n < 4294967295. ? (uint64_t)n : 4294967295u;
}

/* Computes the powers of row k and adds them to the shares. The scene of a row
 * that is not in memory is read for that. */
static murk_status add_powers(murk_sweep_light *l, size_t k,
                              murk_scaled_shares *shares, murk_error *err)
{
    const bool is_here = l->scene[k] != NULL;
    murk_status status = is_here ? MURK_OK : read_scene(l, k, err);
    if (!status) {
        status = murk_scaled_light_powers(&l->power_w[k], l->scene[k],
                                          &l->first->world.domain, err);
    }
    if (!status) {
        status =
            murk_scaled_shares_add(shares, l->scene[k], l->power_w[k], err);
    }
    if (!is_here) {
        drop_scene(l, k);
    }
    return status;
}

static murk_status find_lights(murk_sweep_light *l, double *grow,
                               murk_error *err)
{
    const bool was_quiet = murk_warn_quiet(true); /* the row warns later */
    murk_scaled_shares *shares = NULL;
    murk_status status = murk_scaled_shares_create(&shares, l->scene[0], err);
    for (size_t k = 0; k < l->n && !status; ++k) {
        status = add_powers(l, k, shares, err);
    }
    murk_warn_quiet(was_quiet);
    if (!status && murk_scaled_shares_shine(shares) &&
        murk_scaled_shares_differ(shares)) {
        status = murk_scaled_shares_sources(&l->lights, grow, shares,
                                            &l->first->world.domain, err);
    }
    murk_scaled_shares_destroy(shares);
    return status;
}

murk_status murk_sweep_light_prepare(murk_sweep_light *l, bool with_row_tallies,
                                     murk_error *err)
{
    size_t k = 0;
    double grow = 1;
    /* The first imported row lends its world to the trace. */
    while (k < l->n && !l->stage[k]) {
        ++k;
    }
    if (k == l->n) {
        return MURK_OK;
    }
    murk_status status = murk_stage_build(l->stage[k], err);
    l->first = l->stage[k];
    /* The lights of all rows together, and the tallies of the rows. */
    if (!status) {
        status = find_lights(l, &grow, err);
    }
    if (!status && with_row_tallies) {
        status = murk_row_tallies_create(&l->row_tallies, l->first,
                                         &l->sweep->outputs, err);
    }
    /* The scene that is traced: the first one under these lights, with more
     * photons where lights differ. */
    l->lit_scene = *l->first->scene;
    l->lit_scene.n_tallies = l->row_tallies.n;
    l->lit_scene.photons.emit = grown(l->lit_scene.photons.emit, grow);
    l->lit_scene.photons.store = grown(l->lit_scene.photons.store, grow);
    l->lit_stage = *l->first;
    l->lit_stage.scene = &l->lit_scene;
    l->lit_stage.tally = l->row_tallies.n > 0 ? l->row_tallies.desc : NULL;
    if (l->lights) {
        l->lit_stage.lights = l->lights;
        l->lit_stage.world.lights = l->lights;
    }
    return status;
}

bool murk_sweep_light_has(const murk_sweep_light *l, size_t k)
{
    return l->stage[k] || l->is_late[k];
}

murk_status murk_sweep_light_build(murk_sweep_light *l, size_t k,
                                   murk_error *err)
{
    murk_status status = MURK_OK;
    if (l->stage[k] == l->first && l->first) {
        return MURK_OK;
    }
    if (!l->stage[k] && !l->scene[k]) { /* the first reading has warned */
        const bool was_quiet = murk_warn_quiet(true);
        status = read_scene(l, k, err);
        murk_warn_quiet(was_quiet);
    }
    if (!status && !l->stage[k]) {
        status =
            murk_stage_import_beside(&l->stage[k], l->scene[k], l->other, err);
    }
    return status ? status : murk_stage_build(l->stage[k], err);
}

void murk_sweep_light_drop(murk_sweep_light *l, size_t k)
{
    if (l->stage[k] != l->first) {
        murk_stage_destroy(l->stage[k]);
        l->stage[k] = NULL;
        if (k > 0) {
            drop_scene(l, k);
        }
    }
}

murk_status murk_sweep_light_of(murk_sweep_light *l, size_t k, uint32_t stream,
                                murk_traced **out, bool *is_own,
                                murk_error *err)
{
    const unsigned threads = l->sweep->desc.threads;
    murk_status status = MURK_OK;
    *is_own = l->lights != NULL;
    if (!l->traced[stream]) {
        status = murk_lightmap_trace(&l->traced[stream], &l->lit_stage, stream,
                                     threads, err);
    }
    if (!status && !l->lights) {
        *out = l->traced[stream];
    } else if (!status) {
        status = murk_scaled_light_make(out, l->traced[stream], l->lights,
                                        l->power_w[k], l->scene[0]->bands,
                                        threads, err);
    }
    return status;
}
