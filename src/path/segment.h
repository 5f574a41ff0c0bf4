/* Straight segments between two points of the domain.
 *
 * In a periodic domain the straight line goes to the nearest image of a point
 * and may cross the sides. The line is then cut there into segments, each of
 * which lies in the domain. */
#ifndef MURK_PATH_SEGMENT_H
#define MURK_PATH_SEGMENT_H

#include "base/vector.h"
#include "geometry/surfaces.h"

/* A point nearer to a surface than this [m] lies on the surface: the rounding
 * of single-precision coordinates, with room. The larger of 2^-18 of the
 * domain's largest coordinate, which is 32 to 64 steps of a float (38
 * micrometres at 10 m), and twice the step of murk_surfaces_leave(), which
 * counts if surfaces are larger than the domain. */
double murk_path_surface_tolerance_m(const murk_surfaces *surfaces,
                                     const murk_domain *domain);

typedef struct murk_path_segment {
    murk_vec3 from, to;
} murk_path_segment;

/* Two sides in x and y cut a line into three segments at most. */
#define MURK_PATH_SEGMENTS_MAX 3

/* The image of `point` nearest to `to`: the point itself in an open domain.
 * Both lie within the domain. Of two equally near images always the same. */
murk_vec3 murk_path_nearest_image(const murk_domain *domain, murk_vec3 point,
                                  murk_vec3 to);

/* Cuts the line at the periodic sides; `from` lies within the domain, `to`
 * within one period of the domain. Returns the number of segments, in their
 * order along the line. Segments overlap the sides by `beyond_m`, so that a
 * surface in the plane of a side is met. */
int murk_path_cut(const murk_domain *domain, murk_vec3 from, murk_vec3 to,
                  double beyond_m, murk_path_segment *segment);

/* True if murk_surfaces_blocked() is true for any segment of the line. */
bool murk_path_blocked(const murk_surfaces *surfaces, const murk_domain *domain,
                       murk_vec3 from, murk_vec3 to, bool through_sheets);

/* Product of the transmittances of the thin sheets over all segments, which
 * overlap the sides as for murk_path_blocked(). */
double murk_path_sheets(const murk_surfaces *surfaces,
                        const murk_domain *domain, murk_vec3 from, murk_vec3 to,
                        int band);

#endif
