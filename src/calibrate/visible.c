/* Finds the sightlines of sensors with a sight through clear media
 * (sensing/sight.h), so that surfaces alone decide, and stores the density
 * paths along them (calibrate/sightlines.h). Sensors with different acceptance
 * angles see media with different extinctions. */
#include "calibrate/seen.h"

#include "base/interrupt.h"
#include "base/machine.h"
#include "base/pool.h"
#include "base/position.h"
#include "base/tally.h"
#include "medium/rescaled.h"
#include "plan/plan.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Share of the free memory for sightlines. The lists of a group exist twice
 * while they are sorted. */
#define MEMORY_SHARE 0.45

typedef struct incumbent {
    const murk_seen_desc *desc;
    const murk_scene_desc *scene;
    murk_seen *seen;
    murk_photon_map *empty;
    murk_sight *sight;          /* through clear media */
    murk_media *clear, **alone; /* [media] */
    murk_media **other; /* [acceptances + 1]; media that are not re-weighted,
                         * NULL last; NULL: none */
    double *extinction; /* [acceptances][bands][media] */
    murk_sightlines_through *through; /* [acceptances] */
    murk_sightlines *pose;            /* [poses] */
    murk_sightlines_room room;
    murk_tally failures;
} incumbent;

double murk_seen_extinction(double extinction_per_m, double albedo,
                            const murk_phase *phase, double acceptance_rad)
{
    return acceptance_rad > 0
               ? extinction_per_m * (1 - albedo * murk_phase_share_within(
                                                      phase, acceptance_rad))
               : extinction_per_m;
}

bool murk_seen_keeps(const murk_followed *followed, size_t medium)
{
    for (size_t m = 0; m < followed->media; ++m) {
        if (followed->medium[m] == medium) {
            return true;
        }
    }
    return false;
}

/* ---- sightlines ---- */

/* Finds the sightlines of one pose. */
static void look_from(void *context, unsigned worker, uint64_t number)
{
    incumbent *f = context;
    murk_sightlines *lines = &f->pose[number];
    if (!murk_sightlines_find(lines, &f->through[lines->acceptance_all], worker,
                              &f->desc->pose[number], &f->room)) {
        murk_tally_add(&f->failures, 1);
    }
}

/* Sorts the sightlines of one group. */
static void join(void *context, uint64_t group)
{
    incumbent *f = context;
    const size_t *of = f->desc->group, poses = f->desc->poses;
    size_t first = 0, last;
    while (first < poses && of[first] < group) {
        ++first;
    }
    for (last = first; last < poses && of[last] == group; ++last) {
    }
    if (!murk_sightlines_join(&f->seen->of[group], f->pose + first,
                              last - first, f->through, f->seen->n)) {
        murk_tally_add(&f->failures, 1);
    }
}

/* ---- preparation ---- */

/* Finds the distinct acceptance angles, and that of each pose. */
static murk_status sort_acceptances(incumbent *f, murk_error *err)
{
    const murk_seen_desc *desc = f->desc;
    murk_seen *seen = f->seen;
    murk_status status = MURK_OK;
    for (size_t j = 0; j < desc->poses && !status; ++j) {
        assert(desc->pose[j].type < f->scene->sensors.types);
        const double rad =
            f->scene->sensors.type[desc->pose[j].type].acceptance_rad;
        size_t a = 0;
        while (a < seen->acceptances && seen->acceptance_rad[a] != rad) {
            ++a;
        }
        if (a == seen->acceptances) {
            assert(a <= UINT16_MAX);
            seen->acceptance_rad[seen->acceptances++] = rad;
            status = rad > 0
                         ? murk_media_check_acceptance(desc->stage->media, err)
                         : MURK_OK;
        }
        f->pose[j].acceptance_all = (uint16_t)a;
    }
    return status;
}

/* The extinction of a medium for an acceptance angle. */
static double extinction_of(const incumbent *f, size_t medium, int band,
                            double acceptance_rad)
{
    const murk_scene_medium *m = &f->scene->media[medium];
    return murk_seen_extinction(
        m->extinction_per_m.band[band], m->albedo.band[band],
        &f->desc->stage->phases->medium[medium][band], acceptance_rad);
}

