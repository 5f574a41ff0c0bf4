/* Reads a scene from text and traces the light that a fit re-weights. Failures
 * end the program, because a test has no use for half a scene. */
#include "followed_text.h"

#include "optics_text.h"
#include "stage_text.h"

#include <stdio.h>
#include <stdlib.h>

followed_text followed_text_trace(const char *yaml,
                                  const char *const *overrides,
                                  murk_histories_desc desc)
{
    followed_text lit = {.stage = stage_text_create(yaml, overrides)};
    murk_error err = {0};
    if (!lit.stage) {
        exit(1);
    }
    lit.optics = optics_text_create(yaml, overrides);
    desc.stage = lit.stage;
    desc.threads = 2;
    if (murk_histories_trace(&lit.followed, &desc, &err)) {
        printf("%s: %s\n", err.where, err.text);
        exit(1);
    }
    return lit;
}

void followed_text_release(followed_text *lit)
{
    murk_histories_destroy(lit->followed);
    murk_optics_destroy(lit->optics);
    stage_text_destroy(lit->stage);
    *lit = (followed_text){0};
}
