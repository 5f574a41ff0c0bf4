/* murk study: runs the rows of a study, writes its table and its JSON, and
 * prints a summary; or, with --shard, runs a part of the rows alone. */
#include "app/given.h"
#include "app/part.h"
#include "app/show.h"
#include "base/print.h"

#include <stdlib.h>
#include <string.h>

/* The keys that the command line sets, as the library takes them. */
typedef struct keys {
    char **key; /* [n] */
    const char **value;
    size_t n;
} keys;

static murk_status split_keys(keys *out, const murk_options *options,
                              murk_error *err)
{
    const size_t n = options->n_overrides;
    out->key = calloc(n + 1, sizeof *out->key);
    out->value = calloc(n + 1, sizeof *out->value);
    bool is_whole = out->key && out->value;
    for (size_t i = 0; is_whole && i < n; ++i) {
        const char *text = options->overrides[i].text;
        const size_t length = strcspn(text, "=");
        out->key[i] = strndup(text, length);
        out->value[i] = text + length + 1;
        is_whole = out->key[i] != NULL;
        out->n += is_whole;
    }
    return is_whole ? MURK_OK : murk_no_memory(err, "", "for the options");
}

static void release_keys(keys *k)
{
    for (size_t i = 0; i < k->n; ++i) {
        free(k->key[i]);
    }
    free(k->key);
    free(k->value);
}

/* study.part begins with this text. */
static const murk_part_result study_part = {"study.part",
                                            "murk part of a study"};

/* Reads the study, and makes sure that the files of a part, or else the
 * results, may be written. */
static murk_status begin(murk_study **study, const murk_options *o,
                         const murk_given_save *save, murk_error *err)
{
    keys set = {.n = 0};
    char *path = NULL; /* of study.part, which the library writes */
    murk_status status = split_keys(&set, o, err);
    murk_study_options options = {.size = sizeof options,
                                  .folder = o->out,
                                  .replaces = o->force,
                                  .n = set.n,
                                  .key = (const char *const *)set.key,
                                  .value = set.value,
                                  .shard_number = o->shard.number,
                                  .shard_count = o->shard.count};
    if (o->merges) { /* rows come from parts */
        options.part = o->merges->inputs.word;
        options.parts = o->merges->inputs.n;
    }
    if (!status) {
        status = murk_study_read(study, o->context, o->input, &options, err);
    }
    if (!status) {
        status = o->shard.count ? murk_part_begin(&path, o, &study_part, err)
                                : murk_study_check_save(*study, o->out,
                                                        &save->options, err);
    }
    free(path);
    release_keys(&set);
    return status;
}

/* Prints how many rows the part has, and writes part.txt. */
static murk_status end_part(murk_study *study, const murk_options *options,
                            murk_error *err)
{
    const murk_fields *fields = NULL;
    int64_t asked = 0, done = 0, reused = 0, failed = 0;
    murk_status status = murk_study_fields(study, &fields, err);
    if (!status && murk_shows_summary(options)) {
        (void)murk_fields_int64(fields, "rows_asked", &asked, NULL);
        (void)murk_fields_int64(fields, "rows_done", &done, NULL);
        (void)murk_fields_int64(fields, "rows_failed", &failed, NULL);
        (void)murk_fields_int64(fields, "run.rows_kept", &reused, NULL);
        murk_print("rows        %lld of %lld, of which %lld kept from before "
                   "and %lld failed\n",
                   (long long)done, (long long)asked, (long long)reused,
                   (long long)failed);
    }
    return status ? status : murk_part_end(options, err);
}

/* True if any rows wrote their grids. */
static bool has_grids(const murk_fields *saved)
{
    const size_t n = murk_fields_length(saved, "files");
    for (size_t i = 0; i < n; ++i) {
        if (strncmp(murk_fields_name(saved, "files", i), "fluence_", 8) == 0) {
            return true;
        }
    }
    return false;
}

/* The lines of the run, which name the folder of rows, too. */
static void show_run(const murk_options *options, const murk_fields *saved)
{
    murk_show_times(saved);
    if (options->out) {
        murk_print("files       %s: study.json table.csv scene.resolved.yaml "
                   "%srows/\n",
                   options->out, has_grids(saved) ? "fluence_*.vdb " : "");
    } else {
        murk_print(
            "files       none: -o DIR writes them, and keeps rows that are "
            "done\n");
    }
}

/* Fails if rows have failed, or a plan for all rows that was asked for. */
static murk_status judge(const murk_options *options, const murk_fields *saved,
                         murk_error *err)
{
    static const char *const plans[] = {"plans.mean.failed",
                                        "plans.worst.failed"};
    int64_t failed = 0, rows = 0;
    (void)murk_fields_int64(saved, "rows_failed", &failed, NULL);
    (void)murk_fields_int64(saved, "rows_asked", &rows, NULL);
    if (failed > 0) {
        return murk_fail(err, MURK_RUN_FAILED, options->input,
                         "%lld of %lld rows failed (column failed)",
                         (long long)failed, (long long)rows);
    }
    for (size_t i = 0; i < sizeof plans / sizeof *plans; ++i) {
        const char *why = NULL;
        (void)murk_fields_string(saved, plans[i], &why, NULL);
        if (why) {
            return murk_fail(err, MURK_RUN_FAILED, options->input,
                             "no plan for all rows: %s", why);
        }
    }
    return MURK_OK;
}

/* Saves the rows that were done before an interrupt. Failures are ignored,
 * because the command fails with the interrupt. */
static void save_interrupted(murk_study *study, const murk_options *options,
                             const murk_given_save *save)
{
    const murk_fields *fields = NULL;
    int64_t done = 0;
    if (!murk_study_fields(study, &fields, NULL)) {
        (void)murk_fields_int64(fields, "rows_done", &done, NULL);
    }
    if (done > 0) {
        (void)murk_study_save(study, options->out, &save->options, NULL, NULL);
    }
}

murk_status murk_command_study(const murk_options *options, murk_error *err)
{
    murk_study *study = NULL;
    murk_given_save save;
    const murk_fields *saved = NULL;
    murk_status status = murk_given_save_begin(&save, options, err);
    if (!status) {
        status = begin(&study, options, &save, err);
    }
    if (!status) {
        status = murk_study_run(study, err);
        if (status == MURK_INTERRUPTED && !options->shard.count) {
            save_interrupted(study, options, &save);
        }
    }
    if (!status && options->shard.count) {
        status = end_part(study, options, err);
        goto done;
    }
    if (!status) {
        status =
            murk_study_save(study, options->out, &save.options, &saved, err);
    }
    /* What is printed follows the files. */
    if (saved) {
        murk_show_results(options, saved);
        if (murk_shows_summary(options)) {
            show_run(options, saved);
        }
    }
    /* An interrupt while the files were written stays the failure. */
    if (!status) {
        status = murk_page_of_failed(options, judge(options, saved, err));
    }
done:
    murk_study_destroy(study);
    murk_given_save_end(&save);
    return status;
}
