#include "report/html.h"

#include "base/file.h"
#include "base/utf8.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define NO_VALUE   "\xe2\x80\x93" /* en dash */
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

void murk_page_text(FILE *to, const char *text)
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

void murk_page_json(FILE *to, const char *json)
{
    for (; *json; ++json) {
        if (*json == '<') {
            fputs("\\u003c", to);
        } else {
            fputc(*json, to);
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

void murk_page_base64(FILE *to, const void *bytes, size_t size)
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

void murk_page_hash(char out[MURK_PAGE_HASH_SIZE], const char *text,
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

void murk_page_power(FILE *to, double value, int digits)
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

void murk_page_number(FILE *to, double value)
{
    if (!isfinite(value)) {
        fputs(NO_VALUE, to);
    } else if (value == floor(value) && fabs(value) < COUNT_MAX) {
        fprintf(to, "%.0f", value);
    } else {
        murk_page_power(to, value, 5);
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

void murk_page_estimate(FILE *to, double value, double standard_error)
{
    if (!(isfinite(value) && isfinite(standard_error) && standard_error > 0)) {
        murk_page_number(to, value);
        return;
    }
    const double max = fmax(fabs(value), standard_error);
    const int exponent = (int)floor(log10(max));
    const bool has_power = exponent >= 6 || exponent < -4;
    const double unit = has_power ? pow(10, exponent) : 1;
    const double v = value / unit, error = standard_error / unit;
    const int decimals = error > 0 ? decimals_of(error) : 99;
    if (!(unit > 0 && decimals <= 12)) {
        murk_page_power(to, value, 5);
        fputs(PLUS_MINUS, to);
        murk_page_power(to, standard_error, 2);
        return;
    }
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

void murk_page_share(FILE *to, double share, double standard_error)
{
    if (!isfinite(share)) {
        fputs(NO_VALUE, to);
    } else if (isfinite(standard_error)) {
        fprintf(to, "%.2f" PLUS_MINUS "%.2f %%", 100 * share,
                100 * standard_error);
    } else {
        fprintf(to, "%.2f %%", 100 * share);
    }
}

void murk_page_count(FILE *to, double n, const char *one, const char *more)
{
    murk_page_number(to, n);
    fprintf(to, " %s", n == 1 ? one : more);
}

/* ---- blocks ---- */

void murk_page_section_begin(FILE *to, const char *id, const char *title)
{
    fprintf(to, "<section id=\"%s\">\n<h2>%s</h2>\n", id, title);
}

void murk_page_section_end(FILE *to)
{
    fputs("</section>\n", to);
}

void murk_page_paragraph(FILE *to, const char *text)
{
    fputs("<p>", to);
    murk_page_text(to, text);
    fputs("</p>\n", to);
}

/* A key may be broken after its dots, underscores and slashes. */
static void write_head(FILE *to, const char *head)
{
    if (!head) {
        return;
    }
    while (*head) {
        const size_t length = murk_utf8_length(head);
        const size_t n = length > 0 ? length : 1;
        char one[5] = "";
        memcpy(one, head, n);
        murk_page_text(to, one);
        head += n;
        fputs(*head && strchr("._/", one[0]) ? "<wbr>" : "", to);
    }
}

void murk_page_table_begin(FILE *to, const char *caption,
                           const char *const *heads, size_t n)
{
    fputs("<div class=\"table\" tabindex=\"0\" role=\"region\" aria-label=\"",
          to);
    murk_page_text(to, caption);
    fputs("\">\n<table>\n<caption>", to);
    murk_page_text(to, caption);
    fputs(n > 0 ? "</caption>\n<thead><tr>" : "</caption>\n", to);
    for (size_t i = 0; i < n; ++i) {
        const bool is_text = heads[i] && heads[i][0] == '<';
        fprintf(to, "<th scope=\"col\"%s>", is_text ? " class=\"text\"" : "");
        write_head(to, is_text ? heads[i] + 1 : heads[i]);
        fputs("</th>", to);
    }
    fputs(n > 0 ? "</tr></thead>\n<tbody>\n" : "<tbody>\n", to);
}

void murk_page_table_end(FILE *to)
{
    fputs("</tbody>\n</table>\n</div>\n", to);
}

void murk_page_row_begin(FILE *to, const char *head)
{
    fputs("<tr><th scope=\"row\">", to);
    murk_page_text(to, head);
    fputs("</th>", to);
}

void murk_page_row_end(FILE *to)
{
    fputs("</tr>\n", to);
}

void murk_page_cell_text(FILE *to, const char *text)
{
    fputs("<td class=\"text\">", to);
    murk_page_text(to, text);
    fputs("</td>", to);
}

void murk_page_cell_number(FILE *to, double value)
{
    fputs("<td>", to);
    murk_page_number(to, value);
    fputs("</td>", to);
}

void murk_page_cell_share(FILE *to, double share, double standard_error)
{
    fputs("<td>", to);
    murk_page_share(to, share, standard_error);
    fputs("</td>", to);
}

void murk_page_cell_estimate(FILE *to, double value, double standard_error)
{
    fputs("<td>", to);
    murk_page_estimate(to, value, standard_error);
    fputs("</td>", to);
}

void murk_page_shaded_begin(FILE *to, double shade)
{
    const double size = fmin(fabs(shade), 1);
    const int step = size > 0 ? (int)ceil(6 * size) : 0;
    if (step > 0) {
        fprintf(to, "<td class=\"%s%d\">", shade < 0 ? "minus" : "plus", step);
    } else {
        fputs("<td>", to);
    }
}

void murk_page_shaded_end(FILE *to)
{
    fputs("</td>", to);
}

void murk_page_fact(FILE *to, const char *name, const char *text)
{
    murk_page_row_begin(to, name);
    murk_page_cell_text(to, text && *text ? text : NO_VALUE);
    murk_page_row_end(to);
}

void murk_page_fact_number(FILE *to, const char *name, double value,
                           const char *unit)
{
    murk_page_row_begin(to, name);
    fputs("<td class=\"text\">", to);
    murk_page_number(to, value);
    fprintf(to, "%s%s</td>", *unit ? " " : "", unit);
    murk_page_row_end(to);
}

void murk_page_fact_share(FILE *to, const char *name, double share,
                          double standard_error)
{
    murk_page_row_begin(to, name);
    fputs("<td class=\"text\">", to);
    murk_page_share(to, share, standard_error);
    fputs("</td>", to);
    murk_page_row_end(to);
}

void murk_page_line_begin(FILE *to, const char *name)
{
    fprintf(to, "<div><dt>%s</dt><dd>", name);
}

void murk_page_line_end(FILE *to)
{
    fputs("</dd></div>\n", to);
}

void murk_page_more(FILE *to, size_t rows, const char *file)
{
    if (rows > MURK_PAGE_ROWS_MAX) {
        fprintf(to, "<p class=\"note\">The first %d of %zu rows; all are in ",
                MURK_PAGE_ROWS_MAX, rows);
        murk_page_text(to, file);
        fputs(".</p>\n", to);
    }
}
