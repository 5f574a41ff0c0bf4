/* The command line that gives the same results again: what was typed, quoted
 * for a POSIX shell, without what results do not depend on (where they are
 * written, threads, what is said on the way).
 *
 * A result keeps it under `run`, since the same may be typed in many ways. */
#ifndef MURK_APP_COMMAND_LINE_H
#define MURK_APP_COMMAND_LINE_H

#include "base/status.h"

/* "murk place yard.yaml --seed 3" for free(). Words as murk_options_parse()
 * took them. Fails with MURK_NO_MEMORY. */
murk_status murk_command_line(char **out, int argc, char **argv,
                              murk_error *err);

#endif
