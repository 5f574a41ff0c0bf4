/* Which files of a result folder are murk's own, so that they may be replaced.
 * A main JSON lists the files of its run with their SHA-256 under `files`. A
 * file that still has the listed checksum is murk's; one that has another was
 * edited and counts as the user's. A JSON of murk is murk's as long as the text
 * before its `run` has the checksum that `run` states. A file of an earlier run
 * that a later run did not write again is listed under run.earlier of the main
 * JSON that replaced the earlier one. A folder with main JSONs, none of which
 * has an `identity`, was written by an older version, and all its files count
 * as murk's. */
#ifndef MURK_RESULTS_OWNERSHIP_H
#define MURK_RESULTS_OWNERSHIP_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_owned_file {
    char *name, sum[65];
    int json;        /* listed by murk_main_jsons[json]; -1: by the JSON of a
                        run that was killed */
    bool is_earlier; /* listed under run.earlier */
} murk_owned_file;

typedef struct murk_owned {
    murk_owned_file *file; /* [n] */
    size_t n;
    bool is_read;
    bool is_older, is_newer; /* there is a main JSON without, or with,
                                `identity` */
} murk_owned;

/* Names of the main JSONs; NULL follows the last. */
extern const char *const murk_main_jsons[];

/* True if the file `name` in the folder is murk's. Reads the lists of the
 * folder at the first call; *owned begins as zeros and is released by
 * murk_owned_release(). */
bool murk_owned_has(murk_owned *owned, const char *folder, const char *name);

/* Reads the lists of the folder unless they are read already:
 * owned->file[owned->n] are then the files that its main JSONs list, and those
 * of killed runs. Without memory, files are missing from the list and count as
 * the user's. */
void murk_owned_read(murk_owned *owned, const char *folder);

/* True if the file is in the folder and has the listed checksum. */
bool murk_owned_is_there(const char *folder, const murk_owned_file *file);

/* True if the name ends in ".json". */
bool murk_owned_is_json(const char *name);

/* The SHA-256, in hex, of the text of a JSON before the line of its key `run`,
 * or of the whole text if there is none. It is the value of run.checksum. */
void murk_json_sum(char out[65], const char *text);

/* How a file is related to the main JSONs in the same folder. */
typedef enum murk_belonging {
    MURK_UNLISTED, /* no main JSON lists a file of this name, or the file cannot
                      be read */
    MURK_LISTED,   /* a main JSON lists the file under `files` with its present
                      checksum */
    MURK_OF_ANOTHER_RUN
} murk_belonging;
murk_belonging murk_owned_belonging(const char *path);

void murk_owned_release(murk_owned *owned);

/* Texts by which murk_file_check_owner() recognises pages and images of
 * murk. */
#define MURK_MARK_PAGE  "name=\"generator\" content=\"murk "
#define MURK_MARK_IMAGE "murkCommit"

#endif
