/* Worlds: a scene as it was when the world was made, and the stage that is
 * built from it. */
#include "api/scene.h"

#include "base/log.h"
#include "base/number.h"
#include "base/progress.h"
#include "base/ranks.h"
#include "scene/override.h"
#include "scene/timeline.h"
#include "world/stage_build.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* murk_world_build(), with the files that the stage `earlier` has, NULL: none.
 */
static murk_status build_after(murk_world *world, const murk_stage *earlier,
                               murk_error *err)
{
    if (world->stage) {
        return MURK_OK;
    }
    murk_progress_begin_group("build", 0, "");
    const murk_status status =
        murk_stage_create_after(&world->stage, world->desc, earlier, err);
    murk_progress_end();
    world->load_s = murk_clock_s() - world->begun_s;
    return status;
}

murk_status murk_world_build(murk_world *world, murk_error *err)
{
    return build_after(world, NULL, err);
}

/* ---- later steps ---- */

/* True for failures that are due to the scene at one time. */
static bool is_of_step(murk_status status)
{
    return status == MURK_BAD_VALUE || status == MURK_BAD_FILE ||
           status == MURK_UNSUPPORTED;
}

/* Reads the scene at another time. */
static murk_status describe_at(murk_scene_desc **out, const murk_scene *scene,
                               double t_s, murk_error *err)
{
    char text[MURK_NUMBER_SIZE];
    murk_override *set = calloc(scene->n + 1, sizeof *set);
    if (!set) {
        return murk_no_memory(err, scene->name, "for a later step");
    }
    memcpy(set, scene->set, scene->n * sizeof *set);
    murk_number_print(text, t_s);
    murk_status status =
        murk_override_make(&set[scene->n], "timeline.at_s", text, err);
    if (!status) {
        status = murk_scene_desc_parse(out, scene->text, scene->name, set,
                                       scene->n + 1, err);
        murk_override_release(&set[scene->n]);
    }
    free(set);
    return status;
}

/* The stage with which a stage of `world` at this time shares meshes and grids
 * of the same files: of the worlds that the world comes after, NULL: none, that
 * of the same time; or else the one that was imported last. NULL: there is
 * none. */
static const murk_stage *find_shared(const murk_world *world,
                                     const murk_world *earlier, double t_s)
{
    const murk_stage *last = earlier ? earlier->stage : NULL;
    for (size_t i = 0; earlier && i < earlier->laters; ++i) {
        last = earlier->later[i];
        if (last->scene->timeline.at_s == t_s) {
            return last;
        }
    }
    return world->laters > 0 ? world->later[world->laters - 1] : last;
}

/* Reads a later step and imports its files. A step whose scene is wrong at its
 * time is left out: it has no plan either. */
static murk_status add_later(murk_world *world, const murk_scene *scene,
                             const murk_world *earlier, double t_s,
                             murk_error *err)
{
    murk_error why = {.size = sizeof why};
    murk_scene_desc *desc = NULL;
    murk_stage *stage = NULL;
    /* Read the scene, then the files. */
    murk_status status = describe_at(&desc, scene, t_s, &why);
    if (!status) {
        status = murk_stage_import_after(
            &stage, desc, find_shared(world, earlier, t_s), &why);
    }
    if (status) {
        murk_scene_desc_destroy(desc);
        if (is_of_step(status)) {
            murk_note("placement.look_ahead", "leaves out the step at %g s: %s",
                      t_s, why.text);
            return MURK_OK;
        }
        murk_call_pass(err, &why);
        return status;
    }
    world->later_desc[world->laters] = desc;
    world->later[world->laters++] = stage;
    return MURK_OK;
}

