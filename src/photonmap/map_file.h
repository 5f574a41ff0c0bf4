/* The file light.murk: both photon maps and the data that are needed to use
 * them again.
 *
 * The file is little-endian. Header and table are followed by the bytes of the
 * sections in the order of the table, and nothing after them:
 *
 *   header, 64 bytes:
 *     magic (8 bytes), version (4), byte order mark 0x01020304 (4), size of a
 *     photon record (4), number of sections (4), size of the file (8),
 *     checksum of the table (16), checksum of the header up to here (16)
 *   table, 48 bytes for each section:
 *     name (16, padded with zeros), size (8), 0 (8), checksum (16)
 *
 * Checksums are those of murk_checksum(). A reader refuses every other file
 * with a message of one line (MURK_BAD_FILE): another magic, another version, a
 * shortened file, changed bytes. */
#ifndef MURK_PHOTONMAP_MAP_FILE_H
#define MURK_PHOTONMAP_MAP_FILE_H

#include "base/block.h"
#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

#define MURK_MAP_FILE_VERSION 1 /* a new layout gets a new number */

#define MURK_MAP_FILE_SECTIONS 64 /* at most: bounds the table of a file */

/* A section: a name of 1 to 15 printable ASCII characters without spaces, and
 * bytes. */
typedef struct murk_section {
    char name[16];
    void
        *bytes; /* writing: borrowed; reading: those of the block, 64-aligned */
    size_t size;
    murk_block block; /* reading: owned by the list, in a scratch file if the
                       * sections are larger than blocks in memory may be */
} murk_section;

/* A section for writing. */
murk_section murk_section_of(const char *name, const void *bytes, size_t size);

/* Writes a file, completely or not at all; fails as murk_file_create() and
 * murk_file_commit() do (base/file.h). At most MURK_MAP_FILE_SECTIONS sections,
 * whose names must differ. */
murk_status murk_map_file_write(const char *path, const murk_section *sections,
                                size_t n, murk_error *err);

/* Reads all sections into *out, an array of *n sections, which the caller
 * releases with murk_map_file_release() (NULL is allowed). The file counts as
 * an input of the run (base/inputs.h). Sizes are checked against the file
 * before memory is taken. Fails with MURK_BAD_FILE, with MURK_NO_MEMORY, or
 * with MURK_RUN_FAILED if the disk is too small for a scratch file. The second
 * function leaves out the sections of these names, a list that ends with
 * NULL. */
murk_status murk_map_file_read(murk_section **out, size_t *n, const char *path,
                               murk_error *err);
murk_status murk_map_file_read_without(murk_section **out, size_t *n,
                                       const char *path,
                                       const char *const *left_out,
                                       murk_error *err);
void murk_map_file_release(murk_section *sections, size_t n);

/* Reads one section as an array of one element, without reading the others, in
 * order to find out to which scene a large file belongs. The caller releases it
 * with n = 1. Fails as murk_map_file_read(), and with MURK_BAD_FILE if there is
 * no such section. */
murk_status murk_map_file_read_one(murk_section **out, const char *path,
                                   const char *name, murk_error *err);

/* Returns the section with that name, or NULL if there is none. */
const murk_section *murk_map_file_find(const murk_section *sections, size_t n,
                                       const char *name);

#endif
