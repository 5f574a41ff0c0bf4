#include "geometry/laying.h"

#include <stdlib.h>

#define SAME_COSINE 0.5 /* of planes that are one surface */
#define SAME_RISE   0.5 /* above a plane, of the distance */
#define SHEETS_MAX                                             \
    4096 /* feet looked at for one: of a stack of thousands of \
            sheets within one spacing, the rest is left out */

typedef struct comparison {
    const murk_laying *l;
    murk_foot foot;
    size_t looked_at;
} comparison;

static bool is_taken(void *context, size_t number)
{
    comparison *c = context;
    const murk_laying *l = c->l;
    const murk_foot *other = &l->foot[number];
    const murk_vec3 off = murk_sub(c->foot.position, other->position);
    const double distance = murk_length(off);
    if (++c->looked_at > SHEETS_MAX) {
        return true;
    }
    if (!(distance < MURK_LAY_NEAREST * l->lay->spacing_m) ||
        fabs(murk_dot(c->foot.normal, other->normal)) < SAME_COSINE) {
        return false;
    }
    const double rise = fmax(fabs(murk_dot(off, c->foot.normal)),
                             fabs(murk_dot(off, other->normal)));
    return rise <= fmax(SAME_RISE * distance, l->slack_m);
}

murk_status murk_laying_refuse(const murk_laying *l)
{
    return murk_fail(l->err, MURK_BAD_VALUE, l->where,
                     "spacing_m is %g m, which lays more than %zu places over "
                     "its surfaces, the most there may be",
                     l->lay->spacing_m, l->lay->max);
}

static murk_status keep(murk_laying *l, const murk_foot *foot)
{
    if (l->n == l->lay->max) {
        return murk_laying_refuse(l);
    }
    if (l->n == l->room) {
        const size_t room = l->room ? 2 * l->room : 256;
        murk_foot *grown = realloc(l->foot, room * sizeof *grown);
        if (!grown) {
            return murk_fail(l->err, MURK_NO_MEMORY, l->where,
                             "no memory for %zu places on surfaces", room);
        }
        l->foot = grown;
        l->room = room;
    }
    l->foot[l->n++] = *foot;
    return murk_cells_add(l->cells, foot->position, l->err);
}

void murk_laying_offer(murk_laying *l, murk_vec3 place, murk_vec3 normal)
{
    const murk_box *box = &l->lay->within;
    const murk_vec3 at = {fmin(fmax(place.x, box->min.x), box->max.x),
                          fmin(fmax(place.y, box->min.y), box->max.y),
                          fmin(fmax(place.z, box->min.z), box->max.z)};
    const double rise = fabs(normal.z);
    if (l->status || !(murk_length(murk_sub(at, place)) <= l->slack_m) ||
        !(rise >= l->lay->min_rise && rise <= l->lay->max_rise)) {
        return;
    }
    comparison c = {.l = l, .foot = {at, normal}};
    if (!murk_cells_search(l->cells, at, MURK_LAY_NEAREST * l->lay->spacing_m,
                           is_taken, &c)) {
        l->status = keep(l, &c.foot);
    }
}
