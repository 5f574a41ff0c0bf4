#include "sensing/sight.h"

#include "base/bands.h"
#include "medium/interfaces.h"
#include "sensing/nearby.h"
#include "sensing/passage.h"
#include "sensing/segment.h"
#include "sensing/weights.h"

#include <assert.h>
#include <stdlib.h>

/* Sightlines tested together: neighbours of one map that share the sensor. */
#define BLOCK 2048

/* How far a stored position may be off its surface, as a share of the domain's
 * largest coordinate: rounding of vertices and of storing it, with room. */
#define POSITION_ERROR 0x1p-20

typedef struct scratch {
    uint32_t *photon;  /* numbers of photons */
    uint16_t *clarity; /* NULL where all is clear */
} scratch;

struct murk_sight {
    murk_sight_desc desc;
    murk_sensor_type *type; /* [desc.types], their ranges finite */
    double position_error_m, hair_m;
    bool has_media;
    bool has_sheets;     /* that let light through */
    bool has_interfaces; /* where the index changes */
    uint32_t *weight;
    uint64_t *regions; /* of interest, [photons]; NULL: none */
    size_t photons;
    scratch *worker; /* [threads] */
    murk_tally queries, shadow_rays;
};

/* One look under way. */
typedef struct look {
    murk_sight *sight;
    murk_vec3 sensor;
    double range_m;
    murk_field field;
    bool is_picky;  /* something but the range limits the view */
    uint32_t bands; /* seen, by bits */
    murk_passages passages;
    uint32_t *photon;
    uint16_t *clarity;
    size_t seen;
    bool all_clear;
} look;

/* ---- creation ---- */

static murk_status check_map(const murk_photon_map *map, const char *name,
                             uint64_t emitted, murk_error *err)
{
    const murk_photon *photon = murk_photon_map_photons(map);
    const size_t n = murk_photon_map_count(map);
    for (size_t i = 0; i < n; ++i) {
        const murk_photon *p = &photon[i];
        const float *x = p->position_m;
        if (!(p->power_w >= 0 && isfinite(p->power_w)) || !isfinite(x[0]) ||
            !isfinite(x[1]) || !isfinite(x[2]) || p->band >= MURK_BANDS_MAX ||
            p->emitted >= emitted) {
            return murk_fail(err, MURK_BAD_FILE, name,
                             "record %zu: power %g W, band %d, photon %u of "
                             "%llu at [%g, %g, %g] m cannot be",
                             i, (double)p->power_w, p->band, p->emitted,
                             (unsigned long long)emitted, (double)x[0],
                             (double)x[1], (double)x[2]);
        }
    }
    return MURK_OK;
}

