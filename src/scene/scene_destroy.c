/* Frees a scene. The key table says which members of the structs are allocated;
 * members that no key or a reader of its own (MURK_KEY_OWN) fills are freed one
 * by one. */
#include "scene/scene.h"

#include <stdlib.h>
#include <string.h>

#include "scene/keys.h"
#include "scene/weather.h"

/* Frees the pointer that lies `at` bytes into a struct. The pointer becomes
 * NULL, because several keys may fill one member. */
static void free_member(void *item, size_t at)
{
    void *member;
    void *const none = NULL;
    memcpy(&member, (char *)item + at, sizeof member);
    free(member);
    memcpy((char *)item + at, &none, sizeof none);
}

/* Frees what a row has allocated for a struct. */
static void release(void *context, const murk_key *key, void *item)
{
    (void)context;
    switch (key->kind) {
    /* Texts and lists. */
    case MURK_KEY_TEXT:
        if (key->size == sizeof(char *)) {
            free_member(item, key->at);
        }
        break;
    case MURK_KEY_PATH:
        free_member(item, key->at);
        break;
    case MURK_KEY_NUMBER_LIST:
    case MURK_KEY_SPECTRUM_LIST:
    case MURK_KEY_REFERENCES:
        free_member(item, key->at + offsetof(murk_scene_numbers, value));
        break;
    /* Arrays of structs, after the structs. */
    case MURK_KEY_LIST:
    case MURK_KEY_MAPS:
    case MURK_KEY_NAMED:
        free_member(item, key->keys->array_at);
        break;
    default:
        break;
    }
}

void murk_scene_desc_destroy(murk_scene_desc *scene)
{
    if (!scene) {
        return;
    }
    /* Members that no key or a reader of its own fills. */
    murk_weather_release(&scene->weather);
    for (size_t i = 0; i < scene->n_media; ++i) {
        free(scene->media[i].law.value);
        free(scene->media[i].law.density);
        free(scene->media[i].vdb_frames);
        free(scene->media[i].vdb_next);
        for (size_t k = 0; k < scene->media[i].n_phases; ++k) {
            murk_mixture_destroy(scene->media[i].phase[k].mixture);
        }
    }
    for (size_t i = 0; i < scene->n_lights; ++i) {
        murk_luminaire_destroy(scene->lights[i].luminaire);
        murk_lamp_spectrum_destroy(scene->lights[i].spectrum);
    }
    murk_scene_points *points = &scene->sensors.candidates.points;
    for (size_t i = 0; i < points->files; ++i) {
        free(points->file[i]);
    }
    free(points->file);
    free(points->position);
    for (size_t i = 0; i < scene->n_conditions; ++i) {
        murk_scene_desc_destroy(scene->conditions[i].scene);
    }
    /* Members that keys fill, then the texts of the scene. */
    murk_keys_visit(&murk_scene_keys, scene, release, NULL);
    free(scene->idle);
    free(scene->resolved);
    free(scene->light_key);
    free(scene->rules_key);
    free(scene->whole_key);
    free(scene->world_key);
    for (size_t i = 0; i < scene->files; ++i) {
        free(scene->file[i]);
    }
    free(scene->file);
    free(scene->path);
    free(scene);
}
