/* Parses the command line by the table of options, and checks that the options
 * belong to the command and to each other. */
#include "app/options.h"

#include "app/command_line.h"
#include "app/option_table.h"
#include "app/option_values.h"
#include "app/unknown.h"
#include "base/pool.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static murk_status find_command(murk_options *out, const char *name,
                                murk_error *err)
{
    for (size_t i = 0; i < murk_commands_count; ++i) {
        if (strcmp(murk_commands[i].name, name) == 0) {
            out->command = &murk_commands[i];
            return MURK_OK;
        }
    }
    return murk_unknown_command(name, err);
}

/* Stores a number of the member's size. */
static void store(murk_options *out, size_t at, size_t size, uint64_t value)
{
    char *member = (char *)out + at;
    const bool is_true = value != 0;
    const unsigned whole = (unsigned)value;
    if (size == sizeof is_true) {
        memcpy(member, &is_true, sizeof is_true);
    } else if (size == sizeof whole) {
        memcpy(member, &whole, sizeof whole);
    } else if (size == sizeof value) {
        memcpy(member, &value, sizeof value);
    }
}

/* The value of one option, checked, into its member or scene key. */
static murk_status apply(murk_options *out, const murk_option *option,
                         const char *value, uint64_t *number, murk_error *err)
{
    const char *name = option->name;
    char digits[32];
    int which = 0;
    murk_status status = MURK_OK;
    /* Check the value. */
    switch (option->kind) {
    case MURK_OPTION_SWITCH:
        *number = 1;
        break;
    case MURK_OPTION_TEXT:
        break;
    case MURK_OPTION_COUNT:
        status = murk_option_count(name, value, option->min, option->max,
                                   number, err);
        snprintf(digits, sizeof digits, "%llu", (unsigned long long)*number);
        break;
    case MURK_OPTION_WORD:
        status = murk_option_choice(name, value, option->words, &which, err);
        *number = (uint64_t)which;
        break;
    case MURK_OPTION_OWN:
        return option->read(out, name, value, err);
    }
    if (status) {
        return status;
    }
    /* Keep it. */
    if (option->key) {
        const bool is_count = option->kind == MURK_OPTION_COUNT;
        return murk_option_override(out, option->key, is_count ? digits : value,
                                    name, err);
    }
    if (option->has_flag) {
        store(out, option->flag_at, sizeof(bool), true);
    }
    if (option->kind == MURK_OPTION_TEXT && option->size) {
        memcpy((char *)out + option->at, &value, sizeof value);
    } else {
        store(out, option->at, option->size, *number);
    }
    return MURK_OK;
}

/* Notes and applies it. */
static murk_status take(murk_options *out, const murk_option *option,
                        const char *value, murk_error *err)
{
    murk_given *grown = realloc(out->given, (out->n_given + 1) * sizeof *grown);
    if (!grown) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the options");
    }
    out->given = grown;
    murk_given *given = &out->given[out->n_given++];
    *given = (murk_given){.option = option, .value = value};
    return apply(out, option, value, &given->number, err);
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

/* One option and its value, which stands behind "=" or in the next argument;
 * *i moves past it. */
static murk_status take_option(murk_options *out, int argc, char **argv, int *i,
                               murk_error *err)
{
    const char *text = argv[*i];
    const char *equals = strncmp(text, "--", 2) == 0 ? strchr(text, '=') : NULL;
    const size_t length = equals ? (size_t)(equals - text) : strlen(text);
    const murk_option *option = murk_option_find(text, length);
    if (!option) {
        option = murk_option_find_short(text);
        if (option) { /* -j2 */
            return take(out, option, text + 2, err);
        }
        return murk_unknown_option(text, length, out->command, err);
    }
    if (!option->argument) {
        return equals ? murk_fail(err, MURK_BAD_VALUE, option->name,
                                  "takes no value")
                      : take(out, option, NULL, err);
    }
    if (equals) {
        return take(out, option, equals + 1, err);
    }
    if (*i + 1 >= argc) {
        return murk_fail(err, MURK_BAD_VALUE, option->name, "needs a value: %s",
                         option->argument);
    }
    return take(out, option, argv[++*i], err);
}

/* Options may stand before the command is known, so they are held against it
 * at the end. */
static murk_status check_belonging(const murk_options *out, int argc,
                                   char **argv, murk_error *err)
{
    for (int i = 1; out->command && i < argc; ++i) {
        if (strcmp(argv[i], "--") == 0) {
            break; /* no options behind it */
        }
        if (argv[i][0] != '-') {
            continue;
        }
        const char *equals = strchr(argv[i], '=');
        const size_t length =
            equals ? (size_t)(equals - argv[i]) : strlen(argv[i]);
        const murk_option *option = murk_option_find(argv[i], length);
        option = option ? option : murk_option_find_short(argv[i]);
        if (!option) {
            continue;
        }
        if (!murk_option_belongs(option, out->command->name)) {
            return murk_fail(err, MURK_BAD_VALUE, option->name,
                             "not an option of murk %s (%s)",
                             out->command->name, option->commands);
        }
        i += option->argument && !equals;
    }
    return MURK_OK;
}

