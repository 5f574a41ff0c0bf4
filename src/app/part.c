/* Writes and reads the folder of a part of a run (app/part.h). part.txt has one
 * line a fact: "murk part", "version V", "part K/N", and "word W" for each word
 * of the command. */
#include "app/part.h"

#include "app/lookup.h"
#include "app/show.h"
#include "base/file.h"
#include "base/print.h"
#include "base/shard.h"

#include <stdlib.h>
#include <string.h>

#define MARK "murk part\n"

/* A command line is far shorter than this. */
#define TEXT_MAX 1000000

/* A version with the commit. */
#define VERSION_SIZE 128

murk_status murk_part_path(char **out, const char *folder, const char *name,
                           murk_error *err)
{
    const size_t size = strlen(folder) + strlen(name) + 2;
    *out = malloc(size);
    if (!*out) {
        return murk_no_memory(err, folder, "for a path");
    }
    snprintf(*out, size, "%s/%s", folder, name);
    return MURK_OK;
}

murk_status murk_part_paths(char ***out, const murk_options *options,
                            const char *name, murk_error *err)
{
    const murk_words_given *folders = &options->merges->inputs;
    *out = calloc(folders->n + 1, sizeof **out);
    murk_status status =
        *out ? MURK_OK : murk_no_memory(err, "", "for the parts");
    for (size_t i = 0; i < folders->n && !status; ++i) {
        status = murk_part_path(&(*out)[i], folders->word[i], name, err);
    }
    return status;
}

void murk_part_paths_release(char **paths, const murk_options *options)
{
    for (size_t i = 0; paths && i < options->merges->inputs.n; ++i) {
        free(paths[i]);
    }
    free(paths);
}

/* Fails if murk did not write the file, which begins with the mark, and --force
 * is not given. */
static murk_status check_owner(char **path, const murk_options *options,
                               const murk_part_result *file, murk_error *err)
{
    const murk_status status =
        murk_part_path(path, options->out, file->name, err);
    return status ? status
                  : murk_file_check_owner(*path, file->mark, strlen(file->mark),
                                          options->force, err);
}

murk_status murk_part_begin(char **path, const murk_options *options,
                            const murk_part_result *result, murk_error *err)
{
    static const murk_part_result part = {MURK_PART_FILE, MARK};
    char *facts = NULL;
    *path = NULL;
    for (size_t i = 0; i < options->repeated.n; ++i) {
        if (strchr(options->repeated.word[i], '\n')) {
            return murk_fail(err, MURK_BAD_VALUE, "--shard",
                             "a word of the command has a line break, which "
                             "the file of a part cannot hold");
        }
    }
    murk_status status = murk_folder_make(options->out, err);
    if (!status) {
        status = check_owner(&facts, options, &part, err);
    }
    if (!status) {
        status = check_owner(path, options, result, err);
    }
    if (!status) { /* a part that is not complete has no part.txt */
        (void)remove(facts);
    } else {
        free(*path);
        *path = NULL;
    }
    free(facts);
    return status;
}

murk_status murk_part_end(const murk_options *options, murk_error *err)
{
    char *path = NULL, *text = NULL, version[VERSION_SIZE] = "";
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    murk_status status =
        to ? murk_part_path(&path, options->out, MURK_PART_FILE, err)
           : murk_no_memory(err, "", "for the options");
    if (!status) {
        status = murk_lookup_version(version, sizeof version, err);
    }
    /* The lines of part.txt. */
    if (!status) {
        fprintf(to, MARK "version %s\npart %u/%u\n", version,
                options->shard.number, options->shard.count);
    }
    for (size_t i = 0; i < options->repeated.n && !status; ++i) {
        fprintf(to, "word %s\n", options->repeated.word[i]);
    }
    if (to && fclose(to) != 0 && !status) {
        status = murk_no_memory(err, "", "for the options");
    }
    if (!status) {
        status = murk_file_write(path, text, size, err);
    }
    free(path);
    free(text);
    if (!status && murk_shows_summary(options)) {
        murk_print("part        %u of %u, in %s: murk merge puts the parts "
                   "together\n",
                   options->shard.number, options->shard.count, options->out);
    }
    return status;
}

/* The line at *at without the line break, which is replaced by '\0'; NULL at
 * the end. */
static char *next_line(char **at)
{
    char *line = *at, *end = strchr(line, '\n');
    if (!end) {
        return NULL;
    }
    *end = '\0';
    *at = end + 1;
    return line;
}

murk_status murk_part_read(char ***argv, int *argc, char **text,
                           const char *folder, murk_error *err)
{
    char *path = NULL, version[VERSION_SIZE] = "";
    size_t size = 0;
    murk_status status = murk_part_path(&path, folder, MURK_PART_FILE, err);
    if (!status) {
        status = murk_lookup_version(version, sizeof version, err);
    }
    if (!status) {
        status = murk_file_read(text, &size, path, TEXT_MAX, err);
    }
    *argv = status ? NULL : calloc(size + 2, sizeof **argv);
    if (!status && !*argv) {
        status = murk_no_memory(err, path, "to read it");
    }
    /* The mark, the version, and the words. */
    char *at = *text, *line = status ? NULL : next_line(&at);
    if (!status && (!line || strcmp(line, "murk part") != 0)) {
        status =
            murk_fail(err, MURK_BAD_FILE, path, "no part of a run of murk");
    }
    line = status ? NULL : next_line(&at);
    const char *made_by =
        line && strncmp(line, "version ", 8) == 0 ? line + 8 : "?";
    if (!status) {
        status =
            murk_shard_check_version(made_by, SIZE_MAX, version, path, err);
    }
    *argc = 0;
    while (!status && (line = next_line(&at))) {
        if (strncmp(line, "word ", 5) == 0) {
            (*argv)[(*argc)++] = line + 5;
        }
    }
    free(path);
    return status;
}
