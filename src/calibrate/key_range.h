/* The range in which a fit may vary a key. Internal to free_keys. */
#ifndef MURK_CALIBRATE_KEY_RANGE_H
#define MURK_CALIBRATE_KEY_RANGE_H

#include "calibrate/key_place.h"

typedef struct murk_key_range {
    double lower, upper;
    bool is_log; /* a positive scale: the search uses the logarithm */
} murk_key_range;

/* The range of the key table, or of the preset for a word of presets. A limit
 * that the key may not reach (the cosines -1 and 1) is replaced by a value one
 * thousandth inside, except a lower limit 0 of a key that is searched in
 * logarithms. Limits of 1e9 and more only catch typing errors and count as
 * infinite. The path is used for the last part, the name of the key. */
murk_status murk_key_range_of(murk_key_range *out, const murk_key_place *place,
                              const char *path, const char *where,
                              murk_error *err);

#endif
