/* The row of one sensor in the coverage matrix: queries both photon maps for
 * photons within range, tests field of view, band and normal, tests the
 * sightlines against surfaces in blocks, and computes the clarity. Sightlines
 * across an interface are found by sensing/across.h. murk_sight_row() writes to
 * the scratch buffers of the worker and to the counters of the sight only.
 * murk_sight_part() selects the needed photons of both maps first, and gives up
 * as soon as those that may still be visible add too little.
 * murk_sight_row_again() tests those sightlines alone that differ from those of
 * an earlier sight.
 * murk_sight_depths() computes the optical depths along sightlines with the
 * same routines, without rounding. */
#include "sensing/across.h"
#include "sensing/changed_lines.h"
#include "sensing/nearby.h"
#include "sensing/sight_parts.h"

#include <assert.h>

/* Sightlines tested together: neighbours in a map that end at one sensor.
 * Bigger blocks no longer gain; the arrays stay on the stack. */
#define BLOCK 2048

/* Sightlines of a part of a row that are tested before it is decided whether
 * the row is given up. Smaller blocks end earlier, and recognise fewer surfaces
 * that hide several photons (a choice). */
#define BLOCK_OF_PART 256

/* The state of the search for one row. */
typedef struct row_search {
    murk_sight *sight;
    murk_vec3 sensor;
    murk_path_space space;
    double range_m,
        query_m; /* range of the type, at most sight->max_m; radius of the
                    query, which is larger than range_m if objects beyond
                    interfaces may appear nearer than they are */
    const murk_sensor_type *type;
    murk_field field;
    bool has_filter; /* the type limits the direction, the bands or the smallest
                        distance */
    uint32_t bands;  /* one bit for each band detected */
    murk_path_viewpoint viewpoint; /* of the sensor, in `space` */
    murk_across across;            /* only with sight->interfaces */
    uint32_t *photon;
    uint16_t *clarity;
    size_t seen;            /* photons */
    murk_row_counts counts; /* sightlines */
    bool is_binary;
} row_search;

static void test_surfaces(const row_search *l, const murk_surfaces *surfaces,
                          const murk_vec3 *from, size_t n, bool *blocked)
{
    const murk_sight_desc *desc = &l->sight->desc;
    if (desc->visibility == MURK_VISIBILITY_NORMAL) {
        for (size_t i = 0; i < n; ++i) {
            blocked[i] = false;
        }
        return;
    }
    if (!desc->domain.is_periodic) {
        murk_surfaces_blocked_many(surfaces, from, n, l->sensor,
                                   desc->through_sheets, blocked);
        return;
    }
    for (size_t i = 0; i < n; ++i) {
        const murk_vec3 to =
            murk_path_nearest_image(&desc->domain, l->sensor, from[i]);
        blocked[i] = murk_path_blocked(surfaces, &desc->domain, from[i], to,
                                       desc->through_sheets);
    }
}

/* True if interfaces may end a straight sightline. */
static bool may_bend(const row_search *l)
{
    return l->sight->has_interfaces &&
           l->sight->desc.visibility == MURK_VISIBILITY_RAY;
}

static void test_sightlines(row_search *l, const murk_vec3 *from, size_t n,
                            bool *blocked)
{
    const bool bends = may_bend(l);
    l->counts.tested += (uint32_t)n;
    test_surfaces(l, l->sight->desc.surfaces, from, n, blocked);
    for (size_t i = 0; bends && i < n; ++i) {
        if (!blocked[i] && murk_path_bends_to(&l->viewpoint, from[i])) {
            blocked[i] = true;
            ++l->counts.bent;
        }
    }
}

/* The clarity of photon i of its map along these sightlines. Without detection
 * by power the largest transmittance counts; with power the signals add up. */
static uint16_t clarity_along(const row_search *l, const murk_photon *p,
                              size_t i, const murk_sightline *line,
                              size_t lines)
{
    const murk_sight *sight = l->sight;
    double through = 0, signal_w = 0;
    for (size_t k = 0; k < lines; ++k) {
        through = fmax(through, line[k].transmittance);
    }
    if (!sight->power || lines == 0) {
        return murk_sight_clarity(sight, through);
    }
    for (size_t k = 0; k < lines; ++k) {
        signal_w += murk_power_signal_w(sight->power, l->type, &l->field, p, i,
                                        &line[k]);
    }
    return murk_sight_clarity(
        sight,
        murk_power_chance(l->type, signal_w,
                          sight->desc.power.band_nm[murk_photon_band(p)]));
}

