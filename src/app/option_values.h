/* Readers of the values of options. Messages name the option, the value that
 * was found and the values that are allowed; messages about a key in the file
 * of --set @FILE name the place in the file in place of option and value. */
#ifndef MURK_APP_OPTION_VALUES_H
#define MURK_APP_OPTION_VALUES_H

#include "app/options.h"

/* Adds the override "KEY=VALUE", or `value` alone if `key` is "". Copies key
 * and value. `option` is the name of the option in messages (NULL: --set
 * KEY=VALUE) and must outlive *out. Fails with MURK_NO_MEMORY. */
murk_status murk_option_override(murk_options *out, const char *key,
                                 const char *value, const char *option,
                                 murk_error *err);

/* Readers of options that have a form of their own. */
murk_option_read murk_option_out, murk_option_set, murk_option_exports,
    murk_option_free, murk_option_bounds, murk_option_pixels,
    murk_option_exposure, murk_option_range, murk_option_cut, murk_option_shard;

#endif
