/* Cuts the text of a photometric file into lines and numbers. Line ends are
 * LF, CR LF or CR. */
#include "luminaire/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/log.h"
#include "base/number.h"
#include "base/words.h"

#define CTRL_Z 0x1A /* ends a text in DOS */

murk_status murk_luminaire_text_begin(murk_luminaire_text *out,
                                      const char *path, char *text, size_t size,
                                      murk_error *err)
{
    *out = (murk_luminaire_text){.path = path,
                                 .next = text,
                                 .end = text + size,
                                 .line = 1,
                                 .word_line = 1,
                                 .err = err};
    /* Bytes that are no text, at the beginning and at the end. */
    const char *nul = memchr(text, '\0', size);
    if (nul) {
        size_t line = 1;
        for (const char *p = text; p < nul; ++p) {
            line += *p == '\n';
        }
        return murk_luminaire_text_fail(out, line, "a NUL byte, must be text");
    }
    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0) {
        out->next += 3;
    }
    if (out->end > out->next && out->end[-1] == CTRL_Z) {
        *--out->end = '\0';
    }
    return out->end > out->next
               ? MURK_OK
               : murk_luminaire_text_fail(out, 1,
                                          "an empty file, must be a "
                                          "luminaire (IES LM-63 or "
                                          "EULUMDAT)");
}

murk_status murk_luminaire_text_fail(const murk_luminaire_text *text,
                                     size_t line, const char *format, ...)
{
    char where[320], message[256];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    snprintf(where, sizeof where, "%.290s:%zu", text->path, line);
    return murk_fail(text->err, MURK_BAD_FILE, where, "%s", message);
}

void murk_luminaire_text_warn(const murk_luminaire_text *text, size_t line,
                              const char *format, ...)
{
    char where[320], message[256];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    snprintf(where, sizeof where, "%.290s:%zu", text->path, line);
    murk_warn(where, "%s", message);
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/* Passes over the line end at text->next, if there is one. */
static void pass_line_end(murk_luminaire_text *text)
{
    if (*text->next == '\r' || *text->next == '\n') {
        const bool is_pair = text->next[0] == '\r' && text->next[1] == '\n';
        text->next += is_pair ? 2 : 1;
        ++text->line;
    }
}

char *murk_luminaire_text_line(murk_luminaire_text *text, size_t *line)
{
    if (text->next >= text->end) {
        return NULL;
    }
    *line = text->line;
    char *begin = text->next;
    char *end = begin + strcspn(begin, "\r\n");
    text->next = end;
    pass_line_end(text);
    while (begin < end && is_blank(*begin)) {
        ++begin;
    }
    while (end > begin && is_blank(end[-1])) {
        --end;
    }
    *end = '\0';
    return begin;
}

/* Passes over blanks and line ends. */
static void pass_blanks(murk_luminaire_text *text)
{
    while (text->next < text->end) {
        if (is_blank(*text->next)) {
            ++text->next;
        } else if (*text->next == '\r' || *text->next == '\n') {
            pass_line_end(text);
        } else {
            return;
        }
    }
}

static murk_status fail_word(const murk_luminaire_text *text, size_t line,
                             const char *what, const char *found, double min,
                             double max, const char *kind)
{
    char shown[48];
    murk_words_show(shown, sizeof shown, found);
    return murk_luminaire_text_fail(
        text, line, "%s: %s, must be a %s %.10g..%.10g", what,
        found[0] ? shown : "nothing", kind, min, max);
}

/* Reads the next word; one comma behind a word is part of the separator. */
static murk_status read_word(murk_luminaire_text *text, const char *what,
                             char *word, size_t size)
{
    pass_blanks(text);
    text->word_line = text->line;
    const size_t length = strcspn(text->next, " \t\v\f\r\n,");
    if (length == 0 || text->next >= text->end) {
        return murk_luminaire_text_fail(
            text, text->line, "%s: %s, must be a number", what,
            text->next >= text->end ? "the file ends" : "two commas");
    }
    if (length >= size) {
        return murk_luminaire_text_fail(
            text, text->line, "%s: %zu bytes, must be a number of at most %zu",
            what, length, size - 1);
    }
    snprintf(word, size, "%.*s", (int)length, text->next);
    text->next += length;
    pass_blanks(text);
    if (*text->next == ',') {
        ++text->next;
    }
    return MURK_OK;
}

murk_status murk_luminaire_text_number(murk_luminaire_text *text,
                                       const char *what, double min, double max,
                                       double *out)
{
    char word[64];
    const murk_status status = read_word(text, what, word, sizeof word);
    if (status) {
        return status;
    }
    return murk_number_parse(word, out) && *out >= min && *out <= max
               ? MURK_OK
               : fail_word(text, text->word_line, what, word, min, max,
                           "number");
}

murk_status murk_luminaire_text_count(murk_luminaire_text *text,
                                      const char *what, double min, double max,
                                      size_t *out)
{
    char word[64];
    uint64_t count = 0;
    const murk_status status = read_word(text, what, word, sizeof word);
    if (status) {
        return status;
    }
    if (!murk_count_parse(word, &count) || (double)count < min ||
        (double)count > max) {
        return fail_word(text, text->word_line, what, word, min, max,
                         "whole number");
    }
    *out = (size_t)count;
    return MURK_OK;
}

murk_status murk_luminaire_text_end(murk_luminaire_text *text)
{
    pass_blanks(text);
    if (text->next >= text->end) {
        return MURK_OK;
    }
    char shown[48];
    const size_t line = text->line;
    text->next[strcspn(text->next, "\r\n")] = '\0';
    murk_words_show(shown, sizeof shown, text->next);
    return murk_luminaire_text_fail(
        text, line, "%s behind the last value, must be nothing", shown);
}

murk_status murk_luminaire_text_field(murk_luminaire_text *text,
                                      const char *what, bool may_be_blank,
                                      double min, double max, double *out)
{
    size_t line;
    char *word = murk_luminaire_text_line(text, &line);
    if (!word) {
        return murk_luminaire_text_fail(
            text, text->line, "%s: the file ends, must be a line", what);
    }
    if (may_be_blank && word[0] == '\0') {
        *out = 0;
        return MURK_OK;
    }
    char *comma = strchr(word, ',');
    if (comma && !strchr(word, '.')) {
        *comma = '.';
    }
    return murk_number_parse(word, out) && *out >= min && *out <= max
               ? MURK_OK
               : fail_word(text, line, what, word, min, max, "number");
}

void murk_luminaire_text_copy(char *out, size_t size, const char *text)
{
    size_t n = 0;
    for (; text[n] && n + 1 < size; ++n) {
        out[n] = text[n] >= ' ' && text[n] <= '~' ? text[n] : '?';
    }
    out[n] = '\0';
}

murk_status murk_luminaire_text_rising(const murk_luminaire_text *text,
                                       size_t line, const char *what,
                                       const double *angle, size_t index)
{
    return index == 0 || angle[index] > angle[index - 1]
               ? MURK_OK
               : murk_luminaire_text_fail(text, line,
                                          "%s: %.10g behind %.10g, must rise",
                                          what, angle[index], angle[index - 1]);
}
