/* What the user says of the ranges of free keys. Private to free_keys. */
#ifndef MURK_CALIBRATE_KEY_BOUNDS_H
#define MURK_CALIBRATE_KEY_BOUNDS_H

#include "calibrate/free_keys.h"

/* Narrows the keys' ranges by keys->desc.bounds, and checks that each starts
 * within its own. */
murk_status murk_key_bounds_apply(murk_free_keys *keys, murk_error *err);

#endif
