/* Scores one photon: crossings of planes, chords of spheres and track lengths
 * in grids. The values of the photon are rounded to whole numbers once, at the
 * end of the photon, and added to the sums and the sums of squares. */
#include "transport/score.h"

#include <math.h>

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
    path->cell = scorer->copy + channel * scorer->tallies->cells;
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

void murk_score_segment(murk_score_path *path, murk_vec3 from,
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
    for (size_t i = 0; i < t->lattices; ++i) {
        murk_score_lattice(path, &t->lattice[i], from, direction, length_m,
                           quanta);
    }
}

void murk_score_spill(murk_score_path *path)
{
    murk_scorer *const scorer = path->scorer;
    for (size_t i = 0; i < path->n_entries; ++i) {
        const murk_score_entry *entry = &path->entry[i];
        double *const sum = &scorer->value[entry->cell];
        if (*sum == 0) {
            scorer->touched[scorer->n_touched++] = entry->cell;
        }
        *sum += entry->value;
    }
    path->n_entries = 0;
    path->has_sums = true;
}

void murk_score_end(murk_score_path *path, bool takes_back)
{
    murk_scorer *const scorer = path->scorer;
    murk_score_spill(path);
    for (size_t i = 0; i < scorer->n_touched; ++i) {
        const uint32_t cell = scorer->touched[i];
        const uint64_t value = (uint64_t)(scorer->value[cell] + 0.5);
        murk_wide sum = value, square = (murk_wide)value * value;
        if (takes_back) {
            sum = -sum;
            square = -square;
        }
        murk_tally_bin *const to = &path->cell[cell];
        if (scorer->is_alone) {
            murk_wide_add_alone(&to->sum, sum);
            murk_wide_add_alone(&to->squares, square);
        } else {
            murk_wide_add(&to->sum, sum);
            murk_wide_add(&to->squares, square);
        }
        scorer->value[cell] = 0;
    }
    scorer->n_touched = 0;
    path->has_sums = false;
}
