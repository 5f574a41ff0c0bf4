/* A user's program in C that writes all that murk trace, place --repeat, sense,
 * study and fit write, into folders of the same names. run.sh compares the
 * files with those of the program, byte for byte. A picture is written and
 * removed again.
 *
 *     saves SCENE STUDY FIT-SCENE READINGS FOLDER */
#include "checks.h"

#include <string.h>

static murk_error error = MURK_ERROR_NONE;

static void must(murk_status status)
{
    must_be_ok(status, &error);
}

static const char *folder_of(const char *folder, const char *name)
{
    static char path[2][1024];
    static int k;
    k = 1 - k;
    snprintf(path[k], sizeof path[k], "%s/%s", folder, name);
    return path[k];
}

static murk_save_options exports(const char *words)
{
    murk_save_options options = {.size = sizeof options, .exports = words};
    return options;
}

/* The fields of a save: the main JSON, the summary, and the names of files. */
static void check_saved(const murk_fields *fields, const char *folder,
                        const char *main_json)
{
    const char *text = NULL, *last = NULL;
    char path[64];
    CHECK(fields && murk_fields_length(fields, "run.summary") > 0);
    must(murk_fields_string(fields, "saved.folder", &text, &error));
    CHECK(folder ? strcmp(text, folder) == 0 : !text);
    const size_t n = murk_fields_length(fields, "saved.files");
    CHECK(folder ? n > 2 : n == 0);
    if (n > 0) {
        snprintf(path, sizeof path, "saved.files.%zu", n - 1);
        must(murk_fields_string(fields, path, &last, &error));
        CHECK(strcmp(last, main_json) == 0);
    }
    must(murk_fields_string(fields, "identity", &text, &error));
    CHECK(strlen(text) == 64);
    CHECK(strstr(murk_fields_json(fields), "\n  \"run\": {"));
    CHECK(!strstr(murk_fields_json(fields), "\"saved\""));
}

/* Without fields a save writes the files, too. */
static void check_written(const char *folder, const char *name)
{
    char path[1100];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    CHECK(file);
    fclose(file);
}

/* The scene, with the number of photons of the commands that run.sh runs. */
static murk_world *world_of(murk_context *context, const char *path,
                            const char *light)
{
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    must(murk_scene_read(&scene, context, path, &error));
    if (light) {
        must(murk_scene_use_light(scene, light, &error));
    } else {
        must(murk_scene_set(scene, "photons.emit", "300", &error));
    }
    must(murk_world_create(&world, scene, &error));
    murk_scene_destroy(scene);
    return world;
}

static void trace_and_place(murk_context *context, const char *scene,
                            const char *out)
{
    murk_light *light = NULL;
    murk_plan *plan = NULL;
    const murk_fields *fields = NULL;
    const murk_save_options all = exports("fields, photons ,surfaces");
    murk_save_options more = exports("matrix");
    more.asked = "--repeat 2\n";
    murk_world *world = world_of(context, scene, NULL);
    const char *traced = folder_of(out, "trace"),
               *placed = folder_of(out, "place");
    /* What would be refused after the work is refused before. */
    must(murk_world_check_save(world, "trace", 0, traced, &all, &error));
    const murk_save_options wrong = exports("fields, nothing");
    murk_error why = MURK_ERROR_NONE;
    CHECK(murk_world_check_save(world, "trace", 0, traced, &wrong, &why) ==
          MURK_BAD_VALUE);
    CHECK(strcmp(why.where, "exports") == 0 && !strstr(why.text, "--"));
    CHECK(strstr(why.text, "\"nothing\" is not an export"));
    why = (murk_error)MURK_ERROR_NONE;
    CHECK(murk_world_check_save(world, "place", 4294967295, NULL, NULL, &why) ==
          MURK_BAD_VALUE);
    must(murk_light_trace(&light, world, &error));
    must(murk_light_save(light, NULL, NULL, &fields, &error));
    check_saved(fields, NULL, "ledger.json");
    must(murk_light_save(light, traced, &all, &fields, &error));
    check_saved(fields, traced, "ledger.json");
    /* The plan, and the same job with the next seed. */
    must(murk_plan_for_light(&plan, light, &error));
    must(murk_plan_save(plan, placed, &more, NULL, &error));
    check_written(placed, "plan.json");
    must(murk_plan_repeat(plan, 2, &error));
    must(murk_plan_save(plan, placed, &more, &fields, &error));
    check_saved(fields, placed, "plan.json");
    int64_t runs = 0;
    must(murk_fields_int64(fields, "repeat.runs", &runs, &error));
    CHECK(runs == 2);
    murk_plan_destroy(plan);
    murk_light_destroy(light);
    murk_world_destroy(world);
}