/* The clarity of photon i of its map along the straight line between `from`,
 * the end of the line at the photon, and the nearest image of the sensor.
 * Surfaces that block the line have been tested before. */
static uint16_t clarity_of(const row_search *l, const murk_photon *p, size_t i,
                           murk_vec3 from)
{
    const int band = murk_photon_band(p);
    const murk_sight *sight = l->sight;
    const murk_vec3 to =
        murk_path_nearest_image(&sight->desc.domain, l->sensor, from);
    double through = sight->has_sheets
                         ? murk_path_sheets(sight->desc.surfaces,
                                            &sight->desc.domain, from, to, band)
                         : 1;
    if (sight->has_media && through > 0) {
        through *= murk_path_transmittance_to(&l->viewpoint, band, from);
    }
    if (!sight->power) {
        return murk_sight_clarity(sight, through);
    }
    const murk_vec3 offset = murk_sub(from, to);
    const murk_sightline line = {.transmittance = through,
                                 .apparent = offset,
                                 .leaving = murk_scale(-1, murk_unit(offset)),
                                 .gain = 1};
    return clarity_along(l, p, i, &line, 1);
}

/* Adds a photon to the row. */
static void add_seen(row_search *l, uint32_t photon, uint16_t clarity)
{
    l->clarity[l->seen] = clarity;
    l->is_binary = l->is_binary && clarity == MURK_CLEAR;
    l->photon[l->seen++] = photon;
}

/* Adds those of n photons that are visible. number[n] are their indices in the
 * map, from[n] the photons' ends of the sightlines, and `first` is the number
 * of the map's first photon. The row is written over the indices that the query
 * has found; the write position never passes the read position. */
static void add_visible(row_search *l, const murk_photon *photon,
                        uint32_t first, const uint32_t *number,
                        const murk_vec3 *from, size_t n)
{
    bool blocked[BLOCK];
    test_sightlines(l, from, n, blocked);
    for (size_t i = 0; i < n; ++i) {
        if (blocked[i]) {
            continue;
        }
        if (!l->clarity) {
            l->photon[l->seen++] = first + number[i];
            continue;
        }
        const uint16_t clarity =
            clarity_of(l, &photon[number[i]], number[i], from[i]);
        if (clarity > 0) {
            add_seen(l, first + number[i], clarity);
        }
    }
}

/* True if the sensor can detect this photon: band, position and direction pass
 * the filters of the type. `sensor` is the image of the sensor nearest to the
 * photon. */
static bool is_detectable(const row_search *l, const murk_photon *photon,
                          murk_vec3 at, murk_vec3 sensor)
{
    const murk_vec3 offset = murk_sub(at, sensor);
    return (l->bands >> murk_photon_band(photon) & 1) &&
           murk_field_contains(&l->field, offset) &&
           (!l->field.toward ||
            murk_field_takes(&l->field, offset, murk_photon_direction(photon)));
}

/* True if the photon is farther from the sensor than range_m. The query finds
 * such photons because its radius, query_m, may be larger. */
static bool is_beyond(const row_search *l, murk_vec3 at, murk_vec3 sensor)
{
    const murk_vec3 offset = murk_sub(at, sensor);
    return !(murk_dot(offset, offset) <= l->range_m * l->range_m);
}

/* Adds a photon in a medium of another refractive index than that at the
 * sensor, if the photon is visible. `from` is the position of the photon, off
 * the surface. */
static void add_across(row_search *l, const murk_photon *p,
                       const murk_side *facing, murk_vec3 from, double index,
                       uint32_t first, uint32_t number)
{
    murk_sightline line[MURK_REFRACTED_PATHS_MAX];
    const size_t lines =
        l->bands >> murk_photon_band(p) & 1
            ? murk_across_sightlines(&l->across, p, facing, from, index, line)
            : 0;
    const uint16_t clarity = clarity_along(l, p, number, line, lines);
    if (clarity > 0) {
        add_seen(l, first + number, clarity);
    }
}

