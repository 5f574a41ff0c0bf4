/* Finds what two plans have in common: photons by their records, candidates by
 * their poses, and the places at which their worlds differ. */
#include "plan/earlier.h"

#include "base/sort.h"
#include "world/changed_world.h"

#include <stdlib.h>
#include <string.h>

#define NO_CANDIDATE UINT32_MAX

/* With fewer candidates it takes longer to find the photons that are the same
 * than to test all sightlines (a choice). */
#define CANDIDATES_MIN 16

/* ---- equal photons ---- */

/* The photons of two maps, numbered as those of a sight: surface first. */
typedef struct photon_list {
    const murk_photon *surface, *volume;
    size_t first_volume, n;
    uint64_t *order; /* [n] by emitted index: emitted << 32 | number */
} photon_list;

static const murk_photon *photon_of(const photon_list *list, uint32_t number)
{
    return number < list->first_volume
               ? &list->surface[number]
               : &list->volume[number - list->first_volume];
}

/* False when out of memory. */
static bool list_photons(photon_list *out, const murk_photon_map *surface,
                         const murk_photon_map *volume)
{
    *out = (photon_list){.surface = murk_photon_map_photons(surface),
                         .volume = murk_photon_map_photons(volume),
                         .first_volume = murk_photon_map_count(surface)};
    out->n = out->first_volume + murk_photon_map_count(volume);
    out->order = malloc(out->n * sizeof *out->order + 1);
    for (size_t i = 0; out->order && i < out->n; ++i) {
        const murk_photon *p = photon_of(out, (uint32_t)i);
        out->order[i] = (uint64_t)murk_photon_emitted(p) << 32 | i;
    }
    if (out->order) {
        murk_sort_uint64(out->order, out->n);
    }
    return out->order;
}

/* The end of the run of photons from `begin` on that come from one emitted
 * photon. */
static size_t end_of_run(const photon_list *list, size_t begin)
{
    size_t end = begin;
    while (end < list->n &&
           list->order[end] >> 32 == list->order[begin] >> 32) {
        ++end;
    }
    return end;
}

/* A record with its number, for sorting. */
typedef struct numbered {
    murk_photon photon;
    uint32_t number;
} numbered;

static int compare_records(const void *a, const void *b)
{
    const numbered *p = a, *q = b;
    return memcmp(&p->photon, &q->photon, sizeof p->photon);
}

/* Copies a run, sorted by records. */
static void sort_run(numbered *out, const photon_list *list, size_t begin,
                     size_t end)
{
    for (size_t i = begin; i < end; ++i) {
        const uint32_t number = (uint32_t)list->order[i];
        out[i - begin] = (numbered){*photon_of(list, number), number};
    }
    if (end - begin > 1) {
        qsort(out, end - begin, sizeof *out, compare_records);
    }
}

/* Scratch for the runs of one emitted photon in both lists. */
typedef struct runs {
    numbered *earlier, *now;
    size_t size; /* of each */
} runs;

/* False when out of memory. */
static bool reserve(runs *r, size_t n)
{
    if (n <= r->size) {
        return true;
    }
    free(r->earlier);
    free(r->now);
    r->size = 2 * n;
    r->earlier = malloc(r->size * sizeof *r->earlier);
    r->now = malloc(r->size * sizeof *r->now);
    return r->earlier && r->now;
}

/* Pairs equal records of two sorted runs: the new photon gets the slot of the
 * earlier one. */
static void pair_runs(murk_earlier_rows *rows, const runs *r, size_t n,
                      size_t m)
{
    size_t i = 0, k = 0;
    while (i < n && k < m) {
        const int order = compare_records(&r->earlier[i], &r->now[k]);
        if (order == 0) {
            rows->column[r->now[k].number] =
                (uint32_t)murk_matrix_slot(rows->matrix, r->earlier[i].number);
        }
        i += order <= 0;
        k += order >= 0;
    }
}

