/* The places that an explorer has seen, and the paths between them.
 *
 * Places are numbered as poses->site: usable sites first, then the places of
 * fixed sensors (with one_per_site only of those that are not at a site). Two
 * places are connected if one is seen from a station at the other, or if both
 * are connected to a third place. A path leads over seen places from any place
 * to any connected place. */
#ifndef MURK_PLAN_EXPLORED_H
#define MURK_PLAN_EXPLORED_H

#include "plan/poses.h"
#include "sensing/outlook.h"

typedef struct murk_explored {
    murk_outlook outlook;
    size_t places, sites;    /* sites are the usable ones, numbered first */
    murk_vec3 *place;        /* [places] */
    uint8_t *is_seen;        /* [places] */
    uint8_t *is_always_used; /* [places]; always used for paths: a station, or a
                              * place that connected two sets of places */
    uint32_t *joined; /* [places]; disjoint sets: the parent of a place, or
                       * the place itself */
    size_t sites_seen;
} murk_explored;

/* Borrows the description of sight. */
murk_status murk_explored_init(murk_explored *out, const murk_sight_desc *sight,
                               int bands, size_t sites, const murk_poses *poses,
                               murk_error *err);
void murk_explored_release(murk_explored *explored);

/* Marks everything as seen that a station with this pose sees. Returns the
 * number of usable sites seen so far. */
size_t murk_explored_see(murk_explored *explored, const murk_pose *pose,
                         uint32_t place);

/* True if the place is seen and connected to the other place. */
bool murk_explored_joins(const murk_explored *explored, uint32_t place,
                         uint32_t other);

/* The number of usable sites that a station with this pose would newly see or
 * connect to its place. May be called from several threads. */
size_t murk_explored_opens(murk_explored *explored, const murk_pose *pose,
                           uint32_t place);

/* The shortest path between two connected places. *path[*stops] belongs to the
 * caller: free(). The path is the shortest over all seen places in their set if
 * at most 2000 of these are not always used; otherwise the path leads over a
 * subset of them. */
murk_status murk_explored_path(murk_explored *explored, murk_vec3 **path,
                               size_t *stops, double *length_m, uint32_t from,
                               uint32_t to, murk_error *err);

/* Finds the path over place[n] from place `from` to place `to`. stop[0 ..
 * *stops) are the numbers of the places on the path, both ends included; the
 * array must hold n. *stops is 0 if there is no path. Fails with
 * MURK_NO_MEMORY. Places that a straight step can bypass are left out. Memory
 * grows as n^2 in the worst case. */
murk_status murk_route_find(size_t *stop, size_t *stops, double *length_m,
                            murk_outlook *outlook, const murk_vec3 *place,
                            size_t n, size_t from, size_t to, murk_error *err);

#endif
