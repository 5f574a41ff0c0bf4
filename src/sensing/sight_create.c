/* Creation of a sight: checks the description and the records, prepares media
 * by acceptance angle, refracting boundaries, weights, regions of interest and
 * detection by power, and allocates the scratch buffers of the workers. Rows
 * are computed in sight_row.c, coverage in coverage.c. */
#include "base/machine.h"
#include "medium/rescaled.h"
#include "sensing/sight_parts.h"
#include "sensing/weights.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Possible distance of a stored position from the surface, as a share of the
 * domain's largest coordinate: rounding of vertices and of the stored position,
 * with a margin. */
#define POSITION_ERROR 0x1p-20

/* ---- detection ---- */

/* The clarity of a sightline if the sensor detects all or nothing: 1 from the
 * threshold on, else 0. */
static double detect_from_threshold(const murk_sight_desc *desc,
                                    double transmittance)
{
    return transmittance >= desc->threshold ? 1 : 0;
}

/* One row for each mode: the clarity, 0..1, that follows from the transmittance
 * of a sightline. NULL: the transmittance itself, or the detection probability
 * by power. */
static double (*const DETECT[MURK_DETECTIONS_COUNT])(
    const murk_sight_desc *desc, double transmittance) = {
    [MURK_DETECTION_THRESHOLD] = detect_from_threshold};

/* ---- creation ---- */

static murk_status check_map(const murk_photon_map *map, const char *name,
                             uint64_t emitted, murk_error *err)
{
    const murk_photon *photon = murk_photon_map_photons(map);
    const size_t n = murk_photon_map_count(map);
    for (size_t i = 0; i < n; ++i) {
        const murk_photon *p = &photon[i];
        const murk_vec3 at = murk_photon_place(p);
        const double power_w = murk_photon_power_w(p);
        if (!(power_w >= 0 && isfinite(power_w)) || !murk_is_finite(at) ||
            murk_photon_band(p) >= MURK_BANDS_MAX ||
            murk_photon_emitted(p) >= emitted) {
            return murk_fail(err, MURK_BAD_FILE, name,
                             "record %zu: power %g W, band %d, photon %u of "
                             "%llu at [%g, %g, %g] m cannot be",
                             i, power_w, murk_photon_band(p),
                             murk_photon_emitted(p),
                             (unsigned long long)emitted, at.x, at.y, at.z);
        }
    }
    return MURK_OK;
}

static murk_status check(const murk_sight_desc *desc, murk_error *err)
{
    /* Sensor types. */
    for (size_t k = 0; k < desc->types; ++k) {
        const murk_sensor_type *type = &desc->type[k];
        if (!(type->range_m > 0) || !(type->least_range_m >= 0) ||
            !(type->least_range_m < type->range_m)) {
            return murk_fail(err, MURK_BAD_VALUE, "sensors.types",
                             "range_m is %g m, must be above 0 and above "
                             "least_range_m, %g m, which must be 0 or more",
                             type->range_m, type->least_range_m);
        }
        if (!(type->acceptance_rad >= 0 && type->acceptance_rad <= MURK_PI)) {
            return murk_fail(err, MURK_BAD_VALUE, "sensors.types",
                             "acceptance is %g rad, must be 0..pi",
                             type->acceptance_rad);
        }
    }
    /* Detection. */
    if (!(desc->threshold >= 0 && desc->threshold <= 1)) {
        return murk_fail(err, MURK_BAD_VALUE, "placement.threshold",
                         "%g, must be 0..1", desc->threshold);
    }
    const unsigned maximum =
        desc->combining == MURK_COMBINE_INDEPENDENT ? 1 : MURK_REDUNDANCY_MAX;
    if (desc->redundancy > maximum) {
        return murk_fail(err, MURK_BAD_VALUE, "placement.redundancy",
                         "%u, must be 1..%u", desc->redundancy, maximum);
    }
    /* Records: indices have 32 bits. */
    const double photons = (double)murk_photon_map_count(desc->surface_map) +
                           (double)murk_photon_map_count(desc->volume_map);
    if (!(photons <= UINT32_MAX)) {
        return murk_fail(err, MURK_RUN_FAILED, "",
                         "%.4g photons are stored, sensing counts to %u",
                         photons, UINT32_MAX);
    }
    const murk_status status =
        check_map(desc->surface_map, "surface map", desc->photons_emitted, err);
    return status ? status
                  : check_map(desc->volume_map, "volume map",
                              desc->photons_emitted, err);
}

