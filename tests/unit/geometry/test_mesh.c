/* Meshes arrive in metres with z up, with their materials' names, and what is
 * wrong with a file is said in one line. Deterministic. */
#include "check.h"
#include "geometry/mesh.h"
#include "geometry/surfaces.h"
#include "written.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/murk-mesh-XXXXXX";
static char path[64];

static const char *written(const char *name, const char *text)
{
    snprintf(path, sizeof path, "%s/%s", folder, name);
    write_text(path, text);
    return path;
}

static murk_mesh *read_mesh(const char *file, double unit_m, char up,
                            murk_error *err)
{
    const murk_mesh_import import = {.unit_m = unit_m, .up = up};
    murk_mesh *m = NULL;
    *err = (murk_error){0};
    murk_mesh_read(&m, file, &import, "scene.yaml:3:5", err);
    return m;
}

/* A tetrahedron 1 x 2 x 3; one degenerate face, one line, one point. */
static const char OBJ[] = "mtllib none.mtl\n"
                          "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nv 2 0 0\n"
                          "usemtl glass\nf 1 2 3\nf 1 2 4\n"
                          "usemtl steel\nf 1 3 4\nf 2 3 4\n"
                          "f 1 2 5\nl 1 2\np 1\n";

static void test_obj_is_metres_with_z_up(void)
{
    murk_error err;
    murk_mesh *m = read_mesh(written("a.obj", OBJ), 0, 0, &err);
    CHECK_TEXT(err.text, "");
    if (!m) {
        return;
    }
    CHECK(m->triangles == 4);
    CHECK(m->degenerate == 1);
    CHECK(m->bounds_m.min.x == 0 && m->bounds_m.max.x == 1);
    CHECK(m->bounds_m.max.y == 2 && m->bounds_m.max.z == 3);
    size_t glass = 0;
    for (size_t i = 0; i < m->triangles; ++i) {
        glass += strcmp(m->material_name[m->material[i]], "glass") == 0;
    }
    CHECK(glass == 2);
    murk_mesh_destroy(m);
}

static void test_unit_and_up_axis_as_asked(void)
{
    murk_error err;
    murk_mesh *m = read_mesh(written("a.obj", OBJ), 0.5, 'y', &err);
    CHECK(m && m->bounds_m.max.x == 0.5 && m->bounds_m.max.z == 1);
    CHECK(m && m->bounds_m.min.y == -1.5 && m->bounds_m.max.y == 0);
    murk_mesh_destroy(m);
    m = read_mesh(written("a.obj", OBJ), 0, 'x', &err);
    CHECK(m && m->bounds_m.max.z == 1 && m->bounds_m.min.x == -2 &&
          m->bounds_m.min.y == -3);
    murk_mesh_destroy(m);
}

static void collada(char *text, size_t size, const char *unit, const char *up)
{
    snprintf(
        text, size,
        "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/"
        "11/COLLADASchema\" version=\"1.4.1\"><asset><unit name=\"u\" "
        "meter=\"%s\"/><up_axis>%s</up_axis></asset><library_geometries>"
        "<geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"pa\" "
        "count=\"12\">0 0 0 1 0 0 0 2 0 0 0 3</float_array><technique_common>"
        "<accessor source=\"#pa\" count=\"4\" stride=\"3\"><param name=\"X\" "
        "type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" "
        "type=\"float\"/></accessor></technique_common></source><vertices "
        "id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
        "<triangles count=\"2\"><input semantic=\"VERTEX\" source=\"#v\" "
        "offset=\"0\"/><p>0 1 2 0 1 3</p></triangles></mesh></geometry>"
        "</library_geometries><library_visual_scenes><visual_scene id=\"s\">"
        "<node id=\"n\"><translate>10 0 0</translate><instance_geometry "
        "url=\"#g\"/></node></visual_scene></library_visual_scenes><scene>"
        "<instance_visual_scene url=\"#s\"/></scene></COLLADA>",
        unit, up);
}

static void check_box(const murk_mesh *m, murk_vec3 min, murk_vec3 max)
{
    CHECK(m != NULL);
    if (m) {
        CHECK_NEAR(murk_length(murk_sub(m->bounds_m.min, min)), 0, 1e-6);
        CHECK_NEAR(murk_length(murk_sub(m->bounds_m.max, max)), 0, 1e-6);
    }
}

