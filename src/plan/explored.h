/* Which places an explorer has seen, and how it gets from one to another.
 *
 * Places are numbered as poses->site: usable sites first, then those of fixed
 * sensors elsewhere. Two are joined when one is seen from the other, or both
 * are joined to a third; a way leads over seen places from any to any joined
 * one. */
#ifndef MURK_PLAN_EXPLORED_H
#define MURK_PLAN_EXPLORED_H

#include "plan/poses.h"
#include "sensing/outlook.h"

typedef struct murk_explored {
    murk_outlook outlook;
    size_t places, sites; /* sites are the usable ones, the first */
    murk_vec3 *place;     /* [places] */
    uint8_t *is_seen;     /* [places] */
    uint8_t *is_kept;     /* [places] ways need it: a station, or what joined
                             what was apart */
    uint32_t *joined;     /* [places] a place that it is joined to, or itself */
    size_t sites_seen;
} murk_explored;

/* Borrows the description. */
murk_status murk_explored_init(murk_explored *out, const murk_sight_desc *sight,
                               int bands, size_t sites, const murk_poses *poses,
                               murk_error *err);
void murk_explored_release(murk_explored *explored);

/* A station stands there: what it sees is seen. Returns the usable sites seen
 * by then. */
size_t murk_explored_see(murk_explored *explored, const murk_pose *pose,
                         uint32_t place);

/* Whether the place is seen and joined to the other. */
bool murk_explored_joins(const murk_explored *explored, uint32_t place,
                         uint32_t other);

/* How many usable sites a pose there would bring into view, or join to the
 * place. From any thread. */
size_t murk_explored_opens(murk_explored *explored, const murk_pose *pose,
                           uint32_t place);

/* The way between two joined places, *way [*stops] the caller's for free().
 * Shortest over all seen places up to 2000; of more, a part serves. */
murk_status murk_explored_way(murk_explored *explored, murk_vec3 **way,
                              size_t *stops, double *length_m, uint32_t from,
                              uint32_t to, murk_error *err);

#endif
