/* Builds an Embree scene from the soup: one triangle geometry and one user
 * geometry of spheres for each kind of face, selected by ray masks.
 *
 * Spheres are intersected in double precision by callbacks. Shared buffers
 * are used for triangles, so the soup must outlive the scene. */
#include "geometry/ray_scene.h"

#include "geometry/triangle.h"

#include <float.h>

/* One thread and no pinning: Embree must not start threads, because murk
 * forks and has a thread pool of its own. */
#define DEVICE_SETTINGS "threads=1,user_threads=1,set_affinity=0"

static void sphere_bounds(const struct RTCBoundsFunctionArguments *args)
{
    const murk_stored_sphere *b =
        (const murk_stored_sphere *)args->geometryUserPtr + args->primID;
    /* Enlarge the box by two float steps (2^-22) of the sum of the coordinates
     * and the radius, so that rounding cannot cut off a part of the sphere. */
    const double x = fabs(b->center.x), y = fabs(b->center.y),
                 z = fabs(b->center.z);
    const double r = b->radius + (x + y + z + b->radius) * 0x1p-22;
    *args->bounds_o = (struct RTCBounds){.lower_x = (float)(b->center.x - r),
                                         .lower_y = (float)(b->center.y - r),
                                         .lower_z = (float)(b->center.z - r),
                                         .upper_x = (float)(b->center.x + r),
                                         .upper_y = (float)(b->center.y + r),
                                         .upper_z = (float)(b->center.z + r)};
}

/* The first intersection in (tnear, tfar]; infinite if there is none. */
static float sphere_crossing(const murk_stored_sphere *sphere,
                             const void *context, float tnear, float tfar)
{
    const murk_ray_context *ray = context;
    double t[2];
    if (murk_sphere_roots(sphere->center, sphere->radius, ray->origin,
                          ray->direction, t)) {
        for (int i = 0; i < 2; ++i) {
            const float crossing = (float)t[i];
            if (crossing > tnear && crossing <= tfar) {
                return crossing;
            }
        }
    }
    return INFINITY;
}

static void sphere_intersect(const struct RTCIntersectFunctionNArguments *args)
{
    struct RTCRayHit *ray = (struct RTCRayHit *)args->rayhit;
    if (!args->valid[0]) {
        return;
    }
    const float t = sphere_crossing(
        (const murk_stored_sphere *)args->geometryUserPtr + args->primID,
        args->context, ray->ray.tnear, ray->ray.tfar);
    if (t < INFINITY) {
        ray->ray.tfar = t;
        ray->hit.u = ray->hit.v = 0;
        ray->hit.primID = args->primID;
        ray->hit.geomID = args->geomID;
        ray->hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    }
}

static void sphere_occluded(const struct RTCOccludedFunctionNArguments *args)
{
    struct RTCRay *ray = (struct RTCRay *)args->ray;
    if (args->valid[0] &&
        sphere_crossing((const murk_stored_sphere *)args->geometryUserPtr +
                            args->primID,
                        args->context, ray->tnear, ray->tfar) < INFINITY) {
        ray->tfar = -INFINITY;
    }
}

static void attach(murk_surfaces *s, RTCGeometry geometry, murk_face face,
                   unsigned number)
{
    rtcSetGeometryMask(geometry, MURK_MASK(face));
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_MEDIUM);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(s->scene, geometry, number);
    rtcReleaseGeometry(geometry);
}

static void attach_triangles(murk_surfaces *s, murk_face face)
{
    const murk_soup *soup = &s->soup;
    const size_t first = soup->first_triangle[face];
    const size_t n = soup->first_triangle[face + 1] - first;
    RTCGeometry geometry =
        n > 0 ? rtcNewGeometry(s->device, RTC_GEOMETRY_TYPE_TRIANGLE) : NULL;
    if (!geometry) {
        return;
    }
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                               RTC_FORMAT_FLOAT3, soup->vertex, 0,
                               3 * sizeof *soup->vertex, soup->vertices);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                               RTC_FORMAT_UINT3, soup->corner + 3 * first, 0,
                               3 * sizeof *soup->corner, n);
    attach(s, geometry, face, face);
}

