/* The kernel of a photon record: the distance and the area or volume over which
 * the power of the record is spread.
 *
 * The power of a record is spread over the surface, or the medium, around the
 * record by the kernel 1 - d^2 / r^2 of the distance d up to r, in a medium
 * times the local scattering coefficient, divided by `mass`, the integral of
 * this product. The whole power therefore lies on reflecting or scattering
 * points, none of it beyond an edge, behind a wall or outside of the smoke, and
 * sums over a picture are unbiased for any radius.
 *
 * If the disc lies on one plane without other surfaces nearby, the mass is
 * known. Otherwise it is estimated by rays and point queries in a randomly
 * rotated pattern. Points that are occluded as seen from the record do not
 * belong to the kernel.
 *
 * Sources: kernels with a bandwidth for each sample: Abramson, Ann. Statist. 10
 * (1982) 1217, doi:10.1214/aos/1176345986; Silverman, Density Estimation for
 * Statistics and Data Analysis, 1986, ch. 5; points beyond an edge: Jensen,
 * Realistic Image Synthesis Using Photon Mapping, 2001, ch. 7. */
#ifndef MURK_RENDER_KERNEL_H
#define MURK_RENDER_KERNEL_H

#include "photonmap/photon.h"
#include "render/scenery.h"

/* The kernel of one record. */
typedef struct murk_kernel {
    double radius_m;
    double mass;  /* integral [m2]: on a surface of the kernel over the area, in
                   * a medium of the kernel times the scattering coefficient
                   * over the volume */
    double index; /* refractive index at the record */
    bool is_cut;  /* part of the ball may not belong to the kernel: surfaces or
                     sides of the domain are near */
} murk_kernel;

/* The number of test points: the cut of a disc is estimated within 2 %, that of
 * a ball within 5 %, and the bias of 1 / mass is the square of that. */
#define MURK_PROBES 48

/* The pattern of test points; any number of threads may use it. */
typedef struct murk_probing {
    const murk_scenery *scenery;
    uint32_t seed;
    double disc[MURK_PROBES][2]; /* uniform by area in a disc of radius 1 */
    double ball[MURK_PROBES][3]; /* uniform by volume in a ball of radius 1 */
} murk_probing;

/* Creates the pattern. */
murk_probing murk_probing_of(const murk_scenery *scenery, uint32_t seed);

/* Computes the kernel of a record for a desired radius. The radius of the
 * result is smaller if almost nothing of the desired kernel is visible from the
 * record. `number` addresses the random numbers. */
murk_kernel murk_kernel_of(const murk_probing *probing,
                           const murk_photon *photon, double radius_m,
                           uint64_t number);

/* True if a point within the ball belongs to the kernel. normal: of the surface
 * at the point, towards the viewer; not used in a medium. index: refractive
 * index at the point. */
bool murk_kernel_holds(const murk_scenery *scenery, const murk_photon *photon,
                       const murk_kernel *kernel, murk_vec3 place,
                       murk_vec3 normal, double index);

#endif
