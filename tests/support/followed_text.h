/* Light of a scene given as text, followed for re-weighting. */
#ifndef MURK_TESTS_FOLLOWED_TEXT_H
#define MURK_TESTS_FOLLOWED_TEXT_H

#include "calibrate/histories.h"
#include "calibrate/optics.h"
#include "world/stage.h"

typedef struct followed_text {
    murk_stage *stage;
    murk_optics *optics;
    murk_histories *followed;
} followed_text;

/* Traces by two threads; desc says all but the stage and the threads. Ends the
 * program on failure. End it with followed_text_release(). */
followed_text followed_text_trace(const char *yaml,
                                  const char *const *overrides,
                                  murk_histories_desc desc);
void followed_text_release(followed_text *lit);

#endif
