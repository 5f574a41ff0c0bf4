/* The optics of a scene given as text whose lights are lamps, for tests of
 * re-weighting: no world is built. */
#ifndef MURK_TESTS_OPTICS_TEXT_H
#define MURK_TESTS_OPTICS_TEXT_H

#include "calibrate/optics.h"

/* As stage_text_create(); ends the program on failure. The caller's:
 * optics_text_release(). */
murk_optics optics_text_read(const char *yaml, const char *const *overrides);
void optics_text_release(murk_optics *optics);

#endif
