/* Readers of the values of options. Messages name the option, the value that
 * was found and the values that are allowed. */
#ifndef MURK_APP_OPTION_VALUES_H
#define MURK_APP_OPTION_VALUES_H

#include "app/options.h"

/* Keeps "KEY=VALUE" as one more override; `option` must outlive the options. */
murk_status murk_option_override(murk_options *out, const char *key,
                                 const char *value, const char *option,
                                 murk_error *err);

/* Readers of options that have a form of their own. */
murk_option_read murk_option_out, murk_option_set, murk_option_exports,
    murk_option_free, murk_option_bounds, murk_option_pixels,
    murk_option_exposure, murk_option_range, murk_option_cut;

#endif
