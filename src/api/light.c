/* Light: photon maps and ledger, traced together with the tallies, or read from
 * a file, which has no tallies. */

#include "api/save.h"
#include "lightmap/light_part_trace.h"
#include "lightmap/light_update.h"
#include "results/exports.h"
#include "results/ledger.h"
#include "results/tallies.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Makes a handle that has no light yet. NULL when out of memory. */
static murk_light *make(murk_world *world)
{
    murk_light *light = calloc(1, sizeof *light);
    if (light) {
        light->references = 1;
        light->world = world;
        ++world->references;
        light->session = murk_world_session(world);
    }
    return light;
}

static murk_status read_light(murk_light *light, const char *path,
                              murk_error *err)
{
    light->path = strdup(path);
    if (!light->path) {
        return murk_no_memory(err, path, "for the light");
    }
    light->session.settings.light = light->path;
    return murk_session_read_light(&light->session, err);
}

/* The function of the caller that receives batches. */
typedef struct receiver {
    murk_batch_function each; /* not NULL */
    void *user;
    const murk_scene_desc *scene;
} receiver;

/* A murk_record_batch_sink. */
static murk_status receive(void *context, const murk_record_batch *records,
                           murk_error *err)
{
    const receiver *r = context;
    murk_batch batch = {.records = records, .scene = r->scene};
    const int is_enough = r->each(r->user, &batch);
    murk_made_release(batch.made);
    return is_enough ? murk_fail(err, MURK_INTERRUPTED, "",
                                 "stopped by the function that receives "
                                 "batches, at batch %llu",
                                 (unsigned long long)records->number)
                     : MURK_OK;
}

/* Where light comes from: a file, files of parts, a trace with checkpoints, or
 * a trace whose batches a function of the caller receives. If all are NULL,
 * light is traced. */
typedef struct light_source {
    const char *file;
    const char *const *part; /* [parts] */
    size_t parts;
    const char *checkpoint;
    double checkpoint_every_s;
    receiver *batches;
    murk_light *earlier; /* of another world, to be updated */
} light_source;

static murk_status merge_parts(murk_light *light, const light_source *from,
                               murk_error *err)
{
    const murk_world *world = light->world;
    murk_light_parts *parts = NULL;
    murk_status status = murk_light_parts_read(&parts, from->part, from->parts,
                                               world->stage, err);
    if (!status) {
        status = murk_lightmap_merge(&light->session.traced, world->stage,
                                     parts, world->context->threads, err);
    }
    murk_light_parts_destroy(parts);
    return status;
}

static murk_status fill(murk_light *light, const light_source *from,
                        murk_error *err)
{
    murk_traced **out = &light->session.traced;
    const murk_stage *stage = light->world->stage;
    const unsigned threads = light->world->context->threads;
    return from->file   ? read_light(light, from->file, err)
           : from->part ? merge_parts(light, from, err)
           : from->earlier
               ? murk_lightmap_update(out, &light->session.run.reused_photons,
                                      stage, from->earlier->session.traced,
                                      from->earlier->world->stage, threads, err)
           : from->checkpoint
               ? murk_lightmap_resume(out, stage, threads, from->checkpoint,
                                      from->checkpoint_every_s, err)
           : from->batches ? murk_lightmap_stream(out, stage, threads, receive,
                                                  from->batches, err)
                           : murk_lightmap_trace(out, stage, 0, threads, err);
}

static murk_status light_make(murk_light **out, murk_world *world,
                              const light_source *from, murk_error *error)
{
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_status status = murk_world_build(world, &call.failure);
    murk_light *light = status ? NULL : make(world);
    if (!status) {
        status = light ? fill(light, from, &call.failure) : MURK_NO_MEMORY;
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_light_release(light);
        return status;
    }
    light->session.run.trace_s = light->session.traced->trace_s;
    light->session.run.map_s = light->session.traced->map_s;
    *out = light;
    return MURK_OK;
}

murk_status murk_light_trace(murk_light **out, murk_world *world,
                             murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    const light_source from = {.file = NULL};
    return out && world ? light_make(out, world, &from, error)
                        : murk_call_refuse(error, "out or world is NULL");
}

murk_status murk_light_update(murk_light **out, murk_light *light,
                              murk_world *world, murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !light || !world) {
        return murk_call_refuse(error, "out, light or world is NULL");
    }
    if (light->world->context != world->context) {
        return murk_call_refuse(error,
                                "light and world are of different contexts");
    }
    const light_source from = {.earlier = light};
    return light_make(out, world, &from, error);
}

murk_status murk_light_trace_resume(murk_light **out, murk_world *world,
                                    const char *path, double every_s,
                                    murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!(every_s >= 0)) {
        return murk_call_refuse(error, "every_s is below 0");
    }
    const light_source from = {.checkpoint = path,
                               .checkpoint_every_s = every_s};
    return out && world && path
               ? light_make(out, world, &from, error)
               : murk_call_refuse(error, "out, world or path is NULL");
}

