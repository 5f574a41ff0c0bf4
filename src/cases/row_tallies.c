/* Tallies of one row of a study: photon density over the domain and in regions
 * of interest, the tallies of the scene as single numbers, and the grid of the
 * fluence rate. Density is track length over free volume. */
#include "cases/row_tallies.h"

#include "medium/grid_write.h"
#include "world/plane_area.h"
#include "world/units.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Approximate number of cells of the grid of the fluence rate, a choice. On an
 * axis for which the study gives a size, that size is the number of cells
 * instead. */
#define FLUENCE_CELLS 32768

static void note(murk_row_tallies *g, const char *text, const char *name)
{
    const size_t n = strlen(g->note);
    snprintf(g->note + n, sizeof g->note - n, "%s%s %s", n ? "; " : "", name,
             text);
}

/* Adds a tally; if `part` is NULL, the tally is no density. */
static void add(murk_row_tallies *g, const murk_tally_desc *desc,
                const char *name, const murk_part *part)
{
    murk_tally_desc *d = &g->desc[g->n];
    murk_row_tally *t = &g->row_tally[g->n];
    *d = *desc;
    snprintf(d->name, sizeof d->name, "study-%zu", g->n);
    *t = (murk_row_tally){.per_unit = 1, .is_density = part != NULL};
    snprintf(t->name, sizeof t->name, "%s", name);
    if (part) {
        t->part = *part;
        t->part.number = (uint32_t)g->n;
    }
    ++g->n;
}

/* ---- densities ---- */

static void add_box(murk_row_tallies *g, const murk_box *box, const char *name,
                    const char *where)
{
    const murk_tally_desc desc = {.where = where,
                                  .type = MURK_TALLY_GRID,
                                  .box = *box,
                                  .size = {1, 1, 1}};
    add(g, &desc, name, &(murk_part){.box = *box});
}

static void add_ball(murk_row_tallies *g, const murk_scene_interest *r,
                     const murk_box *bounds, const char *name)
{
    const murk_tally_desc desc = {.where = r->where,
                                  .type = MURK_TALLY_SPHERE,
                                  .center = r->solid.center,
                                  .radius_m = r->solid.radius_m};
    const murk_part part = {.is_ball = true,
                            .box = *bounds,
                            .center = r->solid.center,
                            .radius_m = r->solid.radius_m};
    add(g, &desc, name, &part);
}

/* Adds the part of a box that lies in the domain, or a ball that lies wholly in
 * the domain. Other regions get no tally and are named in the note. */
static void add_region(murk_row_tallies *g, const murk_scene_interest *r,
                       const murk_box *domain)
{
    char name[MURK_ROW_NAME_SIZE];
    const murk_box ball = murk_box_of_ball(r->solid.center, r->solid.radius_m);
    const murk_box box = murk_box_meet(r->solid.box, *domain);
    snprintf(name, sizeof name, "density_%s", r->name);
    if (r->shape == MURK_REGION_BOX && box.min.x < box.max.x &&
        box.min.y < box.max.y && box.min.z < box.max.z) {
        add_box(g, &box, name, r->where);
    } else if (r->shape == MURK_REGION_SPHERE &&
               murk_box_contains(domain, ball.min) &&
               murk_box_contains(domain, ball.max)) {
        add_ball(g, r, &ball, name);
    } else {
        note(g,
             r->shape == MURK_REGION_BOX ? "lies outside the domain"
             : r->shape == MURK_REGION_SPHERE
                 ? "reaches out of the domain and is not measured"
                 : "is not measured: neither a box nor a sphere",
             name);
    }
}

/* ---- the scene's tallies, and the grid ---- */

static void add_tally(murk_row_tallies *g, const murk_tally_desc *asked,
                      const murk_box *domain)
{
    murk_tally_desc desc = *asked;
    desc.bins[0] = desc.bins[1] = desc.angle_bins = 1;
    desc.size[0] = desc.size[1] = desc.size[2] = 1;
    add(g, &desc, asked->name, NULL);
    if (desc.type == MURK_TALLY_PLANE) {
        const double area = murk_plane_area(domain, desc.point, desc.normal);
        g->row_tally[g->n - 1].per_unit = area > 0 ? 1 / area : NAN;
    }
}

static void add_fluence(murk_row_tallies *g, const murk_study_file *study,
                        const murk_box *domain)
{
    murk_tally_desc desc = {
        .where = study->outputs_where, .type = MURK_TALLY_GRID, .box = *domain};
    const murk_candidate_grid own =
        murk_candidate_grid_fill(domain, FLUENCE_CELLS);
    for (int i = 0; i < 3; ++i) {
        desc.size[i] =
            study->fluence_size[i] ? study->fluence_size[i] : own.size[i];
    }
    g->fluence = g->n;
    add(g, &desc, "", NULL);
}

