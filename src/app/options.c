#include "app/options.h"

#include "app/option_table.h"
#include "base/crew.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define THREADS_MAX 256
#define REPEATS_MAX 10000

const murk_command murk_commands[] = {
    {"check", "SCENE", "read a scene, validate it, say what is in it",
     "Reads and builds the scene and prints its surfaces, media, lights, "
     "sensors and candidates, how many candidates are usable or doubtful, and "
     "the photons and the memory that a run will take, foretold by a short "
     "pilot. Nothing is written.",
     murk_command_check},
    {"trace", "SCENE [-o DIR]", "fill the photon maps",
     "Traces photons from the lamps through surfaces and media into the "
     "surface and the volume photon map. With -o writes DIR/light.murk, "
     "DIR/scene.yaml (the scene as resolved) and, last, DIR/ledger.json.",
     murk_command_trace},
    {"place", "SCENE|--matrix FILE [-o DIR]",
     "the main job: trace, sense, place sensors",
     "Traces, finds which candidate sees which stored photon and how clearly, "
     "chooses the sensors, and measures the choice on a second, independent "
     "map. With -o writes DIR/plan.json (last), sensors.csv, coverage.csv, "
     "plan.ply and all that trace writes; with --repeat DIR/repeat.csv. With "
     "--matrix it chooses columns of "
     "a given "
     "coverage matrix, so that most of the rows' weight is covered; "
     "DIR/plan.json is then all it writes by itself, with null where a matrix "
     "has no such thing. The formats of a matrix: scenes/README.md.",
     murk_command_place},
    {"sense", "SCENE --sensors FILE [-o DIR]", "measure a given placement",
     "Traces and measures what the given sensors see. With -o writes "
     "DIR/coverage.json (last), coverage.csv and all that trace writes.",
     murk_command_sense},
    {"study", "STUDY.yaml [-o DIR]",
     "a chain of runs over times and conditions",
     "Runs a scene once for each row of a study: every combination of what the "
     "study's axes list (or one value of each after the other). With -o writes "
     "DIR/table.csv, a row a run with photon density, coverage and their "
     "standard errors, and, last, DIR/study.json. Rows that differ by the "
     "power "
     "of lights alone share one traced light. Finished rows are kept in "
     "DIR/rows: the same command goes on where it was stopped. A row that "
     "fails "
     "is told in the column failed, the others go on, and the command ends "
     "with "
     "1. The study's keys: scenes/README.md.",
     murk_command_study},
    {"replay", "SCENE --photon N", "print every event of one emitted photon",
     "Traces the one photon again, event by event: a photon is a pure function "
     "of seed, scene and index.",
     murk_command_replay},
    {"media", "[NAME]", "the presets of media, with numbers and sources",
     "Lists the presets that a scene's medium may name (preset: fog/kim). With "
     "NAME says what that one means: its words with ranges and defaults, "
     "extinction, albedo and mean cosine by band, sources and doubts. --set "
     "visibility_m=50 gives a word (or albedo, extinction_per_m, phase), --set "
     "bands_nm=[532] other bands. --profile FILE.csv -o FILE.vdb turns a "
     "measured profile into a grid that holds its optical depth.",
     murk_command_media},
};
const size_t murk_commands_count = sizeof murk_commands / sizeof *murk_commands;

static const char *const later_commands[] = {"render", "fit", "report"};

static murk_status find_command(murk_options *out, const char *name,
                                murk_error *err)
{
    for (size_t i = 0; i < murk_commands_count; ++i) {
        if (strcmp(murk_commands[i].name, name) == 0) {
            out->command = &murk_commands[i];
            return MURK_OK;
        }
    }
    for (size_t i = 0; i < sizeof later_commands / sizeof *later_commands;
         ++i) {
        if (strcmp(later_commands[i], name) == 0) {
            return murk_fail(err, MURK_UNSUPPORTED, "", "%s: not supported yet",
                             name);
        }
    }
    return murk_fail(err, MURK_BAD_VALUE, "",
                     "%s: no such command; there are check, trace, place, "
                     "sense, study, replay and media (murk --help)",
                     name);
}

/* A whole number, also as 1e6; strict. */
static bool read_count(const char *text, uint64_t *out)
{
    char *end = NULL;
    if (!((*text >= '0' && *text <= '9') || *text == '.')) {
        return false;
    }
    for (const char *c = text; *c; ++c) {
        if (!strchr("0123456789.eE+", *c)) {
            return false;
        }
    }
    errno = 0;
    const double value = strtod(text, &end);
    if (*end || errno || !(value >= 0 && value < 0x1p64) ||
        value != floor(value)) {
        return false;
    }
    *out = strspn(text, "0123456789") == strlen(text) ? strtoull(text, NULL, 10)
                                                      : (uint64_t)value;
    return true;
}

