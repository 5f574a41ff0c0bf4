/* What options take: numbers, words, files of keys. Messages name the option,
 * what was found and what is allowed. */
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
/* One of allowed[], which ends with NULL. */
murk_status murk_option_choice(const char *name, const char *value,
                               const char *const *allowed, int *out,
                               murk_error *err);

/* Readers of options that have a form of their own (option_table.h). */
murk_status murk_option_out(murk_options *out, const char *name,
                            const char *value, murk_error *err);
murk_status murk_option_set(murk_options *out, const char *name,
                            const char *value, murk_error *err);
murk_status murk_option_method(murk_options *out, const char *name,
                               const char *value, murk_error *err);
murk_status murk_option_exports(murk_options *out, const char *name,
                                const char *value, murk_error *err);
murk_status murk_option_free(murk_options *out, const char *name,
                             const char *value, murk_error *err);
murk_status murk_option_bounds(murk_options *out, const char *name,
                               const char *value, murk_error *err);
murk_status murk_option_loss(murk_options *out, const char *name,
                             const char *value, murk_error *err);

#endif
