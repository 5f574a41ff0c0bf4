/* What rows of a study are known by: which share a light, and whether a kept
 * one is still what it says. Private to the sweep. */
#ifndef MURK_CASES_SWEEP_KEYS_H
#define MURK_CASES_SWEEP_KEYS_H

#include "cases/outputs.h"
#include "world/file_sums.h"

typedef struct murk_sweep_keys {
    char world[65]; /* rows alike in this differ by the power of lights alone */
    char light[65]; /* alike: the same light */
    char placement[65]; /* alike: the same sensors and wishes for placing them;
                       made where a plan for all rows is asked for */
    char own[65]; /* all of the row, but for what others are in its group */
} murk_sweep_keys;

/* Of one row's scene. Files that are missing are left for later to refuse.
 * Fails as murk_sky_light(). */
murk_status murk_sweep_keys_of(murk_sweep_keys *out, murk_file_sums *sums,
                               const murk_scene_desc *scene,
                               const murk_outputs *outputs, const char *version,
                               murk_error *err);

#endif
