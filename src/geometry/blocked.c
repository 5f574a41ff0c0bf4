/* Sightlines. */
#include "geometry/shadow.h"
#include "geometry/walk.h"

#include <string.h>

/* Shadows kept at a time, tested side by side. Measured in a furnished
 * interior. */
#define SHADOWS 4

/* The same code, compiled also for wider registers and chosen when the program
 * starts; products are not fused, so all copies compute the same. Clang and the
 * sanitizers get the plain copy. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WIDE_CLONES \
    __attribute__(( \
        target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define WIDE_CLONES
#endif

/* Into each copy of murk_surfaces_blocked_many(), compiled for its registers:
 * some 5 % more sightlines a second. */
#define INTO_COPIES inline __attribute__((always_inline))

/* The open segment between two points less leave_m at either end, relative to
 * the anchor; false when nothing is left of it. */
static INTO_COPIES bool segment_between(const murk_surfaces *s, murk_vec3 from,
                                        murk_vec3 to, murk_vec3 *origin,
                                        murk_vec3 *along)
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
static INTO_COPIES bool is_blocked(const murk_surfaces *s, sightline *line,
                                   murk_vec3 from, murk_vec3 to, unsigned mask)
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

/* Shadows of triangles that were in the way of rays to one point: plane by
 * plane, so that one point is held against all of them in a few wide steps. */
typedef struct shadows {
    double x[4][SHADOWS], y[4][SHADOWS], z[4][SHADOWS], offset[4][SHADOWS];
    murk_vec3 eye; /* as all here, relative to the anchor */
    double farthest_m;
    size_t oldest;  /* the next to be replaced */
    size_t blocker; /* the last that Embree told; its shadow is drawn when it
                       is told again, so that scattered lines cost little */
} shadows;

static inline bool hidden_by_any(const shadows *known, murk_vec3 p)
{
    int64_t inside[SHADOWS];
    for (int k = 0; k < SHADOWS; ++k) {
        inside[k] = -1;
    }
    for (int i = 0; i < 4; ++i) {
        int64_t any = 0;
        for (int k = 0; k < SHADOWS; ++k) {
            const double height = known->x[i][k] * p.x + known->y[i][k] * p.y +
                                  known->z[i][k] * p.z;
            inside[k] &= height + known->offset[i][k] > 0 ? -1 : 0;
            any |= inside[k];
        }
        if (!any) {
            return false;
        }
    }
    return true;
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
    const size_t k = known->oldest;
    known->oldest = (k + 1) % SHADOWS;
    for (int i = 0; i < 4; ++i) {
        known->x[i][k] = shadow.normal[i].x;
        known->y[i][k] = shadow.normal[i].y;
        known->z[i][k] = shadow.normal[i].z;
        known->offset[i][k] = shadow.offset[i];
    }
}

WIDE_CLONES
void murk_surfaces_blocked_many(const murk_surfaces *s, const murk_vec3 *from,
                                size_t n, murk_vec3 to, bool through_sheets,
                                bool *blocked)
{
    const unsigned mask = through_sheets ? MURK_MASK_BLOCKS : MURK_MASK_ALL;
    shadows known;
    memset(&known, 0, sizeof known);
    for (int k = 0; k < SHADOWS; ++k) {
        known.offset[0][k] = -INFINITY; /* hides nothing */
    }
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
