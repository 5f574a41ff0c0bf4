#include "app/options.h"

#include "app/command_line.h"
#include "app/option_table.h"
#include "app/option_values.h"
#include "app/render_options.h"
#include "app/unknown.h"
#include "base/pool.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define THREADS_MAX 256
#define REPEATS_MAX 10000
#define STARTS_MAX  1000
#define TRACES_MAX  1000
#define NEXT_MAX    100

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

static murk_status apply(murk_options *out, const murk_option *option,
                         const char *value, murk_error *err)
{
    static const char *const formats[] = {"text", "json", NULL};
    static const char *const methods[] = {"maps", "path", "maps-only", NULL};
    static const char *const progresses[] = {"never", "auto", "always", NULL};
    const char *name = option->name;
    murk_status status = MURK_OK;
    uint64_t n = 0;
    int which = 0;
    switch (option->id) {
    case MURK_OPTION_OUT:
        out->out = value;
        if (!*value) {
            status = murk_fail(err, MURK_BAD_VALUE, name,
                               "\"\", must name a folder");
        }
        break;
    case MURK_OPTION_SEED:
        return murk_option_set_count(out, name, "seed", value, 0, UINT32_MAX,
                                     err);
    case MURK_OPTION_THREADS:
        status = murk_option_count(name, value, 1, THREADS_MAX, &n, err);
        out->threads = (unsigned)n;
        break;
    case MURK_OPTION_EMIT:
        return murk_option_set_count(out, name, "photons.emit", value, 1,
                                     UINT32_MAX, err);
    case MURK_OPTION_STORE:
        return murk_option_set_count(out, name, "photons.store", value, 1,
                                     UINT32_MAX, err);
    case MURK_OPTION_COUNT:
        return murk_option_set_count(out, name, "sensors.count", value, 1,
                                     1000000, err);
    case MURK_OPTION_TARGET:
        return murk_option_override(out, "sensors.target", value, name, err);
    case MURK_OPTION_BUDGET:
        return murk_option_override(out, "sensors.budget", value, name, err);
    case MURK_OPTION_SET:
        if (*value == '@') {
            return murk_option_values_of(out, value + 1, err);
        }
        if (!strchr(value, '=') || *value == '=') {
            return murk_fail(err, MURK_BAD_VALUE, name, "%s, must be KEY=VALUE",
                             value);
        }
        return murk_option_override(out, "", value, NULL, err);
    case MURK_OPTION_DATA:
        out->fit.data = value;
        break;
    case MURK_OPTION_FREE:
        return murk_option_words(&out->fit.free, value, name, err);
    case MURK_OPTION_BOUNDS:
        return murk_option_words(&out->fit.bounds, value, name, err);
    case MURK_OPTION_LOSS:
        return murk_option_loss(&out->fit, name, value, err);
    case MURK_OPTION_STARTS:
        return murk_option_count(name, value, 1, STARTS_MAX, &out->fit.starts,
                                 err);
    case MURK_OPTION_TRACES:
        return murk_option_count(name, value, 1, TRACES_MAX, &out->fit.traces,
                                 err);
    case MURK_OPTION_NEXT:
        return murk_option_count(name, value, 1, NEXT_MAX, &out->fit.next, err);
    case MURK_OPTION_PREDICT:
        out->fit.predict = value;
        break;
    case MURK_OPTION_LIGHT:
        out->light = value;
        break;
    case MURK_OPTION_SENSORS:
        out->sensors = value;
        break;
    case MURK_OPTION_MATRIX:
        out->matrix = value;
        break;
    case MURK_OPTION_CAMERA:
        out->camera = value;
        break;
    case MURK_OPTION_METHOD:
        status = murk_option_choice(name, value, methods, &which, err);
        out->by_path = which == 1;
        out->maps_only = which == 2;
        break;
    case MURK_OPTION_FROM_SENSOR:
    case MURK_OPTION_PIXELS:
    case MURK_OPTION_SAMPLES:
    case MURK_OPTION_PNG:
    case MURK_OPTION_EXPOSURE:
    case MURK_OPTION_FALSE_COLOUR:
    case MURK_OPTION_RANGE:
    case MURK_OPTION_SCALE:
        return murk_render_option(&out->render, option, value, err);
    case MURK_OPTION_PROFILE:
        out->profile = value;
        break;
    case MURK_OPTION_COLUMN:
        out->column = value;
        break;
    case MURK_OPTION_ROWS:
        out->rows = value;
        break;
    case MURK_OPTION_VOXEL:
        out->voxel = value;
        break;
    case MURK_OPTION_WIDTH:
        out->width = value;
        break;
    case MURK_OPTION_EXPORT:
        return murk_option_exports(out, name, value, err);
    case MURK_OPTION_REPEAT:
        return murk_option_count(name, value, 1, REPEATS_MAX, &out->repeat,
                                 err);
    case MURK_OPTION_PHOTON:
        out->has_photon = true;
        return murk_option_count(name, value, 0, UINT32_MAX - UINT64_C(1),
                                 &out->photon, err);
    case MURK_OPTION_FORMAT:
        status = murk_option_choice(name, value, formats, &which, err);
        out->json = which == 1;
        break;
    case MURK_OPTION_FORCE:
        out->force = true;
        break;
    case MURK_OPTION_QUIET:
        out->quiet = true;
        break;
    case MURK_OPTION_PROGRESS:
        status = murk_option_choice(name, value, progresses, &which, err);
        out->progress = (murk_progress_mode)which;
        break;
    case MURK_OPTION_HELP:
        out->wants_help = true;
        break;
    case MURK_OPTION_VERSION:
        out->wants_version = true;
        break;
    case MURK_OPTION_MAN:
        out->wants_man = true;
        break;
    }
    return status;
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
    out->given[out->n_given++] = (murk_given){option, value};
    return apply(out, option, value, err);
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
