/* Reading files with a size limit, and writing files that appear either
 * complete or not at all. */
#ifndef MURK_BASE_FILE_H
#define MURK_BASE_FILE_H

#include "base/path.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct murk_file murk_file;

/* Opens a temporary file beside `path` (base/staging.h); the caller writes to
 * murk_file_stream(). Until murk_file_commit() has flushed the temporary file
 * to the disk and renamed it, an older file at `path` stays in place.
 * murk_file_discard() (NULL is allowed) removes the temporary file, also after
 * a failed commit. A `path` that this process has read (base/inputs.h) is
 * refused with MURK_BAD_VALUE. */
murk_status murk_file_create(murk_file **out, const char *path,
                             murk_error *err);
FILE *murk_file_stream(murk_file *file);
murk_status murk_file_commit(murk_file **file, murk_error *err);
void murk_file_discard(murk_file *file);

/* Creates, writes and commits a file. */
murk_status murk_file_write(const char *path, const void *bytes, size_t size,
                            murk_error *err);

/* Opens a regular file for reading and returns the descriptor, which the caller
 * closes, and the size. The file counts as an input of the run. */
murk_status murk_file_open(int *fd, uint64_t *size, const char *path,
                           murk_error *err);

/* Reads exactly `size` bytes; a file that ends earlier is an error. */
murk_status murk_file_read_bytes(int fd, void *out, size_t size,
                                 const char *path, murk_error *err);

/* Reads a whole file, which must be a regular file of at most `max` bytes. A
 * '\0' follows the bytes and is not counted in *size. The caller frees *out. */
murk_status murk_file_read(char **out, size_t *size, const char *path,
                           size_t max, murk_error *err);

/* Like murk_file_read(), for a file that murk wrote and may write again: it
 * does not count as an input of the run (base/inputs.h). */
murk_status murk_file_read_own(char **out, size_t *size, const char *path,
                               size_t max, murk_error *err);

/* Fails with MURK_BAD_VALUE if this run has read the file. */
murk_status murk_file_check_input(const char *path, murk_error *err);

/* Checks, before a long computation, that a single result file may be written
 * to `path`. An existing file must contain `mark` (size bytes), the mark of
 * files that murk wrote, near its beginning, unless `force` is set. The file
 * must not be an input of the run. Fails with MURK_BAD_VALUE. */
murk_status murk_file_check_owner(const char *path, const char *mark,
                                  size_t size, bool force, murk_error *err);

/* Fails with the message for a file that murk did not write. */
murk_status murk_file_not_ours(const char *path, murk_error *err);

/* Creates a folder and its parents. An existing folder that can be written to
 * is accepted. */
murk_status murk_folder_make(const char *path, murk_error *err);

/* Flushes the entries of a folder to the disk if the file system supports
 * it. */
void murk_folder_sync(const char *path);

/* SHA-256 as 64 lower-case hexadecimal digits and '\0'. */
void murk_sha256_hex(const void *bytes, size_t size, char out[65]);

/* A fast 128-bit checksum (XXH3). It detects accidents, not malice. */
void murk_checksum(const void *bytes, size_t size, uint64_t out[2]);

/* The checksum of a regular file of at most `max` bytes, which is read in
 * blocks. The first function counts the file as an input of the run, the second
 * does not (base/inputs.h). */
murk_status murk_file_checksum(const char *path, uint64_t max, uint64_t out[2],
                               murk_error *err);
murk_status murk_file_checksum_own(const char *path, uint64_t max,
                                   uint64_t out[2], murk_error *err);

/* SHA-256 of a file, which does not count as an input of the run. */
murk_status murk_file_sha256(const char *path, char out[65], murk_error *err);

#endif
