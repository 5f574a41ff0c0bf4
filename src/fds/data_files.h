/* The data files of an FDS run, for checksums of what a result depends on. */
#ifndef MURK_FDS_DATA_FILES_H
#define MURK_FDS_DATA_FILES_H

#include <stdbool.h>
#include <stddef.h>

/* Calls add() with the path of each file beside the .smv file `path` that may
 * hold smoke, *.s3d and *.sf, or, if of_walls, geometry, *.ge, in the order of
 * their names: the .smv file names those of the run, and is not read here. A
 * folder that cannot be read has none. Stops and returns false if add() returns
 * false or there is no memory.
 */
bool murk_fds_data_files(const char *path, bool of_walls,
                         bool (*add)(void *context, const char *file),
                         void *context);

#endif
