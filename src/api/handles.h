/* The structs behind the handles of murk.h, and the frame of a public call.
 *
 * Context, scene, world and light, from which other handles are made, count
 * their references: one of the caller, and one of each handle that was made
 * from them. murk_<handle>_destroy() gives back the reference of the caller. */
#ifndef MURK_API_HANDLES_H
#define MURK_API_HANDLES_H

#include "base/host.h"
#include "base/memory_files.h"
#include "cases/repeat.h"
#include "plan/measured.h"
#include "results/fields.h"
#include "results/session.h"

struct murk_fields {
    cJSON *root;
    char *json;
    struct { /* the item of a long list that was read last; list NULL: none */
        const cJSON *list, *item;
        int index;
    } last;
};

struct murk_context {
    size_t references;
    murk_host *host;
    unsigned threads;
    murk_context_options options;
    char *reader;         /* a copy of options.reader */
    murk_fields reported; /* of the last murk_context_write_report() */
    murk_fields preset;   /* of the last murk_context_preset() */
};

struct murk_scene {
    size_t references;
    murk_context *context;
    char *name;   /* of the text, in messages */
    bool is_file; /* read from the file `name` */
    char *text;
    size_t n; /* keys that murk_scene_set() gave */
    murk_override *set;
    murk_memory_files files;
    char *resolved; /* text of the last murk_scene_resolved() */
    char *value;    /* JSON of the last murk_scene_get() */
};

/* An array that was made on request. */
typedef struct murk_made murk_made;
struct murk_made {
    murk_made *next;
    char name[64];
    void *data;
};

struct murk_world {
    size_t references;
    murk_context *context;
    murk_memory_files files;
    murk_scene_desc *desc;
    murk_stage *stage;
    double begun_s, load_s; /* the clock at the beginning, and the duration */
    murk_fields replayed;   /* of the last murk_world_replay() */
};

struct murk_light {
    size_t references;
    murk_world *world;
    murk_session session; /* borrows scene and stage of the world */
    char *path;           /* the file that the light was read from; NULL: it was
                           * traced */
    murk_made *made;
    murk_fields fields, saved;
};

/* The batch that murk_light_stream() hands to the function of the caller. */
struct murk_batch {
    const murk_record_batch *records;
    const murk_scene_desc *scene;
    murk_made *made;
};

struct murk_sensors {
    murk_world *world;
    size_t n;
    murk_pose *pose; /* [n] */
};

struct murk_coverage {
    murk_light *light;
    size_t n;
    murk_pose *pose; /* [n] */
    murk_measured measured;
    murk_sight *sight; /* NULL: there is nothing to see */
    double sense_s;
    uint16_t *matrix; /* [n][records]; NULL before it is asked for */
    size_t records;
    murk_fields fields, saved;
};

struct murk_plan {
    murk_world *world; /* NULL: a plan for a matrix, which has the two below */
    murk_scene *scene;
    struct murk_matrix_plan *matrix; /* results/matrix.h */
    murk_light *light;               /* NULL: a plan over conditions */
    murk_session session;            /* borrows scene, stage and light */
    murk_plan_result plan;
    murk_condition_plans *conditions; /* NULL: the scene as it stands */
    murk_repeat repeat;               /* runs 0: not repeated */
    murk_fields fields, saved;
};

/* ---- a public call ---- */

/* Binds the calling thread to the host of a context, and fills the error of the
 * caller at the end:
 *
 *     murk_call call = murk_call_begin(context, files, error);
 *     return murk_call_end(&call, work(..., &call.failure));
 */
typedef struct murk_call {
    murk_host *host, *before;
    murk_error failure;
    murk_error *error; /* of the caller; may be NULL */
} murk_call;

/* files: the files in memory that paths of the form "memory:NAME" name during
 * the call. NULL: there are none. */
murk_call murk_call_begin(murk_context *context, const murk_memory_files *files,
                          murk_error *error);

