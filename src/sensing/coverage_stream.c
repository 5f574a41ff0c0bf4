/* Coverage by photons that are not stored. Records are collected to chunks, for
 * which photon maps, a sight and the rows of the sensors are computed as for
 * all photons at once; a row depends on the single photons alone. Of the
 * photons of a chunk the list keeps the power and the combined rows, in the
 * order of emitted photons, and of the records of one emitted photon first
 * those of the surface map, each in the order of the chunk's map. */
#include "sensing/coverage_stream.h"

#include "base/sort.h"
#include "sensing/covered_photons.h"
#include "sensing/sight_parts.h"
#include "sensing/weights.h"

#include <stdlib.h>
#include <string.h>

/* Records of a chunk, at least: enough that a chunk takes much longer than
 * starting the threads, and few beside the photons of a run that needs much
 * memory. A chunk consists of whole calls of murk_coverage_stream_add(), so it
 * does not depend on threads. */
#define CHUNK_RECORDS 65536

/* Records that wait for their chunk. */
typedef struct waiting {
    murk_photon *photon;
    size_t n, capacity;
} waiting;

struct murk_coverage_stream {
    murk_sight_desc desc;
    murk_sensor_type *type; /* [desc.types] */
    const murk_pose *pose;
    waiting map[2]; /* surface, volume */
    murk_covered_photons covered;
    murk_photon_list list;
    size_t capacity; /* of the list */
    /* Of the present chunk: the place of each photon in the list; the photons
     * of one row by these places. */
    uint32_t *place, *seen;
};

bool murk_coverage_can_stream(const murk_sight_desc *desc)
{
    return desc->combining == MURK_COMBINE_CLEAREST &&
           !(desc->power.radius_m > 0) &&
           !(desc->interest && desc->interest->n > 0);
}

/* Memory for so many photons, in blocks that need not move as photons come; the
 * machine gives a page when the page is first written. False when out of
 * memory. */
static bool reserve(murk_coverage_stream *s, size_t photons)
{
    s->list.power_w = malloc(photons * sizeof *s->list.power_w + 1);
    s->list.light = malloc(photons + 1);
    s->list.bits = malloc(photons + 1);
    s->capacity = photons;
    const bool has_memory = murk_covered_photons_init(&s->covered, photons);
    s->covered.combined.photons = 0;
    return has_memory && s->list.power_w && s->list.light && s->list.bits;
}

murk_status murk_coverage_stream_create(murk_coverage_stream **out,
                                        const murk_sight_desc *desc,
                                        const murk_pose *pose, size_t n,
                                        size_t expected, murk_error *err)
{
    const murk_status status = murk_coverage_check(desc, pose, n, err);
    if (status) {
        return status;
    }
    /* Copy the settings and the types, and reserve memory. */
    murk_coverage_stream *s = calloc(1, sizeof *s);
    if (s) {
        s->desc = *desc;
        s->pose = pose;
        s->type = malloc(desc->types * sizeof *s->type + 1);
        s->desc.type = s->type;
        s->covered = (murk_covered_photons){
            .desc = &s->desc, .list = &s->list, .sensors = n};
    }
    if (!s || !s->type || !reserve(s, expected)) {
        murk_coverage_stream_destroy(s);
        return murk_no_memory(err, "", "to measure %zu sensors", n);
    }
    memcpy(s->type, desc->type, desc->types * sizeof *s->type);
    *out = s;
    return MURK_OK;
}

void murk_coverage_stream_destroy(murk_coverage_stream *s)
{
    if (s) {
        murk_covered_photons_release(&s->covered);
        free(s->map[0].photon);
        free(s->map[1].photon);
        free(s->list.power_w);
        free(s->list.light);
        free(s->list.bits);
        free(s->place);
        free(s->seen);
        free(s->type);
        free(s);
    }
}

static murk_status no_memory(const murk_coverage_stream *s, murk_error *err)
{
    return murk_no_memory(err, "", "to measure %zu sensors over %zu photons",
                          s->covered.sensors, s->covered.photons);
}

/* ---- a chunk ---- */

/* Memory for n photons in the list. False when out of memory; the list then has
 * memory for s->capacity photons at least. */