static murk_status need_count(const char *name, const char *text, uint64_t low,
                              uint64_t high, uint64_t *out, murk_error *err)
{
    if (!read_count(text, out) || *out < low || *out > high) {
        return murk_fail(err, MURK_BAD_VALUE, name,
                         "%s, must be a whole number %llu..%llu", text,
                         (unsigned long long)low, (unsigned long long)high);
    }
    return MURK_OK;
}

/* Keeps "KEY=VALUE" as one more override. */
static murk_status add_override(murk_options *out, const char *key,
                                const char *value, const char *option,
                                murk_error *err)
{
    const size_t size = strlen(key) + strlen(value) + 2;
    char *text = malloc(size);
    murk_override *overrides =
        realloc(out->overrides, (out->n_overrides + 1) * sizeof *overrides);
    if (overrides) {
        out->overrides = overrides;
    }
    char **kept = realloc(out->kept, (out->n_kept + 1) * sizeof *kept);
    if (kept) {
        out->kept = kept;
    }
    if (!text || !overrides || !kept) {
        free(text);
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the options");
    }
    snprintf(text, size, "%s%s%s", key, *key ? "=" : "", value);
    out->kept[out->n_kept++] = text;
    out->overrides[out->n_overrides++] = (murk_override){text, option};
    return MURK_OK;
}

static murk_status set_count(murk_options *out, const char *name,
                             const char *key, const char *value, uint64_t low,
                             uint64_t high, murk_error *err)
{
    uint64_t n = 0;
    const murk_status status = need_count(name, value, low, high, &n, err);
    char digits[32];
    snprintf(digits, sizeof digits, "%llu", (unsigned long long)n);
    return status ? status : add_override(out, key, digits, name, err);
}

static murk_status choice(const char *name, const char *value,
                          const char *const *allowed, int *out, murk_error *err)
{
    char list[96] = "";
    for (int i = 0; allowed[i]; ++i) {
        if (strcmp(allowed[i], value) == 0) {
            *out = i;
            return MURK_OK;
        }
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s%s",
                 i ? " | " : "", allowed[i]);
    }
    return murk_fail(err, MURK_BAD_VALUE, name, "%s, must be %s", value, list);
}

/* Words with commas between. */
static murk_status read_exports(murk_options *out, const char *name,
                                const char *value, murk_error *err)
{
    static const char *const words[] = {"matrix", "or-library", "lp"};
    for (const char *word = value;;) {
        const size_t length = strcspn(word, ",");
        unsigned bit = 0;
        for (unsigned i = 0; i < sizeof words / sizeof *words; ++i) {
            if (strlen(words[i]) == length &&
                strncmp(words[i], word, length) == 0) {
                bit = 1u << i;
            }
        }
        if (!bit) {
            return murk_fail(err, MURK_BAD_VALUE, name,
                             "%s, must be of matrix, or-library, lp, with "
                             "commas between",
                             value);
        }
        out->exports |= bit;
        if (!word[length]) {
            return MURK_OK;
        }
        word += length + 1;
    }
}

static murk_status apply(murk_options *out, const murk_option *option,
                         const char *value, murk_error *err)
{
    static const char *const formats[] = {"text", "json", NULL};
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
        return set_count(out, name, "seed", value, 0, UINT32_MAX, err);
    case MURK_OPTION_THREADS:
        status = need_count(name, value, 1, THREADS_MAX, &n, err);
        out->threads = (unsigned)n;
        break;
    case MURK_OPTION_EMIT:
        return set_count(out, name, "photons.emit", value, 1, UINT32_MAX, err);
    case MURK_OPTION_STORE:
        return set_count(out, name, "photons.store", value, 1, UINT32_MAX, err);
    case MURK_OPTION_COUNT:
        return set_count(out, name, "sensors.count", value, 1, 1000000, err);
    case MURK_OPTION_TARGET:
        return add_override(out, "sensors.target", value, name, err);
    case MURK_OPTION_BUDGET:
        return add_override(out, "sensors.budget", value, name, err);
    case MURK_OPTION_SET:
        if (!strchr(value, '=') || *value == '=') {
            return murk_fail(err, MURK_BAD_VALUE, name, "%s, must be KEY=VALUE",
                             value);
        }
        return add_override(out, "", value, NULL, err);
    case MURK_OPTION_LIGHT:
        out->light = value;
        break;
    case MURK_OPTION_SENSORS:
        out->sensors = value;
        break;
    case MURK_OPTION_MATRIX:
        out->matrix = value;
        break;
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
        return read_exports(out, name, value, err);
    case MURK_OPTION_REPEAT:
        return need_count(name, value, 1, REPEATS_MAX, &out->repeat, err);
    case MURK_OPTION_PHOTON:
        out->has_photon = true;
        return need_count(name, value, 0, UINT32_MAX - UINT64_C(1),
                          &out->photon, err);
    case MURK_OPTION_FORMAT:
        status = choice(name, value, formats, &which, err);
        out->json = which == 1;
        break;
    case MURK_OPTION_QUIET:
        out->quiet = true;
        break;
    case MURK_OPTION_PROGRESS:
        status = choice(name, value, progresses, &which, err);
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
    case MURK_OPTION_LATER:
        return murk_fail(err, MURK_UNSUPPORTED, name, "not supported yet");
    }
    return status;
}

