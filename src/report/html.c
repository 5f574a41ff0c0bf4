/* Writes text and bytes of the page, and hashes for its content security
 * policy. */
#include "report/html.h"

#include "base/file.h"
#include "base/utf8.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define UNKNOWN "\xef\xbf\xbd" /* U+FFFD */

/* ---- text ---- */

static const char *entity(char c)
{
    switch (c) {
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '&':
        return "&amp;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        return NULL;
    }
}

void murk_html_text(FILE *to, const char *text)
{
    const char *at = text;
    while (at && *at) {
        const size_t n = murk_utf8_length(at);
        const unsigned char c = (unsigned char)*at;
        const bool is_control = c < 0x20 ? c != '\n' && c != '\t' : c == 0x7f;
        if (n == 0 || is_control) {
            fputs(UNKNOWN, to);
            ++at;
        } else if (entity(*at)) {
            fputs(entity(*at), to);
            ++at;
        } else {
            (void)fwrite(at, 1, n, to);
            at += n;
        }
    }
}

/* ---- bytes ---- */

static const char digits64[] =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/* Encodes one to three bytes as four characters of base64. */
static void quartet(char out[4], const unsigned char *bytes, size_t n)
{
    const uint32_t bits = (uint32_t)bytes[0] << 16 |
                          (n > 1 ? (uint32_t)bytes[1] << 8 : 0) |
                          (n > 2 ? (uint32_t)bytes[2] : 0);
    for (size_t i = 0; i < 4; ++i) {
        out[i] = i <= n ? digits64[bits >> (18 - 6 * i) & 63] : '=';
    }
}

void murk_html_base64(FILE *to, const void *bytes, size_t size)
{
    const unsigned char *from = bytes;
    for (size_t i = 0; i < size; i += 3) {
        char four[4];
        quartet(four, from + i, size - i < 3 ? size - i : 3);
        (void)fwrite(four, 1, sizeof four, to);
    }
}

static unsigned hex_digit(char c)
{
    return (unsigned)(c <= '9' ? c - '0' : c - 'a' + 10);
}

void murk_html_hash(char out[MURK_HTML_HASH_SIZE], const char *text,
                    size_t size)
{
    char hex[65];
    unsigned char bytes[33] = {0};
    murk_sha256_hex(text, size, hex);
    for (size_t i = 0; i < 32; ++i) {
        bytes[i] = (unsigned char)(hex_digit(hex[2 * i]) * 16 +
                                   hex_digit(hex[2 * i + 1]));
    }
    memcpy(out, "sha256-", 7);
    char *at = out + 7;
    for (size_t i = 0; i < 32; i += 3, at += 4) {
        quartet(at, bytes + i, 32 - i < 3 ? 32 - i : 3);
    }
    *at = '\0';
}
