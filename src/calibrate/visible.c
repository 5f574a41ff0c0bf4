/* Finds the sightlines of sensors with a sight through clear media
 * (sensing/sight.h), so that surfaces alone decide, and stores the density
 * paths along them (calibrate/sightlines.h). Sensors with different acceptance
 * angles see media with different extinctions. */
#include "calibrate/visible.h"

#include "base/interrupt.h"
#include "base/machine.h"
#include "base/pool.h"
#include "base/ranks.h"
#include "base/tally.h"
#include "medium/rescaled.h"
#include "plan/plan.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Share of the free memory for sightlines. The lists of a group exist twice
 * while they are sorted. */
#define MEMORY_SHARE 0.45

typedef struct search {
    const murk_visible_desc *desc;
    const murk_scene_desc *scene;
    murk_visible *visible;
    murk_photon_map *empty;
    murk_sight *sight;          /* through clear media */
    murk_media *clear, **alone; /* [media] */
    murk_media **other; /* [acceptances + 1]; media that are not re-weighted,
                         * NULL last; NULL: none */
    double *extinction; /* [acceptances][bands][media] */
    murk_sightlines_through *through; /* [acceptances] */
    murk_sightlines *pose;            /* [poses] */
    murk_sightlines_memory memory;
    murk_tally failures;
    murk_arena arena; /* of all arrays here */
} search;

double murk_visible_extinction(const murk_optics *optics, size_t medium,
                               size_t band, double acceptance_rad)
{
    const double extinction_per_m = optics->extinction_per_m[medium].band[band];
    const murk_phase *phase = &optics->phases->medium[medium][band];
    return acceptance_rad > 0
               ? extinction_per_m *
                     (1 - optics->albedo[medium].band[band] *
                              murk_phase_share_within(phase, acceptance_rad))
               : extinction_per_m;
}

void murk_visible_extinctions(double *extinction, const murk_visible *visible,
                              const murk_histories *histories,
                              const murk_optics *optics)
{
    const size_t bands = (size_t)optics->bands;
    for (size_t k = 0; k < visible->acceptances * bands; ++k) {
        for (size_t m = 0; m < visible->media; ++m) {
            extinction[k * visible->media + m] =
                murk_visible_extinction(optics, histories->medium[m], k % bands,
                                        visible->acceptance_rad[k / bands]);
        }
    }
}

bool murk_visible_has_paths(const murk_histories *histories, size_t medium)
{
    for (size_t m = 0; m < histories->media; ++m) {
        if (histories->medium[m] == medium) {
            return true;
        }
    }
    return false;
}

/* ---- sightlines ---- */

/* Finds the sightlines of one pose, the k-th of this rank. */
static void find_sightlines(void *context, unsigned worker, uint64_t k)
{
    search *f = context;
    const size_t number = (size_t)murk_ranks_item(k);
    murk_sightlines *lines = &f->pose[number];
    if (!murk_sightlines_find(lines, &f->through[lines->acceptance_all], worker,
                              &f->desc->pose[number], &f->memory)) {
        murk_tally_add(&f->failures, 1);
    }
}

/* Sorts the sightlines of one group. */
static void sort_group(void *context, uint64_t group)
{
    search *f = context;
    const size_t *of = f->desc->group, poses = f->desc->poses;
    size_t first = 0, last;
    while (first < poses && of[first] < group) {
        ++first;
    }
    for (last = first; last < poses && of[last] == group; ++last) {
    }
    if (!murk_sightlines_join(&f->visible->of[group], f->pose + first,
                              last - first, f->through, f->visible->n)) {
        murk_tally_add(&f->failures, 1);
    }
}

/* ---- preparation ---- */

/* Finds the distinct acceptance angles, and that of each pose. */
static murk_status sort_acceptances(search *f, murk_error *err)
{
    const murk_visible_desc *desc = f->desc;
    murk_visible *visible = f->visible;
    murk_status status = MURK_OK;
    for (size_t j = 0; j < desc->poses && !status; ++j) {
        assert(desc->pose[j].type < f->scene->sensors.types &&
               murk_box_contains(&desc->stage->world.domain.box,
                                 desc->pose[j].position));
        const double rad =
            f->scene->sensors.type[desc->pose[j].type].acceptance_rad;
        /* Find the angle or add it. */
        size_t a = 0;
        while (a < visible->acceptances && visible->acceptance_rad[a] != rad) {
            ++a;
        }
        if (a == visible->acceptances) {
            assert(a <= UINT16_MAX);
            visible->acceptance_rad[visible->acceptances++] = rad;
            status = rad > 0
                         ? murk_media_check_acceptance(desc->stage->media, err)
                         : MURK_OK;
        }
        f->pose[j].acceptance_all = (uint16_t)a;
    }
    return status;
}

