/* Options of murk render that are not shared: where the camera stands, how
 * large the picture is, what PNG files are wanted. */
#ifndef MURK_APP_RENDER_OPTIONS_H
#define MURK_APP_RENDER_OPTIONS_H

#include "app/options.h"

/* Readers of options that have a form of their own (option_table.h). */
murk_status murk_option_pixels(murk_options *out, const char *name,
                               const char *value, murk_error *err);
murk_status murk_option_exposure(murk_options *out, const char *name,
                                 const char *value, murk_error *err);
murk_status murk_option_range(murk_options *out, const char *name,
                              const char *value, murk_error *err);

/* What they need of each other and of --sensors. */
murk_status murk_render_options_check(const murk_options *options,
                                      murk_error *err);

#endif
