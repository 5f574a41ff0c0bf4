/* The set of files that a host reads (base/host.h), so that the host never
 * writes over one of them.
 *
 * The set is in memory that the process shares with the subprocesses that it
 * forks: readers of meshes and grids and the rows of a study run in
 * subprocesses, and the files that they open count, too. A file is identified
 * by device, inode and time of creation, so that every path and link to the
 * file is recognised, and a later file that gets the inode of a removed one is
 * not.
 *
 * Each context of the library begins the set of its host, so no call of a
 * context writes over a file that another call of the context has read. The set
 * of a host without a context stays empty until murk_inputs_begin(). */
#ifndef MURK_BASE_INPUTS_H
#define MURK_BASE_INPUTS_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* murk_inputs_begin() begins the set of the host of the calling thread
 * (base/host.h). Call it once, before any thread or subprocess of the host
 * starts; without this call the set stays empty. If there is no memory for the
 * set, every file counts as an input. murk_inputs_end() releases the set. */
void murk_inputs_begin(void);
void murk_inputs_end(void);

/* Files that are added between murk_inputs_try() and murk_inputs_forget() are
 * in the set until murk_inputs_forget() alone, so that they may be overwritten
 * afterwards. No subprocess of the host may run at either call. */
typedef struct murk_inputs_before {
    _Atomic uint64_t *inputs; /* of the host, before */
    bool are_full;
} murk_inputs_before;

murk_inputs_before murk_inputs_try(void);
void murk_inputs_forget(const murk_inputs_before *before);

/* Adds a file by its descriptor. */
void murk_inputs_add(int file);

/* The hashes of the files in the set, and the addition of such hashes to the
 * set of another process: murk-reader and murk-rows share no memory with the
 * process that started them. The caller frees *hash; a hash that has no memory
 * is left out. The hashes to be added may lie at any address. */
void murk_inputs_list(uint64_t **hash, size_t *n);
void murk_inputs_add_listed(const void *hash, size_t n);

/* Opens a file with fopen(path, "rb") and adds the file to the set. The caller
 * closes the stream. On failure returns NULL, and errno has the reason. */
FILE *murk_inputs_open(const char *path);

/* True if the file at `path` was added, or if there is a file at `path` and the
 * set is full or had no memory. False if there is no file at `path`. */
bool murk_inputs_has(const char *path);

#endif
