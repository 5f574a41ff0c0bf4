/* The structs behind the handles of murk.h that several files of src/api use,
 * and the functions that these files share: the frame of a public call,
 * references, fields and arrays. The structs of studies, fits and pictures are
 * in study.c, fit.c and picture.c.
 *
 * A context, scene, world or light counts the references to it: one of the
 * caller, and one of each handle that has a pointer to it.
 * murk_<handle>_destroy() gives back the reference of the caller, and destroys
 * the handle if no other reference is left. A world has no reference to the
 * scene that it was made from, because the world keeps all that it needs. */
#ifndef MURK_API_HANDLES_H
#define MURK_API_HANDLES_H

#include "base/host.h"
#include "base/memory_files.h"
#include "cases/ahead.h"
#include "cases/repeat.h"
#include "plan/measured.h"
#include "results/fields.h"
#include "results/session.h"

struct murk_fields {
    cJSON *root;
    char *json;
    struct { /* the item of a list that was read last, of the items with an
              * index of SHORT_LIST (fields.c) or more; list NULL: none */
        const cJSON *list, *item;
        int index;
    } last;
};

/* The files in memory of a world or fit of the context, as an element of a
 * linked list. The page of a folder shows the arrays of the world or fit whose
 * results were saved there last. */
typedef struct murk_held_arrays murk_held_arrays;
struct murk_held_arrays {
    murk_held_arrays *next;
    const murk_memory_files *files;
    const char *resolved; /* text of the scene, by whose address the scene is
                           * known */
    char *folder;         /* of the last results, without links; NULL: none, or
                           * another world or fit has saved there since */
};

struct murk_context {
    size_t references;
    murk_held_arrays *held;
    murk_host *host;
    unsigned threads;
    murk_context_options options;
    char *reader;          /* a copy of options.reader */
    murk_fields reported;  /* of the last murk_context_write_report() */
    murk_fields preset;    /* of the last murk_context_preset() */
    murk_fields profile;   /* of the last murk_context_profile_grid() */
    murk_fields reference; /* of the last murk_context_reference() */
    murk_fields keys;      /* of the last murk_context_read_keys() */
};

struct murk_scene {
    size_t references;
    murk_context *context;
    char *name;   /* of the text, in messages */
    bool is_file; /* read from the file `name` */
    bool is_step; /* of murk follow, which calls murk_scene_tell() once */
    char *text;
    size_t n;
    murk_override *set; /* [n] keys of murk_scene_set() and
                         * murk_scene_use_light(), in the order given */
    murk_memory_files files;
    char *resolved; /* text of the last murk_scene_resolved() */
    char *value;    /* JSON of the last murk_scene_get() */
};

/* An array of murk that was made when the caller asked for it, as an element of
 * a linked list. */
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
    murk_held_arrays held;
    murk_scene_desc *desc;
    murk_stage *stage;
    /* [laters] the steps after this time that a plan looks ahead to. */
    murk_scene_desc *later_desc[MURK_SCENE_CONDITIONS_MAX];
    murk_stage *later[MURK_SCENE_CONDITIONS_MAX];
    size_t laters;
    double begun_s, load_s; /* begun_s: clock when the reading of the scene
                             * began; load_s: time from begun_s to the end of
                             * reading, or, once the stage is built, to the end
                             * of building */
    murk_fields replayed;   /* of the last murk_world_replay() */
    murk_fields checked;    /* of the last murk_world_check() */
};

struct murk_light {
    size_t references;
    murk_world *world;
    murk_session session; /* borrows scene and stage of the world; owns the
                           * light, session.traced */
    char *path; /* the file that the light was read from; NULL: the light was
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
    char *path; /* the file that the list was read from; NULL: none */
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
    murk_world *world;               /* NULL: a plan for a matrix */
    murk_scene *scene;               /* of a plan for a matrix, else NULL */
    struct murk_matrix_plan *matrix; /* results/matrix.h; of a plan for a
                                      * matrix, else NULL */
    murk_light *light; /* the light that murk_plan_for_light() was given; NULL
                        * for other plans */
    murk_session session; /* borrows scene and stage of the world; owns the
                           * light, session.traced, if `light` is NULL; zeros
                           * for a plan for a matrix */
    murk_plan_result plan;
    murk_ahead ahead;                 /* plan.ahead if the plan looks ahead */
    murk_condition_plans *conditions; /* NULL unless over conditions */
    murk_repeat repeat;               /* runs 0: not repeated */
    murk_fields fields, saved;
};

