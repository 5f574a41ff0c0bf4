/* Coverage of re-weighted records: the sightlines are found once
 * (calibrate/visible.h), the sums are computed for each set of optics
 * (calibrate/coverage_sums.h) and combined into a ratio
 * (calibrate/coverage_ratio.h). */
#include "calibrate/covered.h"

#include "calibrate/coverage_ratio.h"
#include "plan/plan.h"

#include <assert.h>
#include <stdlib.h>

struct murk_covered {
    murk_visible_desc desc;
    murk_map_weights weights;
    murk_combining combining;
    size_t redundancy; /* number of sightlines of a record that count, the
                        * clearest ones; at least 1; not used for independent
                        * detections */
    murk_visible *visible;
};

/* ---- creation ---- */

murk_status murk_covered_check(const murk_scene_desc *scene, murk_error *err)
{
    /* The combined clarity must be a smooth function of the medium, and
     * sightlines must be straight. */
    const murk_scene_placement *settings = &scene->placement;
    if (!murk_detection_is(settings->detection, MURK_DETECTION_SMOOTH)) {
        return murk_fail(
            err, MURK_BAD_VALUE, settings->where,
            "detection: %s cannot be fitted to: coverage needs "
            "%s, which change smoothly with the medium",
            murk_detection_name(settings->detection),
            murk_detection_list(MURK_DETECTION_SMOOTH, true, " or ").text);
    }
    if (settings->through == MURK_SCENE_REFRACT) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "through: refract cannot be fitted to: coverage "
                         "needs straight sightlines, thin or block");
    }
    if (settings->targets.given) {
        return murk_fail(err, MURK_BAD_VALUE, settings->where,
                         "targets cannot be fitted to: coverage is of the "
                         "light itself");
    }
    return MURK_OK;
}

murk_status murk_covered_create(murk_covered **out,
                                const murk_visible_desc *desc, murk_error *err)
{
    const murk_scene_placement *settings = &desc->stage->scene->placement;
    murk_covered *made = NULL;
    murk_status status = murk_covered_check(desc->stage->scene, err);
    if (status) {
        return status;
    }
    made = calloc(1, sizeof *made);
    if (!made) {
        return murk_no_memory(err, "", "for coverage");
    }
    /* Settings of the scene. */
    made->desc = *desc;
    made->combining = murk_combining_of(settings->detection);
    made->redundancy =
        settings->redundancy > 1 ? (size_t)settings->redundancy : 1;
    made->weights = (murk_map_weights){.balanced = settings->balanced,
                                       .surface = settings->weight_surface,
                                       .volume = settings->weight_volume};
    /* Find the sightlines. */
    status = murk_visible_create(&made->visible, desc, err);
    if (status) {
        free(made);
        return status;
    }
    *out = made;
    return MURK_OK;
}

void murk_covered_destroy(murk_covered *covered)
{
    if (covered) {
        murk_visible_destroy(covered->visible);
        free(covered);
    }
}

double murk_covered_bytes(const murk_covered *covered)
{
    const murk_visible *visible = covered->visible;
    double bytes =
        (double)visible->n * (sizeof *visible->worth_w + sizeof *visible->kind);
    for (size_t g = 0; g < visible->groups; ++g) {
        bytes += murk_sightlines_bytes(&visible->of[g], visible->media);
    }
    return bytes;
}

/* ---- evaluation ---- */

/* Fails if the extinction of a medium without stored density paths differs from
 * the traced one. */
static murk_status check_others(const murk_covered *c,
                                const murk_optics *traced,
                                const murk_optics *at, murk_error *err)
{
    const murk_scene_desc *scene = c->desc.stage->scene;
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const size_t medium = (size_t)scene->regions[i].medium;
        for (size_t a = 0; !murk_visible_has_paths(c->desc.histories, medium) &&
                           a < c->visible->acceptances;
             ++a) {
            for (size_t band = 0; band < (size_t)scene->bands; ++band) {
                const double rad = c->visible->acceptance_rad[a];
                if (murk_visible_extinction(traced, medium, band, rad) !=
                    murk_visible_extinction(at, medium, band, rad)) {
                    return murk_fail(err, MURK_BAD_VALUE,
                                     scene->media[medium].where,
                                     "the medium differs from that of the "
                                     "traced light, whose paths through it "
                                     "were not kept");
                }
            }
        }
    }
    return MURK_OK;
}

