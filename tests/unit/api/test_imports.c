/* Meshes and grids are read by the program murk-reader, by a fork or in the
 * process, with results equal to the bit; the files that a reader opens are
 * inputs of the context in each case, and a malformed file is an error. */
#include "check.h"
#include "murk.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry: [{file: floor.obj, up: z}]\n"
    "materials: {default: {diffuse: 0.5}, oak: {diffuse: 0.3}}\n"
    "media:\n"
    "  fog: {vdb: memory:cloud, extinction_per_m: 1, albedo: 0.9, phase: "
    "isotropic}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [2, 2, 2], power_w: 1}]\n"
    "photons: {emit: 5000}\n";

static void write_files(void)
{
    write_text("floor.obj", "mtllib floor.mtl\n"
                            "v 0 0 0.5\nv 4 0 0.5\nv 4 4 0.5\nv 0 4 0.5\n"
                            "usemtl oak\nf 1 2 3\nf 1 3 4\n");
    write_text("floor.mtl", "newmtl oak\n");
    write_text("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 99\n");
}

static murk_context *make_context(murk_imports imports, const char *reader)
{
    const murk_context_options options = {
        .size = sizeof options, .imports = imports, .reader = reader};
    murk_context *context = NULL;
    CHECK(!murk_context_create(&context, &options, NULL));
    return context;
}

/* The scene with a cloud of cells of 1 m from an array, or from the file `vdb`,
 * which is the pattern of a sequence if it contains a %: then the time is
 * between two frames. */
static murk_scene *make_scene(murk_context *context, const char *vdb)
{
    static const float density[8] = {0, 1, 0.5F, 1, 1, 0, 1, 0.25F};
    static const double place[12] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};
    const size_t shape[3] = {2, 2, 2};
    const murk_array values =
        murk_array_of(density, MURK_TYPE_FLOAT32, 3, shape);
    murk_scene *scene = NULL;
    CHECK(!murk_scene_parse(&scene, context, scene_text, "room", NULL));
    CHECK(
        !murk_scene_add_grid(scene, "cloud", &values, place, NULL, NULL, NULL));
    CHECK(!murk_scene_set(scene, "media.fog.vdb", vdb, NULL));
    if (strchr(vdb, '%')) {
        CHECK(!murk_scene_set(scene, "media.fog.frame", "1.5", NULL));
    }
    return scene;
}

/* The power of all records of both maps, which depends on each bit of the
 * import; 0 if the world cannot be made. */
static double light_of(murk_imports imports, const char *vdb)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = make_context(imports, NULL);
    murk_scene *scene = make_scene(context, vdb);
    murk_world *world = NULL;
    murk_light *light = NULL;
    double sum_w = 0;
    CHECK(!murk_world_create(&world, scene, &error));
    if (!world || murk_light_trace(&light, world, &error)) {
        printf("%s: %s\n", error.where, error.text);
    }
    for (int map = 0; light && map < 2; ++map) {
        murk_array power = {.size = sizeof power};
        CHECK(!murk_light_array(light, (murk_map)map, "power_w", &power, NULL));
        for (size_t i = 0; i < power.shape[0]; ++i) {
            sum_w += (double)*(const float *)((const char *)power.data +
                                              (ptrdiff_t)i * power.stride[0]);
        }
    }
    /* The mesh names floor.mtl, which only its reader opens. */
    CHECK(light &&
          murk_light_write(light, "floor.mtl", NULL) == MURK_BAD_VALUE);
    CHECK(light &&
          murk_light_write(light, "floor.obj", NULL) == MURK_BAD_VALUE);
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return sum_w;
}

static double test_readers_agree(const char *vdb)
{
    const double by_reader = light_of(MURK_IMPORTS_READER, vdb),
                 by_fork = light_of(MURK_IMPORTS_FORK, vdb),
                 in_process = light_of(MURK_IMPORTS_IN_PROCESS, vdb);
    CHECK(by_reader > 0 && by_reader == by_fork && by_reader == in_process);
    return by_reader;
}

static void test_failures(void)
{
    static const murk_imports all[] = {MURK_IMPORTS_READER, MURK_IMPORTS_FORK,
                                       MURK_IMPORTS_IN_PROCESS};
    murk_world *world = NULL;
    for (size_t i = 0; i < 3; ++i) { /* a malformed mesh */
        murk_error error = MURK_ERROR_NONE;
        murk_context *context = make_context(all[i], NULL);
        murk_scene *scene = make_scene(context, "memory:cloud");
        CHECK(!murk_scene_set(scene, "geometry.0.file", "bad.obj", NULL));
        CHECK(murk_world_create(&world, scene, &error) == MURK_BAD_FILE);
        CHECK(strstr(error.text, "bad.obj") != NULL);
        murk_scene_destroy(scene);
        murk_context_destroy(context);
    }
    /* No program, and a program that is another one. */
    static const char *const programs[] = {"no-such-program", "/bin/true"};
    static const murk_status codes[] = {MURK_RUN_FAILED, MURK_BAD_FILE};
    for (size_t i = 0; i < 2; ++i) {
        murk_context *context = make_context(MURK_IMPORTS_READER, programs[i]);
        murk_scene *scene = make_scene(context, "memory:cloud");
        CHECK(murk_world_create(&world, scene, NULL) == codes[i]);
        murk_scene_destroy(scene);
        murk_context_destroy(context);
    }
    /* A value that is none of the three. */
    const murk_context_options wrong = {.size = sizeof wrong,
                                        .imports = (murk_imports)3};
    murk_context *context = NULL;
    CHECK(murk_context_create(&context, &wrong, NULL) == MURK_BAD_VALUE &&
          !context);
}

int main(void)
{
    char folder[] = "/tmp/murk_imports_XXXXXX";
    char top[4096], vdb[4200];
    if (!getcwd(top, sizeof top) || !mkdtemp(folder) || chdir(folder) != 0) {
        return 1;
    }
    snprintf(vdb, sizeof vdb, "%s/tests/physics/scenes/step-cloud.vdb", top);
    write_files();
    test_readers_agree("memory:cloud");
    const double of_one = test_readers_agree(vdb);
    /* Between two equal frames there is the light of one. */
    CHECK(symlink(vdb, "cloud.1.vdb") == 0 && symlink(vdb, "cloud.2.vdb") == 0);
    CHECK(test_readers_agree("cloud.%d.vdb") == of_one);
    test_failures();
    static const char *const files[] = {"floor.obj", "floor.mtl", "bad.obj",
                                        "cloud.1.vdb", "cloud.2.vdb"};
    for (size_t i = 0; i < sizeof files / sizeof *files; ++i) {
        unlink(files[i]);
    }
    CHECK(chdir("/") == 0 && rmdir(folder) == 0);
    return check_done();
}
