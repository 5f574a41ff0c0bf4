/* What --help and the man pages both say. */
#ifndef MURK_APP_HELP_TEXT_H
#define MURK_APP_HELP_TEXT_H

extern const char murk_help_about[];    /* what murk is */
extern const char murk_help_messages[]; /* how errors read */
extern const char murk_help_files[];    /* how results are written */

#endif
