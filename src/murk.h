/* murk: light in fog, smoke, rain and water, and the places of sensors in it.
 *
 * This header is the whole public interface of the library (-lmurk). C11, C17,
 * C++17. This command compiles a program:
 *
 *     cc program.c $(pkg-config --cflags --libs murk)
 *
 * A program that is built by CMake links with murk::murk, a target of the
 * package murk. The folder doc/api/examples has a program for each section of
 * this header.
 *
 *     murk_scene -> murk_world -> murk_light -> murk_coverage, murk_plan,
 *                                               murk_picture
 *     murk_study, murk_fit: many scenes at once, and media from readings
 *
 * Each handle but murk_fields and murk_batch is created by one call and
 * released by murk_<handle>_destroy(), which takes NULL. A handle stays usable
 * after the handles that it was made from are destroyed, so handles may be
 * destroyed in any order. World, light, coverage and picture do not change
 * after they are made; a plan changes by murk_plan_repeat() and
 * murk_plan_repeat_merge(), a study by murk_study_run() and a fit by
 * murk_fit_run() alone; a scene changes by murk_scene_set(),
 * murk_scene_use_light(), murk_scene_add_mesh(), murk_scene_add_grid() and
 * murk_scene_add_table(), a list of sensors by murk_sensors_add().
 *
 * Units: metres, watts, 1/m, nanometres, degrees where a name ends in _deg.
 * Directions are unit vectors along the travel of light.
 *
 * Errors: a function that can fail returns a murk_status and fills *error if it
 * is not NULL. Nothing is printed but the progress line that a context may ask
 * for, no signal handler is installed, and no call ends the process. If a call
 * fails, *out is NULL. Any of these functions fails with MURK_BAD_VALUE if an
 * argument is NULL that may not be NULL, and with MURK_NO_MEMORY; the comment
 * of a function says what else it fails with.
 *
 * Threads: handles of one context are used by one thread at a time; two threads
 * with two contexts do not disturb each other. murk_context_cancel() and
 * murk_context_finish() may be called from any thread and from a signal
 * handler.
 *
 * Structs that begin with `size` may get further members in later versions. The
 * caller sets `size` to sizeof, and all members without a purpose to 0. Any
 * function refuses a size of 0, and any other that cannot be sizeof, with
 * MURK_BAD_VALUE. A shorter struct, of an older header, is taken as if the
 * missing members were 0; a longer one, of a newer header, is taken if the
 * members that the library does not know are 0, and refused with
 * MURK_UNSUPPORTED otherwise. Of a struct that the library fills, it fills the
 * members that it knows. murk_error alone may have the size 0.
 *
 * Lists are a pointer and a number of elements. NULL with a number above 0, and
 * NULL as an element of a list of strings, are refused with MURK_BAD_VALUE; a
 * list of 0 elements is empty whatever the pointer is.
 *
 * Strings are UTF-8. Strings, fields and views that a call returns belong to
 * the handle that was asked, and are valid until this handle is destroyed,
 * unless the comment says less. */
#ifndef MURK_H
#define MURK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- library ---- */

/* The version of this header. A libmurk.so.0 of this version or a later one
 * supports it. */
#define MURK_VERSION_MAJOR 0
#define MURK_VERSION_MINOR 1
#define MURK_VERSION_PATCH 0

/* The version of the library that runs, as "MAJOR.MINOR.PATCH". */
const char *murk_version(void);

typedef enum murk_status {
    MURK_OK,
    MURK_BAD_VALUE,   /* a key, a value or an argument is not allowed */
    MURK_BAD_FILE,    /* a file is missing or malformed */
    MURK_UNSUPPORTED, /* not supported yet */
    MURK_NO_MEMORY,   /* out of memory */
    MURK_RUN_FAILED,  /* the run failed */
    MURK_INTERRUPTED  /* cancelled by murk_context_cancel() */
} murk_status;

/* The meaning of a status code, "a file is missing or malformed"; for any other
 * number "unknown status". */
const char *murk_status_text(murk_status status);

/* The reason for a failure. The caller sets `size` to sizeof(murk_error) and
 * all else to 0, as MURK_ERROR_NONE does, and does so again before the struct
 * is used for another call: a message that it contains already is kept, and a
 * call that succeeds does not clear it. So that no message is lost, size 0
 * counts as that of the first version. A value that murk_scene_set() gave has a
 * key and no file or line. */
typedef struct murk_error {
    size_t size;
    murk_status code;
    int line, column; /* in `file`, from 1; 0: the whole file */
    char file[320];   /* the file, or the name of a text; if a call adds an
                       * array, the name of the array; "" if there is none */
    char key[160];   /* path of the key in a scene, "media.fog.albedo"; or "" */
    char where[320]; /* file, line, column and key as one text; or "argument
                      * NAME"; or the name of a setting, "runs" or "keys KEY";
                      * or the path of a field of a result */
    char text[640];  /* the value found and the allowed values, with units */
} murk_error;

/* An error without a message: murk_error error = MURK_ERROR_NONE; */
#define MURK_ERROR_NONE                                   \
    {                                                     \
        sizeof(murk_error), MURK_OK, 0, 0, "", "", "", "" \
    }

/* ---- arrays ---- */

typedef enum murk_type {
    MURK_TYPE_UINT8,
    MURK_TYPE_UINT16,
    MURK_TYPE_UINT32,
    MURK_TYPE_UINT64,
    MURK_TYPE_FLOAT32,
    MURK_TYPE_FLOAT64
} murk_type;

/* The largest number of dimensions. A tally on a plane has so many: band, two
 * axes, angle bin and direction. */
#define MURK_ARRAY_DIMENSIONS 5

/* An array: element (i, j, ...) lies at data + i * stride[0] + j * stride[1] +
 * ... bytes. Shapes are in the order of C: the last index is the fastest of a
 * dense array. */
typedef struct murk_array {
    size_t size; /* sizeof(murk_array), set by the caller */
    const void *data;
    murk_type type;
    int dimensions;
    size_t shape[MURK_ARRAY_DIMENSIONS];
    ptrdiff_t stride[MURK_ARRAY_DIMENSIONS]; /* [bytes] */
    bool is_copy; /* of a result: true if the values were converted from the
                   * form in which murk stores them; false: the stored values
                   * themselves */
} murk_array;

/* Describes a dense array of the caller, in the order of C: data, type,
 * dimensions and shape[dimensions]; shape NULL, or dimensions not 1..5: an
 * array of no dimensions, which every call refuses. The values are not copied.
 * An array with gaps, or in another order, is described by its strides. */
murk_array murk_array_of(const void *data, murk_type type, int dimensions,
                         const size_t *shape);

/* ---- context ---- */

typedef struct murk_context murk_context;

/* A warning (something is probably wrong) or a note (correct input with an
 * effect that may surprise). `where` is "" or a place as in murk_error. Called
 * from the thread that uses the context, or from a thread of murk, while the
 * thread that uses the context waits. */
typedef void (*murk_log_function)(void *user, bool is_warning,
                                  const char *where, const char *text);

/* The state of a long step, such as "trace", in `unit` ("photons"), which is ""
 * for a step that counts nothing. */
typedef struct murk_progress {
    size_t size;
    const char *step, *unit, *text; /* text: state of a search, or "" */
    uint64_t done, total;           /* total 0: unknown */
    double elapsed_s;
} murk_progress;

/* Called some five times a second from a thread of murk, and at the end of the
 * outermost step from the thread that uses the context. Steps may have inner
 * steps. The end of an inner step has no call of its own: `done` of the last
 * call of an inner step may be below `total`. */
typedef void (*murk_progress_function)(void *user,
                                       const murk_progress *progress);

/* Which process reads the mesh and grid files of a scene, which may be
 * malformed or hostile, and which process runs the rows of a study. Results do
 * not depend on it. */
typedef enum murk_imports {
    MURK_IMPORTS_READER, /* the program murk-reader, started for each file, with
                          * limits on memory and time, that can only read; the
                          * program murk-rows, started for each group of rows */
    MURK_IMPORTS_FORK, /* forks of the process, likewise: needs no program, but
                        * the module murk-openvdb.so for grids; is safe only
                        * while the process has one thread and no world, so not
                        * with murk_follow_next() */
    MURK_IMPORTS_IN_PROCESS /* the process itself, without limits: for files
                             * that are trusted; a malformed file may end the
                             * process, and so does a row that crashes or takes
                             * too much memory */
} murk_imports;

/* Whether the library draws the progress of long steps as a line on standard
 * error, with the steps of subprocesses, of which murk_progress_function is not
 * told. */
typedef enum murk_progress_mode {
    MURK_PROGRESS_NEVER,
    MURK_PROGRESS_AUTO, /* if standard error is a terminal */
    MURK_PROGRESS_ALWAYS
} murk_progress_mode;

