/* A stage from a scene given as text, for tests of the whole chain. */
#ifndef MURK_TESTS_STAGE_TEXT_H
#define MURK_TESTS_STAGE_TEXT_H

#include "world/stage.h"

/* Reads the text (by a temporary file) with overrides ("seed=3", NULL ends
 * them) and builds it. Prints the error and returns NULL on failure. The scene
 * goes with stage_text_destroy(). */
murk_stage *stage_text_create(const char *yaml, const char *const *overrides);
void stage_text_destroy(murk_stage *stage);

/* The scene alone; the caller's: murk_scene_desc_destroy(). */
murk_scene_desc *scene_text_create(const char *yaml,
                                   const char *const *overrides);

#endif
