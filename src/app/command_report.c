/* murk report, and --report of other commands: one self-contained page of a
 * result folder. */
#include "app/given.h"
#include "app/show.h"
#include "base/log.h"
#include "base/print.h"
#include "base/ranks.h"

static double number_of(const murk_fields *page, const char *name)
{
    double value = 0;
    (void)murk_fields_double(page, name, &value, NULL);
    return value;
}

/* Prints the line about the page that was written. */
static void print_page(const murk_fields *page)
{
    const char *path = "";
    (void)murk_fields_string(page, "report", &path, NULL);
    const double photons = number_of(page, "photons");
    murk_print("%s: %.2f MB", path, number_of(page, "bytes") / 1e6);
    if (photons > 0) {
        murk_print(", %.0f of %.0f photons", number_of(page, "photons_shown"),
                   photons);
    }
    murk_print("\n");
}

/* Writes the page of a folder to `path`, NULL: into the folder. */
static murk_status write_page(const murk_options *options, const char *folder,
                              const char *path, bool prints_json,
                              murk_error *err)
{
    murk_given_save save = {.exports = NULL};
    const murk_fields *page = NULL;
    murk_status status = murk_given_save_begin(&save, options, err);
    if (!status) {
        status = murk_context_write_report(options->context, folder, path,
                                           &save.options, &page, err);
    }
    if (!status && prints_json) {
        murk_print_json(murk_fields_json(page));
    } else if (!status && murk_shows_summary(options)) {
        print_page(page);
    }
    murk_given_save_end(&save);
    return status;
}

murk_status murk_command_report(const murk_options *options, murk_error *err)
{
    return options->n_overrides > 0
               ? murk_fail(err, MURK_BAD_VALUE, "report",
                           "shows results as they are: no --set and no --seed")
               : write_page(options, options->input, options->out,
                            options->json, err);
}

murk_status murk_page_check(const murk_options *options, murk_error *err)
{
    const bool has_folder = options->out && !options->shard.count;
    return !options->wants_page || has_folder
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, "--report",
                           "writes the page into the folder of the results: "
                           "needs -o DIR, and no --shard");
}

murk_status murk_page_write(const murk_options *options, murk_error *err)
{
    return options->wants_page && murk_ranks_number() == 0
               ? write_page(options, options->out, NULL, false, err)
               : MURK_OK;
}

murk_status murk_page_of_failed(const murk_options *options, murk_status status)
{
    murk_error why = {0};
    if (status && murk_page_write(options, &why)) {
        murk_message("warning: ", why.where, why.text);
    }
    return status;
}
