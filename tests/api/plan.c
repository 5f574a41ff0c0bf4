/* A user's program in C: a hall with a lamp from text, a crate from arrays, a
 * plume from a grid of the program, and the places of two sensors in it. Built
 * against an installed murk, it fails with a line on the first thing that is
 * not as it should be. */
#include <murk.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(condition)                                                    \
    do {                                                                    \
        if (!(condition)) {                                                 \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
            exit(1);                                                        \
        }                                                                   \
    } while (0)

/* Ends the program with the message of an error. */
static void must(murk_status status, const murk_error *error)
{
    if (status) {
        fprintf(stderr, "%s: %s: %s\n", murk_status_text(status), error->where,
                error->text);
        exit(1);
    }
}

static const char hall[] =
    "murk: 1\n"
    "bands_nm: [532]\n"
    "domain: {min_m: [0, 0, 0], max_m: [8, 6, 3]}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [0, 0, 0], edge1_m: [8, 0, 0], edge2_m: [0, 6, "
    "0]}}\n"
    "materials: {default: {diffuse: 0.5}, crate: {diffuse: 0.2}}\n"
    "lights: [{type: sphere, center_m: [4, 3, 2.8], radius_m: 0.05, "
    "power_w: 20}]\n"
    "photons: {emit: 20000}\n"
    "tallies: [{name: box, type: grid, min_m: [0, 0, 0], max_m: [8, 6, 3], "
    "size: [4, 3, 2]}]\n"
    "sensors:\n"
    "  types: [{name: node, range_m: 6}]\n"
    "  candidates: {grid: {min_m: [1, 1, 1], max_m: [7, 5, 2], "
    "size: [4, 3, 2]}}\n"
    "  count: 1\n";

static const float box[8][3] = {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0},
                                {1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}};
