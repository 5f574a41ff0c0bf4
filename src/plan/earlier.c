/* Finds what two plans have in common: photons by their records, candidates by
 * their poses, and the places at which their worlds differ. */
#include "plan/earlier.h"

#include "base/ranks.h"
#include "base/sort.h"
#include "geometry/changed_surfaces.h"
#include "medium/interfaces.h"
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
    bool are_targets; /* the numbers of targets depend on those that were
                       * rejected, and tell nothing */
    uint64_t *order;  /* [n] by emitted index: emitted << 32 | number */
} photon_list;

static const murk_photon *photon_of(const photon_list *list, uint32_t number)
{
    return number < list->first_volume
               ? &list->surface[number]
               : &list->volume[number - list->first_volume];
}

/* False when out of memory. */
static bool list_photons(photon_list *out, const murk_photon_map *surface,
                         const murk_photon_map *volume, bool are_targets)
{
    *out = (photon_list){.surface = murk_photon_map_photons(surface),
                         .volume = murk_photon_map_photons(volume),
                         .first_volume = murk_photon_map_count(surface),
                         .are_targets = are_targets};
    out->n = out->first_volume + murk_photon_map_count(volume);
    out->order = malloc(out->n * sizeof *out->order + 1);
    for (size_t i = 0; out->order && i < out->n; ++i) {
        const murk_photon *p = photon_of(out, (uint32_t)i);
        const uint64_t emitted = are_targets ? 0 : murk_photon_emitted(p);
        out->order[i] = emitted << 32 | i;
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

/* Copies a run, sorted by the parts of the records that clarities depend on. */
static void sort_run(numbered *out, const photon_list *list, size_t begin,
                     size_t end)
{
    for (size_t i = begin; i < end; ++i) {
        const uint32_t number = (uint32_t)list->order[i];
        numbered *to = &out[i - begin];
        *to = (numbered){*photon_of(list, number), number};
        murk_photon_set_power_w(&to->photon, 0);
        if (list->are_targets) {
            murk_photon_set_emitted(&to->photon, 0);
        }
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

/* Pairs equal records of two sorted runs. */
static void pair_runs(murk_earlier_rows *rows, const runs *r, size_t n,
                      size_t m)
{
    size_t i = 0, k = 0;
    while (i < n && k < m) {
        const int order = compare_records(&r->earlier[i], &r->now[k]);
        if (order == 0) {
            rows->same[r->now[k].number] = r->earlier[i].number;
        }
        i += order <= 0;
        k += order >= 0;
    }
}

/* Fills rows->same. False when out of memory. */
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

/* The slot of a photon of the earlier light in its matrix. */
static size_t slot_of(const murk_earlier_rows *rows, uint32_t photon)
{
    return murk_matrix_slot(rows->matrix, (uint32_t)(rows->offset + photon));
}

/* Lists the new photons of each slot of the earlier matrix. False when out of
 * memory. */
static bool list_by_slot(murk_earlier_rows *rows, size_t photons)
{
    const size_t slots = murk_matrix_slots(rows->matrix);
    rows->first =
        murk_arena_array(&rows->arena, slots + 2, sizeof *rows->first);
    rows->photon =
        murk_arena_array(&rows->arena, photons, sizeof *rows->photon);
    if (rows->arena.is_short) {
        return false;
    }
    /* Count, sum up, and fill; first[s + 1] is the end of slot s while it is
     * filled. */
    for (size_t i = 0; i < photons; ++i) {
        if (rows->same[i] != MURK_NO_PHOTON) {
            ++rows->first[slot_of(rows, rows->same[i]) + 2];
        }
    }
    for (size_t s = 0; s < slots; ++s) {
        rows->first[s + 2] += rows->first[s + 1];
    }
    for (size_t i = 0; i < photons; ++i) {
        if (rows->same[i] != MURK_NO_PHOTON) {
            const size_t slot = slot_of(rows, rows->same[i]);
            rows->photon[rows->first[slot + 1]++] = (uint32_t)i;
        }
    }
    return true;
}

/* Lists the photons that came. False when out of memory. */
static bool list_added(murk_earlier_rows *rows, const photon_list *now)
{
    murk_sight_changes *c = &rows->changes;
    size_t n = 0;
    for (size_t i = 0; i < now->n; ++i) {
        n += rows->same[i] == MURK_NO_PHOTON;
    }
    uint32_t *added = murk_arena_array(&rows->arena, n, sizeof *added);
    murk_photon *record = murk_arena_array(&rows->arena, n, sizeof *record);
    uint64_t *bits =
        murk_arena_array(&rows->arena, now->n / 64 + 1, sizeof *bits);
    if (rows->arena.is_short) {
        return false;
    }
    /* Fill the lists. */
    n = 0;
    for (size_t i = 0; i < now->n; ++i) {
        if (rows->same[i] != MURK_NO_PHOTON) {
            continue;
        }
        const bool is_volume = i >= now->first_volume;
        added[n] = (uint32_t)(is_volume ? i - now->first_volume : i);
        record[n++] = *photon_of(now, (uint32_t)i);
        bits[i / 64] |= UINT64_C(1) << (i % 64);
        c->added_volume += is_volume;
        c->added_surface += !is_volume;
    }
    c->added = added;
    c->added_photon = record;
    c->is_added = bits;
    return true;
}

/* Lists the photons that are gone. False when out of memory. */
static bool list_gone(murk_earlier_rows *rows, const photon_list *earlier,
                      size_t photons)
{
    uint64_t *is_there =
        murk_arena_array(&rows->arena, earlier->n / 64 + 1, sizeof *is_there);
    size_t n = earlier->n;
    for (size_t i = 0; is_there && i < photons; ++i) {
        const uint32_t k = rows->same[i];
        if (k != MURK_NO_PHOTON) {
            is_there[k / 64] |= UINT64_C(1) << (k % 64);
            --n;
        }
    }
    murk_photon *record = murk_arena_array(&rows->arena, n, sizeof *record);
    if (rows->arena.is_short) {
        return false;
    }
    /* Copy the others. */
    n = 0;
    for (uint32_t i = 0; i < earlier->n; ++i) {
        if (!(is_there[i / 64] >> (i % 64) & 1)) {
            record[n++] = *photon_of(earlier, i);
        }
    }
    rows->changes.gone = record;
    rows->changes.gone_photons = n;
    return true;
}

/* With detection by power, photons whose light is estimated otherwise are not
 * the same. */
static void check_light(murk_earlier_rows *rows, const murk_sight *before)
{
    for (size_t i = 0; i < murk_sight_photons(rows->sight); ++i) {
        if (rows->same[i] != MURK_NO_PHOTON &&
            !murk_sight_has_same_light(rows->sight, i, before, rows->same[i])) {
            rows->same[i] = MURK_NO_PHOTON;
        }
    }
}

/* `seen`: the sight of the earlier plan, or NULL if it sees photons, whose
 * light does not count. */
static bool find_photons(murk_earlier_rows *rows, const murk_traced *traced,
                         const murk_sight *seen, bool are_targets)
{
    const murk_sight_desc *desc = murk_sight_described(rows->sight);
    const murk_photon_map *surface = traced->surface, *volume = traced->volume;
    photon_list before = {0}, now = {0};
    const size_t n = murk_sight_photons(rows->sight);
    if (seen) {
        surface = murk_sight_described(seen)->surface_map;
        volume = murk_sight_described(seen)->volume_map;
    }
    rows->same = murk_arena_array(&rows->arena, n, sizeof *rows->same);
    for (size_t i = 0; rows->same && i < n; ++i) {
        rows->same[i] = MURK_NO_PHOTON;
    }
    /* Match the photons, then list those that only one of both has. */
    bool has_memory =
        rows->same && list_photons(&before, surface, volume, are_targets) &&
        list_photons(&now, desc->surface_map, desc->volume_map, are_targets) &&
        match_photons(rows, &before, &now);
    if (has_memory && seen) {
        check_light(rows, seen);
    }
    has_memory = has_memory && list_by_slot(rows, n) &&
                 list_added(rows, &now) && list_gone(rows, &before, n);
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

/* Fills rows->candidate: each earlier pose is that of one candidate at most.
 * False when out of memory. */
static bool find_candidates(murk_earlier_rows *rows, const murk_poses *earlier,
                            const murk_poses *now)
{
    const size_t n = earlier->count;
    numbered_pose *sorted = malloc(n * sizeof *sorted + 1);
    bool *is_found = calloc(n + 1, sizeof *is_found);
    rows->candidate =
        murk_arena_array(&rows->arena, now->count, sizeof *rows->candidate);
    const bool has_memory = sorted && is_found && rows->candidate;
    for (size_t i = 0; has_memory && i < n; ++i) {
        sorted[i] = numbered_pose_of(earlier, i);
    }
    if (has_memory) {
        qsort(sorted, n, sizeof *sorted, compare_poses);
    }
    /* A second candidate at one pose has a row that is computed. */
    for (size_t i = 0; has_memory && i < now->count; ++i) {
        const numbered_pose pose = numbered_pose_of(now, i);
        const numbered_pose *found =
            bsearch(&pose, sorted, n, sizeof *sorted, compare_poses);
        const bool is_first = found && !is_found[found->number];
        rows->candidate[i] = is_first ? found->number : NO_CANDIDATE;
        if (found) {
            is_found[found->number] = true;
        }
    }
    free(is_found);
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
        at_least_of(a) != at_least_of(b) ||
        p->targets.given != q->targets.given ||
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

static bool is_by_power(const murk_scene_desc *scene)
{
    return murk_detection_is(scene->placement.detection,
                             MURK_DETECTION_BY_POWER);
}

/* True if light is scattered alike in both: with detection by power the phase
 * functions of all photons around a place count. */
static bool has_same_phases(const murk_stage *a, const murk_stage *b)
{
    const size_t n = murk_media_count(a->media);
    bool is_same = n == murk_media_count(b->media) &&
                   a->scene->bands == b->scene->bands &&
                   memcmp(a->scene->band_nm, b->scene->band_nm,
                          sizeof a->scene->band_nm) == 0;
    for (size_t i = 0; i < n && is_same; ++i) {
        for (int band = 0; band < a->scene->bands && is_same; ++band) {
            is_same = murk_phase_is_same(murk_media_phase(a->media, i, band),
                                         murk_media_phase(b->media, i, band));
        }
    }
    return is_same;
}

/* Finds the places at which sightlines may differ. If interfaces or meshes that
 * may be interfaces differ, all places have changed: the number of sightlines
 * that a row loses to interfaces does not tell which they were. */
static murk_status find_places(murk_sight_changes *out, const murk_stage *a,
                               const murk_stage *b, murk_world_use what,
                               murk_error *err)
{
    murk_box_list meshes = {0};
    murk_status status = murk_changed_world(&out->changed, a, b, what, err);
    out->surfaces = a->surfaces;
    if (!status && murk_media_bends(b->media)) {
        status = murk_changed_boundary_meshes(&meshes, a->boundary_meshes,
                                              b->boundary_meshes, err);
        out->changed.are_all =
            out->changed.are_all || meshes.are_all || meshes.n > 0;
    }
    return status;
}

/* ---- rows ---- */

static bool has_bit(const uint64_t *bits, uint32_t i)
{
    return bits[i / 64] >> (i % 64) & 1;
}

static void set_entry(murk_earlier_scratch *s, uint32_t photon,
                      uint16_t clarity)
{
    s->dense[photon] = clarity;
    s->seen[photon / 64] |= UINT64_C(1) << (photon % 64);
}

/* Spreads the entries of the earlier row that are taken over, and lists the
 * others of photons that are still there. */
static void take_over(const murk_earlier_rows *rows, murk_earlier_scratch *s,
                      size_t n)
{
    s->gone = (murk_sparse_row){0, s->gone_photon, s->gone_clarity};
    for (size_t k = 0; k < n; ++k) {
        const uint32_t slot = s->slot[k];
        for (uint32_t i = rows->first[slot]; i < rows->first[slot + 1]; ++i) {
            const uint32_t photon = rows->photon[i];
            if (has_bit(s->again, photon)) {
                s->gone_photon[s->gone.seen] = photon;
                s->gone_clarity[s->gone.seen++] = s->slot_clarity[k];
            } else {
                set_entry(s, photon, s->slot_clarity[k]);
            }
        }
    }
}

/* Lists the entries that were spread, by rising number, and clears the bits. */
static void list_row(murk_earlier_scratch *s, size_t words,
                     murk_sparse_row *out)
{
    size_t n = 0;
    bool are_clear = true;
    for (size_t w = 0; w < words; ++w) {
        for (uint64_t bits = s->seen[w]; bits; bits &= bits - 1) {
            const size_t i = 64 * w + (size_t)__builtin_ctzll(bits);
            s->photon[n] = (uint32_t)i;
            s->clarity[n++] = s->dense[i];
            are_clear = are_clear && s->dense[i] == MURK_CLEAR;
        }
    }
    memset(s->seen, 0, words * sizeof *s->seen);
    *out = (murk_sparse_row){n, s->photon, are_clear ? NULL : s->clarity};
}

/* Tests the sightlines of a candidate that may differ from those of its earlier
 * row. */
static void test_again(const murk_earlier_rows *rows, unsigned worker,
                       size_t candidate)
{
    murk_earlier_scratch *s = &rows->scratch[worker];
    const size_t words = murk_sight_photons(rows->sight) / 64 + 1;
    memset(s->again, 0, words * sizeof *s->again);
    murk_sight_row_again(
        rows->sight, worker, &rows->poses->pose[candidate], &rows->changes,
        &rows->tested[rows->candidate[candidate]], s->again, &s->come);
}

/* A murk_row_patches.get. */
static bool get_patch(void *context, unsigned worker, size_t candidate,
                      murk_row_patch *patch)
{
    const murk_earlier_rows *rows = context;
    const murk_earlier_scratch *s = &rows->scratch[worker];
    const uint32_t before = rows->candidate[candidate];
    if (before == NO_CANDIDATE ||
        rows->tested[before].tested == MURK_NOT_TESTED) {
        return false;
    }
    test_again(rows, worker, candidate);
    *patch = (murk_row_patch){before, s->again, s->come, rows->frees_rows};
    return true;
}

/* A murk_known_rows.get: what was tested again in place of the entries of the
 * earlier row. */
static bool get_known(void *context, unsigned worker, size_t candidate,
                      murk_sparse_row *row)
{
    const murk_earlier_rows *rows = context;
    murk_earlier_scratch *s = &rows->scratch[worker];
    const uint32_t before = rows->candidate[candidate];
    const size_t words = murk_sight_photons(rows->sight) / 64 + 1;
    size_t n;
    if (before == NO_CANDIDATE ||
        rows->tested[before].tested == MURK_NOT_TESTED ||
        !murk_matrix_list(s->slot, s->slot_clarity, &n, rows->matrix, before)) {
        return false;
    }
    if (rows->frees_rows) {
        murk_matrix_drop(rows->matrix, before);
    }
    /* Test what may differ, and take the rest over. */
    test_again(rows, worker, candidate);
    take_over(rows, s, n);
    for (size_t k = 0; k < s->come.seen; ++k) {
        set_entry(s, s->come.photon[k],
                  s->come.clarity ? s->come.clarity[k] : MURK_CLEAR);
    }
    list_row(s, words, row);
    return true;
}

/* A murk_known_rows.get_differences. */
static void get_differences(void *context, unsigned worker,
                            murk_sparse_row *gone, murk_sparse_row *come)
{
    const murk_earlier_rows *rows = context;
    *gone = rows->scratch[worker].gone;
    *come = rows->scratch[worker].come;
}

static void allocate_scratch(murk_earlier_rows *rows, size_t photons)
{
    const size_t slots = murk_matrix_slots(rows->matrix),
                 words = photons / 64 + 1;
    murk_arena *a = &rows->arena;
    rows->scratch = murk_arena_array(a, rows->threads, sizeof *rows->scratch);
    for (unsigned i = 0; i < rows->threads && rows->scratch; ++i) {
        murk_earlier_scratch *s = &rows->scratch[i];
        s->slot = murk_arena_array(a, slots, sizeof *s->slot);
        s->slot_clarity = murk_arena_array(a, slots, sizeof *s->slot_clarity);
        s->dense = murk_arena_array(a, photons, sizeof *s->dense);
        s->seen = murk_arena_array(a, words, sizeof *s->seen);
        s->again = murk_arena_array(a, words, sizeof *s->again);
        s->photon = murk_arena_array(a, photons, sizeof *s->photon);
        s->clarity = murk_arena_array(a, photons, sizeof *s->clarity);
        s->gone_photon = murk_arena_array(a, photons, sizeof *s->gone_photon);
        s->gone_clarity = murk_arena_array(a, photons, sizeof *s->gone_clarity);
    }
}

/* The hashes of the columns of the new photons in the earlier matrix, if the
 * candidates are the same and have the same numbers. */
static void take_hashes(murk_earlier_rows *rows, size_t photons,
                        size_t earlier_candidates)
{
    const _Atomic uint64_t *hash = murk_matrix_hashes(rows->matrix);
    bool are_same = hash && murk_ranks_count() == 1 &&
                    earlier_candidates == rows->poses->count;
    for (size_t i = 0; i < rows->poses->count && are_same; ++i) {
        are_same = rows->candidate[i] == i &&
                   rows->tested[i].tested != MURK_NOT_TESTED;
    }
    if (!are_same) {
        return;
    }
    rows->hash = murk_arena_array(&rows->arena, photons, sizeof *rows->hash);
    for (size_t i = 0; rows->hash && i < photons; ++i) {
        const uint32_t k = rows->same[i];
        rows->hash[i] =
            k == MURK_NO_PHOTON ? 0 : atomic_load(&hash[rows->offset + k]);
    }
}

murk_status murk_earlier_rows_create(murk_earlier_rows *out,
                                     const murk_earlier_plan *earlier,
                                     const murk_poses *poses,
                                     const murk_stage *stage, murk_sight *sight,
                                     murk_earlier_see *see, murk_error *err)
{
    murk_earlier_rows rows = {.sight = sight, .poses = poses};
    murk_sight *before = NULL;
    const bool by_power = is_by_power(stage->scene),
               are_targets = stage->scene->placement.targets.given;
    *out = (murk_earlier_rows){0};
    if (!earlier || !*earlier->matrix || poses->count < CANDIDATES_MIN ||
        !has_same_settings(earlier->stage->scene, stage->scene) ||
        (by_power && !has_same_phases(earlier->stage, stage))) {
        return MURK_OK;
    }
    /* The places that have changed, then the photons and candidates that have
     * not. */
    const size_t photons = murk_sight_photons(sight);
    rows.matrix = *earlier->matrix;
    rows.tested = earlier->tested;
    rows.threads = murk_sight_described(sight)->threads;
    rows.offset = earlier->first;
    const murk_world_use what = accepts_scattered(stage->scene)
                                    ? MURK_USE_ACCEPTING_SIGHT
                                    : MURK_USE_SIGHT;
    murk_status status =
        find_places(&rows.changes, earlier->stage, stage, what, err);
    if (!status && !rows.changes.changed.are_all && (by_power || are_targets)) {
        status =
            see(&before, earlier->stage, earlier->traced, rows.threads, err);
    }
    if (status || rows.changes.changed.are_all) {
        return status == MURK_NO_MEMORY ? MURK_OK : status;
    }
    const bool has_memory =
        find_photons(&rows, earlier->traced, before, are_targets) &&
        find_candidates(&rows, earlier->poses, poses);
    murk_sight_destroy(before);
    if (has_memory) {
        allocate_scratch(&rows, photons);
        take_hashes(&rows, photons, earlier->poses->count);
    }
    if (!has_memory || rows.arena.is_short) {
        murk_arena_release(&rows.arena);
        return MURK_OK;
    }
    const murk_sight_changes *c = &rows.changes;
    const bool is_patched = murk_matrix_can_be_patched(
        rows.matrix, photons, c->added_surface + c->added_volume,
        c->gone_photons);
    *out = rows;
    out->known = (murk_known_rows){
        .get = get_known,
        .context = out,
        .is_unmerged = !murk_matrix_hashes(rows.matrix),
        .earlier_hash = rows.hash,
        .get_differences = get_differences,
        .patches = {is_patched ? rows.matrix : NULL, rows.same, get_patch}};
    return MURK_OK;
}

void murk_earlier_rows_release(murk_earlier_rows *rows)
{
    murk_arena_release(&rows->arena);
    *rows = (murk_earlier_rows){0};
}
