/* Walk of a ray through a profile: extinction as a function of height,
 * linear between the given heights and therefore linear along the ray within
 * a layer. No extinction below the first and above the last height. For
 * use inside src/medium only. */
#ifndef MURK_MEDIUM_LAYERS_H
#define MURK_MEDIUM_LAYERS_H

#include "medium/cubic.h"
#include "medium/media.h"

#include <stdbool.h>

typedef struct murk_layers {
    const murk_profile *profile;
    int band;
    double origin, direction; /* height along the ray: origin + t direction */
    double end;
    double from, to; /* the current segment */
    size_t layer; /* the layer of the segment: between heights layer and layer +
                     1 */
    bool is_begun;
    double value; /* extinction at the collision of murk_layers_integrate() */
} murk_layers;

/* Clips [*t0, *t1] to the range of heights. False if nothing is left. */
bool murk_layers_clip(const murk_profile *profile, double origin,
                      double direction, double *t0, double *t1);

/* Starts a walk from t0 to t1, which lie in the interval of
 * murk_layers_clip(). */
void murk_layers_begin(murk_layers *layers, const murk_profile *profile,
                       int band, double origin, double direction, double t0,
                       double t1);

/* Advances to the next segment; false at the end. */
bool murk_layers_next(murk_layers *layers);

/* The extinction on the part [t0, t1] of the current segment: linear. */
murk_cubic murk_layers_cubic(const murk_layers *layers, double t0, double t1);

/* Integrates along the rest of the walk, like murk_linear_integrate(). */
bool murk_layers_integrate(murk_layers *layers, double scale, double offset,
                           double limit, double *sum);

/* True if z is at the first height or above and below the last; *density is
 * then the extinction there [1/m]. At a height that is given twice the value of
 * the upper layer applies. */
bool murk_layers_density(const murk_profile *profile, int band, double z,
                         double *density);

#endif
