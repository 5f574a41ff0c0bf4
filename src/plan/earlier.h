/* Rows of the coverage matrix that a plan takes over from an earlier plan of
 * the same scene at another time. A clarity is taken over if the same photon,
 * equal in every bit, was stored in both, the candidate is at the same pose,
 * and the sightline between them meets no place at which surfaces or media have
 * changed; so the rows are those that would be computed, in every bit. */
#ifndef MURK_PLAN_EARLIER_H
#define MURK_PLAN_EARLIER_H

#include "lightmap/lightmap.h"
#include "plan/poses.h"
#include "sensing/sight.h"
#include "world/stage.h"

/* What an earlier plan leaves: its world and light, its candidates, and the
 * matrix that it was chosen from, NULL if it was not stored. All is borrowed,
 * but for the matrix, which is destroyed when the new rows are complete. */
typedef struct murk_earlier_plan {
    const murk_stage *stage;
    const murk_traced *traced;
    const murk_poses *poses;
    murk_matrix **matrix;
} murk_earlier_plan;

typedef struct murk_earlier_rows {
    murk_known_rows known; /* for the placement problem of the new plan */
    const murk_matrix *matrix;
    uint32_t *column;    /* [photons] as in murk_known_row */
    uint32_t *candidate; /* [poses of the new plan] number of the equal pose of
                          * the earlier plan; UINT32_MAX: none */
    uint16_t **clarity;  /* [threads][slots] scratch */
    unsigned threads;
    murk_box_list changed;
} murk_earlier_rows;

/* Prepares to take over rows of `earlier`, NULL: of none, for the candidates of
 * `poses`. *out holds none, and
 * is all 0, if nothing can be taken over: targets instead of photons, a sight
 * that knows no rows (murk_sight_may_know()), other settings of sensors or of
 * the domain, or a world that has changed everywhere. The caller releases *out
 * before the sight, which the rows are for, and before `earlier`. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_earlier_rows_create(murk_earlier_rows *out,
                                     const murk_earlier_plan *earlier,
                                     const murk_poses *poses,
                                     const murk_stage *stage,
                                     const murk_sight *sight, murk_error *err);
void murk_earlier_rows_release(murk_earlier_rows *rows);

#endif
