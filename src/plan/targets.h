/* Targets in place of photons, so that dark places count too: points drawn
 * evenly over the area of surfaces or the volume of free space, or listed in a
 * file. They are records like photons, with area [m2], volume [m3] or the
 * list's weight for power, so that sight, coverage and plans take them as they
 * take light.
 *
 * Free space: sensing/open_space.h. A point of a surface is a record on each
 * side that lies in it. Points are drawn independently, so each is an "emitted
 * photon" of its own to coverage's error: both sides of a point have its
 * number. Other streams draw other points. Listed points are all there is: they
 * are the same in all streams, and as one photon together have no error.
 * Medium of a record in the volume: the one with the largest extinction there,
 * in the targets' band; UINT8_MAX where there is none. */
#ifndef MURK_PLAN_TARGETS_H
#define MURK_PLAN_TARGETS_H

#include "base/stats.h"
#include "photonmap/map.h"
#include "world/stage.h"

typedef struct murk_target_facts {
    uint64_t points;        /* drawn and kept, or listed; 0: photons are seen */
    size_t surface, volume; /* records of them */
    /* What lies in free space, a side of a surface each; NaN where none was
     * drawn. */
    murk_estimate area_m2, volume_m3;
} murk_target_facts;

typedef struct murk_targets {
    murk_photon_map *surface, *volume; /* either may be empty */
    uint64_t independent;              /* points; 1 for a list */
    murk_target_facts facts;
} murk_targets;

/* Points, at most: a record is 32 bytes. */
#define MURK_TARGETS_MAX 1e8

/* Of a stage whose scene has targets. Release them also after a failure. Fails
 * with MURK_BAD_VALUE or MURK_BAD_FILE at the scene's place where there is
 * nothing to see: no such surface, no free space in it, a list that cannot be
 * read; with MURK_NO_MEMORY or MURK_INTERRUPTED. */
murk_status murk_targets_create(murk_targets *out, const murk_stage *stage,
                                uint32_t stream, unsigned threads,
                                murk_error *err);
void murk_targets_release(murk_targets *targets);

/* Fails as murk_targets_create() would, but for memory; draws a few points. */
murk_status murk_targets_check(const murk_stage *stage, unsigned threads,
                               murk_error *err);

/* The band that sightlines to targets are attenuated in. */
int murk_targets_band(const murk_scene_desc *scene);

#endif
