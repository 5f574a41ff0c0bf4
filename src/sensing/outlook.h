/* The part of free space that a sensor sees, for exploration: the places in
 * view, and the open segments between places.
 *
 * A place is seen if it is within range and in the field of view, the straight
 * segment to it is open, the refractive index does not change along the
 * segment, and at least MURK_OUTLOOK_MIN of the light is transmitted in the
 * clearest band of the type. A segment is open if it meets no surface. A robot
 * must be able to go to a place that is seen, so a pane of glass closes a
 * segment, and walls close segments even if the description asks for
 * MURK_VISIBILITY_NORMAL. Segments do not cross periodic sides. A segment is
 * open in both directions or in none. */
#ifndef MURK_SENSING_OUTLOOK_H
#define MURK_SENSING_OUTLOOK_H

#include "base/tally.h"
#include "sensing/free_segments.h"
#include "sensing/sight.h"

/* The least transmittance of the segment to a place that is seen: the contrast
 * at the end of the meteorological optical range (World Meteorological
 * Organization, Guide No. 8). */
#define MURK_OUTLOOK_MIN 0.05

typedef struct murk_outlook {
    const murk_sight_desc *sight;
    int bands;
    murk_free_segments segments;
    murk_tally tried; /* segments tested so far */
} murk_outlook;

/* `bands` is the number of bands of the scene. Borrows the description `sight`.
 * Of the members of the description, surfaces, media, boundary meshes, domain,
 * types and north are used; murk_outlook_is_open() uses surfaces and domain
 * only. */
void murk_outlook_init(murk_outlook *out, const murk_sight_desc *sight,
                       int bands);

/* True if the segment between two places is open. */
bool murk_outlook_is_open(murk_outlook *outlook, murk_vec3 from, murk_vec3 to);

/* The view of one pose. */
typedef struct murk_outlook_view {
    murk_outlook *outlook;
    murk_vec3 place;
    double range_m;
    murk_field field;
    uint32_t bands; /* one bit for each band */
} murk_outlook_view;

murk_outlook_view murk_outlook_from(murk_outlook *outlook,
                                    const murk_pose *pose);

/* True if the pose sees the place. The pose's own place is always seen. */
bool murk_outlook_sees(const murk_outlook_view *view, murk_vec3 place);

#endif
