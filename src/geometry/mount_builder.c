/* The list of candidate sites: accepts a site if no other site of the same
 * surface is near. Neighbours are found in a grid of cells (base/cells.h). */
#include "geometry/mount_builder.h"

#include <stdlib.h>

/* Two sites are on the same surface if the cosine between the normals, without
 * its sign, is at least SAME_COSINE (60 degrees) and neither site is off the
 * other's plane by more than SAME_RISE times the distance (or by more than
 * rounding, slack_m): the tilt of the chord between points of a surface that
 * bends by 60 degrees. */
#define SAME_COSINE 0.5 /* smallest cosine between normals */
#define SAME_RISE   0.5 /* largest rise as a fraction of the distance */
#define SHEETS_MAX                                                           \
    4096 /* sites compared with one; bounds the time in a stack of thousands \
            of sheets within one spacing: further sheets get no sites */

typedef struct comparison {
    const murk_mount_builder *l;
    murk_mount_site site;
    size_t looked_at;
} comparison;

/* True if the site `number` is on the same surface and nearer than
 * MURK_MOUNT_NEAREST spacings, or if SHEETS_MAX sites were compared already. A
 * callback of murk_cells_search(). */
static bool is_taken(void *context, size_t number)
{
    comparison *c = context;
    const murk_mount_builder *l = c->l;
    const murk_mount_site *other = &l->site[number];
    const murk_vec3 off = murk_sub(c->site.position, other->position);
    const double distance = murk_length(off);
    if (++c->looked_at > SHEETS_MAX) {
        return true;
    }
    if (!(distance < MURK_MOUNT_NEAREST * l->search->spacing_m) ||
        fabs(murk_dot(c->site.normal, other->normal)) < SAME_COSINE) {
        return false;
    }
    const double rise = fmax(fabs(murk_dot(off, c->site.normal)),
                             fabs(murk_dot(off, other->normal)));
    return rise <= fmax(SAME_RISE * distance, l->slack_m);
}

murk_status murk_mount_builder_refuse(const murk_mount_builder *l)
{
    return murk_fail(l->err, MURK_BAD_VALUE, l->where,
                     "spacing_m is %g m, which lays more than %zu places over "
                     "its surfaces, the most there may be",
                     l->search->spacing_m, l->search->max);
}

/* Appends a site to the list and to the grid of cells. */
static murk_status append_site(murk_mount_builder *l,
                               const murk_mount_site *site)
{
    if (l->n == l->search->max) {
        return murk_mount_builder_refuse(l);
    }
    if (l->n == l->capacity) {
        const size_t capacity = l->capacity ? 2 * l->capacity : 256;
        murk_mount_site *grown = realloc(l->site, capacity * sizeof *grown);
        if (!grown) {
            return murk_no_memory(l->err, l->where,
                                  "for %zu places on surfaces", capacity);
        }
        l->site = grown;
        l->capacity = capacity;
    }
    l->site[l->n++] = *site;
    return murk_cells_add(l->cells, site->position, l->err);
}

void murk_mount_builder_offer(murk_mount_builder *l, murk_vec3 place,
                              murk_vec3 normal)
{
    const murk_box *box = &l->search->within;
    const murk_vec3 at = {fmin(fmax(place.x, box->min.x), box->max.x),
                          fmin(fmax(place.y, box->min.y), box->max.y),
                          fmin(fmax(place.z, box->min.z), box->max.z)};
    const double rise = fabs(normal.z);
    if (l->status || !(murk_length(murk_sub(at, place)) <= l->slack_m) ||
        !(rise >= l->search->min_rise && rise <= l->search->max_rise)) {
        return;
    }
    comparison c = {.l = l, .site = {at, normal}};
    if (!murk_cells_search(l->cells, at,
                           MURK_MOUNT_NEAREST * l->search->spacing_m, is_taken,
                           &c)) {
        l->status = append_site(l, &c.site);
    }
}
