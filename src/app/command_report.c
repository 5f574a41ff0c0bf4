/* murk report: one self-contained page of a result folder. */
#include "app/given.h"
#include "app/show.h"
#include "base/print.h"

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

murk_status murk_command_report(const murk_options *options, murk_error *err)
{
    if (options->n_overrides > 0) {
        return murk_fail(err, MURK_BAD_VALUE, "report",
                         "shows results as they are: no --set and no --seed");
    }
    murk_given_save save = {.exports = NULL};
    const murk_fields *page = NULL;
    murk_status status = murk_given_save_begin(&save, options, err);
    if (!status) {
        status =
            murk_context_write_report(options->context, options->input,
                                      options->out, &save.options, &page, err);
    }
    if (!status && options->json) {
        murk_print_json(murk_fields_json(page));
    } else if (!status && murk_shows_summary(options)) {
        print_page(page);
    }
    murk_given_save_end(&save);
    return status;
}
