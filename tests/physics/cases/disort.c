/* DISORT's standard problems 1 to 5: isotropic, Rayleigh, Henyey-Greenstein,
 * Haze-L and Cloud C.1 layers under a beam. The last two are tables made from
 * their Legendre moments. Fluxes are shares of the beam's power. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cases/groups.h"
#include "cases/layer.h"
#include "cases/reference.h"
#include "medium/phase_table.h"
#include "moments.h"
#include "scores.h"

#define MOMENTS "tests/physics/reference/cloud_c1_haze_l_moments.csv"
#define SOURCE  "DISORT's problems by adding-doubling"
#define FLUXES  3

#define HALF_WIDTH 50.0 /* of the domain where murk tallies */

/* photons.least_weight: photons lose weight at collisions instead of ending
 * there, which lowers the noise where much is absorbed. */
#define MIN_WEIGHT .3

/* The table of a phase function, made from the first n of its moments. */
static murk_phase_table *table_of(const char *column, size_t max)
{
    static double chi[MOMENTS_MAX], angle_deg[MOMENTS_ROWS],
        phase_per_sr[MOMENTS_ROWS];
    const size_t n = moments_read(MOMENTS, column, chi);
    murk_phase_table *table = NULL;
    murk_error err = {0};
    moments_tabulate(chi, n < max ? n : max, angle_deg, phase_per_sr);
    const murk_phase_rows rows = {.rows = MOMENTS_ROWS,
                                  .angle_deg = angle_deg,
                                  .phase_per_sr = phase_per_sr,
                                  .where = column};
    if (n == 0 || murk_phase_table_create(&table, &rows, &err)) {
        fprintf(stderr, "%s of %s: %s\n", column, MOMENTS, err.text);
        exit(1);
    }
    return table;
}

/* *table is NULL where the phase function needs none; the caller destroys it.
 */
static murk_phase phase_of(const char *name, size_t max_moments,
                           murk_phase_table **table)
{
    *table = NULL;
    if (strcmp(name, "isotropic") == 0) {
        return murk_phase_hg(0);
    }
    if (strcmp(name, "rayleigh") == 0) {
        return murk_phase_rayleigh();
    }
    if (strcmp(name, "hg") == 0) {
        return murk_phase_hg(.75);
    }
    *table = table_of(name, max_moments);
    return murk_phase_tabulated(*table);
}

typedef struct problem {
    char name[80];
    size_t n;
    score_of of[FLUXES];
    validation_reference reference[FLUXES];
} problem;

/* Flux over the beam's. */
static validation_reference share(const murk_table *t, size_t row,
                                  const char *column)
{
    const validation_reference flux = reference_value(t, row, column, column);
    const validation_reference beam =
        reference_value(t, row, "beam_flux", "beam");
    const double value = flux.value / beam.value;
    return (validation_reference){column, value,
                                  hypot(flux.uncertainty / beam.value,
                                        value * beam.uncertainty / beam.value)};
}

static problem problem_of(const murk_table *t, size_t row)
{
    static const char *const column[FLUXES] = {"up", "down", "direct"};
    static const score_light light[FLUXES] = {SCORE_ALL_LIGHT, SCORE_DIFFUSE,
                                              SCORE_DIRECT};
    const double level = reference_number(t, row, "level");
    problem p = {.n = 0};
    snprintf(p.name, sizeof p.name, "%s %s tau %s albedo %s mu0 %s",
             reference_text(t, row, "problem"), reference_text(t, row, "phase"),
             reference_text(t, row, "tau"), reference_text(t, row, "albedo"),
             reference_text(t, row, "mu0"));
    for (int k = 0; k < FLUXES; ++k) {
        if (isnan(reference_number(t, row, column[k]))) {
            continue; /* too little light to count */
        }
        p.of[p.n] =
            (score_of){.kind = isnan(level) ? SCORE_ESCAPED : SCORE_POWER,
                       .light = light[k],
                       .side = k == 0 ? -1 : 1,
                       .z_m = isnan(level) ? 0 : level};
        p.reference[p.n++] = share(t, row, column[k]);
    }
    return p;
}

