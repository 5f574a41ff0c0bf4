/* Detection by power: the light that a sensor receives from the place of a
 * stored photon, and the probability of detection. For use inside src/sensing
 * only.
 *
 * The power of a packet falls as more packets are traced, so detection is
 * decided by the light at the place of the stored photon, not by the power of
 * the packet. With r the radius of the estimate, in the photon's band,
 *
 *     surface   L = (power leaving on the same side within r) / (pi^2 r^2)
 *               [W/m2/sr], as if light left by the cosine law,
 *     volume    j = (powers within r, each times p(w_k . w)) / (4/3 pi r^3)
 *               [W/m3/sr] in direction w to the sensor; w_k is the direction of
 *               the arriving light and p the phase function of the medium.
 *
 * The photons of the estimate and the radius come from sensing/neighbours.h or,
 * for a fixed radius, from sensing/vicinity.h. If the nearest photons lie
 * within a thousandth of the maximum radius, that thousandth is used as a fixed
 * radius. A photon's own path is left out at the photon's own place. Near edges
 * and corners a ball extends beyond the surface or the medium, so L and j are
 * too low within r of them; a spot of light smaller than r is spread over r.
 *
 * A target of area a0 (or volume v0), turned like the surface, sends
 *
 *     s = T L a0 cos(theta) A cos(alpha) / (d^2 + A / pi)          [W], or
 *     s = T j v0 A cos(alpha) / (d^2 + A / pi)
 *
 * through an aperture A. T is the transmittance of the sightline and d the
 * length, alpha is the angle to the sensor's axis (0 for a type that sees all
 * round), theta the angle to the normal; A / pi limits near targets to the half
 * space that an aperture can receive. Across a boundary d is the apparent
 * distance in the sensor's index, and radiance there is (n sensor / n target)^2
 * of the radiance before: together a bundle of rays carries the same power seen
 * from either end.
 *
 * The probability is that of at least one count of a Poisson process: p = 1 -
 * exp(-eta s), eta = exposure * quantum efficiency * wavelength / (h c). Dark
 * counts and stray light are left out. Detections by several sensors are
 * independent.
 *
 * Source: Jensen, Realistic Image Synthesis Using Photon Mapping, 2001 (density
 * estimates). */
#ifndef MURK_SENSING_POWER_H
#define MURK_SENSING_POWER_H

#include "sensing/sight.h"

/* Maximum mean number of photons in an estimate with a fixed radius, for places
 * of the surface map and of the volume map. Volume estimates depend on the
 * direction, so their photons are stored, and fewer are used. */
#define MURK_POWER_SURFACE_MAX 512
#define MURK_POWER_VOLUME_MAX  128

/* Planck's constant times the speed of light [J m], exact by definition. */
#define MURK_PLANCK_LIGHT (6.62607015e-34 * 299792458.)

typedef struct murk_power murk_power;

/* A path of light from photon to sensor. */
typedef struct murk_sightline {
    double transmittance;
    /* from the sensor to the apparent position of the photon */
    murk_vec3 apparent;
    murk_vec3 leaving; /* unit direction in which light leaves the photon */
    double gain;       /* factor on radiance across the boundary: (n sensor / n
                          photon)^2 */
} murk_sightline;

/* For a description with desc->power.radius_m > 0. Copies desc and borrows
 * everything that desc points to. The places are those of the photons in desc's
 * maps; the light is that of desc->power.light or, if its maps are NULL, the
 * photons in desc's maps.
 *
 * With a fixed radius, needs up to 550 bytes a place of the volume map, 4 a
 * place of the surface map, and 40 a photon of the light. Runs over threads,
 * with progress. Fails with MURK_BAD_VALUE (radius, sensor types),
 * MURK_BAD_FILE (a record of the light's volume map without a medium),
 * MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_power_create(murk_power **out, const murk_sight_desc *desc,
                              murk_error *err);
void murk_power_destroy(murk_power *power); /* accepts NULL */

/* The number of places with fewer than MURK_POWER_FEW photons in the estimate.
 */
size_t murk_power_few(const murk_power *power);

/* The radiance L at place i of the surface map [W/m2/sr]. */
double murk_power_radiance(const murk_power *power, size_t i);

/* The source j at place i of the volume map, for light that leaves along the
 * unit vector `toward` [W/m3/sr]. */
double murk_power_source(const murk_power *power, size_t i, murk_vec3 toward);

/* True if the sources at place i of the volume map of one, and k of the other,
 * are estimated from equal records in the same order, and with the same
 * factor: they then are the same in every direction and every bit, as far as
 * phase functions are. */
bool murk_power_has_same_source(const murk_power *a, size_t i,
                                const murk_power *b, size_t k);

/* The signal s of a photon along one sightline [W]; i is the index of the
 * photon in the surface map or the volume map, in which the photon is. */
double murk_power_signal_w(const murk_power *power,
                           const murk_sensor_type *type,
                           const murk_field *field, const murk_photon *photon,
                           size_t i, const murk_sightline *line);

/* The detection probability p of a signal at a wavelength. */
double murk_power_chance(const murk_sensor_type *type, double signal_w,
                         double wavelength_nm);

#endif
