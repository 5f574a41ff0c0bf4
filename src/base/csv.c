/* Reads the cells of CSV text one after the other (base/csv.h). The state is
 * the position of the next cell. The cells before it have been changed in
 * place: quotes are removed, and '\0' ends each cell. */
#include "base/csv.h"

#include <string.h>

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

static void skip_blanks(murk_csv *csv)
{
    while (is_blank(*csv->next)) {
        ++csv->next;
    }
}

/* Steps over a comma or a line end; stays at the end of the text. */
static void skip_separator(murk_csv *csv)
{
    csv->line += *csv->next == '\n';
    csv->next += csv->next < csv->end;
}

bool murk_csv_find_line(murk_csv *csv)
{
    while (csv->next < csv->end) {
        char *const begin = csv->next;
        skip_blanks(csv);
        if (*csv->next != '#' && *csv->next != '\n' && *csv->next != '\0') {
            csv->next = begin;
            return true;
        }
        csv->next += strcspn(csv->next, "\n");
        skip_separator(csv);
    }
    return false;
}

/* Reads a cell in quotes; csv->next is at the opening quote. Inside the cell
 * two quotes stand for one. */
static const char *read_quoted(murk_csv *csv)
{
    char *to = csv->next++;
    const size_t line = csv->line;
    for (;; ++csv->next) {
        if (*csv->next == '"' && *++csv->next != '"') {
            break;
        }
        if (*csv->next == '\0' || (*csv->next == '\n' && csv->is_one_line)) {
            csv->line = line;
            return csv->is_one_line ? "a quote is not closed in its line"
                                    : "a quote is not closed";
        }
        csv->line += *csv->next == '\n';
        *to++ = *csv->next;
    }
    /* Only blanks may follow before the next comma or line end. The text
     * without quotes is shorter than the cell, so the '\0' behind the text does
     * not overwrite the separator. */
    *to = '\0';
    skip_blanks(csv);
    return *csv->next && *csv->next != ',' && *csv->next != '\n'
               ? "text behind a closing quote, must be a comma or the end of "
                 "the line"
               : NULL;
}

const char *murk_csv_read_cell(murk_csv *csv, char **cell, bool *is_last)
{
    skip_blanks(csv);
    char *stop = NULL;
    *cell = csv->next;
    if (*csv->next == '"') {
        const char *fault = read_quoted(csv);
        if (fault) {
            return fault;
        }
    } else {
        csv->next += strcspn(csv->next, ",\n");
        stop = csv->next;
        while (stop > *cell && is_blank(stop[-1])) {
            --stop;
        }
    }
    *is_last = *csv->next != ',';
    skip_separator(csv);
    if (stop) {
        *stop = '\0'; /* may overwrite the separator, which was passed */
    }
    return NULL;
}
