/* One set of names for the calls that differ between Embree 3 and 4.
 *
 * Only files of src/geometry include this one. Embree 4 calls the intersection
 * context of Embree 3 a ray query context and takes it inside an argument
 * struct. */
#ifndef MURK_GEOMETRY_EMBREE_H
#define MURK_GEOMETRY_EMBREE_H

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>

/* Robust traversal, and a filter function may be given with each query. */
#define MURK_EMBREE_FLAGS \
    (RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION)

typedef struct RTCIntersectContext murk_embree_context;

static inline void murk_embree_context_init(murk_embree_context *context)
{
    rtcInitIntersectContext(context);
}

static inline void murk_embree_intersect(RTCScene scene,
                                         murk_embree_context *context,
                                         struct RTCRayHit *ray)
{
    rtcIntersect1(scene, context, ray);
}

static inline void murk_embree_occluded(RTCScene scene,
                                        murk_embree_context *context,
                                        struct RTCRay *ray,
                                        RTCFilterFunctionN filter)
{
    context->filter = filter;
    rtcOccluded1(scene, context, ray);
}

#else
#include <embree4/rtcore.h>

#define MURK_EMBREE_FLAGS \
    (RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS)

typedef struct RTCRayQueryContext murk_embree_context;

static inline void murk_embree_context_init(murk_embree_context *context)
{
    rtcInitRayQueryContext(context);
}

static inline void murk_embree_intersect(RTCScene scene,
                                         murk_embree_context *context,
                                         struct RTCRayHit *ray)
{
    struct RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = context;
    rtcIntersect1(scene, ray, &arguments);
}

static inline void murk_embree_occluded(RTCScene scene,
                                        murk_embree_context *context,
                                        struct RTCRay *ray,
                                        RTCFilterFunctionN filter)
{
    struct RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    arguments.filter = filter;
    arguments.context = context;
    rtcOccluded1(scene, ray, &arguments);
}

#endif
#endif