murk_status murk_row_tallies_create(murk_row_tallies *out,
                                    const murk_stage *stage,
                                    const murk_outputs *outputs,
                                    murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    const murk_box *domain = &stage->world.domain.box;
    /* Space for every tally of the scene, every region, the domain and the
     * grid. */
    const size_t maximum = scene->n_tallies + scene->placement.n_interests + 2;
    *out = (murk_row_tallies){.study = outputs->study,
                              .desc = calloc(maximum, sizeof *out->desc),
                              .row_tally =
                                  calloc(maximum, sizeof *out->row_tally)};
    if (!out->desc || !out->row_tally) {
        return murk_no_memory(err, scene->path, "for what is measured");
    }
    /* Densities of the domain and of the regions. */
    if (outputs->wants[MURK_OUTPUT_DENSITY]) {
        add_box(out, domain, "density", scene->path);
        for (size_t i = 0; i < scene->placement.n_interests; ++i) {
            add_region(out, &scene->placement.interest[i], domain);
        }
    }
    /* The tallies of the scene that the study names. */
    for (size_t i = 0; i < outputs->study->outputs; ++i) {
        const char *word = outputs->study->output[i];
        for (size_t k = 0; k < scene->n_tallies; ++k) {
            if (murk_output_of(word) == MURK_OUTPUT_TALLY &&
                strcmp(stage->tally[k].name, word) == 0) {
                add_tally(out, &stage->tally[k], domain);
            }
        }
    }
    /* The grid of the fluence rate. */
    out->fluence = SIZE_MAX;
    if (outputs->wants[MURK_OUTPUT_FLUENCE]) {
        add_fluence(out, outputs->study, domain);
    }
    return out->n > 0 ? murk_tallies_check(out->desc, out->n,
                                           &stage->world.domain, err)
                      : MURK_OK;
}

void murk_row_tallies_release(murk_row_tallies *row_tallies)
{
    free(row_tallies->desc);
    free(row_tallies->row_tally);
    *row_tallies = (murk_row_tallies){0};
}

/* ---- reading ---- */

static murk_estimate read_cell(const murk_row_light *light,
                               const double *packet, size_t tally, int band,
                               size_t cell)
{
    return light->tallies ? murk_tallies_read(light->tallies, tally, band, cell,
                                              light->emitted, packet)
                          : (murk_estimate){0, 0};
}

/* The quantity of a tally: that of the study; else that of the scene, except
 * that densities are in photons if the scene is radiometric. */
static murk_quantity quantity_of(const murk_row_tallies *row_tallies,
                                 const murk_row_tally *row_tally,
                                 const murk_scene_desc *scene)
{
    if (row_tallies->study->has_units) {
        return row_tallies->study->units;
    }
    return row_tally->is_density && scene->units == MURK_RADIOMETRIC
               ? MURK_PHOTONS
               : scene->units;
}

/* The estimate divided by a share that has a standard error of its own. Both
 * errors are taken as independent; NaN for a share of 0. */
static murk_estimate divide(murk_estimate e, const murk_estimate *share)
{
    const double s = share->value;
    return s > 0
               ? (murk_estimate){e.value / s,
                                 hypot(e.standard_error / s,
                                       e.value * share->standard_error / s / s)}
               : (murk_estimate){NAN, NAN};
}

/* Adds the value of one cell, times the factor per_unit of the tally and
 * divided by the share: the sum over all bands, and if there are several bands
 * the value in each. */
static void add_values(murk_study_row *row, const murk_row_tallies *row_tallies,
                       size_t number, size_t cell, const char *suffix,
                       const murk_estimate *share, const murk_stage *stage,
                       const murk_row_light *light)
{
    const murk_row_tally *row_tally = &row_tallies->row_tally[number];
    const murk_scene_desc *scene = stage->scene;
    const murk_quantity quantity = quantity_of(row_tallies, row_tally, scene);
    const murk_units units = murk_units_of(quantity);
    double packet[MURK_SOURCES_MAX * MURK_BANDS_MAX];
    murk_estimate band[MURK_BANDS_MAX];
    char name[MURK_ROW_NAME_SIZE];
    /* Convert the power of each photon packet to the quantity of the tally. */
    if (light->tallies) {
        murk_units_packets(packet, quantity, stage, light->packet_w);
    }
    /* The value of the cell in each band. */
    for (int b = 0; b < scene->bands; ++b) {
        band[b] = read_cell(light, packet, number, b, cell);
        band[b].value *= row_tally->per_unit;
        band[b].standard_error *= row_tally->per_unit;
    }
    /* The sum of all bands, then each band if there are several. */
    snprintf(name, sizeof name, "%.120s%s", row_tally->name, suffix);
    murk_study_row_add(row, name, units.irradiance,
                       divide(murk_units_sum(band, scene->bands), share));
    for (int b = 0; scene->bands > 1 && b < scene->bands; ++b) {
        snprintf(name, sizeof name, "%.120s%s_%.9gnm", row_tally->name, suffix,
                 scene->band_nm[b]);
        murk_study_row_add(row, name, units.irradiance, divide(band[b], share));
    }
}

