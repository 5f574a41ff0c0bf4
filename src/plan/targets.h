/* Targets that replace photons, so that dark places count as well: points drawn
 * uniformly over the area of surfaces, the volume of free space or both, or
 * listed in a file. Targets are records like photons; in place of power they
 * have area [m2], volume [m3] or the weight of the list. Sight, coverage and
 * plans therefore treat targets as photons.
 *
 * Free space is defined in sensing/open_space.h. A point of a surface gives one
 * record on each side that lies in free space. Points are drawn independently,
 * so each point counts as an emitted photon of its own for the error of
 * coverage; both sides of a point have the same photon number. Different
 * streams draw different points. A list is complete: it is the same in all
 * streams, and all records of a list count as one photon without error. The
 * medium of a record in the volume is the one with the largest extinction there
 * in the band of the targets, UINT8_MAX if there is none. */
#ifndef MURK_PLAN_TARGETS_H
#define MURK_PLAN_TARGETS_H

#include "plan/target_records.h"

typedef struct murk_targets {
    murk_photon_map *surface, *volume; /* either may be empty */
    uint64_t independent;              /* independent points; 1 for a list */
    murk_target_facts facts;
} murk_targets;

/* Creates the targets of a stage whose scene has targets. Release *out also
 * after a failure. Fails with MURK_BAD_VALUE at the place of the targets in the
 * scene if there is nothing to cover (no such surface, no free space) or too
 * much (plan/target_records.h); with MURK_BAD_FILE or MURK_BAD_VALUE at the
 * file or line of a list that cannot be read, has invalid values or no weight
 * above 0; or with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_targets_create(murk_targets *out, const murk_stage *stage,
                                uint32_t stream, unsigned threads,
                                murk_error *err);
void murk_targets_release(murk_targets *targets);

/* Fails as murk_targets_create() would, except for lack of memory for all
 * targets: reads the whole list, or draws until one point on surfaces and one
 * point in the volume is kept, as far as the scene asks for them. */
murk_status murk_targets_check(const murk_stage *stage, unsigned threads,
                               murk_error *err);

/* The band in which sightlines to targets are attenuated: that of the key
 * band_nm of the targets, or 0 if no band of the scene has this wavelength. */
int murk_targets_band(const murk_scene_desc *scene);

#endif
