/* Refusals of words that the command line does not know, with the one that was
 * likely meant. */
#ifndef MURK_APP_UNKNOWN_H
#define MURK_APP_UNKNOWN_H

#include "app/options.h"

murk_status murk_unknown_command(const char *name, murk_error *err);

/* text[length] begins with a hyphen; command may be NULL. */
murk_status murk_unknown_option(const char *text, size_t length,
                                const murk_command *command, murk_error *err);

#endif
