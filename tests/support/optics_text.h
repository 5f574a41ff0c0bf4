/* The optics of a scene given as text, which says its domain, for tests of
 * re-weighting: no world is built. */
#ifndef MURK_TESTS_OPTICS_TEXT_H
#define MURK_TESTS_OPTICS_TEXT_H

#include "calibrate/optics.h"

/* As stage_text_create(), but ends the program on failure. The caller's:
 * murk_optics_destroy(). */
murk_optics *optics_text_create(const char *yaml, const char *const *overrides);

#endif
