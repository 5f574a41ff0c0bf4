/* Light: records as views and in batches while light is traced, a tally, the
 * energy ledger, light.murk, and light in parts. */
#include "example.h"

/* The sum of a field of floats, n long. */
static double sum_of(const murk_array *view)
{
    double sum = 0;
    for (size_t i = 0; i < view->shape[0]; ++i) {
        sum += *(const float *)((const char *)view->data +
                                (ptrdiff_t)i * view->stride[0]);
    }
    return sum;
}

/* Counts the records of the first ten batches, then cancels. */
static int receive(void *user, murk_batch *batch)
{
    size_t *records = user;
    uint64_t photons[2];
    murk_array emitted = {.size = sizeof emitted};
    murk_batch_photons(batch, photons);
    if (murk_batch_array(batch, MURK_MAP_VOLUME, "emitted", &emitted, NULL)) {
        return 1;
    }
    *records += murk_batch_count(batch, MURK_MAP_VOLUME);
    if (murk_batch_number(batch) < 9) {
        return 0;
    }
    printf("%d photons, some records: %s\n", (int)photons[1] + 1,
           *records > 0 ? "yes" : "no");
    return 1;
}

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL, *again = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_world_create(&world, scene, &error), &error);
    must(murk_light_trace(&light, world, &error), &error);
    /* Power is a view into the records, the direction a copy. */
    murk_array power = {.size = sizeof power},
               direction = {.size = sizeof direction};
    must(murk_light_array(light, MURK_MAP_VOLUME, "power_w", &power, &error),
         &error);
    must(murk_light_array(light, MURK_MAP_VOLUME, "direction", &direction,
                          &error),
         &error);
    printf("power_w is a %s, direction is a %s of n x %zu\n",
           power.is_copy ? "copy" : "view", direction.is_copy ? "copy" : "view",
           direction.shape[1]);
    printf("scattered: %.0f W\n", sum_of(&power));
    /* The tally: band x i x j x k. */
    murk_array values = {.size = sizeof values},
               errors = {.size = sizeof errors};
    must(murk_light_tally(light, "box", &values, &errors, &error), &error);
    printf("tally of %zu x %zu x %zu cells\n", values.shape[1], values.shape[2],
           values.shape[3]);
    /* The ledger of energy is exact. */
    const murk_fields *ledger = NULL;
    double emitted_w = 0;
    int64_t imbalance = 0;
    must(murk_light_fields(light, &ledger, &error), &error);
    must(murk_fields_double(ledger, "emitted_w.total", &emitted_w, &error),
         &error);
    must(murk_fields_int64(ledger, "imbalance_quanta", &imbalance, &error),
         &error);
    printf("emitted: %g W, imbalance: %d\n", emitted_w, (int)imbalance);
    /* light.murk, which a later run reads; and the files of murk trace. */
    must(murk_light_write(light, "light.murk", &error), &error);
    must(murk_light_read(&again, world, "light.murk", &error), &error);
    printf("the same number of records: %s\n",
           murk_light_count(again, MURK_MAP_VOLUME) == power.shape[0] ? "yes"
                                                                      : "no");
    must(murk_light_save(light, "results", NULL, NULL, &error), &error);
    murk_light_destroy(again);
    /* The light in two parts, as two machines would trace it. */
    static const char *const part[] = {"1.part", "2.part"};
    must(murk_light_trace_part(world, 1, 2, part[0], &error), &error);
    must(murk_light_trace_part(world, 2, 2, part[1], &error), &error);
    must(murk_light_merge(&again, world, part, 2, &error), &error);
    printf("the parts have as many records: %s\n",
           murk_light_count(again, MURK_MAP_VOLUME) == power.shape[0] ? "yes"
                                                                      : "no");
    murk_light_destroy(again);
    /* A trace that goes on from its last minute if the program was killed. */
    must(murk_light_trace_resume(&again, world, "checkpoint.part", 60, &error),
         &error);
    (void)remove("checkpoint.part");
    murk_light_destroy(again);
    /* Light in batches; the function of the program cancels. */
    size_t records = 0;
    const murk_status status =
        murk_light_stream(&again, world, receive, &records, NULL);
    printf("%s\n", murk_status_text(status));
    printf("packet of the lamp: %g W\n", murk_light_packet_w(light, 0, 0));
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * power_w is a view, direction is a copy of n x 3
 * scattered: 10 W
 * tally of 4 x 3 x 2 cells
 * emitted: 20 W, imbalance: 0
 * the same number of records: yes
 * the parts have as many records: yes
 * 10240 photons, some records: yes
 * interrupted
 * packet of the lamp: 0.001 W
 */
