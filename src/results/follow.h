/* The results of murk follow: follow.json, with a row for each step in
 * follow.csv and a row for each change of a sensor in moves.csv, and the lines
 * of the summary. */
#ifndef MURK_RESULTS_FOLLOW_H
#define MURK_RESULTS_FOLLOW_H

#include "cases/sequence.h"
#include "results/fields.h"

typedef struct murk_follow_results {
    const murk_scene_desc *scene; /* at the first step */
    const murk_sequence *sequence;
    size_t steps;  /* of the timeline */
    size_t reused; /* steps that were taken from an earlier run */
} murk_follow_results;

void murk_results_list_follow(murk_results_fields *f, const void *of);

/* The columns of follow.csv; `of` points to a murk_sequence. */
void murk_results_list_follow_row(murk_results_fields *f, const void *of,
                                  size_t i);

/* The columns of start.csv, the sensors of the last plan as they are when the
 * search of a step begins; `of` points to a murk_follow_results. */
void murk_results_list_start(murk_results_fields *f, const void *of, size_t i);

/* The columns of moves.csv; `of` points to a murk_follow_results. */
void murk_results_list_move(murk_results_fields *f, const void *of, size_t i);

/* A murk_print_results (base/print.h). */
void murk_print_follow(const void *of);

#endif
