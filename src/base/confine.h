/* Takes from the calling process, for good, all that a parser of one file does
 * not need of the kernel. */
#ifndef MURK_BASE_CONFINE_H
#define MURK_BASE_CONFINE_H

#include <stdbool.h>

/* Closes every file but 0, 1, 2 and `fd`, and installs a filter of system calls
 * (seccomp): files can be read, memory taken and threads started; writing goes
 * to what is open already; opening a file to write, making or removing one, the
 * network, other programs and other processes all fail. No file grows by what
 * the process writes. False when the kernel has no such filter: then only the
 * files are closed and the file size is limited. */
bool murk_confine(int fd);

#endif