/* Unit and up axis in the file hold, unless the scene gives others. */
static void test_collada_unit_and_up_axis(void)
{
    /* A unit of 0.1 m with z up: by the file, by another unit, and with
     * another axis. */
    char text[4096];
    murk_error err;
    collada(text, sizeof text, "0.1", "Z_UP");
    const char *file = written("a.dae", text);
    murk_mesh *m = read_mesh(file, 0, 0, &err);
    check_box(m, murk_vec(1, 0, 0), murk_vec(1.1, 0.2, 0.3));
    murk_mesh_destroy(m);
    m = read_mesh(file, 1, 0, &err);
    check_box(m, murk_vec(10, 0, 0), murk_vec(11, 2, 3));
    murk_mesh_destroy(m);
    m = read_mesh(file, 1, 'y', &err);
    check_box(m, murk_vec(10, -3, 0), murk_vec(11, 0, 2));
    murk_mesh_destroy(m);
    /* With y up: by the file, and with another axis. */
    collada(text, sizeof text, "1", "Y_UP");
    file = written("a.dae", text);
    m = read_mesh(file, 0, 0, &err);
    check_box(m, murk_vec(10, -3, 0), murk_vec(11, 0, 2));
    murk_mesh_destroy(m);
    m = read_mesh(file, 0, 'z', &err);
    check_box(m, murk_vec(10, 0, 0), murk_vec(11, 2, 3));
    murk_mesh_destroy(m);
    /* With x up: by the file, and by the scene. */
    collada(text, sizeof text, "1", "X_UP");
    file = written("a.dae", text);
    m = read_mesh(file, 0, 0, &err);
    check_box(m, murk_vec(-2, -3, 10), murk_vec(0, 0, 11));
    murk_mesh_destroy(m);
    m = read_mesh(file, 0, 'x', &err);
    check_box(m, murk_vec(-2, -3, 10), murk_vec(0, 0, 11));
    murk_mesh_destroy(m);
}

/* An FBX file of one triangle; its unit is a number of centimetres. */
static const char *fbx(int up_axis, double cm)
{
    char text[2000];
    snprintf(text, sizeof text,
             "; FBX 7.3.0 project file\n"
             "FBXHeaderExtension: {\nFBXHeaderVersion: 1003\n"
             "FBXVersion: 7300\n}\n"
             "GlobalSettings: {\nVersion: 1000\nProperties70: {\n"
             "P: \"UpAxis\", \"int\", \"Integer\", \"\",%d\n"
             "P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",%g\n"
             "}\n}\n"
             "Objects: {\nGeometry: 1001, \"Geometry::g\", \"Mesh\" {\n"
             "Vertices: *9 {\na: 0,0,0,1,0,0,0,2,3\n}\n"
             "PolygonVertexIndex: *3 {\na: 0,1,-3\n}\n"
             "GeometryVersion: 124\n}\n"
             "Model: 1002, \"Model::m\", \"Mesh\" {\nVersion: 232\n}\n}\n"
             "Connections: {\nC: \"OO\",1001,1002\nC: \"OO\",1002,0\n}\n",
             up_axis, cm);
    return written("a.fbx", text);
}

/* Axis 0 is x, 1 is y, 2 is z, and is turned up as a scene's own `up` is. */
static void test_fbx_unit_and_up_axis(void)
{
    const murk_box turned[3] = {{{-2, -3, 0}, {0, 0, 1}},
                                {{0, -3, 0}, {1, 0, 2}},
                                {{0, 0, 0}, {1, 2, 3}}};
    for (int axis = 0; axis < 3; ++axis) {
        murk_error err;
        murk_mesh *m = read_mesh(fbx(axis, 100), 0, 0, &err);
        CHECK_TEXT(err.text, "");
        check_box(m, turned[axis].min, turned[axis].max);
        murk_mesh_destroy(m);
        m = read_mesh(fbx(axis, 2), 0, 0, &err); /* 2 cm */
        check_box(m, murk_scale(0.02, turned[axis].min),
                  murk_scale(0.02, turned[axis].max));
        murk_mesh_destroy(m);
        m = read_mesh(fbx(axis, 2), 1, 'z', &err); /* as the scene says */
        check_box(m, turned[2].min, turned[2].max);
        murk_mesh_destroy(m);
    }
}

/* Coordinates of a map, which single precision would round to half a metre,
 * keep their millimetres: they are counted from the mesh's own origin. */
