/* Selects the lights, and in a periodic domain the images of a lamp, to which
 * shadow rays are sent. */
#ifndef MURK_RENDER_CHOICE_H
#define MURK_RENDER_CHOICE_H

#include "medium/phase.h"
#include "render/scenery.h"

/* The number of shadow rays from a point if more lights than this have power in
 * the band; otherwise one ray goes to each of these lights. */
#define MURK_LIGHTS_AT_ONCE 4

/* A point at which light is scattered or reflected towards the viewer. */
typedef struct murk_shading_point {
    int band;
    murk_vec3 position;
    murk_vec3 sight;  /* unit direction of the viewing ray that arrives at the
                       * point */
    double index;     /* refractive index at the point */
    bool is_in_solid; /* inside a solid, where no shadow ray is sent */
    /* a surface: */
    murk_vec3 normal; /* unit normal towards the viewer */
    double diffuse;   /* diffuse reflectance */
    /* a medium, if phase is not NULL: */
    const murk_phase *phase;
    double albedo;
    double cone; /* cosine: light that is scattered by a smaller angle is found
                  * by continuing the ray, not from the maps; -1 all, 1 none */
} murk_shading_point;

/* Fills rays[scenery->n_lit[band]] with the mean number of shadow rays to each
 * light that has power in the band. The sum is MURK_LIGHTS_AT_ONCE, or each
 * number is 1 if there are no more lights than that. Each number is above 0.
 * The order is that of scenery->lit[band]. */
void murk_choice_rays(const murk_scenery *scenery,
                      const murk_shading_point *place,
                      double rays[MURK_SOURCES_MAX]);

/* The images of a lamp in a periodic domain as seen from a point. */
typedef struct murk_source_images {
    double period_m[2]; /* in x and y */
    double away_m[2];   /* from the point to the center of the lamp itself */
    double height_m, size_m;
    double nearest[2];     /* nearest image: periods from the lamp itself */
    double weight[9], sum; /* of the nearest image and the adjacent ones */
} murk_source_images;

murk_source_images murk_images_of(const murk_scenery *scenery, size_t light,
                                  murk_vec3 place);

/* Draws an image by four numbers in (0, 1), and sets periods[] to the
 * displacement of the image from the lamp itself, in periods along x and y.
 * Returns the probability of this image, murk_images_chance(); 0 if the image
 * is too far away to be sampled. */
double murk_images_draw(const murk_source_images *images, const double u[4],
                        double periods[2]);
double murk_images_chance(const murk_source_images *images,
                          const double periods[2]);

#endif
