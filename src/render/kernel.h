/* How far, and over how much, the light of one photon record is spread.
 *
 * A record's power lies on the surface, or in the medium, around it: by the
 * kernel 1 - d^2 / r^2 of distance d, as far as r, times, in a medium, the
 * scattering coefficient there; divided by the `mass`, the integral of just
 * that. So all of a record's power lies where light is reflected or scattered,
 * none of it beyond an edge, behind a wall or outside of the smoke, and sums
 * over a picture are right whatever the radius is.
 *
 * Where a disc lies wholly on one plane and nothing else is about, its mass is
 * known; else rays and looks probe it, in a pattern turned by chance. What lies
 * behind something, as the record sees it, does not belong to it.
 *
 * Source: kernels that belong to the sample: Abramson, Ann. Statist. 10 (1982)
 * 1217, doi:10.1214/aos/1176345986; Silverman, Density Estimation for
 * Statistics and Data Analysis, 1986, ch. 5; of what lies beyond an edge:
 * Jensen, Realistic Image Synthesis Using Photon Mapping, 2001, ch. 7. */
#ifndef MURK_RENDER_KERNEL_H
#define MURK_RENDER_KERNEL_H

#include "photonmap/photon.h"
#include "render/scenery.h"

typedef struct murk_kernel {
    double radius_m;
    double mass;  /* of the kernel: [m2]; in a medium, where the scattering
                     coefficient counts, too */
    double index; /* of refraction, where the record is */
    bool is_cut;  /* not all that the ball holds belongs to it: ask
                     murk_kernel_holds() */
} murk_kernel;

/* Places that are probed: a cut of a disc comes out right to 2 %, of a ball to
 * 5 %, and what 1 / mass is off by in the mean is the square of that. */
#define MURK_PROBES 48

/* What probing a world needs; any number of threads may use it. */
typedef struct murk_probing {
    const murk_scenery *scenery;
    uint32_t seed;
    double disc[MURK_PROBES][2]; /* even by area in one of radius 1 */
    double ball[MURK_PROBES][3]; /* even by volume in one of radius 1 */
} murk_probing;

murk_probing murk_probing_of(const murk_scenery *scenery, uint32_t seed);

/* What the record's kernel is for a wanted radius: that of the answer is
 * smaller where next to nothing of the wanted one is in sight. `number`
 * addresses its random numbers. */
murk_kernel murk_kernel_of(const murk_probing *probing,
                           const murk_photon *photon, double radius_m,
                           uint64_t number);

/* Whether a place within the ball belongs to the kernel. normal: of a surface,
 * faces who looks. */
bool murk_kernel_holds(const murk_scenery *scenery, const murk_photon *photon,
                       const murk_kernel *kernel, murk_vec3 place,
                       murk_vec3 normal, double index);

#endif
