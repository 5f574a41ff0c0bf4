/* Arrays of a caller: what is wrong with an array that is refused, and the
 * fields of a material whose name has a dot. The name of the array is the file
 * of the error, and the argument is the place. */
#include "checks.h"

#include <math.h>
#include <string.h>

static const char text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "materials: {ground.001: {diffuse: 0.5}, ground: {diffuse: 0}}\n"
    "geometry: [{file: 'memory:hall'}]\n"
    "lights: [{type: point, position_m: [2, 2, 2], power_w: 1}]\n"
    "photons: {emit: 1000}\n";

/* A rectangle of two triangles. */
static const float corners[4][3] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
static const uint32_t indices[2][3] = {{0, 1, 2}, {0, 2, 3}};

static murk_array vertices_of(const float (*values)[3], size_t n)
{
    return murk_array_of(values, MURK_TYPE_FLOAT32, 2, (const size_t[]){n, 3});
}

/* The numbers may be int32 that are not negative. */
static murk_array triangles_of(const void *values, size_t n)
{
    return murk_array_of(values, MURK_TYPE_UINT32, 2, (const size_t[]){n, 3});
}

/* One refusal: the place and the message; the file is the array `hall`. */
static void check_refused(murk_status status, const murk_error *error,
                          const char *where, const char *message)
{
    if (status != MURK_BAD_VALUE || strcmp(error->where, where) != 0 ||
        strcmp(error->text, message) != 0 || strcmp(error->file, "hall") != 0 ||
        error->key[0] || error->line != 0) {
        fprintf(stderr, "not \"%s: %s\" of the array hall:\n%s: %s: %s\n",
                where, message, error->file, error->where, error->text);
        exit(1);
    }
}

static void check_meshes(murk_scene *scene)
{
    static const char *const names[] = {"ground.001", "ground"};
    static const float cube[8][3] = {{0, 0, 0}}, far[2][3] = {{0}, {0, NAN, 0}};
    static const uint32_t six[6][3] = {[5] = {0, 0, 8}}, of[3] = {0, 1, 2};
    static const double half[3] = {0, 1, 0.5};
    static const int32_t below[3] = {0, 1, -1};
    const murk_array eight = vertices_of(cube, 8), two = vertices_of(far, 2),
                     none = vertices_of(cube, 0), last = triangles_of(six, 6),
                     zeros = triangles_of(six, 3), empty = triangles_of(six, 0),
                     negative = triangles_of(below, 1),
                     fraction = murk_array_of(half, MURK_TYPE_FLOAT64, 2,
                                              (const size_t[]){1, 3}),
                     flat = murk_array_of(cube, MURK_TYPE_FLOAT32, 2,
                                          (const size_t[]){12, 2}),
                     three = murk_array_of(of, MURK_TYPE_UINT32, 1,
                                           (const size_t[]){3});
    const struct {
        const murk_array *vertices_m, *triangles, *material;
        const char *where, *message;
    } cases[] = {
        {&eight, &last, NULL, "argument triangles",
         "corner 2 of triangle 5 is 8, must be 0 to 7"},
        {&eight, &negative, NULL, "argument triangles",
         "corner 2 of triangle 0 is 4294967295, must be 0 to 7"},
        {&eight, &fraction, NULL, "argument triangles",
         "corner 2 of triangle 0 is 0.5, must be a whole number, 0 to 7"},
        {&eight, &zeros, &three, "argument material",
         "material of triangle 2 is 2, must be 0 to 1"},
        {&eight, &last, &three, "argument material",
         "has 3 elements, must have 6, one for each triangle"},
        {&two, &zeros, NULL, "argument vertices_m",
         "coordinate 1 of vertex 1 is nan, must be a finite number"},
        {&flat, &zeros, NULL, "argument vertices_m",
         "is 12 x 2, must be n x 3 with n above 0"},
        {&none, &zeros, NULL, "argument vertices_m",
         "is 0 x 3, must be n x 3 with n above 0"},
        {&eight, &empty, NULL, "argument triangles",
         "is 0 x 3, must be n x 3 with n above 0"},
        {NULL, &zeros, NULL, "argument vertices_m", "is NULL"}};
    /* Each mesh is refused, and none is added. */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        murk_error error = MURK_ERROR_NONE;
        const murk_status status = murk_scene_add_mesh(
            scene, "hall", cases[i].vertices_m, cases[i].triangles,
            cases[i].material, names, 2, NULL, NULL, &error);
        check_refused(status, &error, cases[i].where, cases[i].message);
    }
}

