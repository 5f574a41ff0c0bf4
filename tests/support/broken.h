/* What tests of broken files share: limits, loading, changes of bytes by
 * addressed random numbers, and the form of a refusal. A change depends on the
 * seed and the number of the file alone, so a file that fails can be made
 * again. */
#ifndef MURK_TEST_BROKEN_H
#define MURK_TEST_BROKEN_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The project's bounds for any bad input: seconds, and kilobytes of memory.
 * Sanitizers slow readers down, whose memory is not limited then, by the factor
 * that base/subprocess.c has, too. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define BROKEN_SLOWEST_S 150.0
#else
#define BROKEN_SLOWEST_S 10.0
#endif
#define BROKEN_MAX_KB 2000000L

/* The largest amount of memory that this process has held so far. */
long broken_peak_kb(void);

typedef struct broken_bytes {
    unsigned char *at; /* owned by the caller */
    size_t size;
} broken_bytes;

/* A whole file; a failed check if it is not there. */
broken_bytes broken_load(const char *path);

/* Flips `flips` bits among the first `among` bytes: the k-th by the words of
 * (seed, MURK_TEST, file, first + k, 0). */
void broken_flip(unsigned char *bytes, size_t among, uint32_t seed,
                 uint64_t file, uint32_t first, uint32_t flips);

/* Replaces one to four bytes, i % 4 + 1, by the words of (seed, MURK_TEST, i,
 * k, 0): by any byte, or, if is_meant, by one of the n bytes of `meant`, which
 * mean something in the format. */
void broken_replace(char *text, size_t size, uint32_t seed, uint64_t i,
                    bool is_meant, const char *meant, size_t n);

/* Fills a multiple of four bytes with noise. */
void broken_noise(char *out, size_t size, uint32_t seed, uint64_t file);

/* Checks that a refusal has a message of one line. */
void broken_check_refusal(const murk_error *err);

#endif
