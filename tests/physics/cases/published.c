/* Slabs with published values: van de Hulst's with the angles at which light
 * leaves it (by event and by murk's own plane tallies), oblique light,
 * semi-infinite media with and without an index.
 *
 * Where a published value agrees with the adding-doubling solution to its last
 * digit, the published one is the reference. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "cases/groups.h"
#include "cases/layer.h"
#include "cases/reference.h"
#include "cases/spline.h"
#include "scores.h"

static layer layer_of(const murk_table *t, size_t row)
{
    const char *light = reference_text(t, row, "light");
    const bool is_diffuse = strcmp(light, "diffuse") == 0;
    return (layer){.index = reference_number(t, row, "index"),
                   .albedo = reference_number(t, row, "albedo"),
                   .phase = murk_phase_hg(reference_number(t, row, "g")),
                   .tau = reference_number(t, row, "tau"),
                   .mu0 = is_diffuse ? 1 : reference_number(t, row, "light"),
                   .is_diffuse = is_diffuse};
}

static void trace_layer(validation *v, const validation_case *c,
                        const layer *of)
{
    if (validation_wants(v, c->name)) {
        test_world w = layer_made(of);
        validation_case traced = *c;
        traced.world = &w.world;
        traced.score = c->context ? scores_add : NULL;
        validation_trace(v, &traced);
        test_world_unmade(&w);
    }
}

/* The rows of one case follow one another. Returns the row after the last. */
static size_t trace_case(validation *v, const murk_table *t, size_t row)
{
    static const score_of reflected = {.kind = SCORE_ESCAPED, .side = -1};
    static const score_of transmitted = {.kind = SCORE_ESCAPED, .side = 1};
    const char *name = reference_text(t, row, "case");
    score_of of[2];
    validation_reference reference[2];
    scores score = {of, 0};
    /* Quantities of the case: the published value if it has three digits or
     * more, otherwise the computed one. */
    const layer lit = layer_of(t, row);
    const char *source = reference_text(t, row, "source");
    for (; row < t->rows && score.n < 2 &&
           strcmp(reference_text(t, row, "case"), name) == 0;
         ++row, ++score.n) {
        const char *quantity = reference_text(t, row, "quantity");
        const bool is_published =
            strlen(reference_text(t, row, "published")) > strlen(".26");
        of[score.n] =
            strcmp(quantity, "reflected") == 0 ? reflected : transmitted;
        reference[score.n] = reference_value(
            t, row, is_published ? "published" : "computed", quantity);
    }
    /* Trace the layer once for all of them. */
    trace_layer(v,
                &(validation_case){.name = name,
                                   .source = source,
                                   .reference = reference,
                                   .quantities = score.n,
                                   .context = &score},
                &lit);
    return row;
}

/* ---- angles ---- */

#define BINS 10 /* of equal width in cosine */

/* Simpson's rule is exact to far below the digits of the table. */
#define PANELS 200

static double radian(double degrees)
{
    return degrees * MURK_PI / 180;
}

/* 2 pi times the integral of L mu over a bin of cosine. */
static double power_in_bin(const spline *radiance, size_t bin)
{
    const double from = (double)bin / BINS, step = 1. / BINS / PANELS;
    double sum = 0;
    for (size_t i = 0; i <= PANELS; ++i) {
        const double mu = from + (double)i * step;
        const double weight = i == 0 || i == PANELS ? 1 : i % 2 ? 4 : 2;
        sum += weight * mu * spline_at(radiance, acos(fmin(mu, 1)));
    }
    return 2 * MURK_PI * sum * step / 3;
}

/* The table between its angles by a spline in the angle; its error by what
 * every other angle alone would give: at fourth order the difference is 15
 * times the error, a third of it is taken. */