static void check_grids(murk_scene *scene)
{
    static const float values[8] = {1, 1, 1, 1, 1, 1, 1, -1};
    const murk_array grid = murk_array_of(values, MURK_TYPE_FLOAT32, 3,
                                          (const size_t[]){2, 2, 2}),
                     none = murk_array_of(values, MURK_TYPE_FLOAT32, 3,
                                          (const size_t[]){2, 0, 2});
    static const double unit[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
                        zeros[12] = {0}, plane[12] = {.1, .2, .3, 0,  .4, .5,
                                                      .6, 0,  .7, .8, .9, 0},
                        shift[12] = {1, 0, 0, INFINITY, 0, 1, 0, 0, 0, 0, 1, 0},
                        small[12] = {1e-6, 0, 0, 0, 0,    1e-6,
                                     0,    0, 0, 0, 1e-6, 0};
    static const char singular[] =
        "is singular: the edges of a voxel (columns 0 to 2) lie in one plane, "
        "must span a volume";
    const struct {
        const murk_array *values;
        const double *rows;
        const char *where, *message;
    } cases[] = {
        {&grid, zeros, "argument index_to_world", singular},
        {&grid, plane, "argument index_to_world", singular},
        {&grid, shift, "argument index_to_world",
         "row 0, column 3 is inf, must be a finite number"},
        {&grid, small, "argument index_to_world",
         "voxels have a volume of 1e-18 m3, must be at least 3e-15 m3"},
        {&grid, NULL, "argument index_to_world", "is NULL"},
        {&grid, unit, "argument values",
         "value [1, 1, 1] is -1, must be finite and at least 0"},
        {&none, unit, "argument values", "has no values"}};
    /* Each grid is refused, and none is added. */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        murk_error error = MURK_ERROR_NONE;
        const murk_status status = murk_scene_add_grid(
            scene, "hall", cases[i].values, cases[i].rows, NULL, NULL, &error);
        check_refused(status, &error, cases[i].where, cases[i].message);
    }
}

static void check_tables(murk_scene *scene)
{
    const murk_array values =
        murk_array_of(corners, MURK_TYPE_FLOAT32, 1, (const size_t[]){3});
    murk_error error = MURK_ERROR_NONE;
    murk_status status =
        murk_scene_add_table(scene, "hall", NULL, &values, &error);
    check_refused(status, &error, "argument values",
                  "has 1 dimensions and type 4, must have 2 and a murk_type");
    /* A name that is not allowed is the place itself. */
    error = (murk_error)MURK_ERROR_NONE;
    static const char *const columns[] = {"x_m", "y_m", "z_m"};
    const murk_array places = vertices_of(corners, 4);
    status = murk_scene_add_table(scene, "a:5", columns, &places, &error);
    CHECK(status == MURK_BAD_VALUE && strcmp(error.file, "a:5") == 0 &&
          strcmp(error.where, "a:5") == 0 && error.line == 0);
}

/* The light that the two triangles absorb, each of its own material. */
static void check_fields(murk_scene *scene)
{
    static const char *const names[] = {"ground.001", "ground"};
    static const uint32_t of[2] = {0, 1};
    const murk_array vertices = vertices_of(corners, 4),
                     triangles = triangles_of(indices, 2),
                     material = murk_array_of(of, MURK_TYPE_UINT32, 1,
                                              (const size_t[]){2});
    murk_error error = MURK_ERROR_NONE;
    murk_world *world = NULL;
    murk_light *light = NULL;
    const murk_fields *fields = NULL;
    double dotted = 0, plain = 0, all = 0;
    /* Trace light in a world whose only surface is the mesh. */
    must_be_ok(murk_scene_add_mesh(scene, "hall", &vertices, &triangles,
                                   &material, names, 2, NULL, NULL, &error),
               &error);
    must_be_ok(murk_world_create(&world, scene, &error), &error);
    must_be_ok(murk_light_trace(&light, world, &error), &error);
    must_be_ok(murk_light_fields(light, &fields, &error), &error);
    /* Read the fields of both materials. */
    must_be_ok(murk_fields_double(fields,
                                  "absorbed_by_material_w.ground.001.total",
                                  &dotted, &error),
               &error);
    must_be_ok(murk_fields_double(fields, "absorbed_by_material_w.ground.total",
                                  &plain, &error),
               &error);
    must_be_ok(
        murk_fields_double(fields, "absorbed_surfaces_w.total", &all, &error),
        &error);
    CHECK(dotted > 0 && plain > dotted);
    CHECK(fabs(dotted + plain - all) < 1e-9);
    CHECK(murk_fields_kind(fields, "absorbed_by_material_w.ground.002.total") ==
          MURK_FIELD_UNKNOWN);
    murk_light_destroy(light);
    murk_world_destroy(world);
}

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    must_be_ok(murk_context_create(&context, NULL, &error), &error);
    must_be_ok(murk_scene_parse(&scene, context, text, "text", &error), &error);
    check_meshes(scene);
    check_grids(scene);
    check_tables(scene);
    check_fields(scene);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}
