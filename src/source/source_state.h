/* One light source after checking, with quantities for emission, and the row of
 * functions of each type of light source. For use inside src/source only.
 *
 * The rows of lamps are in lamps.c and luminaires.c, those of distant light in
 * distant.c. */
#ifndef MURK_SOURCE_SOURCE_STATE_H
#define MURK_SOURCE_SOURCE_STATE_H

#include "source/entry_faces.h"

typedef struct murk_source_state {
    murk_source light; /* direction normalised, c0 too and perpendicular to it;
                        * `where` and `portal` are copies, `intensity` is
                        * shared */
    const murk_domain *domain;
    bool is_dark;       /* without power */
    double power_scale; /* watts for each unit of power_w: an area in m2 if
                         * power_w is an irradiance, else 1 */
    murk_vec3 normal;   /* rect: unit normal of the emitting side */
    double cone;        /* beam: 1 - cos(half angle) */
    double face_end[3]; /* parallel light onto the domain: cumulative shares of
                         * the lit faces across x, y and z */
    murk_entry_faces *entry_faces; /* owned; NULL for lamps and for parallel
                                    * light onto the domain */
} murk_source_state;

/* Checks s->light against s->domain, both set by the caller, normalises the
 * direction of a beam or of directional light, and fills the rest of *s, which
 * must be zero. The caller releases *s with murk_source_state_release(), also
 * after a failure. */
murk_status murk_source_state_prepare(murk_source_state *s, size_t bands,
                                      murk_error *err);

/* The checked light of that index. */
const murk_source_state *murk_sources_state(const murk_sources *lights,
                                            size_t light);

void murk_source_state_release(murk_source_state *s);

/* The start of a photon inside the box of the domain, from uniform numbers.
 * Without entry faces the first four are used. */
murk_ray murk_source_state_emit(const murk_source_state *s,
                                const double u[MURK_ENTRY_FACES_NUMBERS]);

/* ---- one row of functions for each type ---- */

typedef struct murk_source_row {
    /* Checks s->light against s->domain and fills the rest of *s; for light
     * that is given by irradiance also s->power_scale. */
    murk_status (*prepare)(murk_source_state *s, murk_error *err);
    /* The start of a photon. */
    murk_ray (*emit)(const murk_source_state *s,
                     const double u[MURK_ENTRY_FACES_NUMBERS]);
    /* As murk_sources_shine(). The caller sets *shine to {0} except for
     * distance_m and per_sr, which are infinite. */
    bool (*shine)(const murk_source_state *s, int band, murk_vec3 place,
                  const double u[MURK_SHINE_NUMBERS], murk_shine *shine);
    /* As murk_sources_glare(). NULL: the light is invisible. */
    murk_glare (*glare)(const murk_source_state *s, int band, murk_vec3 place,
                        murk_vec3 sight);
    /* False for a light that cannot be sampled. NULL: true. */
    bool (*can_shine)(const murk_source *light);
    /* Lamps: a box that contains the lamp, and an upper limit of the distance
     * of the points of the lamp from the center. NULL for distant light. */
    murk_box (*box)(const murk_source *light);
    double (*extent_m)(const murk_source *light);
    /* The center of the lamp. NULL: the position. */
    murk_vec3 (*middle)(const murk_source *light);
    /* Unit normal of a rectangle or of a flat opening. NULL: murk_source_face()
     * returns the argument `otherwise`, as for spheres, points, beams and
     * distant light. */
    murk_vec3 (*normal)(const murk_source *light);
    /* Estimate for murk_source_irradiance_near(). NULL: that of a point. */
    double (*irradiance_near)(const murk_source *light, int band,
                              murk_vec3 to_lamp, bool has_images);
} murk_source_row;

/* Indexed by murk_source_type; for lamps but luminaires. */
extern const murk_source_row murk_source_lamp_rows[];
extern const murk_source_row murk_source_luminaire_row;

/* The row of a light that is no lamp. */
const murk_source_row *murk_source_distant_row(const murk_source *light);

/* The row of any light. */
const murk_source_row *murk_source_row_of(const murk_source *light);

/* ---- checks that several types share ---- */

/* Fails with MURK_BAD_VALUE if a point is not inside the domain with a margin
 * of `reach` along each axis, except for rounding. */
murk_status murk_source_check_inside(const murk_domain *domain, murk_vec3 p,
                                     murk_vec3 reach, const char *what,
                                     const char *where, murk_error *err);

/* Checks that the parallelogram of a lamp or a portal spans an area and lies in
 * the domain. what: the beginning of a message, such as "the lamp's". Fails
 * with MURK_BAD_VALUE. */
murk_status murk_source_check_sheet(const murk_portal *sheet,
                                    const murk_domain *domain, const char *what,
                                    const char *where, murk_error *err);

/* Normalises the direction of the light. Fails with MURK_BAD_VALUE for a
 * direction that has zero length or is not finite. */
murk_status murk_source_prepare_direction(murk_source_state *s,
                                          murk_error *err);

/* Intersects the line through the point `place` in the unit direction `travel`
 * with a portal: distance ahead (negative if the portal is behind `place`) and
 * cosine. Returns false if the line does not pass the portal inward. */
bool murk_source_passes(const murk_portal *portal, murk_vec3 place,
                        murk_vec3 travel, double *ahead_m, double *cosine);

#endif
