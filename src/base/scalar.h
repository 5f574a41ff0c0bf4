/* A text as a scalar of YAML, which readers of scene files and of values of
 * keys take for that text and not for a number, a list or a comment. */
#ifndef MURK_BASE_SCALAR_H
#define MURK_BASE_SCALAR_H

#include <stdio.h>

/* Prints a text as a scalar, in quotes if the text is a boolean or null, does
 * not begin with a letter, / or _, or has other characters than letters,
 * digits, _ . / and -. */
void murk_scalar_print(FILE *out, const char *text);

/* The scalar, which the caller frees with free(); NULL when out of memory. */
char *murk_scalar(const char *text);

#endif