/* The media that are not re-weighted, for sensors of one acceptance angle. */
static murk_status make_other(incumbent *f, size_t a, murk_spectrum *extinction,
                              murk_error *err)
{
    memset(extinction, 0, f->scene->n_media * sizeof *extinction);
    for (size_t i = 0; i < f->scene->n_media; ++i) {
        for (int band = 0;
             !murk_seen_keeps(f->desc->followed, i) && band < f->scene->bands;
             ++band) {
            extinction[i].band[band] =
                extinction_of(f, i, band, f->seen->acceptance_rad[a]);
        }
    }
    return murk_media_rescale(&f->other[a], f->desc->stage->media, extinction,
                              err);
}

/* Creates the media: without extinction, each re-weighted one by itself, and
 * the others. */
static murk_status make_media(incumbent *f, murk_error *err)
{
    const murk_followed *followed = f->desc->followed;
    const murk_stage *stage = f->desc->stage;
    murk_seen *seen = f->seen;
    const size_t bands = (size_t)f->scene->bands;
    const bool has_other = followed->media < f->scene->n_media;
    /* Allocate. */
    murk_spectrum *extinction =
        calloc(f->scene->n_media + 1, sizeof *extinction);
    f->alone = calloc(followed->media + 1, sizeof *f->alone);
    f->other =
        has_other ? calloc(seen->acceptances + 1, sizeof *f->other) : NULL;
    f->extinction = calloc(seen->acceptances * bands * followed->media + 1,
                           sizeof *f->extinction);
    murk_status status = MURK_OK;
    if (!extinction || !f->alone || !f->extinction ||
        (has_other && !f->other)) {
        status = murk_fail(err, MURK_NO_MEMORY, "media",
                           "no memory for what sensors see through");
    }
    /* Media without extinction: surfaces alone decide. */
    if (!status) {
        status = murk_media_rescale(&f->clear, stage->media, extinction, err);
    }
    /* Each re-weighted medium; the others together. */
    for (size_t m = 0; m < followed->media && !status; ++m) {
        status = murk_media_single(&f->alone[m], stage->media,
                                   followed->medium[m], err);
    }
    for (size_t a = 0; has_other && a < seen->acceptances && !status; ++a) {
        status = make_other(f, a, extinction, err);
    }
    /* Extinctions of the re-weighted media as traced. */
    for (size_t k = 0; !status && k < seen->acceptances * bands; ++k) {
        for (size_t m = 0; m < followed->media; ++m) {
            f->extinction[k * followed->media + m] =
                extinction_of(f, followed->medium[m], (int)(k % bands),
                              seen->acceptance_rad[k / bands]);
        }
    }
    free(extinction);
    return status;
}

/* Creates a sight that sees a record by surfaces and boundaries alone.
 * `emitted` of a record is the number of its contribution. */
