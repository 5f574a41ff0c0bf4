/* The places at which the extinction of two sets of media differs. */
#ifndef MURK_MEDIUM_CHANGED_MEDIA_H
#define MURK_MEDIUM_CHANGED_MEDIA_H

#include "base/box_list.h"
#include "medium/media.h"

/* Adds the bounding boxes of all regions that differ in shape, place, rule or
 * extinction, those of both sets. A segment that does not meet the boxes,
 * enlarged by rounding, has the same optical depth in both sets, in every bit.
 * Sets whose regions do not correspond differ everywhere, as do two sets that
 * refract light and are not equal. with_scattering: albedo and phase function
 * count, too. */
void murk_changed_media(murk_box_list *changed, const murk_media *a,
                        const murk_media *b, bool with_scattering);

#endif