murk_status murk_light_stream(murk_light **out, murk_world *world,
                              murk_batch_function each, void *user,
                              murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !world || !each) {
        return murk_call_refuse(error, "out, world or each is NULL");
    }
    receiver batches = {each, user, world->desc};
    const light_source from = {.batches = &batches};
    return light_make(out, world, &from, error);
}

murk_status murk_light_merge(murk_light **out, murk_world *world,
                             const char *const *path, size_t n,
                             murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    bool has_paths = path && n > 0;
    for (size_t i = 0; has_paths && i < n; ++i) {
        has_paths = path[i] != NULL;
    }
    const light_source from = {.part = path, .parts = n};
    return out && world && has_paths
               ? light_make(out, world, &from, error)
               : murk_call_refuse(error, "out, world or a path is NULL");
}

murk_status murk_light_trace_part(murk_world *world, uint32_t number,
                                  uint32_t count, const char *path,
                                  murk_error *error)
{
    if (!world || !path) {
        return murk_call_refuse(error, "world or path is NULL");
    }
    murk_call call = murk_call_begin(world->context, &world->files, error);
    const murk_shard shard = {number, count};
    murk_status status = murk_shard_check(shard, &call.failure);
    if (!status) {
        status = murk_world_build(world, &call.failure);
    }
    if (!status) {
        status = murk_light_part_trace(
            world->stage, shard, world->context->threads, path, &call.failure);
    }
    return murk_call_end_long(&call, status);
}

double murk_light_packet_w(const murk_light *light, int source, int band)
{
    const murk_traced *t = light ? light->session.traced : NULL;
    const int bands = light ? light->session.scene->bands : 0;
    const size_t channel = source >= 0 && band >= 0 && band < bands
                               ? (size_t)source * (size_t)bands + (size_t)band
                               : SIZE_MAX;
    return t && channel < t->channels ? t->packet_w[channel] : NAN;
}

murk_status murk_light_read(murk_light **out, murk_world *world,
                            const char *path, murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    const light_source from = {.file = path};
    return out && world && path
               ? light_make(out, world, &from, error)
               : murk_call_refuse(error, "out, world or path is NULL");
}

murk_status murk_light_write(const murk_light *light, const char *path,
                             murk_error *error)
{
    if (!light || !path) {
        return murk_call_refuse(error, "light or path is NULL");
    }
    murk_world *world = light->world;
    murk_call call = murk_call_begin(world->context, &world->files, error);
    return murk_call_end(&call,
                         murk_lightmap_save(light->session.traced, world->stage,
                                            path, &call.failure));
}

void murk_light_release(murk_light *light)
{
    if (!light || --light->references > 0) {
        return;
    }
    free(light->path);
    murk_fields_release(&light->fields);
    murk_fields_release(&light->saved);
    murk_made_release(light->made);
    murk_traced_destroy(light->session.traced);
    murk_world_release(light->world);
    free(light);
}

void murk_light_destroy(murk_light *light)
{
    murk_light_release(light);
}

murk_status murk_light_fields(murk_light *light, const murk_fields **fields,
                              murk_error *error)
{
    if (!light || !fields) {
        return murk_call_refuse(error, "light or fields is NULL");
    }
    murk_call call = murk_call_begin(light->world->context, NULL, error);
    *fields = &light->fields;
    return murk_call_end(
        &call, murk_fields_make(&light->fields, murk_results_list_ledger,
                                &(murk_ledger_results){light->session.traced,
                                                       light->session.stage},
                                &call.failure));
}

/* ---- files ---- */

static murk_status save(void *of, murk_session *session,
                        const murk_save_options *options, murk_error *late,
                        murk_error *err)
{
    (void)of; /* all results are in the session */
    murk_status status = murk_save_check(session, "trace", 0, err);
    if (!status) {
        status = murk_save_identify(session, "trace", options, "", err);
    }
    if (!status) {
        status = murk_session_add_light(session, err);
    }
    if (!status) {
        status = murk_add_tallies(session, err);
    }
    if (!status) {
        murk_exports_add_scene(session, NULL, NULL, 0, late);
    }
    const murk_ledger_results ledger = {session->traced, session->stage};
    return status ? status
                  : murk_session_finish(
                        session, "ledger.json",
                        murk_results_json(murk_results_list_ledger, &ledger),
                        murk_print_trace, session, err);
}

murk_status murk_light_save(murk_light *light, const char *folder,
                            const murk_save_options *options,
                            const murk_fields **fields, murk_error *error)
{
    if (!light) {
        return murk_save_refuse(fields, error, "light is NULL");
    }
    murk_world *world = light->world;
    murk_call call = murk_call_begin(world->context, &world->files, error);
    return murk_save_results(&call, &light->session, &light->saved, folder,
                             options, fields, save, light);
}