/* The media that are not re-weighted, for sensors of one acceptance angle. */
static murk_status make_other(search *f, size_t a, murk_spectrum *extinction,
                              murk_error *err)
{
    memset(extinction, 0, f->scene->n_media * sizeof *extinction);
    for (size_t i = 0; i < f->scene->n_media; ++i) {
        for (size_t band = 0; !murk_visible_has_paths(f->desc->histories, i) &&
                              band < (size_t)f->scene->bands;
             ++band) {
            extinction[i].band[band] = murk_visible_extinction(
                f->desc->optics, i, band, f->visible->acceptance_rad[a]);
        }
    }
    return murk_media_rescale(&f->other[a], f->desc->stage->media, extinction,
                              err);
}

/* Creates the media: without extinction, each re-weighted one by itself, and
 * the others. */
static murk_status make_media(search *f, murk_error *err)
{
    const murk_histories *histories = f->desc->histories;
    const murk_stage *stage = f->desc->stage;
    murk_visible *visible = f->visible;
    const size_t bands = (size_t)f->scene->bands;
    const bool has_other = histories->media < f->scene->n_media;
    /* Allocate. */
    murk_spectrum *extinction =
        murk_arena_array(&f->arena, f->scene->n_media, sizeof *extinction);
    f->alone = murk_arena_array(&f->arena, histories->media, sizeof *f->alone);
    f->other = has_other ? murk_arena_array(&f->arena, visible->acceptances + 1,
                                            sizeof *f->other)
                         : NULL;
    f->extinction = murk_arena_array(
        &f->arena, visible->acceptances * bands * histories->media,
        sizeof *f->extinction);
    murk_status status =
        f->arena.is_short
            ? murk_no_memory(err, "media", "for what sensors see through")
            : MURK_OK;
    /* Media without extinction: surfaces alone decide. */
    if (!status) {
        status = murk_media_rescale(&f->clear, stage->media, extinction, err);
    }
    /* Each re-weighted medium; the others together. */
    for (size_t m = 0; m < histories->media && !status; ++m) {
        status = murk_media_single(&f->alone[m], stage->media,
                                   histories->medium[m], err);
    }
    for (size_t a = 0; has_other && a < visible->acceptances && !status; ++a) {
        status = make_other(f, a, extinction, err);
    }
    /* Extinctions of the re-weighted media as traced. */
    if (!status) {
        murk_visible_extinctions(f->extinction, visible, histories,
                                 f->desc->optics);
    }
    return status;
}

/* Creates a sight that sees a record by surfaces and boundaries alone.
 * `emitted` of a record is the number of its contribution. */
static murk_status make_sight(search *f, murk_error *err)
{
    const murk_stage *stage = f->desc->stage;
    const murk_histories *histories = f->desc->histories;
    const murk_scene_placement *settings = &f->scene->placement;
    murk_sensor_type *types = murk_poses_types(f->scene);
    if (!types) {
        return murk_no_memory(err, f->scene->sensors.where,
                              "for the sensors' types");
    }
    /* Acceptance is part of the extinctions here. */
    for (size_t k = 0; k < f->scene->sensors.types; ++k) {
        types[k].acceptance_rad = 0;
    }
    /* Describe the sight; the mode of detection is applied later. */
    const murk_sight_desc desc = {
        .surfaces = stage->surfaces,
        .media = f->clear,
        .boundary_meshes = stage->boundary_meshes,
        .domain = stage->world.domain,
        .surface_map = histories->surface ? histories->surface : f->empty,
        .volume_map = histories->volume ? histories->volume : f->empty,
        .photons_emitted = histories->n,
        .type = types,
        .types = f->scene->sensors.types,
        .north = f->scene->north,
        .visibility =
            settings->by_normal ? MURK_VISIBILITY_NORMAL : MURK_VISIBILITY_RAY,
        .through_sheets = settings->through != MURK_SCENE_BLOCK,
        .weights = {.balanced = settings->balanced,
                    .surface = settings->weight_surface,
                    .volume = settings->weight_volume},
        .interest = murk_goals_interest(stage->goals),
        .threads = f->desc->threads,
        .where = settings->where};
    const murk_status status = murk_sight_create(&f->sight, &desc, err);
    free(types);
    return status;
}

/* Fills the weight and the kind of each record. */
static void weigh(const search *f)
{
    const murk_sight_desc *sight = murk_sight_described(f->sight);
    const murk_histories *histories = f->desc->histories;
    const size_t bands = (size_t)f->scene->bands;
    const size_t photons = murk_sight_photons(f->sight);
    const bool has_regions = sight->interest && sight->interest->n > 0;
    for (size_t i = 0; i < photons; ++i) {
        const murk_photon *p = murk_sight_photon(f->sight, i);
        const murk_contribution *c =
            &histories->contribution[murk_photon_emitted(p)];
        const double factor =
            has_regions ? murk_interest_factor(sight->interest,
                                               murk_sight_regions(f->sight, i))
                        : 1;
        f->visible->worth_w[murk_photon_emitted(p)] =
            histories->packet_w[c->light * bands + c->band] * (double)c->value *
            factor;
        f->visible->kind[murk_photon_emitted(p)] =
            (uint8_t)(murk_photon_band(p) * 2 +
                      (murk_photon_is_volume(p) ? 1 : 0));
    }
}