typedef struct murk_context_options {
    size_t size;                     /* sizeof(murk_context_options) */
    unsigned threads;                /* 0: one per processor, 256 at most */
    murk_log_function log;           /* NULL: warnings and notes are dropped */
    murk_progress_function progress; /* NULL: none */
    void *user;                      /* passed to both */
    murk_imports imports;
    const char *reader; /* path of murk-reader; NULL: libmurk0/murk-reader in
                         * the folder of the library; copied; murk-rows and the
                         * modules murk-openvdb.so and murk-ceres.so lie in the
                         * same folder */
    murk_progress_mode line;   /* not with `progress` */
    const char *const *inputs; /* [n_inputs] files that the caller reads: no
                                * call replaces one of them */
    size_t n_inputs;
} murk_context_options;

/* Creates a context, which all other handles are made in; options NULL: zeros.
 * Fails with MURK_BAD_VALUE if options->imports or options->line is no value of
 * the enumeration or if both `line` and `progress` are given, and with
 * MURK_RUN_FAILED if the machine refuses the threads. */
murk_status murk_context_create(murk_context **out,
                                const murk_context_options *options,
                                murk_error *error);
void murk_context_destroy(murk_context *context);

/* Makes the long call that runs in the context, or else the next long call,
 * stop at the next batch and return MURK_INTERRUPTED; later calls work as
 * usual. Calls that do no long work, such as murk_scene_set(), do not stop. */
void murk_context_cancel(murk_context *context);

/* Makes the search for a plan that runs in the context finish: the best plan
 * and the bound so far become the result, completed to the wanted number of
 * sensors where needed, and are measured as usual, and the call succeeds. Field
 * `placement.cut_by` of the plan is then "interrupt", because the result
 * depends on the time of the request. Returns true if a search of
 * murk_plan_make(), murk_plan_for_light() or murk_plan_for_matrix() runs that
 * was not asked before. Otherwise nothing changes: before the search there is
 * no plan, and repeats, studies and fits compare plans that are searched alike.
 * If a target is not reached, the call fails with MURK_INTERRUPTED. */
bool murk_context_finish(murk_context *context);

/* ---- scene ---- */

typedef struct murk_scene murk_scene;

/* Creates a scene that has only the key `murk`; murk_scene_set() gives it
 * further keys. Fails with MURK_NO_MEMORY. */
murk_status murk_scene_create(murk_scene **out, murk_context *context,
                              murk_error *error);

/* Reads a scene from a file, or from YAML text. `name` stands for the file in
 * messages; files that the text names are relative to the folder of `name`;
 * NULL: "scene", in the working folder. The text is checked as YAML; keys and
 * values are checked by murk_scene_check() and murk_world_create(). Fails with
 * MURK_BAD_FILE if there is no such file, or at line and column if the text is
 * not YAML. */
murk_status murk_scene_read(murk_scene **out, murk_context *context,
                            const char *path, murk_error *error);
murk_status murk_scene_parse(murk_scene **out, murk_context *context,
                             const char *text, const char *name,
                             murk_error *error);
void murk_scene_destroy(murk_scene *scene);

/* Sets a key by its path, "sensors.count" or "lights.0.power_w", to a value in
 * YAML flow style: "5", "[1, 2, 3]", "{preset: fog/radiation, mor_m: 80}". The
 * last value of a key counts. The value is parsed here and checked with the
 * whole scene. Worlds that exist do not change. The key need not be in the text
 * of the scene. A key of the text that excludes this one is removed
 * (photons.emit and photons.store exclude each other). Fails with
 * MURK_BAD_VALUE if there is no such key, or if an earlier call has set a key
 * that excludes this one, and with MURK_BAD_FILE if the value is not YAML; the
 * scene is then as before. */
murk_status murk_scene_set(murk_scene *scene, const char *key,
                           const char *value, murk_error *error);

/* *json: the value of a key in the resolved scene as JSON, defaults included:
 * "0.2", "[1,2,3]", "{...}"; key "": the whole scene. Valid until the next call
 * of this function with the scene. Fails as murk_scene_check(), and with
 * MURK_BAD_VALUE if the scene has no such key. */
murk_status murk_scene_get(murk_scene *scene, const char *key,
                           const char **json, murk_error *error);

/* Sets `seed` and photons.emit or photons.store to those of a file of light,
 * light.murk, unless murk_scene_set() has set them or a map that contains them.
 * murk_light_read() refuses light of another seed or another number of photons.
 * Fails with MURK_BAD_FILE if the file cannot be read as light. */
murk_status murk_scene_use_light(murk_scene *scene, const char *path,
                                 murk_error *error);

/* Reads the whole scene and checks each value; does not open the files that the
 * scene names. Fails with MURK_BAD_VALUE at the first key that is unknown,
 * missing or out of range, and with MURK_BAD_FILE if the text is a study. */
murk_status murk_scene_check(murk_scene *scene, murk_error *error);

/* *text: the scene as resolved, with all defaults, as scene.resolved.yaml;
 * valid until the next call with this scene. Fails as murk_scene_check(). */
murk_status murk_scene_resolved(murk_scene *scene, const char **text,
                                murk_error *error);

/* Adds a mesh that keys for files take as "memory:NAME", for example
 * murk_scene_set(scene, "geometry", "[{file: memory:hall, material: wall}]").
 *
 * vertices_m: n x 3, floats or doubles; triangles: m x 3 indices, uint32 or
 * uint64; material: m indices into material_names[n_materials], uint32, or NULL
 * if all triangles have the first material. int32 indices that are not negative
 * may be passed as MURK_TYPE_UINT32. n_materials 0: the name of the only
 * material is "". Replaces an array of the same name.
 *
 * release NULL: the arrays are copied; else vertices_m must be dense float32
 * and triangles dense uint32, both are used in place, and release(user) is
 * called once: after the mesh was replaced or the scene destroyed, and all
 * worlds and fits that were made with the mesh are destroyed. If the call
 * fails, release is not called and the arrays stay the caller's. Fails with
 * MURK_BAD_VALUE if the name is empty, has more than 63 characters or others
 * than letters, digits, "_", "-" and ".", if a shape or a type does not fit, if
 * the mesh is empty, if the name of a material is too long, if an index is out
 * of range, or if a coordinate is not finite. */
murk_status murk_scene_add_mesh(murk_scene *scene, const char *name,
                                const murk_array *vertices_m,
                                const murk_array *triangles,
                                const murk_array *material,
                                const char *const *material_names,
                                size_t n_materials, void (*release)(void *user),
                                void *user, murk_error *error);

/* Adds a grid that the key `vdb` of a medium takes as "memory:NAME". A grid of
 * albedos must be a file.
 *
 * values: nx x ny x nz, floats or doubles, finite, at least 0. Value (i, j, k)
 * fills the cell around the point index_to_world * (i, j, k, 1), or with
 * `interpolation: linear` is the value at that point. index_to_world is 3 x 4,
 * row by row, in metres, and must be invertible. Replaces an array of the same
 * name. release NULL: the values are copied; else they must be dense floats
 * with x fastest (stride[0] = 4), are used in place, and release(user) is
 * called as for a mesh. If the call fails, release is not called. Fails with
 * MURK_BAD_VALUE if the name, the type or the order is wrong, if there are no
 * values, if a value is negative or not finite, or if index_to_world has a
 * number that is not finite, is singular, or makes voxels of less than
 * 3e-15 m3. */
murk_status murk_scene_add_grid(murk_scene *scene, const char *name,
                                const murk_array *values,
                                const double index_to_world[12],
                                void (*release)(void *user), void *user,
                                murk_error *error);

/* Adds a table that keys for CSV files take as "memory:NAME": candidate places,
 * targets, phase functions.
 *
 * values: rows x columns, floats or doubles; columns[]: the names of the
 * columns, as in the first line of the CSV file. Values and names are copied;
 * the table replaces an array of the same name. Fails with MURK_BAD_VALUE if
 * the name or the type is wrong, or if the name of a column is NULL; the values
 * are checked by the key that takes the table. */
murk_status murk_scene_add_table(murk_scene *scene, const char *name,
                                 const char *const *columns,
                                 const murk_array *values, murk_error *error);

/* ---- results ---- */

/* The fields of a result by the names of the JSON files of the program, listed
 * in murk-results(5). A path joins names and indices by dots:
 * "coverage.held_out", "sensors.0.position_m.2". A name may contain dots
 * itself, such as "ground.001" of a material in
 * "absorbed_by_material_w.ground.001.total": the longest name that leads to a
 * value counts. A result belongs to the handle that it was asked of. */
typedef struct murk_fields murk_fields;

typedef enum murk_field_kind {
    MURK_FIELD_UNKNOWN, /* there is no such field */
    MURK_FIELD_ABSENT,  /* the field has no value: null in JSON */
    MURK_FIELD_NUMBER,
    MURK_FIELD_BOOL,
    MURK_FIELD_STRING,
    MURK_FIELD_LIST,
    MURK_FIELD_OBJECT
} murk_field_kind;