static murk_status no_memory(murk_error *err)
{
    return murk_no_memory(err, "", "for a sight");
}

/* The largest number of photons that a query finds. Photons found through
 * several images are distinguished only after the query, so that twice the
 * space is needed in a periodic domain. */
static size_t found_max(const murk_sight *sight)
{
    return sight->photons * (sight->desc.domain.is_periodic ? 2 : 1);
}

static murk_status allocate(murk_sight *sight, murk_error *err)
{
    const murk_sight_desc *desc = &sight->desc;
    const size_t n = sight->photons;
    const bool attenuates = sight->has_media || sight->has_sheets ||
                            sight->interfaces || desc->power.radius_m > 0;
    const bool has_regions = desc->interest && desc->interest->n;
    sight->weight = malloc(n * sizeof *sight->weight + 1);
    sight->worker = calloc(desc->threads, sizeof *sight->worker);
    sight->regions =
        has_regions ? malloc(n * sizeof *sight->regions + 1) : NULL;
    bool has_memory =
        sight->weight && sight->worker && (sight->regions || !has_regions);
    for (unsigned i = 0; has_memory && i < desc->threads; ++i) {
        murk_scratch *s = &sight->worker[i];
        s->photon = malloc(found_max(sight) * sizeof *s->photon + 1);
        s->clarity = attenuates ? malloc(n * sizeof *s->clarity + 1) : NULL;
        has_memory = s->photon && (s->clarity || !attenuates);
    }
    return has_memory ? MURK_OK
                      : murk_no_memory(err, "",
                                       "to look at %zu photons with %u threads",
                                       n, desc->threads);
}

static void find_regions(murk_sight *sight)
{
    const murk_sight_desc *desc = &sight->desc;
    if (sight->regions) {
        murk_interest_members(sight->regions, desc->interest, desc->surface_map,
                              sight->position_error_m, desc->threads);
        murk_interest_members(sight->regions +
                                  murk_photon_map_count(desc->surface_map),
                              desc->interest, desc->volume_map,
                              sight->position_error_m, desc->threads);
    }
}

/* Copies the sensor types, and prepares the media of those that accept light
 * scattered forward. */
static murk_status prepare_types(murk_sight *sight, murk_error *err)
{
    murk_sight_desc *desc = &sight->desc;
    sight->accepting = calloc(desc->types + 1, sizeof *sight->accepting);
    sight->type = malloc(desc->types * sizeof *sight->type + 1);
    if (!sight->accepting || !sight->type) {
        return no_memory(err);
    }
    memcpy(sight->type, desc->type, desc->types * sizeof *sight->type);
    desc->type = sight->type;
    murk_status status = MURK_OK;
    for (size_t k = 0; k < desc->types && !status; ++k) {
        if (desc->type[k].acceptance_rad > 0) {
            status = murk_media_accepting(&sight->accepting[k], desc->media,
                                          desc->type[k].acceptance_rad, err);
        }
    }
    return status;
}

/* Finds the sheets, media and boundaries that sightlines may meet. */
static murk_status prepare_optics(murk_sight *sight, murk_error *err)
{
    const murk_sight_desc *desc = &sight->desc;
    const bool by_rays = desc->visibility == MURK_VISIBILITY_RAY;
    sight->has_media = murk_media_any(desc->media);
    sight->has_sheets = desc->through_sheets && by_rays &&
                        murk_surfaces_describe(desc->surfaces).sheets > 0;
    sight->has_interfaces = murk_media_bends(desc->media);
    if (desc->refracts && sight->has_interfaces && by_rays) {
        sight->interfaces = malloc(sizeof *sight->interfaces);
        if (!sight->interfaces) {
            return no_memory(err);
        }
        const murk_path_space space = murk_path_space_of(
            desc->surfaces, desc->media, desc->boundary_meshes, &desc->domain);
        murk_interfaces_find(sight->interfaces, &space);
    }
    return MURK_OK;
}

