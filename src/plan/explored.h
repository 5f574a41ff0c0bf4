/* The places that an explorer has seen, and the paths between them.
 *
 * Places are the usable sites and the positions of fixed sensors, numbered as
 * in poses->site (plan/poses.h): usable sites first, then the positions of
 * fixed sensors (with one_per_site only those that are neither at a site nor at
 * an earlier fixed sensor; the numbers that the other fixed sensors would have
 * stay unused). Two places are connected if one is seen from a station or fixed
 * sensor at the other, or if both are connected to a third place. A path leads
 * over seen places from one place to a connected place. */
#ifndef MURK_PLAN_EXPLORED_H
#define MURK_PLAN_EXPLORED_H

#include "plan/poses.h"
#include "sensing/outlook.h"

typedef struct murk_explored {
    murk_outlook outlook;
    size_t places, sites;    /* sites are the usable ones, numbered first */
    murk_vec3 *place;        /* [places] */
    uint8_t *is_seen;        /* [places] */
    uint8_t *is_always_used; /* [places]; true for the place of a station or
                              * fixed sensor, and for a place that connected two
                              * sets of places: searches for paths always
                              * include these places */
    uint32_t *joined; /* [places]; disjoint sets: the parent of a place, or
                       * the place itself */
    size_t sites_seen;
} murk_explored;

/* Nothing is seen at first. Borrows the description of sight. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_explored_init(murk_explored *out, const murk_sight_desc *sight,
                               int bands, size_t sites, const murk_poses *poses,
                               murk_error *err);
void murk_explored_release(murk_explored *explored);

/* Marks `place`, at which a station with this pose stands, and all places that
 * the station sees as seen, and connects them to each other. Returns the number
 * of usable sites seen so far. */
size_t murk_explored_see(murk_explored *explored, const murk_pose *pose,
                         uint32_t place);

/* True if the place is seen and connected to the other place. */
bool murk_explored_joins(const murk_explored *explored, uint32_t place,
                         uint32_t other);

/* The number of usable sites that a station with this pose at `place` would see
 * and that have not been seen, or are not connected to `place`. May be called
 * from several threads. */
size_t murk_explored_opens(murk_explored *explored, const murk_pose *pose,
                           uint32_t place);

/* Finds a path between two connected places. The caller frees (*path)[*stops].
 * The path is the shortest over all seen places that are connected to the two,
 * if is_always_used is false for at most 2000 of these places. Otherwise it is
 * the shortest over a part of these places. Fails with MURK_NO_MEMORY. */
murk_status murk_explored_path(murk_explored *explored, murk_vec3 **path,
                               size_t *stops, double *length_m, uint32_t from,
                               uint32_t to, murk_error *err);

/* Finds the shortest path over place[n] from place[from] to place[to].
 * stop[*stops] are the indices of the places on the path, both ends included;
 * the array must hold n. *stops is 0 if there is no path. Places that an open
 * straight step between their neighbours on the path can bypass are left out.
 * Memory grows as n^2 in the worst case. Fails with MURK_NO_MEMORY. */
murk_status murk_route_find(size_t *stop, size_t *stops, double *length_m,
                            murk_outlook *outlook, const murk_vec3 *place,
                            size_t n, size_t from, size_t to, murk_error *err);

#endif