static murk_status check(const murk_sight_desc *desc, murk_error *err)
{
    for (size_t k = 0; k < desc->types; ++k) {
        const murk_sensor_type *type = &desc->type[k];
        if (!(type->range_m > 0) || !(type->least_range_m >= 0) ||
            !(type->least_range_m < type->range_m)) {
            return murk_fail(err, MURK_BAD_VALUE, "sensors.types",
                             "range_m is %g m, must be above 0 and above "
                             "least_range_m, %g m, which must be 0 or more",
                             type->range_m, type->least_range_m);
        }
    }
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

/* Photons found through several images are told apart only afterwards. */
static size_t scratch_photons(const murk_sight *sight)
{
    return sight->photons * (sight->desc.domain.is_periodic ? 2 : 1);
}

static murk_status set_aside(murk_sight *sight, murk_error *err)
{
    const size_t n = sight->photons, found = scratch_photons(sight);
    const unsigned threads = sight->desc.threads;
    const bool attenuates = sight->has_media || sight->has_sheets;
    sight->weight = malloc(n * sizeof *sight->weight + 1);
    sight->worker = calloc(threads, sizeof *sight->worker);
    const bool has_regions = sight->desc.interest && sight->desc.interest->n;
    sight->regions =
        has_regions ? malloc(n * sizeof *sight->regions + 1) : NULL;
    bool has_room =
        sight->weight && sight->worker && (sight->regions || !has_regions);
    for (unsigned i = 0; has_room && i < threads; ++i) {
        scratch *s = &sight->worker[i];
        s->photon = malloc(found * sizeof *s->photon + 1);
        s->clarity = attenuates ? malloc(n * sizeof *s->clarity + 1) : NULL;
        has_room = s->photon && (s->clarity || !attenuates);
    }
    return has_room ? MURK_OK
                    : murk_fail(err, MURK_NO_MEMORY, "",
                                "no memory to look at %zu photons with %u "
                                "threads",
                                n, threads);
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

murk_status murk_sight_create(murk_sight **out, const murk_sight_desc *desc,
                              murk_error *err)
{
    assert(out && desc && desc->threads >= 1);
    murk_sight *sight = NULL;
    murk_status status = check(desc, err);
    if (status) {
        goto done;
    }
    sight = calloc(1, sizeof *sight);
    if (!sight) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory for a sight");
        goto done;
    }
    const murk_box *box = &desc->domain.box;
    sight->desc = *desc;
    if (murk_length(desc->north) == 0) {
        sight->desc.north = murk_vec(0, 1, 0);
    }
    sight->type = malloc(desc->types * sizeof *sight->type + 1);
    if (!sight->type) {
        status = murk_fail(err, MURK_NO_MEMORY, "", "no memory for a sight");
        goto done;
    }
    /* Twice the diagonal holds every image, and its square is finite. */
    const double most_m = 2 * murk_length(murk_sub(box->max, box->min));
    for (size_t k = 0; k < desc->types; ++k) {
        sight->type[k] = desc->type[k];
        sight->type[k].range_m = fmin(desc->type[k].range_m, most_m);
    }
    sight->desc.type = sight->type;
    sight->position_error_m =
        POSITION_ERROR * murk_domain_extent(&desc->domain);
    sight->hair_m = murk_hair(desc->surfaces, &desc->domain);
    sight->has_media = murk_media_any(desc->media);
    sight->has_sheets = desc->through_sheets &&
                        desc->visibility == MURK_VISIBILITY_RAY &&
                        murk_surfaces_describe(desc->surfaces).sheets > 0;
    sight->has_interfaces = murk_media_bends(desc->media);
    sight->photons = murk_photon_map_count(desc->surface_map) +
                     murk_photon_map_count(desc->volume_map);
    status = set_aside(sight, err);
    if (status) {
        goto done;
    }
    find_regions(sight);
    const murk_photon_factors factors = {desc->interest, sight->regions};
    status = murk_photon_weights(sight->weight, desc->surface_map,
                                 desc->volume_map, &desc->weights, &factors,
                                 desc->where ? desc->where : "", err);
    if (status) {
        goto done;
    }
    *out = sight;
    sight = NULL;
done:
    murk_sight_destroy(sight);
    return status;
}

void murk_sight_destroy(murk_sight *sight)
{
    if (!sight) {
        return;
    }
    for (unsigned i = 0; sight->worker && i < sight->desc.threads; ++i) {
        free(sight->worker[i].photon);
        free(sight->worker[i].clarity);
    }
    free(sight->worker);
    free(sight->regions);
    free(sight->weight);
    free(sight->type);
    free(sight);
}

static murk_vec3 position_of(const murk_photon *photon)
{
    return murk_vec((double)photon->position_m[0],
                    (double)photon->position_m[1],
                    (double)photon->position_m[2]);
}

/* ---- culling ---- */

/* A normal unpacked. Built places have few, so those met last are kept. */
typedef struct side {
    uint32_t packed;
    murk_vec3 normal;
    murk_vec3 off; /* the step off the surface, the same wherever it lies */
    double tilt2;  /* squared sine of what storing may have turned it by */
} side;

static side side_of(const murk_surfaces *surfaces, uint32_t packed)
{
    const murk_vec3 n = murk_direction_unpack(packed), zero = {0, 0, 0};
    const bool is_along_axis = (n.x == 0) + (n.y == 0) + (n.z == 0) == 2;
    const double tilt = is_along_axis ? 0 : MURK_DIRECTION_ERROR_RAD;
    return (side){packed, n, murk_surfaces_leave(surfaces, zero, n),
                  tilt * tilt};
}

/* Where among SIDES a normal is kept: its hash's upper bits (Fibonacci). */
#define SIDES_LOG2 6
#define SIDES      (1 << SIDES_LOG2)

static const side *recall(side *sides, const murk_surfaces *surfaces,
                          uint32_t packed)
{
    side *s = &sides[(packed * UINT32_C(2654435769)) >> (32 - SIDES_LOG2)];
    if (s->packed != packed) {
        *s = side_of(surfaces, packed);
    }
    return s;
}

/* normal . (sensor - photon) > what storage may have moved it by. */
static bool faces(const side *s, murk_vec3 photon, murk_vec3 sensor,
                  double position_error_m)
{
    const murk_vec3 way = murk_sub(sensor, photon);
    const double above = murk_dot(s->normal, way) - position_error_m;
    return above > 0 && above * above > s->tilt2 * murk_dot(way, way);
}

/* ---- sightlines ---- */

static void test_surfaces(const look *l, const murk_vec3 *from, size_t n,
                          bool *blocked)
{
    const murk_sight_desc *desc = &l->sight->desc;
    if (desc->visibility == MURK_VISIBILITY_NORMAL) {
        for (size_t i = 0; i < n; ++i) {
            blocked[i] = false;
        }
        return;
    }
    murk_tally_add(&l->sight->shadow_rays, (int64_t)n);
    if (!desc->domain.is_periodic) {
        murk_surfaces_blocked_many(desc->surfaces, from, n, l->sensor,
                                   desc->through_sheets, blocked);
        return;
    }
    for (size_t i = 0; i < n; ++i) {
        const murk_vec3 to =
            murk_nearest_image(&desc->domain, l->sensor, from[i]);
        blocked[i] = murk_segment_blocked(desc->surfaces, &desc->domain,
                                          from[i], to, desc->through_sheets);
    }
}

static void test_sightlines(const look *l, const murk_vec3 *from, size_t n,
                            bool *blocked)
{
    test_surfaces(l, from, n, blocked);
    const murk_sight_desc *desc = &l->sight->desc;
    const bool may_bend =
        l->sight->has_interfaces && desc->visibility == MURK_VISIBILITY_RAY;
    for (size_t i = 0; may_bend && i < n; ++i) {
        blocked[i] = blocked[i] || murk_passage_bends(&l->passages, from[i]);
    }
}

/* Pieces overlap a periodic side by a hair, so a sheet there counts once. */
static double through_sheets(const look *l, murk_vec3 from, murk_vec3 to,
                             int band)
{
    const murk_sight_desc *desc = &l->sight->desc;
    murk_segment piece[MURK_SEGMENT_PIECES];
    const int n =
        murk_segment_cut(&desc->domain, from, to, l->sight->hair_m, piece);
    double through = 1;
    for (int i = 0; i < n; ++i) {
        through *= murk_surfaces_sheet_transmittance(
            desc->surfaces, piece[i].from, piece[i].to, band);
    }
    return through;
}

static uint16_t clarity_of(const look *l, murk_vec3 from, int band)
{
    const murk_sight *sight = l->sight;
    const murk_vec3 to =
        murk_nearest_image(&sight->desc.domain, l->sensor, from);
    double through = sight->has_sheets ? through_sheets(l, from, to, band) : 1;
    if (sight->has_media && through > 0) {
        through *= murk_passage_transmittance(&l->passages, band, from);
    }
    return (uint16_t)floor(through * MURK_CLEAR + 0.5);
}

/* Takes up n photons (numbers within their map, sightlines from `from`) in
 * place: what is written never passes what is read. */
static void keep_seen(look *l, const murk_photon *photon, uint32_t first,
                      const uint32_t *number, const murk_vec3 *from, size_t n)
{
    bool blocked[BLOCK];
    test_sightlines(l, from, n, blocked);
    for (size_t i = 0; i < n; ++i) {
        if (blocked[i]) {
            continue;
        }
        if (l->clarity) {
            const uint16_t clarity =
                clarity_of(l, from[i], photon[number[i]].band);
            if (clarity == 0) {
                continue;
            }
            l->clarity[l->seen] = clarity;
            l->all_clear = l->all_clear && clarity == MURK_CLEAR;
        }
        l->photon[l->seen++] = first + number[i];
    }
}

/* Whether the photon is such, and lies where, the sensor takes it up. `sensor`
 * is the sensor's image nearest to it. */
static bool is_taken(const look *l, const murk_photon *photon, murk_vec3 at,
                     murk_vec3 sensor)
{
    const murk_vec3 way = murk_sub(at, sensor);
    return (l->bands >> photon->band & 1) &&
           murk_field_contains(&l->field, way) &&
           (!l->field.toward ||
            murk_field_takes(&l->field, way,
                             murk_direction_unpack(photon->direction)));
}

static void look_at(look *l, const murk_photon_map *map, uint32_t first)
{
    const murk_sight_desc *desc = &l->sight->desc;
    const murk_photon *photon = murk_photon_map_photons(map);
    uint32_t *found = l->photon + l->seen;
    const size_t n =
        murk_photons_nearby(map, &desc->domain, l->sensor, l->range_m, found);
    const bool is_periodic = desc->domain.is_periodic;
    murk_vec3 from[BLOCK];
    uint32_t number[BLOCK];
    side sides[SIDES] = {{0}}; /* 0 is nothing's normal, and sees nothing */
    size_t filled = 0;
    for (size_t i = 0; i < n; ++i) {
        const murk_photon *p = &photon[found[i]];
        murk_vec3 at = position_of(p);
        const murk_vec3 sensor =
            is_periodic ? murk_nearest_image(&desc->domain, l->sensor, at)
                        : l->sensor;
        if (l->is_picky && !is_taken(l, p, at, sensor)) {
            continue;
        }
        if (!murk_photon_is_volume(p)) {
            const side *facing = recall(sides, desc->surfaces, p->normal);
            if (!faces(facing, at, sensor, l->sight->position_error_m)) {
                continue;
            }
            at = murk_add(at, facing->off);
        }
        from[filled] = at;
        number[filled++] = found[i];
        if (filled == BLOCK) {
            keep_seen(l, photon, first, number, from, filled);
            filled = 0;
        }
    }
    keep_seen(l, photon, first, number, from, filled);
}

void murk_sight_look(murk_sight *sight, unsigned worker, const murk_pose *pose,
                     murk_look *out)
{
    assert(worker < sight->desc.threads && pose->type < sight->desc.types);
    const murk_sight_desc *desc = &sight->desc;
    const murk_sensor_type *type = &sight->type[pose->type];
    const scratch *s = &sight->worker[worker];
    look l = {.sight = sight,
              .sensor = pose->position,
              .range_m = type->range_m,
              .field = murk_field_of(type, pose, desc->north),
              .is_picky = type->view != MURK_VIEW_SPHERE || type->bands ||
                          type->toward || type->least_range_m > 0,
              .bands = type->bands ? type->bands : UINT32_MAX,
              .passages = murk_passages_from(desc->media, desc->hulls,
                                             &desc->domain, pose->position),
              .photon = s->photon,
              .clarity = s->clarity,
              .all_clear = true};
    murk_tally_add(&sight->queries, 1);
    look_at(&l, desc->surface_map, 0);
    look_at(&l, desc->volume_map,
            (uint32_t)murk_photon_map_count(desc->surface_map));
    *out = (murk_look){l.seen, l.photon, l.all_clear ? NULL : l.clarity};
}

/* ---- the placement problem ---- */

static void look_from(void *context, unsigned worker, size_t candidate,
                      murk_look *out)
{
    const murk_sight_problem *p = context;
    murk_sight_look(p->sight, worker, &p->pose[candidate], out);
}

void murk_sight_problem_init(murk_sight_problem *out, murk_sight *sight,
                             const murk_pose *pose, size_t n)
{
    out->sight = sight;
    out->pose = pose;
    out->problem = (murk_problem){.photons = sight->photons,
                                  .candidates = n,
                                  .weight = sight->weight,
                                  .look = look_from,
                                  .context = out,
                                  .threads = sight->desc.threads};
}

const uint32_t *murk_sight_weights(const murk_sight *sight)
{
    return sight->weight;
}

size_t murk_sight_photons(const murk_sight *sight)
{
    return sight->photons;
}

uint64_t murk_sight_regions(const murk_sight *sight, size_t i)
{
    return sight->regions ? sight->regions[i] : 0;
}

double murk_sight_power_w(const murk_sight *sight, size_t i)
{
    const murk_sight_desc *desc = &sight->desc;
    const size_t surface = murk_photon_map_count(desc->surface_map);
    const murk_photon *photon =
        i < surface ? murk_photon_map_photons(desc->surface_map) + i
                    : murk_photon_map_photons(desc->volume_map) + (i - surface);
    return sight->regions
               ? (double)photon->power_w *
                     murk_interest_factor(desc->interest, sight->regions[i])
               : (double)photon->power_w;
}

const murk_sight_desc *murk_sight_described(const murk_sight *sight)
{
    return &sight->desc;
}

uint64_t murk_sight_queries(const murk_sight *sight)
{
    return (uint64_t)murk_tally_read(&sight->queries);
}

uint64_t murk_sight_shadow_rays(const murk_sight *sight)
{
    return (uint64_t)murk_tally_read(&sight->shadow_rays);
}
