/* Which records groups of sensors see, and what lies between: found once for
 * traced light, good for any extinctions. Inside this room only.
 *
 * Surfaces and boundaries decide what is seen; how clearly follows from the
 * density path of each kept medium along the straight sightline, and from what
 * sheets and the other media let through, all unrounded but for single
 * precision: a look's own clarity, rounded to 1/65535, has no derivative. */
#ifndef MURK_CALIBRATE_SEEN_H
#define MURK_CALIBRATE_SEEN_H

#include "calibrate/followed.h"
#include "calibrate/sightlines.h"

typedef struct murk_seen {
    size_t groups, media, acceptances;
    murk_sightlines *of;    /* [groups] */
    double *acceptance_rad; /* [acceptances] different ones, by type */
    size_t n;               /* contributions */
    double *worth_w;        /* [n] power times regions of interest; chords: 0 */
    uint8_t *kind;          /* [n] band * 2, 1 more in the volume map */
} murk_seen;

typedef struct murk_seen_desc {
    const murk_stage *stage;
    const murk_followed *followed;
    const murk_pose *pose; /* [poses] */
    const size_t *group;   /* [poses] rising, below groups */
    size_t poses, groups;
    unsigned threads;
} murk_seen_desc;

/* What a medium takes out of light in a band for a sensor of such acceptance
 * [1/m, times density]. */
double murk_seen_extinction(double extinction_per_m, double albedo,
                            const murk_phase *phase, double acceptance_rad);

/* Whether followed keeps the density paths of a medium of the scene. */
bool murk_seen_keeps(const murk_followed *followed, size_t medium);

/* Fails with MURK_BAD_VALUE (a pose outside the domain, acceptance and a grid
 * of albedo, more sightlines than the machine holds), MURK_RUN_FAILED (no
 * record has weight), MURK_INTERRUPTED or MURK_NO_MEMORY. Keeps nothing of
 * desc. */
murk_status murk_seen_create(murk_seen **out, const murk_seen_desc *desc,
                             murk_error *err);
void murk_seen_destroy(murk_seen *seen); /* NULL is fine */

#endif