static bool resize(murk_coverage_stream *s, size_t n)
{
    float *power_w = realloc(s->list.power_w, n * sizeof *power_w);
    if (!power_w) {
        return false;
    }
    s->list.power_w = power_w;
    uint8_t *light = realloc(s->list.light, n);
    if (!light) {
        return false;
    }
    s->list.light = light;
    uint8_t *bits = realloc(s->list.bits, n);
    if (!bits) {
        return false;
    }
    s->list.bits = bits;
    s->capacity = n;
    return true;
}

/* Adds places for n photons to the list and to the combined rows. False when
 * out of memory. */
static bool extend(murk_coverage_stream *s, size_t n)
{
    const size_t photons = s->covered.photons + n;
    if (photons > s->capacity) {
        const size_t half_more = s->capacity + s->capacity / 2;
        const size_t all = photons > half_more ? photons : half_more;
        if (!resize(s, all)) {
            return false;
        }
    }
    return photons <= UINT32_MAX &&
           murk_combined_rows_extend(&s->covered.combined, photons);
}

/* Appends the photons of a chunk to the list, by emitted photon, and notes the
 * place of each. False when out of memory. */
static bool append(murk_coverage_stream *s, const murk_sight *sight)
{
    const size_t n = sight->photons, first = s->covered.photons;
    uint64_t *key = malloc(n * sizeof *key);
    free(s->place);
    free(s->seen);
    s->place = malloc(n * sizeof *s->place);
    s->seen = malloc(n * sizeof *s->seen);
    if (!key || !s->place || !s->seen || !extend(s, n)) {
        free(key);
        return false;
    }
    /* Sort by emitted photon, then by number in the chunk. */
    for (size_t i = 0; i < n; ++i) {
        const uint64_t emitted =
            murk_photon_emitted(murk_sight_photon(sight, i));
        key[i] = emitted << 32 | i;
    }
    murk_sort_uint64(key, n);
    for (size_t k = 0; k < n; ++k) {
        const uint32_t i = (uint32_t)key[k];
        const murk_photon *photon = murk_sight_photon(sight, i);
        const bool is_first = k == 0 || key[k] >> 32 != key[k - 1] >> 32;
        s->place[i] = (uint32_t)(first + k);
        s->list.power_w[first + k] = (float)murk_photon_power_w(photon);
        s->list.light[first + k] = murk_photon_light(photon);
        s->list.bits[first + k] =
            (uint8_t)((murk_photon_is_volume(photon) ? MURK_LISTED_VOLUME : 0) |
                      (is_first ? MURK_LISTED_FIRST : 0) |
                      murk_photon_band(photon) * MURK_LISTED_BAND);
    }
    free(key);
    s->covered.photons += n;
    s->covered.surface_photons +=
        murk_photon_map_count(sight->desc.surface_map);
    return true;
}

/* A murk_row_sink. */
static void add_row(void *context, uint32_t sensor, const murk_sparse_row *row)
{
    murk_coverage_stream *s = context;
    for (size_t k = 0; k < row->seen; ++k) {
        s->seen[k] = s->place[row->photon[k]];
    }
    murk_combined_rows_add(
        &s->covered.combined, sensor,
        &(murk_sparse_row){row->seen, s->seen, row->clarity});
}

/* Passes the waiting records of a map to a photon map. */
static murk_status make_map(murk_photon_map **out, waiting *from,
                            unsigned threads, murk_error *err)
{
    const waiting all = *from;
    *from = (waiting){0};
    return murk_photon_map_create(out, all.photon, all.n, threads, err);
}

static murk_status test_chunk(murk_coverage_stream *s, murk_error *err)
{
    murk_photon_map *surface = NULL, *volume = NULL;
    murk_sight *sight = NULL;
    if (s->map[0].n + s->map[1].n == 0) {
        return MURK_OK;
    }
    murk_status status = make_map(&surface, &s->map[0], s->desc.threads, err);
    if (!status) {
        status = make_map(&volume, &s->map[1], s->desc.threads, err);
    }
    if (!status) {
        /* A sight for rows alone: the weights are those of the whole and come
         * at the end. */
        murk_sight_desc desc = s->desc;
        desc.surface_map = surface;
        desc.volume_map = volume;
        desc.photons_emitted = UINT64_C(1) << 32;
        desc.weights = (murk_map_weights){.balanced = true};
        status = murk_sight_create(&sight, &desc, err);
    }
    if (!status && !append(s, sight)) {
        status = no_memory(s, err);
    }
    if (!status) {
        status = murk_coverage_rows(sight, s->pose, s->covered.sensors, add_row,
                                    s, err);
    }
    murk_sight_destroy(sight);
    murk_photon_map_destroy(surface);
    murk_photon_map_destroy(volume);
    return status;
}