murk_status murk_sight_create(murk_sight **out, const murk_sight_desc *desc,
                              murk_error *err)
{
    assert(out && desc && desc->threads >= 1);
    const murk_box *box = &desc->domain.box;
    murk_sight *sight = calloc(1, sizeof *sight);
    if (!sight) {
        return no_memory(err);
    }
    sight->desc = *desc;
    sight->detect = DETECT[desc->detection];
    if (murk_length(desc->north) == 0) {
        sight->desc.north = murk_vec(0, 1, 0);
    }
    /* longer than the distance of any point of the domain from any image of the
     * sensor; not infinite, so that the square is finite */
    sight->max_m = 2 * murk_length(murk_sub(box->max, box->min));
    sight->position_error_m = POSITION_ERROR * murk_box_largest_coordinate(box);
    sight->photons = murk_photon_map_count(desc->surface_map) +
                     murk_photon_map_count(desc->volume_map);
    /* Check, then prepare one part after the other. */
    murk_status status = check(desc, err);
    if (!status) {
        status = prepare_types(sight, err);
    }
    if (!status) {
        status = prepare_optics(sight, err);
    }
    if (!status) {
        status = allocate(sight, err);
    }
    if (!status) {
        find_regions(sight);
        status = murk_photon_weights(
            sight->weight, desc->surface_map, desc->volume_map, &desc->weights,
            desc->interest, sight->regions, murk_sight_layers_max(desc),
            desc->where ? desc->where : "", err);
    }
    if (!status && desc->power.radius_m > 0) {
        status = murk_power_create(&sight->power, &sight->desc, err);
    }
    if (status) {
        murk_sight_destroy(sight);
        return status;
    }
    *out = sight;
    return MURK_OK;
}

void murk_sight_destroy(murk_sight *sight)
{
    if (!sight) {
        return;
    }
    murk_power_destroy(sight->power);
    free(sight->interfaces);
    free(sight->regions);
    free(sight->weight);
    for (unsigned i = 0; sight->worker && i < sight->desc.threads; ++i) {
        free(sight->worker[i].photon);
        free(sight->worker[i].clarity);
    }
    free(sight->worker);
    for (size_t k = 0; sight->accepting && k < sight->desc.types; ++k) {
        murk_media_destroy(sight->accepting[k]);
    }
    free(sight->accepting);
    murk_photon_map_destroy(sight->own_surface);
    murk_photon_map_destroy(sight->own_volume);
    free(sight->type);
    free(sight);
}

void murk_sight_rest(murk_sight *sight)
{
    const size_t n = sight->photons;
    for (unsigned i = 0; i < sight->desc.threads; ++i) {
        const murk_scratch *s = &sight->worker[i];
        murk_machine_drop(s->photon, found_max(sight) * sizeof *s->photon);
        murk_machine_drop(s->clarity, s->clarity ? n * sizeof *s->clarity : 0);
    }
}

void murk_sight_own_maps(murk_sight *sight, murk_photon_map *surface,
                         murk_photon_map *volume)
{
    assert(surface == sight->desc.surface_map &&
           volume == sight->desc.volume_map);
    sight->own_surface = surface;
    sight->own_volume = volume;
}

/* ---- the placement problem ---- */

static void get_row(void *context, unsigned worker, size_t candidate,
                    murk_sparse_row *out)
{
    const murk_sight_problem *p = context;
    const murk_pose *pose = &p->pose[candidate];
    if (pose->type == MURK_POSE_OF_NONE) {
        *out = (murk_sparse_row){0};
        return;
    }
    if (!p->known ||
        !p->known->get(p->known->context, worker, candidate, out)) {
        murk_sight_row(p->sight, worker, pose, out);
    }
    if (p->tested) {
        p->tested[candidate] = murk_sight_counts(p->sight, worker);
    }
}

/* A murk_row_patches.get. */
static bool get_patch(void *context, unsigned worker, size_t candidate,
                      murk_row_patch *patch)
{
    const murk_sight_problem *p = context;
    const bool is_known =
        p->pose[candidate].type != MURK_POSE_OF_NONE &&
        p->known->patches.get(p->known->context, worker, candidate, patch);
    if (is_known && p->tested) {
        p->tested[candidate] = murk_sight_counts(p->sight, worker);
    }
    return is_known;
}

/* A murk_problem.get_differences. */
static void get_differences(void *context, unsigned worker,
                            murk_sparse_row *gone, murk_sparse_row *come)
{
    const murk_sight_problem *p = context;
    p->known->get_differences(p->known->context, worker, gone, come);
}

