/* Reflectance and transmittance of even slabs, lit along the normal and by
 * cosine law. */
#include <math.h>
#include <stdio.h>

#include "cases/groups.h"
#include "cases/layer.h"
#include "cases/reference.h"
#include "scores.h"

/* photons.least_weight: photons lose weight at collisions instead of ending
 * there, which lowers the noise where much is absorbed. */
#define MIN_WEIGHT .3

#define SOURCE "adding-doubling, 64 to 120 nodes"

static const score_of ends[] = {{.kind = SCORE_ESCAPED, .side = -1},
                                {.kind = SCORE_ESCAPED, .side = 1}};

/* The two ends, where the table has a number for both, else the first. */
static void trace(validation *v, const char *name, const char *is_wrong,
                  const layer *of, const validation_reference reference[2])
{
    if (!validation_wants(v, name)) {
        return;
    }
    test_world w = layer_made(of);
    const scores score = {ends, isnan(reference[1].value) ? 1 : 2};
    validation_trace(v, &(validation_case){.name = name,
                                           .source = SOURCE,
                                           .is_wrong = is_wrong,
                                           .world = &w.world,
                                           .reference = reference,
                                           .quantities = score.n,
                                           .score = scores_add,
                                           .context = &score,
                                           .least_weight = MIN_WEIGHT});
    test_world_unmade(&w);
}

static void trace_row(validation *v, const murk_table *t, size_t row)
{
    const layer of = {.index = reference_number(t, row, "index"),
                      .albedo = reference_number(t, row, "albedo"),
                      .phase = murk_phase_hg(reference_number(t, row, "g")),
                      .tau = reference_number(t, row, "tau")};
    char name[80];
    snprintf(name, sizeof name, "index %s albedo %s g %s tau %s",
             reference_text(t, row, "index"), reference_text(t, row, "albedo"),
             reference_text(t, row, "g"), reference_text(t, row, "tau"));
    const validation_reference straight[2] = {
        reference_value(t, row, "reflected", "reflected"),
        reference_value(t, row, "transmitted", "transmitted")};
    trace(v, name, NULL, &of, straight);
    const validation_reference diffuse[2] = {
        reference_value(t, row, "diffuse_reflected", "diffuse reflected"),
        reference_value(t, row, "diffuse_transmitted", "diffuse transmitted")};
    if (!isnan(diffuse[0].value)) {
        layer lit = of;
        lit.is_diffuse = true;
        trace(v, name, NULL, &lit, diffuse);
    }
}

void cases_slabs(validation *v)
{
    murk_table *t = reference_read("slabs.csv");
    for (size_t row = 0; row < t->rows; ++row) {
        trace_row(v, t, row);
    }
    const layer less_forward = {
        .albedo = .9, .phase = murk_phase_hg(.48), .tau = 5};
    trace(v, "index 1 albedo 0.9 g 0.5 tau 5", "g .48", &less_forward,
          (validation_reference[2]){{"reflected", .270013, 5e-7},
                                    {"transmitted", .171606, 5e-7}});
    const layer less_dense = {.index = 1.45,
                              .albedo = .99,
                              .phase = murk_phase_hg(.5),
                              .tau = INFINITY};
    trace(v, "index 1.5 albedo 0.99 g 0.5 tau inf", "index 1.45", &less_dense,
          (validation_reference[2]){{"reflected", .500605, 5e-7},
                                    {"transmitted", NAN, 0}});
    murk_table_destroy(t);
}
