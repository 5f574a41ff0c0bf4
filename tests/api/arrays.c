/* Arrays of a caller: the fields of a material whose name has a dot. */
#include "checks.h"

#include <math.h>

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

static murk_array triangles_of(const void *values, size_t n)
{
    return murk_array_of(values, MURK_TYPE_UINT32, 2, (const size_t[]){n, 3});
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
    must_be_ok(murk_scene_add_mesh(scene, "hall", &vertices, &triangles,
                                   &material, names, 2, NULL, NULL, &error),
               &error);
    must_be_ok(murk_world_create(&world, scene, &error), &error);
    must_be_ok(murk_light_trace(&light, world, &error), &error);
    must_be_ok(murk_light_fields(light, &fields, &error), &error);
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
    check_fields(scene);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    return 0;
}