/* The end of the sightline to a photon, in *from; false if the filters of the
 * type reject the photon or the normal does not face the sensor. */
static inline __attribute__((always_inline)) bool
find_start(const row_search *l, const murk_photon *p, murk_vec3 sensor,
           murk_side sides[MURK_SIDES], murk_vec3 *from)
{
    const murk_vec3 at = murk_photon_place(p);
    *from = at;
    if (l->has_filter && !is_detectable(l, p, at, sensor)) {
        return false;
    }
    if (murk_photon_is_volume(p)) {
        return true;
    }
    const murk_side *facing = murk_side_recall(sides, l->sight->desc.surfaces,
                                               murk_photon_packed_normal(p));
    *from = murk_add(at, facing->off);
    return murk_side_faces(facing, at, sensor, l->sight->position_error_m);
}

/* The loop of search_map() for records of the surface map, if only the normal
 * decides whether a photon remains: the domain has no images, no sightline
 * bends, and the type has no filter. Written apart, with its constants in
 * registers, the loop takes half of the time. */
static void search_facing(row_search *l, const murk_photon *photon,
                          const uint32_t *found, size_t n)
{
    const murk_surfaces *surfaces = l->sight->desc.surfaces;
    const double position_error_m = l->sight->position_error_m;
    const murk_vec3 sensor = l->sensor;
    murk_vec3 from[BLOCK];
    uint32_t number[BLOCK];
    murk_side sides[MURK_SIDES] = {{0}};
    size_t filled = 0;
    for (size_t i = 0; i < n; ++i) {
        const murk_photon *p = &photon[found[i]];
        const murk_vec3 at = murk_photon_place(p);
        const murk_side *facing =
            murk_side_recall(sides, surfaces, murk_photon_packed_normal(p));
        /* The photon is written in any case, and counted if it remains. */
        number[filled] = found[i];
        from[filled] = murk_add(at, facing->off);
        filled += murk_side_faces(facing, at, sensor, position_error_m);
        if (filled == BLOCK) {
            add_visible(l, photon, 0, number, from, filled);
            filled = 0;
        }
    }
    add_visible(l, photon, 0, number, from, filled);
}

static void search_map(row_search *l, const murk_photon_map *map,
                       uint32_t first)
{
    const murk_sight_desc *desc = &l->sight->desc;
    const murk_photon *photon = murk_photon_map_photons(map);
    uint32_t *found = l->photon + l->seen;
    const size_t n =
        murk_photons_nearby(map, &desc->domain, l->sensor, l->query_m, found);
    const bool is_periodic = desc->domain.is_periodic;
    if (map == desc->surface_map && !is_periodic && !l->sight->interfaces &&
        !l->has_filter) {
        search_facing(l, photon, found, n);
        return;
    }
    murk_vec3 from[BLOCK];
    uint32_t number[BLOCK];
    murk_side sides[MURK_SIDES] = {{0}};
    size_t filled = 0;
    /* Filter the photons, and test those that remain in blocks. */
    for (size_t i = 0; i < n; ++i) {
        const murk_photon *p = &photon[found[i]];
        const murk_vec3 at = murk_photon_place(p);
        const murk_vec3 sensor =
            is_periodic ? murk_path_nearest_image(&desc->domain, l->sensor, at)
                        : l->sensor;
        /* A photon in a medium of another refractive index is tested alone,
         * after the photons collected before it, so that the row keeps the
         * order of the map. */
        if (l->sight->interfaces) {
            const murk_side *facing;
            const murk_vec3 start =
                murk_side_start(p, desc->surfaces, sides, &facing);
            const double index = murk_path_index_at(&l->space, start);
            if (index != l->viewpoint.index) {
                add_visible(l, photon, first, number, from, filled);
                filled = 0;
                add_across(l, p, facing, start, index, first, found[i]);
                continue;
            }
            if (is_beyond(l, at, sensor)) {
                continue;
            }
        }
        /* The photon is written in any case, and counted if it remains. */
        number[filled] = found[i];
        filled += find_start(l, p, sensor, sides, &from[filled]);
        if (filled == BLOCK) {
            add_visible(l, photon, first, number, from, filled);
            filled = 0;
        }
    }
    add_visible(l, photon, first, number, from, filled);
}