/* Fills rows->column. False when out of memory. */
static bool match_photons(murk_earlier_rows *rows, const photon_list *earlier,
                          const photon_list *now)
{
    /* Both lists are in the order of emitted photons. */
    runs r = {0};
    bool has_memory = true;
    size_t i = 0, k = 0;
    while (i < earlier->n && k < now->n && has_memory) {
        const uint64_t p = earlier->order[i] >> 32, q = now->order[k] >> 32;
        const size_t i_end = p <= q ? end_of_run(earlier, i) : i,
                     k_end = q <= p ? end_of_run(now, k) : k;
        if (p == q) {
            const size_t n = i_end - i, m = k_end - k;
            has_memory = reserve(&r, n > m ? n : m);
            if (has_memory) {
                sort_run(r.earlier, earlier, i, i_end);
                sort_run(r.now, now, k, k_end);
                pair_runs(rows, &r, n, m);
            }
        }
        i = i_end;
        k = k_end;
    }
    free(r.earlier);
    free(r.now);
    return has_memory;
}

static bool find_photons(murk_earlier_rows *rows,
                         const murk_earlier_plan *earlier,
                         const murk_sight *sight)
{
    const murk_sight_desc *desc = murk_sight_described(sight);
    photon_list before = {0}, now = {0};
    const size_t n = murk_sight_photons(sight);
    rows->column = malloc(n * sizeof *rows->column + 1);
    for (size_t i = 0; rows->column && i < n; ++i) {
        rows->column[i] = MURK_NO_COLUMN;
    }
    const bool has_memory =
        rows->column &&
        list_photons(&before, earlier->traced->surface,
                     earlier->traced->volume) &&
        list_photons(&now, desc->surface_map, desc->volume_map) &&
        match_photons(rows, &before, &now);
    free(before.order);
    free(now.order);
    return has_memory;
}

/* ---- equal candidates ---- */

/* A pose with its number. Compared as bytes. */
typedef struct numbered_pose {
    double value[6]; /* type, position, heading, tilt */
    uint32_t number;
} numbered_pose;

static int compare_poses(const void *a, const void *b)
{
    const numbered_pose *p = a, *q = b;
    return memcmp(p->value, q->value, sizeof p->value);
}

static numbered_pose numbered_pose_of(const murk_poses *poses, size_t i)
{
    const murk_pose *p = &poses->pose[i];
    return (numbered_pose){{(double)p->type, p->position.x, p->position.y,
                            p->position.z, p->heading_rad, p->tilt_rad},
                           (uint32_t)i};
}

/* Fills rows->candidate. False when out of memory. */
static bool find_candidates(murk_earlier_rows *rows, const murk_poses *earlier,
                            const murk_poses *now)
{
    const size_t n = earlier->count;
    numbered_pose *sorted = malloc(n * sizeof *sorted + 1);
    rows->candidate = malloc(now->count * sizeof *rows->candidate + 1);
    const bool has_memory = sorted && rows->candidate;
    for (size_t i = 0; has_memory && i < n; ++i) {
        sorted[i] = numbered_pose_of(earlier, i);
    }
    if (has_memory) {
        qsort(sorted, n, sizeof *sorted, compare_poses);
    }
    for (size_t i = 0; has_memory && i < now->count; ++i) {
        const numbered_pose pose = numbered_pose_of(now, i);
        const numbered_pose *found =
            bsearch(&pose, sorted, n, sizeof *sorted, compare_poses);
        rows->candidate[i] = found ? found->number : NO_CANDIDATE;
    }
    free(sorted);
    return has_memory;
}

/* ---- what both have in common ---- */

/* Rows are binary if a photon counts for a target from some number of sensors
 * on; 0: there is no such number. */
static uint64_t at_least_of(const murk_scene_desc *scene)
{
    return scene->sensors.target > 0 ? scene->placement.at_least : 0;
}

/* True if the clarity of an unchanged sightline follows from the same settings
 * in both scenes. */
