/* murk fit: calibrates the scene to measurements, or predicts the measurements,
 * and writes the results; or, with --shard, a part of the searches. */
#include "app/given.h"
#include "app/part.h"
#include "app/show.h"

#include "base/log.h"

#include <stdlib.h>

/* starts.part begins with the mark of light.murk. */
static const murk_part_result starts_part = {"starts.part", "\x8dmurk"};

/* Options that have no meaning for a prediction at the values of the scene. */
static const char *const of_searches[] = {"--loss", "--starts", "--traces",
                                          "--next"};

static murk_status check_options(const murk_options *o, murk_error *err)
{
    /* The readings, and what is to be found. */
    if (!o->fit.data) {
        return murk_fail(err, MURK_BAD_VALUE, "",
                         "fit needs --data FILE, a CSV of what was measured");
    }
    if (o->fit.predict && (o->fit.free.n || murk_option_text(o, "--next"))) {
        return murk_fail(err, MURK_BAD_VALUE, "--predict",
                         "fits nothing, so it goes with neither --free nor "
                         "--next");
    }
    for (size_t i = 0; !o->fit.predict && !o->fit.free.n &&
                       i < sizeof of_searches / sizeof *of_searches;
         ++i) {
        if (murk_option_text(o, of_searches[i])) {
            return murk_fail(err, MURK_BAD_VALUE, of_searches[i],
                             "is of a search, and without --free KEY, the "
                             "scene's keys to be found, nothing is searched");
        }
    }
    /* Searches that can be divided. */
    if (o->shard.count && (o->fit.predict || !o->fit.free.n)) {
        return murk_fail(err, MURK_BAD_VALUE, "--shard",
                         "divides the searches of a fit, and a prediction has "
                         "none");
    }
    if (o->shard.count && murk_option_number(o, "--starts", 0) == 1) {
        return murk_fail(err, MURK_BAD_VALUE, "--shard",
                         "divides the searches of a fit, and --starts 1 is one "
                         "alone");
    }
    return MURK_OK;
}

/* Prepares the fit, and checks all that can be refused before light is
 * traced. */
static murk_status prepare(murk_fit **fit, const murk_options *o,
                           const murk_given_save *save, murk_error *err)
{
    const murk_fit_options options = {
        .size = sizeof options,
        .n_bounds = o->fit.bounds.n,
        .bounds = o->fit.bounds.word,
        .loss = murk_option_text(o, "--loss"),
        .starts = murk_option_number(o, "--starts", 0),
        .traces = murk_option_number(o, "--traces", 0),
        .next = murk_option_number(o, "--next", 0),
        .predict = o->fit.predict};
    murk_scene *scene = NULL;
    murk_status status = murk_given_scene(&scene, o, err);
    if (!status) {
        status = murk_fit_create(fit, scene, o->fit.data, o->fit.free.word,
                                 o->fit.free.n, &options, err);
    }
    if (!status && !o->shard.count) {
        status = murk_fit_check_save(*fit, o->out, &save->options, err);
    }
    murk_scene_destroy(scene);
    return status;
}

/* Runs a part of the searches, and writes the part. */
static murk_status run_part(murk_fit *fit, const murk_options *options,
                            murk_error *err)
{
    char *path = NULL;
    murk_status status = murk_part_begin(&path, options, &starts_part, err);
    if (!status) {
        status = murk_fit_run_part(fit, options->shard.number,
                                   options->shard.count, path, err);
    }
    if (!status) {
        status = murk_part_end(options, err);
    }
    free(path);
    return status;
}

/* Runs the fit, with the searches of parts that are merged. */
static murk_status run(murk_fit *fit, const murk_options *options,
                       murk_error *err)
{
    if (!options->merges) {
        return murk_fit_run(fit, err);
    }
    char **paths = NULL;
    murk_status status =
        murk_part_paths(&paths, options, starts_part.name, err);
    if (!status) {
        status = murk_fit_merge(fit, (const char *const *)paths,
                                options->merges->inputs.n, err);
    }
    murk_part_paths_release(paths, options);
    return status;
}

/* Where no summary is printed, a warning tells that the data refuse the model,
 * with --quiet as well: who uses the values must know. */
static void warn_of_refusal(const murk_options *options,
                            const murk_fields *saved)
{
    bool is_accepted = true;
    const char *verdict = NULL;
    (void)murk_fields_bool(saved, "accepted", &is_accepted, NULL);
    (void)murk_fields_string(saved, "verdict", &verdict, NULL);
    if (!is_accepted && verdict && !murk_shows_summary(options)) {
        murk_message("warning: ", "", verdict);
    }
}

murk_status murk_command_fit(const murk_options *options, murk_error *err)
{
    murk_fit *fit = NULL;
    murk_given_save save = {.exports = NULL};
    const murk_fields *saved = NULL;
    murk_status status = check_options(options, err);
    if (!status) {
        status = murk_given_save_begin(&save, options, err);
    }
    if (!status) {
        status = prepare(&fit, options, &save, err);
    }
    if (!status && options->shard.count) {
        status = run_part(fit, options, err);
        goto done;
    }
    if (!status) {
        status = run(fit, options, err);
    }
    if (!status) {
        status = murk_fit_save(fit, options->out, &save.options, &saved, err);
    }
    /* What is printed follows the files. */
    if (saved) {
        murk_show_results(options, saved);
        warn_of_refusal(options, saved);
        murk_show_run(options, saved);
    }
done:
    murk_fit_destroy(fit);
    murk_given_save_end(&save);
    return status;
}
