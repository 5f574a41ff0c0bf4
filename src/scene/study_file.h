/* A study's file: a scene, what is varied in it, and what is wanted of each
 * variant.
 *
 *   murk_study: 1
 *   base: fog-yard.yaml
 *   axes:
 *     media.fog.visibility_m: [20, 50, 100]
 *     weather: {dry: {}, wet: {media.rain.rain_mm_per_h: 5}}
 *
 * A row is one value of each axis. Keys and meanings: scenes/README.md. */
#ifndef MURK_SCENE_STUDY_FILE_H
#define MURK_SCENE_STUDY_FILE_H

#include "base/photometry.h"
#include "scene/variant.h"

#define MURK_STUDY_ROWS_MAX    10000
#define MURK_STUDY_AXES_MAX    16
#define MURK_STUDY_OUTPUTS_MAX 128

typedef enum murk_study_axis_kind {
    MURK_STUDY_AXIS_KEY,      /* of the scene, by its path */
    MURK_STUDY_AXIS_NAMED,    /* names, each of several keys */
    MURK_STUDY_AXIS_CONDITION /* a condition of the scene, by its name */
} murk_study_axis_kind;

typedef struct murk_study_axis {
    const char *name;
    const char *path; /* of KEY: its name, or what that is short for */
    murk_scene_where where;
    murk_study_axis_kind kind;
    size_t n;
    murk_yaml **value; /* [n] owned; of NAMED, maps of keys */
    char **text;       /* [n] owned: as a table shows them */
} murk_study_axis;

typedef struct murk_study_file {
    char *path; /* as given */
    char sha256[65];
    char *base; /* the scene, as it is to be opened */
    char *plan; /* sensors.csv or plan.json, likewise; NULL: none */
    bool is_paired;
    murk_study_axis *axis; /* [axes], in the file's order */
    size_t axes;
    size_t rows;
    char **output; /* [outputs]; 0: what the scene has */
    size_t outputs;
    murk_scene_where outputs_where;
    size_t fluence_size[3]; /* of fluence_vdb; 0: murk's choice */
    bool has_units;         /* else the scenes' */
    murk_quantity units;
    murk_yaml *root; /* what all else is from */
} murk_study_file;

/* *out is the caller's: murk_study_file_destroy(). Refuses, before anything is
 * made of it, a study of more than MURK_STUDY_ROWS_MAX rows. Neither the scene
 * nor the plan is opened. */
murk_status murk_study_file_read(murk_study_file **out, const char *path,
                                 murk_error *err);
void murk_study_file_destroy(murk_study_file *study); /* NULL is fine */

/* Which value of each axis row `row` has: index[axes]. Grids: the last axis
 * varies fastest. */
void murk_study_row_indices(const murk_study_file *study, size_t row,
                            size_t *index);

/* The scene of one row. Overrides are the command line's. */
murk_status murk_study_row_scene(murk_scene_desc **out,
                                 const murk_study_file *study, size_t row,
                                 const murk_override *overrides,
                                 size_t n_overrides, murk_error *err);

#endif
