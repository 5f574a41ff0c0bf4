/* Contexts: a context has a host (base/host.h), which holds the limit on
 * threads, the process of imports and the requests to stop and to finish, and
 * which passes messages and progress to the functions of the caller. */
#include "api/handles.h"

#include "base/file.h"
#include "base/host_make.h"
#include "base/inputs.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/pool.h"
#include "base/progress.h"
#include "results/results.h"
#include "results/version.h"
#include "scene/yaml.h"

#include <stdlib.h>
#include <string.h>

static void show_progress(void *user, const murk_progress_facts *facts)
{
    const murk_context *context = user;
    const murk_progress progress = {.size = sizeof progress,
                                    .step = facts->step,
                                    .unit = facts->unit,
                                    .text = facts->text,
                                    .done = facts->done,
                                    .total = facts->total,
                                    .elapsed_s = facts->elapsed_s};
    context->options.progress(context->options.user, &progress);
}

static const murk_importing importing[] = {
    [MURK_IMPORTS_READER] = MURK_IMPORT_STARTS,
    [MURK_IMPORTS_FORK] = MURK_IMPORT_FORKS,
    [MURK_IMPORTS_IN_PROCESS] = MURK_IMPORT_IN_PROCESS};

static murk_status no_memory(murk_error *error, const char *purpose)
{
    murk_error failure = {0};
    (void)murk_no_memory(&failure, "", "%s", purpose);
    murk_call_report(error, &failure);
    return MURK_NO_MEMORY;
}

/* Copies the members that the caller's struct has, and the path of murk-reader.
 * Fails if `imports` is no value of murk_imports. */
static murk_status take_options(murk_context *context,
                                const murk_context_options *options,
                                murk_error *error)
{
    murk_error failure = {0};
    const murk_status status =
        murk_options_copy(&context->options, sizeof context->options, options,
                          "options", "murk_context_options", &failure);
    if (status) {
        murk_call_report(error, &failure);
        return status;
    }
    /* Values of enumerations. */
    if ((unsigned)context->options.imports > MURK_IMPORTS_IN_PROCESS) {
        return murk_call_refuse(error, "options->imports is no value of "
                                       "murk_imports");
    }
    if ((unsigned)context->options.line > MURK_PROGRESS_ALWAYS ||
        (context->options.line && context->options.progress)) {
        return murk_call_refuse(error,
                                "options->line must be a value of "
                                "murk_progress_mode, and MURK_PROGRESS_NEVER "
                                "with options->progress");
    }
    /* The path, as a copy. */
    const char *reader = context->options.reader;
    context->reader = reader ? strdup(reader) : NULL;
    return !reader || context->reader
               ? MURK_OK
               : no_memory(error, "for a copy of options->reader");
}

/* Notes the files that the caller reads; a file that cannot be opened is left
 * out, since it cannot be replaced by mistake. */
static murk_status note_inputs(const murk_context_options *options,
                               murk_error *err)
{
    const murk_status status = murk_call_check_texts(
        err, "options->inputs", options->inputs, options->n_inputs);
    for (size_t i = 0; i < options->n_inputs && !status; ++i) {
        FILE *file = murk_inputs_open(options->inputs[i]);
        if (file) {
            fclose(file);
        }
    }
    return status;
}

murk_status murk_context_create(murk_context **out,
                                const murk_context_options *options,
                                murk_error *error)
{
    if (!out) {
        return murk_call_refuse(error, "out is NULL");
    }
    *out = NULL;
    murk_context *context = calloc(1, sizeof *context);
    murk_host *host = murk_host_create();
    if (!context || !host) {
        free(context);
        murk_host_destroy(host);
        return no_memory(error, "for a context");
    }
    context->references = 1;
    context->host = host;
    murk_status status =
        options ? take_options(context, options, error) : MURK_OK;
    if (status) {
        murk_context_release(context);
        return status;
    }
    context->threads = context->options.threads ? context->options.threads
                                                : murk_pool_processors();
    /* Set up the host. */
    host->importing = importing[context->options.imports];
    host->reader = context->reader;
    host->ranks = murk_host_now()->ranks;
    host->keeps_in_first = murk_host_now()->keeps_in_first;
    host->version = murk_version_with_commit();
    murk_call call = murk_call_begin(context, NULL, error);
    murk_inputs_begin();
    murk_log_to(context->options.log, context->options.user);
    murk_progress_set(context->options.line);
    if (context->options.progress) {
        murk_progress_to(show_progress, context);
    }
    status = note_inputs(&context->options, &call.failure);
    context->options.inputs = NULL; /* the caller's, for this call alone */
    if (!status) {
        status = murk_pool_allow(context->threads, &call.failure);
    }
    if (murk_call_end(&call, status)) {
        murk_context_release(context);
        return status;
    }
    *out = context;
    return MURK_OK;
}

void murk_context_release(murk_context *context)
{
    if (context && --context->references == 0) {
        murk_fields_release(&context->reported);
        murk_fields_release(&context->preset);
        murk_fields_release(&context->profile);
        murk_fields_release(&context->reference);
        murk_fields_release(&context->keys);
        murk_host_destroy(context->host);
        free(context->reader);
        free(context);
    }
}

void murk_context_hold_arrays(murk_context *context, murk_held_arrays *held,
                              const murk_memory_files *files,
                              const murk_scene_desc *scene)
{
    if (files->n > 0) {
        *held = (murk_held_arrays){context->held, files, scene->resolved, NULL};
        context->held = held;
    }
}

void murk_context_forget_arrays(murk_context *context, murk_held_arrays *held)
{
    murk_held_arrays **at = &context->held;
    while (*at && *at != held) {
        at = &(*at)->next;
    }
    if (*at) {
        *at = held->next;
        free(held->folder);
    }
}

void murk_context_note_folder(murk_context *context, const char *folder,
                              const murk_scene_desc *scene)
{
    char *whole = context->held ? realpath(folder, NULL) : NULL;
    for (murk_held_arrays *held = context->held; held; held = held->next) {
        const bool is_saved = scene && held->resolved == scene->resolved;
        const bool was_there =
            whole && held->folder && strcmp(held->folder, whole) == 0;
        if (is_saved || was_there) {
            free(held->folder);
            held->folder = is_saved && whole ? strdup(whole) : NULL;
        }
    }
    free(whole);
}

void murk_context_arrays_of(murk_memory_files *out, const murk_context *context,
                            const char *folder)
{
    char *whole = context->held ? realpath(folder, NULL) : NULL;
    char *path = whole ? murk_path_join(whole, MURK_SCENE_NAME) : NULL;
    char *text = NULL;
    size_t size = 0;
    const murk_held_arrays *held = context->held;
    *out = (murk_memory_files){0};
    while (held && !(held->folder && whole && !strcmp(held->folder, whole))) {
        held = held->next;
    }
    /* The folder may have been written by another program since. */
    if (held && path &&
        !murk_file_read(&text, &size, path, MURK_YAML_MAX_BYTES, NULL) &&
        strcmp(held->resolved, text) == 0) {
        (void)murk_memory_copy(out, held->files);
    }
    free(text);
    free(path);
    free(whole);
}

void murk_context_destroy(murk_context *context)
{
    murk_context_release(context);
}

void murk_context_cancel(murk_context *context)
{
    if (context) {
        atomic_store(&context->host->stop, 1);
    }
}

bool murk_context_finish(murk_context *context)
{
    return context && murk_finish_request(context->host);
}