/* On stored light: the sensors of the plan. */
static void sense(murk_context *context, const char *scene, const char *out)
{
    char stored[1024];
    murk_light *light = NULL;
    murk_sensors *sensors = NULL;
    murk_coverage *coverage = NULL;
    const murk_fields *fields = NULL;
    snprintf(stored, sizeof stored, "%s", folder_of(out, "trace/light.murk"));
    murk_world *world = world_of(context, scene, stored);
    const char *sensed = folder_of(out, "sense");
    must(murk_sensors_read(&sensors, world, folder_of(out, "place/sensors.csv"),
                           &error));
    must(murk_light_read(&light, world, stored, &error));
    must(murk_coverage_measure(&coverage, light, sensors, &error));
    must(murk_coverage_save(coverage, sensed, NULL, &fields, &error));
    check_saved(fields, sensed, "coverage.json");
    murk_coverage_destroy(coverage);
    murk_sensors_destroy(sensors);
    murk_light_destroy(light);
    murk_world_destroy(world);
}

/* A picture by paths: refused values, then files and fields. */
static void take_picture(murk_context *context, const char *path,
                         const char *out)
{
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_picture *picture = NULL;
    const murk_fields *fields = NULL;
    const murk_picture_options view = {.size = sizeof view,
                                       .method = MURK_METHOD_PATHS,
                                       .width = 20,
                                       .height = 10,
                                       .samples = 2};
    const murk_image_options images = {
        .size = sizeof images, .png = true, .false_colour = "Z"};
    must(murk_scene_read(&scene, context, path, &error));
    must(murk_scene_set(scene, "cameras",
                        "[{name: a, from_m: [1, 1, 1], to_m: [2, 2, 1]}]",
                        &error));
    must(murk_world_create(&world, scene, &error));
    /* Values that are refused. */
    murk_picture_options wrong[] = {view, view, view, view};
    wrong[0].width = 0;
    wrong[1].samples = 65537;
    wrong[2].method = (murk_method)9;
    wrong[3].method = MURK_METHOD_MAPS;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        murk_error why = MURK_ERROR_NONE;
        CHECK(murk_picture_render(&picture, world, NULL, &wrong[i], &why) ==
                  MURK_BAD_VALUE &&
              !picture && strstr(why.where, "argument "));
    }
    murk_image_options false_range = images;
    false_range.has_range = true;
    CHECK(murk_picture_check(world, &view, NULL, &false_range, NULL, NULL) ==
          MURK_BAD_VALUE);
    CHECK(murk_picture_check(world, &view, "a.png", NULL, NULL, NULL) ==
          MURK_BAD_VALUE);
    CHECK(murk_picture_check(NULL, &view, NULL, NULL, NULL, NULL) ==
          MURK_BAD_VALUE);
    CHECK(murk_picture_save(NULL, NULL, NULL, NULL, &fields, NULL) ==
              MURK_BAD_VALUE &&
          !fields);
    /* Without files, then with them. */
    char *image = strdup(folder_of(out, "a.exr"));
    CHECK(image);
    must(murk_picture_check(world, &view, image, &images, NULL, &error));
    must(murk_picture_render(&picture, world, NULL, &view, &error));
    must(murk_picture_save(picture, NULL, NULL, NULL, &fields, &error));
    CHECK(murk_fields_kind(fields, "image") == MURK_FIELD_ABSENT);
    must(murk_picture_save(picture, image, &images, NULL, &fields, &error));
    CHECK(murk_fields_length(fields, "pixels") == 2);
    CHECK(murk_fields_length(fields, "mean_radiance") > 0);
    CHECK(murk_fields_length(fields, "saved.summary") > 3);
    const char *coloured = NULL;
    must(murk_fields_string(fields, "false_colour.image", &coloured, &error));
    FILE *file = fopen(coloured, "rb");
    CHECK(file);
    fclose(file);
    remove(coloured);
    remove(folder_of(out, "a.png"));
    remove(image);
    free(image);
    murk_picture_destroy(picture);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
}

