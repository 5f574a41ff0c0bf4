/* The description of one light source, and the records in which light is
 * sampled: the start of a photon, and light that arrives at a point. */
#ifndef MURK_SOURCE_SOURCE_H
#define MURK_SOURCE_SOURCE_H

#include "base/bands.h"
#include "base/source_type.h"
#include "base/vector.h"
#include "luminaire/intensity.h"
#include "source/dome.h"

#include <stdbool.h>
#include <stddef.h>

/* The largest number of portals of one light, which bounds the search for the
 * first portal on a ray. */
#define MURK_PORTALS_MAX 256

/* The largest angular radius of a distant source: up to this radius the
 * radiance over the disc is constant within 2 % (source/disc.h). */
#define MURK_DISC_RAD_MAX 0.1

/* A portal, such as a window: a parallelogram through which distant light
 * passes towards edge1 x edge2. */
typedef struct murk_portal {
    murk_vec3 corner, edge1, edge2;
} murk_portal;

typedef struct murk_source {
    murk_source_type type;
    murk_vec3 position;     /* center of a sphere, corner of a rect, the point,
                             * center of the disc of a beam, center of the
                             * opening of a luminaire */
    murk_vec3 edge1, edge2; /* rect; luminaire: sides of a rectangular opening,
                             * along C = 0 and C = 90 degrees */
    murk_vec3 direction;    /* beam, directional: direction of travel;
                             * luminaire: photometric zero; any length */
    double radius_m;        /* sphere, beam; luminaire: of a round opening */
    double height_m;        /* luminaire: of luminous sides, along `direction`
                             * and centered on the position; 0: none, the
                             * opening is flat */
    const murk_intensity *intensity; /* luminaire: the distribution */
    murk_vec3 c0; /* luminaire: direction of C = 0, gamma = 90 degrees; made
                   * perpendicular to `direction`, any length */
    double divergence_rad;     /* beam: half angle of the cone */
    double angular_radius_rad; /* directional: angular radius of the source; 0:
                                * parallel rays */
    murk_dome dome;            /* dome: the distribution of radiance */
    bool is_part;              /* a part of daylight (world/daylight.h): where
                                * the light comes from is the same at all times,
                                * also while the part is dark */
    const murk_portal *portal; /* directional, dome: [portals], at which the
                                * light is aimed */
    size_t portals;            /* 0: the light is aimed at the domain */
    murk_spectrum power_w;     /* per band. Lamps: power [W]; directional:
                                * irradiance [W/m2] at right angles to the rays;
                                * dome: irradiance [W/m2] on a level plane; both
                                * irradiances are those at the boundary of the
                                * domain */
    const char *where;
} murk_source;

/* True for light from outside the domain: photons start on the boundary of the
 * domain. */
static inline bool murk_source_is_distant(const murk_source *light)
{
    return murk_source_type_group(light->type) != MURK_SOURCE_LAMP;
}

/* A box that contains a lamp, the smallest one except for beams; empty for
 * distant light. */
murk_box murk_source_box(const murk_source *light);

/* An upper limit [m] of the distance of the points of a lamp from the center of
 * the lamp. */
double murk_source_extent_m(const murk_source *lamp);

/* The unit normal of a lamp that is a rectangle, or the direction to which a
 * luminaire with a flat opening sends most of its light: along the aim or
 * against it; `otherwise` for other light. */
murk_vec3 murk_source_face(const murk_source *light, murk_vec3 otherwise);

/* Estimate of the irradiance [W/m2] that a lamp gives at a point, on a plane
 * that faces the lamp, without media and occluders. For a lamp without extent
 * and a distance of 0, the power [W] is returned instead. to_lamp: from the
 * point to the center of the lamp. A point behind a rectangle or outside a beam
 * gets 0; a luminaire counts by its intensity in the direction of the point.
 * has_images: the domain is periodic, so a point behind a rectangle may be lit
 * by an image of the rectangle and may have an estimate, too, unless the
 * rectangle is level; a luminaire counts as even in all directions. */
double murk_source_irradiance_near(const murk_source *lamp, int band,
                                   murk_vec3 to_lamp, bool has_images);

/* The start of a photon. */
typedef struct murk_ray {
    murk_vec3 origin, direction;
    bool is_spent; /* the photon ends where it starts: the ray is drawn from a
                    * portal that is not the first on the ray, or roulette has
                    * removed the photon outside of the domain
                    * (transport/walk.c) */
} murk_ray;

#define MURK_SHINE_NUMBERS 3 /* a point, and the number of a portal */

/* Light that arrives at a point from one direction. */
typedef struct murk_shine {
    murk_vec3 direction; /* unit direction of travel */
    double distance_m; /* back to the lamp; INFINITY: from outside the domain */
    murk_vec3 face;    /* lamps: unit normal of the emitting face at the start;
                        * a point: the direction */
    double irradiance_w_per_m2; /* on a plane at right angles to the
                                 * direction */
    double per_sr; /* probability density with which this direction is drawn
                    * [1/sr]; INFINITY: only one direction is possible */
} murk_shine;

/* A light source seen along a line of sight. */
typedef struct murk_glare {
    double radiance;   /* [W/m2/sr]; 0: none */
    double distance_m; /* INFINITY: outside the domain */
    double per_sr; /* probability density with which murk_sources_shine() draws
                      this direction [1/sr] */
} murk_glare;

/* The light sources of a scene (source/sources.h). */
typedef struct murk_sources murk_sources;

#endif
