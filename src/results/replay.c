/* Traces one photon again and lists each event of the photon. A photon follows
 * from the seed, the scene and the number of the photon alone, so no earlier
 * batch is traced. The photons of the batch are traced up to this photon, and
 * the events of the others are dropped. */
#include "results/replay.h"

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

/* The number of an emitted photon has 32 bits, of which one value is not
 * used. */
#define PHOTON_MAX (UINT32_MAX - UINT64_C(1))

typedef struct replay {
    const murk_scene_desc *scene;
    uint64_t photon;
    cJSON *events;
} replay;

/* The name of the material or medium of an event, or the cause of a loss. */
static const char *partner(const murk_scene_desc *scene,
                           const murk_event *event)
{
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

/* A murk_event_sink. */
static void add_event(void *context, uint64_t batch, const murk_event *event)
{
    (void)batch;
    const replay *r = context;
    if (event->photon != r->photon) {
        return;
    }
    cJSON *item = murk_json_item(r->events);
    murk_json_number(item, "number", event->number);
    cJSON_AddStringToObject(item, "kind", kind_name[event->kind]);
    cJSON_AddStringToObject(item, "partner", partner(r->scene, event));
    if (has_outcome(event)) {
        cJSON_AddStringToObject(item, "outcome", outcome_name[event->outcome]);
    }
    murk_json_vector(item, "position_m",
                     murk_scene_user(r->scene, event->position));
    murk_json_vector(item, "direction_in", event->direction_in);
    murk_json_vector(item, "direction_out", event->direction_out);
    murk_json_number(item, "path_m", event->path_m);
}

/* With photons.store the number of emitted photons is not known beforehand. */
static murk_status check_number(const murk_scene_desc *scene, uint64_t photon,
                                murk_error *err)
{
    const uint64_t emit = scene->photons.emit;
    if (emit && photon >= emit) {
        return murk_fail(err, MURK_BAD_VALUE, "photon",
                         "%llu, must be 0..%llu: the scene emits %llu",
                         (unsigned long long)photon,
                         (unsigned long long)(emit - 1),
                         (unsigned long long)emit);
    }
    return photon <= PHOTON_MAX
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, "photon",
                           "%llu, must be 0..%llu", (unsigned long long)photon,
                           (unsigned long long)PHOTON_MAX);
}

murk_status murk_replay_json(cJSON **out, const murk_stage *stage,
                             uint64_t photon, murk_error *err)
{
    *out = NULL;
    murk_ledger *ledger = NULL;
    murk_status status = check_number(stage->scene, photon, err);
    if (!status) {
        status = murk_ledger_create(&ledger, &stage->world, err);
    }
    if (status) {
        return status;
    }
    /* The head of the JSON, then the batch up to the photon. */
    cJSON *root = murk_json_begin(stage->scene);
    murk_json_number(root, "photon", (double)photon);
    replay r = {.scene = stage->scene,
                .photon = photon,
                .events = cJSON_AddArrayToObject(root, "events")};
    murk_trace trace = murk_stage_trace(stage);
    trace.first = photon / MURK_BATCH_PHOTONS * MURK_BATCH_PHOTONS;
    trace.last = photon + 1;
    trace.sink = add_event;
    trace.context = &r;
    murk_trace_run(&trace, ledger);
    murk_ledger_destroy(ledger);
    *out = root;
    return MURK_OK;
}
