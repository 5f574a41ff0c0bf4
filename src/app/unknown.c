/* Messages about unknown commands and options, with a guess at the intended
 * one. */
#include "app/unknown.h"

#include "app/option_table.h"
#include "scene/words.h"

#include <stdio.h>
#include <string.h>

#define COMMANDS_MAX 32 /* more than the table of commands has */

murk_status murk_unknown_command(const char *name, murk_error *err)
{
    const char *known[COMMANDS_MAX] = {NULL};
    char all[160] = "", shown[64];
    size_t at = 0;
    const size_t n = murk_commands_count;
    /* The list of all commands, for the message. */
    for (size_t i = 0; i < n && i < COMMANDS_MAX; ++i) {
        known[i] = murk_commands[i].name;
        at += (size_t)snprintf(all + at, at < sizeof all ? sizeof all - at : 0,
                               "%s%s",
                               i == 0      ? ""
                               : i + 1 < n ? ", "
                                           : " and ",
                               known[i]);
    }
    /* The nearest name, or a hint that a file comes second. */
    murk_words_show(shown, sizeof shown, name);
    const char *meant = murk_words_meant(name, known, n);
    if (meant) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%s: no such command, did you mean %s?", shown, meant);
    }
    if (strpbrk(name, "./")) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%s: no such command; a file comes after the command, "
                         "as in murk check %s",
                         shown, shown);
    }
    return murk_fail(err, MURK_BAD_VALUE, "",
                     "%s: no such command; there are %s (murk --help)", shown,
                     all);
}

murk_status murk_unknown_option(const char *text, size_t length,
                                const murk_command *command, murk_error *err)
{
    const char *known[MURK_OPTIONS_MAX];
    size_t n = 0;
    char word[64], shown[64];
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *option = &murk_option_table[i];
        if (option->help &&
            (!command || murk_option_belongs(option, command->name))) {
            known[n++] = option->name;
        }
    }
    snprintf(word, sizeof word, "%.*s", (int)(length < 63 ? length : 63), text);
    murk_words_show(shown, sizeof shown, word);
    const char *meant = murk_words_meant(word, known, n);
    if (meant) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%s: no such option, did you mean %s?", shown, meant);
    }
    return murk_fail(err, MURK_BAD_VALUE, "",
                     "%s: no such option (murk %s%s--help)", shown,
                     command ? command->name : "", command ? " " : "");
}
