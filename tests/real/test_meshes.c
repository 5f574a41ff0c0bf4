/* Real meshes come in whole: triangle counts, sizes in metres, z up, and the
 * same model from several formats is the same. Counts and boxes are facts of
 * the files. */
#include "check.h"
#include "geometry/surfaces.h"

#include <stdio.h>
#include <unistd.h>

#define DATA   "../shared/data/meshes/"
#define MODELS "/usr/share/assimp/models/"

static murk_mesh *read_mesh(const char *path, double unit_m, char up)
{
    const murk_mesh_import import = {.unit_m = unit_m, .up = up};
    murk_mesh *m = NULL;
    murk_error err = {0};
    murk_mesh_read(&m, path, &import, path, &err);
    CHECK_TEXT(err.text, "");
    return m;
}

/* Checks that every triangle is read, and height and length [m] to a
 * centimetre. */
static void check_mesh(const char *path, size_t triangles, double height_m,
                       double length_m)
{
    /* Read the mesh. */
    murk_mesh *m = read_mesh(path, 0, 0);
    murk_surfaces *s = NULL;
    murk_error err = {0};
    if (!m) {
        return;
    }
    /* Number of triangles and extents. */
    const murk_vec3 size = murk_sub(m->bounds_m.max, m->bounds_m.min);
    printf("%s: %zu triangles and %zu degenerate, %.3f m high\n", path,
           m->triangles, m->degenerate, size.z);
    CHECK(m->triangles + m->degenerate == triangles);
    CHECK_NEAR(size.z, height_m, 0.01);
    CHECK_NEAR(fmax(size.x, size.y), length_m, 0.01);
    /* The mesh makes surfaces with an area. */
    const murk_material plain = {.name = "default"};
    const murk_surface_desc desc = {.shape = MURK_SHAPE_MESH,
                                    .mesh = m,
                                    .to_world = murk_affine_identity(),
                                    .material = -1,
                                    .where = path};
    CHECK(murk_surfaces_create(&s, &desc, 1, &plain, 1, &err) == MURK_OK);
    CHECK(s && murk_surfaces_describe(s).area_m2 > 0);
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

static void test_field_meshes(void)
{
    check_mesh(DATA "gazebo/willowgarage_visual.dae", 13839, 2.845, 58.63);
    check_mesh(DATA "gazebo/cafe.dae", 23834, 2.867, 24.41);
    check_mesh(DATA "gazebo/house_1.dae", 1884, 5.125, 10.99);
    check_mesh(DATA "gazebo/house_2.dae", 1142, 4.818, 8.47);
    check_mesh(DATA "gazebo/parking_garage.dae", 6413, 45.905, 60.47);
    check_mesh(DATA "gazebo/pier.dae", 684, 9.617, 22.20);
    check_mesh(DATA "gazebo/tower_crane.dae", 8735, 35.028, 39.08);
    check_mesh(DATA "dave/sunkenship_distort.dae", 4171, 7.213, 17.46);
    check_mesh(DATA "uuv/LakeBottom.dae", 12020, 149.50, 998.29);
    check_mesh(DATA "uuv/MangaliaTerrain.dae", 1445, 29.278, 4125.48);
    check_mesh(DATA "uuv/WaterSurface.dae", 452, 0.010, 889.95);
    check_mesh(DATA "uuv/munkholmen.dae", 1332, 17.303, 133.83);
    check_mesh(DATA "uuv/sea_surface_1000m_x_1000m.dae", 4802, 0, 1000);
    check_mesh(DATA "uuv/seabed.dae", 2115, 65.352, 2386.02);
    check_mesh(DATA "cornell_box_embree.obj", 34, 559.2, 556);
}

/* Names the boxes that differ from the first by more than float rounding. */
static void check_same(const char *const *path, const char *up, size_t n,
                       double slack)
{
    murk_box first = murk_box_empty();
    size_t triangles = 0;
    for (size_t i = 0; i < n; ++i) {
        murk_mesh *m = read_mesh(path[i], 0, up[i] == '0' ? 0 : up[i]);
        if (!m) {
            continue;
        }
        if (i == 0) {
            first = m->bounds_m;
            triangles = m->triangles;
        }
        printf("%s\n", path[i]);
        CHECK(m->triangles == triangles);
        CHECK_NEAR(murk_length(murk_sub(m->bounds_m.min, first.min)), 0, slack);
        CHECK_NEAR(murk_length(murk_sub(m->bounds_m.max, first.max)), 0, slack);
        murk_mesh_destroy(m);
    }
}

static void test_formats_agree(void)
{
    if (access(MODELS "OBJ/WusonOBJ.obj", R_OK) != 0) {
        printf("skipped: Debian's assimp-testmodels is not installed\n");
        return;
    }
    const char *const boar[] = {MODELS "OBJ/WusonOBJ.obj",
                                MODELS "PLY/Wuson.ply", MODELS "STL/Wuson.stl",
                                MODELS "DXF/wuson.dxf"};
    check_same(boar, "0000", 4, 2e-6);
    /* The OBJ is y up and says nothing; the FBX says centimetres and y up. */
    const char *const spider[] = {MODELS "OBJ/spider.obj",
                                  MODELS "FBX/spider.fbx"};
    check_same(spider, "y0", 2, 1e-3);
    const char *const stl[] = {MODELS "STL/Spider_binary.stl",
                               MODELS "STL/Spider_ascii.stl"};
    check_same(stl, "00", 2, 1e-4);
    check_mesh(MODELS "IFC/AC14-FZK-Haus.ifc", 35906, 7.318, 18);
}

int main(void)
{
    if (access(DATA, R_OK) != 0) {
        check_skip("no ../shared/data/meshes");
    }
    test_field_meshes();
    test_formats_agree();
    return check_done();
}
