/* light.murk: both maps and what is needed to use them again.
 *
 * Little-endian. A header (magic, version, record size, number of sections),
 * then named sections, each with its length and checksum. A reader refuses
 * anything else with one line: other magic, other version, cut short, changed
 * bytes. */
#ifndef MURK_PHOTONMAP_LIGHT_FILE_H
#define MURK_PHOTONMAP_LIGHT_FILE_H

#include "base/status.h"

#include <stddef.h>
#include <stdint.h>

#define MURK_LIGHT_FILE_VERSION 1

/* A section: a name of up to 15 characters, and bytes. */
typedef struct murk_section {
    char name[16];
    void *bytes; /* writing: borrowed; reading: owned by the list, 64-aligned */
    size_t size;
} murk_section;

/* Written whole or not at all (base/file.h). */
murk_status murk_light_file_write(const char *path,
                                  const murk_section *sections, size_t n,
                                  murk_error *err);

/* *out: array of *n sections, released with murk_light_file_release(). Sizes
 * are checked against the file before anything is allocated. */
murk_status murk_light_file_read(murk_section **out, size_t *n,
                                 const char *path, murk_error *err);
void murk_light_file_release(murk_section *sections, size_t n);

/* The section of that name, or NULL. */
const murk_section *murk_light_file_find(const murk_section *sections, size_t n,
                                         const char *name);

#endif
