/* Sightlines. */
#include "geometry/walk.h"

/* The open segment between two points less leave_m at either end, relative to
 * the anchor; false when nothing is left of it. */
static bool segment_between(const murk_surfaces *s, murk_vec3 from,
                            murk_vec3 to, murk_vec3 *origin, murk_vec3 *along)
{
    *origin = murk_sub(from, s->soup.anchor);
    *along = murk_sub(to, from);
    const double length = murk_length(*along);
    const double trim = s->leave_m / length;
    double first = trim, last = 1 - trim;
    if (!(first < last)) {
        return false;
    }
    const murk_vec3 end = murk_add(*origin, *along);
    if ((!murk_box_contains(&s->reach, *origin) ||
         !murk_box_contains(&s->reach, end)) &&
        !murk_box_clip(&s->reach, *origin, *along, &first, &last)) {
        return false;
    }
    *origin = murk_along(*origin, first, *along);
    *along = murk_scale(last - first, *along);
    return true;
}

static bool is_blocked(const murk_surfaces *s, murk_ray_context *context,
                       murk_vec3 from, murk_vec3 to, unsigned mask)
{
    if (!segment_between(s, to, from, &context->origin, &context->direction)) {
        return false;
    }
    struct RTCRay ray;
    murk_ray_set(&ray, context->origin, context->direction, 1, mask);
    murk_embree_occluded(s->scene, &context->embree, &ray);
    return ray.tfar < 0;
}

bool murk_surfaces_blocked(const murk_surfaces *s, murk_vec3 from, murk_vec3 to,
                           bool through_sheets)
{
    bool blocked;
    murk_surfaces_blocked_many(s, &from, 1, to, through_sheets, &blocked);
    return blocked;
}

void murk_surfaces_blocked_many(const murk_surfaces *s, const murk_vec3 *from,
                                size_t n, murk_vec3 to, bool through_sheets,
                                bool *blocked)
{
    const unsigned mask = through_sheets ? MURK_MASK_BLOCKS : MURK_MASK_ALL;
    murk_ray_context context;
    murk_embree_context_init(&context.embree);
    for (size_t i = 0; i < n; ++i) {
        blocked[i] = s->scene && is_blocked(s, &context, from[i], to, mask);
    }
}

double murk_surfaces_sheet_transmittance(const murk_surfaces *s, murk_vec3 from,
                                         murk_vec3 to, int band)
{
    const murk_soup *soup = &s->soup;
    if (soup->first_triangle[MURK_FACE_SHEET] == soup->triangles &&
        soup->first_ball[MURK_FACE_SHEET] == soup->balls) {
        return 1;
    }
    const murk_vec3 along = murk_sub(to, from);
    const double length = murk_length(along);
    const murk_vec3 direction = murk_scale(1 / length, along);
    murk_walk w;
    if (!murk_walk_begin(&w, s, from, direction, length,
                         MURK_MASK(MURK_FACE_SHEET))) {
        return 1;
    }
    /* Two triangles of one pane meet a ray through their common edge; so hits
     * nearer together than surfaces can be told apart are one. */
    double transmittance = 1, last = s->leave_m;
    while (transmittance > 0 && murk_walk_next(&w)) {
        const murk_primitive p = murk_primitive_of(soup, &w.ray.hit);
        murk_vec3 normal;
        const double distance = murk_walk_locate(&w, p, &normal);
        if (distance > last && distance < length - s->leave_m) {
            const uint8_t material = p.is_ball ? soup->ball[p.index].material
                                               : soup->material[p.index];
            transmittance *= s->material[material].transmit.band[band];
            last = distance + s->leave_m;
        }
    }
    return transmittance;
}
