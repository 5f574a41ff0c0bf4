/* Radiance from the photon maps, by kernel density estimation.
 *
 * Each record has a kernel (render/kernel.h). The radius is the distance of the
 * k-th nearest other record of the band, at least 1e-4 of the diagonal of the
 * domain, and smaller if almost nothing of the kernel is visible from the
 * record. The radiance at a point is a sum over the kernels that contain the
 * point. k grows with the number of records, but more slowly: with more
 * photons, pictures have both less noise and less blur. On surfaces, only
 * records count whose normal is within 60 degrees of the normal at the point.
 * The power of a record is the power that leaves the event, so reflectance or
 * albedo is not applied again.
 *
 * The caller decides by takes_first whether all first events count. Without it,
 * for callers whose shadow rays find direct light, the first events do not
 * count, except those of lights that shadow rays cannot find (source/shine.h),
 * and those on surfaces that face the inside of a solid, where no shadow ray is
 * sent.
 *
 * Photons are independent, but records of one photon are not. Contributions are
 * therefore collected in groups of photons that were emitted one after the
 * other (so that each group has a fair share of every light), and the error is
 * estimated from the variance between groups. */
#ifndef MURK_RENDER_GATHER_H
#define MURK_RENDER_GATHER_H

#include "photonmap/map.h"
#include "render/direct.h"

/* Limits of k: by counting statistics 12 records know a density to 29 %, 256 to
 * 6 %. MURK_GATHER_GROUPS is the number of groups of photons: the spread of 64
 * groups knows a variance to 18 %. */
#define MURK_GATHER_MIN    12
#define MURK_GATHER_MAX    256
#define MURK_GATHER_GROUPS 64

/* With fewer records than this in a map and band, a kernel reaches at least
 * half of the other records, and says little about the point. */
#define MURK_GATHER_FEW (2 * MURK_GATHER_MIN + 1)

/* k for a number of records of one map and band: sqrt(n) / 8, within
 * MURK_GATHER_MIN..MURK_GATHER_MAX. */
size_t murk_gather_nearest(size_t records);

typedef struct murk_gather murk_gather;

typedef struct murk_gathering_desc {
    const murk_scenery *scenery; /* must exist as long as the gather object */
    const murk_photon_map *surface, *volume; /* copied as far as necessary */
    bool takes_first; /* first events of all lights count; false: see above */
    uint32_t seed;
    unsigned threads;
} murk_gathering_desc;

/* Creates a kernel for each record that counts. The caller destroys *out. Fails
 * with MURK_NO_MEMORY. After an interrupt it ends early, and *out, whose
 * kernels are then incomplete, may only be destroyed. Progress is counted in
 * records of both maps. */
murk_status murk_gather_create(murk_gather **out,
                               const murk_gathering_desc *desc,
                               murk_error *err);
void murk_gather_destroy(murk_gather *gather); /* NULL is fine */

/* The largest memory in bytes for maps with these numbers of records: copies,
 * kernels, and scratch memory for creating them. */
double murk_gather_memory_for(double surface, double volume);

/* The number of records of a band and map that have kernels. */
size_t murk_gather_records(const murk_gather *gather, bool of_volume, int band);

/* Returns the radiance [W/m2/sr] towards the viewer, divided by the square of
 * the index, times `scale`, and adds the contributions to group[]. At a point
 * of a medium (with a phase function) the result is per unit of scattering
 * optical depth, [W/m3/sr] divided by the scattering coefficient, and without
 * the light of later events within the cone of the point. */
double murk_gather_light(const murk_gather *gather,
                         const murk_shading_point *place, double scale,
                         double group[MURK_GATHER_GROUPS]);

/* The variance of the sum over all groups, from the variance between groups. */
double murk_gather_variance(const double group[MURK_GATHER_GROUPS]);

#endif
