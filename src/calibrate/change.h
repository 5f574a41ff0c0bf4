/* The differences between the optics that light was traced with and the optics
 * that are wanted, as needed to re-weight photon histories. For
 * use inside src/calibrate only. */
#ifndef MURK_CALIBRATE_CHANGE_H
#define MURK_CALIBRATE_CHANGE_H

#include "base/arena.h"
#include "calibrate/histories.h"
#include "calibrate/optics.h"

/* The change of a re-weighted medium in a band. */
typedef struct murk_medium_change {
    double scattering;     /* ratio of the scattering coefficients, wanted /
                            * traced */
    double log_scattering; /* logarithm of the ratio; 0 if the ratio is 0 */
    double more_per_m;     /* difference of the extinction coefficients, wanted
                            * - traced */
    bool turns; /* the phase functions differ by more than rounding */
    const murk_phase *traced, *at;
} murk_medium_change;

/* The derivatives of `scattering` and `more_per_m` of a medium in a band with
 * respect to a key, and the phase functions at the two values of the key, from
 * whose difference the derivative of a phase function follows. turns: these two
 * differ by more than rounding. */
typedef struct murk_change_slope {
    double scattering, more_per_m;
    bool turns;
    const murk_phase *low, *high;
} murk_change_slope;

typedef struct murk_changes {
    size_t media, keys, channels;
    int bands;
    double *span;               /* [keys]; difference of the two values of a key
                                 * that derivatives are taken from; 0: the key
                                 * has no effect here */
    murk_medium_change *medium; /* [media][bands] */
    murk_change_slope *slope;   /* [keys][media][bands] */
    double *power;              /* [channels]; ratio of powers */
    double *power_slope;        /* [keys][channels]; derivative of the ratio */
    bool any_turns;             /* some phase function differs, or would with
                                 * some key */
    murk_arena arena;           /* of all arrays */
} murk_changes;

/* Compares the optics, which are borrowed. sides[keys] as in murk_reweigh().
 * Fails with MURK_BAD_VALUE if scattering, extinction or power is wanted that
 * the traced light did not have, or with MURK_NO_MEMORY. Release also after a
 * failure. */
murk_status murk_changes_create(murk_changes *out,
                                const murk_histories *histories,
                                const murk_optics *traced,
                                const murk_optics *at,
                                const murk_optics_sides *sides, size_t keys,
                                murk_error *err);
void murk_changes_release(murk_changes *changes);

static inline const murk_medium_change *
murk_change_of(const murk_changes *changes, size_t medium, size_t band)
{
    return &changes->medium[medium * (size_t)changes->bands + band];
}

static inline const murk_change_slope *
murk_change_slope_of(const murk_changes *changes, size_t key, size_t medium,
                     size_t band)
{
    return &changes->slope[(key * changes->media + medium) *
                               (size_t)changes->bands +
                           band];
}

#endif
