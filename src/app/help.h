/* Texts about the program and its commands: --help, the man pages and the
 * completion scripts of shells, from the tables that the parser reads. */
#ifndef MURK_APP_HELP_H
#define MURK_APP_HELP_H

#include "app/options.h"

#include <stdbool.h>
#include <stdio.h>

/* --help of one command, or of the program (NULL). */
void murk_help_print(FILE *to, const murk_command *command);

/* The man page of one command, or of the program (NULL), in roff. Fails as
 * murk_lookup_begin(). */
murk_status murk_man_print(FILE *to, const murk_command *command,
                           murk_error *err);

/* The completion script of bash, or of zsh. Fails as murk_lookup_begin(). */
murk_status murk_completion_print(FILE *to, bool is_zsh, murk_error *err);

extern const char murk_help_about[];    /* what murk is */
extern const char murk_help_messages[]; /* how errors read */
extern const char murk_help_files[];    /* how results are written */

#endif
