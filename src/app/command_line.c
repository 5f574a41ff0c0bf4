/* Parses the command line by the table of options, word by word, records it as
 * results keep it, and checks that the options belong to the command and to
 * each other. An unknown word is refused with the nearest known one. */
#include "app/command_line.h"

#include "app/lookup.h"
#include "app/option_values.h"
#include "base/export_kind.h"
#include "base/number.h"
#include "base/pool.h"
#include "base/scalar.h"
#include "base/utf8.h"
#include "base/words.h"

#include <stdlib.h>
#include <string.h>

#define COMMANDS_MAX 32 /* more than the table of commands has */

/* ---- unknown words ---- */

static murk_status unknown_command(const char *name, murk_error *err)
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

/* text[length] begins with a hyphen; command may be NULL. */
static murk_status unknown_option(const char *text, size_t length,
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

/* ---- options ---- */

/* Reads a whole number, also as 1e6, in the range of the option. */
static murk_status read_count(const murk_option *option, const char *text,
                              uint64_t *out, murk_error *err)
{
    return *text != '+' && murk_count_parse(text, out) && *out >= option->min &&
                   *out <= option->max
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, option->name,
                           "%s, must be a whole number %llu..%llu", text,
                           (unsigned long long)option->min,
                           (unsigned long long)option->max);
}

/* Finds a word among those of the option. */
static murk_status read_word(const murk_option *option, const char *value,
                             uint64_t *out, murk_error *err)
{
    char list[96] = "";
    for (uint64_t i = 0; option->words[i]; ++i) {
        if (strcmp(option->words[i], value) == 0) {
            *out = i;
            return MURK_OK;
        }
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s%s",
                 i ? " | " : "", option->words[i]);
    }
    return murk_fail(err, MURK_BAD_VALUE, option->name, "%s, must be %s", value,
                     list);
}

/* Stores a number in a member of this size. */
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

/* Checks the value of one option, and stores the value in a member of *out or
 * as an override of a scene key. *number receives a number, the number of a
 * word, or 1 for a switch. An option of the kind MURK_OPTION_OWN has a function
 * that does all of this. */
static murk_status apply(murk_options *out, const murk_option *option,
                         const char *value, uint64_t *number, murk_error *err)
{
    char digits[32];
    murk_status status = MURK_OK;
    /* Check the value. */
    switch (option->kind) {
    case MURK_OPTION_SWITCH:
        *number = 1;
        break;
    case MURK_OPTION_TEXT:
    case MURK_OPTION_PATH:
        break;
    case MURK_OPTION_COUNT:
        status = read_count(option, value, number, err);
        snprintf(digits, sizeof digits, "%llu", (unsigned long long)*number);
        break;
    case MURK_OPTION_WORD:
        status = read_word(option, value, number, err);
        break;
    case MURK_OPTION_OWN:
        return option->read(out, option->name, value, err);
    }
    if (status) {
        return status;
    }
    /* Store it. */
    if (option->kind == MURK_OPTION_PATH) {
        char *scalar = murk_scalar(value);
        status = scalar ? murk_option_override(out, option->key, scalar,
                                               option->name, err)
                        : murk_no_memory(err, "", "for the options");
        free(scalar);
        return status;
    }
    if (option->key) {
        const bool is_count = option->kind == MURK_OPTION_COUNT;
        return murk_option_override(out, option->key, is_count ? digits : value,
                                    option->name, err);
    }
    if (option->kind == MURK_OPTION_TEXT && option->size) {
        memcpy((char *)out + option->at, &value, sizeof value);
    } else {
        store(out, option->at, option->size, *number);
    }
    return MURK_OK;
}

/* Notes and applies one option. */
static murk_status take(murk_options *out, const murk_option *option,
                        const char *value, murk_error *err)
{
    murk_given *grown = realloc(out->given, (out->n_given + 1) * sizeof *grown);
    if (!grown) {
        return murk_no_memory(err, "", "for the options");
    }
    out->given = grown;
    murk_given *given = &out->given[out->n_given++];
    *given = (murk_given){.option = option, .value = value};
    return apply(out, option, value, &given->number, err);
}

/* Takes one option and its value, which stands behind "=", behind the letter of
 * a short option (-j2) or in the next argument; *i moves to the last argument
 * that was taken. *is_left_out: true if the command line that results keep
 * leaves the option out. */
