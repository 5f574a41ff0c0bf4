/* The files that a run reads, so that it never writes over one of them.
 *
 * One list for the whole process and all processes that it starts: readers of
 * meshes and grids and the rows of a study work apart, and what they open
 * counts, too. A file is known by device and inode, so by whatever path or
 * link it is reached.
 *
 * The program keeps the list; a library's caller, who may well read a file and
 * write it again, does not unless it begins one. */
#ifndef MURK_BASE_INPUTS_H
#define MURK_BASE_INPUTS_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/stat.h>

/* From now on files are remembered. Call it once, before any thread or child
 * process; without it the list stays empty. */
void murk_inputs_begin(void);

/* Remembers a file that is opened for reading, by its fstat(). */
void murk_inputs_add(const struct stat *file);

/* fopen(path, "rb") of a file that counts as an input. NULL: errno says why. */
FILE *murk_inputs_open(const char *path);

/* Whether this file was added; false where there is no such file. */
bool murk_inputs_has(const char *path);

#endif
