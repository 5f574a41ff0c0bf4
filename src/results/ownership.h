/* Which files of a result folder are murk's own, and may be replaced.
 *
 * A main JSON lists the files of its run with their SHA-256 under `files`: one
 * that still has that checksum is murk's, one that has another was edited and
 * is the user's. A JSON is murk's while all before its `run` has the checksum
 * that `run` gives. A file of an earlier run that the present run did not write
 * again is listed under run.earlier of the main JSON that replaced the earlier
 * one. Folders in which no main JSON has an `identity` were written by an older
 * version and are murk's as a whole. */
#ifndef MURK_RESULTS_OWNERSHIP_H
#define MURK_RESULTS_OWNERSHIP_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_owned_file {
    char *name, sum[65];
    int json;        /* listed by murk_main_jsons[json]; -1: by a killed run */
    bool is_earlier; /* listed under run.earlier */
} murk_owned_file;

typedef struct murk_owned {
    murk_owned_file *file; /* [n] */
    size_t n;
    bool is_read;
    bool is_older, is_newer; /* a main JSON without, and with, `identity` */
} murk_owned;

/* Names of the main JSONs, NULL behind the last. */
extern const char *const murk_main_jsons[];

/* Whether DIR/name, which is there, is murk's as it stands. Reads the folder
 * at the first call; *owned begins as zeros. */
bool murk_owned_has(murk_owned *owned, const char *folder, const char *name);

/* Reads the folder unless that is done: afterwards owned->file[owned->n] is
 * what the main JSONs there list. */
void murk_owned_read(murk_owned *owned, const char *folder);

/* True if the file is in the folder and has the checksum it is listed with. */
bool murk_owned_is_there(const char *folder, const murk_owned_file *file);

/* True if the name ends in ".json". */
bool murk_owned_is_json(const char *name);

/* SHA-256 of a printed JSON up to its line of `run`: run.checksum. */
void murk_json_sum(char out[65], const char *text);

/* How the file at `path` stands to the runs whose main JSONs lie beside it. */
typedef enum murk_belonging {
    MURK_UNLISTED, /* none lists a file of this name */
    MURK_LISTED,   /* one lists it as it is */
    MURK_OF_ANOTHER_RUN
} murk_belonging;
murk_belonging murk_owned_belonging(const char *path);

void murk_owned_release(murk_owned *owned);

/* The marks that other files of murk hold (murk_file_check_owner()). */
#define MURK_MARK_PAGE  "name=\"generator\" content=\"murk "
#define MURK_MARK_IMAGE "murkCommit"

#endif
