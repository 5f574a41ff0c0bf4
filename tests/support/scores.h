/* What a photon scores in a world of level layers, from its segments alone.
 *
 * Levels lie at a z; `side` is +1 along z, -1 against it, 0 both. Scores are
 * shares of the emitted power; a fluence is the power through a level over
 * |cosine| (fluence rate times area). */
#ifndef MURK_TESTS_SCORES_H
#define MURK_TESTS_SCORES_H

#include "validation.h"

typedef enum score_kind {
    SCORE_ESCAPED,  /* leaves the domain */
    SCORE_POWER,    /* passes the level z_m */
    SCORE_FLUENCE,  /* likewise, over |cosine| */
    SCORE_ABSORBED, /* in media */
    SCORE_COLLISIONS
} score_kind;

typedef enum score_light {
    SCORE_ALL_LIGHT,
    SCORE_DIRECT, /* never scattered nor diffusely reflected */
    SCORE_DIFFUSE
} score_light;

typedef struct score_of {
    score_kind kind;
    score_light light;
    int side;
    double z_m;
    double mu_min, mu_max; /* of |cosine| with z, [least, most); both 0: any
                            */
} score_of;

/* The context of scores_add: n quantities in order. */
typedef struct scores {
    const score_of *of;
    size_t n;
} scores;

/* A validation_score. */
void scores_add(const void *scores, const murk_event *before,
                const murk_event *event, double *out);

#endif
