/* murk replay: traces one photon of a scene again, by its index, and shows
 * each event. */
#include "app/session.h"
#include "results/summary.h"

#include <stdlib.h>

static const char *const kind_name[] = {
    [MURK_EVENT_EMITTED] = "emitted",    [MURK_EVENT_SURFACE] = "surface",
    [MURK_EVENT_MEDIUM] = "medium",      [MURK_EVENT_WRAPPED] = "wrapped",
    [MURK_EVENT_ESCAPED] = "escaped",    [MURK_EVENT_LOST] = "lost",
    [MURK_EVENT_INTERFACE] = "interface"};
static const char *const outcome_name[] = {[MURK_ABSORBED] = "absorbed",
                                           [MURK_DIFFUSE] = "reflected",
                                           [MURK_MIRRORED] = "mirrored",
                                           [MURK_TRANSMITTED] = "transmitted",
                                           [MURK_SCATTERED] = "scattered"};
static const char *const loss_name[] = {[MURK_LOSS_EVENTS] = "too many events",
                                        [MURK_LOSS_WRAPS] = "too many wraps",
                                        [MURK_LOSS_NUMERICAL] = "numerical"};

typedef struct replay {
    const murk_session *session;
    uint64_t photon;
    cJSON *events; /* NULL: print lines */
} replay;

/* The name of the material or medium of the event; of a lost photon the reason;
 * of other events "". */
static const char *partner(const replay *r, const murk_event *event)
{
    const murk_scene_desc *scene = r->session->scene;
    switch (event->kind) {
    case MURK_EVENT_SURFACE:
        return scene->materials[event->material_or_medium].name;
    case MURK_EVENT_MEDIUM:
        return scene->media[event->material_or_medium].name;
    case MURK_EVENT_INTERFACE:
        return scene->media[scene->regions[event->material_or_medium].medium]
            .name;
    case MURK_EVENT_LOST:
        return loss_name[event->loss];
    case MURK_EVENT_EMITTED:
    case MURK_EVENT_WRAPPED:
    case MURK_EVENT_ESCAPED:
        break;
    }
    return "";
}

static bool has_outcome(const murk_event *event)
{
    return event->kind == MURK_EVENT_SURFACE ||
           event->kind == MURK_EVENT_MEDIUM ||
           event->kind == MURK_EVENT_INTERFACE;
}

static void print_event(const replay *r, const murk_event *event)
{
    const murk_vec3 p = murk_scene_user(r->session->scene, event->position);
    const murk_vec3 d = event->direction_out;
    const char *name = partner(r, event);
    murk_print("%5u %-9s %9.3f %9.3f %9.3f %7.4f %7.4f %7.4f %9.3f\n",
               event->number, kind_name[event->kind], p.x, p.y, p.z, d.x, d.y,
               d.z, event->path_m);
    if (*name) { /* names may be as wide as a line, so they have their own */
        murk_print("%6s%s%s%s\n", "", name, has_outcome(event) ? ": " : "",
                   has_outcome(event) ? outcome_name[event->outcome] : "");
    }
}

static void add_event(const replay *r, const murk_event *event)
{
    cJSON *item = murk_json_item(r->events);
    murk_json_number(item, "number", event->number);
    cJSON_AddStringToObject(item, "kind", kind_name[event->kind]);
    cJSON_AddStringToObject(item, "partner", partner(r, event));
    if (has_outcome(event)) {
        cJSON_AddStringToObject(item, "outcome", outcome_name[event->outcome]);
    }
    murk_json_vector(item, "position_m",
                     murk_scene_user(r->session->scene, event->position));
    murk_json_vector(item, "direction_in", event->direction_in);
    murk_json_vector(item, "direction_out", event->direction_out);
    murk_json_number(item, "path_m", event->path_m);
}

static void on_event(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    const replay *r = context;
    if (event->photon != r->photon) {
        return;
    }
    if (r->events) {
        add_event(r, event);
    } else if (murk_session_speaks(r->session)) {
        print_event(r, event);
    }
}

murk_status murk_command_replay(const murk_options *options, murk_error *err)
{
    murk_session session;
    murk_ledger *ledger = NULL;
    cJSON *root = NULL;
    const uint64_t photon = murk_option_number(options, "--photon", 0);
    if (!murk_option_text(options, "--photon")) {
        return murk_fail(err, MURK_BAD_VALUE, "", "replay needs --photon N");
    }
    murk_status status = murk_session_begin(&session, options, err);
    if (status) {
        goto done;
    }
    /* The photon must be one that the scene emits. */
    const uint64_t emit = session.scene->photons.emit;
    if (emit && photon >= emit) {
        status =
            murk_fail(err, MURK_BAD_VALUE, "--photon",
                      "%llu, must be 0..%llu: the scene emits %llu",
                      (unsigned long long)photon,
                      (unsigned long long)(emit - 1), (unsigned long long)emit);
        goto done;
    }
    status = murk_ledger_create(&ledger, &session.stage->world, err);
    if (status) {
        goto done;
    }
    /* Events go to a table or to a JSON list. */
    replay r = {.session = &session, .photon = photon};
    if (options->json) {
        root = murk_json_begin(session.scene);
        murk_json_number(root, "photon", (double)photon);
        r.events = cJSON_AddArrayToObject(root, "events");
    } else if (murk_session_speaks(&session)) {
        murk_print("event kind            x m       y m       z m  direction "
                   "out            path m\n");
    }
    /* Trace the batch up to the photon; the sink drops all other photons. */
    murk_trace trace = murk_stage_trace(session.stage);
    trace.first = photon / MURK_BATCH_PHOTONS * MURK_BATCH_PHOTONS;
    trace.last = photon + 1;
    trace.sink = on_event;
    trace.context = &r;
    murk_trace_run(&trace, ledger);
    if (root) {
        status = murk_session_finish(&session, NULL, root, NULL, NULL, err);
        root = NULL;
    }
done:
    cJSON_Delete(root);
    murk_ledger_destroy(ledger);
    murk_session_end(&session);
    return status;
}
