/* The folder of a part of a run (--shard): part.txt has the version of murk,
 * the words of the command, and which part it is; another file has what the
 * part computed. `murk merge` runs the command of the parts again, with
 * options->merges, and the command takes from the parts what they have. */
#ifndef MURK_APP_PART_H
#define MURK_APP_PART_H

#include "app/options.h"

#define MURK_PART_FILE "part.txt"

/* The file of a part with what a command computed. */
typedef struct murk_part_result {
    const char *name;
    const char *mark; /* the bytes that such a file begins with */
} murk_part_result;

/* *out: the path of a file in a folder, for free(). Fails with MURK_NO_MEMORY.
 */
murk_status murk_part_path(char **out, const char *folder, const char *name,
                           murk_error *err);

/* Sets *out to the path of a file in the folder of each part that is merged;
 * murk_part_paths_release() frees the array[options->merges->inputs.n]. Fails
 * with MURK_NO_MEMORY. */
murk_status murk_part_paths(char ***out, const murk_options *options,
                            const char *name, murk_error *err);
void murk_part_paths_release(char **paths, const murk_options *options);

/* Makes the folder -o, and checks that the files of a part may be written
 * there: files that murk did not write are refused without --force. *path: that
 * of the result, for free(), NULL after a failure. Fails with MURK_BAD_VALUE,
 * MURK_RUN_FAILED or MURK_NO_MEMORY. */
murk_status murk_part_begin(char **path, const murk_options *options,
                            const murk_part_result *result, murk_error *err);

/* Writes part.txt, last, and prints where the part lies. */
murk_status murk_part_end(const murk_options *options, murk_error *err);

/* Reads the words of the command of a part: argv[argc], for free(), which point
 * into *text, for free(). Fails with MURK_BAD_FILE if the folder has no part,
 * with MURK_BAD_VALUE if another version of murk wrote it, or with
 * MURK_NO_MEMORY. */
murk_status murk_part_read(char ***argv, int *argc, char **text,
                           const char *folder, murk_error *err);

#endif
