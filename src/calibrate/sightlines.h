/* Stored sightlines from a sensor, or a group of sensors, to the records that
 * it sees. For use inside src/calibrate only. */
#ifndef MURK_CALIBRATE_SIGHTLINES_H
#define MURK_CALIBRATE_SIGHTLINES_H

#include "sensing/sight.h"

/* The sightlines of one group, sorted by contribution; those of one
 * contribution in the order of the poses of the group. */
typedef struct murk_sightlines {
    size_t n, max; /* number in all, and to one record at most */
    uint32_t *contribution;
    float *path_m; /* [n][media]; density path of the re-weighted media */
    float *rest;   /* [n]; transmittance of sheets and other media; NULL: 1 */
    uint16_t *acceptance; /* [n]; index of the acceptance angle; NULL:
                           * acceptance_all */
    uint16_t acceptance_all;
} murk_sightlines;

/* The media that sensors of one acceptance angle look through. */
typedef struct murk_sightlines_through {
    murk_sight *sight; /* through clear media: surfaces and boundaries alone
                        * decide. `emitted` of a record is the number of its
                        * contribution */
    size_t media;
    const murk_media *const *alone; /* [media]; the re-weighted ones */
    const murk_media *other;        /* all others; NULL: none */
    const double *extinction;       /* [bands][media]; of the re-weighted ones,
                                     * as traced */
    bool has_rest;                  /* there are sheets or other media */
} murk_sightlines_through;

/* The memory that sightlines may take, and do take. */
typedef struct murk_sightlines_memory {
    double max_bytes;
    murk_tally bytes;
} murk_sightlines_memory;

/* Finds the sightlines of one sensor, in the order of the maps; the caller sets
 * acceptance_all. False if the memory limit is reached or memory is short. */
bool murk_sightlines_find(murk_sightlines *out,
                          const murk_sightlines_through *through,
                          unsigned worker, const murk_pose *pose,
                          murk_sightlines_memory *memory);

/* Gives all ranks (base/ranks.h) the sightlines of part[parts], of which this
 * rank has found those that it owns (murk_ranks_owns()). *fits: whether the
 * sightlines of all ranks fit into the memory limit of each; if not, the parts
 * stay as they are. Collective. Fails with MURK_NO_MEMORY. */
murk_status murk_sightlines_exchange(bool *fits, murk_sightlines *part,
                                     size_t parts,
                                     const murk_sightlines_through *through,
                                     murk_sightlines_memory *memory,
                                     murk_error *err);

/* Merges part[parts], in order, sorted by contribution (below `contributions`),
 * and releases the parts. False when out of memory or for 2^32 sightlines or
 * more; the parts then stay. */
bool murk_sightlines_join(murk_sightlines *out, murk_sightlines *part,
                          size_t parts, const murk_sightlines_through *through,
                          size_t contributions);
void murk_sightlines_release(murk_sightlines *lines);

/* Memory in bytes. */
double murk_sightlines_bytes(const murk_sightlines *lines, size_t media);

#endif
