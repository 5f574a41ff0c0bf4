/* Converts the light sources of a scene into murk_source (source/source.h):
 * computes the positions of sun and moon, the irradiance of sun, moon, sky and
 * night sky, and which lamps are on at the time of the scene.
 *
 * Computed irradiances are those under the atmosphere of the earth and hold at
 * the boundary of the domain. Irradiances that the scene gives replace them. */
#ifndef MURK_WORLD_SKY_H
#define MURK_WORLD_SKY_H

#include "base/status.h"
#include "scene/scene.h"
#include "source/solar_spectrum.h"
#include "source/sources.h"

/* Properties that were computed for one light source of the scene. */
typedef struct murk_sky_facts {
    bool is_on;           /* true if the source has power in any band at the
                           * time of the scene; false, for example, for a lamp
                           * that is off by its schedule or a sun that has set
                           */
    double azimuth_deg;   /* azimuth of sun or moon, for a light of type sky
                           * that of the sun; clockwise from north; NAN for
                           * other sources, night skies included */
    double elevation_deg; /* apparent elevation of the same body; NAN for other
                           * sources */
    double irradiance_w_per_m2;   /* of distant light, summed over the bands:
                                   * normal to the beam for sun, moon and
                                   * directional light, on a level plane for
                                   * skies; NAN for lamps */
    murk_solar_spectrum spectrum; /* spectrum of sun, moon and skies; without
                                   * nodes for other sources */
    const murk_lamp_spectrum *lamp_spectrum; /* of other sources; NULL: their
                                              * power is even within a band */
} murk_sky_facts;

/* Converts a lamp or directional light without its portals; the schedule is
 * ignored. (Sun, moon and skies become a source of the same type without a
 * computed direction or irradiance.) The result borrows from the scene. */
murk_source murk_sky_lamp(const murk_scene_light *light);

/* Converts the light source with the index `light` of the scene, without its
 * portals. *out borrows from the scene. Every element of out->power_w is 0 if
 * the source does not emit at the time of the scene. *facts receives the
 * properties that were computed. Fails with MURK_BAD_VALUE at the place of the
 * light source: for sun, moon, sky and the schedule night if the ephemeris does
 * not cover the time, and for the schedule night also if the scene has no
 * latitude or longitude. */
murk_status murk_sky_light(murk_source *out, murk_sky_facts *facts,
                           const murk_scene_desc *scene, size_t light,
                           murk_error *err);

/* Converts all light sources of the scene, with their portals:
 * (*out)[scene->n_lights], which the caller frees with free(), together with
 * the portals. facts[scene->n_lights] receives the properties that were
 * computed; facts may be NULL if they are not wanted. Fails as
 * murk_sky_light(), or with MURK_NO_MEMORY. */
murk_status murk_sky_lights(murk_source **out, murk_sky_facts *facts,
                            const murk_scene_desc *scene, murk_error *err);

#endif