/* The kind of the field at a path. */
murk_field_kind murk_fields_kind(const murk_fields *fields, const char *path);

/* *value: the value of a field. An absent number is NaN, an absent string NULL;
 * for int64 and bool an absent value is an error. int64 is for whole numbers
 * up to 2^53 - 1, which JSON holds exactly. Fails with MURK_BAD_VALUE if there
 * is no such field, if it is of another kind, or if int64 is asked of a number
 * with a fraction or beyond that limit; *value is then as before. */
murk_status murk_fields_double(const murk_fields *fields, const char *path,
                               double *value, murk_error *error);
murk_status murk_fields_int64(const murk_fields *fields, const char *path,
                              int64_t *value, murk_error *error);
murk_status murk_fields_bool(const murk_fields *fields, const char *path,
                             bool *value, murk_error *error);
murk_status murk_fields_string(const murk_fields *fields, const char *path,
                               const char **value, murk_error *error);

/* The number of items of a list or of fields of an object ("": of the whole
 * result); 0 for any other field. */
size_t murk_fields_length(const murk_fields *fields, const char *path);

/* The name of field i of an object; NULL if there is none. */
const char *murk_fields_name(const murk_fields *fields, const char *path,
                             size_t i);

/* The whole result as JSON. */
const char *murk_fields_json(const murk_fields *fields);

/* ---- folders ---- */

/* What murk_<handle>_save() writes beside the files that it always writes, and
 * what these files say of the run. All members but size may be NULL or false.
 *
 * murk_light_save(), murk_coverage_save(), murk_plan_save(), murk_study_save()
 * and murk_fit_save() write the files of the command murk trace, sense, place,
 * study and fit to a folder, which is made if there is none. The main JSON
 * comes last. If the call fails before files are moved into the folder, the
 * folder is left as it was. If moving fails, files moved before are in place,
 * and the main JSON is still the old one. An export that cannot be made is left
 * out: then the other files are written, *fields are filled, and the call
 * fails.
 *
 * folder NULL: nothing is written; *fields are filled, with `files` and
 * saved.files empty and saved.folder null.
 *
 * options NULL: zeros. fields may be NULL; else *fields are those of the main
 * JSON as written, with `identity`, `files` and `run` (run.summary: the lines
 * of text that the program prints), and beside them `saved.folder` and
 * `saved.files`, the names of all files in the order written.
 * murk_fields_json() is the text of the main JSON. *fields are valid until the
 * next save of the handle.
 *
 * These functions fail with MURK_BAD_VALUE if a file may not be replaced or if
 * the options ask for what the scene does not have, with MURK_RUN_FAILED if a
 * file cannot be written, and with MURK_INTERRUPTED if they are cancelled. */
typedef struct murk_save_options {
    size_t size;         /* sizeof(murk_save_options) */
    const char *exports; /* words with commas between, and blanks if wanted:
                          * fields, photons, surfaces; of a plan or coverage
                          * also geojson, geo-csv; of a plan also matrix,
                          * or-library, lp; of the steps of a timeline also
                          * light; studies and fits refuse it and voxel_m */
    const char *voxel_m; /* largest edge of exported voxels and of pieces of
                          * surfaces [m], "0.5"; NULL: some 100,000 voxels, and
                          * pieces of some five photons */
    bool replaces;       /* also files that murk did not write, or that were
                          * edited since; files that the context has read are
                          * not replaced, and the call fails unless they have
                          * the same bytes already */
    const char *command; /* the command line of the caller: run.command */
    const char *asked;   /* a text that says what else the results follow from,
                          * beside the scene; `identity` covers it */
    const char *made_by; /* used by murk_context_write_report() alone, for a
                          * folder that the caller removes afterwards: what made
                          * the results, "plan.report() in Python". The page
                          * shows this text in place of the name of the folder,
                          * the list of its files and the commands that use
                          * it */
} murk_save_options;

/* Writes the page of a folder of results (plan.json, ledger.json, study.json,
 * ...) to `page`, one HTML file; NULL: to report.html in the folder. Arrays of
 * the scene are in no file: the page shows them if the world or fit whose
 * results were saved to the folder last, by a call in this context, still
 * exists. Warns of files that do not belong to the results. options:
 * `replaces`, without which a file that murk did not write is not replaced,
 * `asked`, for `identity`, and `made_by` are used; NULL: zeros. Files that are
 * read for the page may be replaced by later calls. fields may be NULL; else
 * *fields are
 * `report` (the path of the page), `bytes`, `photons`, `photons_shown`,
 * `sensors_shown`, `identity` and `files`, valid until the next call of this
 * function with the context. Fails with MURK_BAD_FILE if the folder holds no
 * results or a malformed file, with MURK_BAD_VALUE if the results are of
 * another major or minor version, with MURK_BAD_VALUE or MURK_RUN_FAILED if the
 * page cannot be written, and with MURK_INTERRUPTED if the call is cancelled.
 */
murk_status murk_context_write_report(murk_context *context, const char *folder,
                                      const char *page,
                                      const murk_save_options *options,
                                      const murk_fields **fields,
                                      murk_error *error);

/* ---- presets ---- */

/* *fields: what a preset of media, "fog/kruse", comes to, as murk media: `murk`
 * (the version), `preset`, `about`, `wavelength_nm` (the range), `words` (of
 * each word `value`, `default`, `least`, `most` and `unit`), `bands` (of each
 * band `band_nm`, the extinction, absorption and scattering coefficient [1/m],
 * the albedo, the mean cosine and `phase`, the kind of phase function),
 * `sources`, `doubts`, `identity` and `files`, which is empty. key[n] and
 * value[n]: keys of the medium and their values, "visibility_m" and "50", or
 * bands_nm, band_edges_nm and seed of the scene, as murk_scene_set() takes
 * them. name NULL: `presets`, the list of all, for which n is 0. options:
 * `asked` alone is used, for `identity`; NULL: zeros. The fields are valid
 * until the next call of this function with the context. Fails with
 * MURK_BAD_VALUE if there is no such preset or key, or if a value is wrong, and
 * with MURK_INTERRUPTED if the call is cancelled. */
murk_status murk_context_preset(murk_context *context, const char *name,
                                const char *const *key,
                                const char *const *value, size_t n,
                                const murk_save_options *options,
                                const murk_fields **fields, murk_error *error);

/* ---- profiles ---- */

/* What murk_context_profile_grid() reads of a CSV file, and the size of the
 * grid. All members but size may be NULL or 0. */
typedef struct murk_profile_options {
    size_t size;        /* sizeof(murk_profile_options) */
    const char *column; /* name of the column of the coefficient; NULL: the only
                         * column of a coefficient */
    const char *rows;   /* "COLUMN=VALUE": only the rows with that value in that
                         * column, such as one cast of many; NULL: all rows */
    double voxel_m;     /* height of a voxel [m]; 0: a hundredth of the height
                         * of the profile */
    double width_m;     /* width of the grid in x and in y [m]; 0: 1000 */
} murk_profile_options;

/* Reads a measured profile of a coefficient [1/m] from the CSV file `csv`,
 * whose columns murk-media(5) describes, and writes the profile to the file
 * `grid` (.vdb), which the key `vdb` of a medium with extinction_per_m 1 takes.
 * The grid is one voxel wide, its top is the highest place of the profile, and
 * the optical depth of each voxel is that of the profile. options NULL: zeros.
 * save: `replaces`, without which a file that murk did not write is not
 * replaced, and `asked`, a text that stands for the input in `identity`, are
 * used; NULL: zeros, and `identity` follows from the contents of the CSV file
 * and from the options. fields may be NULL; else *fields are `profile` and
 * `grid` (the two paths), `column`, `rows` (the number that was read),
 * `voxels`, `voxel_m`, `width_m`, `top_m` and `bottom_m` (the heights of the
 * ends of the profile), `optical_depth`, `identity` and `files`, valid until
 * the next call of this function with the context. Fails with MURK_BAD_FILE if
 * the CSV file cannot be read, with MURK_BAD_VALUE at the line and column of a
 * wrong value, if an option does not fit, or if the file may not be replaced,
 * and with MURK_RUN_FAILED if the file cannot be written. */
murk_status murk_context_profile_grid(murk_context *context, const char *csv,
                                      const char *grid,
                                      const murk_profile_options *options,
                                      const murk_save_options *save,
                                      const murk_fields **fields,
                                      murk_error *error);

/* ---- reference ---- */

