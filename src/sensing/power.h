/* How much light a sensor takes up from where a photon is stored (detection:
 * power), and the chance that it notices. Internal to the room.
 *
 * A packet's power falls as more are traced, so the place is judged, not the
 * packet. With r the radius of the estimate, and of the photon's own band,
 *     surface   L = (power leaving on the same side within r) / (pi^2 r^2)
 *               [W/m2/sr], as if it left by the cosine law,
 *     volume    j = (powers within r, each times p(w_k . w)) / (4/3 pi r^3)
 *               [W/m3/sr] in direction w to the sensor, w_k the direction of
 *               the arriving light and p the phase function of its medium.
 * Which photons count, and how far the radius reaches, is for
 * sensing/neighbours.h or, with a fixed radius, sensing/vicinity.h: where
 * photons are judged, not those of their own path.
 * Near edges and corners a ball reaches beyond the surface or the medium, so L
 * and j are too low there within r; a spot smaller than r is spread over it.
 *
 * A target of area a0 (or volume v0) there, turned as the surface is, sends
 *     s = T L a0 cos(theta) A cos(alpha) / (d^2 + A / pi)          [W], or
 *     s = T j v0 A cos(alpha) / (d^2 + A / pi)
 * through an aperture A: alpha off the sensor's axis (0 for one that sees all
 * round), theta off the normal; A / pi keeps what is near within the half space
 * that an aperture can take up. Across a boundary d is the apparent distance,
 * in the sensor's index, and radiance there is (n sensor / n target)^2 of what
 * it was: together that is what a bundle carries, whichever end it is seen
 * from.
 *
 * The chance is that of at least one count, p = 1 - exp(-eta s), eta =
 * exposure * quantum efficiency * wavelength / (h c), of photons in Poisson's
 * law; dark counts and light from elsewhere are left out. Chances of several
 * sensors are independent.
 *
 * Source: Jensen, Realistic Image Synthesis Using Photon Mapping, 2001 (density
 * estimates). */
#ifndef MURK_SENSING_POWER_H
#define MURK_SENSING_POWER_H

#include "medium/media.h"
#include "photonmap/map.h"
#include "sensing/across.h"
#include "sensing/power_settings.h"
#include "sensing/sensor.h"

/* Photons around each that are looked at, on average at most. Volume estimates
 * depend on the direction, so those are kept. */
#define MURK_POWER_SURFACE_MAX 512
#define MURK_POWER_VOLUME_MAX  128

/* Planck's constant times the speed of light [J m], exact by definition. */
#define MURK_PLANCK_LIGHT (6.62607015e-34 * 299792458.)

typedef struct murk_power murk_power;

typedef struct murk_power_desc {
    /* Places to be judged: the light's own maps, or others. Borrowed, as the
     * rest is. */
    const murk_photon_map *surface_map, *volume_map;
    murk_power_light light;
    const murk_media *media;
    const murk_domain *domain;
    double radius_m;   /* as murk_power_check_radius() lets it */
    size_t neighbours; /* 0: all within radius_m; else, at least 2, as far as
                          so many reach, radius_m at most */
    unsigned threads;
} murk_power_desc;

/* Takes up to 550 bytes a place of the volume map, 4 of the surface map, and 40
 * a photon of the light's; over threads, with progress. Fails with
 * MURK_BAD_VALUE (radius), MURK_BAD_FILE (a record of no medium),
 * MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_power_create(murk_power **out, const murk_power_desc *desc,
                              murk_error *err);
void murk_power_destroy(murk_power *power); /* NULL is fine */

/* Places that fewer than MURK_POWER_FEW photons tell of. */
size_t murk_power_few(const murk_power *power);

/* L at place i of the surface map [W/m2/sr]. */
double murk_power_radiance(const murk_power *power, size_t i);

/* j at place i of the volume map, for light that goes on along unit `toward`
 * [W/m3/sr]. */
double murk_power_source(const murk_power *power, size_t i, murk_vec3 toward);

/* s of place i of its map by one way [W]. */
double murk_power_signal_w(const murk_power *power,
                           const murk_sensor_type *type,
                           const murk_field *field, const murk_photon *photon,
                           size_t i, const murk_sightline *line);

/* MURK_BAD_VALUE when aperture, efficiency, exposure or targets are out of
 * range. */
murk_status murk_power_check_type(const murk_sensor_type *type,
                                  murk_error *err);

/* p of a signal at a wavelength. */
double murk_power_chance(const murk_sensor_type *type, double signal_w,
                         double wavelength_nm);

#endif