static murk_status make_sight(incumbent *f, murk_error *err)
{
    const murk_stage *stage = f->desc->stage;
    const murk_followed *followed = f->desc->followed;
    const murk_scene_placement *settings = &f->scene->placement;
    murk_sensor_type *types = murk_poses_types(f->scene);
    if (!types) {
        return murk_fail(err, MURK_NO_MEMORY, f->scene->sensors.where,
                         "no memory for the sensors' types");
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
        .surface_map = followed->surface ? followed->surface : f->empty,
        .volume_map = followed->volume ? followed->volume : f->empty,
        .photons_emitted = followed->n,
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
static void weigh(const incumbent *f)
{
    const murk_sight_desc *sight = murk_sight_described(f->sight);
    const murk_followed *followed = f->desc->followed;
    const size_t bands = (size_t)f->scene->bands;
    const size_t photons = murk_sight_photons(f->sight);
    const bool has_regions = sight->interest && sight->interest->n > 0;
    for (size_t i = 0; i < photons; ++i) {
        const murk_photon *p = murk_sight_photon(f->sight, i);
        const murk_contribution *c =
            &followed->contribution[murk_photon_emitted(p)];
        const double factor =
            has_regions ? murk_interest_factor(sight->interest,
                                               murk_sight_regions(f->sight, i))
                        : 1;
        f->seen->worth_w[murk_photon_emitted(p)] =
            followed->packet_w[c->light * bands + c->band] * (double)c->value *
            factor;
        f->seen->kind[murk_photon_emitted(p)] =
            (uint8_t)(murk_photon_band(p) * 2 +
                      (murk_photon_is_volume(p) ? 1 : 0));
    }
}

/* Describes the media for each acceptance angle. */
static void look_through(incumbent *f)
{
    const murk_seen *seen = f->seen;
    const bool has_sheets =
        murk_surfaces_describe(f->desc->stage->surfaces).sheets > 0;
    for (size_t a = 0; a < seen->acceptances; ++a) {
        f->through[a] = (murk_sightlines_through){
            .sight = f->sight,
            .media = seen->media,
            .alone = (const murk_media *const *)f->alone,
            .other = f->other ? f->other[a] : NULL,
            .extinction =
                f->extinction + a * (size_t)f->scene->bands * seen->media,
            .has_rest = f->other || has_sheets};
    }
}

static murk_status check_poses(const murk_seen_desc *desc, murk_error *err)
{
    const murk_box *box = &desc->stage->world.domain.box;
    for (size_t j = 0; j < desc->poses; ++j) {
        const murk_vec3 p = desc->pose[j].position;
        if (!murk_box_contains(box, p)) {
            return murk_fail(err, MURK_BAD_VALUE, "sensors",
                             "sensor %zu at %s m is outside the domain, %s to "
                             "%s m",
                             j + 1, murk_position_show(p).text,
                             murk_position_show(box->min).text,
                             murk_position_show(box->max).text);
        }
    }
    return MURK_OK;
}

/* Allocates. */
static murk_status set_aside(incumbent *f, murk_error *err)
{
    const murk_seen_desc *desc = f->desc;
    murk_seen *seen = calloc(1, sizeof *seen);
    f->seen = seen;
    f->pose = calloc(desc->poses + 1, sizeof *f->pose);
    f->through = calloc(desc->poses + 1, sizeof *f->through);
    if (seen) {
        seen->groups = desc->groups;
        seen->media = desc->followed->media;
        seen->n = desc->followed->n;
        seen->of = calloc(desc->groups + 1, sizeof *seen->of);
        seen->acceptance_rad =
            calloc(desc->poses + 1, sizeof *seen->acceptance_rad);
        seen->worth_w = calloc(seen->n + 1, sizeof *seen->worth_w);
        seen->kind = calloc(seen->n + 1, sizeof *seen->kind);
    }
    if (f->pose && f->through && seen && seen->of && seen->acceptance_rad &&
        seen->worth_w && seen->kind) {
        return MURK_OK;
    }
    return murk_fail(err, MURK_NO_MEMORY, "",
                     "no memory to look at %zu records", desc->followed->n);
}

/* Errors of the parallel steps. */
static murk_status outcome(const incumbent *f, murk_error *err)
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

static void release(incumbent *f)
{
    for (size_t j = 0; f->pose && j < f->desc->poses; ++j) {
        murk_sightlines_release(&f->pose[j]);
    }
    for (size_t m = 0; f->alone && m < f->desc->followed->media; ++m) {
        murk_media_destroy(f->alone[m]);
    }
    for (size_t a = 0; f->other && f->other[a]; ++a) {
        murk_media_destroy(f->other[a]);
    }
    murk_media_destroy(f->clear);
    free(f->pose);
    free(f->through);
    free(f->alone);
    free(f->other);
    free(f->extinction);
    murk_sight_destroy(f->sight);
    murk_photon_map_destroy(f->empty);
    murk_seen_destroy(f->seen);
}

murk_status murk_seen_create(murk_seen **out, const murk_seen_desc *desc,
                             murk_error *err)
{
    incumbent f = {.desc = desc,
                   .scene = desc->stage->scene,
                   .room.max_bytes =
                       MEMORY_SHARE * murk_machine_memory_bytes()};
    /* Prepare poses, acceptances, media and sight. */
    murk_status status = check_poses(desc, err);
    if (!status) {
        status = set_aside(&f, err);
    }
    if (!status) {
        status = sort_acceptances(&f, err);
    }
    if (!status) {
        status = murk_photon_map_create(&f.empty, NULL, 0, 1, err);
    }
    if (!status) {
        status = make_media(&f, err);
    }
    if (!status) {
        status = make_sight(&f, err);
    }
    /* Find the sightlines of each pose, then sort them by group. */
    if (!status) {
        weigh(&f);
        look_through(&f);
        murk_pool_run_workers(desc->threads, desc->poses, look_from, &f);
        status = outcome(&f, err);
    }
    if (!status) {
        murk_pool_run(desc->threads, desc->groups, join, &f);
        status = outcome(&f, err);
    }
    if (!status) {
        *out = f.seen;
        f.seen = NULL;
    }
    release(&f);
    return status;
}

void murk_seen_destroy(murk_seen *seen)
{
    if (!seen) {
        return;
    }
    for (size_t g = 0; seen->of && g < seen->groups; ++g) {
        murk_sightlines_release(&seen->of[g]);
    }
    free(seen->of);
    free(seen->acceptance_rad);
    free(seen->worth_w);
    free(seen->kind);
    free(seen);
}
