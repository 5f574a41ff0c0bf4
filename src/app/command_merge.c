/* murk merge: runs the command that made the parts of a run, and lets it take
 * from the parts what they have. */
#include "app/command_line.h"
#include "app/part.h"

#include <stdlib.h>
#include <string.h>

/* The words of the command of the parts. */
typedef struct words {
    char **word; /* [n] */
    int n;
    char *text;
    char *folder; /* of the results */
} words;

static void release_words(words *w)
{
    free(w->word);
    free(w->text);
    free(w->folder);
}

/* Fails if the commands of two parts differ, and names the first words that
 * do. */
static murk_status check_equal(const words *a, const words *b, const char *path,
                               const char *other, murk_error *err)
{
    for (int i = 0; i < a->n || i < b->n; ++i) {
        const char *x = i < a->n ? a->word[i] : "nothing";
        const char *y = i < b->n ? b->word[i] : "nothing";
        if (strcmp(x, y) != 0) {
            return murk_fail(err, MURK_BAD_VALUE, path,
                             "part of another run: its command has \"%s\" "
                             "where that of %s has \"%s\"",
                             x, other, y);
        }
    }
    return MURK_OK;
}

/* The command of all parts. */
static murk_status read_words(words *out, const murk_options *options,
                              murk_error *err)
{
    murk_status status = MURK_OK;
    for (size_t i = 0; i < options->inputs.n && !status; ++i) {
        words w = {.n = 0};
        const char *folder = options->inputs.word[i];
        status = murk_part_read(&w.word, &w.n, &w.text, folder, err);
        if (!status && i > 0) {
            status = check_equal(&w, out, folder, options->inputs.word[0], err);
        }
        if (!status && i == 0) {
            *out = w;
        } else {
            release_words(&w);
        }
    }
    return status;
}

/* The options of the command of the parts, with those of murk merge that change
 * no result. */
static murk_status parse(murk_options *out, words *w,
                         const murk_options *options, murk_error *err)
{
    static char name[] = "murk", out_option[] = "-o";
    char **argv = calloc((size_t)w->n + 4, sizeof *argv);
    int argc = 0;
    *out = (murk_options){.threads = 1};
    w->folder = options->out ? strdup(options->out) : NULL;
    if (!argv || (options->out && !w->folder)) {
        free(argv);
        return murk_no_memory(err, "", "for the options");
    }
    /* "murk", the folder of the results, and the words of the parts, among
     * which "--" may end the options. */
    argv[argc++] = name;
    if (w->folder) {
        argv[argc++] = out_option;
        argv[argc++] = w->folder;
    }
    memcpy(argv + argc, w->word, (size_t)w->n * sizeof *argv);
    argc += w->n;
    murk_status status = murk_options_parse(out, argc, argv, err);
    free(argv);
    const murk_option *shard = murk_option_find("--shard", strlen("--shard"));
    const bool has_parts = !status && out->command && !out->wants_help &&
                           !out->wants_version && !out->wants_man &&
                           !out->shard.count &&
                           murk_option_belongs(shard, out->command->name) &&
                           !murk_option_is_given(out, "--completion");
    if (!status && !has_parts) {
        status = murk_fail(err, MURK_BAD_FILE, options->input,
                           "no part of a command that --shard divides");
    }
    /* What concerns the place of results and the form of the output. */
    out->context = options->context;
    out->out = options->out;
    out->threads = options->threads;
    out->json = options->json;
    out->quiet = options->quiet;
    out->force = options->force;
    out->progress = options->progress;
    out->merges = options;
    return status;
}

murk_status murk_command_merge(const murk_options *options, murk_error *err)
{
    words w = {.n = 0};
    murk_options command = {.threads = 1};
    murk_status status = read_words(&w, options, err);
    if (!status) {
        status = parse(&command, &w, options, err);
    }
    if (!status) {
        status = command.command->run(&command, err);
    }
    murk_options_release(&command);
    release_words(&w);
    return status;
}
