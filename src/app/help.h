/* Texts about the program and its commands: --help and the man pages, from the
 * tables that the parser reads. */
#ifndef MURK_APP_HELP_H
#define MURK_APP_HELP_H

#include "app/options.h"

/* --help of one command, or of the program (NULL). */
void murk_help_print(FILE *to, const murk_command *command);

/* The man page of one command, or of the program (NULL), in roff. */
void murk_man_print(FILE *to, const murk_command *command);

extern const char murk_help_about[];    /* what murk is */
extern const char murk_help_messages[]; /* how errors read */
extern const char murk_help_files[];    /* how results are written */

#endif
