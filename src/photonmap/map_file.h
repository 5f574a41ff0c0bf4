/* The file light.murk: both photon maps and the data that are needed to use
 * them again.
 *
 * The file is little-endian: a header of 64 bytes, a table with 48 bytes for
 * each section, then the bytes of the sections in order, and nothing after
 * them. | header: magic (8 bytes), version, byte order mark 0x01020304, record
 * size, | number of sections (4 each), file size (8), checksum of the table |
 * (16), checksum of the header up to here (16) | table: name (16, padded with
 * zeros), size (8), 0 (8), checksum (16)
 *
 * Checksums are those of murk_checksum(). A reader refuses every other file
 * with a message of one line (MURK_BAD_FILE): another magic, another version, a
 * shortened file, changed bytes. */
#ifndef MURK_PHOTONMAP_MAP_FILE_H
#define MURK_PHOTONMAP_MAP_FILE_H

#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

#define MURK_MAP_FILE_VERSION 1 /* a new layout gets a new number */

#define MURK_MAP_FILE_SECTIONS 64 /* at most: bounds the table of a file */

/* A section: a name of 1 to 15 printable characters, and bytes. */
typedef struct murk_section {
    char name[16];
    void *bytes; /* writing: borrowed; reading: owned by the list, 64-aligned */
    size_t size;
} murk_section;

/* Writes a file, completely or not at all (base/file.h). The names must
 * differ. */
murk_status murk_map_file_write(const char *path, const murk_section *sections,
                                size_t n, murk_error *err);

/* Reads all sections into *out, an array of *n sections. The caller releases it
 * with murk_map_file_release() (NULL is allowed). Sizes are checked against the
 * file before memory is taken, and a file that is larger than the memory of the
 * machine is refused (MURK_NO_MEMORY). */
murk_status murk_map_file_read(murk_section **out, size_t *n, const char *path,
                               murk_error *err);
void murk_map_file_release(murk_section *sections, size_t n);

/* Reads one section as an array of one element, without reading the others, in
 * order to find out to which scene a large file belongs. Fails with
 * MURK_BAD_FILE if there is no such section. */
murk_status murk_map_file_read_one(murk_section **out, const char *path,
                                   const char *name, murk_error *err);

/* Returns the section with that name, or NULL. */
const murk_section *murk_map_file_find(const murk_section *sections, size_t n,
                                       const char *name);

#endif
