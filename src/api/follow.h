/* The steps of a timeline while they are made (follow.c), and those that an
 * earlier run has left in the folder (follow_resume.c). */
#ifndef MURK_API_FOLLOW_H
#define MURK_API_FOLLOW_H

#include "api/save.h"
#include "api/scene.h"

#include "base/ranks.h"
#include "base/shard.h"
#include "cases/sequence.h"
#include "results/ownership.h"

#define MURK_STEP_NAME  "steps/%04zu" /* the folder of a step, by its number */
#define MURK_STEP_START "start.csv"

struct murk_follow {
    murk_scene *scene; /* a copy of the caller's */
    char *folder;      /* NULL: none */
    murk_save_options save;
    char *command, *asked, *exports, *voxel_m; /* of `save` */
    size_t steps, next, reused; /* of the timeline; number of the next one; not
                                 * made again */
    size_t end;                 /* the first step that this run does not make */
    murk_shard shard; /* of the steps; count 0: they are not divided */
    bool is_part;     /* some of the steps are made, for a merge or rank 0 */
    char **part;      /* [parts] folders of parts that are put together */
    size_t parts;
    size_t *part_of; /* [steps] number, from 1, of the part that has the step;
                      * 0: none has it. NULL: no parts */
    bool has_begun;  /* ranks have been given their work, if any */
    size_t dealt;    /* steps that the ranks of this run have made */
    const murk_ranks *ranks; /* of the context, which rank 0 has left to go on
                              * alone; NULL: it has not */
    murk_sequence sequence;
    murk_sequence_sensor *start; /* [starts] sensors of the scene's own start
                                  * plan, without the fixed ones */
    size_t starts;
    bool has_start;     /* each step begins at `start` */
    bool has_plan;      /* the sequence has the sensors of an earlier step */
    size_t last_reused; /* number from 1 of the last step that was not made
                         * again, if no step was made after it; else 0 */
    murk_plan *before;  /* the last plan that was made; NULL: none. The next one
                         * takes over what is the same */
    murk_session session;
    murk_fields row, fields, saved; /* row: of the last step */
};

/* A step that is made. */
typedef struct murk_follow_step {
    size_t number;
    double t_s;
    murk_world *world;
    murk_sequence_row row;
    char *start;     /* the file at which its search begins; NULL: none */
    bool is_dark;    /* there is nothing to see, so no sensor has a reason to
                      * move */
    murk_pose *pose; /* [poses] sensors of the plan, without the fixed ones */
    size_t poses;
} murk_follow_step;

/* Makes the scene at a time; `start`: the file of the plan at which the search
 * begins, or NULL. */
murk_status murk_follow_scene_at(murk_scene **out, const murk_follow *follow,
                                 double t_s, const char *start,
                                 murk_error *err);

/* Reads the plan at which each step begins, search_from: start_plan, of the
 * scene at the first step. Its sensors are those of the sequence before that
 * step. Does nothing with another key or without a start plan. Fails as
 * murk_placement_read(). */
murk_status murk_follow_read_start(murk_follow *follow,
                                   const murk_scene_desc *desc,
                                   murk_error *err);

/* Begins a handle that makes some of the steps of `follow`: it borrows what the
 * caller of murk_follow_create() gave and has nothing made yet. It ends, before
 * `follow`, with murk_follow_part_end() and not with murk_follow_destroy(). */
void murk_follow_part_begin(murk_follow *out, const murk_follow *follow);
void murk_follow_part_end(murk_follow *part);

/* Remembers the plan of a step for the next one, which takes over what is the
 * same. A dark step leaves the plan before it. */
void murk_follow_remember(murk_follow *follow, murk_plan *plan);

/* The path of a file of a step in a folder of results, or of its folder (name
 * NULL). The caller frees it; NULL when out of memory or without a folder. */
char *murk_follow_file(const char *folder, size_t step, const char *name);
bool murk_follow_has_file(const char *folder, size_t step, const char *name);

/* True if the folder of a step has all files that its plan.json lists, with the
 * checksums there. *owned begins as zeros, is then the list, and is released by
 * murk_owned_release(). */
bool murk_follow_is_whole(murk_owned *owned, const char *folder);

/* murk_follow_file() in the folder of this run. */
char *murk_follow_step_path(const murk_follow *follow, size_t step,
                            const char *name);

/* The JSON in a file that murk has written; NULL if there is none. The caller
 * deletes it. */
cJSON *murk_follow_read_json(const char *folder, size_t step, const char *name);

/* Fills the row from the main JSON of a plan. */
void murk_follow_fill_row(murk_follow_step *step, const cJSON *plan);

/* Copies the sensors of a plan, of which the fixed ones come last, and adds up
 * their costs. */
murk_status murk_follow_fill_sensors(murk_follow_step *step,
                                     const murk_pose *pose, size_t n,
                                     murk_error *err);

/* Takes the sensors from the file of a plan. */
murk_status murk_follow_read_sensors(murk_follow_step *step, const char *path,
                                     murk_error *err);

/* Takes a step from the plan that an earlier run has left in the folder of
 * results. False if there is none, or if it is of another scene, version or
 * start, or was cut short. */
bool murk_follow_take_earlier(const murk_follow *follow, const char *folder,
                              murk_follow_step *step);

/* After steps of an earlier run: makes the plan of the last of them once more,
 * without saving it, so that the next step takes over, and counts, what it
 * would have taken over without the stop. The results of the step do not depend
 * on it, so without such a plan nothing is taken over. Fails if the call is
 * cancelled or memory is short. */
murk_status murk_follow_recall(murk_follow *follow, murk_error *err);

/* ---- parts (follow_parts.c) ---- */

/* True if no step depends on the plan of another one. */
bool murk_follow_is_divisible(const murk_follow *follow);

/* *start: start.csv of a step in the folder of a part, NULL if the step has no
 * start; the caller frees it. Fails with MURK_BAD_VALUE if the step of this run
 * begins at other sensors. */
murk_status murk_follow_part_start(char **start, const murk_follow *follow,
                                   const char *part, size_t step,
                                   murk_error *err);

/* Writes follow.part for a shard whose steps have been made. */
murk_status murk_follow_part_write(const murk_follow *follow, murk_error *err);

/* *is_taken: whether the step was taken from the part that has it, whose files
 * are copied into the folder of this run, if it has one. Fails as
 * murk_results_show(). */
murk_status murk_follow_take_part(bool *is_taken, const murk_follow *follow,
                                  murk_follow_step *step, murk_error *err);

void murk_follow_release_parts(murk_follow *follow);

/* Before the first step: with ranks (base/ranks.h) deals the steps out, or
 * leaves them to rank 0. Other ranks have no steps afterwards. Collective. */
murk_status murk_follow_begin_ranks(murk_follow *follow, murk_error *err);

#endif