/* *fields: what murk knows of files and of itself, by name, for editors and
 * forms.
 *
 * "scene": the keys of a scene file. `introduction` and `keys` are those of the
 * top level; `all` is a list of all keys, with `path` ("media.*.albedo", where
 * * stands for the name or the number of an item) and `is_settable` (the path
 * has no *, and the key is no map). Each key has `type` ("number", "word",
 * "list of maps"), `value` (the values in words), `range` of numbers
 * (`minimum`, `maximum`, `excludes_minimum`, `excludes_maximum`), `words` (the
 * names of detection modes, of types of lights and the like), `unit`, `default`
 * in YAML, `default_in_words` if the default depends on other keys, `required`
 * (of a group, `of_group`: one key of the group), `in_place_of` (the other keys
 * of the group, of which a map has one at most), `variants` (the kinds of the
 * map that have the key; empty: all), and `meaning`.
 *
 * "scene.KEY", with the path of a key: `path`, `of` (what has the key), `rows`
 * (the same members, once for each kind of values that the key takes in
 * different variants of the map), and `introduction` and `keys` of the map if
 * the key is a map. "study" and "study.KEY": the same of a study file.
 *
 * "schema": a JSON Schema (draft-07) of scene and study files, which
 * murk_fields_json() prints. "version": `version`, `commit`, `date` (of the
 * commit), `compiler` and `packages` of the library.
 *
 * The fields are valid until the next call of this function with the context.
 * Fails with MURK_BAD_VALUE if there is no such name or key. */
murk_status murk_context_reference(murk_context *context, const char *name,
                                   const murk_fields **fields,
                                   murk_error *error);

/* *fields: the keys in a file of lines KEY: VALUE, such as calibrated.yaml of a
 * fit: `keys`, in the order of the file, of each `key` and `value`, as
 * murk_scene_set() and murk_study_options take them. If the data refused the
 * model of the fit, the log gets a warning. Whether a scene has such keys is
 * not checked. The fields are valid until the next call of this function with
 * the context. Fails with MURK_BAD_FILE if the file cannot be read or is not
 * such a map, and with MURK_BAD_VALUE if a value is not a number or a word. */
murk_status murk_context_read_keys(murk_context *context, const char *path,
                                   const murk_fields **fields,
                                   murk_error *error);

/* ---- world ---- */

typedef struct murk_world murk_world;

/* Checks the whole scene, reads its files and builds surfaces, media and light
 * sources. With conditions to place over (the key placement.over), the world is
 * built by the first call that needs it instead. The options of the context say
 * which process reads mesh and grid files. Fails as murk_scene_check(), with
 * MURK_BAD_VALUE if parts of the scene do not fit each other, such as a region
 * of interest outside of the domain, with MURK_BAD_FILE if a mesh, a grid or
 * the table of a phase function is missing, malformed or larger than the
 * limits, with MURK_RUN_FAILED if the process that reads a file cannot be
 * started or ends without an answer, and with MURK_INTERRUPTED if the call is
 * cancelled. */
murk_status murk_world_create(murk_world **out, murk_scene *scene,
                              murk_error *error);
void murk_world_destroy(murk_world *world);

/* The box of the domain: min x, y, z, max x, y, z [m]; NaN if the world cannot
 * be built. */
void murk_world_bounds(const murk_world *world, double bounds_m[6]);

/* The number of bands, and the wavelength of band i [nm], from 0 (NaN: no such
 * band). */
int murk_world_bands(const murk_world *world);
double murk_world_band_nm(const murk_world *world, int i);

/* Finds out before any light is traced if murk_light_save() (command "trace"),
 * murk_coverage_save() ("sense") or murk_plan_save() ("place") would refuse the
 * folder or the options. runs: those of murk_plan_repeat(), else 0. Fails with
 * MURK_BAD_VALUE if they would, if there is no such command, if the scene does
 * not allow the exports or, with the command "sense", has conditions to place
 * over, or if the seeds or goals of the scene cannot be repeated; with
 * MURK_RUN_FAILED if the folder cannot be written to; and as
 * murk_world_create() if the world is built here. */
murk_status murk_world_check_save(murk_world *world, const char *command,
                                  uint64_t runs, const char *folder,
                                  const murk_save_options *options,
                                  murk_error *error);

/* Traces one photon of the world again, as murk replay: photon is its number,
 * as the field `emitted` of murk_light_array() has it. *fields: `photon` and
 * `events`, a list with `number`, `kind`, `partner`, `outcome` (only of events
 * on surfaces, in media and at interfaces), `position_m`, `direction_in`,
 * `direction_out` [unit vectors] and `path_m` (since the event before) of each
 * event, in the order along the path; valid until the next call of this
 * function with the world. With photons.store, any number below 2^32 - 1 is
 * accepted. options: `command` and `asked` alone are used, for `run` and
 * `identity`; NULL: zeros. Fails with MURK_BAD_VALUE if the scene emits no
 * photon of this number, with MURK_INTERRUPTED if the call is cancelled, and as
 * murk_world_create() if the world is built here. */
murk_status murk_world_replay(murk_world *world, uint64_t photon,
                              const murk_save_options *options,
                              const murk_fields **fields, murk_error *error);

/* What murk_world_check() draws and forecasts. All members but size may be
 * zeros. */
typedef struct murk_check_options {
    size_t size;         /* sizeof(murk_check_options) */
    const char *picture; /* path of a PNG file, ending in ".png", for a plan and
                          * two sections of the world on one sheet; NULL: no
                          * picture, and the members below must be zeros */
    size_t pixels[2];    /* width and height of the sheet, 640 x 480 or more;
                          * zeros: 1600 wide, and as high as needed */
    const double *cut_m; /* [3] x of the plane of the side section, y of that of
                          * the front section and z of that of the plan [m];
                          * NULL: x and y of the middle of the candidates, or of
                          * all things if there are none, and z at most 1.5 m
                          * above the floor */
    size_t ranks;        /* forecast what each of this number of ranks of
                          * murk-mpi computes, holds and receives, at most
                          * 100000; 0: no such forecast */
} murk_check_options;

/* Looks over the world before its light is traced, as murk check, and gives
 * warnings of what is probably wrong to the log of the context. *fields, which
 * murk-results(5) lists: `domain`, `surfaces`, `mesh_materials`, `media`,
 * `regions`, `lights`, `candidates`, `sensors`, `tallies`, `cameras` and
 * `forecast` (the photons that a run will emit and store, and the memory of the
 * run [bytes], by a pilot run of few photons), with options->ranks `ranks`,
 * with options->picture `picture`, and `identity`, `files` and `run`.
 * run.summary, the lines of text that the program prints, is a field alone and
 * not in murk_fields_json(). fields may be NULL; else *fields are valid until
 * the next call of this function with the world. options NULL: zeros. save:
 * `replaces`, without which a file that murk did not write is not replaced by
 * the picture, and `command` and `asked`, for `run` and `identity`, are used;
 * NULL: zeros. Fails with MURK_BAD_VALUE if an option is wrong, if the picture
 * may not be replaced, or if the scene has too few photons, or sensors or
 * targets that do not fit the world (the picture is drawn all the same if the
 * candidates are refused, as it may show why); with MURK_BAD_FILE if a list of
 * places that the scene names is malformed, with MURK_RUN_FAILED if the picture
 * cannot be written, with MURK_INTERRUPTED if the call is cancelled, and as
 * murk_world_create() if that has not built the world. */
murk_status murk_world_check(murk_world *world,
                             const murk_check_options *options,
                             const murk_save_options *save,
                             const murk_fields **fields, murk_error *error);

/* ---- light ---- */

typedef struct murk_light murk_light;

typedef enum murk_map { MURK_MAP_SURFACE, MURK_MAP_VOLUME } murk_map;

/* Traces the light of a world: the photon maps that photons.maps asks for, the
 * energy ledger and the tallies. Fails with MURK_BAD_VALUE if photons.emit is
 * less than the number of pairs of a light source and a band with power, if a
 * few photons of a band that are traced beforehand are all lost, or if a
 * forecast says that the records would be more than photons.max_stored or than
 * the memory of the machine and the disk of a scratch file hold; with
 * MURK_RUN_FAILED if more than
 * photons.max_stored records are stored all the same, if more than 1 % of the
 * photons are lost or if photons.store records would need too many photons;
 * with MURK_INTERRUPTED if the call is cancelled; and as murk_world_create() if
 * the world is built here. */
murk_status murk_light_trace(murk_light **out, murk_world *world,
                             murk_error *error);

/* The same light, for long traces: every `every_s` seconds (0: never) all that
 * was traced so far is written to the file `path`, the checkpoint, and the call
 * goes on from there if an earlier call for the same world left one. The light
 * is that of murk_light_trace() in every bit. A checkpoint of another world,
 * and one that is damaged, is not used, with a warning; a checkpoint that
 * cannot be written is a warning, too. The caller removes the file when the
 * light is saved. Fails as murk_light_trace(). */
murk_status murk_light_trace_resume(murk_light **out, murk_world *world,
                                    const char *path, double every_s,
                                    murk_error *error);

