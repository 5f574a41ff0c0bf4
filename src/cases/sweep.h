/* A study: its rows as runs, one after the other, of which one that fails
 * leaves the others alone.
 *
 * Rows whose light differs by the power of their lights alone are a group: its
 * light is traced once (lightmap/relight.h). Each group runs in a process of
 * its own (base/isolated.h), so that its files are imported before any ray
 * device exists, and its memory ends with it.
 *
 * What is finished is kept in FOLDER/rows, a file a row, named by a checksum of
 * all that the row follows from: its scene as resolved, the files that this
 * names, outputs, version, and the other lights of its group. The same study
 * goes on from there. */
#ifndef MURK_CASES_SWEEP_H
#define MURK_CASES_SWEEP_H

#include "cases/outputs.h"
#include "cases/row.h"

typedef struct murk_sweep_row {
    murk_study_row found;
    char key[65];
    size_t group;
    bool is_done;   /* found says what there is; also where it failed */
    bool has_plans; /* found has the values of the plans for all rows */
    bool is_kept;   /* of an earlier run */
} murk_sweep_row;

typedef struct murk_sweep_group {
    size_t *row; /* [n] */
    size_t n;
    size_t lights; /* that differ, by power */
    bool was_traced;
} murk_sweep_group;

/* One plan for all rows that have not failed, for the mean of their coverages
 * or for the least. */
enum { MURK_SWEEP_MEAN, MURK_SWEEP_WORST, MURK_SWEEP_PLANS };

/* Lit rows that a plan is chosen for; of more, so many have a say. */
#define MURK_SWEEP_CHOOSERS_MAX 64

typedef struct murk_sweep_plan {
    bool is_wanted, is_kept;
    murk_study_row
        found; /* its sensors, in_sample and upper_bound; failed: why there
            is none; neither: there is nothing to see in any row */
    char key[65];
    murk_estimate mean; /* over the rows that have a value; error: the mean of
                           theirs, which is more, as rows share their random
                           numbers */
    murk_estimate worst;
    size_t worst_row; /* rows: none has a value */
} murk_sweep_plan;

typedef struct murk_sweep_desc {
    const murk_study_file *study;
    const murk_override *overrides;
    size_t n_overrides;
    const char *folder;  /* NULL: nothing is kept */
    bool force;          /* replaces grids of fluence that are not murk's */
    const char *version; /* of the program: other versions' rows are made anew
                          */
    unsigned threads;
    void (*row_done)(void *context, size_t row); /* may be NULL */
    void *context;
} murk_sweep_desc;

typedef struct murk_sweep {
    murk_sweep_desc desc;
    murk_outputs outputs;
    murk_sweep_row *row; /* [study->rows] */
    murk_sweep_group *group;
    size_t groups;
    murk_sweep_plan plan[MURK_SWEEP_PLANS];
    size_t chooser[MURK_SWEEP_CHOOSERS_MAX]; /* [choosers] rows, in order */
    size_t choosers;
    bool sees_in_the_dark; /* targets stand in for light */
    bool cannot_keep;      /* a row's file cannot be written */
    char scene_sha256[65]; /* of the base scene's file */
    uint32_t seed;         /* of the first row that could be read */
} murk_sweep;

size_t murk_sweep_done(const murk_sweep *sweep);   /* failed ones, too */
size_t murk_sweep_failed(const murk_sweep *sweep); /* rows */
/* Why a plan for all rows that was asked for could not be made; NULL: all were.
 */
const char *murk_sweep_why_no_plan(const murk_sweep *sweep);

/* The name of the output that a plan for all rows gives: "coverage_one_mean".
 */
const char *murk_sweep_plan_name(int plan);

/* True if the plan was asked for and made. */
bool murk_sweep_plan_stands(const murk_sweep_plan *plan);

/* True if the row is done, except for the coverage that the plans for all rows
 * have in it. */
bool murk_sweep_lacks_values(const murk_sweep_row *row);

#endif