static murk_status take_option(murk_options *out, int argc, char **argv, int *i,
                               bool *is_left_out, murk_error *err)
{
    const char *text = argv[*i];
    const bool is_long = text[1] == '-';
    const char *equals = is_long ? strchr(text, '=') : NULL;
    const size_t length = equals ? (size_t)(equals - text) : strlen(text);
    const char *value = equals ? equals + 1 : NULL;
    /* The option, by its whole name or by one letter with its value behind. */
    const murk_option *option = murk_option_find(text, length);
    if (!option && !is_long) {
        option = murk_option_find(text, 2);
        option = option && option->argument ? option : NULL;
        value = text + 2;
    }
    if (!option) {
        return unknown_option(text, length, out->command, err);
    }
    /* Its value. */
    *is_left_out = option->is_left_out;
    if (value && !option->argument) {
        return murk_fail(err, MURK_BAD_VALUE, option->name, "takes no value");
    }
    if (!value && option->argument) {
        if (*i + 1 >= argc) {
            return murk_fail(err, MURK_BAD_VALUE, option->name,
                             "needs a value: %s", option->argument);
        }
        value = argv[++*i];
    }
    return take(out, option, value, err);
}

/* ---- checks ---- */

/* Options may stand before the command, so whether the command has them is
 * checked at the end. */
