/* The outputs that a study asks of each of its rows. */
#ifndef MURK_CASES_OUTPUTS_H
#define MURK_CASES_OUTPUTS_H

#include "scene/study_file.h"

/* The words of the key `outputs`; MURK_OUTPUT_TALLY stands for all other
 * entries, which are names of tallies of the scene. */
typedef enum murk_output {
    MURK_OUTPUT_DENSITY,
    MURK_OUTPUT_STORED,
    MURK_OUTPUT_FIXED,
    MURK_OUTPUT_BEST,
    MURK_OUTPUT_ONE_MEAN,
    MURK_OUTPUT_ONE_WORST,
    MURK_OUTPUT_FLUENCE,
    MURK_OUTPUT_TALLY,
    MURK_OUTPUTS
} murk_output;

typedef struct murk_outputs {
    const murk_study_file *study;
    bool wants[MURK_OUTPUTS];
} murk_outputs;

/* The output that a word names; MURK_OUTPUT_TALLY if the word names none of the
 * other outputs. */
murk_output murk_output_of(const char *word);

/* Reads the outputs of a study. `scene` is the scene of one row, which names
 * the tallies. A study without `outputs` gets density, coverage_fixed if the
 * study names the file of a plan, and coverage_best if the scene states a
 * number, a target or a budget of sensors. Fails at the place in the study if
 * an output is unknown or lacks something it needs. */
murk_status murk_outputs_choose(murk_outputs *out, const murk_study_file *study,
                                const murk_scene_desc *scene, murk_error *err);

/* True if one plan for all rows is asked for. */
bool murk_outputs_plan_for_all(const murk_outputs *outputs);

#endif
