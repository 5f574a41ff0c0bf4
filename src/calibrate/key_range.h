/* Between which values a fit may move a key. Private to free_keys. */
#ifndef MURK_CALIBRATE_KEY_RANGE_H
#define MURK_CALIBRATE_KEY_RANGE_H

#include "calibrate/key_place.h"

typedef struct murk_key_range {
    double lower, upper;
    bool is_log; /* a positive scale: the search runs over its logarithm */
} murk_key_range;

/* As the table of keys says, and for a word of a preset as that says. An end
 * that is no value itself (the cosines -1 and 1) is kept off by a thousandth;
 * 0 is not, of what runs over its logarithm. Ends of 1e9 and more are there to
 * find slips of the pen: infinite here. The path is the key's, for its last
 * part. */
murk_status murk_key_range_of(murk_key_range *out, const murk_key_place *place,
                              const char *path, const char *where,
                              murk_error *err);

#endif
