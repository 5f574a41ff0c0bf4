/* Builds the phase functions of the media of a scene from the scene structs.
 * Phase functions in closed form are set directly; Fournier-Forand, measured
 * tables (CSV) and mixtures of presets become tables (medium/phase_table.h).
 * Measured tables from one path share one table, and so do Fournier-Forand
 * functions with equal parameters. The albedo and the phase functions of
 * droplets of a file are computed first (scene/medium_preset.h). */
#include "world/phases.h"

#include "base/log.h"
#include "scene/medium_preset.h"
#include "scene/table.h"
#include "world/mixtures.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Limit on the number of nodes of all tables of a scene together, so that a
 * scene that names many files cannot take all memory: the nodes of 24 bytes
 * take 96 MB. */
#define NODES_MAX 4000000

/* A measured table is extended to angle 0 before the first row and to 180
 * degrees beyond the last row. Warn if more than this share of the scattered
 * light lies in one of the two extensions. The share is a choice. */
#define BEYOND_ROWS .1

/* The columns of a measured table, in messages. */
#define COLUMNS "angle_deg and phase_per_sr"

/* Warns if more than BEYOND_ROWS of the light lies before the first row or
 * beyond the last row of a table. */
static void warn_of_guesses(const murk_phase_table *table, const char *path)
{
    const murk_phase_facts *facts = murk_phase_table_facts(table);
    if (facts->before_first > BEYOND_ROWS || facts->behind_last > BEYOND_ROWS) {
        murk_warn(path,
                  "%.3g %% of the light turns by less than the first angle and "
                  "%.3g %% by more than the last: as the rows are extended",
                  100 * facts->before_first, 100 * facts->behind_last);
    }
}

/* Reads a table of scattering angle and phase function from a CSV file. */
static murk_status read_table(murk_phase_table **out, const char *path,
                              murk_error *err)
{
    murk_table *csv = NULL;
    double *angle = NULL, *value = NULL;
    /* Read both columns. */
    murk_status status = murk_table_read(&csv, path, err);
    if (!status) {
        status = murk_table_read_column(csv, "angle_deg", COLUMNS, &angle, err);
    }
    if (!status) {
        status =
            murk_table_read_column(csv, "phase_per_sr", COLUMNS, &value, err);
    }
    /* Build the table, which normalises the values. */
    if (!status) {
        const murk_phase_rows rows = {.rows = csv->rows,
                                      .angle_deg = angle,
                                      .phase_per_sr = value,
                                      .line = csv->line,
                                      .where = path};
        status = murk_phase_table_create(out, &rows, err);
    }
    if (!status) {
        warn_of_guesses(*out, path);
    }
    free(angle);
    free(value);
    murk_table_destroy(csv);
    return status;
}

static bool needs_table(const murk_scene_phase *phase)
{
    return phase->kind == MURK_PHASE_TABLE ||
           murk_phase_is_tabulated(phase->kind);
}

/* True if two phase functions, of which b needs a table and a has one, share
 * the table: they name the same path, or have the same kind and numbers. A
 * mixture is the same as itself only. */
static bool is_same(const murk_scene_phase *a, const murk_scene_phase *b)
{
    if (a->mixture || b->mixture) {
        return a == b;
    }
    const murk_phase of_a = murk_phase_of(a->kind, a->value);
    const murk_phase of_b = murk_phase_of(b->kind, b->value);
    return a->kind == b->kind && a->table ? strcmp(a->table, b->table) == 0
                                          : murk_phase_is_same(&of_a, &of_b);
}

static murk_status make_table(murk_phase_table **out,
                              const murk_scene_phase *phase, murk_error *err)
{
    if (phase->mixture) {
        return murk_mixture_table(out, phase->mixture, phase->where, err);
    }
    return phase->table ? read_table(out, phase->table, err)
                        : murk_phase_tabulate(out, phase->kind, phase->value,
                                              phase->where, err);
}

/* Sets *out to the table of a phase function, one that exists already or a new
 * one; to NULL if the phase function needs no table. */
static murk_status find_table(const murk_phase_table **out, murk_phases *phases,
                              const murk_scene_phase *phase, murk_error *err)
{
    *out = NULL;
    if (!needs_table(phase)) {
        return MURK_OK;
    }
    /* Search the existing tables. */
    for (size_t i = 0; i < phases->n && !*out; ++i) {
        *out = is_same(phases->of[i], phase) ? phases->table[i] : NULL;
    }
    if (*out) {
        return MURK_OK;
    }
    /* Build a new table; the number of nodes of all tables is limited. */
    murk_phase_table *made = NULL;
    const murk_status status = make_table(&made, phase, err);
    if (status) {
        return status;
    }
    phases->of[phases->n] = phase;
    phases->table[phases->n++] = made;
    *out = made;
    phases->nodes += murk_phase_table_facts(made)->nodes;
    return phases->nodes <= NODES_MAX
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, phase->where,
                           "the scene's phase tables have more than %d nodes "
                           "together up to here",
                           NODES_MAX);
}

