/* Validation of UTF-8 by the table of well-formed byte sequences (RFC 3629,
 * section 4), and escaping of text for terminals, so that a name in an input
 * file cannot send control sequences. */
#include "base/utf8.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

size_t murk_utf8_length(const char *text)
{
    const unsigned char *at = (const unsigned char *)text;
    const unsigned char c = at[0];
    const size_t n = c < 0x80                ? 1
                     : c >= 0xc2 && c < 0xe0 ? 2
                     : c >= 0xe0 && c < 0xf0 ? 3
                     : c >= 0xf0 && c < 0xf5 ? 4
                                             : 0;
    for (size_t i = 1; i < n; ++i) {
        if ((at[i] & 0xc0) != 0x80) {
            return 0;
        }
    }
    /* overlong, surrogate, overlong, beyond U+10FFFF */
    const bool is_bad =
        (c == 0xe0 && at[1] < 0xa0) || (c == 0xed && at[1] >= 0xa0) ||
        (c == 0xf0 && at[1] < 0x90) || (c == 0xf4 && at[1] >= 0x90);
    return is_bad ? 0 : n;
}

bool murk_utf8_is_printable(const char *text, size_t n)
{
    for (; n > 0 && *text; --n) {
        const unsigned char c = (unsigned char)*text;
        const size_t length = murk_utf8_length(text);
        if (c < 0x20 || c == 0x7f || length == 0) {
            return false;
        }
        text += length;
    }
    return true;
}

/* Returns the code point of the character of `length` bytes at `text`. */
static uint32_t code_point(const char *text, size_t length)
{
    const unsigned char *at = (const unsigned char *)text;
    /* The first byte of n bytes holds 7 - n bits (7 bits if n is 1), each other
     * byte 6 bits. */
    uint32_t code = length == 1 ? at[0] : at[0] & (0x7fu >> length);
    for (size_t i = 1; i < length; ++i) {
        code = code << 6 | (at[i] & 0x3fu);
    }
    return code;
}

uint32_t murk_utf8_control(const char *text)
{
    const uint32_t code = code_point(text, murk_utf8_length(text));
    const bool is_control =
        code < 0x20 || (code >= 0x7f && code < 0xa0) || /* C0, DEL, C1 */
        code == 0x200e || code == 0x200f ||             /* direction marks */
        (code >= 0x2028 && code <= 0x202e) || /* separators, overrides */
        (code >= 0x2066 && code <= 0x2069);   /* directional isolates */
    return is_control ? code : 0;
}

size_t murk_utf8_escape(char *out, size_t size, const char *text)
{
    static const char named[] = "\n\r\t", letter[] = "nrt";
    size_t n = 0;
    while (*text) {
        const size_t length = murk_utf8_length(text);
        const size_t taken = length ? length : 1; /* a malformed byte is escaped
                                                   * alone */
        char piece[20] = "";                      /* at most 4 times \xNN */
        const char *name = strchr(named, *text);
        if (name) {
            snprintf(piece, sizeof piece, "\\%c", letter[name - named]);
        } else if (length && !murk_utf8_control(text)) {
            memcpy(piece, text, length);
        } else {
            for (size_t i = 0; i < taken; ++i) {
                snprintf(piece + 4 * i, sizeof piece - 4 * i, "\\x%02x",
                         (unsigned)(unsigned char)text[i]);
            }
        }
        const size_t more = strlen(piece);
        if (n + more >= size) {
            break;
        }
        memcpy(out + n, piece, more);
        n += more;
        text += taken;
    }
    if (size > 0) {
        out[n] = '\0';
    }
    return n;
}

/* ---- words of a POSIX shell ---- */

/* Characters that need no quotes anywhere in a word. */
static const char shell_plain[] = "abcdefghijklmnopqrstuvwxyz"
                                  "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                  "0123456789_-+./:=@,%";

/* A quote inside the word closes the quotes, is escaped and opens the quotes
 * again: 'it'\''s'. */
static void shell_quote(char *to, const char *word)
{
    *to++ = '\'';
    for (; *word; ++word) {
        if (*word == '\'') {
            memcpy(to, "'\\'", 3);
            to += 3;
        }
        *to++ = *word;
    }
    memcpy(to, "'", 2);
}

static void shell_escape(char *to, const char *word)
{
    memcpy(to, "$'", 2);
    to += 2;
    while (*word) {
        const unsigned char c = (unsigned char)*word;
        if (!murk_utf8_is_printable(word, 1) || c == '\'' || c == '\\') {
            to += snprintf(to, 5, "\\%03o", c);
            ++word;
        } else {
            const size_t n = murk_utf8_length(word);
            memcpy(to, word, n);
            to += n;
            word += n;
        }
    }
    memcpy(to, "'", 2);
}

char *murk_utf8_shell_word(const char *word)
{
    /* at most four characters for each byte, and the quotes */
    char *out = malloc(4 * strlen(word) + 4);
    if (!out) {
        return NULL;
    }
    if (*word && word[strspn(word, shell_plain)] == '\0') {
        strcpy(out, word);
    } else if (murk_utf8_is_printable(word, SIZE_MAX)) {
        shell_quote(out, word);
    } else {
        shell_escape(out, word);
    }
    return out;
}
