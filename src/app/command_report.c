/* murk report: one self-contained page of a result folder: see report/report.h.
 */
#include "app/identity.h"
#include "app/session.h"
#include "base/log.h"
#include "base/progress.h"
#include "report/report.h"
#include "results/summary.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* The page as JSON. The identity of a page follows from the identities of the
 * results in it. */
static murk_status print_json(const murk_options *options, const char *path,
                              double bytes, const murk_report_facts *facts,
                              murk_error *err)
{
    char shown[MURK_RESULT_FILES * 65] = "";
    size_t n = 0;
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        const char *one = murk_result_text(facts->results->json[i], "identity");
        if (one && strlen(one) == 64) {
            n += (size_t)snprintf(shown + n, 65, "%s", one);
        }
    }
    cJSON *root = cJSON_CreateObject();
    cJSON_AddStringToObject(root, "report", path);
    murk_json_number(root, "bytes", bytes);
    murk_json_number(root, "photons", (double)facts->photons);
    murk_json_number(root, "photons_shown", (double)facts->photons_shown);
    murk_json_number(root, "sensors_shown", (double)facts->sensors);
    return murk_print_alone(root, options, shown, path, err);
}

/* Prints the name and size of the page, and the photons in it, on standard
 * output. */
static murk_status print_page(const murk_options *options, const char *path,
                              const murk_report_facts *facts, murk_error *err)
{
    struct stat known = {0};
    (void)stat(path, &known);
    const double bytes = (double)known.st_size;
    if (options->json) {
        return print_json(options, path, bytes, facts, err);
    }
    if (!options->quiet) {
        murk_print("%s: %.2f MB", path, bytes / 1e6);
        if (facts->photons > 0) {
            murk_print(", %llu of %llu photons",
                       (unsigned long long)facts->photons_shown,
                       (unsigned long long)facts->photons);
        }
        murk_print("\n");
    }
    return MURK_OK;
}

murk_status murk_command_report(const murk_options *options, murk_error *err)
{
    if (options->n_overrides > 0) {
        return murk_fail(err, MURK_BAD_VALUE, "report",
                         "shows results as they are: no --set and no --seed");
    }
    murk_session_quiet(options);
    murk_progress_begin_group("report", 0, "");
    /* Read the folder. */
    char *path = options->out ? strdup(options->out)
                              : murk_path_join(options->input, "report.html");
    murk_report *report = NULL;
    murk_report_facts facts = {0};
    murk_status status = murk_report_read(&report, options->input, err);
    if (!status && !path) {
        status = murk_no_memory(err, "", "for the page");
    }
    if (!status) {
        /* Name files of other runs, and replace no page that murk did not
         * write. */
        facts = murk_report_describe(report);
        const char *strangers = facts.results->strangers;
        if (strangers && *strangers) {
            murk_warn(options->input,
                      "edited since, of an earlier run, or of a run that was "
                      "killed while it wrote them: %s",
                      strangers);
        }
        status = murk_file_check_owner(path, MURK_MARK_PAGE,
                                       sizeof MURK_MARK_PAGE - 1,
                                       options->force, err);
    }
    if (!status) {
        status = murk_report_write(report, path, err);
    }
    murk_progress_end();
    if (!status) {
        status = print_page(options, path, &facts, err);
    }
    murk_report_destroy(report);
    free(path);
    return status;
}
