/* A scratch file: blocks of bytes that a run needs and that exceed the memory
 * it may use. The file lies in the folder that the environment variable TMPDIR
 * names, else in /var/tmp, which should not be a file system in memory. The
 * file loses its name as soon as it is open, and so vanishes with the process,
 * however the process ends. The blocks are mapped into memory for reading, so
 * they are read like memory; the operating system fetches pages when they are
 * read. */
#ifndef MURK_BASE_SCRATCH_FILE_H
#define MURK_BASE_SCRATCH_FILE_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct murk_scratch_file murk_scratch_file;

/* The folder of scratch files. */
const char *murk_scratch_folder(void);

/* The free space of the file system of the folder [bytes]; INFINITY if unknown.
 */
double murk_scratch_free_bytes(void);

/* Opens an empty file in the folder and removes its name at once. The caller
 * closes *fd. Fails at the folder with MURK_RUN_FAILED. */
murk_status murk_scratch_open(int *fd, murk_error *err);

/* The failure of a scratch file for a reason as in errno. */
murk_status murk_scratch_fail(int reason, murk_error *err);

/* Makes an empty file for blocks of bytes_max bytes altogether, for whose
 * addresses it reserves left, as far as the process may have so many. Fails at
 * the folder with MURK_RUN_FAILED, or with MURK_NO_MEMORY. */
murk_status murk_scratch_file_create(murk_scratch_file **out,
                                     uint64_t bytes_max, murk_error *err);
void murk_scratch_file_destroy(murk_scratch_file *file); /* accepts NULL */

/* Appends a block, aligned to 64 bytes, and returns the mapped copy, which may
 * only be read, until the block is discarded or the file destroyed. NULL if the
 * block cannot be written; murk_scratch_file_check() then tells the reason. May
 * be called from any thread. */
void *murk_scratch_file_append(murk_scratch_file *file, const void *block,
                               size_t size);

/* The bytes that the file can still take: as the free space of the file system,
 * the limit on the size of files and the addresses that are reserved allow. */
double murk_scratch_file_left(const murk_scratch_file *file);

/* Fails with MURK_RUN_FAILED if a block could not be written. */
murk_status murk_scratch_file_check(const murk_scratch_file *file,
                                    murk_error *err);

/* Gives the space of a block back to the file system, as far as the block
 * covers whole pages. May be called from any thread. */
void murk_scratch_file_discard(murk_scratch_file *file, const void *block,
                               size_t size);

/* Takes all pages out of the resident memory of the process. Blocks stay valid:
 * the next read fetches their pages again, from the cache of the operating
 * system or from the disk. May be called from any thread. */
void murk_scratch_file_evict(murk_scratch_file *file);

#endif
