/* Looks up commands, options, and the values that were given. */
#include "app/options.h"

#include <assert.h>
#include <string.h>

const murk_command *murk_command_find(const char *name)
{
    for (size_t i = 0; i < murk_commands_count; ++i) {
        if (strcmp(murk_commands[i].name, name) == 0) {
            return &murk_commands[i];
        }
    }
    return NULL;
}

static bool is_word(const char *word, const char *text, size_t length)
{
    return word && strlen(word) == length && strncmp(word, text, length) == 0;
}

const murk_option *murk_option_find(const char *text, size_t length)
{
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *option = &murk_option_table[i];
        if (is_word(option->name, text, length) ||
            is_word(option->other, text, length)) {
            return option;
        }
    }
    return NULL;
}

bool murk_option_belongs(const murk_option *option, const char *command)
{
    for (const char *at = option->commands; at && *at; at += strspn(at, " ")) {
        const size_t length = strcspn(at, " ");
        if (command && is_word(command, at, length)) {
            return true;
        }
        at += length;
    }
    return !option->commands;
}

static const murk_given *last_given(const murk_options *options,
                                    const char *name)
{
    assert(murk_option_find(name, strlen(name)));
    for (size_t i = options->n_given; i-- > 0;) {
        if (strcmp(options->given[i].option->name, name) == 0) {
            return &options->given[i];
        }
    }
    return NULL;
}

bool murk_option_is_given(const murk_options *options, const char *name)
{
    return last_given(options, name) != NULL;
}

const char *murk_option_text(const murk_options *options, const char *name)
{
    const murk_given *given = last_given(options, name);
    return given ? given->value : NULL;
}

uint64_t murk_option_number(const murk_options *options, const char *name,
                            uint64_t otherwise)
{
    const murk_given *given = last_given(options, name);
    return given ? given->number : otherwise;
}
