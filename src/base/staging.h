/* Temporary (staged) files of a run, and the removal of staged files that a
 * killed run left behind.
 *
 * A staged file has a hidden name, .murk.staged.XXXXXX, in the folder of its
 * final path, and is locked (flock) as long as its process lives. A single file
 * is locked directly; a folder of several files is locked by the file .lock in
 * it. A staged file or folder without a lock is left over from a killed run and
 * may be removed. On file systems without locks nothing is locked, and files of
 * other runs are not removed. */
#ifndef MURK_BASE_STAGING_H
#define MURK_BASE_STAGING_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

/* Opens a new file in the folder of `path` for reading and writing, and locks
 * it. The caller frees *name, closes the descriptor, and removes or renames the
 * file. Returns the descriptor. On failure returns -1, leaves *name unchanged,
 * and errno has the reason. */
int murk_staging_file(const char *path, char **name);

typedef struct murk_staging {
    char *folder; /* NULL: no staged folder */
    int lock;     /* descriptor of the file .lock in the folder */
} murk_staging;

/* Creates a new, locked folder for staged files in `parent`, which the caller
 * ends with murk_staging_end(). Fails with MURK_RUN_FAILED or MURK_NO_MEMORY.
 */
murk_status murk_staging_begin(murk_staging *out, const char *parent,
                               murk_error *err);

/* Declares that the files of the folder are being moved to their final paths.
 * If the process is killed after this call, murk_staging_clean() removes the
 * folder only if `all` is set, because the files in the folder name the owner
 * of the files that were moved already. */
void murk_staging_moving(const murk_staging *staging);

/* Removes the folder and the files that are left in it, and sets *staging to
 * {0}. Does nothing else if staging->folder is NULL. */
void murk_staging_end(murk_staging *staging);

/* Removes the unlocked staged files and folders in `parent`, and those that
 * older versions of murk left under other names. Without `all`, folders whose
 * files were being moved are left in place. */
void murk_staging_clean(const char *parent, bool all);

/* Calls `visit` for each staged folder in `parent`, locked ones included. */
void murk_staging_visit(const char *parent,
                        void (*visit)(void *context, const char *folder),
                        void *context);

#endif
