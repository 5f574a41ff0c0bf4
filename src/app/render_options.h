/* Options of murk render that are not shared: where the camera stands, how
 * large the picture is, what PNG files are wanted. */
#ifndef MURK_APP_RENDER_OPTIONS_H
#define MURK_APP_RENDER_OPTIONS_H

#include "app/option_table.h"
#include "app/options.h"

/* Takes one of them. */
murk_status murk_render_option(murk_render_options *out,
                               const murk_option *option, const char *value,
                               murk_error *err);

/* What they need of each other and of --sensors. */
murk_status murk_render_options_check(const murk_options *options,
                                      murk_error *err);

#endif
