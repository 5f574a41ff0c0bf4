/* A problem whose looks are made once and kept, as far as there is room.
 *
 * A look is kept when it takes no more than its candidate's even share of
 * MURK_REMEMBERED_BYTES; others are made anew. So which are kept depends on
 * neither threads nor the machine. */
#ifndef MURK_STUDY_REMEMBERED_H
#define MURK_STUDY_REMEMBERED_H

#include "placement/problem.h"

#define MURK_REMEMBERED_BYTES 1073741824u

typedef struct murk_kept_look murk_kept_look;

typedef struct murk_remembered {
    murk_problem problem; /* the same but for its looks */
    const murk_problem *source;
    _Atomic(murk_kept_look *) *kept; /* [candidates] NULL: not yet, or not */
} murk_remembered;

/* Borrows the source; must not move while it is used. */
murk_status murk_remembered_init(murk_remembered *out,
                                 const murk_problem *source, murk_error *err);
void murk_remembered_release(murk_remembered *remembered);

#endif