/* Begins the search for the row of a sensor; the caller sets the viewpoint. */
static row_search begin(murk_sight *sight, unsigned worker,
                        const murk_pose *pose)
{
    assert(worker < sight->desc.threads && pose->type < sight->desc.types);
    const murk_sight_desc *desc = &sight->desc;
    const murk_sensor_type *type = &sight->type[pose->type];
    const double range_m = fmin(type->range_m, sight->max_m);
    const murk_scratch *s = &sight->worker[worker];
    const murk_media *accepting = sight->accepting[pose->type];
    murk_tally_add(&sight->queries, 1);
    /* The row goes to the scratch buffers of the worker. */
    return (row_search){
        .sight = sight,
        .sensor = pose->position,
        .range_m = range_m,
        .query_m = range_m,
        .type = type,
        .field = murk_field_of(type, pose, desc->north),
        .has_filter = type->view != MURK_VIEW_SPHERE || type->bands ||
                      type->toward || type->least_range_m > 0,
        .bands = type->bands ? type->bands : UINT32_MAX,
        .space = murk_path_space_of(desc->surfaces,
                                    accepting ? accepting : desc->media,
                                    desc->boundary_meshes, &desc->domain),
        .photon = s->photon,
        .clarity = s->clarity,
        .is_binary = true};
}

/* The row that was found, with these sightlines, which the scratch buffer of
 * the worker notes and the counters add up. */
static murk_sparse_row found_row(const row_search *l, unsigned worker,
                                 const murk_row_counts *counts)
{
    murk_sight *sight = l->sight;
    sight->worker[worker].counts = *counts;
    if (sight->desc.visibility != MURK_VISIBILITY_NORMAL) {
        murk_tally_add(&sight->shadow_rays, counts->tested);
    }
    murk_tally_add(&sight->blocked_by_interfaces, counts->bent);
    murk_tally_add(&sight->totally_reflected, counts->reflected);
    return (murk_sparse_row){l->seen, l->photon,
                             l->is_binary ? NULL : l->clarity};
}

bool murk_sight_has_same_light(const murk_sight *a, size_t i,
                               const murk_sight *b, size_t k)
{
    if (!a->power || !b->power) {
        return a->power == b->power;
    }
    const size_t first_a = murk_photon_map_count(a->desc.surface_map),
                 first_b = murk_photon_map_count(b->desc.surface_map);
    const bool is_volume = i >= first_a;
    return is_volume == (k >= first_b) &&
           (is_volume ? murk_power_has_same_source(a->power, i - first_a,
                                                   b->power, k - first_b)
                      : murk_power_radiance(a->power, i) ==
                            murk_power_radiance(b->power, k));
}

murk_row_counts murk_sight_counts(const murk_sight *sight, unsigned worker)
{
    return sight->worker[worker].counts;
}

/* Prepares the search across interfaces; *l stays where it is. */
static void begin_across(row_search *l)
{
    murk_sight *sight = l->sight;
    /* At grazing angles objects may appear farther away than any real distance.
     * Their apparent distance is therefore limited by type->range_m, which may
     * be infinite, and only the real distance of a query is limited by
     * sight->max_m, which exceeds all of the domain. */
    if (sight->interfaces) {
        l->across = (murk_across){sight, &l->counts, &l->viewpoint, &l->field,
                                  l->type->range_m};
        l->query_m =
            fmin(sight->max_m,
                 murk_refracted_paths_range(sight->interfaces, &l->viewpoint,
                                            l->type->range_m));
    }
}

void murk_sight_row(murk_sight *sight, unsigned worker, const murk_pose *pose,
                    murk_sparse_row *out)
{
    const murk_sight_desc *desc = &sight->desc;
    row_search l = begin(sight, worker, pose);
    l.viewpoint = murk_path_viewpoint_at(&l.space, pose->position);
    begin_across(&l);
    /* Search both maps; volume photons are numbered after surface photons. */
    search_map(&l, desc->surface_map, 0);
    search_map(&l, desc->volume_map,
               (uint32_t)murk_photon_map_count(desc->surface_map));
    *out = found_row(&l, worker, &l.counts);
}

/* ---- rows that change ---- */