static murk_status check_exports(const murk_options *out, murk_error *err)
{
    /* Exports need a folder and a command that has what they export. */
    const bool is_place = strcmp(out->command->name, "place") == 0;
    const bool is_media = strcmp(out->command->name, "media") == 0;
    if (out->exports && !out->out) {
        return murk_fail(err, MURK_BAD_VALUE, "--export",
                         "needs a folder to write into: -o DIR");
    }
    if ((out->exports & MURK_EXPORTS_OF_PROBLEM) && !is_place) {
        return murk_fail(err, MURK_BAD_VALUE, "--export",
                         "matrix, or-library, lp are of murk place; murk %s "
                         "has fields, photons, surfaces",
                         out->command->name);
    }
    if (out->matrix && (out->exports & ~(unsigned)MURK_EXPORTS_OF_PROBLEM)) {
        return murk_fail(err, MURK_BAD_VALUE, "--export",
                         "fields, photons, surfaces are of a scene, and "
                         "--matrix has none; must be of matrix, or-library, "
                         "lp");
    }
    if (out->voxel && !is_media &&
        !(out->exports & (MURK_EXPORT_FIELDS | MURK_EXPORT_SURFACES))) {
        return murk_fail(err, MURK_BAD_VALUE, "--voxel",
                         "is of --export fields or surfaces, which are not "
                         "asked for");
    }
    return MURK_OK;
}

/* What a command reads, as its arguments name it. */
static const char *kind_of_input(const murk_command *command)
{
    static const char *const kinds[][2] = {
        {"DIR", "folder"}, {"STUDY", "study"}, {"[NAME]", "preset"}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; ++i) {
        const char *word = kinds[i][0];
        if (strncmp(command->arguments, word, strlen(word)) == 0) {
            return kinds[i][1];
        }
    }
    return "scene";
}

murk_status murk_options_parse(murk_options *out, int argc, char **argv,
                               murk_error *err)
{
    *out = (murk_options){.threads = murk_pool_processors(),
                          .progress = MURK_PROGRESS_AUTO};
    murk_status status = MURK_OK;
    bool may_be_option = true;
    for (int i = 1; i < argc && !status; ++i) {
        if (may_be_option && strcmp(argv[i], "--") == 0) {
            may_be_option = false; /* "--" ends the options, as in POSIX */
        } else if (may_be_option && argv[i][0] == '-' && argv[i][1]) {
            status = take_option(out, argc, argv, &i, err);
        } else if (!out->command && strcmp(argv[i], "help") == 0) {
            out->wants_help = true; /* murk help place */
        } else if (!out->command) {
            status = find_command(out, argv[i], err);
        } else if (!out->input) {
            out->input = argv[i];
        } else {
            status =
                murk_fail(err, MURK_BAD_VALUE, "",
                          "%s: one %s at a time, %s is named already", argv[i],
                          kind_of_input(out->command), out->input);
        }
    }
    if (!status) {
        status = check_belonging(out, argc, argv, err);
    }
    if (!status) {
        status = murk_command_line(&out->typed, argc, argv, err);
    }
    if (status || out->wants_help || out->wants_version || out->wants_man) {
        return status;
    }
    if (!out->command) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "no command; try murk --help");
    }
    status = check_exports(out, err);
    if (status) {
        return status;
    }
    if (out->matrix) {
        return out->input ? murk_fail(err, MURK_BAD_VALUE, "--matrix",
                                      "stands in place of a scene, and %s is "
                                      "given as one",
                                      out->input)
                          : MURK_OK;
    }
    if (!out->input && out->command->arguments[0] != '[') {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%s: no %s; usage: murk "
                         "%s %s",
                         out->command->name, kind_of_input(out->command),
                         out->command->name, out->command->arguments);
    }
    return MURK_OK;
}

static void release_words(murk_words_given *words)
{
    for (size_t i = 0; i < words->n; ++i) {
        free(words->word[i]);
    }
    free(words->word);
}

void murk_options_release(murk_options *options)
{
    for (size_t i = 0; i < options->n_kept; ++i) {
        free(options->kept[i]);
    }
    free(options->kept);
    release_words(&options->fit.free);
    release_words(&options->fit.bounds);
    free(options->overrides);
    free(options->given);
    free(options->typed);
    *options = (murk_options){0};
}
