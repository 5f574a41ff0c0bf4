/* The context of the library that the commands of the program use: its messages
 * go to standard error, its progress to the terminal, and SIGINT and SIGTERM
 * finish its searches and cancel its calls. */
#ifndef MURK_APP_TERMINAL_H
#define MURK_APP_TERMINAL_H

#include "app/options.h"

/* Makes options->context for the rest of the program, with the threads, the
 * progress and the quietness of the options. The first signal during a search
 * for a plan makes the search finish (murk_context_finish()). After any other
 * signal long computations of the context stop, and one more signal of the same
 * number ends the program at once. */
murk_status murk_terminal_begin(murk_options *options, murk_error *err);

/* True after a signal that makes long computations stop. */
bool murk_terminal_interrupted(void);

/* Prints "murk: PLACE: TEXT" of an error on standard error. */
void murk_terminal_fail(const murk_options *options, const murk_error *err);

#endif
