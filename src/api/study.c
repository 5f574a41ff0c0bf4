/* Studies: runs the rows of a study file, each group of rows in a subprocess,
 * and holds the values of all rows. */
#include "api/handles.h"

#include "cases/sweep.h"
#include "results/study.h"
#include "results/version.h"

#include <stdio.h>
#include <stdlib.h>

#define VERSION_SIZE 128 /* bytes of a version and a commit */

struct murk_study {
    murk_context *context;
    char version[VERSION_SIZE];
    murk_study_file *file;
    murk_sweep *sweep;
    murk_fields fields;
};

static murk_status run(murk_study *study, const char *path, const char *folder,
                       murk_error *err)
{
    snprintf(study->version, sizeof study->version, "%s %s", MURK_VERSION,
             murk_version_commit());
    murk_status status = murk_study_file_read(&study->file, path, err);
    const murk_sweep_desc desc = {.study = study->file,
                                  .folder = folder,
                                  .version = study->version,
                                  .threads = study->context->threads};
    if (!status) {
        status = murk_sweep_create(&study->sweep, &desc, err);
    }
    return status ? status : murk_sweep_run(study->sweep, err);
}

murk_status murk_study_run(murk_study **out, murk_context *context,
                           const char *path, const char *folder,
                           murk_error *error)
{
    if (!out || !context || !path) {
        return murk_call_refuse(error, "out, context or path is NULL");
    }
    *out = NULL;
    murk_call call = murk_call_begin(context, NULL, error);
    murk_study *study = calloc(1, sizeof *study);
    murk_status status = MURK_NO_MEMORY;
    if (study) {
        study->context = context;
        ++context->references;
        status = run(study, path, folder, &call.failure);
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_study_destroy(study);
        return status;
    }
    *out = study;
    return MURK_OK;
}

void murk_study_destroy(murk_study *study)
{
    if (study) {
        murk_fields_release(&study->fields);
        murk_sweep_destroy(study->sweep);
        murk_study_file_destroy(study->file);
        murk_context_release(study->context);
        free(study);
    }
}

murk_status murk_study_fields(murk_study *study, const murk_fields **fields,
                              murk_error *error)
{
    if (!study || !fields) {
        return murk_call_refuse(error, "study or fields is NULL");
    }
    murk_call call = murk_call_begin(study->context, NULL, error);
    *fields = &study->fields;
    return murk_call_end(
        &call, murk_fields_make(&study->fields, murk_results_list_study,
                                &(murk_study_results){study->sweep, false},
                                &call.failure));
}