/* A twin has another phase function, or too few moments of its own. */
static void trace(validation *v, const murk_table *t, size_t row,
                  const char *is_wrong, const murk_phase *instead,
                  size_t max_moments)
{
    const problem p = problem_of(t, row);
    if (!validation_wants(v, p.name)) {
        return;
    }
    /* One layer with the phase function of the problem. */
    murk_phase_table *table;
    const murk_phase phase =
        phase_of(reference_text(t, row, "phase"), max_moments, &table);
    test_world w =
        layer_made(&(layer){.albedo = reference_number(t, row, "albedo"),
                            .phase = instead ? *instead : phase,
                            .tau = reference_number(t, row, "tau"),
                            .mu0 = reference_number(t, row, "mu0")});
    /* Fluxes and intensities by the weights of passing photons. */
    const scores score = {p.of, p.n};
    validation_trace(v, &(validation_case){.name = p.name,
                                           .source = SOURCE,
                                           .is_wrong = is_wrong,
                                           .world = &w.world,
                                           .reference = p.reference,
                                           .quantities = p.n,
                                           .score = scores_add,
                                           .context = &score,
                                           .least_weight = MIN_WEIGHT});
    test_world_unmade(&w);
    murk_phase_table_destroy(table);
}

/* Problem 5b by murk's own plane inside the layer, which counts direct light
 * with the diffuse. */
static void trace_plane(validation *v, const murk_table *t, size_t row)
{
    const char *name = "5b by a plane tally";
    if (!validation_wants(v, name)) {
        return;
    }
    /* The layer of the problem, with a plane tally at the level. */
    murk_phase_table *table;
    const layer of = {
        .albedo = reference_number(t, row, "albedo"),
        .phase = phase_of(reference_text(t, row, "phase"), MOMENTS_MAX, &table),
        .tau = reference_number(t, row, "tau"),
        .mu0 = reference_number(t, row, "mu0"),
        .half_width = HALF_WIDTH};
    const murk_tally_desc plane =
        layer_plane("level", reference_number(t, row, "level"), 1);
    /* The reference adds direct and diffuse light. */
    const validation_cell cell[] = {{0, 1, 1}, {0, 0, 1}};
    const validation_reference down = share(t, row, "down");
    const validation_reference direct = share(t, row, "direct");
    const validation_reference reference[] = {
        share(t, row, "up"),
        {"down, direct and diffuse", down.value + direct.value,
         hypot(down.uncertainty, direct.uncertainty)}};
    test_world w = layer_made(&of);
    validation_trace(v, &(validation_case){.name = name,
                                           .source = SOURCE,
                                           .world = &w.world,
                                           .reference = reference,
                                           .quantities = 2,
                                           .tally = &plane,
                                           .tallies = 1,
                                           .cell = cell,
                                           .cells = 2,
                                           .least_weight = MIN_WEIGHT});
    test_world_unmade(&w);
    murk_phase_table_destroy(table);
}

static bool is_problem(const murk_table *t, size_t row, const char *name)
{
    return strcmp(reference_text(t, row, "problem"), name) == 0;
}

void cases_disort(validation *v)
{
    const murk_phase isotropic = murk_phase_hg(0);
    const murk_phase less_forward = murk_phase_hg(.74);
    murk_table *t = reference_read("disort.csv");
    for (size_t row = 0; row < t->rows; ++row) {
        trace(v, t, row, NULL, NULL, MOMENTS_MAX);
        if (is_problem(t, row, "2d")) {
            trace(v, t, row, "isotropic", &isotropic, MOMENTS_MAX);
        } else if (is_problem(t, row, "3b")) {
            trace(v, t, row, "g .74", &less_forward, MOMENTS_MAX);
        } else if (is_problem(t, row, "4b")) {
            trace(v, t, row, "8 of 82 moments", NULL, 8);
        } else if (is_problem(t, row, "5b")) {
            trace(v, t, row, "30 of 299 moments", NULL, 30);
            trace_plane(v, t, row);
        }
    }
    murk_table_destroy(t);
}
