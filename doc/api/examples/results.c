/* Fields of results: typed values by path, and a walk over the names. */
#include "example.h"

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_plan *plan = NULL;
    const murk_fields *fields = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    must(murk_world_create(&world, scene, &error), &error);
    must(murk_plan_make(&plan, world, &error), &error);
    must(murk_plan_fields(plan, &fields, &error), &error);
    /* Values by their paths. */
    double z_m = 0;
    int64_t emitted = 0;
    bool is_optimal = false;
    const char *type = NULL;
    must(murk_fields_double(fields, "sensors.0.position_m.2", &z_m, &error),
         &error);
    must(murk_fields_int64(fields, "photons.emitted", &emitted, &error),
         &error);
    must(murk_fields_bool(fields, "bound.proven_optimal", &is_optimal, &error),
         &error);
    must(murk_fields_string(fields, "sensors.0.type", &type, &error), &error);
    printf("%s at %g m, %d photons, %s\n", type, z_m, (int)emitted,
           is_optimal ? "optimal" : "not proven");
    /* A sphere has no heading; a name that does not exist is another matter. */
    printf("absent: %d, unknown: %d\n",
           murk_fields_kind(fields, "sensors.0.heading_deg") ==
               MURK_FIELD_ABSENT,
           murk_fields_kind(fields, "sensors.7") == MURK_FIELD_UNKNOWN);
    /* The names of an object. */
    const size_t n = murk_fields_length(fields, "coverage");
    for (size_t i = 0; i < n && i < 2; ++i) {
        printf("coverage.%s\n", murk_fields_name(fields, "coverage", i));
    }
    printf("JSON: %c...\n", murk_fields_json(fields)[0]);
    murk_plan_destroy(plan);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * node at 1 m, 20000 photons, optimal
 * absent: 1, unknown: 1
 * coverage.in_sample
 * coverage.held_out
 * JSON: {...
 */
