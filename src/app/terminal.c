/* Connects the context of the library with the terminal. Places in messages of
 * the library name keys that were set and settings of calls; the user gave
 * these as options, so the program names the options in place of them. */
#include "app/terminal.h"

#include "base/file.h"
#include "base/log.h"
#include "base/place.h"
#include "base/ranks.h"

#include <errno.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define PLACE_SIZE 640  /* of a place with the name of an option */
#define TEXT_SIZE  1024 /* of a text with names of options */

/* Before the name of a setting in texts of the library. */
#define MARK "options->"

/* What helps with a file that murk did not write. */
#define FORCE ", or --force replaces it"

/* ---- places ---- */

/* The option that set a key last, or NULL. */
static const char *option_of_key(const murk_options *options, const char *key)
{
    const char *option = NULL;
    for (size_t i = 0; i < options->n_overrides; ++i) {
        const murk_given_key *override = &options->overrides[i];
        if (override->option && strlen(key) == strcspn(override->text, "=") &&
            strncmp(key, override->text, strlen(key)) == 0) {
            option = override->option;
        }
    }
    return option;
}

/* The option that gave the value of a place "KEY=VALUE: KEY", or NULL. */
static const murk_given_key *override_of(const murk_options *options,
                                         const char *place)
{
    for (size_t i = options->n_overrides; i > 0; --i) {
        const murk_given_key *override = &options->overrides[i - 1];
        const size_t length = strlen(override->text);
        if (override->option && strncmp(place, override->text, length) == 0 &&
            (place[length] == '\0' || place[length] == ':')) {
            return override;
        }
    }
    return NULL;
}

/* The option of the command that gives the setting of this name; NULL if there
 * is none. */
static const murk_option *option_of_setting(const murk_options *options,
                                            const char *name, size_t length)
{
    const char *command = options->command ? options->command->name : NULL;
    for (size_t i = 0; i < murk_option_table_size; ++i) {
        const murk_option *option = &murk_option_table[i];
        if (option->setting && strlen(option->setting) == length &&
            strncmp(option->setting, name, length) == 0 &&
            murk_option_belongs(option, command)) {
            return option;
        }
    }
    return NULL;
}

/* Names the option in place of what the library calls it. */
static const char *place_of(const murk_options *options, const char *where,
                            char out[PLACE_SIZE])
{
    const size_t length = strcspn(where, " ");
    const murk_option *named = option_of_setting(options, where, length);
    if (named && (where[length] == '\0' || named->has_items)) {
        snprintf(out, PLACE_SIZE, "%s%s", named->name, where + length);
        return out;
    }
    const size_t mark = strlen(MURK_SET_MARK);
    if (strncmp(where, MURK_SET_MARK, mark) != 0) {
        return where;
    }
    const char *place = where + mark;
    const murk_given_key *override = override_of(options, place);
    if (!override) { /* --set KEY=VALUE, or a key alone */
        const char *option = option_of_key(options, place);
        snprintf(out, PLACE_SIZE, "%s%s", option ? "" : "--",
                 option ? option : where);
        return out;
    }
    /* Of a file of keys the place is the file, so the key is told as well. */
    const char *rest = place + strlen(override->text);
    const bool is_file = strncmp(override->option, "--set @", 7) == 0;
    snprintf(out, PLACE_SIZE, "%s%s%.*s", override->option,
             is_file && !*rest ? ": " : rest,
             is_file && !*rest ? (int)strcspn(override->text, "=") : 0,
             override->text);
    return out;
}

/* Copies the text of a message, at most TEXT_SIZE - 1 bytes of it, with the
 * name of the option in place of each setting "options->NAME" that an option
 * gives. */
static const char *text_of(const murk_options *options, const char *text,
                           char out[TEXT_SIZE])
{
    size_t n = 0;
    out[0] = '\0';
    while (*text && n < TEXT_SIZE) {
        /* The text before the next mark, then the option, or the mark. */
        const char *at = strstr(text, MARK);
        const char *name = at ? at + strlen(MARK) : "";
        const size_t before = at ? (size_t)(at - text) : strlen(text);
        const size_t length = strspn(name, "abcdefghijklmnopqrstuvwxyz_");
        const murk_option *option = option_of_setting(options, name, length);
        n += (size_t)snprintf(out + n, TEXT_SIZE - n, "%.*s%s", (int)before,
                              text,
                              option ? option->name
                              : at   ? MARK
                                     : "");
        text = option ? name + length : at ? name : text + before;
    }
    return out;
}

