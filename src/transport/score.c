/* Scores one photon: crossings of planes, chords of spheres and track lengths
 * in grids. The values of the photon are rounded to whole numbers once, at the
 * end of the photon, and added to the sums and the sums of squares. */
#include "transport/score.h"

#include <assert.h>
#include <math.h>

/* Entries of the list by which sums of cells are loaded in advance: about the
 * time of a load from the second cache. */
#define AHEAD 16

/* The bits of the number of a slot. */
#define SLOT_BITS 13

static_assert(1 << SLOT_BITS == MURK_SCORE_SLOTS, "a number for each slot");
static_assert(MURK_SCORE_ENTRIES <= MURK_SCORE_SLOTS / 2, "slots stay empty");
static_assert(MURK_SCORE_ENTRIES <= UINT16_MAX, "a slot holds an entry");

/* The signed distance of a position beyond a plane; 0 if the position lies in
 * the plane. */
static inline double beyond(const murk_tally_plane *plane, murk_station at)
{
    const double s = murk_dot(plane->normal, murk_sub(at.place, plane->point));
    return fabs(s) <= at.reach_m ? 0 : s;
}

static uint32_t bin_at(double x, uint32_t bins)
{
    return x >= (double)bins ? bins - 1 : x > 0 ? (uint32_t)x : 0;
}

/* Scores a crossing of a plane at the share t of the way from the last position
 * of the chain to `to`. */
static void cross(murk_score_path *path, const murk_tally_plane *plane,
                  double t, murk_vec3 to, murk_vec3 direction, bool backward,
                  double quanta)
{
    const murk_vec3 from = path->at.place;
    const murk_vec3 p = murk_along(from, t, murk_sub(to, from));
    uint32_t bin[2];
    for (int i = 0; i < 2; ++i) {
        bin[i] = bin_at((murk_component(p, plane->axes[i]) - plane->low_m[i]) *
                            plane->bins_per_m[i],
                        plane->bins[i]);
    }
    const uint32_t angle =
        bin_at(fabs(murk_dot(plane->normal, direction)) * plane->angle_bins,
               plane->angle_bins);
    const uint32_t first_angle = backward ? plane->angle_bins : 0;
    murk_score_add(path,
                   plane->first +
                       ((first_angle + angle) * plane->bins[1] + bin[1]) *
                           plane->bins[0] +
                       bin[0],
                   quanta);
}

/* Scores the chord of a segment through a sphere. The chord is computed from
 * the point of the line nearest to the center, which keeps full precision for a
 * small, distant sphere. */
static inline void score_probe(murk_score_path *path, const murk_probe *probe,
                               murk_vec3 from, murk_vec3 direction,
                               double length_m, double quanta)
{
    const murk_vec3 to_center = murk_sub(probe->center, from);
    const double along = murk_dot(to_center, direction);
    const murk_vec3 off = murk_along(to_center, -along, direction);
    const double left = probe->radius_m * probe->radius_m - murk_dot(off, off);
    if (!(left > 0)) {
        return;
    }
    const double half = sqrt(left);
    const double t0 = along - half > 0 ? along - half : 0;
    const double t1 = along + half < length_m ? along + half : length_m;
    if (t1 > t0) {
        const uint32_t down = probe->hemispheres && direction.z < 0;
        murk_score_add(path, probe->first + down,
                       (t1 - t0) * probe->per_m * quanta);
    }
}

void murk_score_start(murk_score_path *path, size_t channel, murk_station at)
{
    const murk_scorer *scorer = path->scorer;
    path->low = scorer->low + channel * scorer->tallies->cells;
    path->high = scorer->high + channel * scorer->tallies->cells;
    murk_score_jump(path, at);
}

void murk_score_jump(murk_score_path *path, murk_station at)
{
    const murk_tallies *t = path->scorer->tallies;
    path->at = at;
    for (size_t i = 0; i < t->planes; ++i) {
        path->side[i] = beyond(&t->plane[i], at);
    }
}

void murk_score_crossings(murk_score_path *path, murk_vec3 from,
                          murk_vec3 direction, double length_m, double quanta,
                          murk_station at)
{
    const murk_tallies *t = path->scorer->tallies;
    for (size_t i = 0; i < t->planes; ++i) {
        const double s0 = path->side[i], s1 = beyond(&t->plane[i], at);
        if ((s0 < 0) != (s1 < 0)) {
            cross(path, &t->plane[i], s0 / (s0 - s1), at.place, direction,
                  s1 < 0, quanta);
        }
        path->side[i] = s1;
    }
    path->at = at;
    for (size_t i = 0; i < t->probes; ++i) {
        score_probe(path, &t->probe[i], from, direction, length_m, quanta);
    }
}

void murk_score_segment(murk_score_path *path, murk_vec3 from,
                        murk_vec3 direction, double length_m, double quanta,
                        murk_station at)
{
    const murk_tallies *t = path->scorer->tallies;
    murk_score_crossings(path, from, direction, length_m, quanta, at);
    for (size_t i = 0; i < t->lattices; ++i) {
        murk_score_lattice(path, &t->lattice[i], from, direction, length_m,
                           quanta);
    }
}

