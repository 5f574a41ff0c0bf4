/* Coverage of re-weighted records: the sightlines are found once
 * (calibrate/seen.h), the sums are computed for each set of optics
 * (calibrate/coverage_sums.h) and combined into a ratio
 * (calibrate/coverage_ratio.h). */
#include "calibrate/covered.h"

#include "base/interrupt.h"
#include "calibrate/coverage_ratio.h"
#include "plan/plan.h"

#include <assert.h>
#include <stdlib.h>

/* Runs of batches that are processed in parallel: enough tasks for the threads
 * of most machines. */
#define RUNS 16

/* Number of batches if the caller wants none. */
#define BATCHES_OWN 64

struct murk_covered {
    murk_covered_desc desc;
    murk_map_weights weights;
    murk_combining combining;
    size_t redundancy; /* number of views that count, at least 1 */
    murk_seen *seen;
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
                                const murk_covered_desc *desc, murk_error *err)
{
    const murk_scene_placement *settings = &desc->stage->scene->placement;
    const murk_seen_desc seen = {.stage = desc->stage,
                                 .followed = desc->followed,
                                 .pose = desc->pose,
                                 .group = desc->group,
                                 .poses = desc->poses,
                                 .groups = desc->groups,
                                 .threads = desc->threads};
    murk_covered *made = NULL;
    murk_status status = murk_covered_check(desc->stage->scene, err);
    if (status) {
        return status;
    }
    made = calloc(1, sizeof *made);
    if (!made) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for coverage");
    }
    /* Settings of the scene. */
    made->desc = *desc;
    made->combining =
        murk_combining_of(desc->stage->scene->placement.detection);
    made->redundancy =
        settings->redundancy > 1 ? (size_t)settings->redundancy : 1;
    made->weights = (murk_map_weights){.balanced = settings->balanced,
                                       .surface = settings->weight_surface,
                                       .volume = settings->weight_volume};
    /* Find the sightlines. */
    status = murk_seen_create(&made->seen, &seen, err);
    if (!status) {
        *out = made;
        made = NULL;
    }
    murk_covered_destroy(made);
    return status;
}

void murk_covered_destroy(murk_covered *covered)
{
    if (covered) {
        murk_seen_destroy(covered->seen);
        free(covered);
    }
}

double murk_covered_bytes(const murk_covered *covered)
{
    const murk_seen *seen = covered->seen;
    double bytes =
        (double)seen->n * (sizeof *seen->worth_w + sizeof *seen->kind);
    for (size_t g = 0; g < seen->groups; ++g) {
        bytes += murk_sightlines_bytes(&seen->of[g], seen->media);
    }
    return bytes;
}

/* ---- extinction as sensors see it ---- */

static double extinction_of(const murk_optics *optics, size_t medium,
                            size_t band, double acceptance_rad)
{
    return murk_seen_extinction(optics->extinction_per_m[medium].band[band],
                                optics->albedo[medium].band[band],
                                &optics->phases->medium[medium][band],
                                acceptance_rad);
}

/* Fills extinction[acceptances][bands][media] of the re-weighted media. */
static void fill_extinctions(double *extinction, const murk_covered *c,
                             const murk_optics *optics)
{
    const murk_seen *seen = c->seen;
    const size_t bands = (size_t)c->desc.stage->scene->bands;
    for (size_t a = 0; a < seen->acceptances; ++a) {
        for (size_t band = 0; band < bands; ++band) {
            for (size_t m = 0; m < seen->media; ++m) {
                extinction[(a * bands + band) * seen->media + m] =
                    extinction_of(optics, c->desc.followed->medium[m], band,
                                  seen->acceptance_rad[a]);
            }
        }
    }
}

