/* Bounds of free keys that the user states. Internal to free_keys. */
#ifndef MURK_CALIBRATE_KEY_BOUNDS_H
#define MURK_CALIBRATE_KEY_BOUNDS_H

#include "calibrate/free_keys.h"

/* Narrows the ranges of the keys by keys->desc.bounds, and checks that each
 * start value lies in the range. */
murk_status murk_key_bounds_apply(murk_free_keys *keys, murk_error *err);

#endif
