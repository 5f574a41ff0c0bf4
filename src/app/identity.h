/* What results follow from beside the scene: the same text for any number of
 * threads, any output folder, and any order of different options. */
#ifndef MURK_APP_IDENTITY_H
#define MURK_APP_IDENTITY_H

#include "app/options.h"

/* *out: the options that results depend on beside the scene, with the contents
 * of files in place of their names, as lines of text; for free(), also after a
 * failure. */
murk_status murk_identity_asked(char **out, const murk_options *options,
                                murk_error *err);

/* *out: that text and the keys that --set and other options give, for a command
 * that has no scene; for free(), also after a failure. */
murk_status murk_identity_alone(char **out, const murk_options *options,
                                murk_error *err);

#endif
