/* The table of readings that a mapping makes of a file of measurements. */
#ifndef MURK_READINGS_MAPPED_H
#define MURK_READINGS_MAPPED_H

#include "readings/mapping.h"

typedef struct murk_mapped_file {
    murk_table table; /* of readings, with all columns; the path and the lines
                       * are those of the file of measurements. Texts point into
                       * the objects below; do not destroy it */
    char sha256[65];  /* of the checksums of the mapping and of the file */
    murk_mapping mapping;
    murk_field_file file;
    murk_arena arena; /* of the numbers that were computed, and of names */
} murk_mapped_file;

/* Reads the mapping file `path`, which must outlive *out, and the file that it
 * names. A reading is left out if a cell that it needs holds no measurement;
 * notes tell how many. max_bytes, max_readings: limits of the file and of the
 * readings. Fails with MURK_BAD_FILE and MURK_BAD_VALUE at the line of the
 * mapping or of the file that is wrong, and with MURK_NO_MEMORY. Release *out
 * also after a failure. */
murk_status murk_mapped_file_read(murk_mapped_file *out, const char *path,
                                  size_t max_bytes, size_t max_readings,
                                  murk_error *err);
void murk_mapped_file_release(murk_mapped_file *mapped);

#endif