static const char *suffix_of(const murk_tally_desc *d, size_t cell)
{
    return murk_tally_directions(d) == 1 ? ""
           : d->type == MURK_TALLY_PLANE ? cell ? "_backward" : "_forward"
           : cell                        ? "_down"
                                         : "_up";
}

murk_status murk_row_tallies_read(murk_study_row *row,
                                  const murk_row_tallies *row_tallies,
                                  const murk_stage *stage,
                                  const murk_row_light *light, unsigned threads,
                                  murk_error *err)
{
    const murk_surfaces_facts facts = murk_surfaces_describe(stage->surfaces);
    murk_open_space *space = NULL;
    murk_status status = MURK_OK;
    /* Without surfaces all space is free, and without light all values are 0;
     * the free space is then not needed. */
    if (light->tallies && facts.triangles + facts.spheres > 0) {
        status = murk_stage_free_space(&space, stage, threads, err);
    }
    /* All tallies but the grid, cell by cell; densities refer to the free
     * share of their volume. */
    for (size_t i = 0; i < row_tallies->n && !status; ++i) {
        const murk_row_tally *row_tally = &row_tallies->row_tally[i];
        if (i == row_tallies->fluence) {
            continue;
        }
        const murk_estimate share =
            row_tally->is_density ? murk_free_share(&row_tally->part, space,
                                                    stage->scene->seed, threads)
                                  : (murk_estimate){1, 0};
        const size_t cells = murk_tally_cells(&row_tallies->desc[i]);
        for (size_t c = 0; c < cells; ++c) {
            add_values(row, row_tallies, i, c,
                       suffix_of(&row_tallies->desc[i], c), &share, stage,
                       light);
        }
    }
    murk_open_space_destroy(space);
    return status;
}

murk_status murk_row_tallies_write_fluence(const char *path,
                                           const murk_row_tallies *row_tallies,
                                           const murk_scene_desc *scene,
                                           const murk_row_light *light,
                                           murk_error *err)
{
    const murk_tally_desc *d = &row_tallies->desc[row_tallies->fluence];
    const size_t cells = murk_tally_cells(d);
    /* The transform from cells to the coordinates of the user; values stand at
     * the centres of the cells. */
    const murk_vec3 a = d->box.min, all = murk_sub(d->box.max, a);
    const murk_vec3 e =
        murk_vec(all.x / (double)d->size[0], all.y / (double)d->size[1],
                 all.z / (double)d->size[2]);
    const murk_affine to_world = {
        .matrix = {{e.x, 0, 0}, {0, e.y, 0}, {0, 0, e.z}},
        .shift = murk_scene_user(scene, murk_along(a, 0.5, e))};
    const char *const notes[] = {"unit", "W/m2", "quantity", "fluence rate",
                                 NULL};
    murk_grid_field fields[MURK_BANDS_MAX];
    char names[MURK_BANDS_MAX][48];
    float *value = malloc((size_t)scene->bands * cells * sizeof *value);
    if (!value) {
        return murk_no_memory(err, scene->path, "for what is measured");
    }
    /* One field for each band. */
    for (int b = 0; b < scene->bands; ++b) {
        float *field = value + (size_t)b * cells;
        for (size_t c = 0; c < cells; ++c) {
            field[c] = (float)read_cell(light, light->packet_w,
                                        row_tallies->fluence, b, c)
                           .value;
        }
        snprintf(names[b], sizeof names[b], "fluence_%.9gnm",
                 scene->band_nm[b]);
        fields[b] = (murk_grid_field){names[b], field, notes};
    }
    const murk_status status = murk_grid_write(
        path, fields, (size_t)scene->bands, d->size, &to_world, err);
    free(value);
    return status;
}

/* Prints vectors with all digits. */
static void print_vectors(FILE *out, const murk_vec3 *v, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        fprintf(out, "%a %a %a ", v[i].x, v[i].y, v[i].z);
    }
}

void murk_row_tallies_sign(FILE *out, const murk_scene_desc *scene,
                           const murk_outputs *outputs)
{
    for (size_t i = 0; i < outputs->study->outputs; ++i) {
        fprintf(out, "%s\n", outputs->study->output[i]);
    }
    for (size_t i = 0; i < scene->n_tallies; ++i) {
        const murk_scene_tally *t = &scene->tallies[i];
        const murk_vec3 v[] = {t->point, t->normal, t->box.min, t->box.max,
                               t->center};
        fprintf(out, "%s %d ", t->name, (int)t->type);
        print_vectors(out, v, 5);
        fprintf(out, "%a %d\n", t->radius_m, t->hemispheres);
    }
    for (size_t i = 0; i < scene->placement.n_interests; ++i) {
        const murk_scene_interest *r = &scene->placement.interest[i];
        const murk_vec3 v[] = {r->solid.box.min, r->solid.box.max,
                               r->solid.center};
        fprintf(out, "%s %d ", r->name, (int)r->shape);
        print_vectors(out, v, 3);
        fprintf(out, "%a\n", r->solid.radius_m);
    }
}
