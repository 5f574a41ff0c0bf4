/* Prints lines for people: breaks them at 80 columns, and escapes control
 * characters of names, so that no name can act on the terminal. */
#include "base/print.h"

#include "base/utf8.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COLUMNS 80 /* of a terminal */

/* The text so far of a line that has not ended. */
static _Thread_local struct {
    char *text;
    size_t size, capacity;
} open_line;

/* The receiver of lines that have ended, and the first argument of its calls;
 * take NULL: lines are shown. */
static _Thread_local struct {
    murk_print_take *take;
    void *to;
} receiver;

/* Column at which a broken line goes on: that at which its text begins. */
static size_t indent_of(const char *line)
{
    const size_t lead = strspn(line, " ");
    const bool has_label = lead == 0 && strlen(line) > MURK_PRINTED_LABEL &&
                           line[MURK_PRINTED_LABEL - 1] == ' ' &&
                           line[MURK_PRINTED_LABEL] != ' ';
    return has_label ? MURK_PRINTED_LABEL : lead > 0 ? lead : 2;
}

void murk_print_line(const char *line)
{
    const size_t indent = indent_of(line);
    size_t begin = 0; /* blanks before the text of this part */
    while (strlen(line) + begin > COLUMNS) {
        size_t cut = COLUMNS - begin;
        while (cut > indent && line[cut] != ' ') {
            --cut;
        }
        if (line[cut] != ' ' || cut <= (begin ? 0 : indent)) {
            cut = strcspn(line + indent, " ") + indent; /* a word is too long */
            if (!line[cut]) {
                break;
            }
        }
        size_t end = cut; /* without the blanks before the cut */
        while (end > 0 && line[end - 1] == ' ') {
            --end;
        }
        printf("%*s%.*s\n", (int)begin, "", (int)end, line);
        line += cut + strspn(line + cut, " ");
        begin = indent;
    }
    printf("%*s%s\n", (int)begin, "", line);
}

/* Shows one line, or hands it to the receiver, with control characters escaped
 * as at most four bytes for each byte. */
static void show(const char *line)
{
    const size_t size = 4 * strlen(line) + 1;
    char *shown = malloc(size);
    if (shown) {
        murk_utf8_escape(shown, size, line);
    }
    if (shown && receiver.take) {
        receiver.take(receiver.to, shown);
    } else if (shown) {
        murk_print_line(shown);
    }
    free(shown);
}

static bool make_space(size_t more)
{
    if (open_line.size + more < open_line.capacity) {
        return true;
    }
    const size_t capacity = 2 * (open_line.size + more) + 256;
    char *grown = realloc(open_line.text, capacity);
    if (grown) {
        open_line.text = grown;
        open_line.capacity = capacity;
    }
    return grown != NULL;
}

/* Appends text to the open line, and shows each line that is ended by the byte
 * `end` in the new text. */
static void add_text(const char *format, char end, va_list args)
{
    va_list again;
    va_copy(again, args);
    const int n = vsnprintf(NULL, 0, format, args);
    if (n > 0 && make_space((size_t)n + 1)) {
        char *line = open_line.text, *from = line + open_line.size, *stop;
        vsnprintf(from, (size_t)n + 1, format, again);
        while ((stop = strchr(from, end))) {
            *stop = '\0';
            show(line);
            line = from = stop + 1;
        }
        open_line.size = strlen(line);
        memmove(open_line.text, line, open_line.size + 1);
    }
    va_end(again);
}

/* A line ends with the line feeds of `format`; those of names among the
 * arguments are shown escaped. To tell them apart, the line feeds of `format`
 * are replaced by a byte that neither `format` nor any text in UTF-8 has. */
void murk_print(const char *format, ...)
{
    static const char line_end = '\xff';
    char *marked = strdup(format);
    if (!marked) {
        return;
    }
    for (char *c = marked; *c; ++c) {
        *c = *c == '\n' ? line_end : *c;
    }
    va_list args;
    va_start(args, format);
    add_text(marked, line_end, args);
    va_end(args);
    free(marked);
    if (open_line.size == 0) {
        free(open_line.text);
        open_line.text = NULL;
        open_line.capacity = 0;
    }
}

void murk_print_into(murk_print_take *take, void *to, murk_print_results *print,
                     const void *of)
{
    receiver.take = take;
    receiver.to = to;
    print(of);
    receiver.take = NULL;
}

void murk_print_json(const char *text)
{
    bool has_end = false;
    while (*text) {
        const size_t length = murk_utf8_length(text);
        /* U+FFFD stands for a byte that is not part of a character */
        const uint32_t control = length ? murk_utf8_control(text) : 0xfffd;
        has_end = *text == '\n';
        if (control && !has_end && *text != '\t') {
            printf("\\u%04x", (unsigned)control);
        } else {
            fwrite(text, 1, length, stdout);
        }
        text += length ? length : 1;
    }
    if (!has_end) {
        putchar('\n');
    }
}
