/* A study file: a scene, the keys that are varied, and the outputs wanted for
 * each variant.
 *
 *   murk_study: 1
 *   base: fog-yard.yaml
 *   axes:
 *     media.fog.visibility_m: [20, 50, 100]
 *     weather: {dry: {}, wet: {media.rain.rain_mm_per_h: 5}}
 *
 * A row has one value of each axis: any combination of values (mode: grid), or
 * the values at equal positions (mode: paired). Keys:
 * doc/reference/studies.md. */
#ifndef MURK_SCENE_STUDY_FILE_H
#define MURK_SCENE_STUDY_FILE_H

#include "base/photometry.h"
#include "scene/variant.h"

/* Limits of a study: 10,000 rows of a minute each take a week. */
#define MURK_STUDY_ROWS_MAX    10000
#define MURK_STUDY_AXES_MAX    16
#define MURK_STUDY_OUTPUTS_MAX 128

typedef enum murk_study_axis_kind {
    MURK_STUDY_AXIS_KEY,      /* a key of the scene, by its path */
    MURK_STUDY_AXIS_NAMED,    /* names, each with several keys */
    MURK_STUDY_AXIS_CONDITION /* a condition of the scene, by its name */
} murk_study_axis_kind;

typedef struct murk_study_axis {
    const char *name;
    const char *path; /* for a key: the path, after short names are expanded */
    murk_scene_where where;
    murk_study_axis_kind kind;
    size_t n;
    murk_yaml **value; /* [n] owned; for names: maps of keys */
    char **text;       /* [n] owned: the values as a table shows them */
} murk_study_axis;

typedef struct murk_study_file {
    char *path; /* as given */
    char sha256[65];
    char *base; /* path of the scene, relative to the working folder */
    char *plan; /* path of sensors.csv or plan.json; NULL: none */
    bool is_paired;
    murk_study_axis *axis; /* [axes], in the file's order */
    size_t axes;
    size_t rows;
    char **output; /* [outputs] names, owned by the tree; none: the outputs that
                    * the scene has */
    size_t outputs;
    murk_scene_where outputs_where;
    size_t fluence_size[3]; /* grid of fluence_vdb; 0: chosen by the program */
    bool has_units;         /* false: the units of each scene */
    murk_quantity units;
    murk_yaml *root; /* the tree that names and values belong to */
} murk_study_file;

/* Reads a study file. The caller owns *out and releases it with
 * murk_study_file_destroy(). Refuses a study with more than MURK_STUDY_ROWS_MAX
 * rows. Fails with MURK_BAD_FILE, MURK_BAD_VALUE or MURK_NO_MEMORY. Opens
 * neither the scene nor the plan. */
murk_status murk_study_file_read(murk_study_file **out, const char *path,
                                 murk_error *err);
void murk_study_file_destroy(murk_study_file *study); /* NULL is fine */

/* Sets index[a] to the index of the value of axis a in row `row`, which is less
 * than study->rows. In a grid the last axis varies fastest; paired axes all
 * have the index `row`. */
void murk_study_row_indices(const murk_study_file *study, size_t row,
                            size_t *index);

/* Reads the scene of one row, with the overrides of the command line. The
 * caller owns *out and releases it with murk_scene_desc_destroy(). `study` must
 * outlive the call only. */
murk_status murk_study_row_scene(murk_scene_desc **out,
                                 const murk_study_file *study, size_t row,
                                 const murk_override *overrides,
                                 size_t n_overrides, murk_error *err);

#endif
