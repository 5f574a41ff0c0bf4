/* Sightlines: whether anything blocks the segment between two points, one by
 * one or many to one point.
 *
 * Embree is asked one ray at a time, since its wide occlusion queries change a
 * few grazing answers with the other rays of a packet. Many sightlines to one
 * point use an occlusion cache: the shadows of the last occluding triangles,
 * because neighbouring sightlines to one sensor are mostly blocked by the same
 * few triangles. Four dot products then answer a question for which Embree
 * takes some hundred nanoseconds. A shadow is reduced by margins well above
 * Embree's own rounding, so Embree would report any point inside as occluded
 * too, whichever of Embree's kernels runs. Every other point is left to Embree,
 * so that the answers are those of the single query. */
#include "geometry/triangle.h"
#include "geometry/walk.h"

#include <string.h>

/* Shadows in the cache, tested side by side in one wide register. Four was
 * the fastest number in a furnished interior. */
#define SHADOWS 4

/* Margin in float steps by which a ray must miss every edge, and by which eye
 * and point must be away from the plane. Rounding a ray's origin and direction
 * to floats moves the ray by at most 4 units anywhere in the scene, the ends of
 * the ray are moved inwards by 8, and Embree's own arithmetic adds at most some
 * 8. Cost: only that rays which pass within the margin are left to Embree. */
#define MARGIN_UNITS 64

/* Compiles the function for wider registers, too; the program selects a
 * version when it starts. Products are not fused (-ffp-contract=off), so all
 * versions give the same results. Clang and the sanitizers get the plain
 * version only. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WIDE_CLONES \
    __attribute__(( \
        target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define WIDE_CLONES
#endif

/* Inlines into each version of murk_surfaces_blocked_many(), compiled for the
 * registers of that version: some 5 % more sightlines a second. */
#define INTO_COPIES inline __attribute__((always_inline))

/* The segment between two points, shortened by leave_m at either end and
 * clipped to the scene, relative to the anchor; false if nothing is left of the
 * segment, or if Embree cannot trace it. is_from_inside: `from` is within
 * s->reach, which many segments from one point need not find out again. */
static INTO_COPIES bool segment_between(const murk_surfaces *s, murk_vec3 from,
                                        bool is_from_inside, murk_vec3 to,
                                        murk_vec3 *origin, murk_vec3 *along)
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
    const bool is_inside = is_from_inside && murk_box_contains(&s->reach, end);
    if (!is_inside &&
        !murk_box_clip(&s->reach, *origin, *along, &first, &last)) {
        return false;
    }
    *origin = murk_along(*origin, first, *along);
    *along = murk_scale(last - first, *along);
    /* Embree can trace any segment inside of most scenes. */
    return (is_inside && s->is_reach_sound) ||
           murk_ray_is_sound(*origin, *along);
}

static INTO_COPIES bool is_inside_reach(const murk_surfaces *s, murk_vec3 point)
{
    return murk_box_contains(&s->reach, murk_sub(point, s->soup.anchor));
}

/* A query to Embree, which also reports an occluding triangle. */
typedef struct sightline {
    murk_ray_context context;
    struct RTCRay ray;
    unsigned geometry,
        primitive; /* of the occluder; RTC_INVALID_GEOMETRY_ID: not known */
} sightline;

static void record_occluder(const struct RTCFilterFunctionNArguments *args)
{
    sightline *line = (sightline *)(void *)args->context;
    const struct RTCHit *hit = (const struct RTCHit *)(const void *)args->hit;
    line->geometry = hit->geomID;
    line->primitive = hit->primID;
}

/* Asks Embree. The ray starts at `to`, the common end of many sightlines;
 * is_to_inside: `to` is within s->reach. */
static INTO_COPIES bool is_blocked(const murk_surfaces *s, sightline *line,
                                   murk_vec3 from, murk_vec3 to,
                                   bool is_to_inside, unsigned mask)
{
    murk_ray_context *context = &line->context;
    line->geometry = RTC_INVALID_GEOMETRY_ID;
    if (!segment_between(s, to, is_to_inside, from, &context->origin,
                         &context->direction)) {
        return false;
    }
    murk_ray_set(&line->ray, context->origin, context->direction, 1, mask);
    murk_embree_occluded(s->scene, &context->embree, &line->ray,
                         record_occluder);
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
    return is_blocked(s, &line, from, to, is_inside_reach(s, to),
                      through_sheets ? MURK_MASK_BLOCKS : MURK_MASK_ALL);
}

/* Four planes: a point is inside if normal . point + offset > 0 for all of
 * them. Three planes pass through the eye and an edge; the fourth is the
 * plane of the triangle. */
typedef struct shadow {
    murk_vec3 normal[4];
    double offset[4];
} shadow;

/* Computes the shadow; false if the triangle has none that is certain. unit_m:
 * a float step (geometry/ray_scene.h); farthest_m: no queried point is farther
 * from the eye. */
