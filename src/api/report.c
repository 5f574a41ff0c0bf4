/* Reads a folder of results and writes one page of it, as murk report does. The
 * identity of a page follows from the identities of the results in it. */
#include "api/save.h"

#include "base/file.h"
#include "base/inputs.h"
#include "base/log.h"
#include "base/progress.h"
#include "report/report.h"
#include "results/ownership.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define IDENTITY 64 /* letters of an identity */

/* The identities of all main JSONs of the folder, and a line feed. */
typedef struct identities {
    char text[MURK_RESULT_FILES * IDENTITY + 2];
} identities;

static identities identities_of(const murk_results_in *results)
{
    identities all = {""};
    size_t n = 0;
    for (int i = 0; i < MURK_RESULT_FILES; ++i) {
        const char *one = murk_result_text(results->json[i], "identity");
        if (one && strlen(one) == IDENTITY) {
            memcpy(all.text + n, one, IDENTITY);
            n += IDENTITY;
        }
    }
    all.text[n] = '\n';
    return all;
}

/* Makes the fields of a page that is written. */
static murk_status describe(murk_fields *fields, const char *path,
                            const murk_report_facts *facts,
                            const murk_save_options *options, murk_error *err)
{
    struct stat page = {0};
    (void)stat(path, &page);
    /* The identity of a page follows from those of the results in it. */
    const identities of = identities_of(facts->results);
    cJSON *root = cJSON_CreateObject();
    cJSON_AddStringToObject(root, "report", path);
    murk_json_number(root, "bytes", (double)page.st_size);
    murk_json_number(root, "photons", (double)facts->photons);
    murk_json_number(root, "photons_shown", (double)facts->photons_shown);
    murk_json_number(root, "sensors_shown", (double)facts->sensors);
    return murk_save_alone(fields, root, "report", options, of.text, path, err);
}

/* Names the files of other runs, which are not in the page. */
static void warn_of_strangers(const char *folder,
                              const murk_results_in *results)
{
    if (results->strangers && *results->strangers) {
        murk_warn(folder,
                  "edited since, of an earlier run, or of a run that was "
                  "killed while it wrote them: %s",
                  results->strangers);
    }
}

static murk_status write_page(murk_fields *fields, const char *folder,
                              const char *path,
                              const murk_save_options *options, murk_error *err)
{
    const murk_save_options all = murk_save_known(options);
    murk_report *report = NULL;
    murk_report_facts facts = {0};
    murk_progress_begin_group("report", 0, "");
    murk_status status = murk_report_read(&report, folder, all.made_by, err);
    /* No page may be replaced that murk did not write. */
    if (!status) {
        facts = murk_report_describe(report);
        warn_of_strangers(folder, facts.results);
        status = murk_file_check_owner(
            path, MURK_MARK_PAGE, sizeof MURK_MARK_PAGE - 1, all.replaces, err);
    }
    if (!status) {
        status = murk_report_write(report, path, err);
    }
    murk_progress_end();
    if (!status) {
        status = describe(fields, path, &facts, options, err);
    }
    murk_report_destroy(report);
    return status;
}

murk_status murk_context_write_report(murk_context *context, const char *folder,
                                      const char *page,
                                      const murk_save_options *options,
                                      const murk_fields **fields,
                                      murk_error *error)
{
    if (!context || !folder) {
        return murk_save_refuse(fields, error, "context or folder is NULL");
    }
    murk_call call = murk_call_begin(context, NULL, error);
    /* The files of the folder are results, which later calls may replace. */
    const murk_inputs_before before = murk_inputs_try();
    char *path = page ? strdup(page) : murk_path_join(folder, "report.html");
    murk_status status =
        path ? murk_save_check_options(options, &call.failure)
             : murk_no_memory(&call.failure, "", "for the page");
    if (!status) {
        murk_memory_files arrays;
        murk_context_arrays_of(&arrays, context, folder);
        context->host->files = &arrays;
        status = write_page(&context->reported, folder, path, options,
                            &call.failure);
        context->host->files = NULL;
        murk_memory_release(&arrays);
    }
    free(path);
    murk_inputs_forget(&before);
    status = murk_call_end_long(&call, status);
    if (fields) {
        *fields = status ? NULL : &context->reported;
    }
    return status;
}
