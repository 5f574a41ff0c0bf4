/* Light from the photon maps: what records near a place send towards who looks,
 * by density estimate.
 *
 * Each record has a kernel of its own (render/kernel.h), as wide as the k-th
 * nearest other record of its band is far; what a place gets is the sum over
 * the kernels that hold it. k grows with the number of records, and more slowly
 * than it: with more photons pictures are both less noisy and less blurred. On
 * surfaces those count whose normal is within 60 degrees of the place's. A
 * record's power is what leaves its event, so no reflectance and no albedo is
 * applied again.
 *
 * Whether first events count is the caller's choice: where shadow rays find
 * direct light they must not, but for those of lights that no shadow ray finds
 * (source/shine.h), and in solids, where none goes.
 *
 * Photons are independent, records of one photon are not: contributions are
 * told by groups of photons that were emitted one after the other (so that
 * each has its share of every light), whose spread is the honest error. */
#ifndef MURK_RENDER_GATHER_H
#define MURK_RENDER_GATHER_H

#include "photonmap/map.h"
#include "render/direct.h"

/* Limits of k: by counting statistics 12 records know a density to 29 %, 256 to
 * 6 %. And groups of photons: the spread of 64 groups knows a variance to 18 %.
 */
#define MURK_GATHER_MIN    12
#define MURK_GATHER_MAX    256
#define MURK_GATHER_GROUPS 64

/* With fewer records than this in a map and band a kernel reaches to every
 * second of them, or farther, and says little of its place. */
#define MURK_GATHER_FEW (2 * MURK_GATHER_MIN + 1)

/* k for so many records of one map and band: sqrt(n) / 8, within
 * MURK_GATHER_MIN..MURK_GATHER_MAX. */
size_t murk_gather_nearest(size_t records);

typedef struct murk_gather murk_gather;

typedef struct murk_gathering_desc {
    const murk_scenery *scenery; /* borrowed as long as the gather lives */
    const murk_photon_map *surface, *volume; /* copied as far as used */
    bool takes_first; /* first events count, of all lights */
    uint32_t seed;
    unsigned threads;
} murk_gathering_desc;

/* *out is the caller's. Fails with MURK_NO_MEMORY; ends early, with whatever
 * there is, when interrupted. Progress by photons. */
murk_status murk_gather_create(murk_gather **out,
                               const murk_gathering_desc *desc,
                               murk_error *err);
void murk_gather_destroy(murk_gather *gather); /* NULL is fine */

/* Bytes that it takes of maps with so many records, at most: their copies,
 * their kernels, and what is needed to lay them. */
double murk_gather_memory_for(double surface, double volume);

/* Records of a band that have kernels: those that count of one map. */
size_t murk_gather_records(const murk_gather *gather, bool of_volume, int band);

/* Radiance [W/m2/sr] towards who looks, over the index squared, at a place of a
 * surface or, where it has a phase function, of a medium: there for each
 * optical depth that scatters, [W/m3/sr] over the scattering coefficient, and
 * without what later events bring within the place's cone.
 * Times `scale` it is returned, and added to
 * group[]. */
double murk_gather_light(const murk_gather *gather,
                         const murk_shading_point *place, double scale,
                         double group[MURK_GATHER_GROUPS]);

/* Variance of the sum over all groups, by their spread. */
double murk_gather_variance(const double group[MURK_GATHER_GROUPS]);

#endif