/* True if plans look ahead to later steps. */
static inline bool murk_world_is_ahead(const murk_world *world)
{
    return world->desc->timeline.given &&
           world->desc->placement.steps_ahead > 1;
}

/* True if the world has the types and the places of the sensors. */
static inline bool murk_world_has_poses(const murk_world *world,
                                        const murk_pose *pose, size_t n)
{
    bool has = true;
    for (size_t i = 0; i < n && has; ++i) {
        has = pose[i].type < world->desc->sensors.types &&
              murk_box_contains(&world->stage->world.domain.box,
                                pose[i].position);
    }
    return has;
}
#define MURK_OTHER_SENSORS \
    "the light is of a scene without the type or the place of a sensor"

/* True if positions count from the same local origin in both worlds. */
static inline bool murk_worlds_share_origin(const murk_world *a,
                                            const murk_world *b)
{
    const murk_vec3 p = a->desc->origin, q = b->desc->origin;
    return p.x == q.x && p.y == q.y && p.z == q.z;
}

#define MURK_OTHER_ORIGIN                                                    \
    "the scenes lie far from 0 and have other local origins: give both the " \
    "same domain"

/* murk_plan_make() for a step of a sequence. A request to finish does not end
 * the search with the best plan so far: the call fails with MURK_INTERRUPTED.
 * The plan takes over what is the same in `earlier`, a plan that was made by
 * this function for the same scene at another time; the rows of `earlier` are
 * used up. NULL: none; then the paths of photons are noted in the cells of
 * `watched` (lightmap/path_cells.h), or, if that is NULL, too, of the domain.
 */
murk_status murk_plan_make_step(murk_plan **out, murk_world *world,
                                murk_plan *earlier, const murk_box *watched,
                                murk_error *error);

/* Adds the files in memory of a scene, if there are any, to the list of a
 * context, until murk_context_forget_arrays(). All stay in place till then. */
void murk_context_hold_arrays(murk_context *context, murk_held_arrays *held,
                              const murk_memory_files *files,
                              const murk_scene_desc *scene);
/* Does nothing if they are not in the list. */
void murk_context_forget_arrays(murk_context *context, murk_held_arrays *held);

/* Notes that results of a scene, or of none (NULL), were saved to a folder. */
void murk_context_note_folder(murk_context *context, const char *folder,
                              const murk_scene_desc *scene);

/* Makes *out a copy of the files in memory whose results are in the folder: the
 * last that were saved there, if the text of their scene is still that of the
 * folder. Empty if there are none, or when out of memory. */
void murk_context_arrays_of(murk_memory_files *out, const murk_context *context,
                            const char *folder);

/* ---- a public call ---- */

/* A public call that runs. Its beginning binds the calling thread to the host
 * of a context. Its end binds the thread to the former host, and, if the call
 * failed, copies the failure to the error of the caller:
 *
 *     murk_call call = murk_call_begin(context, files, error);
 *     return murk_call_end(&call, work(..., &call.failure));
 */