static const murk_option *find_option(const char *text, size_t length)
{
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *option = &murk_option_table[i];
        if ((strlen(option->name) == length &&
             strncmp(option->name, text, length) == 0) ||
            (option->other && strlen(option->other) == length &&
             strncmp(option->other, text, length) == 0)) {
            return option;
        }
    }
    return NULL;
}

/* One of a letter, whose value follows at once; NULL: it is none. */
static const murk_option *find_short(const char *text)
{
    const bool may_be = text[0] == '-' && text[1] != '-' && strlen(text) > 2;
    const murk_option *option = may_be ? find_option(text, 2) : NULL;
    return option && option->argument ? option : NULL;
}

/* One option and its value, which stands behind "=" or in the next argument;
 * *i moves past it. */
static murk_status take_option(murk_options *out, int argc, char **argv, int *i,
                               murk_error *err)
{
    const char *text = argv[*i];
    const char *equals = strncmp(text, "--", 2) == 0 ? strchr(text, '=') : NULL;
    const size_t length = equals ? (size_t)(equals - text) : strlen(text);
    const murk_option *option = find_option(text, length);
    if (!option) {
        option = find_short(text);
        if (option) { /* -j2 */
            return apply(out, option, text + 2, err);
        }
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "%.*s: no such option (murk --help)", (int)length,
                         text);
    }
    if (!option->argument) {
        return equals ? murk_fail(err, MURK_BAD_VALUE, option->name,
                                  "takes no value")
                      : apply(out, option, NULL, err);
    }
    if (equals) {
        return apply(out, option, equals + 1, err);
    }
    if (*i + 1 >= argc) {
        return murk_fail(err, MURK_BAD_VALUE, option->name, "needs a value: %s",
                         option->argument);
    }
    return apply(out, option, argv[++*i], err);
}

/* Options may stand before the command is known, so they are held against it
 * at the end. */
static murk_status check_belonging(const murk_options *out, int argc,
                                   char **argv, murk_error *err)
{
    for (int i = 1; out->command && i < argc; ++i) {
        if (argv[i][0] != '-') {
            continue;
        }
        const char *equals = strchr(argv[i], '=');
        const size_t length =
            equals ? (size_t)(equals - argv[i]) : strlen(argv[i]);
        const murk_option *option = find_option(argv[i], length);
        option = option ? option : find_short(argv[i]);
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

murk_status murk_options_parse(murk_options *out, int argc, char **argv,
                               murk_error *err)
{
    *out = (murk_options){.threads = murk_crew_processors(),
                          .progress = MURK_PROGRESS_AUTO};
    murk_status status = MURK_OK;
    for (int i = 1; i < argc && !status; ++i) {
        if (argv[i][0] == '-' && argv[i][1]) {
            status = take_option(out, argc, argv, &i, err);
        } else if (!out->command) {
            status = find_command(out, argv[i], err);
        } else if (!out->input) {
            out->input = argv[i];
        } else {
            status = murk_fail(err, MURK_BAD_VALUE, "",
                               "%s: one scene at a time, %s is named already",
                               argv[i], out->input);
        }
    }
    if (!status) {
        status = check_belonging(out, argc, argv, err);
    }
    if (status || out->wants_help || out->wants_version || out->wants_man) {
        return status;
    }
    if (!out->command) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "no command; try murk --help");
    }
    if (out->exports && !out->out) {
        return murk_fail(err, MURK_BAD_VALUE, "--export",
                         "needs a folder to write into: -o DIR");
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
                         "%s: no scene; usage: murk "
                         "%s %s",
                         out->command->name, out->command->name,
                         out->command->arguments);
    }
    return MURK_OK;
}

void murk_options_release(murk_options *options)
{
    for (size_t i = 0; i < options->n_kept; ++i) {
        free(options->kept[i]);
    }
    free(options->kept);
    free(options->overrides);
    *options = (murk_options){0};
}