static bool get_part(void *context, unsigned worker, size_t candidate,
                     const murk_row_need *need, murk_sparse_row *out)
{
    const murk_sight_problem *p = context;
    const murk_pose *pose = &p->pose[candidate];
    if (pose->type == MURK_POSE_OF_NONE) {
        *out = (murk_sparse_row){0};
        return need->gain_min == 0;
    }
    return murk_sight_part(p->sight, worker, pose, need, out);
}

static void rest(void *context)
{
    const murk_sight_problem *p = context;
    murk_sight_rest(p->sight);
}

static void list_counters(void *context, murk_counters *list)
{
    const murk_sight_problem *p = context;
    murk_sight *sight = p->sight;
    murk_tally *const counter[MURK_SIGHT_COUNTERS] = {
        &sight->queries, &sight->shadow_rays, &sight->blocked_by_interfaces,
        &sight->totally_reflected, &sight->reused};
    for (size_t i = 0; i < MURK_SIGHT_COUNTERS; ++i) {
        list->counter[list->n++] = counter[i];
    }
}

void murk_sight_problem_init(murk_sight_problem *out, murk_sight *sight,
                             const murk_pose *pose, size_t n)
{
    out->sight = sight;
    out->pose = pose;
    out->known = NULL;
    out->tested = NULL;
    out->problem = (murk_problem){.photons = sight->photons,
                                  .candidates = n,
                                  .weight = sight->weight,
                                  .get_row = get_row,
                                  .get_part = get_part,
                                  .get_differences = get_differences,
                                  .rest = rest,
                                  .list_counters = list_counters,
                                  .context = out,
                                  .threads = sight->desc.threads,
                                  .combining = sight->desc.combining,
                                  .redundancy = sight->desc.redundancy};
}

void murk_sight_problem_know(murk_sight_problem *problem,
                             const murk_known_rows *known)
{
    problem->known = known;
    problem->problem.earlier_hash = known ? known->earlier_hash : NULL;
    problem->problem.is_unmerged = known && known->is_unmerged;
    problem->problem.patches = (murk_row_patches){0};
    if (known && known->patches.matrix) {
        problem->problem.patches = known->patches;
        problem->problem.patches.get = get_patch;
    }
}

const uint32_t *murk_sight_weights(const murk_sight *sight)
{
    return sight->weight;
}

size_t murk_sight_photons(const murk_sight *sight)
{
    return sight->photons;
}

const murk_photon *murk_sight_photon(const murk_sight *sight, size_t i)
{
    const murk_sight_desc *desc = &sight->desc;
    const size_t surface = murk_photon_map_count(desc->surface_map);
    return i < surface
               ? murk_photon_map_photons(desc->surface_map) + i
               : murk_photon_map_photons(desc->volume_map) + (i - surface);
}

uint64_t murk_sight_regions(const murk_sight *sight, size_t i)
{
    return sight->regions ? sight->regions[i] : 0;
}

double murk_sight_power_w(const murk_sight *sight, size_t i)
{
    const murk_photon *photon = murk_sight_photon(sight, i);
    return sight->regions ? murk_photon_power_w(photon) *
                                murk_interest_factor(sight->desc.interest,
                                                     sight->regions[i])
                          : murk_photon_power_w(photon);
}

bool murk_sight_is_in_file(const murk_sight *sight)
{
    return murk_photon_map_is_in_file(sight->desc.surface_map) ||
           murk_photon_map_is_in_file(sight->desc.volume_map);
}

const murk_sight_desc *murk_sight_described(const murk_sight *sight)
{
    return &sight->desc;
}

size_t murk_sight_power_few(const murk_sight *sight)
{
    return sight->power ? murk_power_few(sight->power) : 0;
}

murk_sight_work murk_sight_work_of(const murk_sight *sight)
{
    return (murk_sight_work){
        .queries = (uint64_t)murk_tally_read(&sight->queries),
        .shadow_rays = (uint64_t)murk_tally_read(&sight->shadow_rays),
        .blocked_by_interfaces =
            (uint64_t)murk_tally_read(&sight->blocked_by_interfaces),
        .totally_reflected =
            (uint64_t)murk_tally_read(&sight->totally_reflected),
        .reused = (uint64_t)murk_tally_read(&sight->reused)};
}
