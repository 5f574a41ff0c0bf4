/* Straight ways between two points of the domain.
 *
 * In a periodic domain the straight way goes to the nearest image and may
 * cross the sides: it is then cut there, into pieces that each lie in the
 * domain. Internal to the room. */
#ifndef MURK_SENSING_SEGMENT_H
#define MURK_SENSING_SEGMENT_H

#include "base/vector.h"
#include "geometry/surfaces.h"
#include "medium/media.h"

/* The domain's largest coordinate [m], without sign. */
double murk_domain_extent(const murk_domain *domain);

/* What is nearer to a surface than this [m] lies on it: rounding of single
 * precision coordinates, with room. 2^-18 of the domain's largest coordinate,
 * some 32 to 64 steps of a float (38 micrometres at 10 m), or twice what
 * murk_surfaces_leave() steps, where surfaces are larger than the domain. */
double murk_sight_tolerance_m(const murk_surfaces *surfaces,
                              const murk_domain *domain);

typedef struct murk_segment {
    murk_vec3 from, to;
} murk_segment;

/* Two sides in x and y cut a segment into three pieces at most. */
#define MURK_SEGMENT_PIECES 3

/* The image of `point` nearest to `to`: itself where the domain is open. Both
 * within the domain; of two equally near ones always the same. */
murk_vec3 murk_nearest_image(const murk_domain *domain, murk_vec3 point,
                             murk_vec3 to);

/* Cuts the segment at the periodic sides; `from` within the domain, `to`
 * within one period of it. Returns the number of pieces, first to last. Pieces
 * overlap the sides by `beyond_m`, so that a surface in a side's plane is
 * met. */
int murk_segment_cut(const murk_domain *domain, murk_vec3 from, murk_vec3 to,
                     double beyond_m, murk_segment *piece);

/* murk_surfaces_blocked() over all pieces. */
bool murk_segment_blocked(const murk_surfaces *surfaces,
                          const murk_domain *domain, murk_vec3 from,
                          murk_vec3 to, bool through_sheets);

/* Product of the transmittances of the thin sheets over all pieces, which
 * overlap the sides as they do for surfaces. */
double murk_segment_sheets(const murk_surfaces *surfaces,
                           const murk_domain *domain, murk_vec3 from,
                           murk_vec3 to, int band);

/* Whether the index of refraction changes on the straight way to the nearest
 * image of `to`: light bends there, so what is seen beyond is elsewhere. */
bool murk_segment_bends(const murk_media *media, const murk_domain *domain,
                        murk_vec3 from, murk_vec3 to);

#endif
