/* Files that are written before they are shown, and what a killed run leaves.
 *
 * What is being written has a hidden name, .murk.staged.XXXXXX, in the folder
 * where it will stand, and is held by a lock (flock) as long as its process
 * lives: a file by itself, a folder of several by the file .lock in it. What
 * nobody holds is a leftover of a run that was killed, and may be removed. */
#ifndef MURK_BASE_STAGING_H
#define MURK_BASE_STAGING_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

/* Opens a new file beside `path`, locked. *name is the caller's to free();
 * removes it himself. Returns the descriptor, or -1 and errno. */
int murk_staging_file(const char *path, char **name);

typedef struct murk_staging {
    char *folder; /* NULL: none */
    int lock;     /* descriptor of its .lock */
} murk_staging;

/* A new folder for files within `parent`, locked. */
murk_status murk_staging_begin(murk_staging *out, const char *parent,
                               murk_error *err);

/* From now on its files move to their places. If the process is killed from
 * here on, murk_staging_clean() leaves the folder until it is told to take all:
 * what lies in it says whose the moved files are. */
void murk_staging_moving(const murk_staging *staging);

/* Removes the folder with what is left in it. */
void murk_staging_end(murk_staging *staging);

/* Removes the leftovers in a folder that nobody holds; without `all` those
 * stay whose files were on the move. */
void murk_staging_clean(const char *parent, bool all);

/* Calls `visit` for each leftover folder in `parent` (also those held by
 * someone). */
void murk_staging_visit(const char *parent,
                        void (*visit)(void *context, const char *folder),
                        void *context);

#endif
