/* Text in UTF-8 (RFC 3629). */
#ifndef MURK_BASE_UTF8_H
#define MURK_BASE_UTF8_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Returns the number of bytes, 1..4, of the character at `text`, which must end
 * with '\0'. The '\0' counts as a character of one byte. Returns 0 if the bytes
 * are no character: incomplete, overlong, a surrogate, or beyond U+10FFFF. */
size_t murk_utf8_length(const char *text);

/* True if the first `n` characters (or all, if there are fewer) are valid and
 * no control characters of ASCII. */
bool murk_utf8_is_printable(const char *text, size_t n);

/* Returns the code point of the valid character at `text` if a terminal might
 * act on the character instead of showing it, else 0. Such characters are
 * control characters of ASCII and of ISO 6429 (U+0080..U+009F), line and
 * paragraph separators, and the marks, overrides and isolates of the direction
 * of writing (U+200E, U+200F, U+202A..U+202E, U+2066..U+2069). */
uint32_t murk_utf8_control(const char *text);

/* Copies `text` to out[size] for display on a terminal. Each byte of a control
 * character (see above) or of malformed UTF-8 becomes \xNN. Line feed, carriage
 * return and tab become \n, \r and \t. The copy ends before the first character
 * that does not fit; four bytes for each byte of `text` and one more are always
 * enough. Returns the length of the copy. */
size_t murk_utf8_escape(char *out, size_t size, const char *text);

/* Quotes a word for a POSIX shell: in single quotes if necessary, or as $'\ooo'
 * (POSIX.1-2024, 2.2.4) if the word contains characters that are not printable
 * UTF-8, so that the result is one line and valid in a JSON file. The caller
 * frees the result; NULL when out of memory. */
char *murk_utf8_shell_word(const char *word);

#endif