static murk_phase phase_of(const murk_scene_phase *p, int band,
                           const murk_phase_table *table)
{
    return table                      ? murk_phase_tabulated(table)
           : p->kind == MURK_PHASE_HG ? murk_phase_hg(p->mean_cosine.band[band])
                                      : murk_phase_of(p->kind, p->value);
}

/* Sets the phase functions of one medium for all bands of the scene. The medium
 * has one phase function for all bands, or one for each band. */
static murk_status fill_medium(murk_phases *phases,
                               const murk_scene_desc *scene, size_t medium,
                               murk_error *err)
{
    const murk_scene_medium *m = phases->source[medium];
    murk_status status = MURK_OK;
    for (size_t k = 0; k < m->n_phases && !status; ++k) {
        const murk_phase_table *table;
        status = find_table(&table, phases, &m->phase[k], err);
        for (int band = 0; band < scene->bands && !status; ++band) {
            if (m->n_phases == 1 || (size_t)band == k) {
                phases->medium[medium][band] =
                    phase_of(&m->phase[k], band, table);
            }
        }
    }
    return status;
}

static murk_status no_memory(const murk_scene_desc *scene, murk_error *err)
{
    return murk_no_memory(err, scene->path, "for a phase function");
}

/* Sets phases->source[medium]: for droplets of a file, computes the medium by
 * the effective radius in the file. */
static murk_status find_source(murk_phases *phases,
                               const murk_scene_desc *scene,
                               const murk_fillings *fillings, size_t medium,
                               murk_error *err)
{
    const murk_scene_medium *m = &scene->media[medium];
    phases->source[medium] = m;
    if (!(m->effective_variance > 0)) {
        return MURK_OK;
    }
    assert(fillings && fillings->grid[medium]);
    const double radius_um =
        murk_grid_describe(fillings->grid[medium])->effective_radius_um;
    murk_scene_medium *made = malloc(sizeof *made);
    const murk_status status =
        made ? murk_medium_droplets_fill(made, m, radius_um, scene, err)
             : no_memory(scene, err);
    if (status) {
        free(made);
        return status;
    }
    phases->source[medium] = phases->droplets[medium] = made;
    return MURK_OK;
}

/* Finds the sources of all media, and allocates for the largest number of
 * tables: one for each phase function. */
static murk_status prepare(murk_phases *phases, const murk_scene_desc *scene,
                           const murk_fillings *fillings, murk_error *err)
{
    size_t max = 0;
    phases->media = scene->n_media;
    phases->source = calloc(scene->n_media + 1, sizeof *phases->source);
    phases->droplets = calloc(scene->n_media + 1, sizeof *phases->droplets);
    phases->medium = calloc(scene->n_media + 1, sizeof *phases->medium);
    murk_status status = phases->source && phases->droplets && phases->medium
                             ? MURK_OK
                             : no_memory(scene, err);
    for (size_t i = 0; i < scene->n_media && !status; ++i) {
        status = find_source(phases, scene, fillings, i, err);
        max += status ? 0 : phases->source[i]->n_phases;
    }
    if (status) {
        return status;
    }
    phases->table = calloc(max + 1, sizeof *phases->table);
    phases->of = calloc(max + 1, sizeof *phases->of);
    return phases->table && phases->of ? MURK_OK : no_memory(scene, err);
}

murk_status murk_phases_create(murk_phases **out, const murk_scene_desc *scene,
                               const murk_fillings *fillings, murk_error *err)
{
    murk_phases *phases = calloc(1, sizeof *phases);
    murk_status status =
        phases ? prepare(phases, scene, fillings, err) : no_memory(scene, err);
    /* Build the phase functions of each medium. */
    for (size_t i = 0; i < scene->n_media && !status; ++i) {
        status = fill_medium(phases, scene, i, err);
    }
    if (!status) {
        *out = phases;
        phases = NULL;
    }
    murk_phases_destroy(phases);
    return status;
}

void murk_phases_destroy(murk_phases *phases)
{
    if (phases) {
        for (size_t i = 0; phases->table && i < phases->n; ++i) {
            murk_phase_table_destroy(phases->table[i]);
        }
        for (size_t i = 0; phases->droplets && i < phases->media; ++i) {
            if (phases->droplets[i]) {
                murk_medium_droplets_release(phases->droplets[i]);
                free(phases->droplets[i]);
            }
        }
        free(phases->table);
        free(phases->of);
        free(phases->medium);
        free(phases->source);
        free(phases->droplets);
        free(phases);
    }
}

const char *murk_phases_kind(const murk_scene_medium *medium, int band)
{
    const murk_scene_phase *p =
        &medium->phase[medium->n_phases == 1 ? 0 : band];
    const bool is_isotropic =
        p->kind == MURK_PHASE_HG && p->mean_cosine.band[band] == 0;
    return is_isotropic ? "isotropic" : murk_phase_kinds[p->kind].name;
}