/* Traces a part of the light of a world, for machines without a common memory,
 * and writes the part to a file: of `count` parts, numbered from 1 to 100000 at
 * most, part `number` has every count-th batch of photons. The parts of a world
 * together are its light in every bit (murk_light_merge()). Fails as
 * murk_light_trace(), but finds only while it traces that records are too many
 * or memory is short, and accepts lost photons, which murk_light_merge()
 * refuses; also with MURK_BAD_VALUE if there is no such part. */
murk_status murk_light_trace_part(murk_world *world, uint32_t number,
                                  uint32_t count, const char *path,
                                  murk_error *error);

/* The light of a world from n files of parts, in any order; a part may be there
 * several times. Photons of missing parts are traced, with a warning. Fails as
 * murk_light_trace(), with MURK_BAD_FILE for a file that is no part of a light
 * or is damaged, and with MURK_BAD_VALUE for a part of another scene, number of
 * parts or version of murk, and for parts of one number that differ. */
murk_status murk_light_merge(murk_light **out, murk_world *world,
                             const char *const *path, size_t n,
                             murk_error *error);

/* A batch of photons whose records are handed over while light is traced. The
 * handle and all views of it are valid until the function that receives it
 * returns. */
typedef struct murk_batch murk_batch;

/* Receives a batch. Returns 0 to go on; any other number cancels the trace.
 * Called in the order of photons, in the thread that called
 * murk_light_stream(), for one batch at a time. The function may call the
 * functions murk_batch_...() and murk_context_cancel(), and no other function
 * with handles of the context. */
typedef int (*murk_batch_function)(void *user, murk_batch *batch);

/* Traces as murk_light_trace(), and calls each(user, batch) for each batch of
 * photons. The records of all batches together are those of the light, which
 * sorts them into another order.
 *
 * With photons.emit the field power_w is in watts. With photons.store the
 * number of photons is known at the end alone: power_w of a batch is then the
 * share of a photon packet, and murk_light_packet_w() gives at the end the
 * power [W] to multiply the share by. Photons behind the one that completes
 * photons.store are no part of any batch. Fails as murk_light_trace(), and with
 * MURK_INTERRUPTED if `each` cancels. */
murk_status murk_light_stream(murk_light **out, murk_world *world,
                              murk_batch_function each, void *user,
                              murk_error *error);

/* The number of a batch, from 0, and the numbers of its photons: photons[0] is
 * the first, photons[1] the last. */
uint64_t murk_batch_number(const murk_batch *batch);
void murk_batch_photons(const murk_batch *batch, uint64_t photons[2]);

/* The number of records of a batch in a map, and a field of these records in
 * the order of photons. murk_light_array() lists the fields. Fails with
 * MURK_BAD_VALUE for another name. */
size_t murk_batch_count(const murk_batch *batch, murk_map map);
murk_status murk_batch_array(murk_batch *batch, murk_map map, const char *field,
                             murk_array *view, murk_error *error);

/* The power [W] of a photon packet of a light source of the scene in a band,
 * both numbered from 0. The power is 0 if the source emitted no photon in the
 * band, and NaN if there is no such source or band. */
double murk_light_packet_w(const murk_light *light, int source, int band);

/* Reads and writes a file of light, light.murk. Writing does not replace a file
 * that the context has read. Reading fails with MURK_BAD_FILE if there is no
 * light in it, MURK_BAD_VALUE if the seed or a key that light depends on is not
 * that of the world, MURK_INTERRUPTED, and as murk_world_create() if the world
 * is built here. Writing fails with MURK_BAD_VALUE or MURK_RUN_FAILED. */
murk_status murk_light_read(murk_light **out, murk_world *world,
                            const char *path, murk_error *error);
murk_status murk_light_write(const murk_light *light, const char *path,
                             murk_error *error);
void murk_light_destroy(murk_light *light);

/* The number of records of a map; 0 for a map that is not stored. */
size_t murk_light_count(const murk_light *light, murk_map map);

/* A field of the records of a map, in the order of the map:
 *
 *   position_m   n x 3 float32  float64, a copy, if the scene is far from 0
 *   power_w      n     float32
 *   emitted      n     uint32   number of the photon
 *   band, light  n     uint8    number of the band, of the light source
 *   material     n     uint8    number of the material or of the medium
 *   direction    n x 3 float32  of travel, unit; a copy
 *   normal       n x 3 float32  faces the photon, unit; 0 in the volume map; a
 *                               copy
 *   event_class  n     uint8    0: the first event of the photon; 1: mirrors
 *                               and transmission alone came before; 2: any
 *                               other event; a copy
 *
 * A photon may have many records, each of another event, so the power of the
 * records of a map may add up to more than that of the light sources. Copies
 * are made once and belong to the light. Fails with MURK_BAD_VALUE for another
 * name. */
murk_status murk_light_array(murk_light *light, murk_map map, const char *field,
                             murk_array *view, murk_error *error);

/* The values of a tally and their standard errors, float64: planes band x bin_i
 * x bin_j x angle bin x direction [W], grids band x i x j x k and spheres band
 * x direction [W/m2]; made once, owned by the light. Either view may be NULL.
 * Fails with MURK_BAD_VALUE if the scene has no tally of that name, or if the
 * light was read from a file, which has no tallies. */
murk_status murk_light_tally(murk_light *light, const char *name,
                             murk_array *values, murk_array *errors,
                             murk_error *error);

/* *fields: those of ledger.json, which murk-results(5) lists. Powers are in
 * watts: `emitted_w.total`, `escaped_w.total`, or of a material
 * `absorbed_by_material_w.wall.total`. The ledger balances exactly: the emitted
 * power is the sum of the absorbed, escaped and lost power, counted in whole
 * quanta (`imbalance_quanta` is 0). Each part of the sum is random, however,
 * and has no standard error in the ledger; murk_light_tally() gives standard
 * errors. Fails with MURK_NO_MEMORY. */
murk_status murk_light_fields(murk_light *light, const murk_fields **fields,
                              murk_error *error);

/* Writes the files of murk trace to a folder: light.murk, ledger.json,
 * scene.resolved.yaml, and tallies.csv and grids, if the light has tallies. The
 * arguments are described at murk_save_options. Fails with MURK_BAD_VALUE,
 * MURK_RUN_FAILED or MURK_INTERRUPTED, as described there. */
murk_status murk_light_save(murk_light *light, const char *folder,
                            const murk_save_options *options,
                            const murk_fields **fields, murk_error *error);

/* ---- sensors ---- */

typedef struct murk_sensors murk_sensors;

typedef struct murk_sensor {
    size_t size;
    const char *type; /* the name of a sensor type of the scene */
    double position_m[3];
    double heading_deg; /* clockwise from north; NaN for a sphere */
    double tilt_deg;    /* upward from the horizon; NaN for a sphere */
} murk_sensor;

/* Makes a list of sensors for a world: an empty list, or that of a file,
 * sensors.csv or plan.json. Reading fails with MURK_BAD_FILE if the file is
 * missing or malformed, or lists no sensor although there is something to see;
 * with MURK_BAD_VALUE if the scene has no sensors, or if a sensor does not fit
 * the scene, as murk_sensors_add(), or has a heading beyond +-360 degrees; and
 * as murk_world_create() if the world is built here. */
murk_status murk_sensors_create(murk_sensors **out, murk_world *world,
                                murk_error *error);
murk_status murk_sensors_read(murk_sensors **out, murk_world *world,
                              const char *path, murk_error *error);
void murk_sensors_destroy(murk_sensors *sensors);

/* Adds a sensor; the struct is copied. Fails with MURK_BAD_VALUE if the type is
 * not one of the scene, if a type with a view has no heading or tilt or the
 * tilt is beyond +-90 degrees, or if the position is outside of the domain; and
 * as murk_world_create() if the world is built here. */
murk_status murk_sensors_add(murk_sensors *sensors, const murk_sensor *sensor,
                             murk_error *error);

/* The number of sensors. */
size_t murk_sensors_count(const murk_sensors *sensors);

/* *sensor: sensor i, from 0; the caller has set sensor->size. The string
 * sensor->type belongs to the world of the sensors. Fails with MURK_BAD_VALUE
 * if there is no sensor i. */
murk_status murk_sensors_get(const murk_sensors *sensors, size_t i,
                             murk_sensor *sensor, murk_error *error);

/* ---- coverage ---- */

typedef struct murk_coverage murk_coverage;

/* Measures what sensors see of a light, as murk sense. The sensors are copied.
 * Fails with MURK_BAD_VALUE if there are no sensors although there is something
 * to see, or if the sensors are of another world than the light, with
 * MURK_BAD_FILE if the table of the targets is missing or malformed, with
 * MURK_RUN_FAILED if no photon or target has weight or a region of interest
 * holds none, and with MURK_INTERRUPTED if the call is cancelled. */
