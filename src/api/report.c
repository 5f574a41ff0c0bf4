/* Reads a folder of results and writes one page of it, as murk report does. */
#include "api/handles.h"

#include "base/file.h"
#include "base/progress.h"
#include "report/report.h"
#include "results/ownership.h"

#include <stdlib.h>
#include <string.h>

static murk_status write_page(const char *folder, const char *path,
                              murk_error *err)
{
    murk_report *report = NULL;
    murk_progress_begin_group("report", 0, "");
    murk_status status = murk_report_read(&report, folder, err);
    if (!status) {
        status = murk_file_check_owner(path, MURK_MARK_PAGE,
                                       sizeof MURK_MARK_PAGE - 1, false, err);
    }
    if (!status) {
        status = murk_report_write(report, path, err);
    }
    murk_progress_end();
    murk_report_destroy(report);
    return status;
}

murk_status murk_context_write_report(murk_context *context, const char *folder,
                                      const char *page, murk_error *error)
{
    if (!context || !folder) {
        return murk_call_refuse(error, "context or folder is NULL");
    }
    murk_call call = murk_call_begin(context, NULL, error);
    char *path = page ? strdup(page) : murk_path_join(folder, "report.html");
    const murk_status status =
        path ? write_page(folder, path, &call.failure) : MURK_NO_MEMORY;
    free(path);
    return murk_call_end_long(&call, status);
}
