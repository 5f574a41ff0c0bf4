/* The scene's lights as the light room wants them: where sun and moon stand,
 * how much comes from them and from the sky, and which lamps are on.
 *
 * Irradiances are those of a real atmosphere, at the domain's boundary. */
#ifndef MURK_WORLD_SKY_H
#define MURK_WORLD_SKY_H

#include "base/status.h"
#include "scene/scene.h"
#include "source/solar_spectrum.h"
#include "source/sources.h"

/* What was found of one light. */
typedef struct murk_sky_facts {
    bool is_on;         /* lamps: by their schedule; else: any light from it */
    double azimuth_deg; /* sun, moon; sky: of the sun; clockwise from north */
    double elevation_deg;       /* of the same, apparent */
    double irradiance_w_per_m2; /* distant light, over all bands: sun, moon and
                                   directional at right angles to the beam,
                                   skies on a level plane */
    murk_solar_spectrum spectrum; /* of sun, moon and skies; else no nodes: even
                                     within a band */
} murk_sky_facts;

/* A light that is not of the sky, as the scene states it; it borrows from the
 * scene. */
murk_source murk_sky_lamp(const murk_scene_light *light);

/* One light of the scene; it borrows from the scene. All of its power_w is 0
 * where it does not shine at the scene's time. Fails at the light's place
 * where its time is not one that the ephemeris knows. */
murk_status murk_sky_light(murk_source *out, murk_sky_facts *facts,
                           const murk_scene_desc *scene, size_t light,
                           murk_error *err);

#endif
