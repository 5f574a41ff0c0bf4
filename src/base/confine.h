/* Confines the calling process permanently to the system calls that a parser of
 * one file needs. */
#ifndef MURK_BASE_CONFINE_H
#define MURK_BASE_CONFINE_H

#include <stdbool.h>

/* Closes every file descriptor but 0, 1, 2 and `fd` > 2, and installs a filter
 * of system calls (seccomp). The process can then read files, take memory,
 * start threads, and write to pipes and devices that are open already. Opening
 * a file for writing, making or removing files, the network and starting
 * programs or processes fail. The limit on the size of files is 0, so that
 * writing to a regular file fails, too. Returns false if the filter cannot be
 * installed, for example because the kernel has none: then only the descriptors
 * are closed and the file size is limited. */
bool murk_confine(int fd);

#endif
