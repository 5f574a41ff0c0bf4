/* What the commands on a scene share: reading the scene, building its world,
 * and tracing its light or reading it from a file. */
#include "app/session.h"

#include "app/given.h"
#include "app/identity.h"
#include "results/tallies.h"

#include "api/scene.h"
#include "base/log.h"
#include "base/progress.h"
#include "world/stage_build.h"

/* Reads the scene as the commands that call murk.h do. */
static murk_status read_scene(murk_scene_desc **out,
                              const murk_options *options, murk_error *err)
{
    murk_scene *scene = NULL;
    murk_status status = murk_given_scene(&scene, options, err);
    if (!status) {
        status = murk_scene_describe(out, scene, err);
    }
    murk_scene_destroy(scene);
    return status;
}

void murk_session_quiet(const murk_options *options)
{
    if (options->quiet) {
        murk_warn_to(NULL);
    }
    murk_progress_set(options->quiet ? MURK_PROGRESS_NEVER : options->progress);
}

void murk_session_set(murk_session *session, const murk_options *options)
{
    *session = (murk_session){.settings = {.folder = options->out,
                                           .force = options->force,
                                           .threads = options->threads,
                                           .exports = options->exports,
                                           .voxel = options->voxel,
                                           .light = options->light,
                                           .prints_json = options->json,
                                           .is_quiet = options->quiet},
                              .run.threads = options->threads,
                              .run.command = options->typed,
                              .begun_s = murk_clock_s()};
    murk_session_quiet(options);
}

murk_status murk_session_scene(murk_session *session,
                               const murk_options *options, murk_error *err)
{
    murk_session_set(session, options);
    murk_progress_begin_group("read", 0, "");
    const murk_status status = read_scene(&session->scene, options, err);
    murk_progress_end();
    if (status) {
        return status;
    }
    murk_scene_tell(session->scene);
    return murk_identity_scene(session->identity, options, session->scene, err);
}

murk_status murk_session_read(murk_session *session,
                              const murk_options *options, murk_error *err)
{
    const murk_status status = murk_session_scene(session, options, err);
    return status ? status
                  : murk_results_begin(&session->results, options->out,
                                       options->force, err);
}

murk_status murk_session_build(murk_session *session, murk_error *err)
{
    murk_progress_begin_group("build", 0, "");
    const murk_status status =
        murk_stage_create(&session->stage, session->scene, err);
    murk_progress_end();
    session->run.load_s = murk_clock_s() - session->begun_s;
    return status;
}

murk_status murk_session_light(murk_session *session, murk_error *err)
{
    const murk_status status =
        session->settings.light
            ? murk_session_read_light(session, err)
            : murk_lightmap_trace(&session->traced, session->stage, 0,
                                  session->settings.threads, err);
    if (!status) {
        session->run.trace_s = session->traced->trace_s;
        session->run.map_s = session->traced->map_s;
    }
    return status;
}
