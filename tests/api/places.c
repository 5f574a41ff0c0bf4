/* The place of an error that is a setting of a call, a key of the scene without
 * a line, or the path of a field of results: it stands in `where`, a key in
 * `key`, too, and `file` is empty. */
#include <murk.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Handles that the checks share. */
typedef struct given {
    murk_context *context;
    murk_scene *scene;
    murk_world *world;
    murk_light *light;
} given;

static const char *const keys[] = {"media.fog.albedo"};

static const char text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "media: {fog: {extinction_per_m: 0.1, albedo: 0.9, phase: {hg: 0.8}}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [2, 2, 2], power_w: 1}]\n"
    "photons: {emit: 1000}\n";

static int failures;

static void check(bool holds, const char *name, const char *problem)
{
    if (!holds) {
        fprintf(stderr, "%s: %s\n", name, problem);
        ++failures;
    }
}

static void check_place(const char *where, const char *key,
                        const murk_error *error)
{
    check(strcmp(error->where, where) == 0 && strcmp(error->key, key) == 0 &&
              !error->file[0] && error->line == 0,
          where, "is not the place of its error");
    if (strcmp(error->where, where) != 0) {
        fprintf(stderr, "the place is %s, the file %s, the key %s: %s\n",
                error->where, error->file, error->key, error->text);
    }
}

/* Settings of murk_world_check(). */
static void check_overview(const given *g)
{
    static const double inside_m[] = {2, 2, 1}, outside_m[] = {2, 2, 9};
    static const struct {
        const char *where;
        murk_check_options options;
    } cases[] = {{"picture", {.picture = "sheet.svg"}},
                 {"picture", {.picture = ".png"}},
                 {"pixels", {.pixels = {800, 600}}},
                 {"pixels", {.picture = "sheet.png", .pixels = {0, 600}}},
                 {"pixels", {.picture = "sheet.png", .pixels = {800, 400}}},
                 {"cut_m", {.cut_m = inside_m}},
                 {"cut_m", {.picture = "sheet.png", .cut_m = outside_m}},
                 {"ranks", {.ranks = 100001}}};
    /* Each case is refused at its setting, and leaves no fields. */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        murk_error error = MURK_ERROR_NONE;
        const murk_fields *fields = NULL;
        murk_check_options options = cases[i].options;
        options.size = sizeof options;
        check(murk_world_check(g->world, &options, NULL, &fields, &error) ==
                      MURK_BAD_VALUE &&
                  !fields,
              cases[i].where, "a check that failed has fields");
        check_place(cases[i].where, "", &error);
    }
}

static void check_settings(const given *g)
{
    static const struct {
        const char *where, *command;
        uint64_t runs;
        murk_save_options options;
    } saves[] = {
        {"exports", "trace", 0, {.exports = "pictures"}},
        {"voxel_m", "trace", 0, {.exports = "surfaces", .voxel_m = "wide"}},
        {"runs", "place", UINT64_MAX, {0}},
        {"command", "render", 0, {0}}};
    for (size_t i = 0; i < sizeof saves / sizeof *saves; ++i) {
        murk_error error = MURK_ERROR_NONE;
        murk_save_options options = saves[i].options;
        options.size = sizeof options;
        (void)murk_world_check_save(g->world, saves[i].command, saves[i].runs,
                                    NULL, &options, &error);
        check_place(saves[i].where, "", &error);
    }
    murk_error unsent = MURK_ERROR_NONE;
    const murk_fields *replay = NULL;
    (void)murk_world_replay(g->world, 1000, NULL, &replay, &unsent);
    check_place("photon", "", &unsent);
    check(!replay, "photon", "a replay that failed has fields");
    static const struct {
        const char *where;
        size_t n;
        murk_fit_options options;
    } fits[] = {{"loss", 1, {.loss = "cubic"}},
                {"next", 0, {.next = 1}},
                {"predict", 1, {.predict = "fit.json"}}};
    for (size_t i = 0; i < sizeof fits / sizeof *fits; ++i) {
        murk_error error = MURK_ERROR_NONE;
        murk_fit *fit = NULL;
        murk_fit_options options = fits[i].options;
        options.size = sizeof options;
        (void)murk_fit_create(&fit, g->scene, "no-such-data.csv", keys,
                              fits[i].n, &options, &error);
        check_place(fits[i].where, "", &error);
    }
    /* A field of results. */
    murk_error error = MURK_ERROR_NONE;
    const murk_fields *fields = NULL;
    double value;
    check(!murk_light_fields(g->light, &fields, NULL), "the light",
          "no fields");
    (void)murk_fields_double(fields, "photons.none", &value, &error);
    check_place("photons.none", "", &error);
}

