/* Sightlines. */
#include "geometry/shadow.h"
#include "geometry/walk.h"

/* Shadows kept at a time, a power of two. Measured in a furnished interior: 2
 * and 4 are alike, 6 is 6 % slower, 16 by a third. */
#define SHADOWS 4

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
    return murk_ray_is_sound(*origin, *along);
}

/* One sightline asked of Embree, which also tells a triangle in the way. */
typedef struct sightline {
    murk_ray_context context;
    struct RTCRay ray;
    unsigned geometry, primitive; /* RTC_INVALID_GEOMETRY_ID: not known */
} sightline;

static void note_blocker(const struct RTCFilterFunctionNArguments *args)
{
    sightline *line = (sightline *)(void *)args->context;
    const struct RTCHit *hit = (const struct RTCHit *)(const void *)args->hit;
    line->geometry = hit->geomID;
    line->primitive = hit->primID;
}

/* The ray runs from `to`, the end that sightlines share. */
static bool is_blocked(const murk_surfaces *s, sightline *line, murk_vec3 from,
                       murk_vec3 to, unsigned mask)
{
    murk_ray_context *context = &line->context;
    line->geometry = RTC_INVALID_GEOMETRY_ID;
    if (!segment_between(s, to, from, &context->origin, &context->direction)) {
        return false;
    }
    murk_ray_set(&line->ray, context->origin, context->direction, 1, mask);
    murk_embree_occluded(s->scene, &context->embree, &line->ray, note_blocker);
    return line->ray.tfar < 0;
}

bool murk_surfaces_blocked(const murk_surfaces *s, murk_vec3 from, murk_vec3 to,
                           bool through_sheets)
{
    if (!s->scene) {
        return false;
    }
    sightline line;
    murk_embree_context_init(&line.context.embree);
    return is_blocked(s, &line, from, to,
                      through_sheets ? MURK_MASK_BLOCKS : MURK_MASK_ALL);
}

/* Shadows of triangles that were in the way of rays to one point. */
typedef struct shadows {
    murk_vec3 eye; /* as all here, relative to the anchor */
    double farthest_m;
    size_t n, latest; /* latest: hid the last hidden point */
    size_t blocker;   /* the last that Embree told; its shadow is drawn when it
                         is told again, so that scattered lines cost little */
    murk_shadow of[SHADOWS];
} shadows;

static bool hidden_by_any(shadows *known, murk_vec3 p)
{
    for (size_t k = 0; k < SHADOWS; ++k) {
        const size_t i = (known->latest + k) % SHADOWS;
        if (i < known->n && murk_shadow_hides(&known->of[i], p)) {
            known->latest = i;
            return true;
        }
    }
    return false;
}

static void remember(shadows *known, const murk_surfaces *s,
                     const sightline *line)
{
    murk_shadow shadow;
    if (line->geometry >= MURK_FACES) {
        return;
    }
    const size_t index =
        s->soup.first_triangle[line->geometry] + line->primitive;
    if (index != known->blocker) {
        known->blocker = index;
        return;
    }
    const murk_triangle t = murk_soup_triangle(&s->soup, index);
    if (!murk_shadow_make(&shadow, &t, known->eye, s->unit_m,
                          known->farthest_m)) {
        return;
    }
    known->latest = known->n < SHADOWS
                        ? known->n++
                        : (known->latest + SHADOWS - 1) % SHADOWS;
    known->of[known->latest] = shadow;
}

void murk_surfaces_blocked_many(const murk_surfaces *s, const murk_vec3 *from,
                                size_t n, murk_vec3 to, bool through_sheets,
                                bool *blocked)
{
    const unsigned mask = through_sheets ? MURK_MASK_BLOCKS : MURK_MASK_ALL;
    shadows known;
    known.n = known.latest = 0;
    known.blocker = SIZE_MAX;
    known.eye = murk_sub(to, s->soup.anchor);
    known.farthest_m = murk_length(murk_sub(s->reach.max, s->reach.min));
    const bool may_know = murk_box_contains(&s->reach, known.eye);
    sightline line;
    murk_embree_context_init(&line.context.embree);
    for (size_t i = 0; i < n; ++i) {
        const murk_vec3 p = murk_sub(from[i], s->soup.anchor);
        if (hidden_by_any(&known, p) && murk_box_contains(&s->reach, p)) {
            blocked[i] = true;
            continue;
        }
        blocked[i] = s->scene && is_blocked(s, &line, from[i], to, mask);
        if (blocked[i] && may_know) {
            remember(&known, s, &line);
        }
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