/* The part of a row that may differ from that of an earlier sight. */
typedef struct row_changes {
    const murk_sight_changes *of;
    murk_box_list near;
    murk_change_cone cone;   /* around `near` */
    uint64_t *tested;        /* a bit for each photon */
    murk_row_counts earlier; /* sightlines of the earlier row that are not taken
                              * over: of photons that are gone, and those that
                              * are tested again */
} row_changes;

/* The photons of a map that were added, within range. */
static size_t find_added(const row_search *l, const row_changes *c,
                         bool is_volume, uint32_t *found)
{
    const murk_sight_changes *of = c->of;
    const size_t first = is_volume ? of->added_surface : 0;
    const size_t n = murk_photons_listed_nearby(
        of->added_photon + first,
        is_volume ? of->added_volume : of->added_surface,
        &l->sight->desc.domain, l->sensor, l->query_m, found);
    for (size_t i = 0; i < n; ++i) {
        found[i] = of->added[first + found[i]];
    }
    return n;
}

/* The photons of a map within range, in the cone around the changed places,
 * that were there before. `first` is the number of the map's first photon. */
static size_t find_in_cone(const row_search *l, const row_changes *c,
                           const murk_photon_map *map, uint32_t first,
                           uint32_t *found)
{
    const murk_photon *photon = murk_photon_map_photons(map);
    const size_t n =
        murk_photon_map_within(map, c->cone.middle, c->cone.radius_m, found);
    size_t remaining = 0;
    for (size_t i = 0; i < n; ++i) {
        const uint32_t k = first + found[i];
        const murk_photon *p = &photon[found[i]];
        const bool is_added = c->of->is_added[k / 64] >> (k % 64) & 1;
        const murk_vec3 offset = murk_sub(murk_photon_place(p), l->sensor);
        /* Written in any case, and counted if it remains. */
        found[remaining] = found[i];
        remaining += !is_added & murk_change_cone_has(&c->cone, offset);
    }
    /* The test of the range has the bits of a query of the map. */
    return murk_photons_chosen_within(photon, found, remaining, l->sensor,
                                      l->query_m);
}

/* The photons of a map that may be a part of the change: those that were added,
 * and those to which a sightline may meet a changed place. */
static size_t find_changed(const row_search *l, const row_changes *c,
                           const murk_photon_map *map, bool is_volume,
                           uint32_t first, uint32_t *found)
{
    if (c->near.n == 0 && !c->near.are_all) {
        return find_added(l, c, is_volume, found);
    }
    if (!c->cone.is_there) {
        return murk_photons_nearby(map, &l->sight->desc.domain, l->sensor,
                                   l->query_m, found);
    }
    const size_t n = find_in_cone(l, c, map, first, found);
    return n + find_added(l, c, is_volume, found + n);
}

/* True if the straight sightline from `at` meets a changed place. */
static bool meets_change(const row_search *l, const row_changes *c,
                         murk_vec3 at)
{
    return l->sight->desc.domain.is_periodic
               ? murk_changes_meet_line(&c->near, &l->viewpoint, at)
               : murk_box_list_meet(&c->near, at, murk_sub(l->sensor, at));
}

/* The number of n straight sightlines that interfaces ended, with the surfaces
 * of the earlier sight. Interfaces are the same in both. */
static uint32_t count_bent(const row_search *l, const row_changes *c,
                           const murk_vec3 *from, size_t n)
{
    uint32_t count = 0;
    for (size_t i = 0; i < n; ++i) {
        if (murk_path_bends_to(&l->viewpoint, from[i])) {
            bool is_blocked;
            test_surfaces(l, c->of->surfaces, &from[i], 1, &is_blocked);
            count += !is_blocked;
        }
    }
    return count;
}

/* Straight sightlines that are tested together. */
typedef struct line_block {
    murk_vec3 from[BLOCK];  /* [n] */
    uint32_t number[BLOCK]; /* [n] photons, in their map */
    size_t n;
    murk_vec3 again[BLOCK]; /* [n_again] the starts of those that the earlier
                             * row had */
    size_t n_again;
} line_block;

