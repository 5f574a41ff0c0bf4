/* Rows of the coverage matrix that a plan takes over from an earlier plan of
 * the same scene at another time. A clarity is taken over if the same photon,
 * equal in every bit, was stored in both, the candidate is at the same pose,
 * and the sightline between them meets no place at which surfaces or media have
 * changed; so the rows are those that would be computed, in every bit. */
#ifndef MURK_PLAN_EARLIER_H
#define MURK_PLAN_EARLIER_H

#include "base/arena.h"
#include "lightmap/lightmap.h"
#include "plan/poses.h"
#include "sensing/sight.h"
#include "world/stage.h"

/* What an earlier plan leaves: its world and light, its candidates, the matrix
 * that it was chosen from, NULL if it was not stored, and the number of
 * sightlines of each row (murk_sight_tested()). All is borrowed, but for the
 * matrix, which is destroyed when the new rows are complete. */
typedef struct murk_earlier_plan {
    const murk_stage *stage;
    const murk_traced *traced;
    const murk_poses *poses;
    const uint32_t *tested; /* [poses] */
    murk_matrix **matrix;
    size_t first; /* number of the first photon of this light in the matrix,
                   * which may have those of other steps, too */
} murk_earlier_plan;

/* Scratch memory of a thread: the earlier row by slot, the new row, and the
 * entries of the earlier row in place of which sightlines were tested again. */
typedef struct murk_earlier_scratch {
    uint32_t *slot;
    uint16_t *slot_clarity; /* [slots] */
    uint16_t *dense;        /* [photons] the new row, in any order, */
    uint64_t *seen, *again; /* a bit a photon: has an entry in `dense`; was
                             * tested again */
    uint32_t *photon;
    uint16_t *clarity; /* [photons] the new row */
    uint32_t *gone_photon;
    uint16_t *gone_clarity; /* [photons] */
    murk_sparse_row gone, come;
} murk_earlier_scratch;

typedef struct murk_earlier_rows {
    murk_known_rows known; /* for the placement problem of the new plan */
    murk_sight *sight;     /* of the new plan */
    const murk_poses *poses;
    const murk_matrix *matrix;
    const uint32_t *tested;
    size_t offset;       /* first photon of the earlier light in its matrix */
    uint32_t *same;      /* [photons of the new plan] number of the equal
                          * photon of the earlier plan; UINT32_MAX: none */
    uint32_t *first;     /* [slots + 1] the photons of a slot of the earlier
                          * matrix in */
    uint32_t *photon;    /* [photons] this list of new photons */
    uint32_t *candidate; /* [poses of the new plan] number of the equal pose
                          * of the earlier plan; UINT32_MAX: none */
    uint64_t *hash;      /* [photons] murk_problem.earlier_hash, or NULL */
    murk_sight_changes changes;
    murk_earlier_scratch *scratch; /* [threads] */
    unsigned threads;
    murk_arena arena; /* of all arrays */
} murk_earlier_rows;

/* Prepares to take over rows of `earlier`, NULL: of none, for the candidates of
 * `poses`. *out holds none, and
 * is all 0, if nothing can be taken over: targets instead of photons, a sight
 * that knows no rows (murk_sight_may_know()), other settings of sensors or of
 * the domain, a world that has changed everywhere, or too little memory: some
 * 20 bytes a photon and thread. A run without earlier rows needs less, so lack
 * of memory is no failure here. The caller releases *out before the sight,
 * which the rows are for, and before `earlier`. */
murk_status murk_earlier_rows_create(murk_earlier_rows *out,
                                     const murk_earlier_plan *earlier,
                                     const murk_poses *poses,
                                     const murk_stage *stage, murk_sight *sight,
                                     murk_error *err);
void murk_earlier_rows_release(murk_earlier_rows *rows);

#endif
