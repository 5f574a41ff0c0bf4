/* A ray through a layered medium: extinction by height, linear between the
 * heights given, and so along the ray within a layer. Nothing below the first
 * height and above the last. Inside this room only. */
#ifndef MURK_MEDIUM_LAYERS_H
#define MURK_MEDIUM_LAYERS_H

#include "medium/cubic.h"
#include "medium/media.h"

#include <stdbool.h>

typedef struct murk_layers {
    const murk_profile *profile;
    int band;
    double origin, direction; /* heights: origin + t direction */
    double end;
    double from, to; /* the present segment */
    size_t layer;    /* that it lies in: between heights layer and layer + 1 */
    bool is_begun;
    double value; /* where murk_layers_integrate() stopped */
} murk_layers;

/* Cuts [*t0, *t1] to the heights given. False when nothing is left. */
bool murk_layers_clip(const murk_profile *profile, double origin,
                      double direction, double *t0, double *t1);

/* Sets out from t0 to t1, both from murk_layers_clip() or between such. */
void murk_layers_begin(murk_layers *layers, const murk_profile *profile,
                       int band, double origin, double direction, double t0,
                       double t1);

/* The next segment; false at the end. */
bool murk_layers_next(murk_layers *layers);

/* The extinction over the part [t0, t1] of the present segment: a line. */
murk_cubic murk_layers_cubic(const murk_layers *layers, double t0, double t1);

/* As murk_linear_integrate(). */
bool murk_layers_integrate(murk_layers *layers, double scale, double offset,
                           double limit, double *sum);

/* Whether z lies between the heights given, and the extinction there [1/m]. A
 * height given twice belongs to the layer above it. */
bool murk_layers_density(const murk_profile *profile, int band, double z,
                         double *density);

#endif
