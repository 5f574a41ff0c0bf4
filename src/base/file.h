/* Reading files, writing files that appear either complete or not at all,
 * making folders, and checksums. */
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
 * murk_file_commit() releases *file and sets it to NULL; if it fails, it also
 * removes the temporary file. murk_file_discard() (NULL is allowed) gives up a
 * file that was not committed. A `path` that this run has read (base/inputs.h)
 * is refused with MURK_BAD_VALUE; other failures are MURK_RUN_FAILED and
 * MURK_NO_MEMORY. */
murk_status murk_file_create(murk_file **out, const char *path,
                             murk_error *err);
FILE *murk_file_stream(murk_file *file);
murk_status murk_file_commit(murk_file **file, murk_error *err);
void murk_file_discard(murk_file *file);

/* Creates, writes and commits a file; fails as murk_file_create() and
 * murk_file_commit() do. */
murk_status murk_file_write(const char *path, const void *bytes, size_t size,
                            murk_error *err);

/* Opens a regular file for reading and returns the descriptor, which the caller
 * closes, and the size in bytes. The file counts as an input of the run. Fails
 * with MURK_BAD_FILE. */
murk_status murk_file_open(int *fd, uint64_t *size, const char *path,
                           murk_error *err);

/* A file as it is: device, inode, size and times of changes of a file on the
 * disk; the checksum of a table in memory. While the identity is the same, so
 * is the content, unless a program has set the clock back. */
typedef struct murk_file_identity {
    uint64_t part[7];
} murk_file_identity;

struct stat;
murk_file_identity murk_file_identity_of(const struct stat *file);

/* The identity of a file that murk_file_read() can read, which counts as an
 * input of the run. Fails with MURK_BAD_FILE. */
murk_status murk_file_identify(murk_file_identity *out, const char *path,
                               murk_error *err);

/* Reads exactly `size` bytes. Fails with MURK_BAD_FILE, also if the file ends
 * earlier. */
murk_status murk_file_read_bytes(int fd, void *out, size_t size,
                                 const char *path, murk_error *err);

/* Writes a copy of a regular file of at most `max` bytes, which appears
 * complete or not at all; the file that is read does not count as an input of
 * the run. Fails as murk_file_read_own() and murk_file_write() do. */
murk_status murk_file_copy_own(const char *path, const char *from, uint64_t max,
                               murk_error *err);

/* Reads a whole file, which must be a regular file of at most `max` bytes, or a
 * table in memory of any size if the path begins with "memory:"
 * (base/memory_files.h). A '\0' follows the bytes and is not counted in *size.
 * The caller frees *out. Fails with MURK_BAD_FILE or MURK_NO_MEMORY. */
murk_status murk_file_read(char **out, size_t *size, const char *path,
                           size_t max, murk_error *err);

/* Like murk_file_read(), for a file on the disk that murk wrote and may write
 * again: the file does not count as an input of the run (base/inputs.h). */
murk_status murk_file_read_own(char **out, size_t *size, const char *path,
                               size_t max, murk_error *err);

/* Fails with MURK_BAD_VALUE if this run has read the file as an input. */
murk_status murk_file_check_input(const char *path, murk_error *err);

/* Checks, before a long computation, that a single result file may be written
 * to `path`. An existing regular file must contain `mark` (size bytes), the
 * mark of files that murk wrote, in the first 65,536 bytes, unless `force` is
 * set. The file must not be an input of the run. Fails with MURK_BAD_VALUE,
 * also for a symbolic link that leads nowhere unless `force` is set. A path
 * that leads to something other than a regular file passes, and is refused by
 * murk_file_create(). */
murk_status murk_file_check_owner(const char *path, const char *mark,
                                  size_t size, bool force, murk_error *err);

/* Fails with MURK_BAD_VALUE and the text MURK_NOT_OURS, the message for a file
 * that murk did not write. */
#define MURK_NOT_OURS                                        \
    "not written by murk, or edited since; must be another " \
    "file or folder"
murk_status murk_file_not_ours(const char *path, murk_error *err);

/* Creates a folder and the missing folders above it. An existing folder that
 * can be written to is accepted. Fails with MURK_RUN_FAILED or MURK_NO_MEMORY.
 */
murk_status murk_folder_make(const char *path, murk_error *err);

/* Flushes the entries of a folder to the disk if the file system supports
 * it. */
void murk_folder_sync(const char *path);

/* SHA-256 as 64 lower-case hexadecimal digits and '\0'. */
void murk_sha256_hex(const void *bytes, size_t size, char out[65]);

/* A fast 128-bit checksum (XXH3). It detects accidents, not malice. */
void murk_checksum(const void *bytes, size_t size, uint64_t out[2]);

/* The checksum of a regular file of at most `max` bytes, which is read in
 * blocks. murk_file_checksum() counts the file as an input of the run
 * (base/inputs.h), and returns the stored checksum of a file in memory
 * (base/memory_files.h). murk_file_checksum_own() does neither. Both fail with
 * MURK_BAD_FILE or MURK_NO_MEMORY; `out` has no meaning then. */
murk_status murk_file_checksum(const char *path, uint64_t max, uint64_t out[2],
                               murk_error *err);
murk_status murk_file_checksum_own(const char *path, uint64_t max,
                                   uint64_t out[2], murk_error *err);

/* SHA-256 of a regular file, which does not count as an input of the run, as 64
 * hexadecimal digits and '\0'. Fails with MURK_BAD_FILE or MURK_NO_MEMORY;
 * `out` has no meaning then. */
murk_status murk_file_sha256(const char *path, char out[65], murk_error *err);

#endif