static void test_far_meshes_keep_their_digits(void)
{
    static const char text[] = "v 500000.125 5500002.25 1000000.5\n"
                               "v 500001.125 5500002.25 1000000.5\n"
                               "v 500000.125 5500004.25 1000003.5\n"
                               "f 1 2 3\n";
    murk_error err;
    murk_mesh *m = read_mesh(written("map.obj", text), 0, 0, &err);
    CHECK_TEXT(err.text, "");
    CHECK(m && m->origin_m.x == 500000 && m->origin_m.y == 5500000 &&
          m->origin_m.z == 1000000);
    check_box(m, murk_vec(500000.125, 5500002.25, 1000000.5),
              murk_vec(500001.125, 5500004.25, 1000003.5));
    CHECK(m && m->vertex_m[3] == 1.125f && m->vertex_m[7] == 4.25f &&
          m->vertex_m[8] == 3.5f);
    /* the last place of a float between 4 and 8 m */
    CHECK(m && m->step_m == 0x1p-21);
    murk_mesh_destroy(m);
}

static void check_refused(const char *file, const char *part)
{
    murk_error err;
    murk_mesh *m = read_mesh(file, 0, 0, &err);
    CHECK(m == NULL);
    CHECK(err.code == MURK_BAD_FILE);
    CHECK_TEXT(err.where, "scene.yaml:3:5");
    CHECK_MENTIONS(err.text, part);
    CHECK(strchr(err.text, '\n') == NULL);
    murk_mesh_destroy(m);
}