/* Settings of a picture, and of its files. */
static void check_picture(murk_world *world)
{
    const murk_picture_options none = {.size = sizeof none, .camera = "none"},
                               view = {.size = sizeof view,
                                       .method = MURK_METHOD_PATHS,
                                       .from_sensor = 1};
    const murk_image_options heat = {.size = sizeof heat,
                                     .false_colour = "heat"};
    const murk_picture_options paths = {.size = sizeof paths,
                                        .method = MURK_METHOD_PATHS};
    murk_error error = MURK_ERROR_NONE;
    (void)murk_picture_check(world, &none, NULL, NULL, NULL, &error);
    check_place("camera", "", &error);
    error = (murk_error)MURK_ERROR_NONE;
    (void)murk_picture_check(world, &view, NULL, NULL, NULL, &error);
    check_place("from_sensor", "", &error);
    error = (murk_error)MURK_ERROR_NONE;
    (void)murk_picture_check(world, &paths, NULL, &heat, NULL, &error);
    check_place("false_colour", "", &error);
}

/* Settings of a context's functions. */
static void check_context(const given *g)
{
    const murk_profile_options wrong = {.size = sizeof wrong, .width_m = -1};
    const murk_fields *fields = NULL;
    murk_error width = MURK_ERROR_NONE, name = MURK_ERROR_NONE;
    murk_error key = MURK_ERROR_NONE, none = MURK_ERROR_NONE;
    (void)murk_context_profile_grid(g->context, "cast.csv", "cast.vdb", &wrong,
                                    NULL, &fields, &width);
    check_place("width_m", "", &width);
    check(!fields, "width_m", "a grid that failed has fields");
    (void)murk_context_reference(g->context, "scenery", &fields, &name);
    check_place("argument name", "", &name);
    (void)murk_context_reference(g->context, "scene.sensors.cuont", &fields,
                                 &key);
    check_place("sensors.cuont", "sensors.cuont", &key);
    check(!fields, "sensors.cuont", "a key that is unknown has fields");
    check(murk_context_reference(g->context, NULL, &fields, &none) ==
                  MURK_BAD_VALUE &&
              murk_context_reference(g->context, "scene", NULL, NULL) ==
                  MURK_BAD_VALUE,
          "reference", "takes NULL");
    /* A file of keys that is not there. */
    murk_error file = MURK_ERROR_NONE;
    check(murk_context_read_keys(g->context, "none.yaml", &fields, &file) ==
                  MURK_BAD_FILE &&
              strcmp(file.file, "none.yaml") == 0 && !fields,
          "none.yaml", "is not told");
    check(murk_context_read_keys(g->context, NULL, &fields, NULL) ==
                  MURK_BAD_VALUE &&
              murk_context_read_keys(g->context, "a.yaml", NULL, NULL) ==
                  MURK_BAD_VALUE,
          "keys of a file", "takes NULL");
    /* Options of a context that name no file, and two ways of progress. */
    const murk_context_options no_file = {.size = sizeof no_file,
                                          .n_inputs = 1};
    const murk_context_options no_mode = {.size = sizeof no_mode,
                                          .line = (murk_progress_mode)3};
    murk_context *refused = NULL;
    murk_error inputs = MURK_ERROR_NONE;
    (void)murk_context_create(&refused, &no_file, &inputs);
    check_place("argument options->inputs", "", &inputs);
    check(!refused &&
              murk_context_create(&refused, &no_mode, NULL) == MURK_BAD_VALUE,
          "context", "takes wrong options");
}

/* A key of a scene whose picture is asked for from the map that is left out. */
static void check_key(const given *g)
{
    murk_error error = MURK_ERROR_NONE;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    murk_picture *picture = NULL;
    if (murk_scene_parse(&scene, g->context, text, "text", &error) ||
        murk_scene_set(scene, "photons.maps", "surface", &error) ||
        murk_scene_set(scene, "cameras",
                       "[{name: a, from_m: [1, 1, 1], to_m: [2, 2, 1]}]",
                       &error) ||
        murk_world_create(&world, scene, &error) ||
        murk_light_trace(&light, world, &error)) {
        check(false, error.where, error.text);
    } else {
        (void)murk_picture_render(&picture, world, light, NULL, &error);
        check_place("photons.maps", "photons.maps", &error);
        check_picture(world);
    }
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
}

int main(void)
{
    given g = {0};
    if (murk_context_create(&g.context, NULL, NULL) ||
        murk_scene_parse(&g.scene, g.context, text, "text", NULL) ||
        murk_world_create(&g.world, g.scene, NULL) ||
        murk_light_trace(&g.light, g.world, NULL)) {
        fprintf(stderr, "the handles cannot be made\n");
        return 1;
    }
    check_settings(&g);
    check_overview(&g);
    check_context(&g);
    check_key(&g);
    murk_light_destroy(g.light);
    murk_world_destroy(g.world);
    murk_scene_destroy(g.scene);
    murk_context_destroy(g.context);
    return failures != 0;
}