/* Describes the media for each acceptance angle. */
static void describe_media(search *f)
{
    const murk_visible *visible = f->visible;
    const bool has_sheets =
        murk_surfaces_describe(f->desc->stage->surfaces).sheets > 0;
    for (size_t a = 0; a < visible->acceptances; ++a) {
        f->through[a] = (murk_sightlines_through){
            .sight = f->sight,
            .media = visible->media,
            .alone = (const murk_media *const *)f->alone,
            .other = f->other ? f->other[a] : NULL,
            .extinction =
                f->extinction + a * (size_t)f->scene->bands * visible->media,
            .has_rest = f->other || has_sheets};
    }
}

static murk_status allocate(search *f, murk_error *err)
{
    const murk_visible_desc *desc = f->desc;
    const size_t n = desc->histories->n;
    murk_visible *visible = calloc(1, sizeof *visible);
    f->pose = murk_arena_array(&f->arena, desc->poses, sizeof *f->pose);
    f->through = murk_arena_array(&f->arena, desc->poses, sizeof *f->through);
    f->visible = visible;
    if (visible) {
        murk_arena *arena = &visible->arena;
        visible->groups = desc->groups;
        visible->media = desc->histories->media;
        visible->n = n;
        visible->of =
            murk_arena_array(arena, desc->groups, sizeof *visible->of);
        visible->acceptance_rad = murk_arena_array(
            arena, desc->poses, sizeof *visible->acceptance_rad);
        visible->worth_w = murk_arena_array(arena, n, sizeof(double));
        visible->kind = murk_arena_array(arena, n, sizeof *visible->kind);
    }
    return visible && !visible->arena.is_short && !f->arena.is_short
               ? MURK_OK
               : murk_no_memory(err, "", "to look at %zu records", n);
}

/* Errors of the parallel steps. */
static murk_status outcome(const search *f, murk_error *err)
{
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    if (murk_tally_read(&f->failures) > 0) {
        return murk_fail(err, MURK_BAD_VALUE, f->scene->photons.where,
                         "the sightlines of %zu sensors to %zu records take "
                         "more memory than this machine has free: fewer "
                         "photons, or sensors of less range",
                         f->desc->poses, murk_sight_photons(f->sight));
    }
    return MURK_OK;
}

static void release(search *f)
{
    for (size_t j = 0; f->pose && j < f->desc->poses; ++j) {
        murk_sightlines_release(&f->pose[j]);
    }
    for (size_t m = 0; f->alone && m < f->desc->histories->media; ++m) {
        murk_media_destroy(f->alone[m]);
    }
    for (size_t a = 0; f->other && f->other[a]; ++a) {
        murk_media_destroy(f->other[a]);
    }
    murk_media_destroy(f->clear);
    murk_sight_destroy(f->sight);
    murk_photon_map_destroy(f->empty);
    murk_visible_destroy(f->visible);
    murk_arena_release(&f->arena);
}

murk_status murk_visible_create(murk_visible **out,
                                const murk_visible_desc *desc, murk_error *err)
{
    search f = {.desc = desc,
                .scene = desc->stage->scene,
                .memory.max_bytes = MEMORY_SHARE * murk_machine_memory_bytes()};
    /* Prepare poses, acceptances, media and sight. */
    murk_status status = allocate(&f, err);
    if (status || (status = sort_acceptances(&f, err)) ||
        (status = murk_photon_map_create(&f.empty, NULL, 0, 1, err)) ||
        (status = make_media(&f, err)) || (status = make_sight(&f, err))) {
        goto done;
    }
    /* Find the sightlines of each pose, then sort them by group. */
    weigh(&f);
    describe_media(&f);
    murk_pool_run_workers(desc->threads, murk_ranks_share(desc->poses),
                          find_sightlines, &f);
    status = murk_ranks_share_failure(outcome(&f, err), err);
    if (!status) {
        bool fits;
        status = murk_sightlines_exchange(&fits, f.pose, desc->poses, f.through,
                                          &f.memory, err);
        murk_tally_add(&f.failures, !fits);
        status = status ? status : outcome(&f, err);
    }
    if (!status) {
        murk_pool_run(desc->threads, desc->groups, sort_group, &f);
        status = murk_ranks_share_failure(outcome(&f, err), err);
    }
    if (!status) {
        *out = f.visible;
        f.visible = NULL;
    }
done:
    release(&f);
    return status;
}

void murk_visible_destroy(murk_visible *visible)
{
    if (!visible) {
        return;
    }
    for (size_t g = 0; visible->of && g < visible->groups; ++g) {
        murk_sightlines_release(&visible->of[g]);
    }
    murk_arena_release(&visible->arena);
    free(visible);
}
