/* Reads values that may be given once for all bands, or as a list with one
 * item per band. */
#ifndef MURK_SCENE_WALK_BANDS_H
#define MURK_SCENE_WALK_BANDS_H

#include "scene/walk.h"

/* Fills the array of structs in `owner` that a row of kind MURK_KEY_PER_BAND
 * describes, and the number of structs. */
murk_status murk_walk_bands(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *owner);

#endif
