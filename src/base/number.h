/* Strict parsing of numbers that users write, and printing of numbers.
 *
 * A number is decimal, with or without exponent (-3, 0.5, .5, 1e6), and finite.
 * Nothing may precede or follow it: no 0x10, 1_000, nan, .inf, 12abc. */
#ifndef MURK_BASE_NUMBER_H
#define MURK_BASE_NUMBER_H

#include <stdbool.h>
#include <stdint.h>

#define MURK_NUMBER_SIZE 32 /* 17 digits, sign, point, exponent */

/* Returns false and leaves *out unchanged if the text is not exactly one
 * number. */
bool murk_number_parse(const char *text, double *out);

/* Parses a whole number 0..2^64-1; with an exponent (1e6) up to 2^53. */
bool murk_count_parse(const char *text, uint64_t *out);

/* Prints with 15, 16 or 17 digits, the fewest that read back as the same
 * double. */
void murk_number_print(char out[MURK_NUMBER_SIZE], double value);

#endif
