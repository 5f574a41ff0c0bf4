/* The size with which a struct of murk.h begins: each struct that a caller
 * fills or lends is passed with sizes that are refused and with sizes that are
 * not. run.sh compares the structs of the table with those of the header.
 *
 * A struct of a newer header is an array of bytes, of which the first are the
 * struct that this header knows. */
#include <murk.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LARGEST 4096 /* bytes, behind which a size is taken for a mistake */
#define NEWER   64   /* bytes of the members of a newer header */

/* Handles that the calls share. */
typedef struct given {
    murk_context *context;
    murk_scene *scene;
    murk_world *world;
    murk_light *light;
} given;

static int failures;

static void check(bool holds, const char *name, size_t size, const char *text)
{
    if (!holds) {
        fprintf(stderr, "%s of size %zu: %s\n", name, size, text);
        ++failures;
    }
}

/* ---- calls that take a struct ---- */

/* Passes a struct. Returns MURK_OK also if the call fails for another reason,
 * which is MURK_BAD_FILE. */
typedef murk_status taker(const given *g, void *of, murk_error *error);

static murk_status take_context_options(const given *g, void *of,
                                        murk_error *error)
{
    (void)g;
    murk_context *context = NULL;
    const murk_status status = murk_context_create(&context, of, error);
    murk_context_destroy(context);
    return status;
}

static murk_status take_save_options(const given *g, void *of,
                                     murk_error *error)
{
    const murk_fields *fields = NULL;
    const murk_status status =
        murk_world_check_save(g->world, "trace", 0, NULL, of, error);
    murk_error again = MURK_ERROR_NONE;
    if (murk_light_save(g->light, NULL, of, &fields, &again) != status ||
        strcmp(again.text, error->text) != 0) {
        check(false, "murk_save_options", 0, again.text);
    }
    return status;
}

static murk_status take_preset_options(const given *g, void *of,
                                       murk_error *error)
{
    const murk_fields *fields = NULL;
    return murk_context_preset(g->context, NULL, NULL, NULL, 0, of, &fields,
                               error);
}

static murk_status take_page_options(const given *g, void *of,
                                     murk_error *error)
{
    const murk_status status = murk_context_write_report(
        g->context, "no-such-folder", NULL, of, NULL, error);
    return status == MURK_BAD_FILE ? MURK_OK : status;
}

static murk_status take_check_options(const given *g, void *of,
                                      murk_error *error)
{
    return murk_world_check(g->world, of, NULL, NULL, error);
}

static murk_status take_study_options(const given *g, void *of,
                                      murk_error *error)
{
    murk_study *study = NULL;
    const murk_status status =
        murk_study_read(&study, g->context, "no-such-study.yaml", of, error);
    return status == MURK_BAD_FILE ? MURK_OK : status;
}

static murk_status take_fit_options(const given *g, void *of, murk_error *error)
{
    static const char *const keys[] = {"media.fog.albedo"};
    murk_fit *fit = NULL;
    const murk_status status =
        murk_fit_create(&fit, g->scene, "no-such-data.csv", keys, 1, of, error);
    return status == MURK_BAD_FILE ? MURK_OK : status;
}

static murk_status take_profile_options(const given *g, void *of,
                                        murk_error *error)
{
    const murk_status status =
        murk_context_profile_grid(g->context, "no-such-profile.csv",
                                  "no-such-grid.vdb", of, NULL, NULL, error);
    return status == MURK_BAD_FILE ? MURK_OK : status;
}

static murk_status take_sensor(const given *g, void *of, murk_error *error)
{
    murk_sensors *sensors = NULL;
    murk_status status = murk_sensors_create(&sensors, g->world, error);
    if (!status) {
        status = murk_sensors_add(sensors, of, error);
    }
    murk_sensors_destroy(sensors);
    return status;
}

static murk_status take_picture_options(const given *g, void *of,
                                        murk_error *error)
{
    return murk_picture_check(g->world, of, NULL, NULL, NULL, error);
}

static murk_status take_image_options(const given *g, void *of,
                                      murk_error *error)
{
    return murk_picture_check(g->world, NULL, NULL, of, NULL, error);
}

static murk_status take_array(const given *g, void *of, murk_error *error)
{
    static const char *const heads[] = {"x_m", "y_m"};
    return murk_scene_add_table(g->scene, "places", heads, of, error);
}

/* ---- calls that fill a struct ---- */

static murk_status fill_sensor(const given *g, void *of, murk_error *error)
{
    const murk_sensor node = {.size = sizeof node, .type = "node"};
    murk_sensors *sensors = NULL;
    murk_status status = murk_sensors_create(&sensors, g->world, error);
    if (!status) {
        status = murk_sensors_add(sensors, &node, error);
    }
    if (!status) {
        status = murk_sensors_get(sensors, 0, of, error);
    }
    murk_sensors_destroy(sensors);
    return status;
}

