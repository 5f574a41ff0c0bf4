/* Scores one photon: crossings of planes, chords of spheres and track lengths
 * in grids. The values of the photon are rounded to whole numbers once, at the
 * end of the photon, and added to the sums and the sums of squares. */
#include "transport/score.h"

#include <math.h>

/* Entries of the list by which sums of cells are loaded in advance: about the
 * time of a load from the second cache. */
#define AHEAD 16

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
        /* The lower half is needed at the end of the photon: load it in
         * advance. */
        __builtin_prefetch(&path->low[cell], 1);
    }
    scorer->n_touched = touched;
    path->last = 0;
    path->has_sums = true;
}

/* Adds the rounded sums of the photon that ends to the tallies, and clears
 * them. Inlined for each of the cases. */
static inline __attribute__((always_inline)) void
add_sums(const murk_score_path *path, bool is_alone, bool takes_back)
{
    murk_scorer *const scorer = path->scorer;
    for (size_t i = 0; i < scorer->n_touched; ++i) {
        const uint32_t cell = scorer->touched[i];
        murk_tally_bin *const low = &path->low[cell];
        murk_tally_bin *const high = &path->high[cell];
        /* Below 2^48: MURK_TALLY_SEGMENTS_MAX segments of a packet. */
        const uint64_t value = (uint64_t)(int64_t)(scorer->sum[cell] + 0.5);
        const murk_wide square = (murk_wide)value * value;
        const murk_wide sum = takes_back ? -(murk_wide)value : value;
        const murk_wide squares = takes_back ? -square : square;
        if (is_alone) {
            murk_wide_add_alone(&low->sum, &high->sum, sum);
            murk_wide_add_alone(&low->squares, &high->squares, squares);
        } else {
            murk_wide_add(&low->sum, &high->sum, sum);
            murk_wide_add(&low->squares, &high->squares, squares);
        }
        scorer->sum[cell] = 0;
    }
    scorer->n_touched = 0;
}

void murk_score_end(murk_score_path *path, bool takes_back)
{
    murk_score_spill(path);
    if (!path->scorer->is_alone) {
        add_sums(path, false, takes_back);
    } else if (takes_back) {
        add_sums(path, true, true);
    } else {
        add_sums(path, true, false);
    }
    path->has_sums = false;
}
