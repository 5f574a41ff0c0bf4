/* Readers of the values of options. Messages name the option, the value that
 * was found and the values that are allowed. */
#ifndef MURK_APP_OPTION_VALUES_H
#define MURK_APP_OPTION_VALUES_H

#include "app/options.h"

/* A whole number low..high, also as 1e6. */
murk_status murk_option_count(const char *name, const char *text, uint64_t low,
                              uint64_t high, uint64_t *out, murk_error *err);

/* Keeps "KEY=VALUE" as one more override; `option` must outlive the options. */
murk_status murk_option_override(murk_options *out, const char *key,
                                 const char *value, const char *option,
                                 murk_error *err);

/* The index of one of allowed[], which ends with NULL. */
murk_status murk_option_choice(const char *name, const char *value,
                               const char *const *allowed, uint64_t *out,
                               murk_error *err);

/* Readers of options that have a form of their own. */
murk_option_read murk_option_out, murk_option_set, murk_option_method,
    murk_option_exports, murk_option_free, murk_option_bounds, murk_option_loss,
    murk_option_pixels, murk_option_exposure, murk_option_range;

#endif