/* ---- all photons ---- */

static bool put(waiting *to, const murk_photon *photon, size_t n)
{
    if (to->n + n > to->capacity) {
        const size_t capacity = to->n + n > CHUNK_RECORDS + CHUNK_RECORDS / 4
                                    ? to->n + n
                                    : CHUNK_RECORDS + CHUNK_RECORDS / 4;
        murk_photon *grown = realloc(to->photon, capacity * sizeof *grown);
        if (!grown) {
            return false;
        }
        to->photon = grown;
        to->capacity = capacity;
    }
    if (n > 0) {
        memcpy(to->photon + to->n, photon, n * sizeof *photon);
    }
    to->n += n;
    return true;
}

murk_status murk_coverage_stream_add(murk_coverage_stream *s,
                                     const murk_photon *surface,
                                     size_t n_surface,
                                     const murk_photon *volume, size_t n_volume,
                                     murk_error *err)
{
    if (!put(&s->map[0], surface, n_surface) ||
        !put(&s->map[1], volume, n_volume)) {
        return no_memory(s, err);
    }
    return s->map[0].n + s->map[1].n >= CHUNK_RECORDS ? test_chunk(s, err)
                                                      : MURK_OK;
}

/* Turns shares of a packet into watts, with the rounding of
 * murk_photon_set_power_w(), and returns the weights of the photons, for
 * free(). */
static murk_status weigh(uint32_t **out, murk_coverage_stream *s,
                         const double *packet_w, int bands, murk_error *err)
{
    const murk_photon_list *list = &s->list;
    const size_t n = s->covered.photons;
    murk_power_sum power[2] = {{0}};
    /* Watts, and the sums of each map. */
    for (size_t i = 0; i < n; ++i) {
        if (packet_w) {
            const size_t band = list->bits[i] / MURK_LISTED_BAND;
            const double packet =
                packet_w[list->light[i] * (size_t)bands + band];
            list->power_w[i] = (float)((double)list->power_w[i] * packet);
        }
        murk_power_sum_add(&power[list->bits[i] & MURK_LISTED_VOLUME],
                           (double)list->power_w[i]);
    }
    /* Weights. */
    double factor[2];
    const murk_status status = murk_weight_factors(
        factor, power, &s->desc.weights, murk_sight_layers_max(&s->desc),
        s->desc.where ? s->desc.where : "", err);
    uint32_t *weight = malloc(n * sizeof *weight + 1);
    for (size_t i = 0; !status && weight && i < n; ++i) {
        weight[i] = murk_weight_of((double)list->power_w[i],
                                   factor[list->bits[i] & MURK_LISTED_VOLUME]);
    }
    *out = weight;
    return status ? status : weight ? MURK_OK : no_memory(s, err);
}

murk_status murk_coverage_stream_end(murk_coverage_result *out,
                                     murk_coverage_stream *s,
                                     const double *packet_w, int bands,
                                     uint64_t emitted, murk_error *err)
{
    murk_coverage_result coverage = {0};
    uint32_t *weight = NULL;
    /* The last chunk, then the weights of all photons. */
    murk_status status = test_chunk(s, err);
    if (!status) {
        status = weigh(&weight, s, packet_w, bands, err);
    }
    if (!status &&
        !murk_coverage_result_create(&coverage, s->covered.sensors, 0)) {
        status = no_memory(s, err);
    }
    /* The sums. */
    if (!status) {
        s->desc.photons_emitted = emitted;
        s->covered.weight = weight;
        murk_combined_rows_only(&s->covered.combined, weight, s->covered.only);
        status = murk_covered_photons_sum_up(&coverage, &s->covered, err);
    }
    if (status) {
        murk_coverage_result_release(&coverage);
    } else {
        *out = coverage;
    }
    free(weight);
    return status;
}
