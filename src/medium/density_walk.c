/* Walk along a ray through the density of a region: selects the walk for the
 * kind of density (march.h, linear.h, rectilinear.h or layers.h). */
#include "medium/density_walk.h"

#include <assert.h>

void murk_density_walk_begin(murk_density_walk *walk, const murk_place *place,
                             int band, murk_vec3 origin, murk_vec3 direction,
                             double t0, double t1)
{
    assert(place->filling != MURK_FILLED_EVENLY);
    walk->filling = place->filling;
    /* A profile depends only on the height in the frame of the region. */
    if (place->filling == MURK_FILLED_BY_LAYERS) {
        murk_vec3 o = origin, d = direction;
        if (place->is_moved) {
            o = murk_affine_point(&place->to_local, origin);
            d = murk_affine_direction(&place->to_local, direction);
        }
        murk_layers_begin(&walk->in.layers, place->profile, band, o.z, d.z, t0,
                          t1);
        return;
    }
    const murk_vec3 o = murk_affine_point(&place->to_index, origin);
    const murk_vec3 d = murk_affine_direction(&place->to_index, direction);
    /* A grid is walked in index space, a rectilinear one in metres. */
    if (place->filling == MURK_FILLED_BY_RECTILINEAR) {
        murk_rectilinear_begin(&walk->in.field, place->field, o, d, t0, t1);
    } else if (place->filling == MURK_FILLED_BY_NEAREST) {
        murk_march_begin(&walk->in.march, place->tree, o, d, t0, t1);
    } else {
        murk_linear_begin(&walk->in.linear, place->blocks, o, d, t0, t1);
    }
}

bool murk_density_walk_next(murk_density_walk *walk)
{
    switch (walk->filling) {
    case MURK_FILLED_BY_NEAREST:
        return murk_march_next(&walk->in.march);
    case MURK_FILLED_BY_LINEAR:
        return murk_linear_next(&walk->in.linear);
    case MURK_FILLED_BY_RECTILINEAR:
        return murk_rectilinear_next(&walk->in.field);
    case MURK_FILLED_BY_LAYERS:
        return murk_layers_next(&walk->in.layers);
    case MURK_FILLED_EVENLY:
        break;
    }
    return false;
}

double murk_density_walk_to(const murk_density_walk *walk)
{
    switch (walk->filling) {
    case MURK_FILLED_BY_NEAREST:
        return walk->in.march.ray.to;
    case MURK_FILLED_BY_LINEAR:
        return walk->in.linear.ray.to;
    case MURK_FILLED_BY_RECTILINEAR:
        return walk->in.field.to;
    case MURK_FILLED_BY_LAYERS:
        return walk->in.layers.to;
    case MURK_FILLED_EVENLY:
        break;
    }
    return INFINITY;
}

murk_cubic murk_density_walk_cubic(const murk_density_walk *walk, double t0,
                                   double t1)
{
    switch (walk->filling) {
    case MURK_FILLED_BY_NEAREST:
        return (murk_cubic){{walk->in.march.value, 0, 0, 0}};
    case MURK_FILLED_BY_LINEAR:
        return murk_linear_cubic(&walk->in.linear, t0, t1);
    case MURK_FILLED_BY_RECTILINEAR:
        return murk_rectilinear_cubic(&walk->in.field, t0, t1);
    case MURK_FILLED_BY_LAYERS:
        return murk_layers_cubic(&walk->in.layers, t0, t1);
    case MURK_FILLED_EVENLY:
        break;
    }
    return (murk_cubic){{0}};
}

bool murk_density_walk_integrate(murk_density_walk *walk, double scale,
                                 double offset, double limit, double *sum,
                                 double *collision_t, double *density)
{
    murk_march *march = &walk->in.march;
    murk_linear *linear = &walk->in.linear;
    murk_layers *layers = &walk->in.layers;
    murk_rectilinear_walk *field = &walk->in.field;
    bool collides = false;
    /* If the limit is reached, the walk has moved the end of its segment to the
     * collision and has stored the density there. */
    switch (walk->filling) {
    case MURK_FILLED_BY_NEAREST:
        collides = murk_march_integrate(march, scale, offset, limit, sum);
        *collision_t = march->ray.to;
        *density = march->value;
        break;
    case MURK_FILLED_BY_LINEAR:
        collides = murk_linear_integrate(linear, scale, offset, limit, sum);
        *collision_t = linear->ray.to;
        *density = linear->value;
        break;
    case MURK_FILLED_BY_RECTILINEAR:
        collides = murk_rectilinear_integrate(field, scale, offset, limit, sum);
        *collision_t = field->to;
        *density = field->value;
        break;
    case MURK_FILLED_BY_LAYERS:
        collides = murk_layers_integrate(layers, scale, offset, limit, sum);
        *collision_t = layers->to;
        *density = layers->value;
        break;
    case MURK_FILLED_EVENLY:
        break;
    }
    return collides;
}
