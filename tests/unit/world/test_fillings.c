/* Grids, frames and profiles on their way from a scene to its world. Nothing
 * here is random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "base/host.h"
#include "check.h"
#include "medium/grid_write.h"
#include "stage_text.h"
#include "world/stage_build.h"

#include <stdlib.h>
#include <unistd.h>

static char folder[64], text[1024];

/* Writes a frame with a density, of which the first voxel is given, and an
 * albedo, 2 x 1 x 1 m. */
static void write_density(int frame, float first)
{
    const float density[2] = {first, 2}, albedo[2] = {0.25F, 0.75F};
    const murk_grid_field fields[] = {{"density", density, NULL},
                                      {"albedo", albedo, NULL}};
    const size_t size[3] = {2, 1, 1};
    const murk_affine place = murk_affine_identity();
    char path[96];
    murk_error err = {0};
    snprintf(path, sizeof path, "%s/f.%03d.vdb", folder, frame);
    CHECK(murk_grid_write(path, fields, 2, size, &place, &err) == MURK_OK);
    CHECK_TEXT(err.text, "");
}

/* The stage of a scene whose media and regions are given, NULL ends the
 * overrides. */
static murk_stage *stage_of(const char *media_and_regions,
                            const char *const *overrides)
{
    snprintf(text, sizeof text,
             "murk: 1\n"
             "domain: {min_m: [-9, -9, -9], max_m: [9, 9, 9]}\n"
             "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n"
             "%s",
             media_and_regions);
    return stage_text_create(text, overrides);
}

/* A sequence of frames 1, 2, 5. */
static void write_frame(int frame)
{
    write_density(frame, (float)frame);
}

static double extinction(const murk_stage *stage, double x, double y, double z)
{
    return murk_media_extinction(stage->media, 0, 0, murk_vec(x, y, z));
}

static double scattering(const murk_stage *stage, double x, double y, double z)
{
    return murk_media_scattering(stage->media, 0, 0, murk_vec(x, y, z));
}

static void test_frames_and_albedo(void)
{
    char scene[512], frame_5[] = "media.m.frame=5", other[128];
    snprintf(scene, sizeof scene,
             "media:\n  m: {vdb: %s/f.###.vdb, frame: 2, extinction_per_m: 3, "
             "grid: density, albedo: {grid: albedo}}\n"
             "regions: [{medium: m}]\n",
             folder);
    murk_stage *stage = stage_of(scene, NULL);
    CHECK(stage && extinction(stage, 0, 0, 0) == 6);
    CHECK(stage && scattering(stage, 0, 0, 0) == 1.5);
    CHECK(stage && scattering(stage, 1, 0, 0) == 4.5);
    stage_text_destroy(stage);
    const char *const later[] = {frame_5, NULL};
    stage = stage_of(scene, later);
    CHECK(stage && extinction(stage, 0, 0, 0) == 15);
    CHECK(stage && scattering(stage, 0, 0, 0) == 3.75);
    stage_text_destroy(stage);
    /* another file's albedo; linear half way between the voxels */
    snprintf(other, sizeof other, "media.m.albedo.vdb=%s/f.001.vdb", folder);
    const char *const linear[] = {other, "media.m.interpolation=linear", NULL};
    stage = stage_of(scene, linear);
    CHECK(stage && extinction(stage, 0.5, 0, 0) == 6);
    CHECK(stage && scattering(stage, 0.5, 0, 0) == 3);
    CHECK(stage && extinction(stage, 1.5, 0, 0) == 3);
    CHECK(stage && scattering(stage, 1.5, 0, 0) == 0.75 * 3);
    stage_text_destroy(stage);
}

/* A scene whose albedo does not change in time; 2 x 1 x 1 m, as the frames. */
static void scene_in_time(char scene[512], const char *frame)
{
    snprintf(scene, 512,
             "media:\n  m: {vdb: %s/f.###.vdb, frame: %s, extinction_per_m: 3, "
             "grid: density, albedo: {grid: albedo, vdb: %s/f.005.vdb}}\n"
             "regions: [{medium: m}]\n",
             folder, frame, folder);
}