static bool make_shadow(shadow *s, const murk_triangle *triangle, murk_vec3 eye,
                        double unit_m, double farthest_m)
{
    /* Orient the normal away from the eye. */
    const double margin = MARGIN_UNITS * unit_m;
    const double nearest = sqrt(murk_triangle_distance2(triangle, eye));
    murk_vec3 normal = murk_unit(murk_triangle_normal(triangle));
    double height = murk_dot(murk_sub(triangle->a, eye), normal);
    const bool is_turned = height < 0;
    if (is_turned) {
        normal = murk_scale(-1, normal);
        height = -height;
    }
    if (!(height > margin)) {
        return false;
    }
    /* The plane of the triangle: points behind the plane by more than the
     * margin. */
    s->normal[3] = normal;
    s->offset[3] = -murk_dot(normal, triangle->a) - margin;
    /* The planes through the eye and each edge. A ray that is d off such a
     * plane at the far end is at least d * nearest / farthest off where the ray
     * passes the edge. */
    const double side_margin = margin * farthest_m / nearest;
    const murk_vec3 corner[3] = {
        murk_sub(triangle->a, eye),
        murk_sub(is_turned ? triangle->c : triangle->b, eye),
        murk_sub(is_turned ? triangle->b : triangle->c, eye)};
    for (int i = 0; i < 3; ++i) {
        const murk_vec3 side =
            murk_unit(murk_cross(corner[i], corner[(i + 1) % 3]));
        /* Not finite if the eye is on the line of the edge. */
        if (!murk_is_finite(side)) {
            return false;
        }
        s->normal[i] = side;
        s->offset[i] = -murk_dot(side, eye) - side_margin;
    }
    return true;
}

/* The occlusion cache: shadows of triangles that have blocked rays to one
 * point, the eye. Element [i][k] of the arrays belongs to plane i of shadow k,
 * so that a point is tested against all shadows in a few wide operations. */
typedef struct occlusion_cache {
    double x[4][SHADOWS], y[4][SHADOWS], z[4][SHADOWS], offset[4][SHADOWS];
    murk_vec3 eye; /* relative to the anchor, like all positions in the cache */
    double farthest_m;
    size_t oldest;        /* the shadow that is replaced next */
    size_t last_occluder; /* the last occluder that Embree reported. A shadow is
                             constructed only if the same triangle is reported
                             twice in succession, so that scattered sightlines
                             cost little */
} occlusion_cache;

/* The height of a point above plane i of shadow k. */
static INTO_COPIES double height_above(const occlusion_cache *cache, int i,
                                       int k, murk_vec3 p)
{
    return cache->x[i][k] * p.x + cache->y[i][k] * p.y + cache->z[i][k] * p.z +
           cache->offset[i][k];
}

/* True if the point is inside one of the cached shadows: for one of them the
 * lowest of the four heights is positive. All planes are computed, because a
 * branch after each plane is hard to predict and costs more than the planes
 * that it saves. */
static INTO_COPIES bool is_occluded_by_cached(const occlusion_cache *cache,
                                              murk_vec3 p)
{
    double lowest[SHADOWS];
    for (int k = 0; k < SHADOWS; ++k) {
        lowest[k] = height_above(cache, 0, k, p);
    }
#pragma GCC unroll 4
    for (int i = 1; i < 4; ++i) {
        for (int k = 0; k < SHADOWS; ++k) {
            const double of_plane = height_above(cache, i, k, p);
            lowest[k] = of_plane < lowest[k] ? of_plane : lowest[k];
        }
    }
    double highest = lowest[0];
    for (int k = 1; k < SHADOWS; ++k) {
        highest = lowest[k] > highest ? lowest[k] : highest;
    }
    return highest > 0;
}

/* Adds the shadow of the reported occluder to the cache. */
static void cache_occluder(occlusion_cache *cache, const murk_surfaces *s,
                           const sightline *line)
{
    shadow of_triangle;
    /* Spheres have no shadow planes. */
    if (line->geometry >= MURK_FACES) {
        return;
    }
    const size_t index =
        s->soup.first_triangle[line->geometry] + line->primitive;
    /* Wait for the second report of the same triangle. */
    if (index != cache->last_occluder) {
        cache->last_occluder = index;
        return;
    }
    /* Replace the oldest shadow. */
    const murk_triangle t = murk_soup_triangle(&s->soup, index);
    if (!make_shadow(&of_triangle, &t, cache->eye, s->unit_m,
                     cache->farthest_m)) {
        return;
    }
    const size_t k = cache->oldest;
    cache->oldest = (k + 1) % SHADOWS;
    for (int i = 0; i < 4; ++i) {
        cache->x[i][k] = of_triangle.normal[i].x;
        cache->y[i][k] = of_triangle.normal[i].y;
        cache->z[i][k] = of_triangle.normal[i].z;
        cache->offset[i][k] = of_triangle.offset[i];
    }
}

WIDE_CLONES
void murk_surfaces_blocked_many(const murk_surfaces *s, const murk_vec3 *from,
                                size_t n, murk_vec3 to, bool through_sheets,
                                bool *blocked)
{
    const unsigned mask = through_sheets ? MURK_MASK_BLOCKS : MURK_MASK_ALL;
    occlusion_cache cache;
    memset(&cache, 0, sizeof cache);
    for (int k = 0; k < SHADOWS; ++k) {
        cache.offset[0][k] = -INFINITY; /* an empty shadow: contains no point */
    }
    cache.last_occluder = SIZE_MAX;
    cache.eye = murk_sub(to, s->soup.anchor);
    cache.farthest_m = murk_length(murk_sub(s->reach.max, s->reach.min));
    const bool is_to_inside = is_inside_reach(s, to);
    sightline line;
    murk_embree_context_init(&line.context.embree);
    for (size_t i = 0; i < n; ++i) {
        /* A certain answer from the cache, else ask Embree. */
        const murk_vec3 p = murk_sub(from[i], s->soup.anchor);
        if (is_occluded_by_cached(&cache, p) &&
            murk_box_contains(&s->reach, p)) {
            blocked[i] = true;
            continue;
        }
        blocked[i] =
            s->scene && is_blocked(s, &line, from[i], to, is_to_inside, mask);
        if (blocked[i] && is_to_inside) {
            cache_occluder(&cache, s, &line);
        }
    }
}
