/* The command line as results record it: quoted for a shell, without options
 * that change no result. */
#include "app/command_line.h"

#include "app/option_table.h"
#include "base/utf8.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static char *append(char *line, const char *word)
{
    char *quoted = murk_utf8_shell_word(word);
    const size_t at = strlen(line);
    char *grown = quoted ? realloc(line, at + strlen(quoted) + 2) : NULL;
    if (grown) {
        grown[at] = ' ';
        strcpy(grown + at + 1, quoted);
    } else {
        free(line);
    }
    free(quoted);
    return grown;
}

/* How many arguments this one is with its value, which may be the next. */
static int words_of(const murk_option *option, const char *text)
{
    const bool has_value = strncmp(text, "--", 2) == 0
                               ? strchr(text, '=') != NULL
                               : strlen(text) > 2;
    return option && option->argument && !has_value ? 2 : 1;
}

murk_status murk_command_line(char **out, int argc, char **argv,
                              murk_error *err)
{
    char *line = strdup("murk");
    bool may_be_option = true;
    for (int i = 1; line && i < argc;) {
        const char *text = argv[i];
        const bool is_option = may_be_option && text[0] == '-' && text[1];
        const bool is_long = strncmp(text, "--", 2) == 0;
        const size_t length = is_long ? strcspn(text, "=") : strlen(text);
        const murk_option *option =
            is_option ? murk_option_find(text, length) : NULL;
        if (is_option && !option) {
            option = murk_option_find_short(text);
        }
        may_be_option &= strcmp(text, "--") != 0; /* which ends the options */
        const int words = words_of(option, text);
        for (int k = 0; line && k < words && i < argc; ++k, ++i) {
            if (!option || !option->is_left_out) {
                line = append(line, argv[i]);
            }
        }
    }
    if (!line) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the options");
    }
    *out = line;
    return MURK_OK;
}
