/* Writes a text as a scalar of YAML: plain where that can only be read as the
 * text, in double quotes elsewhere. */
#include "base/scalar.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* True if a text may stand without quotes everywhere: the text is no number,
 * null or boolean of YAML, begins with a letter, / or _, and has only
 * letters, digits, _ . / and -. */
static bool is_plain(const char *text)
{
    static const char *const words[] = {"null", "Null",  "NULL",
                                        "true", "false", NULL};
    const bool is_letter = (text[0] >= 'a' && text[0] <= 'z') ||
                           (text[0] >= 'A' && text[0] <= 'Z');
    if (!is_letter && text[0] != '/' && text[0] != '_') {
        return false;
    }
    for (const char *const *word = words; *word; ++word) {
        if (strcmp(text, *word) == 0) {
            return false;
        }
    }
    return strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                        "0123456789_./-") == strlen(text);
}

void murk_scalar_print(FILE *out, const char *text)
{
    if (is_plain(text)) {
        fputs(text, out);
        return;
    }
    fputc('"', out);
    for (const unsigned char *p = (const unsigned char *)text; *p; ++p) {
        if (*p == '"' || *p == '\\') {
            fprintf(out, "\\%c", *p);
        } else if (*p < 0x20 || *p == 0x7F) {
            fprintf(out, "\\x%02X", *p);
        } else {
            fputc(*p, out);
        }
    }
    fputc('"', out);
}

char *murk_scalar(const char *text)
{
    char *scalar = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&scalar, &size);
    if (!out) {
        return NULL;
    }
    murk_scalar_print(out, text);
    if (fclose(out)) {
        free(scalar);
        return NULL;
    }
    return scalar;
}
