/* Which lights shadow rays from a place are sent to, and in a periodic domain
 * which images of a lamp. */
#ifndef MURK_RENDER_CHOICE_H
#define MURK_RENDER_CHOICE_H

#include "render/scenery.h"

/* With more lights than this, so many shadow rays are shared out. */
#define MURK_LIGHTMAPS_AT_ONCE 4

/* Where shadow rays start. */
typedef struct murk_shadow_origin {
    int band;
    murk_vec3 position;
    bool is_surface;
    murk_vec3 normal; /* of a surface: unit, to the side that is lit */
} murk_shadow_origin;

/* Fills rays[scenery->n_lit[band]]: the mean number of shadow rays to each
 * light that has power in the band; their sum is MURK_LIGHTMAPS_AT_ONCE, or
 * each is 1 where there are no more lights than that. It is 0 only where a lamp
 * cannot light the place. */
void murk_choice_rays(const murk_scenery *scenery,
                      const murk_shadow_origin *outlook,
                      double rays[MURK_SOURCES_MAX]);

/* Images of a lamp in a periodic domain, as a place looks for them. */
typedef struct murk_source_images {
    double period_m[2]; /* in x and y */
    double away_m[2];   /* from the place to the lamp's own middle */
    double height_m, size_m;
    double nearest[2];     /* the nearest image: periods from the lamp itself */
    double weight[9], sum; /* of the nearest image and its neighbours */
} murk_source_images;

murk_source_images murk_images_of(const murk_scenery *scenery, size_t light,
                                  murk_vec3 place);

/* Draws the image that is `periods` away from the lamp itself, by four numbers
 * in (0, 1). Returns its chance, which is murk_images_chance(); 0: it is too
 * far to be looked for. */
double murk_images_draw(const murk_source_images *images, const double u[4],
                        double periods[2]);
double murk_images_chance(const murk_source_images *images,
                          const double periods[2]);

#endif
