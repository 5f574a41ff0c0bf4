/* The folder of a part of a run (--shard): part.txt has the version of murk,
 * the words of the command, and which part it is; other files have what the
 * part computed. */
#ifndef MURK_APP_PART_H
#define MURK_APP_PART_H

#include "app/options.h"

/* Names of files of a part. */
#define MURK_PART_FILE  "part.txt"
#define MURK_PART_LIGHT "light.part"

/* *out: the path of a file in a folder, for free(). Fails with MURK_NO_MEMORY.
 */
murk_status murk_part_path(char **out, const char *folder, const char *name,
                           murk_error *err);

/* Makes the folder -o, and checks that the files of a part may be written
 * there: files that murk did not write are refused without --force. Fails with
 * MURK_BAD_VALUE, MURK_RUN_FAILED or MURK_NO_MEMORY. */
murk_status murk_part_begin(const murk_options *options, murk_error *err);

/* Writes part.txt, last. */
murk_status murk_part_end(const murk_options *options, murk_error *err);

/* Reads the words of the command of a part: argv[argc], for free(), which point
 * into *text, for free(). Fails with MURK_BAD_FILE if the folder has no part,
 * with MURK_BAD_VALUE if another version of murk wrote it, or with
 * MURK_NO_MEMORY. */
murk_status murk_part_read(char ***argv, int *argc, char **text,
                           const char *folder, murk_error *err);

#endif