static void attach_spheres(murk_surfaces *s, murk_face face)
{
    const murk_soup *soup = &s->soup;
    const size_t first = soup->first_sphere[face];
    const size_t n = soup->first_sphere[face + 1] - first;
    RTCGeometry geometry =
        n > 0 ? rtcNewGeometry(s->device, RTC_GEOMETRY_TYPE_USER) : NULL;
    if (!geometry) {
        return;
    }
    rtcSetGeometryUserPrimitiveCount(geometry, (unsigned)n);
    rtcSetGeometryUserData(geometry, soup->sphere + first);
    rtcSetGeometryBoundsFunction(geometry, sphere_bounds, NULL);
    rtcSetGeometryIntersectFunction(geometry, sphere_intersect);
    rtcSetGeometryOccludedFunction(geometry, sphere_occluded);
    attach(s, geometry, face, MURK_GEOMETRY_OF_SPHERES(face));
}

static bool count_memory(void *context, ssize_t bytes, bool post)
{
    (void)post;
    size_t *total = context;
    *total += (size_t)bytes; /* negative if memory is released */
    return true;
}

static murk_status embree_failed(murk_surfaces *s, murk_error *err)
{
    const enum RTCError code = rtcGetDeviceError(s->device);
    switch (code) {
    case RTC_ERROR_NONE:
        return MURK_OK;
    case RTC_ERROR_OUT_OF_MEMORY:
        return murk_no_memory(err, "geometry",
                              "to prepare rays through %zu triangles",
                              s->soup.triangles);
    default:
        return murk_fail(err, MURK_RUN_FAILED, "geometry",
                         "Embree cannot prepare rays through %zu triangles "
                         "(its error %d)",
                         s->soup.triangles, (int)code);
    }
}

murk_status murk_ray_scene_commit(murk_surfaces *s, murk_error *err)
{
    /* The device, which must support ray masks. */
    s->device = rtcNewDevice(DEVICE_SETTINGS);
    if (!s->device) {
        return murk_fail(err, MURK_NO_MEMORY, "geometry",
                         "Embree does not start (its error %d)",
                         (int)rtcGetDeviceError(NULL));
    }
    if (!rtcGetDeviceProperty(s->device,
                              RTC_DEVICE_PROPERTY_RAY_MASK_SUPPORTED)) {
        return murk_fail(err, MURK_UNSUPPORTED, "geometry",
                         "this build of Embree has no ray masks");
    }
    rtcSetDeviceMemoryMonitorFunction(s->device, count_memory,
                                      &s->embree_bytes);
    /* The scene, with one geometry for triangles and one for spheres of each
     * kind of face. */
    s->scene = rtcNewScene(s->device);
    if (s->scene) {
        rtcSetSceneFlags(s->scene, MURK_EMBREE_FLAGS);
        rtcSetSceneBuildQuality(s->scene, RTC_BUILD_QUALITY_MEDIUM);
        for (int face = 0; face < MURK_FACES; ++face) {
            attach_triangles(s, (murk_face)face);
            attach_spheres(s, (murk_face)face);
        }
        rtcCommitScene(s->scene);
    }
    return embree_failed(s, err);
}

void murk_ray_scene_release(murk_surfaces *s)
{
    if (s->scene) {
        rtcReleaseScene(s->scene);
    }
    if (s->device) {
        rtcReleaseDevice(s->device);
    }
    s->scene = NULL;
    s->device = NULL;
}

/* ---- neighbours of a point ---- */

typedef struct visiting {
    const murk_soup *soup;
    murk_visit visit;
    void *context;
    bool has_ended; /* Embree may still call for primitives of the same leaf */
} visiting;

/* Embree's point query. */
static bool visit_one(struct RTCPointQueryFunctionArguments *args)
{
    visiting *v = args->userPtr;
    const struct RTCHit hit = {.geomID = args->geomID, .primID = args->primID};
    if (v->has_ended ||
        !v->visit(v->context, murk_primitive_of(v->soup, &hit))) {
        return false;
    }
    v->has_ended = true;
    args->query->radius = 0; /* ends the query */
    return true;
}

void murk_ray_scene_visit(const murk_surfaces *s, murk_vec3 point,
                          double radius_m, murk_visit visit, void *context)
{
    visiting v = {.soup = &s->soup, .visit = visit, .context = context};
    /* The query is in single precision: enlarge the radius so that rounding
     * loses no surface at the rim. */
    const double size =
        fabs(point.x) + fabs(point.y) + fabs(point.z) + radius_m;
    struct RTCPointQuery query = {
        .x = (float)point.x,
        .y = (float)point.y,
        .z = (float)point.z,
        .radius = (float)(radius_m + s->leave_m + size * (double)FLT_EPSILON)};
    struct RTCPointQueryContext of_embree;
    rtcInitPointQueryContext(&of_embree);
    rtcPointQuery(s->scene, &query, &of_embree, visit_one, &v);
}