static const uint32_t sides[12][3] = {
    {0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
    {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

static int releases;

static void release(void *user)
{
    free(user);
    ++releases;
}

static int warnings;

static void hear(void *user, bool is_warning, const char *where,
                 const char *text)
{
    (void)where;
    CHECK(user == (void *)&warnings && text[0]);
    warnings += is_warning;
}

/* The scene: text, a mesh, a grid that is used in place, and keys. */
static murk_scene *make_scene(murk_context *context)
{
    murk_error error = MURK_ERROR_NONE;
    murk_scene *scene = NULL;
    must(murk_scene_parse(&scene, context, hall, "room.yaml", &error), &error);
    const size_t vertices[2] = {8, 3}, triangles[2] = {12, 3};
    const murk_array v = murk_array_of(box, MURK_TYPE_FLOAT32, 2, vertices),
                     t = murk_array_of(sides, MURK_TYPE_UINT32, 2, triangles);
    const char *const names[] = {"crate"};
    must(murk_scene_add_mesh(scene, "crate", &v, &t, NULL, names, 1, NULL, NULL,
                             &error),
         &error);
    /* A plume of 16 x 8 x 4 cells of a quarter of a metre, x fastest. */
    const size_t n = 16 * 8 * 4;
    float *values = malloc(n * sizeof *values);
    CHECK(values);
    for (size_t i = 0; i < n; ++i) {
        values[i] = i % 16 < 8 ? 0.5F : 0;
    }
    murk_array plume = {.size = sizeof plume,
                        .data = values,
                        .type = MURK_TYPE_FLOAT32,
                        .dimensions = 3,
                        .shape = {16, 8, 4},
                        .stride = {4, 64, 512}};
    const double place[12] = {.25, 0,     0, 2.125, 0,   .25,
                              0,   3.125, 0, 0,     .25, .125};
    must(murk_scene_add_grid(scene, "plume", &plume, place, release, values,
                             &error),
         &error);
    must(murk_scene_set(scene, "geometry",
                        "[{rect: {corner_m: [0, 0, 0], edge1_m: [8, 0, 0], "
                        "edge2_m: [0, 6, 0]}}, {file: memory:crate}]",
                        &error),
         &error);
    must(murk_scene_set(scene, "media",
                        "{smoke: {vdb: memory:plume, extinction_per_m: 1, "
                        "albedo: 0.5, phase: isotropic}}",
                        &error),
         &error);
    must(murk_scene_set(scene, "regions", "[{medium: smoke}]", &error), &error);
    must(murk_scene_set(scene, "sensors.count", "2", &error), &error);
    return scene;
}

/* Records, their unpacked fields, the energy ledger and the tally. */
static void check_light(murk_light *light)
{
    murk_error error = MURK_ERROR_NONE;
    murk_array power = {.size = sizeof power}, normal = {.size = sizeof normal},
               values = {.size = sizeof values},
               errors = {.size = sizeof errors};
    const murk_fields *fields = NULL;
    must(murk_light_array(light, MURK_MAP_SURFACE, "power_w", &power, &error),
         &error);
    CHECK(power.shape[0] == murk_light_count(light, MURK_MAP_SURFACE) &&
          power.shape[0] > 1000 && !power.is_copy);
    double sum_w = 0;
    for (size_t i = 0; i < power.shape[0]; ++i) {
        sum_w += (double)*(const float *)((const char *)power.data +
                                          (ptrdiff_t)i * power.stride[0]);
    }
    CHECK(sum_w > 0 && sum_w < 40);
    must(murk_light_array(light, MURK_MAP_SURFACE, "normal", &normal, &error),
         &error);
    CHECK(normal.is_copy && normal.dimensions == 2 && normal.shape[1] == 3);
    const float *first = normal.data;
    CHECK(fabs((double)(first[0] * first[0] + first[1] * first[1] +
                        first[2] * first[2]) -
               1) < 1e-3);
    CHECK(murk_light_count(light, MURK_MAP_VOLUME) > 100);
    /* 20 W leave the lamp, and none is lost. */
    int64_t imbalance = 1;
    double emitted = 0;
    must(murk_light_fields(light, &fields, &error), &error);
    must(murk_fields_double(fields, "emitted_w.total", &emitted, &error),
         &error);
    must(murk_fields_int64(fields, "imbalance_quanta", &imbalance, &error),
         &error);
    CHECK(fabs(emitted - 20) < 1e-9 && imbalance == 0);
    /* The grid of the tally: one band, 4 x 3 x 2 cells. */
    must(murk_light_tally(light, "box", &values, &errors, &error), &error);
    CHECK(values.dimensions == 4 && values.shape[0] == 1 &&
          values.shape[1] == 4 && values.shape[2] == 3 && values.shape[3] == 2);
    const double value = *(const double *)values.data,
                 one_error = *(const double *)errors.data;
    CHECK(value > 0 && one_error > 0 && one_error < value);
}

/* The plan, and the same sensors measured again. */
static void check_plan(murk_light *light, murk_world *world, const char *folder)
{
    murk_error error = MURK_ERROR_NONE;
    murk_plan *plan = NULL;
    murk_sensors *sensors = NULL, *own = NULL;
    murk_coverage *coverage = NULL;
    const murk_fields *of_plan = NULL, *of_coverage = NULL;
    double planned = 0, measured = 0;
    must(murk_plan_for_light(&plan, light, &error), &error);
    must(murk_plan_fields(plan, &of_plan, &error), &error);
    must(murk_fields_double(of_plan, "coverage.in_sample", &planned, &error),
         &error);
    CHECK(planned > .2 && planned <= 1);
    CHECK(murk_fields_length(of_plan, "sensors") == 2);
    CHECK(murk_fields_kind(of_plan, "sensors.0.heading_deg") ==
          MURK_FIELD_ABSENT);
    CHECK(murk_fields_kind(of_plan, "sensors.2") == MURK_FIELD_UNKNOWN);
    /* The sensors of the plan, one by one into a list of the program's. */
    must(murk_plan_sensors(&sensors, plan, &error), &error);
    must(murk_sensors_create(&own, world, &error), &error);
    CHECK(murk_sensors_count(sensors) == 2);
    for (size_t i = 0; i < 2; ++i) {
        murk_sensor sensor = {.size = sizeof sensor};
        must(murk_sensors_get(sensors, i, &sensor, &error), &error);
        CHECK(strcmp(sensor.type, "node") == 0 && isnan(sensor.heading_deg));
        must(murk_sensors_add(own, &sensor, &error), &error);
    }
    must(murk_coverage_measure(&coverage, light, own, &error), &error);
    must(murk_coverage_fields(coverage, &of_coverage, &error), &error);
    must(murk_fields_double(of_coverage, "coverage.in_sample", &measured,
                            &error),
         &error);
    CHECK(measured == planned);
    /* A row of the matrix a sensor, a column a record. */
    murk_array matrix = {.size = sizeof matrix};
    must(murk_coverage_matrix(coverage, &matrix, &error), &error);
    CHECK(matrix.shape[0] == 2 &&
          matrix.shape[1] == murk_light_count(light, MURK_MAP_SURFACE) +
                                 murk_light_count(light, MURK_MAP_VOLUME));
    must(murk_plan_save(plan, folder, NULL, NULL, &error), &error);
    murk_coverage_destroy(coverage);
    murk_sensors_destroy(own);
    murk_sensors_destroy(sensors);
    murk_plan_destroy(plan);
}

/* Misuse and wrong values give errors, with the place of the value. */
static void check_errors(murk_context *context, murk_scene *scene)
{
    murk_error error = MURK_ERROR_NONE;
    murk_scene *bad = NULL;
    murk_world *world = NULL;
    char text[sizeof hall];
    memcpy(text, hall, sizeof hall);
    strstr(text, "20000")[1] = 'x';
    CHECK(murk_scene_parse(&bad, context, text, "bad.yaml", &error) == MURK_OK);
    CHECK(murk_world_create(&world, bad, &error) == MURK_BAD_VALUE && !world);
    CHECK(error.code == MURK_BAD_VALUE && error.line == 8);
    CHECK(strcmp(error.file, "bad.yaml") == 0);
    CHECK(strcmp(error.key, "photons.emit") == 0);
    /* A key that the program set. */
    error = (murk_error)MURK_ERROR_NONE;
    CHECK(murk_scene_set(bad, "photons.emit", "many", &error) == MURK_OK);
    CHECK(murk_scene_check(bad, &error) == MURK_BAD_VALUE);
    CHECK(strcmp(error.key, "photons.emit") == 0 && error.line == 0 &&
          error.file[0] == '\0');
    CHECK(!strstr(error.where, "--") && !strstr(error.text, "--"));
    /* Arrays with holes, a wrong index, a name that is not there. */
    const uint32_t wrong[3] = {0, 1, 8};
    const size_t vertices[2] = {8, 3}, one[2] = {1, 3};
    const murk_array v = murk_array_of(box, MURK_TYPE_FLOAT32, 2, vertices),
                     t = murk_array_of(wrong, MURK_TYPE_UINT32, 2, one);
    error = (murk_error)MURK_ERROR_NONE;
    CHECK(murk_scene_add_mesh(bad, "m", &v, &t, NULL, NULL, 0, NULL, NULL,
                              &error) == MURK_BAD_VALUE);
    CHECK(strstr(error.text, "0 to 7"));
    CHECK(murk_scene_add_mesh(bad, "m/n", &v, &t, NULL, NULL, 0, NULL, NULL,
                              NULL) == MURK_BAD_VALUE);
    CHECK(murk_scene_set(NULL, "seed", "1", NULL) == MURK_BAD_VALUE);
    CHECK(murk_world_create(NULL, scene, NULL) == MURK_BAD_VALUE);
    /* A request to stop ends the next long call, and no other. */
    murk_context_cancel(context);
    CHECK(murk_world_create(&world, scene, NULL) == MURK_INTERRUPTED && !world);
    CHECK(murk_world_create(&world, scene, NULL) == MURK_OK);
    murk_world_destroy(world);
    murk_scene_destroy(bad);
}

int main(int argc, char **argv)
{
    murk_error error = MURK_ERROR_NONE;
    const murk_context_options options = {
        .size = sizeof options, .threads = 2, .log = hear, .user = &warnings};
    murk_context *context = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    const char *folder = argc > 1 ? argv[1] : "api-plan";
    CHECK(strncmp(murk_version(), "0.", 2) == 0);
    must(murk_context_create(&context, &options, &error), &error);
    murk_scene *scene = make_scene(context);
    check_errors(context, scene);
    must(murk_world_create(&world, scene, &error), &error);
    double bounds[6];
    murk_world_bounds(NULL, bounds);
    CHECK(isnan(bounds[0]) && isnan(bounds[5]));
    murk_world_bounds(world, bounds);
    CHECK(bounds[3] == 8 && bounds[5] == 3 && murk_world_bands(world) == 1);
    must(murk_light_trace(&light, world, &error), &error);
    /* Handles may be destroyed in any order. */
    murk_context_destroy(context);
    murk_scene_destroy(scene);
    check_light(light);
    check_plan(light, world, folder);
    murk_world_destroy(world);
    CHECK(releases == 0);
    murk_light_destroy(light);
    CHECK(releases == 1);
    return 0;
}
