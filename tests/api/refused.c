/* A constructor that is refused leaves NULL in *out and a message in the error:
 * tables of all functions of murk.h that have an `out`, each called with an
 * argument that is NULL, and with a value that its work refuses, if there is
 * one. The message tells the two cases apart. run.sh compares the tables with
 * the header. */
#include <murk.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Handles that the calls of the table share. */
typedef struct given {
    murk_context *context;
    murk_scene *wrong;  /* the key photons.emit is wrong */
    murk_scene *scene;  /* with sensors, and too small a photons.max_stored */
    murk_world *small;  /* of that scene */
    murk_world *world;  /* of the scene before both keys were set */
    murk_light *light;  /* of the world */
    murk_sensors *none; /* an empty list of sensors of the world */
} given;

static const char *const keys[] = {"media.fog.albedo"};
static const char *const no_parts[] = {"no-such.part"};
static const double place[3];

/* Cancels a trace. */
static int cancel(void *user, murk_batch *batch)
{
    (void)user;
    (void)batch;
    return 1;
}

/* X(handle, function, call with NULL, call that the work refuses, a part of the
 * message of that); the calls may use g, out and error. */
#define CONSTRUCTORS(X)                                                        \
    X(scene, murk_scene_read, (&out, g->context, NULL, &error),                \
      (&out, g->context, "no-such-scene.yaml", &error), "cannot read")         \
    X(scene, murk_scene_parse, (&out, g->context, NULL, NULL, &error),         \
      (&out, g->context, "murk: [", "text", &error), "not YAML")               \
    X(world, murk_world_create, (&out, NULL, &error),                          \
      (&out, g->wrong, &error), "many, must be")                               \
    X(light, murk_light_trace, (&out, NULL, &error), (&out, g->small, &error), \
      "max_stored allows 1")                                                   \
    X(light, murk_light_stream, (&out, g->world, NULL, NULL, &error),          \
      (&out, g->world, cancel, NULL, &error), "stopped by the function")       \
    X(light, murk_light_read, (&out, g->world, NULL, &error),                  \
      (&out, g->world, "no-such-light.murk", &error), "cannot read")           \
    X(light, murk_light_trace_resume, (&out, g->world, NULL, 1, &error),       \
      (&out, g->world, "none.part", -1, &error), "every_s is below 0")         \
    X(light, murk_light_merge, (&out, g->world, NULL, 1, &error),              \
      (&out, g->world, no_parts, 1, &error), "cannot read")                    \
    X(sensors, murk_sensors_read, (&out, g->world, NULL, &error),              \
      (&out, g->small, "no-such-sensors.csv", &error), "cannot read")          \
    X(coverage, murk_coverage_measure, (&out, g->light, NULL, &error),         \
      (&out, g->light, g->none, &error), "no sensors")                         \
    X(plan, murk_plan_make, (&out, NULL, &error), (&out, g->world, &error),    \
      "the scene has none")                                                    \
    X(plan, murk_plan_for_light, (&out, NULL, &error),                         \
      (&out, g->light, &error), "the scene has none")                          \
    X(plan, murk_plan_for_matrix, (&out, NULL, NULL, NULL, NULL, &error),      \
      (&out, g->scene, "no-such-matrix.csv", NULL, NULL, &error),              \
      "has a text, must be a scene of murk_scene_create()")                    \
    X(study, murk_study_read, (&out, g->context, NULL, NULL, &error),          \
      (&out, g->context, "no-such-study.yaml", NULL, &error), "cannot read")   \
    X(world, murk_world_move, (&out, g->world, NULL, place, NULL, &error),     \
      (&out, g->world, "no-such-item", place, NULL, &error), "no-such-item")   \
    X(light, murk_light_update, (&out, g->light, NULL, &error),                \
      (&out, g->light, g->small, &error), "max_stored allows 1")               \
    X(coverage, murk_coverage_update, (&out, NULL, g->light, &error),          \
      (&out, NULL, g->light, &error), "is NULL")                               \
    X(plan, murk_plan_update, (&out, NULL, g->light, &error),                  \
      (&out, NULL, g->light, &error), "is NULL")                               \
    X(follow, murk_follow_create, (&out, NULL, NULL, NULL, &error),            \
      (&out, g->scene, NULL, NULL, &error), "has no timeline")                 \
    X(fit, murk_fit_create, (&out, g->scene, NULL, keys, 1, NULL, &error),     \
      (&out, g->scene, "no-such-data.csv", keys, 1, NULL, &error),             \
      "cannot read")                                                           \
    X(picture, murk_picture_render, (&out, NULL, NULL, NULL, &error),          \
      (&out, g->world, g->light, NULL, &error), "cameras: the scene has none")

/* Without memory alone the work of these fails. */
#define WITHOUT_WORK(X)                                   \
    X(context, murk_context_create, (NULL, NULL, &error)) \
    X(scene, murk_scene_create, (&out, NULL, &error))     \
    X(sensors, murk_sensors_create, (&out, NULL, &error)) \
    X(sensors, murk_plan_sensors, (&out, NULL, &error))

