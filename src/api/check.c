/* A look over a world before its light is traced, as murk check shows it. */
#include "api/save.h"

#include "overview/overview.h"

/* As of parts (murk_light_trace_part()); no cluster has more processors. */
#define RANKS_MAX 100000

typedef struct request {
    murk_section_file picture;
    unsigned ranks;
    cJSON *lines; /* set by work(): the lines of text; NULL: none */
} request;

/* A murk_save_work; of: the request. No file but the picture is written. */
static murk_status work(void *of, murk_session *session,
                        const murk_save_options *save, murk_error *late,
                        murk_error *err)
{
    (void)late;
    request *asked = of;
    murk_overview overview = {0};
    murk_status status = murk_save_identify(session, "check", save, "", err);
    if (!status) {
        status = murk_overview_make(&overview, session, &asked->picture,
                                    asked->ranks, err);
    }
    if (!status) {
        asked->lines = murk_print_collect(murk_overview_print, &overview);
        status = murk_session_finish(
            session, NULL, murk_overview_json(&overview), NULL, NULL, err);
    }
    murk_overview_release(&overview);
    return status;
}

static murk_status take_options(request *out, const murk_check_options *options,
                                murk_error *err)
{
    murk_check_options all = {0};
    murk_status status = murk_options_copy(&all, sizeof all, options, "options",
                                           "murk_check_options", err);
    if (!status && all.ranks > RANKS_MAX) {
        status = murk_fail(err, MURK_BAD_VALUE, "ranks",
                           "is %zu, must be 0..%d", all.ranks, RANKS_MAX);
    }
    *out = (request){.picture = {.path = all.picture,
                                 .cut_m = all.cut_m,
                                 .pixels = {all.pixels[0], all.pixels[1]}},
                     .ranks = (unsigned)all.ranks};
    return status;
}

/* Adds the lines as run.summary to the fields, but not to the JSON text,
 * because the JSON of murk check has none. Takes over the lines in any case.
 * Releases the fields and fails with MURK_NO_MEMORY if `lines` is NULL. */
static murk_status add_lines(murk_world *world, cJSON *lines, murk_error *error)
{
    cJSON *run = cJSON_GetObjectItem(world->checked.root, "run");
    if (lines && cJSON_AddItemToObject(run, "summary", lines)) {
        return MURK_OK;
    }
    cJSON_Delete(lines);
    murk_fields_release(&world->checked);
    murk_call call = murk_call_begin(world->context, NULL, error);
    return murk_call_end(
        &call, murk_no_memory(&call.failure, "", "for the lines of text"));
}

murk_status murk_world_check(murk_world *world,
                             const murk_check_options *options,
                             const murk_save_options *save,
                             const murk_fields **fields, murk_error *error)
{
    if (!world) {
        return murk_save_refuse(fields, error, "world is NULL");
    }
    /* The options, and the world unless it is built. */
    request asked;
    murk_call call = murk_call_begin(world->context, &world->files, error);
    murk_status status = take_options(&asked, options, &call.failure);
    if (!status) {
        status = murk_world_build(world, &call.failure);
    }
    /* The facts, their JSON and the lines of text. */
    if (status) {
        status = murk_call_end_long(&call, status);
    } else {
        const murk_session session = murk_world_session(world);
        status = murk_save_results(&call, &session, &world->checked, NULL, save,
                                   NULL, work, &asked);
        if (!status) {
            status = add_lines(world, asked.lines, error);
        } else {
            cJSON_Delete(asked.lines);
        }
    }
    if (fields) {
        *fields = status ? NULL : &world->checked;
    }
    return status;
}