/* Ends a call that does no long work. A request to cancel stays for the next
 * call, unless `status` is MURK_INTERRUPTED. */
murk_status murk_call_end(murk_call *call, murk_status status);

/* Ends a call that murk_context_cancel() may have cancelled. A request to
 * cancel is cleared, and turns any status into MURK_INTERRUPTED. */
murk_status murk_call_end_long(murk_call *call, murk_status status);

/* Splits the place of a failure into file, line, column and key, and copies the
 * failure to `to`, the error of the caller: the members that the caller's
 * struct has. Copies nothing if `to` is NULL or has a message already. */
void murk_call_report(murk_error *to, murk_error *failure);

/* Copies a failure as murk_call_report() does, but does not split the place,
 * which is neither a file nor a key. */
void murk_call_pass(murk_error *to, murk_error *failure);

/* Fails with MURK_BAD_VALUE and `text`. It needs no context, so it serves for
 * NULL handles and other misuse. */
murk_status murk_call_refuse(murk_error *error, const char *text);

/* Checks a struct of a caller, which begins with its size. `type` is the name
 * of the struct and `argument` that of the argument, for the message. The size
 * must be one that the struct may have in some version of the header, and not
 * below min_size. Members behind the first `known` bytes are those of a newer
 * header and must be zeros; known SIZE_MAX: the struct is an output, and these
 * members are not read. */
murk_status murk_struct_check(const void *given, size_t min_size, size_t known,
                              const char *argument, const char *type,
                              murk_error *err);

/* Copies the struct of a caller to *known of `size` bytes, after
 * murk_struct_check(): the members that both have. The others stay as they are.
 * given NULL: changes nothing. */
murk_status murk_options_copy(void *known, size_t size, const void *given,
                              const char *argument, const char *type,
                              murk_error *err);

/* Fails because of a value in an argument. The place is "argument NAME", which
 * is neither a file nor a key. */
murk_status murk_call_bad_argument(murk_error *err, const char *name,
                                   const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Fails as murk_call_bad_argument() if one of text[n] is NULL, or if text is
 * NULL and n is not 0. */
murk_status murk_call_check_texts(murk_error *err, const char *name,
                                  const char *const *text, size_t n);

/* ---- references ---- */

void murk_context_release(murk_context *context);
void murk_scene_release(murk_scene *scene);
void murk_world_release(murk_world *world);

/* Builds a world unless it is built already. murk_world_create() does not build
 * the world of a scene with conditions to place over, because the files of all
 * conditions are imported before any world is built. */
murk_status murk_world_build(murk_world *world, murk_error *err);
void murk_light_release(murk_light *light);

/* Makes the fields of the object `of` by a table of results, unless *fields has
 * fields already. */
murk_status murk_fields_make(murk_fields *fields, murk_results_list list,
                             const void *of, murk_error *err);
void murk_fields_release(murk_fields *fields);

/* The first returns the array of that name, or NULL if the list has none. The
 * second adds an array of zeros, which the list owns, and returns NULL when out
 * of memory. */
void *murk_made_find(const murk_made *list, const char *name);
void *murk_made_add(murk_made **list, const char *name, size_t bytes,
                    murk_error *err);
void murk_made_release(murk_made *list);

/* Fills a view of the caller: a dense array unless strides are changed
 * afterwards. */
murk_status murk_array_fill(murk_array *view, const void *data, murk_type type,
                            int dimensions, const size_t *shape, bool is_copy,
                            murk_error *err);
size_t murk_type_bytes(murk_type type);

/* Reads element i of a flat walk in the order of C as a double. */
double murk_array_number(const murk_array *view, size_t i);
size_t murk_array_count(const murk_array *view);

/* Fails with MURK_BAD_VALUE unless the view has at least the size of
 * murk_array, that many dimensions, a known type, and data if its shape is not
 * empty. */
murk_status murk_array_check(const murk_array *view, int dimensions,
                             const char *name, murk_error *err);

#endif
