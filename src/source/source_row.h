/* One row of functions for each type of light source. Private to this room.
 *
 * The rows of lamps are in lamps.c, those of distant light in distant.c. */
#ifndef MURK_SOURCE_SOURCE_ROW_H
#define MURK_SOURCE_SOURCE_ROW_H

#include "source/shine.h"
#include "source/source_state.h"

typedef struct murk_source_row {
    /* Checks s->light against s->domain and fills the rest of *s; for light
     * that is given by irradiance also s->power_scale. */
    murk_status (*prepare)(murk_source_state *s, murk_error *err);
    /* The start of a photon. */
    murk_ray (*emit)(const murk_source_state *s,
                     const double u[MURK_ENTRY_FACES_NUMBERS]);
    /* As murk_sources_shine(); *shine is {0} but for distance_m and per_sr,
     * which are infinite. */
    bool (*shine)(const murk_source_state *s, int band, murk_vec3 place,
                  const double u[MURK_SHINE_NUMBERS], murk_shine *shine);
    /* As murk_sources_glare(). NULL: the light cannot be looked at. */
    murk_glare (*glare)(const murk_source_state *s, int band, murk_vec3 place,
                        murk_vec3 sight);
    /* False for a light that reaches no place by chance. NULL: true. */
    bool (*can_shine)(const murk_source *light);
    /* Of lamps: the box around the lamp, and the largest distance from the
     * middle of the box. */
    murk_box (*box)(const murk_source *light);
    double (*extent_m)(const murk_source *light);
    /* The middle of the lamp. NULL: its position. */
    murk_vec3 (*middle)(const murk_source *light);
    /* Unit normal of a flat lamp. NULL: it is not flat. */
    murk_vec3 (*normal)(const murk_source *light);
    /* Estimate for murk_source_irradiance_near(). NULL: of a point. */
    double (*irradiance_near)(const murk_source *light, int band, murk_vec3 way,
                              bool has_images);
} murk_source_row;

/* Indexed by murk_source_type; NULL for the types of the other file. */
extern const murk_source_row *const murk_source_lamp_rows[];

/* Of every light that is no lamp. */
const murk_source_row *murk_source_distant_row(const murk_source *light);

const murk_source_row *murk_source_row_of(const murk_source *light);

/* ---- checks that several types share ---- */

/* Refuses a point, grown by `reach` along each axis, that is not inside. */
murk_status murk_source_check_inside(const murk_domain *domain, murk_vec3 p,
                                     murk_vec3 reach, const char *what,
                                     const char *where, murk_error *err);

/* A parallelogram of a lamp or a portal; what: "the lamp's". */
murk_status murk_source_check_sheet(const murk_portal *sheet,
                                    const murk_domain *domain, const char *what,
                                    const char *where, murk_error *err);

/* Makes the direction of the light unit; refuses one that points nowhere. */
murk_status murk_source_prepare_direction(murk_source_state *s,
                                          murk_error *err);

/* How far along unit `travel` from the place the line passes a portal inward,
 * and the cosine there; false if it does not. */
bool murk_source_passes(const murk_portal *portal, murk_vec3 place,
                        murk_vec3 travel, double *ahead_m, double *cosine);

#endif
