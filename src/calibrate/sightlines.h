/* Sightlines kept: from a sensor, or a group of them, to the records it sees.
 * Inside this room only. */
#ifndef MURK_CALIBRATE_SIGHTLINES_H
#define MURK_CALIBRATE_SIGHTLINES_H

#include "sensing/sight.h"

/* Of one group: by contribution rising, those of one contribution in the order
 * of the group's poses. */
typedef struct murk_sightlines {
    size_t n, max; /* in all, to one record */
    uint32_t *contribution;
    float *path_m; /* [n][media] density path of the kept media */
    float *rest;   /* [n] let through by sheets and other media; NULL: all */
    uint16_t *acceptance; /* [n] of the pose, an index; NULL: acceptance_all */
    uint16_t acceptance_all;
} murk_sightlines;

/* What sensors of one acceptance look through. */
typedef struct murk_sightlines_through {
    murk_sight *sight; /* through clear media: surfaces and boundaries alone
                          decide. A record's `emitted` is the number of its
                          contribution */
    size_t media;
    const murk_media *const *alone; /* [media] the kept ones */
    const murk_media *other;        /* all others; NULL: there are none */
    const double *extinction;       /* [bands][media] of the kept, as traced */
    bool has_rest;                  /* sheets or others */
} murk_sightlines_through;

/* Memory that lines may take, and do. */
typedef struct murk_sightlines_room {
    double max_bytes;
    murk_tally bytes;
} murk_sightlines_room;

/* Those from one sensor, in the order of the maps; acceptance_all is the
 * caller's. False where room or memory is used up. */
bool murk_sightlines_find(murk_sightlines *out,
                          const murk_sightlines_through *through,
                          unsigned worker, const murk_pose *pose,
                          murk_sightlines_room *room);

/* Brings those of part[parts] together, in order, to contributions below
 * `contributions`; releases the parts. False when out of memory. */
bool murk_sightlines_join(murk_sightlines *out, murk_sightlines *part,
                          size_t parts, const murk_sightlines_through *through,
                          size_t contributions);
void murk_sightlines_release(murk_sightlines *lines);

/* Bytes that they take. */
double murk_sightlines_bytes(const murk_sightlines *lines, size_t media);

#endif