/* Fills the derivatives of the extinctions with respect to each key, by central
 * differences. */
static murk_status find_slopes(murk_coverage_sums *s, const murk_covered *c,
                               const murk_optics *traced,
                               const murk_optics_sides *sides, murk_error *err)
{
    const murk_histories *histories = c->desc.histories;
    const size_t cells = murk_coverage_cells(s);
    double *low = calloc(cells + 1, sizeof *low);
    murk_status status = low ? MURK_OK : murk_no_memory(err, "", "for slopes");
    for (size_t k = 0; k < s->keys && !status; ++k) {
        const murk_optics_sides *side = &sides[k];
        double *slope = s->steepness + k * cells;
        s->has_say[k] = side->low != NULL;
        if (!side->low) {
            continue; /* the key has no effect */
        }
        /* Difference quotients; other media must not change. */
        murk_visible_extinctions(low, c->visible, histories, side->low);
        murk_visible_extinctions(slope, c->visible, histories, side->high);
        for (size_t cell = 0; cell < cells; ++cell) {
            slope[cell] = (slope[cell] - low[cell]) / side->span;
        }
        status = check_others(c, traced, side->low, err);
        status = status ? status : check_others(c, traced, side->high, err);
    }
    free(low);
    return status;
}

/* Fills the weights of the maps at the wanted optics; fails if no map that
 * counts has weight. */
static murk_status mix_all(murk_coverage_mix *out, const murk_coverage_sums *s,
                           const murk_covered *c, murk_error *err)
{
    double all[MURK_MAP_PARTS] = {0};
    for (size_t i = 0; i < s->batches * MURK_MAP_PARTS; ++i) {
        all[i % MURK_MAP_PARTS] += s->all[i];
    }
    return murk_coverage_mix_of(out, &c->weights, all)
               ? MURK_OK
               : murk_fail(err, MURK_RUN_FAILED,
                           c->desc.stage->scene->placement.where,
                           "re-weighted, the stored photons weigh %g W on "
                           "surfaces and %g W in media: there is no coverage "
                           "to tell",
                           all[MURK_SURFACE_PART], all[MURK_VOLUME_PART]);
}

murk_status murk_covered_read(const murk_row_sums *out, size_t first,
                              const murk_covered *covered,
                              const murk_reweighed *reweighed,
                              const murk_optics *traced, const murk_optics *at,
                              const murk_optics_sides *sides, murk_error *err)
{
    assert(reweighed->n == covered->visible->n);
    const size_t groups = covered->desc.groups, keys = reweighed->keys;
    murk_coverage_sums sums = {.visible = covered->visible,
                               .reweighed = reweighed,
                               .combining = covered->combining,
                               .redundancy = covered->redundancy,
                               .bands =
                                   (size_t)covered->desc.stage->scene->bands,
                               .batches = out->batches,
                               .runs = out->runs,
                               .keys = keys};
    murk_coverage_mix mix;
    /* Check the optics; allocate; fill the bounds of batches, the extinctions
     * and their derivatives. */
    murk_status status = check_others(covered, traced, at, err);
    if (!status && !murk_coverage_sums_allocate(&sums)) {
        status =
            murk_no_memory(err, "", "for the coverage of %zu groups", groups);
    }
    if (!status) {
        for (size_t b = 0; b <= sums.batches; ++b) {
            sums.bound[b] =
                murk_histories_first(covered->desc.histories, sums.batches, b);
        }
        murk_visible_extinctions(sums.extinction, covered->visible,
                                 covered->desc.histories, at);
        status = find_slopes(&sums, covered, traced, sides, err);
    }
    /* Sum. */
    if (!status) {
        status = murk_coverage_sums_add(&sums, covered->desc.threads, err);
    }
    status = status ? status : mix_all(&mix, &sums, covered, err);
    /* Ratio, slopes and contributions of each group. */
    for (size_t g = 0; g < groups && !status; ++g) {
        const size_t row = first + g;
        double *slope = out->slope + row * keys;
        murk_coverage_ratio(&out->value[row], slope, out->batch + row,
                            out->rows, g, &sums, &mix);
        murk_coverage_slope_parts(out->run + row * keys, out->rows * keys,
                                  slope, g, &sums, &mix);
    }
    murk_coverage_sums_release(&sums);
    return status;
}
