/* Text, bytes and numbers of the page. Numbers have the form that the page's
 * script gives them, too (tools/report/format.js). */
#include "report/html.h"

#include "base/file.h"
#include "base/utf8.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define UNKNOWN    "\xef\xbf\xbd" /* U+FFFD */
#define PLUS_MINUS " \xc2\xb1 "

/* Whole numbers below it are written out. */
#define COUNT_MAX 1e10

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

/* Up to three bytes as four characters. */
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

/* ---- numbers ---- */

static void write_exponent(FILE *to, int exponent)
{
    static const char *const digits[] = {"⁰", "¹", "²", "³", "⁴",
                                         "⁵", "⁶", "⁷", "⁸", "⁹"};
    char text[16];
    snprintf(text, sizeof text, "%d", abs(exponent));
    fputs(exponent < 0 ? "10⁻" : "10", to);
    for (const char *c = text; *c; ++c) {
        fputs(digits[*c - '0'], to);
    }
}

void murk_html_power(FILE *to, double value, int digits)
{
    char text[32];
    snprintf(text, sizeof text, "%.*g", digits, value);
    char *e = strchr(text, 'e');
    if (!e) {
        fputs(text, to);
        return;
    }
    *e = '\0';
    if (strcmp(text, "1") != 0) {
        fprintf(to, "%s·", text);
    }
    write_exponent(to, atoi(e + 1));
}

void murk_html_number(FILE *to, double value)
{
    if (!isfinite(value)) {
        fputs(MURK_HTML_NONE, to);
    } else if (value == floor(value) && fabs(value) < COUNT_MAX) {
        fprintf(to, "%.0f", value);
    } else {
        murk_html_power(to, value, 5);
    }
}

/* Decimals that two digits of an error need; negative: it ends before the
 * point. */
static int decimals_of(double standard_error)
{
    const int exponent = (int)floor(log10(standard_error));
    /* .0996 is .10 to two digits */
    const bool rounds_up = standard_error / pow(10, exponent) >= 9.95;
    return 1 - exponent - rounds_up;
}

void murk_html_estimate(FILE *to, double value, double standard_error)
{
    if (!(isfinite(value) && isfinite(standard_error) && standard_error > 0)) {
        murk_html_number(to, value);
        return;
    }
    /* a common power of ten of both, if one of them needs it */
    const double max = fmax(fabs(value), standard_error);
    const int exponent = (int)floor(log10(max));
    const bool has_power = exponent >= 6 || exponent < -4;
    const double unit = has_power ? pow(10, exponent) : 1;
    const double v = value / unit, error = standard_error / unit;
    const int decimals = error > 0 ? decimals_of(error) : 99;
    if (!(unit > 0 && decimals <= 12)) {
        murk_html_power(to, value, 5);
        fputs(PLUS_MINUS, to);
        murk_html_power(to, standard_error, 2);
        return;
    }
    /* both to the decimals that two digits of the error need */
    const double ten = decimals < 0 ? pow(10, -decimals) : 1;
    const int shown = decimals > 0 ? decimals : 0;
    fputs(has_power ? "(" : "", to);
    fprintf(to, "%.*f" PLUS_MINUS "%.*f", shown,
            decimals < 0 ? ten * round(v / ten) : v, shown,
            decimals < 0 ? ten * round(error / ten) : error);
    if (has_power) {
        fputs(")·", to);
        write_exponent(to, exponent);
    }
}

void murk_html_share(FILE *to, double share, double standard_error)
{
    if (!isfinite(share)) {
        fputs(MURK_HTML_NONE, to);
    } else if (isfinite(standard_error)) {
        fprintf(to, "%.2f" PLUS_MINUS "%.2f %%", 100 * share,
                100 * standard_error);
    } else {
        fprintf(to, "%.2f %%", 100 * share);
    }
}
