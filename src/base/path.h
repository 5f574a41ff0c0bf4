/* File paths: joining and taking apart. */
#ifndef MURK_BASE_PATH_H
#define MURK_BASE_PATH_H

/* Returns a relative `path` with the folder of the file `beside` in front:
 * "a/b.yaml" and "c.csv" give "a/c.csv". Returns a copy of `path` if `path` is
 * absolute or `beside` has no slash. The caller frees the result; NULL when out
 * of memory. */
char *murk_path_beside(const char *beside, const char *path);

/* Returns FOLDER/NAME, with one slash also if `folder` ends with a slash. The
 * caller frees the result; NULL when out of memory. */
char *murk_path_join(const char *folder, const char *name);

/* The last part of a path, behind the last slash, or the whole path if there is
 * no slash. The result points into `path`. */
const char *murk_path_name(const char *path);

#endif