/* The number of lines of checksums in the light key of a stage. */
static size_t sums_in(const murk_stage *stage)
{
    size_t n = 0;
    const char *at = stage->light_key;
    while ((at = strstr(at, "checksum: "))) {
        at += strlen("checksum: ");
        ++n;
    }
    return n;
}

static void test_a_time_between_frames(void)
{
    /* Frame 1 has the densities 1 and 2, frame 2 has 2 and 2. */
    char scene[512];
    scene_in_time(scene, "1.25");
    murk_stage *stage = stage_of(scene, NULL);
    CHECK(stage && extinction(stage, 0, 0, 0) == 3.75);
    CHECK(stage && extinction(stage, 1, 0, 0) == 6);
    CHECK(stage && scattering(stage, 0, 0, 0) == .25 * 3.75);
    murk_stage *other = stage_of(scene, NULL);
    CHECK(stage && other && strcmp(stage->light_key, other->light_key) == 0);
    stage_text_destroy(other);
    /* The light key has the checksums of both frames and of the albedos. */
    scene_in_time(scene, "1");
    murk_stage *whole = stage_of(scene, NULL);
    CHECK(stage && whole && sums_in(stage) == sums_in(whole) + 1);
    stage_text_destroy(whole);
    /* Another next frame gives another key. */
    write_density(2, 7);
    scene_in_time(scene, "1.25");
    other = stage_of(scene, NULL);
    CHECK(other && extinction(other, 0, 0, 0) == 3 * (.75 + .25 * 7));
    CHECK(stage && other && strcmp(stage->light_key, other->light_key) != 0);
    stage_text_destroy(other);
    stage_text_destroy(stage);
    write_density(2, 2);
}

/* True if the stage `after`, made beside `stage`, is as `alone` and shares the
 * grids of the first medium, or does not. */
static void check_shared(const char *scene, const murk_stage *stage,
                         bool is_shared)
{
    murk_stage *alone = stage_of(scene, NULL), *after = NULL;
    murk_error err = {0};
    CHECK(alone && murk_stage_create_after(&after, alone->scene, stage, &err) ==
                       MURK_OK);
    if (after) {
        CHECK((after->grid[0] == stage->grid[0]) == is_shared);
        CHECK((after->fillings->albedo[0] == stage->fillings->albedo[0]) ==
              is_shared);
        CHECK(strcmp(after->light_key, alone->light_key) == 0);
        CHECK(extinction(after, 0, 0, 0) == extinction(alone, 0, 0, 0));
        CHECK(scattering(after, 1, 0, 0) == scattering(alone, 1, 0, 0));
    }
    murk_stage_destroy(after);
    stage_text_destroy(alone);
}

/* A stage shares grids with an earlier one if the files have equal contents and
 * the same grids are taken from them. */
static void test_equal_files_are_shared(void)
{
    char scene[512];
    /* Files are read beside a ray device, whose threads a fork would not have.
     */
    murk_host_now()->importing = MURK_IMPORT_IN_PROCESS;
    scene_in_time(scene, "1");
    murk_stage *stage = stage_of(scene, NULL);
    CHECK(stage);
    check_shared(scene, stage, true);
    scene_in_time(scene, "2");
    check_shared(scene, stage, false);
    scene_in_time(scene, "1.25");
    check_shared(scene, stage, false);
    /* The same file with other contents. */
    scene_in_time(scene, "1");
    write_density(1, 3);
    check_shared(scene, stage, false);
    write_frame(1);
    check_shared(scene, stage, true);
    stage_text_destroy(stage);
    /* Between two frames: at the same time and at another one. */
    scene_in_time(scene, "1.25");
    stage = stage_of(scene, NULL);
    check_shared(scene, stage, true);
    scene_in_time(scene, "1.5");
    check_shared(scene, stage, false);
    stage_text_destroy(stage);
    murk_host_now()->importing = MURK_IMPORT_FORKS;
}

static void write_text(const char *name, const char *content, size_t size)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *to = fopen(path, "wb");
    CHECK(to && fwrite(content, 1, size, to) == size);
    CHECK(to && fclose(to) == 0);
}

