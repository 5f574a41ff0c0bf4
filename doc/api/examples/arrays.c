/* A mesh, a grid and a table of the program in a scene. */
#include "example.h"

static void release(void *user)
{
    free(user);
    printf("the grid is released\n");
}

/* A crate of one metre, two of whose triangles are of steel. */
static void add_crate(murk_scene *scene)
{
    static const float corners[8][3] = {{3, 2, 0}, {4, 2, 0}, {4, 3, 0},
                                        {3, 3, 0}, {3, 2, 1}, {4, 2, 1},
                                        {4, 3, 1}, {3, 3, 1}};
    static const uint32_t sides[12][3] = {
        {0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
        {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    static const uint32_t material[12] = {0, 0, 1, 1};
    static const char *const names[] = {"wood", "steel"};
    const size_t n_corners[] = {8, 3}, n_sides[] = {12, 3};
    const murk_array v = murk_array_of(corners, MURK_TYPE_FLOAT32, 2,
                                       n_corners),
                     t = murk_array_of(sides, MURK_TYPE_UINT32, 2, n_sides),
                     m = murk_array_of(material, MURK_TYPE_UINT32, 1, n_sides);
    murk_error error = MURK_ERROR_NONE;
    must(murk_scene_add_mesh(scene, "crate", &v, &t, &m, names, 2, NULL, NULL,
                             &error),
         &error);
    must(murk_scene_set(scene, "geometry",
                        "[{box: {min_m: [0, 0, 0], max_m: [8, 6, 3]}}, "
                        "{file: memory:crate}]",
                        &error),
         &error);
    must(murk_scene_set(scene, "materials",
                        "{default: {diffuse: 0.5}, wood: {diffuse: 0.3}, "
                        "steel: {specular: 0.6}}",
                        &error),
         &error);
}

/* A plume of 4 x 4 x 4 cells of half a metre, used in place: x is the fastest
 * index, and the grid belongs to the scene from here on. */
static void add_plume(murk_scene *scene)
{
    float *density = malloc(64 * sizeof *density);
    if (!density) {
        exit(1);
    }
    for (int i = 0; i < 64; ++i) {
        density[i] = (float)(i % 4) / 4;
    }
    const murk_array values = {.size = sizeof values,
                               .data = density,
                               .type = MURK_TYPE_FLOAT32,
                               .dimensions = 3,
                               .shape = {4, 4, 4},
                               .stride = {4, 16, 64}};
    const double index_to_world[12] = {0.5, 0, 0, 5.25, 0,   0.5,
                                       0,   3, 0, 0,    0.5, 0.25};
    murk_error error = MURK_ERROR_NONE;
    must(murk_scene_add_grid(scene, "plume", &values, index_to_world, release,
                             density, &error),
         &error);
    must(murk_scene_set(scene, "media",
                        "{fog: {vdb: memory:plume, extinction_per_m: 1, "
                        "albedo: 0.9, phase: {hg: 0.8}}}",
                        &error),
         &error);
    must(murk_scene_set(scene, "regions", "[{medium: fog}]", &error), &error);
}

/* Candidate places of sensors, as a CSV file would list them. */
static void add_places(murk_scene *scene)
{
    static const double places[3][3] = {{1, 1, 2}, {7, 1, 2}, {4, 5, 2}};
    static const char *const columns[] = {"x_m", "y_m", "z_m"};
    const size_t shape[] = {3, 3};
    const murk_array values =
        murk_array_of(places, MURK_TYPE_FLOAT64, 2, shape);
    murk_error error = MURK_ERROR_NONE;
    must(murk_scene_add_table(scene, "places", columns, &values, &error),
         &error);
    must(murk_scene_set(scene, "sensors.candidates", "{points: memory:places}",
                        &error),
         &error);
}

int main(void)
{
    murk_error error = MURK_ERROR_NONE;
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    must(murk_context_create(&context, NULL, &error), &error);
    must(murk_scene_parse(&scene, context, room, "room.yaml", &error), &error);
    add_crate(scene);
    add_plume(scene);
    add_places(scene);
    must(murk_world_create(&world, scene, &error), &error);
    printf("the world is built\n");
    murk_scene_destroy(scene);
    murk_world_destroy(world);
    murk_context_destroy(context);
    return 0;
}

/* Prints:
 *
 * the world is built
 * the grid is released
 */
