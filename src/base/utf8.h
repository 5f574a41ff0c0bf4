/* Text as bytes of UTF-8 (RFC 3629). */
#ifndef MURK_BASE_UTF8_H
#define MURK_BASE_UTF8_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Bytes of the character at text, 1..4, which ends with a '\0' somewhere; 0
 * where it is none: cut short, overlong, a surrogate, beyond U+10FFFF. */
size_t murk_utf8_length(const char *text);

/* Whether the first `n` characters (or all, where there are fewer) are such,
 * and none is a control character of ASCII. */
bool murk_utf8_is_printable(const char *text, size_t n);

/* The code point of the well-formed character at `text` where a terminal might
 * act on the character instead of showing it, else 0: control characters of
 * ASCII and of ISO 6429 (U+0080..U+009F), line and paragraph separators, and
 * characters that change the direction of writing. */
uint32_t murk_utf8_control(const char *text);

/* Copies `text` to out[size] for a terminal. Control characters (see above) and
 * bytes that are no UTF-8 become one \xNN for each byte. Line feed, carriage
 * return and tab become \n, \r and \t. The copy is cut before the first
 * character that does not fit; four bytes for each byte of `text` and one more
 * are always enough. Returns the copy's length. */
size_t murk_utf8_escape(char *out, size_t size, const char *text);

/* A word as a shell reads it back: in single quotes, where it needs them; what
 * is no printable UTF-8 by $'\ooo' (POSIX.1-2024, 2.2.4), so that the text is
 * one line and valid in a JSON file. For free(); NULL when out of memory. */
char *murk_utf8_shell_word(const char *word);

#endif
