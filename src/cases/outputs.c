/* The outputs that a study asks for: reads the words of `outputs`, and refuses
 * outputs that are unknown or that lack something they need. */
#include "cases/outputs.h"

#include "base/words.h"
#include "plan/plan.h"

#include <stdio.h>
#include <string.h>

static const char *const WORDS[] = {
    [MURK_OUTPUT_DENSITY] = "density",
    [MURK_OUTPUT_STORED] = "stored",
    [MURK_OUTPUT_FIXED] = "coverage_fixed",
    [MURK_OUTPUT_BEST] = "coverage_best",
    [MURK_OUTPUT_ONE_MEAN] = "coverage_one_mean",
    [MURK_OUTPUT_ONE_WORST] = "coverage_one_worst",
    [MURK_OUTPUT_FLUENCE] = "fluence_vdb"};
#define N_WORDS (sizeof WORDS / sizeof *WORDS)

murk_output murk_output_of(const char *word)
{
    for (size_t i = 0; i < N_WORDS; ++i) {
        if (strcmp(WORDS[i], word) == 0) {
            return (murk_output)i;
        }
    }
    return MURK_OUTPUT_TALLY;
}

static bool is_tally(const murk_scene_desc *scene, const char *name)
{
    for (size_t i = 0; i < scene->n_tallies; ++i) {
        if (strcmp(scene->tallies[i].name, name) == 0) {
            return true;
        }
    }
    return false;
}

static murk_status unknown(const murk_study_file *study,
                           const murk_scene_desc *scene, const char *word,
                           murk_error *err)
{
    const char *names[MURK_OUTPUTS + 64];
    char shown[MURK_SCENE_NAME_SIZE];
    char allowed[160] = "";
    size_t n = 0, length = 0;
    for (; n < N_WORDS; ++n) {
        names[n] = WORDS[n];
        length += (size_t)snprintf(allowed + length, sizeof allowed - length,
                                   "%s%s", n ? ", " : "", WORDS[n]);
    }
    for (size_t i = 0; i < scene->n_tallies && i < 64; ++i) {
        names[n++] = scene->tallies[i].name;
    }
    murk_words_show(shown, sizeof shown, word);
    return murk_fail(err, MURK_BAD_VALUE, study->outputs_where,
                     "%s is no output%s, must be %s or the name of a tally",
                     shown, murk_words_suggest(word, names, n).text, allowed);
}

static bool places(const murk_scene_desc *scene)
{
    const murk_scene_sensors *s = &scene->sensors;
    return s->given && (s->count > 0 || s->target > 0 || s->budget > 0);
}

static bool measures_coverage(const murk_outputs *outputs)
{
    return outputs->wants[MURK_OUTPUT_FIXED] ||
           outputs->wants[MURK_OUTPUT_BEST] ||
           murk_outputs_plan_for_all(outputs);
}

static murk_status check_needs(const murk_outputs *out,
                               const murk_scene_desc *scene, murk_error *err)
{
    const murk_study_file *study = out->study;
    const char *where = study->outputs > 0 ? study->outputs_where : study->path;
    /* Coverage needs a plan or sensors. */
    if (out->wants[MURK_OUTPUT_FIXED] && !study->plan) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "coverage_fixed needs a plan: FILE, sensors.csv or "
                         "plan.json");
    }
    if (measures_coverage(out) && !scene->sensors.given) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "coverage needs sensors, and the scene %s has none",
                         scene->path);
    }
    /* A best plan needs a number of sensors, a target or a budget. Keys that
     * ask for a plan of one scene alone are refused. */
    if ((out->wants[MURK_OUTPUT_BEST] || murk_outputs_plan_for_all(out)) &&
        !places(scene)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "a best plan needs sensors.count, target or budget, "
                         "and the scene %s has none",
                         scene->path);
    }
    const char *key = murk_plan_single_key(scene);
    if ((out->wants[MURK_OUTPUT_BEST] || murk_outputs_plan_for_all(out)) &&
        key) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "a best plan for placement.%s, which %s has, is "
                         "not supported in a study: run place for each row%s",
                         key, scene->path,
                         murk_plan_at_least(scene) > 0
                             ? ", or use placement.redundancy"
                             : "");
    }
    /* One plan for all rows cannot be explored, and the plan for the worst row
     * needs a known environment. */
    const murk_scene_knowledge knows = scene->placement.knowledge;
    if (murk_outputs_plan_for_all(out) && knows == MURK_SCENE_EXPLORE) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "one plan for all rows cannot be explored: "
                         "placement.knowledge is explore, must be known or "
                         "unknown");
    }
    if (out->wants[MURK_OUTPUT_ONE_WORST] && knows != MURK_SCENE_KNOWN) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "coverage_one_worst needs what every candidate sees, "
                         "so placement.knowledge must be known");
    }
    return MURK_OK;
}

murk_status murk_outputs_choose(murk_outputs *out, const murk_study_file *study,
                                const murk_scene_desc *scene, murk_error *err)
{
    *out = (murk_outputs){.study = study};
    for (size_t i = 0; i < study->outputs; ++i) {
        const murk_output k = murk_output_of(study->output[i]);
        if (k == MURK_OUTPUT_TALLY && !is_tally(scene, study->output[i])) {
            return unknown(study, scene, study->output[i], err);
        }
        out->wants[k] = true;
    }
    if (study->outputs == 0) {
        out->wants[MURK_OUTPUT_DENSITY] = true;
        out->wants[MURK_OUTPUT_FIXED] = study->plan != NULL;
        out->wants[MURK_OUTPUT_BEST] = places(scene);
    }
    return check_needs(out, scene, err);
}

bool murk_outputs_plan_for_all(const murk_outputs *outputs)
{
    return outputs->wants[MURK_OUTPUT_ONE_MEAN] ||
           outputs->wants[MURK_OUTPUT_ONE_WORST];
}