static void test_changed(row_search *l, row_changes *c,
                         const murk_photon *photon, uint32_t first,
                         line_block *b)
{
    add_visible(l, photon, first, b->number, b->from, b->n);
    c->earlier.tested += (uint32_t)b->n_again;
    if (may_bend(l)) {
        c->earlier.bent += count_bent(l, c, b->again, b->n_again);
    }
    b->n = b->n_again = 0;
}

/* Tests the sightlines to a photon beyond an interface. Surfaces do not decide
 * about their number, so the earlier row had as many. */
static void test_changed_across(row_search *l, row_changes *c,
                                const murk_photon *p, const murk_side *facing,
                                murk_vec3 from, double index, bool is_added,
                                uint32_t first, uint32_t number)
{
    const murk_row_counts had = l->counts;
    add_across(l, p, facing, from, index, first, number);
    if (!is_added) {
        c->earlier.tested += l->counts.tested - had.tested;
        c->earlier.bent += l->counts.bent - had.bent;
        c->earlier.reflected += l->counts.reflected - had.reflected;
    }
}

/* Tests the sightlines to the photons of a map that may differ. `first` is the
 * number of the map's first photon. */
static void search_changed(row_search *l, row_changes *c,
                           const murk_photon_map *map, bool is_volume,
                           uint32_t first)
{
    const murk_sight_desc *desc = &l->sight->desc;
    const murk_interfaces *interfaces = l->sight->interfaces;
    const murk_photon *photon = murk_photon_map_photons(map);
    uint32_t *found = l->photon + l->seen;
    const size_t n = find_changed(l, c, map, is_volume, first, found);
    murk_side sides[MURK_SIDES] = {{0}};
    line_block block;
    block.n = block.n_again = 0;
    for (size_t i = 0; i < n; ++i) {
        const uint32_t number = found[i], k = first + number;
        const murk_photon *p = &photon[number];
        const bool is_added = c->of->is_added[k / 64] >> (k % 64) & 1;
        const murk_vec3 sensor = murk_path_nearest_image(
            &desc->domain, l->sensor, murk_photon_place(p));
        murk_vec3 at;
        /* An entry may differ if the photon or a sightline does. */
        if (interfaces) {
            const murk_side *facing;
            at = murk_side_start(p, desc->surfaces, sides, &facing);
            const double index = murk_path_index_at(&l->space, at);
            if (index != l->viewpoint.index) {
                if (is_added || murk_changes_may_meet_refracted(
                                    &c->near, interfaces, &l->viewpoint, at)) {
                    c->tested[k / 64] |= UINT64_C(1) << (k % 64);
                    test_changed_across(l, c, p, facing, at, index, is_added,
                                        first, number);
                }
                continue;
            }
            if (is_beyond(l, murk_photon_place(p), sensor)) {
                continue;
            }
        }
        if (!find_start(l, p, sensor, sides, &at) ||
            (!is_added && !meets_change(l, c, at))) {
            continue;
        }
        c->tested[k / 64] |= UINT64_C(1) << (k % 64);
        block.from[block.n] = at;
        block.number[block.n++] = number;
        block.again[block.n_again] = at;
        block.n_again += !is_added;
        if (block.n == BLOCK) {
            test_changed(l, c, photon, first, &block);
        }
    }
    test_changed(l, c, photon, first, &block);
}

/* Counts the sightlines of the earlier row to a photon that is gone. */
static void count_gone(const row_search *l, row_changes *c,
                       const murk_photon *p, murk_side sides[MURK_SIDES])
{
    const murk_sight_desc *desc = &l->sight->desc;
    const murk_vec3 place = murk_photon_place(p),
                    sensor = murk_path_nearest_image(&desc->domain, l->sensor,
                                                     place);
    murk_vec3 from;
    /* Across interfaces, as search_map() has it. */
    if (l->sight->interfaces) {
        const murk_side *facing;
        from = murk_side_start(p, desc->surfaces, sides, &facing);
        const double index = murk_path_index_at(&l->space, from);
        if (index != l->viewpoint.index) {
            murk_across across = l->across;
            murk_sightline ignored[MURK_REFRACTED_PATHS_MAX];
            across.counts = &c->earlier;
            if (l->bands >> murk_photon_band(p) & 1) {
                murk_across_sightlines(&across, p, facing, from, index,
                                       ignored);
            }
            return;
        }
        if (is_beyond(l, place, sensor)) {
            return;
        }
    }
    /* Along a straight line. */
    if (find_start(l, p, sensor, sides, &from)) {
        ++c->earlier.tested;
        if (may_bend(l)) {
            c->earlier.bent += count_bent(l, c, &from, 1);
        }
    }
}

