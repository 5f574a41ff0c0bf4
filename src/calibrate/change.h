/* How the optics of the media and lights that light was followed through differ
 * from those it was traced with. Private to this room. */
#ifndef MURK_CALIBRATE_CHANGE_H
#define MURK_CALIBRATE_CHANGE_H

#include "calibrate/reweigh.h"

/* Of a kept medium in a band. */
typedef struct murk_medium_change {
    double scattering;     /* sigma_s' / sigma_s */
    double log_scattering; /* of it; where it is 0, 0 */
    double more_per_m;     /* sigma_t' - sigma_t */
    bool turns; /* the phase functions differ by more than rounding */
    const murk_phase *traced, *at;
} murk_medium_change;

/* The same, by a key. */
typedef struct murk_change_slope {
    double scattering, more_per_m;
    bool turns;
    const murk_phase *low, *high;
} murk_change_slope;

typedef struct murk_changes {
    size_t media, keys, channels;
    int bands;
    double *span;               /* [keys] 0: has no say */
    murk_medium_change *medium; /* [media][bands] */
    murk_change_slope *slope;   /* [keys][media][bands] */
    double *power;              /* [channels] ratio */
    double *power_slope;        /* [keys][channels] of the ratio */
    bool any_turns;             /* some phase function differs, or would */
} murk_changes;

/* *out is the caller's: murk_changes_destroy(); borrows the optics. */
murk_status murk_changes_create(murk_changes **out,
                                const murk_followed *followed,
                                const murk_optics *traced,
                                const murk_optics *at,
                                const murk_optics_sides *sides, size_t keys,
                                murk_error *err);
void murk_changes_destroy(murk_changes *changes); /* NULL is fine */

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