static int failures;

static void check(bool holds, const char *function, const char *text)
{
    if (!holds) {
        fprintf(stderr, "%s: %s\n", function, text);
        ++failures;
    }
}

/* One call: *out is any address but NULL before, and NULL afterwards. A context
 * is refused without an `out` alone. */
#define CALL(handle, function, arguments, part)                                \
    do {                                                                       \
        murk_error error = MURK_ERROR_NONE;                                    \
        murk_##handle *out = (void *)&failures;                                \
        const murk_status status = function arguments;                         \
        check(status != MURK_OK, #function, "is not refused");                 \
        check(error.code == status && error.text[0], #function, "no message"); \
        check(strstr(error.text, part) != NULL, #function, error.text);        \
        check(!out || strcmp(#handle, "context") == 0, #function,              \
              "*out is not NULL");                                             \
    } while (0);

#define WITH_NULL(handle, function, arguments) \
    CALL(handle, function, arguments, "NULL")
#define BOTH(handle, function, with_null, refused, part) \
    CALL(handle, function, with_null, "NULL")            \
    CALL(handle, function, refused, part)

static void call_all(const given *g)
{
    CONSTRUCTORS(BOTH)
    WITHOUT_WORK(WITH_NULL)
}

/* A list of texts with NULL in it, or NULL in place of the list. */
static void pass_null_texts(const given *g)
{
    static const char *const none[] = {"seed", NULL};
    static const murk_study_options studies[] = {
        {.size = sizeof *studies, .n = 2},
        {.size = sizeof *studies, .n = 1, .key = none},
        {.size = sizeof *studies, .n = 1, .value = none},
        {.size = sizeof *studies, .n = 2, .key = none, .value = none},
        {.size = sizeof *studies, .n = 1, .key = none, .value = none + 1},
        {.size = sizeof *studies, .parts = 1},
        {.size = sizeof *studies, .parts = 2, .part = none}};
    for (size_t i = 0; i < sizeof studies / sizeof *studies; ++i) {
        WITH_NULL(study, murk_study_read,
                  (&out, g->context, "no-such-study.yaml", &studies[i], &error))
    }
    /* Bounds and keys of a fit. */
    static const murk_fit_options fits[] = {
        {.size = sizeof *fits, .n_bounds = 1},
        {.size = sizeof *fits, .n_bounds = 1, .bounds = none + 1}};
    for (size_t i = 0; i < sizeof fits / sizeof *fits; ++i) {
        WITH_NULL(
            fit, murk_fit_create,
            (&out, g->scene, "no-such-data.csv", keys, 1, &fits[i], &error))
    }
    WITH_NULL(fit, murk_fit_create,
              (&out, g->scene, "no-such-data.csv", none, 2, NULL, &error))
    WITH_NULL(fit, murk_fit_create,
              (&out, g->scene, "no-such-data.csv", NULL, 2, NULL, &error))
}

/* A list of 0 elements is empty, also if it has a pointer, here to a list with
 * NULL in it. The files of studies and fits are missing, which is found after
 * the lists are read. */
static void pass_empty_lists(const given *g)
{
    static const char *const none[] = {NULL};
    static const murk_study_options study = {
        .size = sizeof study, .key = none, .value = none, .part = none};
    static const murk_fit_options fit = {.size = sizeof fit, .bounds = none};
    CALL(study, murk_study_read,
         (&out, g->context, "no-such-study.yaml", &study, &error),
         "cannot read")
    CALL(fit, murk_fit_create,
         (&out, g->scene, "no-such-data.csv", keys, 1, &fit, &error),
         "cannot read")
    CALL(fit, murk_fit_create,
         (&out, g->scene, "no-such-data.csv", none, 0, NULL, &error),
         "cannot read")
    CALL(fit, murk_fit_create,
         (&out, g->scene, "no-such-data.csv", NULL, 0, NULL, &error),
         "cannot read")
}

/* One call with a list: `part` of the message, or NULL if it is not refused. */
static void check_list(const char *function, murk_status status,
                       const murk_error *error, const char *part)
{
    if (!part) {
        check(status == MURK_OK, function, error->text);
        return;
    }
    check(status == MURK_BAD_VALUE, function, "a list is not refused");
    check(strstr(error->text, part) != NULL, function, error->text);
}

/* The lists of the arrays of a scene: names of materials, and columns. */
static void add_lists(const given *g)
{
    static const float corners[9] = {1, 0, 0, 1, 1, 0, 1, 0, 1};
    static const uint32_t indices[3] = {0, 1, 2};
    static const char *const none[] = {NULL}, *const wall[] = {"wall", NULL};
    static const struct {
        const char *const *names;
        size_t n;
        const char *part; /* of the message; NULL: is not refused */
    } meshes[] = {{NULL, 0, NULL},
                  {none, 0, NULL},
                  {wall, 1, NULL},
                  {NULL, 1, "is NULL, must be 1 texts"},
                  {wall, 2, "element 1 of 2 is NULL"}},
      tables[] = {{wall, 1, NULL},
                  {NULL, 1, "is NULL, must be 1 texts"},
                  {wall, 2, "element 1 of 2 is NULL"}};
    const murk_array vertices = murk_array_of(corners, MURK_TYPE_FLOAT32, 2,
                                              (const size_t[]){3, 3}),
                     triangles = murk_array_of(indices, MURK_TYPE_UINT32, 2,
                                               (const size_t[]){1, 3});
    for (size_t i = 0; i < sizeof meshes / sizeof *meshes; ++i) {
        murk_error error = MURK_ERROR_NONE;
        const murk_status status = murk_scene_add_mesh(
            g->scene, "wall", &vertices, &triangles, NULL, meshes[i].names,
            meshes[i].n, NULL, NULL, &error);
        check_list("murk_scene_add_mesh", status, &error, meshes[i].part);
    }
    for (size_t i = 0; i < sizeof tables / sizeof *tables; ++i) {
        murk_error error = MURK_ERROR_NONE;
        const murk_array values = murk_array_of(
            corners, MURK_TYPE_FLOAT32, 2, (const size_t[]){2, tables[i].n});
        const murk_status status = murk_scene_add_table(
            g->scene, "list", tables[i].names, &values, &error);
        check_list("murk_scene_add_table", status, &error, tables[i].part);
    }
    /* Arrays are lists of values: data NULL, and no shape. */
    murk_error error = MURK_ERROR_NONE;
    murk_array values =
        murk_array_of(NULL, MURK_TYPE_FLOAT32, 2, (const size_t[]){2, 1});
    check_list("murk_scene_add_table",
               murk_scene_add_table(g->scene, "list", wall, &values, &error),
               &error, "data is NULL");
    error = (murk_error)MURK_ERROR_NONE;
    values = murk_array_of(corners, MURK_TYPE_FLOAT32, 2, NULL);
    check_list("murk_scene_add_table",
               murk_scene_add_table(g->scene, "list", wall, &values, &error),
               &error, "has 0 dimensions");
}

/* Saving that is refused leaves NULL in *fields, and so does a look over no
 * world. */
#define SAVE(handle)                                                       \
    do {                                                                   \
        murk_error error = MURK_ERROR_NONE;                                \
        const murk_fields *fields = (const void *)&failures;               \
        check(murk_##handle##_save(NULL, NULL, NULL, &fields, &error) ==   \
                      MURK_BAD_VALUE &&                                    \
                  !fields && error.text[0],                                \
              "murk_" #handle "_save", "is not refused without a handle"); \
    } while (0)

static void save_all(void)
{
    SAVE(light);
    SAVE(coverage);
    SAVE(plan);
    SAVE(study);
    SAVE(fit);
    murk_error error = MURK_ERROR_NONE;
    const murk_fields *fields = (const void *)&failures;
    check(murk_world_check(NULL, NULL, NULL, &fields, &error) ==
                  MURK_BAD_VALUE &&
              !fields && error.text[0],
          "murk_world_check", "is not refused without a world");
}

int main(void)
{
    static const char text[] =
        "murk: 1\n"
        "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
        "media: {fog: {extinction_per_m: 0.1, albedo: 0.9, phase: {hg: 0.8}}}\n"
        "regions: [{medium: fog}]\n"
        "lights: [{type: point, position_m: [2, 2, 2], power_w: 1}]\n"
        "photons: {emit: 1000}\n";
    /* The handles, then all calls. */
    given g = {0};
    if (murk_context_create(&g.context, NULL, NULL) ||
        murk_scene_parse(&g.scene, g.context, text, "text", NULL) ||
        murk_world_create(&g.world, g.scene, NULL) ||
        murk_light_trace(&g.light, g.world, NULL) ||
        murk_sensors_create(&g.none, g.world, NULL) ||
        murk_scene_set(g.scene, "photons.max_stored", "1", NULL) ||
        murk_scene_set(g.scene, "sensors",
                       "{types: [{name: node, range_m: 3}], count: 1}", NULL) ||
        murk_world_create(&g.small, g.scene, NULL) ||
        murk_scene_parse(&g.wrong, g.context, text, "text", NULL) ||
        murk_scene_set(g.wrong, "photons.emit", "many", NULL)) {
        fprintf(stderr, "the handles of the table cannot be made\n");
        return 1;
    }
    call_all(&g);
    pass_null_texts(&g);
    pass_empty_lists(&g);
    add_lists(&g);
    save_all();
    murk_sensors_destroy(g.none);
    murk_light_destroy(g.light);
    murk_world_destroy(g.small);
    murk_world_destroy(g.world);
    murk_scene_destroy(g.wrong);
    murk_scene_destroy(g.scene);
    murk_context_destroy(g.context);
    return failures != 0;
}
