/* File paths: joining and taking apart. */
#ifndef MURK_BASE_PATH_H
#define MURK_BASE_PATH_H

/* Returns `path` relative to the folder of the file `beside`, or a copy of
 * `path` if it is absolute. The caller frees it; NULL when out of memory. */
char *murk_path_beside(const char *beside, const char *path);

/* Returns FOLDER/NAME, without a second slash. The caller frees it; NULL when
 * out of memory. */
char *murk_path_join(const char *folder, const char *name);

/* The last part of a path, behind the last slash. The result points into
 * `path`. */
const char *murk_path_name(const char *path);

#endif
