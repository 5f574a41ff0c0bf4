/* What a study's rows are asked for, and what its lights are traced with. */
#ifndef MURK_CASES_OUTPUTS_H
#define MURK_CASES_OUTPUTS_H

#include "scene/study_file.h"

/* Words of `outputs`; other entries are names of the scene's tallies. */
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

/* The word that an entry is; MURK_OUTPUT_TALLY: none. */
murk_output murk_output_of(const char *word);

/* Fails at the study's place where an output is not known, or what it needs is
 * missing. `scene` is that of a row, for names of tallies. Without outputs it
 * is density, coverage_fixed where the study has a plan and coverage_best where
 * the scene says what to place. */
murk_status murk_outputs_choose(murk_outputs *out, const murk_study_file *study,
                                const murk_scene_desc *scene, murk_error *err);

/* Whether sensors are looked from at all. */
bool murk_outputs_need_sensors(const murk_outputs *outputs);

/* Whether a plan for all rows is asked for. */
bool murk_outputs_plan_for_all(const murk_outputs *outputs);

#endif