static murk_status fill_array(const given *g, void *of, murk_error *error)
{
    return murk_light_array(g->light, MURK_MAP_SURFACE, "power_w", of, error);
}

/* ---- the table ---- */

static const double places[4] = {1, 2, 3, 4};
static const murk_context_options of_context = {.size = sizeof of_context};
static const murk_save_options of_save = {.size = sizeof of_save};
static const murk_check_options of_check = {.size = sizeof of_check};
static const murk_study_options of_study = {.size = sizeof of_study};
static const murk_fit_options of_fit = {.size = sizeof of_fit};
static const murk_picture_options of_picture = {.size = sizeof of_picture};
static const murk_image_options of_images = {.size = sizeof of_images};
static const murk_profile_options of_profile = {.size = sizeof of_profile};
static const murk_sensor of_sensor = {.size = sizeof of_sensor, .type = "node"};
static const murk_array of_array = {.size = sizeof of_array,
                                    .data = places,
                                    .type = MURK_TYPE_FLOAT64,
                                    .dimensions = 2,
                                    .shape = {2, 2},
                                    .stride = {16, 8}};

/* min_size: the smallest size that is taken. An older header has none of the
 * members behind the size, or has all members. */
static const struct {
    const char *name;
    taker *take;
    const void *of;
    size_t bytes, min_size;
    bool is_filled;
} rows[] = {{"murk_context_options", take_context_options, &of_context,
             sizeof of_context, sizeof(size_t), false},
            {"murk_save_options", take_save_options, &of_save, sizeof of_save,
             sizeof(size_t), false},
            {"murk_save_options", take_preset_options, &of_save, sizeof of_save,
             sizeof(size_t), false},
            {"murk_save_options", take_page_options, &of_save, sizeof of_save,
             sizeof(size_t), false},
            {"murk_check_options", take_check_options, &of_check,
             sizeof of_check, sizeof(size_t), false},
            {"murk_study_options", take_study_options, &of_study,
             sizeof of_study, sizeof(size_t), false},
            {"murk_fit_options", take_fit_options, &of_fit, sizeof of_fit,
             sizeof(size_t), false},
            {"murk_picture_options", take_picture_options, &of_picture,
             sizeof of_picture, sizeof(size_t), false},
            {"murk_image_options", take_image_options, &of_images,
             sizeof of_images, sizeof(size_t), false},
            {"murk_profile_options", take_profile_options, &of_profile,
             sizeof of_profile, sizeof(size_t), false},
            {"murk_sensor", take_sensor, &of_sensor, sizeof of_sensor,
             2 * sizeof(size_t), false},
            {"murk_array", take_array, &of_array, sizeof of_array,
             sizeof of_array, false},
            {"murk_sensor", fill_sensor, &of_sensor, sizeof of_sensor,
             sizeof of_sensor, true},
            {"murk_array", fill_array, &of_array, sizeof of_array,
             sizeof of_array, true}};

/* Passes the struct of row i with another size; `rest` is the value of the
 * bytes of a newer header. */
static murk_status pass(const given *g, size_t i, size_t size, int rest,
                        murk_error *error)
{
    void *of = malloc(LARGEST + NEWER);
    if (!of) {
        exit(1);
    }
    memset(of, rest, LARGEST + NEWER);
    memcpy(of, rows[i].of, rows[i].bytes);
    memcpy(of, &size, sizeof size);
    const murk_status status = rows[i].take(g, of, error);
    /* A struct that is filled keeps its size and what the library does not
     * know. */
    size_t after;
    memcpy(&after, of, sizeof after);
    check(after == size, rows[i].name, size, "the size was changed");
    for (size_t k = rows[i].bytes; k < LARGEST + NEWER; ++k) {
        if (((unsigned char *)of)[k] != (unsigned char)rest) {
            check(false, rows[i].name, size, "wrote behind the struct");
            break;
        }
    }
    free(of);
    return status;
}

static void check_refused(const given *g, size_t i, size_t size)
{
    char want[96];
    murk_error error = MURK_ERROR_NONE;
    snprintf(want, sizeof want, "size is %zu, must be sizeof(%s)", size,
             rows[i].name);
    check(pass(g, i, size, 0, &error) == MURK_BAD_VALUE, rows[i].name, size,
          "is not refused");
    check(strcmp(error.text, want) == 0, rows[i].name, size, error.text);
    check(strncmp(error.where, "argument ", 9) == 0, rows[i].name, size,
          error.where);
}

