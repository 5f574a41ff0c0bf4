/* A result folder, read: what the commands left there, as far as it is there.
 *
 * JSON is read as YAML, of which it is a part: each value knows its line. Of
 * the main files at least one must be there, and each must be of this version:
 * same major and minor number. */
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
    MURK_RESULT_LEDGER,   /* ledger.json, of trace and all that trace */
    MURK_RESULT_FILES
} murk_result_file;

typedef struct murk_result_kind {
    const char *file, *key, *title; /* "plan.json", its key in the page's data,
                                       the heading of its answer */
} murk_result_kind;

extern const murk_result_kind murk_result_kinds[MURK_RESULT_FILES];

typedef struct murk_results_in {
    const char *folder; /* borrowed */
    char *whole;        /* its whole path; as named, where there is none */
    char *path[MURK_RESULT_FILES];      /* of each, there or not */
    murk_yaml *json[MURK_RESULT_FILES]; /* NULL: not there */
    struct dirent **entry; /* [entries] of the folder by name, without those
                              that begin with a dot */
    int entries;
    char *strangers;        /* murk_results_strangers(); NULL: not looked for */
    murk_scene_desc *scene; /* as resolved; NULL: not there, or cannot be read,
                               for the reason in no_scene */
    murk_error no_scene;
} murk_results_in;

/* Fails with MURK_BAD_FILE or MURK_BAD_VALUE in one line: no such folder, no
 * results in it, results that cannot be read or are of another version.
 * Release it in any case. */
murk_status murk_results_read(murk_results_in *out, const char *folder,
                              murk_error *err);
/* Whether it is there, and no other's by-product: ledger.json is, beside any
 * other. */
bool murk_results_is_main(const murk_results_in *results,
                          murk_result_file which);

/* Whether the JSONs of the folder can be of one run: files of another that was
 * written over them, or beside them, have another command, scene or seed. */
bool murk_results_are_one_run(const murk_results_in *results);

/* The files that some main JSON lists and none as they are: edited, or of a run
 * that was killed while it wrote them. Their names, ", " between, for free();
 * "" where there is none, NULL when out of memory. */
char *murk_results_strangers(const murk_results_in *results);
void murk_results_release(murk_results_in *results);

/* Whether there is such a regular file. */
bool murk_results_has(const char *folder, const char *name);

/* True if a name ends in an extension, as ".csv". */
bool murk_name_ends(const char *name, const char *extension);

/* The name of the resolved scene in the folder: scene.yaml, as older versions
 * wrote it, where there is no scene.resolved.yaml. */
const char *murk_results_scene(const char *folder);

/* The path of a regular file of the folder, for free(); NULL if there is none.
 */
char *murk_results_path(const char *folder, const char *name);

/* A CSV of the folder; *out stays NULL where there is none. */
murk_status murk_results_table(murk_table **out, const char *folder,
                               const char *name, murk_error *err);

/* The cell of a row in the column of that name; as a text "", as a number NaN
 * if there is none. */
const char *murk_table_text(const murk_table *table, size_t row,
                            const char *name);
double murk_table_value(const murk_table *table, size_t row, const char *name);

/* The value under a key of a map, and the number of keys of a map; NULL and 0
 * if root is no map. */
const murk_yaml *murk_result_get(const murk_yaml *root, const char *key);
size_t murk_result_entries(const murk_yaml *root);

/* What lies under a path such as "coverage.held_out"; NULL where there is
 * nothing, or root is NULL. As a number NaN, as a text NULL where it is none;
 * as a list 0 children. */
const murk_yaml *murk_result_at(const murk_yaml *root, const char *path);
double murk_result_number(const murk_yaml *root, const char *path);
const char *murk_result_text(const murk_yaml *root, const char *path);
size_t murk_result_count(const murk_yaml *root, const char *path);

/* Whether it is that text; true and false are texts, too. */
bool murk_result_is(const murk_yaml *root, const char *path, const char *text);

#endif