void murk_terminal_fail(const murk_options *options, const murk_error *err)
{
    char place[PLACE_SIZE], shown[TEXT_SIZE], text[TEXT_SIZE];
    const bool helps = strcmp(err->text, MURK_NOT_OURS) == 0;
    snprintf(text, sizeof text, "%s%s", text_of(options, err->text, shown),
             helps ? FORCE : "");
    murk_message("", place_of(options, err->where, place), text);
}

/* ---- messages ---- */

/* With --quiet, the only warnings that are shown are those about the file of
 * --predict: that the data rejected the model of that fit. */
static bool is_shown(const murk_options *options, const char *where)
{
    return !options->quiet ||
           (options->fit.predict && strcmp(where, options->fit.predict) == 0);
}

/* Prints a warning or a note once. */
static void tell(void *user, bool is_warning, const char *where,
                 const char *text)
{
    const murk_options *options = user;
    const char *kind = is_warning ? "warning: " : "note: ";
    char shown[PLACE_SIZE], said[TEXT_SIZE];
    const char *place = place_of(options, where, shown);
    text = text_of(options, text, said);
    if (is_shown(options, where) && murk_message_is_new(kind, place, text)) {
        murk_message(kind, place, text);
    }
}

/* ---- signals ---- */

static murk_context *_Atomic running;
static atomic_int is_interrupted;

/* What is said when a search is asked to finish; NULL: nothing. On a terminal
 * the text begins below the progress line. */
#define FINISHES                                                              \
    "murk: interrupted: the search ends with the best plan so far; a second " \
    "interrupt ends the run\n"
static const char *_Atomic finishes;

/* The first signal during a search for a plan asks the search to finish. Any
 * other signal cancels, and the next one of the same number kills the process.
 * Calls only functions that are safe in a signal handler. */
static void on_signal(int number)
{
    murk_context *context = atomic_load(&running);
    if (murk_context_finish(context)) {
        const char *text = atomic_load(&finishes);
        const int before = errno;
        if (text && write(STDERR_FILENO, text, strlen(text)) < 0) {
            errno = before; /* nobody reads the text */
        }
        return;
    }
    atomic_store(&is_interrupted, 1);
    murk_context_cancel(context);
    signal(number, SIG_DFL);
}

bool murk_terminal_interrupted(void)
{
    return atomic_load(&is_interrupted) != 0;
}

static void install_handlers(void)
{
    struct sigaction action = {.sa_handler = on_signal};
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

/* ---- the context ---- */

/* Lists the files of keys (--set @FILE), which were read before there was a
 * context, so that no result replaces them. Returns the number of files. */
static size_t list_files_of_keys(const char **file, const murk_options *options)
{
    size_t n = 0;
    for (size_t i = 0; i < options->n_given; ++i) {
        const char *value = options->given[i].value;
        if (strcmp(options->given[i].option->name, "--set") == 0 &&
            *value == '@') {
            file[n++] = value + 1;
        }
    }
    return n;
}

murk_status murk_terminal_begin(murk_options *options, murk_error *err)
{
    const char **file = calloc(options->n_given + 1, sizeof *file);
    if (!file) {
        return murk_no_memory(err, "", "for the options");
    }
    const murk_context_options settings = {
        .size = sizeof settings,
        .threads = options->threads ? options->threads : murk_ranks_threads(),
        .log = tell,
        .user = options,
        .imports =
            options->has_threads ? MURK_IMPORTS_READER : MURK_IMPORTS_FORK,
        .line = options->quiet ? MURK_PROGRESS_NEVER : options->progress,
        .inputs = file,
        .n_inputs = list_files_of_keys(file, options)};
    const murk_status status =
        murk_context_create(&options->context, &settings, err);
    free(file);
    if (status) {
        return status;
    }
    /* From here on signals reach the context. */
    atomic_store(&running, options->context);
    atomic_store(&finishes, options->quiet          ? NULL
                            : isatty(STDERR_FILENO) ? "\n" FINISHES
                                                    : FINISHES);
    install_handlers();
    return MURK_OK;
}