murk_status murk_coverage_measure(murk_coverage **out, murk_light *light,
                                  const murk_sensors *sensors,
                                  murk_error *error);
void murk_coverage_destroy(murk_coverage *coverage);

/* *fields: those of coverage.json. Fails with MURK_NO_MEMORY. */
murk_status murk_coverage_fields(murk_coverage *coverage,
                                 const murk_fields **fields, murk_error *error);

/* Writes the files of murk sense to a folder: coverage.json, coverage.csv,
 * coverage.ply (if there is something to see), scene.resolved.yaml and those of
 * the light. The arguments are described at murk_save_options. Fails with
 * MURK_BAD_VALUE, MURK_RUN_FAILED or MURK_INTERRUPTED, as described there. */
murk_status murk_coverage_save(murk_coverage *coverage, const char *folder,
                               const murk_save_options *options,
                               const murk_fields **fields, murk_error *error);

/* The coverage matrix: sensors x records, uint16: 65535 times the clarity with
 * which the sensor sees the record, 0 if the sensor does not see the record.
 * The clarity is the transmittance of the sightline; with a threshold it is 1
 * or 0, and with detection by power it is the probability of detection. Records
 * of the surface map come first, then those of the volume map, each in the
 * order of murk_light_array(); with targets in place of photons, the targets.
 * Made once, owned by the coverage. Fails with MURK_NO_MEMORY. */
murk_status murk_coverage_matrix(murk_coverage *coverage, murk_array *view,
                                 murk_error *error);

/* ---- plan ---- */

typedef struct murk_plan murk_plan;

/* Chooses the sensors, as murk place. The light of the world is traced, or,
 * with conditions to place over, the light of each condition. Fails as
 * murk_light_trace(), with MURK_BAD_FILE if a table of candidates or targets is
 * missing or malformed, and with MURK_BAD_VALUE or MURK_RUN_FAILED if no plan
 * meets the keys of `sensors` and `placement`. */
murk_status murk_plan_make(murk_plan **out, murk_world *world,
                           murk_error *error);
/* Chooses the sensors for light that is traced already. Fails as
 * murk_plan_make(), and with MURK_BAD_VALUE if the scene has conditions to
 * place over, each of which has a light of its own. */
murk_status murk_plan_for_light(murk_plan **out, murk_light *light,
                                murk_error *error);
/* Chooses columns of a coverage matrix in a file, as murk place --matrix: CSV
 * or OR-Library text, murk-matrix(5). scene: one of murk_scene_create(), whose
 * keys say how many and how: `seed`, one of sensors.count, sensors.target and
 * sensors.budget, and of `placement` `method`, `detection`, `redundancy`,
 * `restarts` and `nodes`. folder and options: those of murk_plan_save(), which
 * are judged before the search, or NULL. The plan has fields and is saved, as
 * plan.json and the exports matrix, or-library and lp; it has no sensors and is
 * not repeated. Fails with MURK_BAD_VALUE if the scene has other keys or not
 * one goal, if no choice of columns reaches the goal, or if murk_plan_save()
 * would refuse; with MURK_RUN_FAILED if the search finds no choice that reaches
 * the goal, if the matrix exceeds the memory, or if the folder cannot be
 * written to; with MURK_BAD_FILE if the file is missing or malformed; and with
 * MURK_INTERRUPTED if the call is cancelled. */
murk_status murk_plan_for_matrix(murk_plan **out, murk_scene *scene,
                                 const char *path, const char *folder,
                                 const murk_save_options *options,
                                 murk_error *error);
void murk_plan_destroy(murk_plan *plan);

/* *fields: those of plan.json. Fails with MURK_NO_MEMORY. */
murk_status murk_plan_fields(murk_plan *plan, const murk_fields **fields,
                             murk_error *error);

/* Makes a list of the chosen sensors, in the order of the plan. Fails with
 * MURK_BAD_VALUE for a plan for a matrix, and with MURK_NO_MEMORY. */
murk_status murk_plan_sensors(murk_sensors **out, const murk_plan *plan,
                              murk_error *error);

/* Makes `runs` - 1 further plans with the seeds that follow that of the scene,
 * each with light of its own, and compares them with the plan: how much the
 * result depends on chance. The fields `repeat` of plan.json and the file
 * repeat.csv have the results. Fields of the plan that were asked for before
 * are valid no longer. If the call fails or is cancelled, the plan keeps the
 * runs that were finished. A plan in the dark does not depend on chance: then
 * the call logs a note and makes no further plan. Fails with MURK_BAD_VALUE if
 * runs is 0, for a plan for a matrix, and as murk_world_check_save() does; with
 * MURK_INTERRUPTED if the call is cancelled; and as murk_plan_make() if a
 * further plan cannot be made, with MURK_RUN_FAILED for example. */
murk_status murk_plan_repeat(murk_plan *plan, uint64_t runs, murk_error *error);

/* Makes a part of the further plans of murk_plan_repeat(), for machines without
 * a common memory, and writes the part to a file: of `count` parts, numbered
 * from 1 to 100000 at most, part `number` has every count-th seed. The plan
 * itself does not change. Each machine makes the plan first, from the same
 * scene. If the call fails or is cancelled, nothing is written. Fails as
 * murk_plan_repeat(), and with MURK_BAD_VALUE if there is no such part. */
murk_status murk_plan_repeat_part(murk_plan *plan, uint64_t runs,
                                  uint32_t number, uint32_t count,
                                  const char *path, murk_error *error);

/* As murk_plan_repeat(), to the same results in every bit, with the further
 * plans of n files of parts, in any order; a part may be there several times.
 * Plans of missing parts are made, with a warning. Fails as murk_plan_repeat();
 * and, before a further plan is made and with a plan that is not repeated, with
 * MURK_BAD_FILE for a file that is no such part or is damaged, and with
 * MURK_BAD_VALUE for a part of another scene, plan, number of runs, number of
 * parts or version of murk, and for parts of one number that differ. */
murk_status murk_plan_repeat_merge(murk_plan *plan, uint64_t runs,
                                   const char *const *path, size_t n,
                                   murk_error *error);

/* Writes the files of murk place to a folder: plan.json, sensors.csv,
 * coverage.csv, scene.resolved.yaml, plan.ply (not in the dark), after
 * exploring explore.csv and path.ply, after repeats repeat.csv, and the files
 * of the light; over conditions regret.csv and the files of each condition
 * instead of plan.ply and the files of the light; for a matrix only plan.json
 * and the exports. The arguments are described at murk_save_options. Fails with
 * MURK_BAD_VALUE, MURK_RUN_FAILED or MURK_INTERRUPTED, as described there. */
murk_status murk_plan_save(murk_plan *plan, const char *folder,
                           const murk_save_options *options,
                           const murk_fields **fields, murk_error *error);

/* ---- update ---- */

/* A world that changes step by step, such as one in which an object moves: each
 * light, coverage and plan is made from that of the step before. */

/* The world with an item of the geometry in another place: that of the scene
 * with the keys geometry.ITEM.translate_m and, unless NULL, rotate_deg, each of
 * three numbers [m], [degrees]. item: its name, or its number from 0. `world`
 * stays as it is. Fails as murk_world_create(), and with MURK_BAD_VALUE if
 * there is no such item or a track of the timeline moves it. */
murk_status murk_world_move(murk_world **out, murk_world *world,
                            const char *item, const double translate_m[3],
                            const double *rotate_deg, murk_error *error);

/* The light of a world from that of another world of the same scene, such as
 * one of murk_world_move() or of another time: equal to that of
 * murk_light_trace() in every bit. Photons whose path no change touches are not
 * traced again. The first update of a light traces all photons and notes where
 * they pass, 64 cells in a box around the change; later ones trace those that
 * start otherwise or pass a changed cell; `run.reused` of ledger.json counts
 * the others. All are traced with photons.store, with flight: delta in a
 * medium, with outside: continued, and after changes that fill the domain.
 * `light` stays as it is. Fails as
 * murk_light_trace(), and with MURK_BAD_VALUE if both are of different
 * contexts. */
murk_status murk_light_update(murk_light **out, murk_light *light,
                              murk_world *world, murk_error *error);

/* What the sensors of a coverage see of another light, such as an updated one.
 * Fails as murk_coverage_measure(), and with MURK_BAD_VALUE if the scene of the
 * light lacks the type of a sensor, or its place is outside of the domain, or
 * if both scenes have other local origins. */
murk_status murk_coverage_update(murk_coverage **out, murk_coverage *coverage,
                                 murk_light *light, murk_error *error);

