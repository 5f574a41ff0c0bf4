/* Strict parsing of numbers that users write, and printing of numbers.
 *
 * A number is decimal, with or without sign, point and exponent (-3, +2, 0.5,
 * .5, 1e6), and finite. Nothing may precede or follow the number. Refused are,
 * for example, 0x10, 1_000, nan, .inf and 12abc. */
#ifndef MURK_BASE_NUMBER_H
#define MURK_BASE_NUMBER_H

#include <stdbool.h>
#include <stdint.h>

#define MURK_NUMBER_SIZE 32 /* 17 digits, sign, point, exponent */

/* Returns false and leaves *out unchanged if the text is not exactly one
 * number. */
bool murk_number_parse(const char *text, double *out);

/* Parses a whole number: 0..2^64-1 in digits, with or without a plus sign, or
 * 0..2^53 with a point or an exponent (1e6, 5.0). Returns false and leaves *out
 * unchanged if the text is not exactly one such number. */
bool murk_count_parse(const char *text, uint64_t *out);

/* Prints a value with at most 15, 16 or 17 significant digits, the first of
 * these limits at which the text reads back as the same double. */
void murk_number_print(char out[MURK_NUMBER_SIZE], double value);

#endif
