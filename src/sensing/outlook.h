/* What a sensor sees of free space: which places to stand at lie in its view,
 * and whether a straight way between two places is open.
 *
 * A place is seen when it is within range and in the field of view, the
 * straight way to it is open, the index of refraction does not change on it,
 * and at least MURK_OUTLOOK_MIN of the light comes through in the clearest of
 * the type's bands. A way is open when no surface is in it: what is seen can be
 * gone to, so a pane of glass closes it, and so do walls with
 * MURK_VISIBILITY_NORMAL. Ways do not cross periodic sides, and a way back is
 * open when the way there is. */
#ifndef MURK_SENSING_OUTLOOK_H
#define MURK_SENSING_OUTLOOK_H

#include "base/tally.h"
#include "sensing/sight.h"
#include "sensing/ways.h"

/* The contrast at which the meteorological optical range ends. */
#define MURK_OUTLOOK_MIN 0.05

typedef struct murk_outlook {
    const murk_sight_desc *sight;
    int bands;
    murk_ways ways;
    murk_tally tried; /* straight ways, so far */
} murk_outlook;

/* `bands` is how many the scene has. Of the description's surfaces, media,
 * boundary meshes, domain, types and north, which it borrows; the first and the
 * domain are enough for murk_outlook_is_open(). */
void murk_outlook_init(murk_outlook *out, const murk_sight_desc *sight,
                       int bands);

bool murk_outlook_is_open(murk_outlook *outlook, murk_vec3 from, murk_vec3 to);

/* One pose's view. */
typedef struct murk_outlook_view {
    murk_outlook *outlook;
    murk_vec3 place;
    double range_m;
    murk_field field;
    uint32_t bands; /* by bits */
} murk_outlook_view;

murk_outlook_view murk_outlook_from(murk_outlook *outlook,
                                    const murk_pose *pose);

/* The pose's own place is always seen. */
bool murk_outlook_sees(const murk_outlook_view *view, murk_vec3 place);

#endif
