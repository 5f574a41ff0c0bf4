/* The events of one photon of a world, as murk replay shows them. */
#include "api/save.h"

#include "results/replay.h"

/* A murk_save_work; of: the number of the photon. No file is written. */
static murk_status work(void *of, murk_session *session,
                        const murk_save_options *options, murk_error *late,
                        murk_error *err)
{
    (void)late;
    const uint64_t *photon = of;
    cJSON *root = NULL;
    murk_status status =
        murk_save_identify(session, "replay", options, "", err);
    if (!status) {
        status = murk_replay_json(&root, session->stage, *photon, err);
    }
    return status ? status
                  : murk_session_finish(session, NULL, root, NULL, NULL, err);
}

murk_status murk_world_replay(murk_world *world, uint64_t photon,
                              const murk_save_options *options,
                              const murk_fields **fields, murk_error *error)
{
    if (!world || !fields) {
        return murk_save_refuse(fields, error, "world or fields is NULL");
    }
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_status status = murk_world_build(world, &call.failure);
    if (status) {
        *fields = NULL;
        return murk_call_end_long(&call, status);
    }
    const murk_session session = murk_world_session(world);
    return murk_save_results(&call, &session, &world->replayed, NULL, options,
                             fields, work, &photon);
}
