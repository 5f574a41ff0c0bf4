/* Parses the command line by the tables of commands and options. */
#ifndef MURK_APP_COMMAND_LINE_H
#define MURK_APP_COMMAND_LINE_H

#include "app/options.h"

/* Options point into argv. Release them also after a failure. */
murk_status murk_options_parse(murk_options *out, int argc, char **argv,
                               murk_error *err);
void murk_options_release(murk_options *options);

#endif