/* Counts the sightlines of the earlier row to all photons that are gone. */
static void count_all_gone(const row_search *l, row_changes *c)
{
    const murk_photon *gone = c->of->gone;
    murk_side sides[MURK_SIDES] = {{0}};
    uint32_t found[2 * BLOCK]; /* for the images of a periodic domain */
    for (size_t first = 0; first < c->of->gone_photons; first += BLOCK) {
        const size_t left = c->of->gone_photons - first;
        const size_t n = murk_photons_listed_nearby(
            gone + first, left < BLOCK ? left : BLOCK, &l->sight->desc.domain,
            l->sensor, l->query_m, found);
        for (size_t i = 0; i < n; ++i) {
            count_gone(l, c, &gone[first + found[i]], sides);
        }
    }
}

void murk_sight_row_again(murk_sight *sight, unsigned worker,
                          const murk_pose *pose,
                          const murk_sight_changes *changes,
                          const murk_row_counts *before, uint64_t *tested,
                          murk_sparse_row *out)
{
    const murk_sight_desc *desc = &sight->desc;
    row_search l = begin(sight, worker, pose);
    row_changes c = {.of = changes, .tested = tested};
    l.viewpoint = murk_path_viewpoint_at(&l.space, pose->position);
    begin_across(&l);
    c.near = murk_changes_within_range(&changes->changed, &desc->domain,
                                       l.sensor, l.query_m);
    if (!desc->domain.is_periodic && !sight->interfaces) {
        /* A sightline begins so far off its photon. */
        const double off_m = murk_surfaces_leave_step_m(desc->surfaces);
        c.cone = murk_changes_cone(&c.near, l.sensor, l.query_m,
                                   2 * (off_m + sight->position_error_m));
    }
    search_changed(&l, &c, desc->surface_map, false, 0);
    search_changed(&l, &c, desc->volume_map, true,
                   (uint32_t)murk_photon_map_count(desc->surface_map));
    count_all_gone(&l, &c);
    /* The sightlines of the row: those before, without those of photons that
     * are gone, and with those of photons that came. */
    const murk_row_counts all = {
        before->tested - c.earlier.tested + l.counts.tested,
        before->bent - c.earlier.bent + l.counts.bent,
        before->reflected - c.earlier.reflected + l.counts.reflected};
    murk_tally_add(&sight->reused, (int64_t)(all.tested - l.counts.tested));
    *out = found_row(&l, worker, &all);
}

/* ---- parts of rows ---- */

/* Writes the numbers of the needed photons of a map that pass the filters to
 * selected[], and adds to *max the amounts by which they can increase the
 * value. Returns the number of photons. */
static size_t select_needed(const row_search *l, const murk_photon_map *map,
                            const uint64_t *need, uint32_t *selected,
                            uint64_t *max)
{
    const murk_domain *domain = &l->sight->desc.domain;
    const murk_photon *photon = murk_photon_map_photons(map);
    const size_t n =
        murk_photons_nearby(map, domain, l->sensor, l->query_m, selected);
    murk_side sides[MURK_SIDES] = {{0}};
    size_t count = 0;
    /* Compact the numbers in place. */
    for (size_t i = 0; i < n; ++i) {
        const uint32_t k = selected[i];
        if (need[k] == 0) {
            continue;
        }
        const murk_vec3 sensor =
            domain->is_periodic
                ? murk_path_nearest_image(domain, l->sensor,
                                          murk_photon_place(&photon[k]))
                : l->sensor;
        murk_vec3 from;
        if (find_start(l, &photon[k], sensor, sides, &from)) {
            selected[count++] = k;
            *max += need[k];
        }
    }
    return count;
}

/* Tests the sightlines to the n selected photons of a map. Subtracts from *max
 * the amounts of photons that are not visible. False if *max falls below
 * `min`. As in add_visible(), the row is written over the selected numbers.
 */
