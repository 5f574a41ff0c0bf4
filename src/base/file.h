/* Files that appear whole or not at all, and reading with a limit. */
#ifndef MURK_BASE_FILE_H
#define MURK_BASE_FILE_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct murk_file murk_file;

/* Opens a temporary file beside `path` (base/staging.h); write to
 * murk_file_stream(). Nothing is seen under `path` until murk_file_commit() has
 * flushed it to the disk and renamed it; what stood there before stays until
 * then. murk_file_discard() (NULL is fine) removes the temporary file, also
 * after a failed commit. A file that this process has read (base/inputs.h) is
 * refused with MURK_BAD_VALUE. */
murk_status murk_file_create(murk_file **out, const char *path,
                             murk_error *err);
FILE *murk_file_stream(murk_file *file);
murk_status murk_file_commit(murk_file **file, murk_error *err);
void murk_file_discard(murk_file *file);

/* create, write, commit. */
murk_status murk_file_write(const char *path, const void *bytes, size_t size,
                            murk_error *err);

/* The whole file, which must be a regular one of at most `most` bytes, with a
 * '\0' behind it (not counted). *out is the caller's to free(). */
murk_status murk_file_read(char **out, size_t *size, const char *path,
                           size_t max, murk_error *err);

/* The same of a file that murk wrote and may write anew: it does not count as
 * an input of the run (base/inputs.h). */
murk_status murk_file_read_own(char **out, size_t *size, const char *path,
                               size_t max, murk_error *err);

/* Fails with MURK_BAD_VALUE where this run has read the file. */
murk_status murk_file_check_input(const char *path, murk_error *err);

/* Whether a file that stands alone may be written under `path`, before the
 * work: what stands there, if anything, must hold in its head the mark that
 * files of murk hold (size bytes), unless `force`, and must not be an input.
 * Else MURK_BAD_VALUE. */
murk_status murk_file_check_owner(const char *path, const char *mark,
                                  size_t size, bool force, murk_error *err);

/* The message of it. */
murk_status murk_file_not_ours(const char *path, murk_error *err);

/* Makes a folder and its parents; an existing one that can be written is
 * fine. */
murk_status murk_folder_make(const char *path, murk_error *err);

/* Flushes a folder's entries to the disk, where the file system can. */
void murk_folder_sync(const char *path);

/* `path` as seen from the folder of the file `beside` (or `path` itself when
 * it is absolute). The caller frees it; NULL when out of memory. */
char *murk_path_beside(const char *beside, const char *path);

/* FOLDER/name for free(), NULL when out of memory. */
char *murk_path_join(const char *folder, const char *name);

/* The last part of a path, behind its last slash; borrowed. */
const char *murk_path_name(const char *path);

/* SHA-256 as 64 lower-case hex digits and '\0'. */
void murk_sha256_hex(const void *bytes, size_t size, char out[65]);

/* A fast 128-bit checksum (XXH3), against accidents, not against malice. */
void murk_checksum(const void *bytes, size_t size, uint64_t out[2]);

/* The same of a regular file of at most `most` bytes, read in pieces. */
murk_status murk_file_checksum(const char *path, uint64_t max, uint64_t out[2],
                               murk_error *err);
murk_status murk_file_checksum_own(const char *path, uint64_t max,
                                   uint64_t out[2], murk_error *err);

/* SHA-256 of a file, which does not count as an input. */
murk_status murk_file_sha256(const char *path, char out[65], murk_error *err);

#endif
