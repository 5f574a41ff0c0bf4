/* Keys of the rows of a study: hashes that tell which rows share a trace, and
 * whether a stored row is still valid. For use inside src/cases only. */
#ifndef MURK_CASES_SWEEP_KEYS_H
#define MURK_CASES_SWEEP_KEYS_H

#include "cases/sweep.h"
#include "world/file_sums.h"

typedef struct murk_sweep_keys {
    /* The light of rows with equal world keys differs at most in the power of
     * the light sources; sensors and placement may differ. */
    char world[65];
    /* Rows of equal light keys have the same light. */
    char light[65];
    /* Rows of equal placement keys have the same sensors and the same settings
     * of the placement. Only filled if a plan for all rows is asked for. */
    char placement[65];
    /* A hash of everything that the row depends on, except for the other rows
     * of its group. */
    char own[65];
} murk_sweep_keys;

/* Keys of the scene of one row. A missing file is no failure here, because the
 * row refuses it later. Fails as murk_sky_lights() does, or with
 * MURK_NO_MEMORY. */
murk_status murk_sweep_keys_of(murk_sweep_keys *out, murk_file_sums *sums,
                               const murk_scene_desc *scene,
                               const murk_outputs *outputs, const char *version,
                               murk_error *err);

/* Groups rows of equal world keys: fills the groups of the sweep from
 * keys[rows], and `group` and `key` of each row. The key is a hash of the own
 * key of the row and the light keys of all rows of the group. Rows that are
 * done already are those whose scene could not be read; their `group` is
 * SIZE_MAX, and they get no key. */
murk_status murk_sweep_group_rows(murk_sweep *sweep,
                                  const murk_sweep_keys *keys, murk_error *err);

#endif