typedef struct murk_call {
    murk_context *context;
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

/* Ends the searches of the call limit_s seconds after the time begun_s of
 * murk_clock_s(), or, if limit_s is 0, does nothing. The caller sets the
 * deadline to INFINITY when the plan is made (base/interrupt.h). Fails with
 * MURK_BAD_VALUE if there are several ranks, because each would end at another
 * point. */
murk_status murk_call_limit_search(double limit_s, double begun_s,
                                   murk_error *failure);

/* Splits the place of a failure, failure->where, into file, line, column and
 * key, and copies the failure to `to`, the error of the caller: the members
 * that the caller's struct has, or all if to->size is 0. Copies nothing if `to`
 * is NULL or has a message already. */
void murk_call_report(murk_error *to, murk_error *failure);

/* Copies a failure as murk_call_report() does, but does not split the place.
 * For failures whose place is neither a file nor a key, such as those at the
 * path of a field. */
void murk_call_pass(murk_error *to, murk_error *failure);

/* Fails with MURK_BAD_VALUE and `text`. For NULL handles and other misuse, when
 * no call has begun: the function needs no context. */
murk_status murk_call_refuse(murk_error *error, const char *text);

/* Checks a struct of a caller, which begins with its size. `type` is the name
 * of the struct and `argument` that of the argument, for the message. Fails
 * with MURK_BAD_VALUE if the size is 0, below min_size, above STRUCT_MAX
 * (call.c), or no multiple of the alignment of size_t. Bytes behind the first
 * `known` bytes are members of a newer header: fails with MURK_UNSUPPORTED
 * unless all of them are 0. known SIZE_MAX: the struct is an output, whose
 * members are not read. */
murk_status murk_struct_check(const void *given, size_t min_size, size_t known,
                              const char *argument, const char *type,
                              murk_error *err);

/* Checks the struct of a caller by murk_struct_check(), and copies the members
 * that it has to *known of `size` bytes; other members of *known stay as they
 * are. given NULL: changes nothing and returns MURK_OK. */
murk_status murk_options_copy(void *known, size_t size, const void *given,
                              const char *argument, const char *type,
                              murk_error *err);

/* Fails with MURK_BAD_VALUE because of the value of an argument. The place of
 * the failure is "argument NAME", which is neither a file nor a key. */
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
 * the world of a scene with conditions to place over (the key placement.over),
 * because the files of all conditions are imported before any world is built.
 */
murk_status murk_world_build(murk_world *world, murk_error *err);

/* murk_world_create(), with the meshes and grids of the world `earlier`, NULL:
 * none, whose files are the same (murk_stage_create_after()). */
murk_status murk_world_create_after(murk_world **out, murk_scene *scene,
                                    const murk_world *earlier,
                                    murk_error *error);
void murk_light_release(murk_light *light);

/* Makes the fields of the object `of` by the table `list` (results/fields.h),
 * unless *fields has fields already. Fails with MURK_NO_MEMORY, and *fields is
 * then empty. */
murk_status murk_fields_make(murk_fields *fields, murk_results_list list,
                             const void *of, murk_error *err);

/* Replaces the fields by those of the object `root`, which *fields takes over;
 * NULL counts as lack of memory. Fails with MURK_NO_MEMORY, and *fields is then
 * empty. */
murk_status murk_fields_take(murk_fields *fields, cJSON *root, murk_error *err);
void murk_fields_release(murk_fields *fields);

/* murk_made_find() returns the data of the array of that name, or NULL if the
 * list has none. murk_made_add() adds an array of zeros, which the list owns,
 * and returns its data, or NULL when out of memory. */
void *murk_made_find(const murk_made *list, const char *name);
void *murk_made_add(murk_made **list, const char *name, size_t bytes,
                    murk_error *err);
void murk_made_release(murk_made *list);

/* Makes *view, a struct of the caller whose member `size` is set, describe a
 * dense array at `data`, in the order of C. For another order, change
 * view->stride afterwards. Fails with MURK_BAD_VALUE if view is NULL, and as
 * murk_struct_check(). */
murk_status murk_array_fill(murk_array *view, const void *data, murk_type type,
                            int dimensions, const size_t *shape, bool is_copy,
                            murk_error *err);
size_t murk_type_bytes(murk_type type);

/* Returns element i of an array as a double. Elements are counted in the order
 * of C: the last index is the fastest. */
double murk_array_number(const murk_array *view, size_t i);
size_t murk_array_count(const murk_array *view);

/* Checks a view that a caller gives as the argument `name`. Fails with
 * MURK_BAD_VALUE if the view is NULL, smaller than murk_array, of another
 * number of dimensions or of an unknown type, or if it has elements and data is
 * NULL; and as murk_struct_check(). */
murk_status murk_array_check(const murk_array *view, int dimensions,
                             const char *name, murk_error *err);

#endif
