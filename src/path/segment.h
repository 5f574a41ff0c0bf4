/* Straight segments between two points of the domain.
 *
 * In a periodic domain the straight line from one point to the nearest image of
 * the other may cross the sides. murk_path_cut() cuts the line there into
 * segments and moves each segment by whole periods into the domain. */
#ifndef MURK_PATH_SEGMENT_H
#define MURK_PATH_SEGMENT_H

#include "base/vector.h"
#include "geometry/surfaces.h"

/* A point nearer to a surface than this [m] counts as lying on the surface: the
 * rounding of single-precision coordinates, with a margin. The larger of 2^-18
 * of the domain's largest coordinate, which is 32 to 64 steps of a float (38
 * micrometres at 10 m), and twice the step of murk_surfaces_leave(), which is
 * the larger one if surfaces reach beyond twice that coordinate. */
double murk_path_surface_tolerance_m(const murk_surfaces *surfaces,
                                     const murk_domain *domain);

typedef struct murk_path_segment {
    murk_vec3 from, to;
} murk_path_segment;

/* The line of murk_path_cut() crosses at most one side perpendicular to x and
 * at most one perpendicular to y, which cut the line into at most three
 * segments. */
#define MURK_PATH_SEGMENTS_MAX 3

/* In a periodic domain the image of `point`, moved by whole periods in x and y,
 * that is nearest to `to` (of two equally near images the one with the smaller
 * coordinate); otherwise `point` itself. */
murk_vec3 murk_path_nearest_image(const murk_domain *domain, murk_vec3 point,
                                  murk_vec3 to);

/* Cuts the line at the periodic sides; `from` lies within the domain, `to` at
 * most one period outside. Writes the segments in their order along the line
 * and returns their number, 1..MURK_PATH_SEGMENTS_MAX; 1 if the domain is not
 * periodic. The two segments at a cut both extend over the side by `beyond_m`
 * along the line, but not beyond the ends of the line, so that a surface in the
 * plane of the side is met. */
int murk_path_cut(const murk_domain *domain, murk_vec3 from, murk_vec3 to,
                  double beyond_m, murk_path_segment *segment);

/* True if murk_surfaces_blocked() is true for any segment of the line. The
 * segments extend over periodic sides by murk_path_surface_tolerance_m(). */
bool murk_path_blocked(const murk_surfaces *surfaces, const murk_domain *domain,
                       murk_vec3 from, murk_vec3 to, bool through_sheets);

/* Product of the transmittances of the thin sheets that the segments cross. The
 * segments are those of murk_path_blocked(). */
double murk_path_sheets(const murk_surfaces *surfaces,
                        const murk_domain *domain, murk_vec3 from, murk_vec3 to,
                        int band);

#endif
