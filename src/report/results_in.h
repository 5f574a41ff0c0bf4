/* The content of a result folder. At least one of the main JSON files must be
 * there, and each must be of this version, that is, of the same major and minor
 * number. JSON is read as YAML, of which it is a subset, so each value knows
 * its line. */
#ifndef MURK_REPORT_RESULTS_IN_H
#define MURK_REPORT_RESULTS_IN_H

#include "base/status.h"
#include "scene/scene.h"
#include "scene/table.h"
#include "scene/yaml.h"

#include <dirent.h>
#include <stdbool.h>

typedef enum murk_result_file {
    MURK_RESULT_PLAN,     /* plan.json, of place */
    MURK_RESULT_COVERAGE, /* coverage.json, of sense */
    MURK_RESULT_STUDY,    /* study.json */
    MURK_RESULT_FIT,      /* fit.json */
    MURK_RESULT_PREDICT,  /* predict.json, of fit without --free */
    MURK_RESULT_FOLLOW,   /* follow.json */
    MURK_RESULT_LEDGER,   /* ledger.json, of trace and other commands that trace
                             light */
    MURK_RESULT_FILES
} murk_result_file;

typedef struct murk_result_kind {
    const char *file, *key,
        *title; /* file name, such as "plan.json", key of the file in the data
                   of the page, and heading of the summary of the file */
} murk_result_kind;

extern const murk_result_kind murk_result_kinds[MURK_RESULT_FILES];

typedef struct murk_results_in {
    const char *folder; /* borrowed */
    char *whole; /* the absolute path of the folder; the path as named if the
                    absolute one cannot be found */
    char *path[MURK_RESULT_FILES];      /* of each main file, also if it is not
                                           there */
    murk_yaml *json[MURK_RESULT_FILES]; /* NULL: not there */
    struct dirent **entry; /* [entries]; of the folder, sorted by name, without
                              names that begin with a dot */
    int entries;
    char *strangers;        /* as murk_results_strangers() returns them, owned;
                               NULL: not computed */
    murk_scene_desc *scene; /* the resolved scene; NULL: not there, or it cannot
                               be read, for the reason in no_scene */
    murk_error no_scene;
    const char *made_by; /* borrowed; as in murk_report_read() */
} murk_results_in;

/* Reads the main JSON files and the resolved scene. Fails with MURK_BAD_FILE or
 * MURK_BAD_VALUE if there is no such folder, if it has no results, or if a main
 * JSON cannot be read or is of another version; or with MURK_NO_MEMORY. Release
 * *out in any case. `folder` must outlive it. */
murk_status murk_results_read(murk_results_in *out, const char *folder,
                              murk_error *err);
/* True if this JSON is there and is the main one of its run. ledger.json is not
 * if any other main JSON is there. */
bool murk_results_is_main(const murk_results_in *results,
                          murk_result_file which);

/* True if the folder has results of murk fit, of a fit or of a prediction, and
 * therefore fit.csv. */
bool murk_results_has_readings(const murk_results_in *results);

/* True if the JSON files of the folder may be of one run: no two differ in
 * command, folder of the command, checksum of the scene, seed or identity,
 * where both state it. */
bool murk_results_are_one_run(const murk_results_in *results);

/* The names, with ", " between them, of files that are listed in a main JSON
 * but do not have a checksum listed under `files` in any: they were edited, are
 * of an earlier run, or of one that was killed while it wrote them. Also
 * ledger.json if it is of another run. The caller frees the text; "" if there
 * are none, NULL when out of memory. */
char *murk_results_strangers(const murk_results_in *results);
void murk_results_release(murk_results_in *results);

/* True if the folder has a regular file of this name. */
bool murk_results_has(const char *folder, const char *name);

/* True if the part of a name from its last dot on is the extension, such as
 * ".csv". */
bool murk_name_ends(const char *name, const char *extension);

/* The file name of the resolved scene: "scene.resolved.yaml" if it is there;
 * else "scene.yaml", which older versions wrote, whether or not it is there. */
const char *murk_results_scene(const char *folder);

/* The path of a regular file of the folder, which the caller frees; NULL if
 * there is none, or out of memory. */
char *murk_results_path(const char *folder, const char *name);

/* Reads a CSV file of the folder. The caller owns *out (murk_table_destroy()).
 * If there is no such file, returns MURK_OK and leaves *out as it is. */
murk_status murk_results_table(murk_table **out, const char *folder,
                               const char *name, murk_error *err);

/* The cell of a row in the column of this name, as text or as a number. Without
 * such a column "" and NaN; NaN also if the cell is not a number. */
const char *murk_table_text(const murk_table *table, size_t row,
                            const char *name);
double murk_table_value(const murk_table *table, size_t row, const char *name);

/* The value of a key of a map (NULL: no such key), and the number of keys. NULL
 * and 0 if root is NULL or is not a map. */
const murk_yaml *murk_result_get(const murk_yaml *root, const char *key);
size_t murk_result_entries(const murk_yaml *root);

/* The value at a path such as "coverage.held_out"; "" is root itself. As node:
 * NULL if there is none, or if root is NULL. As number: NaN if it is not one.
 * As text: the text of any value but null, a list or a map; otherwise NULL. As
 * number of items: 0 if it is not a list. */
const murk_yaml *murk_result_at(const murk_yaml *root, const char *path);
double murk_result_number(const murk_yaml *root, const char *path);
const char *murk_result_text(const murk_yaml *root, const char *path);
size_t murk_result_count(const murk_yaml *root, const char *path);

/* True if the value at the path, as text, is this text. "true" and "false" are
 * texts, too. */
bool murk_result_is(const murk_yaml *root, const char *path, const char *text);

#endif
