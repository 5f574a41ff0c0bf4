/* Numbers as users write them, strictly, and as they are written back.
 *
 * A number is decimal, with or without exponent (-3, 0.5, .5, 1e6), finite,
 * with nothing before or behind it: no 0x10, 1_000, nan, .inf, 12abc. */
#ifndef MURK_BASE_NUMBER_H
#define MURK_BASE_NUMBER_H

#include <stdbool.h>
#include <stdint.h>

#define MURK_NUMBER_SIZE 32

/* False, and *out untouched, when the text is not exactly one. */
bool murk_number_parse(const char *text, double *out);

/* A whole number 0..2^64-1; exponents too (1e6) up to 2^53. */
bool murk_count_parse(const char *text, uint64_t *out);

/* The shortest of 15, 16 and 17 digits that reads back the same. */
void murk_number_print(char out[MURK_NUMBER_SIZE], double value);

#endif
