/* How far links between sensors must reach to join them all.
 *
 * Two sensors can be linked where the straight way between them is open: no
 * surface lies in it but a thin sheet that lets light through. Geometry alone:
 * media, waves round corners and through walls are not looked at. The least
 * range that joins all is the longest link of a minimum spanning tree (Prim,
 * Bell Syst. Tech. J. 36 (1957) 1389, doi:10.1002/j.1538-7305.1957.tb01515.x),
 * and no set of links joins them with less. In a periodic domain ways go to
 * the nearest image. */
#ifndef MURK_SENSING_LINKS_H
#define MURK_SENSING_LINKS_H

#include "base/status.h"
#include "geometry/surfaces.h"
#include "sensing/sensor.h"

#include <stddef.h>

/* Pairs are tried one by one: more sensors are not looked at. */
#define MURK_LINKED_SENSORS_MAX 3000

typedef struct murk_link {
    size_t from, to; /* sensors, from 0 */
    double length_m;
} murk_link;

typedef struct murk_links {
    murk_link *link; /* [n], n = sensors - groups: the tree of open ways, or one
                        in each group, each link with a sensor new to it */
    size_t n;
    size_t groups;  /* that open ways join; 1: all; 0: not looked at */
    double range_m; /* longest link; NaN where there is more than one group */
    double plain_range_m; /* the same, were all ways open */
} murk_links;

/* One sensor needs no links: 0 m. Release with murk_links_release(). Fails with
 * MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_links_find(murk_links *out, const murk_pose *pose, size_t n,
                            const murk_surfaces *surfaces,
                            const murk_domain *domain, bool through_sheets,
                            murk_error *err);
void murk_links_release(murk_links *links);

#endif
