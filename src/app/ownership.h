/* Which files of a result folder are murk's own, and may be replaced.
 *
 * A main JSON lists the files of its run with their SHA-256 under `files`: one
 * that still has that checksum is murk's, one that has another was edited and
 * is the user's. A JSON is murk's while all before its `run` has the checksum
 * that `run` gives. Folders of versions that wrote no `identity` are murk's as
 * a whole. */
#ifndef MURK_APP_OWNERSHIP_H
#define MURK_APP_OWNERSHIP_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct murk_owned_file {
    char *name, sum[65];
    bool is_left; /* listed by a run that was killed while its files moved */
} murk_owned_file;

typedef struct murk_owned {
    murk_owned_file *file; /* [n] */
    size_t n;
    bool is_read, is_older;
} murk_owned;

/* Names of the main JSONs, NULL behind the last. */
extern const char *const murk_main_jsons[];

/* Whether DIR/name, which is there, is murk's as it stands. Reads the folder
 * at the first call; *owned begins as zeros. */
bool murk_owned_has(murk_owned *owned, const char *folder, const char *name);

/* How the file at `path` stands to the runs whose main JSONs lie beside it. */
typedef enum murk_belonging {
    MURK_UNLISTED, /* none lists a file of this name */
    MURK_LISTED,   /* one lists it as it is */
    MURK_OF_ANOTHER_RUN
} murk_belonging;
murk_belonging murk_owned_look(const char *path);

void murk_owned_release(murk_owned *owned);

/* The marks that other files of murk hold (murk_file_check_owner()). */
#define MURK_MARK_PAGE  "name=\"generator\" content=\"murk "
#define MURK_MARK_IMAGE "murkCommit"

#endif