static murk_status check_belonging(const murk_options *out, murk_error *err)
{
    for (size_t i = 0; out->command && i < out->n_given; ++i) {
        const murk_option *option = out->given[i].option;
        if (!murk_option_belongs(option, out->command->name)) {
            return murk_fail(err, MURK_BAD_VALUE, option->name,
                             "not an option of murk %s (%s)",
                             out->command->name, option->commands);
        }
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

/* Checks that options of murk render come with the options that they need. */
static murk_status check_picture(const murk_options *out, murk_error *err)
{
    static const struct {
        const char *option, *needs, *shown;
    } rows[] = {{"--from-sensor", "--sensors", "--sensors FILE"},
                {"--exposure", "--png", "--png"},
                {"--range", "--false-colour", "--false-colour CHANNEL"},
                {"--scale", "--false-colour", "--false-colour CHANNEL"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        if (murk_option_is_given(out, rows[i].option) &&
            !murk_option_is_given(out, rows[i].needs)) {
            return murk_fail(err, MURK_BAD_VALUE, rows[i].option,
                             "goes with %s, which is not given", rows[i].shown);
        }
    }
    const murk_render_options *r = &out->render;
    const bool is_log = murk_option_number(out, "--scale", 0) == 1;
    return r->has_range && is_log && !(r->range[0] > 0)
               ? murk_fail(err, MURK_BAD_VALUE, "--range",
                           "%g:%g, must be above 0 with --scale log",
                           r->range[0], r->range[1])
               : MURK_OK;
}

/* The noun for the input of a command, in messages. */
static const char *const NOUN[] = {
    [MURK_INPUT_SCENE] = "scene",   [MURK_INPUT_STUDY] = "study",
    [MURK_INPUT_FOLDER] = "folder", [MURK_INPUT_PARTS] = "folder",
    [MURK_INPUT_PRESET] = "preset", [MURK_INPUT_START_SCENE] = "scene",
    [MURK_INPUT_KEY] = "key",       [MURK_INPUT_NONE] = "file",
};

static murk_status check_input(const murk_options *out, murk_error *err)
{
    if (out->matrix) {
        return out->input ? murk_fail(err, MURK_BAD_VALUE, "--matrix",
                                      "stands in place of a scene, and %s is "
                                      "given as one",
                                      out->input)
                          : MURK_OK;
    }
    return out->input || out->command->arguments[0] == '['
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, "",
                           "%s: no %s; usage: murk %s %s", out->command->name,
                           NOUN[out->command->input], out->command->name,
                           out->command->arguments);
}

/* ---- the command line ---- */

/* Checks that a command that prints one text is given nothing of a scene. */
static murk_status check_text_alone(const murk_options *out, murk_error *err)
{
    return out->command->is_text_alone && (out->n_overrides || out->json)
               ? murk_fail(err, MURK_BAD_VALUE, "",
                           "%s: prints one text and reads no scene, so --set, "
                           "--seed and --format json have no meaning",
                           out->command->name)
               : MURK_OK;
}

/* True if a command has the name of a key of a scene. False, too, if no context
 * can be made: the command that is run makes one and tells the reason. */
static bool is_key(const murk_command *command)
{
    char name[64];
    murk_lookup lookup;
    snprintf(name, sizeof name, "scene.%s", command->name);
    const murk_status status = murk_lookup_begin(&lookup, name, NULL);
    murk_lookup_end(&lookup);
    return !status;
}

static murk_status add_word(murk_words_given *words, const char *word,
                            murk_error *err)
{
    const char **grown = realloc(words->word, (words->n + 2) * sizeof *grown);
    if (!grown) {
        return murk_no_memory(err, "", "for the options");
    }
    words->word = grown;
    words->word[words->n++] = word;
    words->word[words->n] = NULL;
    return MURK_OK;
}

/* Takes a word that is no option: the command or the input. */
static murk_status take_word(murk_options *out, const char *word,
                             murk_error *err)
{
    const bool is_help =
        out->command && strcmp(out->command->name, "help") == 0;
    const murk_command *command = murk_command_find(word);
    if (!out->command) {
        out->command = command;
        return command ? MURK_OK : unknown_command(word, err);
    }
    if (out->command->input == MURK_INPUT_PARTS) {
        out->input = out->input ? out->input : word;
        return add_word(&out->inputs, word, err);
    }
    if (is_help && !out->input && command && !is_key(command)) {
        out->command = command; /* murk help place */
        out->wants_help = true;
    } else if (!out->input) {
        out->input = word;
    } else {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%s: one %s at a time, %s is named already", word,
                         NOUN[out->command->input], out->input);
    }
    return MURK_OK;
}

static murk_status take_all(murk_options *out, int argc, char **argv,
                            murk_error *err)
{
    murk_status status = MURK_OK;
    bool may_be_option = true;
    for (int i = 1; i < argc && !status; ++i) {
        const int first = i;
        bool is_left_out = false;
        if (may_be_option && strcmp(argv[i], "--") == 0) {
            may_be_option = false; /* "--" ends the options, as in POSIX */
        } else if (may_be_option && argv[i][0] == '-' && argv[i][1]) {
            status = take_option(out, argc, argv, &i, &is_left_out, err);
        } else {
            status = take_word(out, argv[i], err);
        }
        for (int k = first; k <= i && !is_left_out && !status; ++k) {
            status = add_word(&out->repeated, argv[k], err);
        }
    }
    return status;
}

/* Joins the words that are kept to a line for a shell. */
static murk_status join_words(murk_options *out, murk_error *err)
{
    size_t size = 0;
    FILE *typed = open_memstream(&out->typed, &size);
    bool is_whole = typed && fputs("murk", typed) >= 0;
    for (size_t i = 0; is_whole && i < out->repeated.n; ++i) {
        char *word = murk_utf8_shell_word(out->repeated.word[i]);
        is_whole = word && fprintf(typed, " %s", word) > 0;
        free(word);
    }
    if (typed && fclose(typed) != 0) {
        is_whole = false;
    }
    return is_whole ? MURK_OK : murk_no_memory(err, "", "for the options");
}

murk_status murk_options_parse(murk_options *out, int argc, char **argv,
                               murk_error *err)
{
    *out = (murk_options){.threads = murk_pool_processors(),
                          .progress = MURK_PROGRESS_AUTO};
    /* Take the words, and record them as results keep them. */
    murk_status status = take_all(out, argc, argv, err);
    if (!status) {
        status = join_words(out, err);
    }
    /* Check them against the command and each other. */
    if (!status) {
        status = check_belonging(out, err);
    }
    if (status || out->wants_help || out->wants_version || out->wants_man ||
        murk_option_is_given(out, "--completion")) {
        return status;
    }
    if (!out->command) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "no command; try murk --help");
    }
    status = check_text_alone(out, err);
    if (!status) {
        status = check_exports(out, err);
    }
    if (!status) {
        status = check_input(out, err);
    }
    if (!status && out->shard.count && !out->out) {
        status = murk_fail(err, MURK_BAD_VALUE, "--shard",
                           "needs a folder to write the part into: -o DIR");
    }
    return status ? status : check_picture(out, err);
}

void murk_options_release(murk_options *options)
{
    for (size_t i = 0; i < options->n_owned; ++i) {
        free(options->owned[i]);
    }
    free(options->owned);
    free(options->inputs.word);
    free(options->repeated.word);
    free(options->fit.free.word);
    free(options->fit.bounds.word);
    free(options->overrides);
    free(options->given);
    free(options->typed);
    *options = (murk_options){0};
}
