/* Records of unformatted Fortran files, as FDS writes them. For use inside
 * src/fds only.
 *
 * A record consists of one or more subrecords, each between two lengths of four
 * bytes in the byte order of the computer that wrote the file. A length is
 * negative before the bytes if another subrecord follows, and behind the bytes
 * if a subrecord came before. Compilers divide records of 2^31 - 9 bytes or
 * more; the rule does not depend on the size.
 *
 * Source: The GNU Fortran Compiler, manual of gcc 11.1, "File format of
 * unformatted sequential files". */
#ifndef MURK_FDS_RECORDS_H
#define MURK_FDS_RECORDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct murk_fds_records {
    FILE *file;      /* borrowed */
    uint64_t bytes;  /* of the file */
    bool is_swapped; /* the other byte order */
    bool is_cut;     /* the end of the file was met within a record */
} murk_fds_records;

/* Sets the byte order by the length of the first record, which must be
 * `expected`, and goes back to the beginning. False if it is not. */
bool murk_fds_records_begin(murk_fds_records *records, uint32_t expected);

/* Reads a record of exactly n bytes. False if there is no such record. */
bool murk_fds_record_bytes(murk_fds_records *records, void *out, uint64_t n);

/* Reads a record of exactly n words of four bytes and brings them to the byte
 * order of this computer. False if there is no such record. */
bool murk_fds_record_words(murk_fds_records *records, void *out, uint64_t n);

/* Skips a record; *size is the number of bytes in it. */
bool murk_fds_record_skip(murk_fds_records *records, uint64_t *size);

#endif
