/* What a main JSON says of its run: `identity`, `files`, run.earlier. */
#ifndef MURK_RESULTS_RUN_FILES_H
#define MURK_RESULTS_RUN_FILES_H

#include "results/results.h"

/* Adds "identity", and "files" (where it is not there) with what was added so
 * far but for JSONs, whose `run` differs from run to run. Under run.earlier
 * come files of earlier runs that lie in the folder and that no other JSON
 * there will list once `name` (the main JSON's) has been replaced. */
void murk_json_identify(cJSON *root, const char *identity,
                        murk_results *results, const char *name);

/* Adds a file that lies under `path` to "files", by its name without folder;
 * the empty "files" where path is NULL. */
void murk_json_file(cJSON *root, const char *path);

#endif