static void test_what_is_no_mesh_is_refused(void)
{
    check_refused("/nowhere/a.obj", "No such file");
    check_refused(folder, "is a folder");
    check_refused(written("empty.obj", ""), "is empty");
    check_refused(written("a.txt", "hello"), "no mesh that can be read");
    check_refused(written("points.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"),
                  "no triangles");
    check_refused(written("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
                  "has an area");
    check_refused(written("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n"),
                  "");
    snprintf(path, sizeof path, "%s/pipe.obj", folder);
    CHECK(mkfifo(path, 0600) == 0);
    check_refused(path, "not a regular file");
    char text[256];
    snprintf(text, sizeof text, "mtllib %s/pipe.obj\n%s", folder,
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    murk_error err; /* a pipe named inside must not make the reader wait */
    murk_mesh *m = read_mesh(written("pipes.obj", text), 0, 0, &err);
    CHECK(m != NULL);
    murk_mesh_destroy(m);
}

/* A unit of 0 is none; an unknown axis and a negative or huge unit are bad. */
static void test_bad_units_and_axes_are_named(void)
{
    murk_error err;
    const char *file = written("a.obj", OBJ);
    murk_mesh *m = read_mesh(file, 1e9, 'z', &err);
    CHECK(m && m->bounds_m.max.x == 1e9);
    murk_mesh_destroy(m);
    const double bad[] = {-0.01, 1.01e9, NAN};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        CHECK(!read_mesh(file, bad[i], 0, &err));
        CHECK(err.code == MURK_BAD_VALUE);
        CHECK_MENTIONS(err.text, "must be above 0 and at most 1e9 m");
    }
    CHECK(!read_mesh(file, 1, 'w', &err));
    CHECK_TEXT(err.text, "up is w, must be x, y or z");
}

static void test_materials_are_found_by_name(void)
{
    murk_error err;
    murk_mesh *m = read_mesh(written("a.obj", OBJ), 0, 0, &err);
    const murk_material materials[3] = {
        {.name = "default"}, {.name = "Glass"}, {.name = "glass"}};
    const murk_surface_desc desc = {.shape = MURK_SHAPE_MESH,
                                    .mesh = m,
                                    .to_world = murk_affine_identity(),
                                    .material = -1};
    murk_surfaces *s = NULL;
    CHECK(m &&
          murk_surfaces_create(&s, &desc, 1, materials, 3, &err) == MURK_OK);
    CHECK(s && murk_surfaces_material_area(s, 2) == 1 + 1.5);
    CHECK(s && murk_surfaces_material_area(s, 1) == 0);
    CHECK(s && murk_surfaces_material_area(s, 0) == 3 + 3.5);
    murk_surfaces_destroy(s);
    s = NULL; /* whatever the case, where no name is exactly so */
    CHECK(m &&
          murk_surfaces_create(&s, &desc, 1, materials, 2, &err) == MURK_OK);
    CHECK(s && murk_surfaces_material_area(s, 1) == 1 + 1.5);
    murk_surfaces_destroy(s);
    murk_mesh_destroy(m);
}

/* One triangle that names `named`: an OBJ its materials, a glTF its buffer. */
static const char *naming(const char *name, const char *named)
{
    static const char gltf[] =
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{"
        "\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{"
        "\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"
        "\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
        "\"buffers\":[{\"uri\":\"%s\",\"byteLength\":36}]}";
    char text[1000];
    if (strstr(name, ".gltf")) {
        snprintf(text, sizeof text, gltf, named);
    } else {
        snprintf(text, sizeof text,
                 "mtllib %s\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n",
                 named);
    }
    return written(name, text);
}

static void check_reach(const char *file, const char *allow, bool is_read)
{
    const murk_mesh_import import = {.allow = allow};
    murk_mesh *m = NULL;
    murk_error err = {0};
    murk_mesh_read(&m, file, &import, "scene.yaml:3:5", &err);
    if ((m != NULL) != is_read) {
        printf("%s, allow %s: %s\n", file, allow ? allow : "-", err.text);
    }
    CHECK((m != NULL) == is_read);
    if (!is_read) {
        CHECK_MENTIONS(err.text, "outside its folder");
        CHECK_MENTIONS(err.text, "geometry.*.allow");
    }
    murk_mesh_destroy(m);
}

/* Files outside the mesh's folder are opened only where that is allowed, by
 * whatever path or link they are named. */
static void test_files_that_a_mesh_names(void)
{
    static const float triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const char *const kinds[] = {"obj", "gltf"};
    char inner[80], outside[100], link[120], name[40];
    snprintf(inner, sizeof inner, "%s/inner", folder);
    snprintf(outside, sizeof outside, "%s/outside.bin", folder);
    snprintf(link, sizeof link, "%s/link.bin", inner);
    CHECK(mkdir(inner, 0700) == 0);
    const char *const places[] = {outside, inner};
    for (int i = 0; i < 2; ++i) {
        char file[120];
        snprintf(file, sizeof file, i ? "%s/own.bin" : "%s", places[i]);
        write_bytes(file, triangle, sizeof triangle);
    }
    CHECK(symlink(outside, link) == 0);
    for (int k = 0; k < 2; ++k) {
        snprintf(name, sizeof name, "inner/m.%s", kinds[k]);
        check_reach(naming(name, "own.bin"), NULL, true);
        check_reach(naming(name, "../outside.bin"), NULL, false);
        check_reach(naming(name, "link.bin"), NULL, false);
        check_reach(naming(name, "link.bin"), folder, true);
        check_reach(naming(name, "../outside.bin"), folder, true);
        check_reach(naming(name, "../outside.bin"), "/usr", false);
    }
    /* the mesh itself may be a link; what it names is of the link's folder */
    char elsewhere[80], linked[110];
    snprintf(elsewhere, sizeof elsewhere, "%s/elsewhere", folder);
    snprintf(linked, sizeof linked, "%s/m.obj", elsewhere);
    CHECK(mkdir(elsewhere, 0700) == 0);
    CHECK(symlink(naming("inner/m.obj", "own.bin"), linked) == 0);
    check_reach(linked, NULL, true);
    murk_mesh *m = NULL;
    murk_error err = {0};
    const murk_mesh_import nowhere = {.allow = "/nowhere/at/all"};
    CHECK(murk_mesh_read(&m, naming("inner/m.obj", "own.bin"), &nowhere, "s",
                         &err) == MURK_BAD_VALUE);
    CHECK_MENTIONS(err.text, "allow: /nowhere/at/all is no folder");
}

int main(void)
{
    if (!mkdtemp(folder)) {
        check_skip("no temporary folder");
    }
    test_obj_is_metres_with_z_up();
    test_unit_and_up_axis_as_asked();
    test_collada_unit_and_up_axis();
    test_fbx_unit_and_up_axis();
    test_far_meshes_keep_their_digits();
    test_what_is_no_mesh_is_refused();
    test_bad_units_and_axes_are_named();
    test_materials_are_found_by_name();
    test_files_that_a_mesh_names();
    char clean[80];
    snprintf(clean, sizeof clean, "rm -r %s", folder);
    CHECK(system(clean) == 0);
    return check_done();
}
