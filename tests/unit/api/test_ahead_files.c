/* Steps that a plan looks ahead to share the meshes and grids of equal files
 * with each other, with the own step, and with the steps of the world before,
 * which may have other frames of a sequence of grids. */
#include "api/scene.h"
#include "check.h"
#include "written.h"

#include <stdlib.h>
#include <unistd.h>

static const char scene_form[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "timeline: {from_s: 0, to_s: 3, every_s: 1}\n"
    "geometry: [{file: %s/floor.obj, up: z}]\n"
    "media: {fog: {vdb: '%s', extinction_per_m: 1, albedo: 0.9}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [2, 2, 2], power_w: 1}]\n"
    "photons: {emit: 100}\n"
    "sensors:\n"
    "  types: [{name: node, range_m: 5}]\n"
    "  candidates: {grid: {min_m: [1, 1, 1], max_m: [3, 3, 2], size: [2, 2, "
    "2]}}\n"
    "  count: 1\n"
    "placement: {look_ahead: 3}\n";

static bool shares(const murk_stage *a, const murk_stage *b)
{
    return a->mesh[0] && a->mesh[0] == b->mesh[0] && a->grid[0] &&
           a->grid[0] == b->grid[0];
}

int main(void)
{
    char folder[] = "/tmp/murk_ahead_XXXXXX", top[4096], vdb[4200];
    char text[sizeof scene_form + sizeof folder + sizeof vdb], file[64];
    murk_context *context = NULL;
    murk_scene *scene = NULL;
    murk_world *first = NULL, *second = NULL;
    murk_error error = MURK_ERROR_NONE;
    if (!getcwd(top, sizeof top) || !mkdtemp(folder)) {
        return 1;
    }
    snprintf(file, sizeof file, "%s/floor.obj", folder);
    snprintf(vdb, sizeof vdb, "%s/tests/physics/scenes/step-cloud.vdb", top);
    snprintf(text, sizeof text, scene_form, folder, vdb);
    write_text(file, "v 0 0 0.5\nv 4 0 0.5\nv 4 4 0.5\nf 1 2 3\n");
    /* The world of a step, and the one after it. */
    CHECK(!murk_context_create(&context, NULL, NULL));
    CHECK(!murk_scene_parse(&scene, context, text, "room", &error));
    CHECK(!murk_world_create(&first, scene, &error));
    CHECK_TEXT(error.text, "");
    CHECK(!murk_scene_set(scene, "timeline.at_s", "1", NULL));
    CHECK(!murk_world_create_after(&second, scene, first, &error));
    if (first && second) {
        CHECK(first->laters == 2 && second->laters == 2);
        for (size_t i = 0; i < 2; ++i) {
            CHECK(shares(first->stage, first->later[i]));
            CHECK(shares(first->stage, second->later[i]));
        }
        CHECK(shares(first->stage, second->stage));
    }
    /* What is shared outlives the world that read it. */
    murk_world_destroy(first);
    CHECK(second && second->stage->mesh[0]);
    murk_world_destroy(second);
    murk_scene_destroy(scene);
    murk_context_destroy(context);
    unlink(file);
    rmdir(folder);
    return check_done();
}
