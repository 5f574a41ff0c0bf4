/* A light as a place sees it: the counterpart of murk_sources_emit(), for what
 * looks at lights instead of starting photons from them.
 *
 * Everything is for clear air and an open view; what stands or floats between
 * is the caller's. Lamps are no surfaces: light passes through them, and each
 * is seen by its shining side alone. Light that is aimed at portals comes along
 * lines that pass one of them inward. */
#ifndef MURK_SOURCE_SHINE_H
#define MURK_SOURCE_SHINE_H

#include "source/sources.h"

/* Light that arrives at a place. */
typedef struct murk_shine {
    murk_vec3 direction; /* unit, of travel */
    double distance_m; /* back to the lamp; INFINITY: from beyond the domain */
    murk_vec3 face;    /* lamps: unit, where the lamp's face looks to there */
    double irradiance_w_per_m2; /* across the direction */
    double per_sr; /* how densely such directions are drawn; INFINITY: there is
                      but the one */
} murk_shine;

/* Whether murk_sources_shine() can find the light: not so of a beam without
 * width, which no place lies in. */
bool murk_sources_can_shine(const murk_sources *lights, size_t light);

#define MURK_SHINE_NUMBERS 3

/* One way in which the light reaches the place, for numbers in (0, 1): the mean
 * over them of irradiance * f(direction) is the integral of radiance * f over
 * all directions, whatever f is. False: none for these numbers. */
bool murk_sources_shine(const murk_sources *lights, size_t light, int band,
                        murk_vec3 place, const double u[MURK_SHINE_NUMBERS],
                        murk_shine *shine);

/* A light as it is looked at. */
typedef struct murk_glare {
    double radiance;   /* [W/m2/sr]; 0: none */
    double distance_m; /* INFINITY: beyond the domain */
    double per_sr; /* how densely murk_sources_shine() draws this direction */
} murk_glare;

/* What the light sends to the place against unit direction `sight`. Parallel
 * and point-like light is not seen. */
murk_glare murk_sources_glare(const murk_sources *lights, size_t light,
                              int band, murk_vec3 place, murk_vec3 sight);

#endif