static void check_taken(const given *g, size_t i, size_t size, int rest)
{
    murk_error error = MURK_ERROR_NONE;
    check(pass(g, i, size, rest, &error) == MURK_OK, rows[i].name, size,
          error.text);
}

static void check_row(const given *g, size_t i)
{
    const size_t bytes = rows[i].bytes, min_size = rows[i].min_size;
    /* No size of any version. */
    check_refused(g, i, 0);
    check_refused(g, i, 4);
    check_refused(g, i, bytes - 1);
    check_refused(g, i, bytes + 1);
    check_refused(g, i, LARGEST + sizeof(size_t));
    check_refused(g, i, SIZE_MAX - 7);
    /* This header, an older one, and a newer one without its members. */
    check_taken(g, i, bytes, 0x5a);
    check_taken(g, i, min_size, 0x5a);
    check_taken(g, i, bytes + NEWER, 0);
    check_taken(g, i, LARGEST, 0);
    /* A newer header with a member. */
    murk_error error = MURK_ERROR_NONE;
    const murk_status status = pass(g, i, bytes + NEWER, 1, &error);
    check(status == (rows[i].is_filled ? MURK_OK : MURK_UNSUPPORTED),
          rows[i].name, bytes + NEWER, error.text);
    check(rows[i].is_filled || strstr(error.text, "newer murk.h"), rows[i].name,
          bytes + NEWER, error.text);
}

/* The error of a caller of an older header, of a newer one, and without a
 * size. */
static void check_error(const given *g)
{
    const size_t sizes[] = {0, offsetof(murk_error, text), sizeof(murk_error),
                            sizeof(murk_error) + NEWER};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        struct {
            murk_error error;
            char newer[NEWER];
        } of = {.error = {.size = sizes[i]}};
        check(murk_scene_set(g->scene, "no.such.key", "1", &of.error) ==
                  MURK_BAD_VALUE,
              "murk_error", sizes[i], "the call did not fail");
        check(of.error.size == sizes[i] && of.error.code == MURK_BAD_VALUE &&
                  of.error.where[0],
              "murk_error", sizes[i], "is not filled");
        check((of.error.text[0] != '\0') ==
                  (sizes[i] != offsetof(murk_error, text)),
              "murk_error", sizes[i], "has or lacks the last member");
        check(of.newer[0] == '\0', "murk_error", sizes[i],
              "wrote behind the struct");
    }
}

/* The library gives the size of the struct that it passes to a function of the
 * caller. */
static size_t progress_size;

static void hear(void *user, const murk_progress *progress)
{
    (void)user;
    progress_size = progress->size;
}

static void check_progress(void)
{
    const murk_context_options options = {.size = sizeof options,
                                          .progress = hear};
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    if (murk_context_create(&context, &options, NULL) ||
        murk_scene_parse(
            &scene, context,
            "murk: 1\ndomain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
            "lights: [{type: point, position_m: [2, 2, 2], power_w: 1}]\n",
            "text", NULL) ||
        murk_world_create(&world, scene, NULL)) {
        check(false, "murk_progress", 0, "no world");
    }
    check(progress_size == sizeof(murk_progress), "murk_progress",
          progress_size, "is not the size");
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
}

int main(void)
{
    static const char text[] =
        "murk: 1\n"
        "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
        "geometry: [{box: {min_m: [0, 0, 0], max_m: [4, 4, 3]}}]\n"
        "materials: {default: {diffuse: 0.5}}\n"
        "media: {fog: {extinction_per_m: 0.1, albedo: 0.9, phase: {hg: 0.8}}}\n"
        "regions: [{medium: fog}]\n"
        "lights: [{type: point, position_m: [2, 2, 2], power_w: 1}]\n"
        "sensors: {types: [{name: node, range_m: 3}], count: 1}\n"
        "cameras: [{name: a, from_m: [1, 1, 1], to_m: [2, 2, 1]}]\n"
        "photons: {emit: 1000}\n";
    /* The handles, then all rows. */
    given g = {0};
    if (murk_context_create(&g.context, NULL, NULL) ||
        murk_scene_parse(&g.scene, g.context, text, "text", NULL) ||
        murk_world_create(&g.world, g.scene, NULL) ||
        murk_light_trace(&g.light, g.world, NULL)) {
        fprintf(stderr, "the handles of the table cannot be made\n");
        return 1;
    }
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        check_row(&g, i);
    }
    check_error(&g);
    check_progress();
    murk_light_destroy(g.light);
    murk_world_destroy(g.world);
    murk_scene_destroy(g.scene);
    murk_context_destroy(g.context);
    return failures != 0;
}
