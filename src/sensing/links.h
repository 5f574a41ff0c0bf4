/* The range that links between sensors need to join all sensors of a plan.
 *
 * Two sensors can be linked if the straight segment between them meets no
 * surface; with `through_sheets`, thin transmitting sheets may be met. This is
 * geometry alone: attenuation by media, diffraction and transmission through
 * walls are not considered. The smallest range that joins all sensors is the
 * longest link of a minimum spanning tree (Prim, Bell Syst. Tech. J. 36 (1957)
 * 1389, doi:10.1002/j.1538-7305.1957.tb01515.x). In a periodic domain segments
 * go to the nearest image. */
#ifndef MURK_SENSING_LINKS_H
#define MURK_SENSING_LINKS_H

#include "base/status.h"
#include "geometry/surfaces.h"
#include "sensing/sensor.h"

#include <stddef.h>

/* The algorithm tests pairs of sensors, so the time grows with the square: for
 * more sensors links are not computed. */
#define MURK_LINKED_SENSORS_MAX 3000

typedef struct murk_link {
    size_t from, to; /* indices of sensors */
    double length_m;
} murk_link;

typedef struct murk_links {
    murk_link
        *link; /* [n], n = sensors - groups: the spanning tree, or one for each
                  group; each link adds a sensor. NULL if not computed */
    size_t n;
    size_t groups;  /* groups of sensors that open segments join; 1: all joined;
                       0: not computed (no sensors, or more than
                       MURK_LINKED_SENSORS_MAX) */
    double range_m; /* length of the longest link, 0 for a single sensor; NaN
                       with more than one group, or if not computed */
    double plain_range_m; /* range_m as it would be if all segments were open;
                             NaN if not computed */
} murk_links;

/* Finds the links that join the n sensors. After success call
 * murk_links_release(). Fails with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_links_find(murk_links *out, const murk_pose *pose, size_t n,
                            const murk_surfaces *surfaces,
                            const murk_domain *domain, bool through_sheets,
                            murk_error *err);
void murk_links_release(murk_links *links);

#endif