/* Reads the steps that a plan looks ahead to, before any ray device exists. */
static murk_status read_later(murk_world *world, const murk_scene *scene,
                              const murk_world *earlier, murk_error *err)
{
    const murk_scene_timeline *timeline = &world->desc->timeline;
    const size_t steps = murk_world_is_ahead(world)
                             ? (size_t)world->desc->placement.steps_ahead
                             : 1;
    murk_status status = MURK_OK;
    size_t found = 1;
    for (size_t i = 0;
         found < steps && i < murk_timeline_steps(timeline) && !status; ++i) {
        const double t_s = murk_timeline_time_s(timeline, i);
        if (t_s > timeline->at_s) {
            status = add_later(world, scene, earlier, t_s, err);
            ++found;
        }
    }
    return status;
}

/* Builds the world, and those of the later steps. */
static murk_status build_all(murk_world *world, const murk_scene *scene,
                             const murk_world *earlier, murk_error *err)
{
    murk_status status = read_later(world, scene, earlier, err);
    if (!status) {
        const double t_s = world->desc->timeline.at_s;
        status = build_after(world, find_shared(world, earlier, t_s), err);
    }
    for (size_t i = 0; i < world->laters && !status; ++i) {
        status = murk_stage_build(world->later[i], err);
    }
    return status;
}

/* ---- the world ---- */

/* Reads the scene, passes the notes and warnings of murk_scene_tell() to the
 * log, and builds the world unless there are conditions to place over. */
static murk_status build(murk_world *world, murk_scene *scene,
                         const murk_world *earlier, murk_error *err)
{
    if (!murk_memory_copy(&world->files, &scene->files)) {
        return murk_no_memory(err, scene->name, "for the world");
    }
    world->begun_s = murk_clock_s();
    murk_progress_begin_group("read", 0, "");
    const murk_status status = murk_scene_describe(&world->desc, scene, err);
    murk_progress_end();
    world->load_s = murk_clock_s() - world->begun_s;
    if (status) {
        return status;
    }
    if (!scene->is_step) {
        murk_scene_tell(world->desc);
    }
    return world->desc->placement.over == MURK_SCENE_OBJECTIVE_NONE
               ? build_all(world, scene, earlier, err)
               : MURK_OK;
}

murk_status murk_world_create_after(murk_world **out, murk_scene *scene,
                                    const murk_world *earlier,
                                    murk_error *error)
{
    *out = NULL;
    /* Build; a world that fails is released. */
    murk_call call = murk_call_begin(scene->context, &scene->files, error);
    murk_world *world = calloc(1, sizeof *world);
    murk_status status = MURK_NO_MEMORY;
    if (world) {
        world->references = 1;
        world->context = scene->context;
        ++world->context->references;
        status = build(world, scene, earlier, &call.failure);
    }
    if (murk_ranks_count() > 1) {
        const char *key = status ? "" : world->desc->whole_key;
        status = murk_ranks_check_same("scene", key, strlen(key), status,
                                       &call.failure);
    }
    status = murk_call_end_long(&call, status);
    if (status) {
        murk_world_release(world);
        return status;
    }
    murk_context_hold_arrays(world->context, &world->held, &world->files,
                             world->desc);
    *out = world;
    return MURK_OK;
}

murk_status murk_world_create(murk_world **out, murk_scene *scene,
                              murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    return out && scene ? murk_world_create_after(out, scene, NULL, error)
                        : murk_call_refuse(error, "out or scene is NULL");
}

/* The number of an item of the geometry that a text names by its name or
 * number; the number of items if there is none. */
static size_t item_of(const murk_scene_desc *scene, const char *text)
{
    char *end;
    const unsigned long number = strtoul(text, &end, 10);
    size_t i = 0;
    if (*text >= '0' && *text <= '9' && !*end) {
        return number < scene->geometries ? number : scene->geometries;
    }
    while (i < scene->geometries &&
           strcmp(text, scene->geometry[i].name) != 0) {
        ++i;
    }
    return i;
}

/* Fails if a track of the timeline moves the item, too. */
static murk_status check_free(const murk_scene_desc *scene, const char *item,
                              murk_error *error)
{
    const size_t i = item_of(scene, item);
    bool is_moved = false;
    for (size_t k = 0; k < scene->timeline.tracks && i < scene->geometries;
         ++k) {
        const murk_scene_track *track = &scene->timeline.track[k];
        is_moved = is_moved || (track->kind == MURK_TRACK_GEOMETRY &&
                                item_of(scene, track->item) == i);
    }
    return is_moved ? murk_call_refuse(error, "a track of the timeline moves "
                                              "this item; timeline.at_s says "
                                              "the time")
                    : MURK_OK;
}

