/* Rows of the coverage matrix that a plan takes over from an earlier plan of
 * the same scene at another time. A clarity is taken over if the same photon or
 * target was stored in both, the candidate is at the same pose, and the
 * sightline between them meets no place at which surfaces or media have
 * changed; so the rows are those that would be computed, in every bit. Photons
 * are the same if their records are equal in every bit but the power, which is
 * no part of a clarity; with detection by power, if their light is estimated
 * from the same records. */
#ifndef MURK_PLAN_EARLIER_H
#define MURK_PLAN_EARLIER_H

#include "base/arena.h"
#include "lightmap/light_update.h"
#include "plan/poses.h"
#include "sensing/sight.h"
#include "world/stage.h"

/* What an earlier plan leaves: its world and light, its candidates, the matrix
 * that it was chosen from, NULL if it was not stored, and the sightlines
 * of each row (murk_sight_counts()). All is borrowed, but for the
 * matrix, which is destroyed when the new rows are complete. */
typedef struct murk_earlier_plan {
    const murk_stage *stage;
    const murk_traced *traced;
    const murk_poses *poses;
    const murk_row_counts *tested; /* [poses] */
    murk_matrix **matrix;
    size_t first; /* number of the first photon of this light in the matrix,
                   * which may have those of other steps, too */
    const murk_passed_light *held_out; /* without light if it was not stored;
                                        * NULL: none */
} murk_earlier_plan;

/* Scratch memory of a thread. */
typedef struct murk_earlier_scratch {
    uint32_t *slot;
    uint16_t *slot_clarity; /* [slots] the earlier row as a list */
    uint16_t *dense;        /* [photons] the clarity of each photon in the new
                             * row, valid where `seen` has its bit */
    uint64_t *seen, *again; /* a bit a photon: it has an entry in the new row;
                             * its sightline was tested again */
    uint32_t *photon;
    uint16_t *clarity; /* [photons] the new row as a list */
    uint32_t *gone_photon;
    uint16_t *gone_clarity; /* [photons] memory of `gone` */
    murk_sparse_row gone,   /* entries of the earlier row whose sightlines were
                             * tested again */
        come;               /* those in their place */
} murk_earlier_scratch;

typedef struct murk_earlier_rows {
    murk_known_rows known; /* for the placement problem of the new plan */
    murk_sight *sight;     /* of the new plan */
    const murk_poses *poses;
    murk_matrix *matrix;
    bool frees_rows; /* set by the caller, who asks for each row once: a row of
                      * the matrix is freed when it has been read, so that the
                      * new one takes its place */
    const murk_row_counts *tested;
    size_t offset;       /* first photon of the earlier light in its matrix */
    uint32_t *same;      /* [photons of the new plan] number of the same
                          * photon of the earlier plan; UINT32_MAX: none */
    uint32_t *first;     /* [slots + 2] the new photons of slot s of the earlier
                          * matrix are photon[first[s]] to
                          * photon[first[s + 1] - 1] */
    uint32_t *photon;    /* [photons] */
    uint32_t *candidate; /* [poses of the new plan] number of the equal pose
                          * of the earlier plan; UINT32_MAX: none */
    uint64_t *hash;      /* [photons] murk_problem.earlier_hash, or NULL */
    murk_sight_changes changes;
    murk_earlier_scratch *scratch; /* [threads] */
    unsigned threads;
    murk_arena arena; /* of all arrays */
} murk_earlier_rows;

/* Makes the sight of a plan (plan/plan.h). */
typedef murk_status murk_earlier_see(murk_sight **out, const murk_stage *stage,
                                     const murk_traced *traced,
                                     unsigned threads, murk_error *err);

/* Prepares to take over rows of `earlier`, NULL: of none, for the candidates of
 * `poses`. `see` makes the sight of `earlier` once more, for targets and for
 * detection by power. *out is all 0, and no row is taken over, if that is not
 * possible: other settings of sensors or of the domain, a world that has
 * changed everywhere, interfaces that have changed, or too little memory. The
 * rows take some 20 bytes a photon and thread; a run without earlier rows needs
 * less, so lack of memory is no failure. The caller releases *out before the
 * sight, which the rows are for, and before `earlier`. */
murk_status murk_earlier_rows_create(murk_earlier_rows *out,
                                     const murk_earlier_plan *earlier,
                                     const murk_poses *poses,
                                     const murk_stage *stage, murk_sight *sight,
                                     murk_earlier_see *see, murk_error *err);
void murk_earlier_rows_release(murk_earlier_rows *rows);

#endif