static void bins_of(const murk_table *t, const char *column,
                    validation_reference reference[BINS], char names[BINS][48],
                    const char *word)
{
    double angle[SPLINE_NODES_MAX], value[SPLINE_NODES_MAX];
    double angle2[SPLINE_NODES_MAX], value2[SPLINE_NODES_MAX];
    size_t n2 = 0;
    /* All angles, and every other angle. */
    for (size_t i = 0; i < t->rows; ++i) {
        angle[i] = radian(reference_number(t, i, "angle_deg"));
        value[i] = reference_number(t, i, column);
        if (i % 2 == 0) {
            angle2[n2] = angle[i];
            value2[n2++] = value[i];
        }
    }
    /* Power in each bin by both splines, and the uncertainty of the
     * reference. */
    const spline all = spline_through(angle, value, t->rows);
    const spline half = spline_through(angle2, value2, n2);
    for (size_t k = 0; k < BINS; ++k) {
        const double power = power_in_bin(&all, k);
        const double printed =
            validation_half_digit_of(reference_text(t, 0, column)) * 2 *
            MURK_PI * ((double)k + .5) / BINS / BINS;
        snprintf(names[k], sizeof names[k], "%s, cosine %.1f to %.1f", word,
                 (double)k / BINS, (double)(k + 1) / BINS);
        reference[k] = (validation_reference){
            names[k], power,
            hypot(printed, (power_in_bin(&half, k) - power) / 3)};
    }
}

#define ANGLES_SOURCE                                                  \
    "adding-doubling, van de Hulst 1980 table 35; spline between its " \
    "angles"

/* Scattered light by events: that before, that behind the slab. */
static void trace_angles(validation *v, const char *is_wrong, double g,
                         const validation_reference reference[2 * BINS])
{
    score_of of[2 * BINS];
    for (size_t k = 0; k < 2 * BINS; ++k) {
        const double bin = (double)(k % BINS);
        of[k] = (score_of){.kind = SCORE_ESCAPED,
                           .light = SCORE_DIFFUSE,
                           .side = k < BINS ? -1 : 1,
                           .mu_min = bin / BINS,
                           .mu_max = bin + 1 == BINS ? 2 : (bin + 1) / BINS};
    }
    const scores score = {of, 2 * BINS};
    trace_layer(v,
                &(validation_case){.name = "van de Hulst slab, angles",
                                   .source = ANGLES_SOURCE,
                                   .is_wrong = is_wrong,
                                   .reference = reference,
                                   .quantities = score.n,
                                   .context = &score},
                &(layer){.albedo = .9, .phase = murk_phase_hg(g), .tau = 2});
}

/* All light by planes in the sides that it leaves through. What comes straight
 * through the slab falls into the last bin behind it. */
static void trace_planes(validation *v,
                         const validation_reference angles[2 * BINS])
{
    const murk_tally_desc planes[] = {layer_plane("before", 0, 1),
                                      layer_plane("behind", 2, 1),
                                      layer_plane("before_angles", 0, BINS),
                                      layer_plane("behind_angles", 2, BINS)};
    validation_reference reference[2 + 2 * BINS] = {
        {"reflected", .09739, 5e-6}, {"transmitted", .66096, 5e-6}};
    validation_cell cell[2 + 2 * BINS] = {{0, 1, 1}, {1, 0, 1}};
    for (size_t k = 0; k < 2 * BINS; ++k) {
        const bool is_before = k < BINS; /* the slab, where backward counts */
        reference[2 + k] = angles[k];
        cell[2 + k] = is_before ? (validation_cell){2, BINS + k, 1}
                                : (validation_cell){3, k - BINS, 1};
    }
    reference[1 + 2 * BINS].value += exp(-2);
    reference[1 + 2 * BINS].quantity = "through, cosine 0.9 to 1.0";
    trace_layer(v,
                &(validation_case){.name = "van de Hulst slab, plane tallies",
                                   .source = ANGLES_SOURCE,
                                   .reference = reference,
                                   .quantities = 2 + 2 * BINS,
                                   .tally = planes,
                                   .tallies = 4,
                                   .cell = cell,
                                   .cells = 2 + 2 * BINS},
                &(layer){.albedo = .9,
                         .phase = murk_phase_hg(.75),
                         .tau = 2,
                         .half_width = 20});
}

static void van_de_hulst_slab(validation *v)
{
    murk_table *t = reference_read("vdhulst_slab_angular.csv");
    validation_reference reference[2 * BINS];
    char names[2 * BINS][48];
    bins_of(t, "reflected_per_sr", reference, names, "reflected");
    bins_of(t, "transmitted_per_sr", reference + BINS, names + BINS,
            "scattered through");
    trace_angles(v, NULL, .75, reference);
    trace_angles(v, "g .74", .74, reference);
    trace_planes(v, reference);
    murk_table_destroy(t);
}

void cases_published(validation *v)
{
    murk_table *t = reference_read("slabs_published.csv");
    for (size_t row = 0; row < t->rows;) {
        row = trace_case(v, t, row);
    }
    murk_table_destroy(t);
    van_de_hulst_slab(v);
}
