#include "medium/course.h"

#include <assert.h>

void murk_course_begin(murk_flight_state *course, const murk_place *place,
                       int band, murk_vec3 origin, murk_vec3 direction,
                       double t0, double t1)
{
    assert(place->filling != MURK_FILLED_EVENLY);
    course->filling = place->filling;
    if (place->filling == MURK_FILLED_BY_LAYERS) {
        murk_vec3 o = origin, d = direction;
        if (place->is_moved) {
            o = murk_affine_point(&place->to_local, origin);
            d = murk_affine_direction(&place->to_local, direction);
        }
        murk_layers_begin(&course->in.layers, place->profile, band, o.z, d.z,
                          t0, t1);
        return;
    }
    const murk_vec3 o = murk_affine_point(&place->to_index, origin);
    const murk_vec3 d = murk_affine_direction(&place->to_index, direction);
    if (place->filling == MURK_FILLED_BY_NEAREST) {
        murk_march_begin(&course->in.march, place->tree, o, d, t0, t1);
    } else {
        murk_linear_begin(&course->in.linear, place->tree, o, d, t0, t1);
    }
}

bool murk_course_next(murk_flight_state *course)
{
    switch (course->filling) {
    case MURK_FILLED_BY_NEAREST:
        return murk_march_next(&course->in.march);
    case MURK_FILLED_BY_LINEAR:
        return murk_linear_next(&course->in.linear);
    case MURK_FILLED_BY_LAYERS:
        return murk_layers_next(&course->in.layers);
    case MURK_FILLED_EVENLY:
        break;
    }
    return false;
}

double murk_course_to(const murk_flight_state *course)
{
    switch (course->filling) {
    case MURK_FILLED_BY_NEAREST:
        return course->in.march.to;
    case MURK_FILLED_BY_LINEAR:
        return course->in.linear.to;
    case MURK_FILLED_BY_LAYERS:
        return course->in.layers.to;
    case MURK_FILLED_EVENLY:
        break;
    }
    return INFINITY;
}

murk_cubic murk_course_cubic(const murk_flight_state *course, double t0,
                             double t1)
{
    switch (course->filling) {
    case MURK_FILLED_BY_NEAREST:
        return (murk_cubic){{course->in.march.value, 0, 0, 0}};
    case MURK_FILLED_BY_LINEAR:
        return murk_linear_cubic(&course->in.linear, t0, t1);
    case MURK_FILLED_BY_LAYERS:
        return murk_layers_cubic(&course->in.layers, t0, t1);
    case MURK_FILLED_EVENLY:
        break;
    }
    return (murk_cubic){{0}};
}

bool murk_course_integrate(murk_flight_state *course, double scale,
                           double offset, double limit, double *sum,
                           double *stop, double *density)
{
    murk_march *march = &course->in.march;
    murk_linear *linear = &course->in.linear;
    murk_layers *layers = &course->in.layers;
    bool stops = false;
    switch (course->filling) {
    case MURK_FILLED_BY_NEAREST:
        stops = murk_march_integrate(march, scale, offset, limit, sum);
        *stop = march->to;
        *density = march->value;
        break;
    case MURK_FILLED_BY_LINEAR:
        stops = murk_linear_integrate(linear, scale, offset, limit, sum);
        *stop = linear->to;
        *density = linear->value;
        break;
    case MURK_FILLED_BY_LAYERS:
        stops = murk_layers_integrate(layers, scale, offset, limit, sum);
        *stop = layers->to;
        *density = layers->value;
        break;
    case MURK_FILLED_EVENLY:
        break;
    }
    return stops;
}
