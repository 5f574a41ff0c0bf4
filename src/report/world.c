/* The world that the view shows: surfaces and media of the scene, and the media
 * of conditions and steps. */
#include "report/scene.h"
#include "world/stage_build.h"

#include <string.h>

static bool same_file(const char *a, const char *b)
{
    return a == b || (a && b && strcmp(a, b) == 0);
}

/* True if the media of one scene can be built with the boundary meshes of the
 * other: same numbers of media and regions, and the same meshes of regions.
 */
static bool has_same_meshes(const murk_scene_desc *a, const murk_scene_desc *b)
{
    bool is_same = a->n_regions == b->n_regions && a->n_media == b->n_media;
    for (size_t i = 0; is_same && i < a->n_regions; ++i) {
        is_same = same_file(a->regions[i].solid.mesh, b->regions[i].solid.mesh);
    }
    return is_same;
}

static const murk_scene_desc *condition_of(const murk_scene_desc *scene,
                                           const char *name)
{
    for (size_t c = 0; c < scene->n_conditions; ++c) {
        if (strcmp(scene->conditions[c].name, name) == 0) {
            return scene->conditions[c].scene;
        }
    }
    return NULL;
}

/* The scene of the condition or step that a state stands for, if its media have
 * to be built. NULL if the state is neither, or if it has the same world as the
 * scene. Also NULL if its media cannot be built with the boundary meshes of the
 * scene; the media of the scene are then shown instead. */
static const murk_scene_desc *other_media(const murk_report_scene *s,
                                          size_t state)
{
    const murk_shown_state *shown = &s->state[state];
    const murk_scene_desc *of =
        shown->scene ? shown->scene : condition_of(s->scene, shown->name);
    return of && strcmp(of->world_key, s->scene->world_key) != 0 &&
                   has_same_meshes(of, s->scene)
               ? of
               : NULL;
}

static murk_status build_media(murk_report_scene *s, size_t state,
                               const murk_scene_desc *of, murk_error *why)
{
    murk_shown_state *to = &s->state[state];
    const murk_status status =
        murk_phases_create(&to->phases, of, to->fillings, why);
    return status ? status
                  : murk_stage_media(&to->media, s->stage, of, to->fillings,
                                     to->phases, why);
}

void murk_report_build(murk_report_scene *s)
{
    static const char lost[] = "What the scene names cannot be read again, so "
                               "surfaces and media are not shown";
    const murk_scene_desc *of[MURK_SHOWN_STATES_MAX] = {0};
    murk_error why = {0};
    /* files are imported before building, which makes a ray device */
    murk_status status = murk_stage_import(&s->stage, s->scene, &why);
    for (size_t i = 0; i < s->states && !status; ++i) {
        of[i] = other_media(s, i);
        if (of[i]) {
            status = murk_fillings_create(&s->state[i].fillings, of[i], NULL,
                                          NULL, &why);
        }
    }
    if (!status) {
        status = murk_stage_build(s->stage, &why);
    }
    for (size_t i = 0; i < s->states && !status; ++i) {
        status = of[i] ? build_media(s, i, of[i], &why) : MURK_OK;
    }
    if (status) {
        murk_report_scene_note(s, lost, &why);
        murk_stage_destroy(s->stage);
        s->stage = NULL;
    }
}