/* The plan for another light, such as an updated one, from a plan of the same
 * scene: that of murk_plan_for_light() with the key placement.start_plan and
 * the sensors of `plan`, in every bit. From the second update of a sequence on,
 * the clarity of sightlines that no change touches is taken over from the plan
 * before, within placement.memory_mb, and cannot be taken over again. Fails as
 * murk_plan_for_light(), and with MURK_BAD_VALUE if `plan` is for a matrix or
 * over conditions, or of another context or local origin than the light, or if
 * the scene of the light lacks the type of one of its sensors, or its place is
 * outside of the domain. */
murk_status murk_plan_update(murk_plan **out, murk_plan *plan,
                             murk_light *light, murk_error *error);

/* ---- follow ---- */

typedef struct murk_follow murk_follow;

/* Follows a scene through the steps of its timeline. Each step is the scene at
 * its time, as with the key timeline.at_s, and its plan begins at that of the
 * step before, as with the key placement.start_plan, unless the method is
 * greedy or timeline.search_from is start_plan; so a step equals a plan of the
 * scene with these keys in every bit. folder: where murk_follow_next() saves
 * the plan of each step, in steps/NNNN, and from which it takes the steps that
 * an earlier run of the same scene has finished; NULL: nothing is saved.
 * options: described at murk_save_options;
 * exports may also name `light`, without which the steps have no light.murk.
 * Folder, options and scene are copied. Fails with MURK_BAD_VALUE if the scene
 * has no timeline, if it has placement.over, or if murk_follow_save() would
 * refuse the folder. */
murk_status murk_follow_create(murk_follow **out, murk_scene *scene,
                               const char *folder,
                               const murk_save_options *options,
                               murk_error *error);
void murk_follow_destroy(murk_follow *follow);

/* Makes the next step. *row: the fields of its line in follow.csv, until the
 * next call; NULL once all steps are made. A step whose scene is wrong at that
 * time has no plan, and its field `failed` says why; the next step then begins
 * at the last plan that was made. Fails with MURK_INTERRUPTED if the call is
 * cancelled or asked to finish, with MURK_RUN_FAILED if the step cannot be
 * saved, and with MURK_NO_MEMORY; the same step can be tried again. */
murk_status murk_follow_next(murk_follow *follow, const murk_fields **row,
                             murk_error *error);

/* Before the first step: divides the steps, of which murk_follow_next() then
 * makes those of part number of count, which are neighbours, and
 * murk_follow_save() writes the file follow.part alone. The folder of the part
 * is put together with those of other parts by murk_follow_merge(). Fails with
 * MURK_BAD_VALUE if there is no such part or no folder, or if steps depend on
 * each other: timeline.search_from must be start_plan, or placement.method
 * greedy. */
murk_status murk_follow_shard(murk_follow *follow, uint32_t number,
                              uint32_t count, murk_error *error);

/* Before the first step: takes the folders part[parts] of parts, of which
 * murk_follow_next() copies the steps into the folder, and makes those that are
 * in none, so that the results are those of a single run, but for the facts of
 * the run: `run`, times, and what was taken over from the step before. A part
 * may be given several times. Missing parts, and steps whose files are damaged,
 * are named in warnings. Fails with MURK_BAD_FILE if a folder has no part, and
 * with MURK_BAD_VALUE, naming the first difference, if a part is of another
 * scene, other files, other options, another version or number of parts, or if
 * two parts have different results of a step. */
murk_status murk_follow_merge(murk_follow *follow, const char *const *part,
                              size_t parts, murk_error *error);

/* *fields: those of follow.json. Fails with MURK_NO_MEMORY. */
murk_status murk_follow_fields(murk_follow *follow, const murk_fields **fields,
                               murk_error *error);

/* Writes follow.json, follow.csv, a row a step, moves.csv, a row a change of a
 * sensor, scene.resolved.yaml, and with exports that viewers show follow.pvd,
 * for the steps made so far, into the folder; for a part of the steps
 * follow.part alone, and *fields is NULL. Fails with MURK_BAD_VALUE,
 * MURK_RUN_FAILED or MURK_INTERRUPTED, as described at murk_save_options. */
murk_status murk_follow_save(murk_follow *follow, const murk_fields **fields,
                             murk_error *error);

/* ---- study ---- */

typedef struct murk_study murk_study;

/* How the rows of a study are run. All members but size may be zeros. */
typedef struct murk_study_options {
    size_t size;            /* sizeof(murk_study_options) */
    const char *folder;     /* keeps the finished rows, which a later study with
                             * this folder does not run again, and the grids of
                             * rows; NULL: nothing is kept */
    bool replaces;          /* rows may replace grids in the folder that murk
                             * did not write */
    size_t n;               /* keys that are set in the scene of each row: */
    const char *const *key; /* [n] paths of keys; paths and values are as
                             * murk_scene_set() takes them */
    const char *const *value; /* [n] */
    uint32_t shard_number;    /* 1..shard_count: which part of the rows is run;
                               * the part lies in the folder then, and is not
                               * saved */
    uint32_t shard_count; /* parts of the study, up to 100000; 0: all rows are
                           * run */
    size_t parts;         /* folders with parts of the study, of which rows are
                           * taken over: */
    const char *const *part; /* [parts] */
} murk_study_options;

/* Reads a study file and the scenes of its rows; options NULL: zeros. Fails
 * with MURK_BAD_VALUE or MURK_BAD_FILE if the study is wrong or if the scenes
 * of all rows are, and with MURK_INTERRUPTED if the call is cancelled. With
 * parts, also fails if a part is of another study, version or number of parts,
 * with the first difference; missing parts are named in a warning. */
murk_status murk_study_read(murk_study **out, murk_context *context,
                            const char *path, const murk_study_options *options,
                            murk_error *error);

/* Finds out before any row is run if murk_study_save() would refuse the folder
 * or the options. Fails as murk_study_save() would. */
murk_status murk_study_check_save(murk_study *study, const char *folder,
                                  const murk_save_options *options,
                                  murk_error *error);

/* Runs the rows that are not done, as murk study. Of a shard, runs the rows of
 * each shard_count-th group of rows that share light, from group shard_number
 * on, and then writes the part. The results of a study with all its parts are
 * those of a single run, in every bit. A row that fails is no failure of the
 * study: its field `failed` has the reason. A cancelled study keeps the rows
 * that are done, and may be run again. Fields that were asked for before are
 * valid no longer. `imports` in the options of the context chooses the process
 * that runs a group of rows. The study file and the scene must stay as they
 * were read; rows of a scene that has changed fail. Fails with
 * MURK_INTERRUPTED, or with MURK_RUN_FAILED if a finished row or the part
 * cannot be kept or if there is no program murk-rows where it is asked for. */
murk_status murk_study_run(murk_study *study, murk_error *error);
void murk_study_destroy(murk_study *study);

/* *fields: those of study.json. Fails with MURK_NO_MEMORY. */
murk_status murk_study_fields(murk_study *study, const murk_fields **fields,
                              murk_error *error);

/* Writes the files of murk study to a folder: study.json and table.csv, of the
 * rows that are done, and scene.resolved.yaml, if the base scene is valid by
 * itself. The arguments are described at murk_save_options. Fails with
 * MURK_BAD_VALUE, MURK_RUN_FAILED or MURK_INTERRUPTED, as described there, and
 * with MURK_BAD_VALUE for a shard. */
murk_status murk_study_save(murk_study *study, const char *folder,
                            const murk_save_options *options,
                            const murk_fields **fields, murk_error *error);

/* ---- fit ---- */

typedef struct murk_fit murk_fit;

/* How a fit searches. All members but size may be zeros. */
typedef struct murk_fit_options {
    size_t size;               /* sizeof(murk_fit_options) */
    size_t n_bounds;           /* limits of free keys: */
    const char *const *bounds; /* [n_bounds] "KEY=LOW:HIGH"; LOW or HIGH may be
                                * empty */
    const char *loss;    /* "none", "huber" or "cauchy", the last two also with
                          * a width in standard errors: "huber:1.345"; NULL:
                          * none */
    uint64_t starts;     /* number of searches from different values; 0: 4 */
    uint64_t traces;     /* largest number of times that light is traced for one
                          * start; 0: 12 */
    uint64_t next;       /* number of places to propose for further readings */
    const char *predict; /* path of the fit.json of a finished fit: nothing is
                          * fitted, and the readings are predicted at the values
                          * there; NULL: no such fit */
} murk_fit_options;

/* Reads the readings of the CSV file `data`, or of the file that the mapping
 * file `data` (.yaml) names, and prepares to fit keys[n] of a
 * scene to these readings: keys such as "media.fog.visibility_m",
 * "media.fog.albedo@each" (a value for each condition) or "gain.NAME" (a factor
 * of readings). With n = 0 (keys may be NULL) nothing is fitted, and
 * murk_fit_run() predicts the readings at the values of the scene, where
 * factors of readings are 1. options NULL: zeros; with options->predict, n must
 * be 0, and with n = 0 options->next must be 0. Fails with MURK_BAD_VALUE or
 * MURK_BAD_FILE if scene, readings, keys or options are wrong, and as
 * murk_world_create(). */