void murk_score_spill(murk_score_path *path)
{
    murk_scorer *const scorer = path->scorer;
    size_t touched = scorer->n_touched;
    for (size_t i = 1; i <= path->last; ++i) {
        const size_t cell = path->list[i].cell;
        /* Load a sum that is needed later. */
        const size_t ahead = i + AHEAD < path->last ? i + AHEAD : path->last;
        __builtin_prefetch(&scorer->sum[path->list[ahead].cell], 1);
        double *const sum = &scorer->sum[cell];
        /* Without a branch, because it is hard to predict if the photon has
         * been in the cell before. */
        const double before = *sum, after = before + path->list[i].value;
        scorer->touched[touched] = (uint32_t)cell;
        touched += (before == 0) & (after > 0);
        *sum = after;
        /* The sums of the cell are needed at the end of the photon. */
        __builtin_prefetch(&path->low[cell], 1);
    }
    scorer->n_touched = touched;
    path->last = 0;
    path->has_sums = true;
}

/* The slot at which the search for a cell begins: the highest bits of the
 * product with 2^32 / 1.618 (Knuth, The Art of Computer Programming, volume 3,
 * 1973, section 6.4). */
static inline uint32_t first_slot(uint32_t cell)
{
    return (uint32_t)(cell * UINT32_C(2654435769)) >> (32 - SLOT_BITS);
}

/* All bits if a slot has an entry, else 0: a condition that the compiler does
 * not turn into a branch. */
static inline uint64_t is_taken(size_t entry)
{
    return 0 - (uint64_t)(entry != 0);
}

/* Adds up the entries of each cell, in their order, in the first entries of the
 * list, which then name the bins of the cells; `last` is the last of these. The
 * slots in use are listed in `touched`. */
static void join_cells(murk_score_path *path)
{
    murk_score_entry *restrict const list = path->list;
    uint16_t *restrict const slots = path->scorer->slot;
    uint32_t *restrict const touched = path->scorer->touched;
    const size_t last = path->last;
    size_t joined = 0;
    for (size_t i = 1; i <= last; ++i) {
        const uint32_t cell = (uint32_t)list[i].cell;
        const uint64_t offset = cell * sizeof *path->low;
        const double value = list[i].value;
        /* The sums of the cell are needed soon: load them in advance. */
        __builtin_prefetch((char *)path->low + offset, 1);
        /* The slot of the cell, or an empty one. Entry 0 is that of an empty
         * slot: its value is 0. There is no branch on is_new, because it is
         * hard to predict if the photon has been in the cell before. */
        uint32_t slot = first_slot(cell);
        size_t entry = slots[slot];
        while (is_taken(entry) & (list[entry].cell ^ offset)) {
            slot = (slot + 1) % MURK_SCORE_SLOTS;
            entry = slots[slot];
        }
        const bool is_new = entry == 0;
        const size_t to = is_new ? joined + 1 : entry;
        const double sum = list[entry].value + value;
        touched[joined] = slot;
        slots[slot] = (uint16_t)to;
        list[to] = (murk_score_entry){sum, offset};
        joined += is_new;
    }
    path->last = joined;
}

/* Adds a whole number and its square to the tallies, or subtracts them, while
 * other threads may add. */
static void add_shared(const murk_score_path *path, size_t cell,
                       double contribution, bool takes_back)
{
    murk_tally_bin *const low = &path->low[cell];
    murk_tally_bin *const high = &path->high[cell];
    const murk_wide value = (murk_wide)(int64_t)(contribution + 0.5);
    const murk_wide square = value * value;
    murk_wide_add(&low->sum, &high->sum, takes_back ? -value : value);
    murk_wide_add(&low->squares, &high->squares, takes_back ? -square : square);
}

/* Adds the sums of a photon whose list has been full, and clears them. */
static void add_sums(const murk_score_path *path, bool is_alone,
                     bool takes_back)
{
    murk_scorer *const scorer = path->scorer;
    for (size_t i = 0; i < scorer->n_touched; ++i) {
        const uint32_t cell = scorer->touched[i];
        if (is_alone) {
            murk_score_add_alone(&path->low[cell], &path->high[cell],
                                 scorer->sum[cell]);
        } else {
            add_shared(path, cell, scorer->sum[cell], takes_back);
        }
        scorer->sum[cell] = 0;
    }
    scorer->n_touched = 0;
}

/* Adds the joined entries of a list, and clears the slots. */
static void add_list(const murk_score_path *path, bool is_alone,
                     bool takes_back)
{
    murk_scorer *const scorer = path->scorer;
    const size_t n = path->last;
    if (is_alone) {
        scorer->add(path->low, path->high, &path->list[1], n);
    }
    for (size_t i = 1; i <= n && !is_alone; ++i) {
        add_shared(path, path->list[i].cell / sizeof *path->low,
                   path->list[i].value, takes_back);
    }
    for (size_t i = 0; i < n; ++i) {
        scorer->slot[scorer->touched[i]] = 0;
    }
}

void murk_score_add_entries(murk_tally_bin *low, murk_tally_bin *high,
                            const murk_score_entry *entry, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        const size_t cell = entry[i].cell / sizeof *low;
        murk_score_add_alone(&low[cell], &high[cell], entry[i].value);
    }
}

void murk_score_end(murk_score_path *path, bool takes_back)
{
    const bool is_alone = path->scorer->is_alone && !takes_back;
    if (path->has_sums) {
        murk_score_spill(path);
        add_sums(path, is_alone, takes_back);
    } else {
        join_cells(path);
        add_list(path, is_alone, takes_back);
    }
    path->last = 0;
    path->has_sums = false;
}