/* Sets a key of an item of the geometry to a vector. */
static murk_status set_vector(murk_scene *scene, const char *item,
                              const char *key, const double value[3],
                              murk_error *error)
{
    char text[4 * MURK_NUMBER_SIZE], number[3][MURK_NUMBER_SIZE];
    const size_t size = strlen(item) + 64;
    char *path = malloc(size);
    if (!path) {
        return murk_no_memory(error, item, "for its place");
    }
    for (int i = 0; i < 3; ++i) {
        murk_number_print(number[i], value[i]);
    }
    snprintf(path, size, "geometry.%s.%s", item, key);
    snprintf(text, sizeof text, "[%s, %s, %s]", number[0], number[1],
             number[2]);
    const murk_status status = murk_scene_set(scene, path, text, error);
    free(path);
    return status;
}

murk_status murk_world_move(murk_world **out, murk_world *world,
                            const char *item, const double translate_m[3],
                            const double *rotate_deg, murk_error *error)
{
    if (out) {
        *out = NULL;
    }
    if (!out || !world || !item || !translate_m) {
        return murk_call_refuse(error,
                                "out, world, item or translate_m is NULL");
    }
    /* The resolved scene of the world, with the item in another place. */
    murk_scene *scene = NULL;
    murk_status status = check_free(world->desc, item, error);
    if (!status) {
        status = murk_scene_parse(&scene, world->context, world->desc->resolved,
                                  world->desc->path, error);
    }
    if (!status && !murk_memory_copy(&scene->files, &world->files)) {
        status = murk_no_memory(error, item, "for the moved world");
    }
    if (!status) {
        status = set_vector(scene, item, "translate_m", translate_m, error);
    }
    if (!status && rotate_deg) {
        status = set_vector(scene, item, "rotate_deg", rotate_deg, error);
    }
    if (!status) {
        status = murk_world_create_after(out, scene, world, error);
    }
    murk_scene_destroy(scene);
    return status;
}

void murk_world_release(murk_world *world)
{
    if (!world || --world->references > 0) {
        return;
    }
    murk_context_forget_arrays(world->context, &world->held);
    murk_fields_release(&world->replayed);
    murk_fields_release(&world->checked);
    for (size_t i = 0; i < world->laters; ++i) {
        murk_stage_destroy(world->later[i]);
        murk_scene_desc_destroy(world->later_desc[i]);
    }
    murk_stage_destroy(world->stage);
    murk_scene_desc_destroy(world->desc);
    murk_memory_release(&world->files);
    murk_context_release(world->context);
    free(world);
}

void murk_world_destroy(murk_world *world)
{
    murk_world_release(world);
}

void murk_world_bounds(const murk_world *world, double bounds_m[6])
{
    for (int i = 0; i < 6 && bounds_m; ++i) {
        bounds_m[i] = NAN;
    }
    if (!world || !bounds_m) {
        return;
    }
    murk_call call = murk_call_begin(world->context, &world->files, NULL);
    const murk_status status =
        murk_world_build((murk_world *)world, &call.failure);
    if (murk_call_end(&call, status)) {
        return;
    }
    const murk_box box =
        murk_scene_user_box(world->desc, world->stage->world.domain.box);
    for (int axis = 0; axis < 3; ++axis) {
        bounds_m[axis] = murk_component(box.min, axis);
        bounds_m[3 + axis] = murk_component(box.max, axis);
    }
}

int murk_world_bands(const murk_world *world)
{
    return world ? world->desc->bands : 0;
}

double murk_world_band_nm(const murk_world *world, int i)
{
    return world && i >= 0 && i < world->desc->bands ? world->desc->band_nm[i]
                                                     : NAN;
}