/* True if the mesh of a scene is shared with the stage of the same scene, which
 * `change`, NULL: none, alters in between. */
static bool is_mesh_shared(const char *file, void (*change)(void))
{
    char scene[256];
    murk_error err = {0};
    snprintf(scene, sizeof scene,
             "materials: {wall: {diffuse: 0.5}}\n"
             "geometry: [{file: %s/%s, up: z, material: wall}]\n",
             folder, file);
    murk_stage *stage = stage_of(scene, NULL), *after = NULL;
    if (change) {
        change();
    }
    CHECK(stage && murk_stage_create_after(&after, stage->scene, stage, &err) ==
                       MURK_OK);
    const bool is_shared = after && after->mesh[0] == stage->mesh[0];
    murk_stage_destroy(after);
    stage_text_destroy(stage);
    return is_shared;
}

static const char triangle[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

static void move_triangle(void)
{
    static const char moved[] = "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n";
    write_text("m.obj", moved, strlen(moved));
}

/* A mesh whose file names others may change without the file: geometry of glTF
 * lies in its buffers, and names of materials in the library of an OBJ file. */
static void test_meshes_that_are_shared(void)
{
    static const char with_library[] = "mtllib m.mtl\nusemtl a\nv 0 0 0\n"
                                       "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
    static const char gltf[] =
        "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0,"
        " \"scenes\": [{\"nodes\": [0]}], \"nodes\": [{\"mesh\": 0}],"
        " \"meshes\": [{\"primitives\": [{\"attributes\":"
        " {\"POSITION\": 0}}]}],"
        " \"buffers\": [{\"uri\": \"m.bin\", \"byteLength\": 36}],"
        " \"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}],"
        " \"accessors\": [{\"bufferView\": 0, \"componentType\": 5126,"
        " \"count\": 3, \"type\": \"VEC3\"}]}";
    static const float corner[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    murk_host_now()->importing = MURK_IMPORT_IN_PROCESS;
    /* Files that name others, and one that does not. */
    write_text("m.obj", triangle, strlen(triangle));
    write_text("library.obj", with_library, strlen(with_library));
    write_text("m.mtl", "newmtl a\n", strlen("newmtl a\n"));
    write_text("m.gltf", gltf, strlen(gltf));
    write_text("m.bin", (const char *)corner, sizeof corner);
    CHECK(is_mesh_shared("m.obj", NULL));
    CHECK(!is_mesh_shared("m.obj", move_triangle));
    CHECK(!is_mesh_shared("library.obj", NULL));
    CHECK(!is_mesh_shared("m.gltf", NULL));
    murk_host_now()->importing = MURK_IMPORT_FORKS;
    const char *const names[] = {"m.obj", "library.obj", "m.mtl", "m.gltf",
                                 "m.bin"};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        remove(path);
    }
}

static void refuses(const char *media, const char *override, const char *part)
{
    /* Write a scene with these media. */
    char path[128];
    snprintf(path, sizeof path, "%s/s.yaml", folder);
    FILE *file = fopen(path, "w");
    CHECK(file != NULL);
    if (!file) {
        return;
    }
    fprintf(file,
            "murk: 1\ndomain: {min_m: [0, 0, 0], max_m: [1, 1, 1]}\n"
            "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n%s",
            media);
    fclose(file);
    /* The scene can be read, but no stage can be made of it: the message
     * names the medium. */
    const murk_override option = {.text = override};
    murk_scene_desc *scene = NULL;
    murk_stage *stage = NULL;
    murk_error err = {0};
    CHECK(murk_scene_desc_read(&scene, path, &option, override ? 1 : 0, &err) ==
          MURK_OK);
    CHECK(scene && murk_stage_create(&stage, scene, &err) != MURK_OK);
    CHECK(stage == NULL);
    CHECK_MENTIONS(err.text, part);
    CHECK_MENTIONS(err.where, "media.m");
    murk_scene_desc_destroy(scene);
    remove(path);
}

static void test_a_missing_frame_names_those_there_are(void)
{
    static const char given[] = "media: {m: {vdb: f.###.vdb, frame: 2, grid: "
                                "density, extinction_per_m: 1, albedo: 1}}\n";
    static const char left_out[] = "media: {m: {vdb: f.###.vdb, grid: density, "
                                   "extinction_per_m: 1, albedo: 1}}\n";
    refuses(given, "media.m.frame=3",
            "f.###.vdb is not there; there are 1..2, 5");
    refuses(given, "media.m.frame=3", "frame 3 of ");
    refuses(given, "media.m.frame=2.5",
            "frame 2.5 is between two frames, and frame 3 of ");
    refuses(given, "media.m.frame=2.5",
            "f.###.vdb is not there; there are 1..2, 5");
    refuses(given, "media.m.frame=4.5", "and frame 4 of ");
    refuses(given, "media.m.frame=3.5", "and frame 3 of ");
    refuses(left_out, NULL,
            "stands for a sequence: misses frame, there are 1..2, 5");
    refuses(given, "media.m.albedo.grid=none", "no grid named none");
    refuses(given, "media.m.albedo.grid=density", "albedo must be 0..1");
}

static void test_a_profile_and_its_extent(void)
{
    static const char scene[] =
        "bands_nm: [450, 550]\n"
        "media:\n"
        "  m: {profile: {z_m: [0, 1, 1, 3], extinction_per_m: [1, [2, 4], 1, "
        "0]}, albedo: [1, 0.5]}\n"
        "regions:\n"
        "  - {medium: m}\n"
        "  - {medium: m, box: {min_m: [5, 5, -5], max_m: [6, 6, 2]}, "
        "translate_m: [0, 0, 4]}\n";
    murk_stage *stage = stage_of(scene, NULL);
    if (!stage) {
        return;
    }
    const murk_vec3 p = {0, 0, 0.5};
    CHECK(murk_media_extinction(stage->media, 0, 0, p) == 1.5);
    CHECK(murk_media_extinction(stage->media, 1, 0, p) == 2.5);
    CHECK(murk_media_scattering(stage->media, 1, 0, p) == 1.25);
    CHECK(extinction(stage, 0, 0, 1) == 1 && extinction(stage, 0, 0, 2) == 0.5);
    CHECK(extinction(stage, 0, 0, 3.5) == 0 &&
          extinction(stage, 0, 0, -1) == 0);
    CHECK(extinction(stage, 5.5, 5.5, 5.5) == 0.75); /* 1.5 m up */
    const murk_box box = murk_media_bounds(stage->media);
    CHECK(box.min.z == -1 && box.max.z == 6);
    stage_text_destroy(stage);

    static const char alone[] =
        "murk: 1\n"
        "lights: [{type: point, position_m: [5, 5, 5], power_w: 1}]\n"
        "media: {m: {profile: {z_m: [0, 3], extinction_per_m: [1, 1]}, albedo: "
        "1}}\n"
        "regions: [{medium: m, box: {min_m: [0, 0, -5], max_m: [10, 10, "
        "9]}}]\n";
    stage = stage_text_create(alone, NULL);
    CHECK(stage && stage->world.domain.box.min.z == -0.1);
    CHECK(stage && stage->world.domain.box.max.z == 5.1); /* the lamp */
    stage_text_destroy(stage);
}

int main(void)
{
    snprintf(folder, sizeof folder, "%s/murk_fillings_XXXXXX", P_tmpdir);
    if (!mkdtemp(folder)) {
        return 1;
    }
    const int frames[] = {1, 2, 5};
    for (int i = 0; i < 3; ++i) {
        write_frame(frames[i]);
    }
    test_frames_and_albedo();
    test_a_time_between_frames();
    test_equal_files_are_shared();
    test_meshes_that_are_shared();
    test_a_missing_frame_names_those_there_are();
    test_a_profile_and_its_extent();
    for (int i = 0; i < 3; ++i) {
        char path[96];
        snprintf(path, sizeof path, "%s/f.%03d.vdb", folder, frames[i]);
        remove(path);
    }
    rmdir(folder);
    return check_done();
}
