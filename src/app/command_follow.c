/* murk follow: makes the steps of a timeline one after the other, prints a row
 * for each as it is done, and writes the tables; or, with --shard, makes a part
 * of the steps alone. */
#include "app/given.h"
#include "app/part.h"
#include "app/show.h"
#include "base/print.h"
#include "base/ranks.h"

#include <math.h>
#include <stdlib.h>

/* A number of a row; NaN for null. */
static double number(const murk_fields *row, const char *name)
{
    double value = NAN;
    (void)murk_fields_double(row, name, &value, NULL);
    return value;
}

static void print_row(const murk_fields *row)
{
    const char *failed = "";
    (void)murk_fields_string(row, "failed", &failed, NULL);
    if (failed && failed[0]) {
        murk_print("%5.0f %10.6g  failed: %s\n", number(row, "step"),
                   number(row, "t_s"), failed);
        return;
    }
    if (isnan(number(row, "coverage"))) {
        murk_print("%5.0f %10.6g  dark: there is nothing to see\n",
                   number(row, "step"), number(row, "t_s"));
        return;
    }
    murk_print("%5.0f %10.6g %9.4f +- %.4f %9.4f %6.0f %9.2f\n",
               number(row, "step"), number(row, "t_s"), number(row, "coverage"),
               number(row, "standard_error"), number(row, "upper"),
               number(row, "moved"), number(row, "seconds"));
}

/* Makes all steps. */
static murk_status make_steps(murk_follow *follow, const murk_options *options,
                              murk_error *err)
{
    const bool shows = murk_shows_summary(options);
    const murk_fields *row = NULL;
    murk_status status = murk_follow_next(follow, &row, err);
    if (shows && !status) {
        murk_print(" step        t_s  coverage             upper  moved   "
                   "seconds\n");
    }
    while (!status && row) {
        if (shows) {
            print_row(row);
        }
        status = murk_follow_next(follow, &row, err);
    }
    return status;
}

/* Fails if steps have no plan. */
static murk_status judge(const murk_options *options, const murk_fields *saved,
                         murk_error *err)
{
    int64_t failed = 0, steps = 0;
    (void)murk_fields_int64(saved, "steps_failed", &failed, NULL);
    (void)murk_fields_int64(saved, "steps_asked", &steps, NULL);
    return failed == 0 ? MURK_OK
                       : murk_fail(err, MURK_RUN_FAILED, options->input,
                                   "%lld of %lld steps failed (column failed)",
                                   (long long)failed, (long long)steps);
}

/* follow.part begins with the mark of light.murk. */
static const murk_part_result follow_part = {"follow.part", "\x8dmurk"};

/* Divides the steps, or takes the parts that are put together. */
static murk_status divide(murk_follow *follow, const murk_options *options,
                          murk_error *err)
{
    char *path = NULL; /* of follow.part, which the library writes */
    if (options->merges) {
        return murk_follow_merge(follow, options->merges->inputs.word,
                                 options->merges->inputs.n, err);
    }
    if (!options->shard.count) {
        return MURK_OK;
    }
    murk_status status = murk_follow_shard(follow, options->shard.number,
                                           options->shard.count, err);
    if (!status) {
        status = murk_part_begin(&path, options, &follow_part, err);
    }
    free(path);
    return status;
}

/* Writes the part, and prints how many steps it has. */
static murk_status end_part(murk_follow *follow, const murk_options *options,
                            murk_error *err)
{
    const murk_fields *fields = NULL;
    int64_t asked = 0, done = 0, failed = 0;
    murk_status status = murk_follow_save(follow, NULL, err);
    if (!status) {
        status = murk_follow_fields(follow, &fields, err);
    }
    if (!status && murk_shows_summary(options)) {
        (void)murk_fields_int64(fields, "steps_asked", &asked, NULL);
        (void)murk_fields_int64(fields, "steps_done", &done, NULL);
        (void)murk_fields_int64(fields, "steps_failed", &failed, NULL);
        murk_print("steps       %lld of %lld, of which %lld failed\n",
                   (long long)done, (long long)asked, (long long)failed);
    }
    return status ? status : murk_part_end(options, err);
}

murk_status murk_command_follow(const murk_options *options, murk_error *err)
{
    murk_scene *scene = NULL;
    murk_follow *follow = NULL;
    murk_given_save save;
    const murk_fields *saved = NULL;
    murk_status status = murk_given_save_begin(&save, options, err);
    if (!status) {
        status = murk_given_scene(&scene, options, err);
    }
    if (!status) {
        status = murk_follow_create(&follow, scene, options->out, &save.options,
                                    err);
    }
    if (!status) {
        status = divide(follow, options, err);
    }
    if (!status) {
        status = make_steps(follow, options, err);
    }
    if (!status && murk_ranks_number() > 0) {
        goto done; /* rank 0 writes */
    }
    if (!status && options->shard.count) {
        status = end_part(follow, options, err);
        goto done;
    }
    /* After a failure the steps that are done stay in the folder, and the
     * tables of an earlier, longer run stay whole. */
    if (!status) {
        status = murk_follow_save(follow, &saved, err);
    }
    murk_show(options, saved);
    if (!status) {
        status = murk_page_of_failed(options, judge(options, saved, err));
    }
done:
    murk_follow_destroy(follow);
    murk_scene_destroy(scene);
    murk_given_save_end(&save);
    return status;
}
