/* The compression function of SHA-256 with the SHA instructions of x86
 * processors (FIPS 180-4, doi:10.6028/NIST.FIPS.180-4).
 *
 * libmd computes SHA-256 in plain C, which takes a tenth of the time of a run
 * that stores a million photons. */
#ifndef MURK_BASE_SHA256_BLOCKS_H
#define MURK_BASE_SHA256_BLOCKS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* True if this machine has the instructions. */
bool murk_sha256_has_blocks(void);

/* Updates the state by n blocks of 64 bytes. Only where
 * murk_sha256_has_blocks(). */
void murk_sha256_blocks(uint32_t state[8], const unsigned char *bytes,
                        size_t n);

#endif
