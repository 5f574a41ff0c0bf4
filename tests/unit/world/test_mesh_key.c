/* The light key, which decides whether light can be taken over, depends on what
 * a mesh reads from the files that it names, and on its own file. */
#include "check.h"
#include "stage_text.h"
#include "world/stage_build.h"
#include "written.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/murk_mesh_key_XXXXXX";
static char scene_text[512];

static void write_mesh(const char *materials, const char *mesh)
{
    char path[64];
    snprintf(path, sizeof path, "%s/a.mtl", folder);
    write_text(path, materials);
    snprintf(path, sizeof path, "%s/a.obj", folder);
    write_text(path, mesh);
}

/* The key; the caller frees it. */
static char *key_of(void)
{
    murk_stage *stage = stage_text_create(scene_text, NULL);
    CHECK(stage);
    char *key = strdup(stage ? stage->light_key : "");
    /* The same beside another stage of the same files. */
    if (stage) {
        murk_stage *beside = NULL;
        murk_error err = {0};
        CHECK(!murk_stage_import_beside(&beside, stage->scene, stage, &err));
        CHECK_TEXT(beside ? beside->light_key : "", key);
        murk_stage_destroy(beside);
        stage_text_destroy(stage);
    }
    return key;
}

int main(void)
{
#define SQUARE "v 0 0 1\nv 1 0 1\nv 1 1 1\nusemtl oak\nf 1 2 3\n"
    static const char *const files[][2] = {
        {"newmtl oak\n", "mtllib a.mtl\n" SQUARE},
        {"newmtl ash\n", "mtllib a.mtl\n" SQUARE},
        {"newmtl oak\n", "mtllib a.mtl\n# again\n" SQUARE},
        {"newmtl ash\n", SQUARE},
        {"newmtl oak\n", SQUARE}};
    char *key[5];
    CHECK(mkdtemp(folder));
    snprintf(scene_text, sizeof scene_text,
             "murk: 1\ndomain: {min_m: [0, 0, 0], max_m: [2, 2, 2]}\n"
             "geometry: [{file: %s/a.obj}]\n"
             "materials: {default: {diffuse: 0.5}, oak: {diffuse: 0.2}}\n"
             "lights: [{type: point, position_m: [1, 1, 1.5], power_w: 1}]\n"
             "photons: {emit: 10}\n",
             folder);
    for (size_t i = 0; i < 5; ++i) {
        write_mesh(files[i][0], files[i][1]);
        key[i] = key_of();
    }
    CHECK(strcmp(key[0], key[1]) != 0); /* other materials in the named file */
    CHECK(strcmp(key[0], key[2]) != 0); /* another mesh */
    CHECK(strcmp(key[3], key[4]) == 0); /* the file is not named */
    for (size_t i = 0; i < 5; ++i) {
        free(key[i]);
    }
    char path[64];
    snprintf(path, sizeof path, "%s/a.mtl", folder);
    unlink(path);
    snprintf(path, sizeof path, "%s/a.obj", folder);
    unlink(path);
    rmdir(folder);
    return check_done();
}