/* Fails if a medium without stored density paths differs. */
static murk_status check_others(const murk_covered *c,
                                const murk_optics *traced,
                                const murk_optics *at, murk_error *err)
{
    const murk_scene_desc *scene = c->desc.stage->scene;
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const size_t medium = (size_t)scene->regions[i].medium;
        for (size_t a = 0; !murk_seen_keeps(c->desc.followed, medium) &&
                           a < c->seen->acceptances;
             ++a) {
            for (size_t band = 0; band < (size_t)scene->bands; ++band) {
                const double rad = c->seen->acceptance_rad[a];
                if (extinction_of(traced, medium, band, rad) !=
                    extinction_of(at, medium, band, rad)) {
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

/* ---- evaluation ---- */

/* Finds the first contribution of each batch: batch b contains the photons p
 * with p * batches / emitted = b, rounded down. */
static void find_bounds(murk_coverage_sums *r, const murk_followed *followed)
{
    size_t i = 0;
    for (size_t b = 0; b < r->batches; ++b) {
        r->bound[b] = i;
        while (i < followed->n && (uint64_t)followed->contribution[i].photon *
                                          r->batches / followed->emitted <=
                                      b) {
            ++i;
        }
    }
    r->bound[r->batches] = i;
    assert(i == followed->n);
}

/* Allocates all sums; sums->seen and the counts must be set. */
static murk_status set_aside(murk_coverage_sums *s, murk_error *err)
{
    const size_t cells = murk_coverage_cells(s), groups = s->seen->groups;
    const size_t parts = MURK_MAP_PARTS;
    s->has_say = calloc(s->keys + 1, sizeof *s->has_say);
    s->bound = calloc(s->batches + 1, sizeof *s->bound);
    s->extinction = calloc(cells + 1, sizeof *s->extinction);
    s->steepness = calloc(s->keys * cells + 1, sizeof *s->steepness);
    s->all = calloc(s->batches * parts, sizeof *s->all);
    s->all_slope = calloc(s->runs * parts * s->keys + 1, sizeof *s->all_slope);
    s->in_view = calloc(groups * s->batches * parts + 1, sizeof *s->in_view);
    s->in_view_slope = calloc(groups * s->runs * parts * s->keys + 1,
                              sizeof *s->in_view_slope);
    if (s->has_say && s->bound && s->extinction && s->steepness && s->all &&
        s->all_slope && s->in_view && s->in_view_slope) {
        return MURK_OK;
    }
    return murk_fail(err, MURK_NO_MEMORY, "",
                     "no memory for the coverage of %zu groups", groups);
}

static void release(murk_coverage_sums *s)
{
    free(s->has_say);
    free(s->bound);
    free(s->extinction);
    free(s->steepness);
    free(s->all);
    free(s->all_slope);
    free(s->in_view);
    free(s->in_view_slope);
}

/* Fills the derivatives of the extinctions with respect to each key, by central
 * differences. */
static murk_status find_slopes(murk_coverage_sums *s, const murk_covered *c,
                               const murk_optics *traced,
                               const murk_optics_sides *sides, murk_error *err)
{
    const size_t cells = murk_coverage_cells(s);
    double *low = calloc(cells + 1, sizeof *low);
    murk_status status =
        low ? MURK_OK
            : murk_fail(err, MURK_NO_MEMORY, "", "no memory for slopes");
    for (size_t k = 0; k < s->keys && !status; ++k) {
        const murk_optics_sides *side = &sides[k];
        double *slope = s->steepness + k * cells;
        s->has_say[k] = side->low != NULL;
        if (!side->low) {
            continue; /* the key has no effect */
        }
        /* Difference quotients; other media must not change. */
        fill_extinctions(low, c, side->low);
        fill_extinctions(slope, c, side->high);
        for (size_t cell = 0; cell < cells; ++cell) {
            slope[cell] = (slope[cell] - low[cell]) / side->span;
        }
        status = check_others(c, traced, side->low, err);
        if (!status) {
            status = check_others(c, traced, side->high, err);
        }
    }
    free(low);
    return status;
}

/* Fills the weights of the maps at the wanted optics. */
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

/* Computes the sums; tells an interrupt from lack of memory. */
static murk_status add_up(murk_coverage_sums *s, const murk_covered *c,
                          murk_error *err)
{
    const bool has_room = murk_coverage_sums_add(s, c->desc.threads);
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    return has_room ? MURK_OK
                    : murk_fail(err, MURK_NO_MEMORY, "",
                                "no memory for the coverage of %zu groups",
                                c->desc.groups);
}

murk_status murk_covered_read(double *value, double *slope, double *batch,
                              size_t batches, double *slope_batch, size_t runs,
                              const murk_covered *covered,
                              const murk_reweighed *reweighed,
                              const murk_optics *traced, const murk_optics *at,
                              const murk_optics_sides *sides, size_t keys,
                              murk_error *err)
{
    assert(reweighed->n == covered->seen->n && reweighed->keys == keys);
    const size_t parts = batches > 0 ? batches : BATCHES_OWN;
    murk_coverage_sums sums = {.seen = covered->seen,
                               .reweighed = reweighed,
                               .combining = covered->combining,
                               .redundancy = covered->redundancy,
                               .bands =
                                   (size_t)covered->desc.stage->scene->bands,
                               .batches = parts,
                               .runs = slope_batch    ? runs
                                       : parts < RUNS ? parts
                                                      : RUNS,
                               .keys = keys};
    murk_coverage_mix mix;
    /* Optics: check, allocate, fill extinctions and derivatives. */
    murk_status status = check_others(covered, traced, at, err);
    if (!status) {
        status = set_aside(&sums, err);
    }
    if (!status) {
        find_bounds(&sums, covered->desc.followed);
        fill_extinctions(sums.extinction, covered, at);
        status = find_slopes(&sums, covered, traced, sides, err);
    }
    /* Sum. */
    if (!status) {
        status = add_up(&sums, covered, err);
    }
    if (!status) {
        status = mix_all(&mix, &sums, covered, err);
    }
    /* Ratio, slopes and contributions of each group. */
    for (size_t g = 0; g < covered->desc.groups && !status; ++g) {
        murk_coverage_ratio(&value[g], slope + g * keys,
                            batches > 0 ? batch + g : NULL,
                            covered->desc.groups, g, &sums, &mix);
        if (slope_batch) {
            murk_coverage_slope_parts(slope_batch + g * keys,
                                      covered->desc.groups * keys,
                                      slope + g * keys, g, &sums, &mix);
        }
    }
    release(&sums);
    return status;
}
