/* The example scenes are what they promise to be: sizes, and rooms without a
 * seam that light could leave by. Rays are random; the verdict repeats, since
 * their numbers do. */
#include "base/rng.h"
#include "check.h"
#include "geometry/mesh.h"
#include "geometry/surfaces.h"
#include "scene/scene.h"

#define RAYS 100000

static murk_mesh *read_mesh(const char *path)
{
    const murk_mesh_import import = {.unit_m = 1, .up = 'z'};
    murk_mesh *mesh = NULL;
    murk_error err = {0};
    CHECK(murk_mesh_read(&mesh, path, &import, path, &err) == MURK_OK);
    if (!mesh) {
        printf("%s: %s\n", err.where, err.text);
    }
    return mesh;
}

static murk_surfaces *surfaces_of(const murk_mesh *mesh)
{
    const murk_material plain = {.name = "default"};
    const murk_surface_desc desc = {.shape = MURK_SHAPE_MESH,
                                    .mesh = mesh,
                                    .to_world = murk_affine_identity(),
                                    .material = 0,
                                    .where = "mesh"};
    murk_surfaces *surfaces = NULL;
    murk_error err = {0};
    CHECK(murk_surfaces_create(&surfaces, &desc, 1, &plain, 1, &err) ==
          MURK_OK);
    return surfaces;
}

/* Rays from random positions inside the box [0, size], half of them toward
 * random points on the twelve edges, where gaps between surfaces would be.
 * Counts rays that meet no surface and do not leave through the window in
 * the plane x = size.x. */
static size_t escapes(const murk_surfaces *surfaces, murk_vec3 size,
                      const murk_box *window)
{
    size_t count = 0;
    for (uint64_t i = 0; i < RAYS; ++i) {
        /* A random origin inside the box, and a random target inside the
         * box or on an edge. */
        const murk_random4 a = murk_random(1, MURK_TEST, i, 0, 0);
        const murk_random4 b = murk_random(1, MURK_TEST, i, 0, 1);
        const murk_vec3 from = murk_vec(size.x * (0.01 + 0.98 * a.u[0]),
                                        size.y * (0.01 + 0.98 * a.u[1]),
                                        size.z * (0.01 + 0.98 * a.u[2]));
        double to[3] = {b.u[0], b.u[1], b.u[2]};
        if (i % 2) {
            const int axis = (int)(i / 2 % 3);
            to[axis] = to[axis] < 0.5 ? 0 : 1;
            to[(axis + 1) % 3] = b.u[3] < 0.5 ? 0 : 1;
        }
        const murk_vec3 d = murk_unit(murk_sub(
            murk_vec(to[0] * size.x, to[1] * size.y, to[2] * size.z), from));
        /* Count rays that meet no surface, except those through the window. */
        murk_hit hit;
        if (murk_surfaces_hit(surfaces, from, d, INFINITY, &hit)) {
            continue;
        }
        const murk_vec3 out = murk_along(from, (size.x - from.x) / d.x, d);
        count += !(window && d.x > 0 && murk_box_contains(window, out));
    }
    return count;
}

static void test_paper_scene_has_268_triangles_and_no_seam(void)
{
    murk_mesh *mesh = read_mesh("scenes/meshes/paper-room.obj");
    if (!mesh) {
        return;
    }
    CHECK(mesh->triangles == 268);
    CHECK(mesh->degenerate == 0);
    const murk_vec3 size = murk_vec(12, 10, 3);
    murk_surfaces *surfaces = surfaces_of(mesh);
    CHECK(escapes(surfaces, size, NULL) == 0);
    murk_surfaces_destroy(surfaces);

    /* Teeth: without one triangle of the floor it is open. */
    mesh->corner[1] = mesh->corner[0];
    surfaces = surfaces_of(mesh);
    CHECK(escapes(surfaces, size, NULL) > 0);
    murk_surfaces_destroy(surfaces);
    murk_mesh_destroy(mesh);
}

static void test_smoke_hall_is_open_at_the_gate_only(void)
{
    murk_mesh *mesh = read_mesh("scenes/meshes/smoke-hall.obj");
    if (!mesh) {
        return;
    }
    CHECK(mesh->degenerate == 0);
    const murk_vec3 size = murk_vec(30, 18, 9);
    const murk_box gate = {murk_vec(29.99, 6.5, -0.001),
                           murk_vec(30.01, 11.5, 4.8)};
    murk_surfaces *surfaces = surfaces_of(mesh);
    CHECK(escapes(surfaces, size, &gate) == 0);
    CHECK(escapes(surfaces, size, NULL) > 0);
    murk_surfaces_destroy(surfaces);
    murk_mesh_destroy(mesh);
}

static murk_scene_desc *read_scene(const char *path)
{
    murk_scene_desc *scene = NULL;
    murk_error err = {0};
    CHECK(murk_scene_desc_read(&scene, path, NULL, 0, &err) == MURK_OK);
    if (!scene) {
        printf("%s: %s\n", err.where, err.text);
    }
    return scene;
}

/* A name that the mesh does not know would be an optical property that nobody
 * gets; a name that the scene does not know, a black surface. */
static void check_materials(const murk_scene_desc *scene)
{
    for (size_t g = 0; g < scene->geometries; ++g) {
        if (!scene->geometry[g].solid.mesh) {
            continue;
        }
        murk_mesh *mesh = read_mesh(scene->geometry[g].solid.mesh);
        if (!mesh) {
            continue;
        }
        for (size_t i = 0; i < mesh->triangles; ++i) {
            const char *name = mesh->material_name[mesh->material[i]];
            size_t m = 1;
            while (m < scene->n_materials &&
                   strcmp(scene->materials[m].name, name) != 0) {
                ++m;
            }
            CHECK(m < scene->n_materials);
        }
        murk_mesh_destroy(mesh);
    }
}

static void test_scenes_read_and_name_their_materials(void)
{
    static const char *const paths[] = {
        "scenes/paper-room.yaml", "scenes/smoke-hall.yaml",
        "scenes/fog-yard.yaml",   "scenes/rain-street.yaml",
        "scenes/harbour.yaml",    "scenes/day-night.yaml"};
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; ++i) {
        murk_scene_desc *scene = read_scene(paths[i]);
        if (!scene) {
            continue;
        }
        check_materials(scene);
        CHECK(scene->has_domain);
        CHECK(murk_box_contains(&scene->domain.box,
                                scene->sensors.candidates.grid_min));
        CHECK(murk_box_contains(&scene->domain.box,
                                scene->sensors.candidates.grid_max));
        murk_scene_desc_destroy(scene);
    }
}

static void test_paper_scene_is_of_the_papers_size(void)
{
    murk_scene_desc *scene = read_scene("scenes/paper-room.yaml");
    if (scene) {
        const size_t *size = scene->sensors.candidates.grid_size;
        CHECK(size[0] * size[1] * size[2] == 1188);
        CHECK(scene->photons.store == 10000);
        CHECK(scene->sensors.count == 5);
        CHECK(scene->n_media == 0);
        murk_scene_desc_destroy(scene);
    }
}

int main(void)
{
    test_scenes_read_and_name_their_materials();
    test_paper_scene_is_of_the_papers_size();
    test_paper_scene_has_268_triangles_and_no_seam();
    test_smoke_hall_is_open_at_the_gate_only();
    return check_done();
}
