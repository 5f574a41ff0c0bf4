/* Fits: the parameters of a scene are calibrated to the readings of a file, as
 * murk fit does without further options. */
#include "api/light.h"
#include "api/scene.h"

#include "base/progress.h"
#include "calibrate/calibrate.h"
#include "calibrate/covered.h"
#include "results/fit.h"
#include "world/stage_build.h"

#include <stdlib.h>
#include <string.h>

/* The name under which the text of a scene is read again for each value of a
 * parameter (base/memory_files.h). */
#define SCENE_TEXT "murk-scene"

struct murk_fit {
    murk_scene *scene;
    murk_memory_files files; /* of the scene as it was, and its text */
    murk_scene_desc *desc;
    murk_imported_stages imported;
    murk_stage *stage; /* borrows of the imported stages */
    murk_readings *measured;
    murk_free_keys *keys;
    murk_calibration found;
    murk_fields fields;
};

/* The files of all conditions first, then the scene's own world. */
static murk_status build(murk_fit *f, murk_error *err)
{
    murk_progress_begin_group("build", 0, "");
    murk_status status = murk_scene_describe(&f->desc, f->scene, err);
    if (!status) {
        status = murk_imported_stages_import(&f->imported, f->desc, err);
    }
    if (!status) {
        status = murk_stage_import_beside(&f->stage, f->desc,
                                          f->imported.stage[0], err);
    }
    if (!status) {
        status = murk_stage_build(f->stage, err);
    }
    murk_progress_end();
    return status;
}

/* Reads the readings and finds the parameters. Refuses before any trace what
 * would otherwise fail after all of them. */
static murk_status read_input(murk_fit *f, const char *data,
                              const char *const *keys, size_t n,
                              murk_error *err)
{
    murk_status status = murk_readings_read(&f->measured, data, f->desc,
                                            &f->stage->world.domain, err);
    const murk_free_desc desc = {
        .scene_path =
            f->scene->is_file ? f->scene->name : MURK_MEMORY_PREFIX SCENE_TEXT,
        .overrides = f->scene->set,
        .n_overrides = f->scene->n,
        .asked = keys,
        .n_asked = n,
        .measured = f->measured,
        .domain = &f->stage->world.domain};
    if (!status) {
        status = murk_free_keys_create(&f->keys, &desc, err);
    }
    for (size_t i = 0; !status && i < f->measured->readings; ++i) {
        if (f->measured->reading[i].kind == MURK_READ_COVERAGE) {
            status = murk_covered_check(f->desc, err);
        }
    }
    return status;
}

static murk_status calibrate(murk_fit *f, murk_error *err)
{
    const murk_calibration_desc desc = {.keys = f->keys,
                                        .measured = f->measured,
                                        .imported = &f->imported,
                                        .threads = f->scene->context->threads,
                                        .seed = f->desc->seed};
    murk_progress_begin_group("fit", 0, "steps");
    const murk_status status = murk_calibrate(&f->found, &desc, err);
    murk_progress_end();
    return status;
}

/* The text of a scene that is no file becomes a file in memory. */
static murk_status keep_files(murk_fit *f, murk_error *err)
{
    char *text = strdup(f->scene->text);
    if (!text || !murk_memory_copy(&f->files, &f->scene->files)) {
        free(text);
        return murk_no_memory(err, f->scene->name, "for the fit");
    }
    const murk_memory_file file = {
        .kind = MURK_MEMORY_TABLE, .data = text, .release = free};
    return murk_memory_add(&f->files, SCENE_TEXT, file, err);
}

murk_status murk_fit_run(murk_fit **out, murk_scene *scene, const char *data,
                         const char *const *keys, size_t n, murk_error *error)
{
    if (!out || !scene || !data || !keys || n == 0) {
        return murk_call_refuse(error, "out, scene, data or keys is NULL, or "
                                       "there are no keys");
    }
    /* The handle, then each step. */
    *out = NULL;
    murk_fit *f = calloc(1, sizeof *f);
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    murk_status status = MURK_NO_MEMORY;
    if (f) {
        f->scene = scene;
        ++scene->references;
        status = keep_files(f, &call.failure);
        call.host->files = &f->files;
    }
    if (!status) {
        status = build(f, &call.failure);
    }
    if (!status) {
        status = read_input(f, data, keys, n, &call.failure);
    }
    if (!status) {
        status = calibrate(f, &call.failure);
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_fit_destroy(f);
        return status;
    }
    *out = f;
    return MURK_OK;
}

void murk_fit_destroy(murk_fit *f)
{
    if (!f) {
        return;
    }
    murk_fields_release(&f->fields);
    murk_calibration_release(&f->found);
    murk_free_keys_destroy(f->keys);
    murk_readings_destroy(f->measured);
    murk_stage_destroy(f->stage);
    murk_imported_stages_release(&f->imported);
    murk_scene_desc_destroy(f->desc);
    murk_memory_release(&f->files);
    murk_scene_release(f->scene);
    free(f);
}

static murk_fit_facts facts_of(const murk_fit *f)
{
    return (murk_fit_facts){.scene = f->desc,
                            .keys = f->keys,
                            .measured = f->measured,
                            .found = &f->found};
}

murk_status murk_fit_fields(murk_fit *f, const murk_fields **fields,
                            murk_error *error)
{
    if (!f || !fields) {
        return murk_call_refuse(error, "fit or fields is NULL");
    }
    const murk_fit_facts facts = facts_of(f);
    murk_call call = murk_call_begin(f->scene->context, NULL, error);
    *fields = &f->fields;
    return murk_call_end(&call,
                         murk_fields_make(&f->fields, murk_results_list_fit,
                                          &facts, &call.failure));
}