murk_status murk_fit_create(murk_fit **out, murk_scene *scene, const char *data,
                            const char *const *keys, size_t n,
                            const murk_fit_options *options, murk_error *error);

/* Finds out before any light is traced if murk_fit_save() would refuse the
 * folder or the options. Fails as murk_fit_save() would. */
murk_status murk_fit_check_save(murk_fit *fit, const char *folder,
                                const murk_save_options *options,
                                murk_error *error);

/* Finds the values of the keys, as murk fit. Fails with MURK_BAD_VALUE if the
 * fit has run already, if the scene has too few photons for a fit, or if the
 * fit would take more memory than is free, with MURK_UNSUPPORTED if the scene
 * has `outside: continued` and readings need light, with MURK_RUN_FAILED if the
 * search cannot begin, with MURK_BAD_FILE if options->next asks for places and
 * a table of candidates is missing or malformed, and with MURK_INTERRUPTED. */
murk_status murk_fit_run(murk_fit *fit, murk_error *error);
void murk_fit_destroy(murk_fit *fit);

/* Runs a part of the searches of a fit, for machines without a common memory,
 * and writes the part to a file: of `count` parts, numbered from 1 to 100000 at
 * most, each has the first search, on which the others depend, and part
 * `number` every count-th of the others. The parts of a fit together are the
 * fit in every bit (murk_fit_merge()). The fit itself has not run afterwards.
 * Fails as murk_fit_run(), with MURK_BAD_VALUE if there is no such part, if the
 * fit has one search or predicts, and with MURK_RUN_FAILED if the file cannot
 * be written. */
murk_status murk_fit_run_part(murk_fit *fit, uint32_t number, uint32_t count,
                              const char *path, murk_error *error);

/* Finds the values of the keys as murk_fit_run(), with searches from n files of
 * parts, in any order; a part may be there several times. Searches of missing
 * parts are run, with a warning. Fails as murk_fit_run(), with MURK_BAD_FILE
 * for a file that is no part of a fit or is damaged, and with MURK_BAD_VALUE
 * for a part of another scene, of other readings, keys, options, number of
 * parts or version of murk, for searches that differ between parts, and if the
 * fit predicts. */
murk_status murk_fit_merge(murk_fit *fit, const char *const *path, size_t n,
                           murk_error *error);

/* *fields: those of fit.json, or of a prediction of predict.json. Fails
 * with MURK_BAD_VALUE before murk_fit_run() has succeeded. */
murk_status murk_fit_fields(murk_fit *fit, const murk_fields **fields,
                            murk_error *error);

/* Writes the files of murk fit to a folder: fit.json, fit.csv, calibrated.yaml
 * and scene.resolved.yaml, or of a prediction predict.json, fit.csv and
 * scene.resolved.yaml. The arguments are described at murk_save_options. Fails
 * with MURK_BAD_VALUE before murk_fit_run() has succeeded, and with
 * MURK_BAD_VALUE, MURK_RUN_FAILED or MURK_INTERRUPTED, as described there. */
murk_status murk_fit_save(murk_fit *fit, const char *folder,
                          const murk_save_options *options,
                          const murk_fields **fields, murk_error *error);

/* ---- picture ---- */

typedef struct murk_picture murk_picture;

typedef enum murk_method {
    MURK_METHOD_MAPS,     /* direct light by shadow rays; other light by density
                           * estimation, from records of later events of
                           * photons */
    MURK_METHOD_PATHS,    /* path tracing with shadow rays, without maps */
    MURK_METHOD_MAPS_ONLY /* all light by density estimation, from all
                           * records */
} murk_method;

/* What a picture shows. All members but size may be 0 or NULL. */
typedef struct murk_picture_options {
    size_t size;        /* sizeof(murk_picture_options) */
    const char *camera; /* the name of a camera of the scene; NULL: the first,
                         * or with from_sensor no camera */
    murk_method method;
    const murk_sensors *sensors; /* the picture gets the channels of their
                                  * coverage; NULL: none */
    uint64_t from_sensor; /* the picture is the view of this one of `sensors`,
                           * from 1 on: of a type with hfov and vfov that view,
                           * of other types a view all round. Width, height and
                           * samples of 0 then mean the width and samples of the
                           * camera if it is named, else 640 pixels and 16
                           * samples, and a height that makes the pixels square.
                           * 0: of the camera */
    size_t width, height; /* [pixels]; both 0: those of the camera */
    uint64_t samples;     /* of each pixel, up to 65536; 0: of the camera */
} murk_picture_options;

/* Renders the picture of a world from the light, which must be of this world.
 * light NULL: for MURK_METHOD_PATHS alone, which uses no light. options NULL:
 * zeros. Fails with MURK_BAD_VALUE if the scene has no such camera, if the list
 * has no such sensor, if the camera is outside of the domain, if a number is
 * out of range, or if the scene does not store the maps that the method needs,
 * with MURK_NO_MEMORY, and with MURK_INTERRUPTED if the call is cancelled. */
murk_status murk_picture_render(murk_picture **out, murk_world *world,
                                murk_light *light,
                                const murk_picture_options *options,
                                murk_error *error);
void murk_picture_destroy(murk_picture *picture);

/* A channel, height x width float32, rows from the top: "distance_m"; of band b
 * "radiance.b" and "error.b" (its standard error) [W/m2/sr], "surface.b" and
 * "volume.b" (parts of the radiance), "depth.b" (optical depth); "rgb.0" to
 * "rgb.2", "rgb_error.0" to "rgb_error.2"; "position_m.0" to "position_m.2";
 * with sensors "coverage.count", how many of them see the surface of the pixel,
 * and "coverage.clarity", the largest clarity of their views, 0 to 1. Fails
 * with MURK_BAD_VALUE if the picture has no such channel. */
murk_status murk_picture_array(const murk_picture *picture, const char *channel,
                               murk_array *view, murk_error *error);

typedef enum murk_colour_scale {
    MURK_SCALE_AUTO, /* logarithmic for radiances and their errors unless the
                      * range begins at 0 or below; else linear */
    MURK_SCALE_LINEAR,
    MURK_SCALE_LOG
} murk_colour_scale;

/* The PNG files that murk_picture_save() writes beside the OpenEXR image. */
typedef struct murk_image_options {
    size_t size; /* sizeof(murk_image_options) */
    bool png;    /* the picture for the eye, as NAME.png beside NAME.exr */
    bool has_exposure;
    double exposure_stops;    /* of that PNG, -100 to 100: radiance is shown
                               * 2^exposure_stops times as bright; without
                               * has_exposure: by the picture */
    const char *false_colour; /* a channel in false colour with a legend, as
                               * NAME-CHANNEL.png; NULL: none. The names are
                               * those in the OpenEXR file: "radiance.550nm", of
                               * one band "radiance", "Z", "coverage.count" */
    bool has_range;
    double range[2]; /* values that the false colours go from and to; without
                      * has_range: by the picture */
    murk_colour_scale scale; /* of the false colours */
} murk_image_options;

/* Writes the OpenEXR image `path` and the PNG files that png asks for (NULL:
 * none), each of them whole or not at all. path NULL: no file is written.
 * options: `replaces`, `command` and `asked` are used, as described at
 * murk_save_options; NULL: zeros. fields may be NULL; else *fields are those of
 * murk render --format json: `image`, `png` and `false_colour` (the files),
 * `camera`, `projection`, `from_m`, `heading_deg`, `tilt_deg`, `method`,
 * `pixels`, `samples`, `sensors`, `rays`, `lost`, `unsure_errors`, `mean_over`,
 * `mean_radiance` [W/m2/sr], `mean_radiance_standard_error`, `identity`,
 * `files` and `run`, and beside them `saved.summary`, the lines of text that
 * the program prints. *fields are valid until the next save of the picture.
 * Fails with MURK_BAD_VALUE if there is no such channel, if a number is out of
 * range, if the path ends in ".png", or if a file may not be replaced, and with
 * MURK_RUN_FAILED if a file cannot be written. */
murk_status murk_picture_save(murk_picture *picture, const char *path,
                              const murk_image_options *png,
                              const murk_save_options *options,
                              const murk_fields **fields, murk_error *error);

/* Finds out before any light is traced if murk_picture_render() would refuse
 * the options of the picture, or if murk_picture_save() would refuse path,
 * png or options (NULL as described there). Warns if the picture is taken
 * from inside a solid of transmitting material, or from a place from where no
 * open way to any light was found. Fails as these functions. */
murk_status murk_picture_check(murk_world *world,
                               const murk_picture_options *picture,
                               const char *path, const murk_image_options *png,
                               const murk_save_options *options,
                               murk_error *error);

#ifdef __cplusplus
}
#endif

#endif