static void run_study(murk_context *context, const char *path, const char *out)
{
    static const char *const key[] = {"photons.emit"}, *const value[] = {"200"};
    murk_study *study = NULL;
    const murk_fields *fields = NULL;
    const char *folder = folder_of(out, "study");
    const murk_study_options options = {.size = sizeof options,
                                        .folder = folder,
                                        .n = 1,
                                        .key = key,
                                        .value = value};
    must(murk_study_read(&study, context, path, &options, &error));
    must(murk_study_check_save(study, folder, NULL, &error));
    const murk_save_options none = exports("fields");
    murk_error why = MURK_ERROR_NONE;
    CHECK(murk_study_check_save(study, folder, &none, &why) == MURK_BAD_VALUE &&
          strcmp(why.where, "exports") == 0);
    must(murk_study_run(study, &error));
    must(murk_study_save(study, folder, NULL, &fields, &error));
    check_saved(fields, folder, "study.json");
    murk_study_destroy(study);
}

/* A page of a folder that is said not to be kept names neither the folder nor
 * its files. */
static void check_page(murk_context *context, const char *folder,
                       const char *out)
{
    const murk_save_options made = {.size = sizeof made,
                                    .made_by = "a program of a test"};
    static char text[1 << 20];
    char *page = strdup(folder_of(out, "page.html"));
    must(murk_context_write_report(context, folder, page, &made, NULL, &error));
    FILE *file = fopen(page, "rb");
    CHECK(file != NULL);
    const size_t size = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    text[size] = '\0';
    CHECK(strstr(text, "Results of a program of a test") != NULL);
    CHECK(strstr(text, "a program of a test makes them again") != NULL);
    CHECK(!strstr(text, "of the folder"));
    remove(page);
    free(page);
}

/* A fit with all its options, then predictions at its values and at those of
 * the scene. */
static void run_fit(murk_context *context, const char *path, const char *data,
                    const char *out)
{
    static const char *const key[] = {"media.fog.extinction_per_m"};
    static const char *const bounds[] = {"media.fog.extinction_per_m=0.001:5"};
    char values[1024];
    murk_scene *scene = NULL;
    murk_fit *fit = NULL;
    const murk_fields *fields = NULL;
    murk_fit_options options = {.size = sizeof options,
                                .n_bounds = 1,
                                .bounds = bounds,
                                .loss = "huber:2",
                                .starts = 1,
                                .traces = 2,
                                .next = 1};
    murk_save_options said = exports(NULL);
    must(murk_scene_read(&scene, context, path, &error));
    must(murk_scene_set(scene, "photons.emit", "2000", &error));
    must(murk_fit_create(&fit, scene, data, key, 1, &options, &error));
    CHECK(murk_fit_fields(fit, &fields, NULL) == MURK_BAD_VALUE);
    const char *folder = folder_of(out, "fit");
    said.asked = "--free media.fog.extinction_per_m\n"
                 "--bounds media.fog.extinction_per_m=0.001:5\n"
                 "--loss huber:2\n";
    must(murk_fit_check_save(fit, folder, &said, &error));
    murk_save_options none = exports(NULL);
    murk_error unused = MURK_ERROR_NONE;
    none.voxel_m = "1";
    CHECK(murk_fit_check_save(fit, folder, &none, &unused) == MURK_BAD_VALUE &&
          strcmp(unused.where, "voxel_m") == 0);
    must(murk_fit_run(fit, &error));
    must(murk_fit_save(fit, folder, &said, &fields, &error));
    check_saved(fields, folder, "fit.json");
    murk_fit_destroy(fit);
    check_page(context, folder, out);
    /* Predict. */
    snprintf(values, sizeof values, "%s", folder_of(out, "fit/fit.json"));
    const murk_fit_options predicts = {.size = sizeof predicts,
                                       .predict = values};
    must(murk_fit_create(&fit, scene, data, NULL, 0, &predicts, &error));
    must(murk_fit_run(fit, &error));
    folder = folder_of(out, "predict");
    must(murk_fit_save(fit, folder, NULL, &fields, &error));
    check_saved(fields, folder, "predict.json");
    murk_fit_destroy(fit);
    /* Predict at the values of the scene. */
    must(murk_fit_create(&fit, scene, data, NULL, 0, NULL, &error));
    must(murk_fit_run(fit, &error));
    folder = folder_of(out, "predict_scene");
    must(murk_fit_save(fit, folder, NULL, &fields, &error));
    check_saved(fields, folder, "predict.json");
    murk_fit_destroy(fit);
    murk_scene_destroy(scene);
}

int main(int argc, char **argv)
{
    CHECK(argc == 6);
    murk_context *context = NULL;
    must(murk_context_create(&context, NULL, &error));
    trace_and_place(context, argv[1], argv[5]);
    sense(context, argv[1], argv[5]);
    take_picture(context, argv[1], argv[5]);
    run_study(context, argv[2], argv[5]);
    run_fit(context, argv[3], argv[4], argv[5]);
    murk_context_destroy(context);
    return 0;
}
