/* The data files of an FDS run, for checksums of what a result depends on. */
#ifndef MURK_FDS_DATA_FILES_H
#define MURK_FDS_DATA_FILES_H

#include <stdbool.h>
#include <stddef.h>

/* Calls add() with the path of each file beside the .smv file `path` that FDS
 * named for the run and that may hold smoke: NAME_*.s3d and NAME_*.sf for
 * NAME.smv, in the order of their names. A folder that cannot be read
 * has none. Stops and returns false if add() returns false or there is no
 * memory. */
bool murk_fds_data_files(const char *path,
                         bool (*add)(void *context, const char *file),
                         void *context);

#endif
