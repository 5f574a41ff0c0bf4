/* A scratch file: blocks of bytes that a run needs and that exceed the memory
 * it may use. The file lies in the folder that the environment variable TMPDIR
 * names, else in /var/tmp, has no name, and vanishes with the process, however
 * the process ends. The blocks are mapped into memory for reading, so they are
 * read like memory; the operating system fetches pages when they are read. */
#ifndef MURK_BASE_SCRATCH_FILE_H
#define MURK_BASE_SCRATCH_FILE_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct murk_scratch_file murk_scratch_file;

/* The folder of scratch files. */
const char *murk_scratch_folder(void);

/* The bytes that the folder can take [bytes]: the free space of the file
 * system; INFINITY if unknown. */
double murk_scratch_free_bytes(void);

/* Makes an empty file. Fails at the folder with MURK_RUN_FAILED, or with
 * MURK_NO_MEMORY. */
murk_status murk_scratch_file_create(murk_scratch_file **out, murk_error *err);
void murk_scratch_file_destroy(murk_scratch_file *file); /* accepts NULL */

/* Appends a block, aligned to 64 bytes, and returns the mapped copy, which may
 * only be read, until the block is discarded or the file destroyed. NULL if the
 * block cannot be written; murk_scratch_file_check() then tells the reason. May
 * be called from any thread. */
void *murk_scratch_file_append(murk_scratch_file *file, const void *block,
                               size_t size);

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
