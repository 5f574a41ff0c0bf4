/* Confines the calling process permanently to the system calls that a parser of
 * one file needs. */
#ifndef MURK_BASE_CONFINE_H
#define MURK_BASE_CONFINE_H

#include <stdbool.h>

/* Closes every file but 0, 1, 2 and `fd`, and installs a filter of system calls
 * (seccomp). The process can then read files, take memory and start threads,
 * and write to files that are open already. Opening a file for writing, making
 * or removing files, the network and starting programs or processes fail. No
 * file grows by the writes of the process. Returns false if the kernel has no
 * such filter: then only the files are closed and the file size is limited. */
bool murk_confine(int fd);

#endif