static bool test_selected(row_search *l, const murk_photon_map *map,
                          uint32_t first, const uint64_t *need, uint64_t min,
                          const uint32_t *selected, size_t n, uint64_t *max)
{
    const murk_photon *photon = murk_photon_map_photons(map);
    murk_vec3 from[BLOCK_OF_PART];
    uint32_t number[BLOCK_OF_PART];
    murk_side sides[MURK_SIDES] = {{0}};
    for (size_t begin_at = 0; begin_at < n; begin_at += BLOCK_OF_PART) {
        const size_t left = n - begin_at,
                     filled = left < BLOCK_OF_PART ? left : BLOCK_OF_PART;
        for (size_t i = 0; i < filled; ++i) {
            const murk_side *side;
            number[i] = selected[begin_at + i];
            from[i] = murk_side_start(&photon[number[i]],
                                      l->sight->desc.surfaces, sides, &side);
            *max -= need[number[i]];
        }
        /* The visible ones of the block remain possible. */
        const size_t before = l->seen;
        add_visible(l, photon, first, number, from, filled);
        for (size_t i = before; i < l->seen; ++i) {
            *max += need[l->photon[i] - first];
        }
        if (*max < min) {
            return false;
        }
    }
    return true;
}

bool murk_sight_part(murk_sight *sight, unsigned worker, const murk_pose *pose,
                     const murk_row_need *need, murk_sparse_row *out)
{
    /* Refracted sightlines are not foretold. */
    if (sight->interfaces) {
        murk_sight_row(sight, worker, pose, out);
        return true;
    }
    /* Select photons of both maps, then test their sightlines. */
    const murk_photon_map *surface_map = sight->desc.surface_map,
                          *volume_map = sight->desc.volume_map;
    const uint32_t first = (uint32_t)murk_photon_map_count(surface_map);
    row_search l = begin(sight, worker, pose);
    uint64_t max = 0;
    const size_t surface =
        select_needed(&l, surface_map, need->entry_max, l.photon, &max);
    const uint32_t *selected = l.photon + surface;
    const size_t volume = select_needed(&l, volume_map, need->entry_max + first,
                                        l.photon + surface, &max);
    if (max < need->gain_min) {
        return false;
    }
    l.viewpoint = murk_path_viewpoint_at(&l.space, pose->position);
    const bool is_complete =
        test_selected(&l, surface_map, 0, need->entry_max, need->gain_min,
                      l.photon, surface, &max) &&
        test_selected(&l, volume_map, first, need->entry_max + first,
                      need->gain_min, selected, volume, &max);
    *out = found_row(&l, worker, &l.counts);
    return is_complete;
}

void murk_sight_depths(double *depth, double *sheets, const murk_sight *sight,
                       const murk_pose *pose, const uint32_t *photon, size_t n,
                       const murk_media *const *media, size_t count)
{
    const murk_sight_desc *desc = &sight->desc;
    murk_side sides[MURK_SIDES] = {{0}};
    for (size_t i = 0; i < n; ++i) {
        /* The transmittance of the sheets on each sightline. */
        sheets[i] = 1;
        if (sight->has_sheets) {
            const murk_photon *p = murk_sight_photon(sight, photon[i]);
            const murk_side *side;
            const murk_vec3 from =
                murk_side_start(p, desc->surfaces, sides, &side);
            const murk_vec3 to =
                murk_path_nearest_image(&desc->domain, pose->position, from);
            sheets[i] = murk_path_sheets(desc->surfaces, &desc->domain, from,
                                         to, murk_photon_band(p));
        }
    }
    /* The optical depth in each of the media. */
    for (size_t m = 0; m < count; ++m) {
        const murk_path_space space = murk_path_space_of(
            desc->surfaces, media[m], desc->boundary_meshes, &desc->domain);
        const murk_path_viewpoint viewpoint =
            murk_path_viewpoint_at(&space, pose->position);
        for (size_t i = 0; i < n; ++i) {
            const murk_photon *p = murk_sight_photon(sight, photon[i]);
            const murk_side *side;
            const murk_vec3 from =
                murk_side_start(p, desc->surfaces, sides, &side);
            depth[i * count + m] =
                murk_path_depth_to(&viewpoint, murk_photon_band(p), from);
        }
    }
}
