/* Arrays that a scene uses in place: the release callback is called once, after
 * the last handle that needs the array, and not at all if the call was refused;
 * the light is that of copied arrays. */
#include "check.h"
#include "murk.h"

#include <math.h>

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "geometry: [{file: memory:floor}]\n"
    "materials: {default: {diffuse: 0.5}}\n"
    "media: {fog: {vdb: memory:cloud, extinction_per_m: 1, albedo: 0.9, "
    "phase: isotropic}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [2, 2, 2], power_w: 1}]\n"
    "photons: {emit: 5000}\n";

static float corners[4][3] = {
    {0, 0, 0.5}, {4, 0, 0.5}, {4, 4, 0.5}, {0, 4, 0.5}};
static uint32_t sides[2][3] = {{0, 1, 2}, {0, 2, 3}};
static float density[8] = {0, 1, 0.5F, 1, 1, 0, 1, 0.25F}; /* 2 x 2 x 2 */
static const double place[12] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};

/* Counts the releases of one array. */
static void release(void *user)
{
    ++*(int *)user;
}

static murk_status add_floor(murk_scene *scene, const char *name,
                             murk_type type, int *releases)
{
    const size_t n_corners[2] = {4, 3}, n_sides[2] = {2, 3};
    const murk_array v = murk_array_of(corners, MURK_TYPE_FLOAT32, 2,
                                       n_corners),
                     t = murk_array_of(sides, type, 2, n_sides);
    return murk_scene_add_mesh(scene, name, &v, &t, NULL, NULL, 0,
                               releases ? release : NULL, releases, NULL);
}

/* With x or z fastest; only the first can be used in place. */
static murk_status add_cloud(murk_scene *scene, const char *name,
                             bool is_x_fastest, int *releases)
{
    const size_t shape[3] = {2, 2, 2};
    murk_array values = murk_array_of(density, MURK_TYPE_FLOAT32, 3, shape);
    if (is_x_fastest) {
        values.stride[0] = 4;
        values.stride[2] = 16;
    }
    return murk_scene_add_grid(scene, name, &values, place,
                               releases ? release : NULL, releases, NULL);
}

static murk_scene *make_scene(murk_context *context)
{
    murk_scene *scene = NULL;
    CHECK(!murk_scene_parse(&scene, context, scene_text, "room", NULL));
    return scene;
}

static void test_refused_arrays_stay_with_the_caller(murk_context *context)
{
    int mesh = 0, grid = 0;
    murk_scene *scene = make_scene(context);
    /* A type or an order that cannot be used in place, and a bad name. */
    CHECK(add_floor(scene, "floor", MURK_TYPE_FLOAT32, &mesh));
    CHECK(add_floor(scene, "a/b", MURK_TYPE_UINT32, &mesh));
    CHECK(add_cloud(scene, "cloud", false, &grid));
    CHECK(add_cloud(scene, "a/b", true, &grid));
    /* Bad values. */
    sides[1][2] = 4;
    CHECK(add_floor(scene, "floor", MURK_TYPE_UINT32, &mesh) == MURK_BAD_VALUE);
    sides[1][2] = 3;
    corners[3][1] = INFINITY;
    CHECK(add_floor(scene, "floor", MURK_TYPE_UINT32, &mesh) == MURK_BAD_VALUE);
    corners[3][1] = 4;
    density[7] = -1;
    CHECK(add_cloud(scene, "cloud", true, &grid) == MURK_BAD_VALUE);
    density[7] = 0.25F;
    murk_scene_destroy(scene);
    CHECK(mesh == 0 && grid == 0);
}

/* The power of all records: copied, or lent. */
static double light_of(murk_context *context, int *mesh, int *grid)
{
    murk_scene *scene = make_scene(context);
    murk_world *world = NULL;
    murk_light *light = NULL;
    double sum_w = 0;
    CHECK(!add_floor(scene, "floor", MURK_TYPE_UINT32, mesh) &&
          !add_cloud(scene, "cloud", true, grid));
    CHECK(!murk_world_create(&world, scene, NULL));
    murk_scene_destroy(scene);
    CHECK(!murk_light_trace(&light, world, NULL));
    murk_world_destroy(world);
    CHECK((!mesh || *mesh == 0) && (!grid || *grid == 0));
    for (int map = 0; map < 2; ++map) {
        murk_array power = {.size = sizeof power};
        CHECK(!murk_light_array(light, (murk_map)map, "power_w", &power, NULL));
        CHECK(power.shape[0] > 100);
        for (size_t i = 0; i < power.shape[0]; ++i) {
            sum_w += (double)*(const float *)((const char *)power.data +
                                              (ptrdiff_t)i * power.stride[0]);
        }
    }
    murk_light_destroy(light);
    return sum_w;
}

static void test_lent_arrays_are_released_once(murk_context *context)
{
    int mesh = 0, grid = 0;
    const double copied_w = light_of(context, NULL, NULL),
                 lent_w = light_of(context, &mesh, &grid);
    CHECK(lent_w == copied_w && lent_w > 0);
    CHECK(mesh == 1 && grid == 1);
}

static void test_a_replaced_array_is_released(murk_context *context)
{
    int first = 0, second = 0;
    murk_scene *scene = make_scene(context);
    CHECK(!add_floor(scene, "floor", MURK_TYPE_UINT32, &first));
    CHECK(!add_floor(scene, "floor", MURK_TYPE_UINT32, &second));
    CHECK(first == 1 && second == 0);
    CHECK(!add_cloud(scene, "floor", true, &first));
    CHECK(first == 1 && second == 1);
    murk_scene_destroy(scene);
    CHECK(first == 2 && second == 1);
}

int main(void)
{
    murk_context *context = NULL;
    CHECK(!murk_context_create(&context, NULL, NULL));
    test_refused_arrays_stay_with_the_caller(context);
    test_lent_arrays_are_released_once(context);
    test_a_replaced_array_is_released(context);
    murk_context_destroy(context);
    return check_done();
}
