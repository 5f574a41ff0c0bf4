/* The steps of murk_free_keys_create() that read the texts of the user: names
 * of parameters and bounds. Internal to free_keys. */
#ifndef MURK_CALIBRATE_FREE_NAMES_H
#define MURK_CALIBRATE_FREE_NAMES_H

#include "calibrate/free_keys.h"

/* Fills condition[], their names, the number of bands and the checksum of the
 * file. */
murk_status murk_free_find_conditions(murk_free_keys *keys, murk_error *err);

/* Fills key[] with names and paths. */
murk_status murk_free_add_all(murk_free_keys *keys, murk_error *err);

/* Completes key k, a factor of readings. */
murk_status murk_free_place_gain(murk_free_keys *keys, size_t k,
                                 murk_error *err);

/* Fails if readings need a free factor (murk_reading_unit_needs_gain()) and the
 * factor that they name is not free. */
murk_status murk_free_check_gains(const murk_free_keys *keys, murk_error *err);

/* Narrows the ranges of the keys by keys->desc.bounds, and checks that each
 * start value lies in the range. */
murk_status murk_free_apply_bounds(murk_free_keys *keys, murk_error *err);

#endif
