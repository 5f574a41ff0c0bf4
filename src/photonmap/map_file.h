/* light.murk: both maps and what is needed to use them again.
 *
 * Little-endian: a header of 64 bytes, a table of 48 bytes a section, then the
 * sections' bytes one behind the other, and nothing behind them.
 *   header: magic (8 bytes), version, byte order mark 0x01020304, record size,
 *           number of sections (4 each), file size (8), checksum of the table
 *           (16), checksum of the header up to here (16)
 *   table:  name (16, padded with zeros), size (8), 0 (8), checksum (16)
 * Checksums are murk_checksum(). A reader refuses anything else with one line
 * (MURK_BAD_FILE): other magic, other version, cut short, changed bytes. */
#ifndef MURK_PHOTONMAP_MAP_FILE_H
#define MURK_PHOTONMAP_MAP_FILE_H

#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

#define MURK_MAP_FILE_VERSION 1

#define MURK_MAP_FILE_SECTIONS 64 /* at most */

/* A section: a name of 1 to 15 printable characters, and bytes. */
typedef struct murk_section {
    char name[16];
    void *bytes; /* writing: borrowed; reading: owned by the list, 64-aligned */
    size_t size;
} murk_section;

/* Written whole or not at all (base/file.h). Names must differ. */
murk_status murk_map_file_write(const char *path, const murk_section *sections,
                                size_t n, murk_error *err);

/* *out: array of *n sections, released with murk_map_file_release() (NULL is
 * fine). Sizes are checked against the file before anything is allocated, and
 * a file larger than the machine's memory is refused (MURK_NO_MEMORY). */
murk_status murk_map_file_read(murk_section **out, size_t *n, const char *path,
                               murk_error *err);
void murk_map_file_release(murk_section *sections, size_t n);

/* The section of that name alone, as a list of one, without reading the others:
 * to learn what a large file is of. Fails with MURK_BAD_FILE where there is no
 * such section. */
murk_status murk_map_file_read_one(murk_section **out, const char *path,
                                   const char *name, murk_error *err);

/* The section of that name, or NULL. */
const murk_section *murk_map_file_find(const murk_section *sections, size_t n,
                                       const char *name);

#endif
