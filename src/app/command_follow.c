/* murk follow: makes the steps of a timeline one after the other, prints a row
 * for each as it is done, and writes the tables. */
#include "app/given.h"
#include "app/show.h"
#include "base/print.h"

#include <math.h>

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
        status = make_steps(follow, options, err);
    }
    /* After a failure the steps that are done stay in the folder, and the
     * tables of an earlier, longer run stay whole. */
    if (!status) {
        status = murk_follow_save(follow, &saved, err);
    }
    murk_show(options, saved);
    if (!status) {
        status = judge(options, saved, err);
    }
    murk_follow_destroy(follow);
    murk_scene_destroy(scene);
    murk_given_save_end(&save);
    return status;
}
