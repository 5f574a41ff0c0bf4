/* A study (parameter sweep): its rows, their groups, and plans for all rows.
 *
 * Rows whose light differs only by the power of their lights are a group, whose
 * light is traced once (lightmap/scaled_light.h). Each group runs in a
 * subprocess (base/isolated.h), so that files are imported before any ray
 * device exists, and so that the memory of the group ends with the subprocess;
 * or in the calling process, if the host says so. A row that fails leaves the
 * other rows alone.
 *
 * A finished row is stored in FOLDER/rows, in a file named by a hash of
 * everything that the row follows from: the resolved scene, the files that it
 * names, the outputs with their units and sizes, the file of a given placement,
 * the version of murk, and the lights of all rows of the group. The same study
 * continues from the stored rows. */
#ifndef MURK_CASES_SWEEP_H
#define MURK_CASES_SWEEP_H

#include "base/shard.h"
#include "cases/outputs.h"
#include "cases/row.h"

typedef struct murk_sweep_row {
    murk_study_row found;
    char key[65];
    size_t group;    /* index into murk_sweep.group; SIZE_MAX: the row failed
                      * before rows were grouped */
    bool is_done;    /* found is filled; also if the row failed */
    bool has_plans;  /* found holds the coverage of the plans for all rows */
    bool is_reused;  /* taken over from an earlier run or a part */
    size_t part;     /* number, from 1, of the part among desc.part that has the
                      * row; 0: none, or the row is in the folder already */
    bool is_chooser; /* takes part in the choice of the plans for all rows */
} murk_sweep_row;

typedef struct murk_sweep_group {
    size_t *row; /* [n] */
    size_t n;
    size_t lights; /* number of different light keys (cases/sweep_keys.h) among
                    * the rows */
    bool was_traced;
} murk_sweep_group;

/* The plans for all rows that have not failed: one for the mean of the
 * coverages of the rows, one for the least of them. */
enum { MURK_SWEEP_MEAN, MURK_SWEEP_WORST, MURK_SWEEP_PLANS };

/* Largest number of rows that take part in the choice of a plan for all rows.
 * Of more rows, this number takes part, evenly spread in the order of the rows,
 * because the light of all of them is held in memory at one time. */
#define MURK_SWEEP_CHOOSERS_MAX 64

typedef struct murk_sweep_plan {
    bool is_wanted, is_reused;
    /* Sensors, in_sample and upper_bound; or failed, if there is no plan; or
     * neither, if no row has anything to see. */
    murk_study_row found;
    char key[65];
    /* Mean over the rows that have a value. The standard error is the mean of
     * the standard errors of these rows, which is an upper bound, because rows
     * share their random numbers. */
    murk_estimate mean;
    murk_estimate worst;
    size_t worst_row; /* number of the row with the worst coverage; the number
                       * of rows, if none has a value */
} murk_sweep_plan;

typedef struct murk_sweep_desc {
    const murk_study_file *study;
    const murk_override *overrides;
    size_t n_overrides;
    const char *folder;  /* NULL: nothing is kept */
    bool force;          /* also replaces grids that murk did not write */
    const char *version; /* version of the program: rows of other versions are
                            made again */
    unsigned threads;
    murk_shard shard;        /* the part of the rows that is run; no plans for
                                all rows are made then */
    const char *const *part; /* [parts] folders of parts, whose rows are taken
                                over (cases/sweep_part.h) */
    size_t parts;
    void (*row_done)(void *context, size_t row); /* may be NULL */
    void *context;
} murk_sweep_desc;

/* What this rank has found and the other ranks have not received yet
 * (cases/sweep_ranks.h). */
typedef struct murk_sweep_found {
    char *text; /* [size] texts, each ended by '\0' */
    size_t size;
    bool is_shared; /* there are other ranks */
    bool is_short_of_memory;
    bool is_received; /* what other ranks have found is being taken over */
} murk_sweep_found;

typedef struct murk_sweep {
    murk_sweep_desc desc;
    murk_outputs outputs;
    murk_sweep_row *row; /* [study->rows] */
    murk_sweep_group *group;
    size_t groups;
    murk_sweep_plan plan[MURK_SWEEP_PLANS];
    size_t chooser[MURK_SWEEP_CHOOSERS_MAX]; /* [choosers] rows, in order */
    size_t choosers;
    bool sees_in_the_dark; /* targets take the place of light */
    bool cannot_keep;      /* the file of a row cannot be written */
    murk_sweep_found found;
    char scene_sha256[65]; /* of the file of the base scene */
    uint32_t seed;         /* of the first row that could be read */
} murk_sweep;

/* True if the row is to be run: its group is one of the shard, or the run is
 * not divided. Shard K of N has the groups K - 1, K - 1 + N, and so on, so that
 * the photons of rows that share light are traced once. Rows that failed before
 * they were grouped are in no shard. */
bool murk_sweep_owns(const murk_sweep *sweep, size_t row);

/* Rows that murk_sweep_owns(). */
size_t murk_sweep_owned(const murk_sweep *sweep);

/* Rows that are done, with those that failed; and rows that failed. */
size_t murk_sweep_done(const murk_sweep *sweep);
size_t murk_sweep_failed(const murk_sweep *sweep);

/* The reason why a plan for all rows that was asked for could not be made; NULL
 * if all were made. */
const char *murk_sweep_why_no_plan(const murk_sweep *sweep);

/* The name of the output that a plan for all rows gives: "coverage_one_mean" or
 * "coverage_one_worst". */
const char *murk_sweep_plan_name(int plan);

/* True if the plan was asked for and made. */
bool murk_sweep_plan_stands(const murk_sweep_plan *plan);

/* True if the row is done and has not failed, but lacks the coverage of the
 * plans for all rows. */
bool murk_sweep_lacks_values(const murk_sweep_row *row);

/* Reads the scenes of all rows, and the stored rows of earlier runs; traces
 * nothing. A row whose scene cannot be read has failed; the study fails if all
 * rows have. The study also fails if the command line sets a key of an axis, if
 * an output is unknown or lacks something it needs, if the file of the given
 * placement cannot be read, if a plan for all rows is asked for and rows differ
 * in sensors or placement, if a grid in the folder may not be replaced, if a
 * part is refused (murk_sweep_parts_read() in cases/sweep_part.h), or with
 * MURK_INTERRUPTED or MURK_NO_MEMORY. *out is the caller's:
 * murk_sweep_destroy(). The desc is copied; the objects that it points to must
 * outlive *out. */
murk_status murk_sweep_create(murk_sweep **out, const murk_sweep_desc *desc,
                              murk_error *err);
void murk_sweep_destroy(murk_sweep *sweep); /* NULL is fine */

/* Copies rows of parts into the folder, runs the rows that are not done, then
 * makes the plans for all rows; a shard runs its rows alone, and then writes
 * the file of the part (cases/sweep_part.h). Fails with MURK_INTERRUPTED or
 * MURK_NO_MEMORY, or if a finished row or the part cannot be stored; a row that
 * fails is no failure of the study. If the host forks (base/host.h), call it
 * while this process has no threads. */
murk_status murk_sweep_run(murk_sweep *sweep, murk_error *err);

#endif
