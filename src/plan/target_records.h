/* Records of targets before they enter maps. Internal to the files of targets.
 */
#ifndef MURK_PLAN_TARGET_RECORDS_H
#define MURK_PLAN_TARGET_RECORDS_H

#include "base/stats.h"
#include "lightmap/record_buffers.h"
#include "world/stage.h"

/* Upper limit on the points that a spacing makes, as on those that the scene
 * file may ask for: a record takes 32 bytes, so 1e8 records take 3.2 GB. */
#define MURK_TARGETS_MAX 1e8

typedef struct murk_target_facts {
    uint64_t points;        /* drawn and kept, or listed; 0: the scene has no
                             * targets */
    size_t surface, volume; /* number of records in each map */
    /* Sizes of that part of the requested space that is free: the area of
     * surfaces, of which each free side counts, and the volume. NaN if no
     * points were drawn on surfaces, or in the volume. */
    murk_estimate area_m2, volume_m3;
} murk_target_facts;

/* The task of making targets, and the targets made so far. */
typedef struct murk_target_records {
    const murk_stage *stage;
    uint32_t stream;
    unsigned threads;
    uint64_t max; /* points to keep at most on surfaces, and at most in the
                     volume */
    int band;     /* in which sightlines are attenuated */
    murk_record_list surface, volume;
    murk_target_facts facts;
} murk_target_records;

/* A record of weight 1; a zero normal means a record in the volume. */
murk_photon murk_target_of(murk_vec3 place, murk_vec3 normal, int band,
                           uint8_t material);

/* In place of the material or medium of a record that lies on no surface or in
 * no medium. */
#define MURK_TARGET_IN_NONE UINT8_MAX

/* The index of the medium with the largest extinction at a place in a band;
 * MURK_TARGET_IN_NONE if all extinctions are 0 there. */
uint8_t murk_target_medium(const murk_stage *stage, int band, murk_vec3 place);

/* Draw points on the surfaces or in the volume that the scene asks for, and
 * append the records to records->surface or records->volume. The power of a
 * record is the area [m2] or the volume [m3] that the record stands for. Each
 * point has one number, murk_photon_emitted(), which the records of both sides
 * of a surface share; the numbers continue those of the points that were drawn
 * before. Fail with MURK_BAD_VALUE if there is no such surface or volume, if no
 * point lies in free space, or if there are too many points for
 * MURK_TARGETS_MAX or the memory; or with MURK_NO_MEMORY or MURK_INTERRUPTED.
 */
murk_status murk_targets_draw_surfaces(murk_target_records *records,
                                       murk_error *err);
murk_status murk_targets_draw_volume(murk_target_records *records,
                                     murk_error *err);

/* Reads the list of targets: points with a normal become records on surfaces,
 * points without a normal records in the volume. Fails with MURK_BAD_FILE,
 * MURK_BAD_VALUE or MURK_NO_MEMORY. */
murk_status murk_targets_read(murk_target_records *records, murk_error *err);

#endif
