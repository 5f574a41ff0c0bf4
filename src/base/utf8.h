/* Text as bytes of UTF-8 (RFC 3629). */
#ifndef MURK_BASE_UTF8_H
#define MURK_BASE_UTF8_H

#include <stdbool.h>
#include <stddef.h>

/* Bytes of the character at text, 1..4, which ends with a '\0' somewhere; 0
 * where it is none: cut short, overlong, a surrogate, beyond U+10FFFF. */
size_t murk_utf8_length(const char *text);

/* Whether the first `n` characters (or all, where there are fewer) are such,
 * and none is a control character of ASCII. */
bool murk_utf8_is_printable(const char *text, size_t n);

#endif