static bool has_same_settings(const murk_scene_desc *a,
                              const murk_scene_desc *b)
{
    const murk_scene_placement *p = &a->placement, *q = &b->placement;
    if (p->detection != q->detection || p->threshold != q->threshold ||
        p->by_normal != q->by_normal || p->through != q->through ||
        at_least_of(a) != at_least_of(b) || p->targets.given ||
        q->targets.given ||
        memcmp(&a->north, &b->north, sizeof a->north) != 0 ||
        memcmp(&a->origin, &b->origin, sizeof a->origin) != 0 ||
        a->sensors.types != b->sensors.types) {
        return false;
    }
    /* Unused bytes of the types may differ, and rows are then computed. */
    murk_sensor_type *types_a = murk_poses_types(a),
                     *types_b = murk_poses_types(b);
    const bool is_same =
        types_a && types_b &&
        memcmp(types_a, types_b, a->sensors.types * sizeof *types_a) == 0;
    free(types_a);
    free(types_b);
    return is_same;
}

/* True if some type accepts light that was scattered forward, so that phase
 * functions decide about its sightlines. */
static bool accepts_scattered(const murk_scene_desc *scene)
{
    bool accepts = false;
    for (size_t k = 0; k < scene->sensors.types; ++k) {
        accepts = accepts || scene->sensors.type[k].acceptance_rad > 0;
    }
    return accepts;
}

/* A murk_known_rows.get. */
static bool get_known(void *context, unsigned worker, size_t candidate,
                      murk_known_row *row)
{
    const murk_earlier_rows *rows = context;
    const uint32_t before = rows->candidate[candidate];
    *row =
        (murk_known_row){rows->column, rows->clarity[worker], &rows->changed};
    return before != NO_CANDIDATE &&
           murk_matrix_spread(rows->clarity[worker], rows->matrix, before);
}

/* False when out of memory. */
static bool allocate_scratch(murk_earlier_rows *rows, unsigned threads)
{
    const size_t slots = murk_matrix_slots(rows->matrix);
    rows->clarity = calloc(threads, sizeof *rows->clarity);
    bool has_memory = rows->clarity;
    for (; has_memory && rows->threads < threads; ++rows->threads) {
        uint16_t *made = malloc(slots * sizeof *made + 1);
        rows->clarity[rows->threads] = made;
        has_memory = made;
    }
    return has_memory;
}

murk_status murk_earlier_rows_create(murk_earlier_rows *out,
                                     const murk_earlier_plan *earlier,
                                     const murk_poses *poses,
                                     const murk_stage *stage,
                                     const murk_sight *sight, murk_error *err)
{
    murk_earlier_rows rows = {0};
    *out = rows;
    if (!earlier || !*earlier->matrix || !murk_sight_may_know(sight) ||
        poses->count < CANDIDATES_MIN ||
        !has_same_settings(earlier->stage->scene, stage->scene)) {
        return MURK_OK;
    }
    /* The places that have changed, then the photons and candidates that have
     * not. */
    rows.matrix = *earlier->matrix;
    const murk_world_use what = accepts_scattered(stage->scene)
                                    ? MURK_USE_ACCEPTING_SIGHT
                                    : MURK_USE_SIGHT;
    const murk_status status =
        murk_changed_world(&rows.changed, earlier->stage, stage, what, err);
    if (status || rows.changed.are_all) {
        return status;
    }
    if (!find_photons(&rows, earlier, sight) ||
        !find_candidates(&rows, earlier->poses, poses) ||
        !allocate_scratch(&rows, murk_sight_described(sight)->threads)) {
        murk_earlier_rows_release(&rows);
        return murk_no_memory(err, "", "for the rows of the step before");
    }
    *out = rows;
    out->known = (murk_known_rows){get_known, out};
    return MURK_OK;
}

void murk_earlier_rows_release(murk_earlier_rows *rows)
{
    for (unsigned i = 0; i < rows->threads; ++i) {
        free(rows->clarity[i]);
    }
    free(rows->clarity);
    free(rows->column);
    free(rows->candidate);
    *rows = (murk_earlier_rows){0};
}
