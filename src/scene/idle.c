/* Keys without effect: a table states for each such key under which
 * condition it has an effect. The tree is searched for keys of the table
 * that the user has set. */
#include "scene/idle.h"

#include "scene/keys.h"
#include "scene/walk.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- conditions under which a key has an effect ---- */

static bool has_threshold(const murk_scene_desc *s)
{
    return murk_detection_is(s->placement.detection,
                             MURK_DETECTION_HAS_THRESHOLD);
}

static bool has_power(const murk_scene_desc *s)
{
    return murk_detection_is(s->placement.detection, MURK_DETECTION_BY_POWER);
}

static bool has_neighbours(const murk_scene_desc *s)
{
    return has_power(s) && !(s->placement.power_radius_m > 0);
}

static bool bends_sight(const murk_scene_desc *s)
{
    return s->placement.through != MURK_SCENE_REFRACT ||
           !s->placement.by_normal;
}

static bool explores(const murk_scene_desc *s)
{
    return s->placement.knowledge == MURK_SCENE_EXPLORE;
}

static bool restarts(const murk_scene_desc *s)
{
    return s->placement.method == MURK_PLACE_BEST;
}

static bool branches(const murk_scene_desc *s)
{
    return (s->placement.method == MURK_PLACE_BEST ||
            s->placement.method == MURK_PLACE_EXACT) &&
           s->placement.knowledge == MURK_SCENE_KNOWN;
}

static bool has_interest(const murk_scene_desc *s)
{
    return s->placement.n_interests > 0;
}

static bool has_jitter(const murk_scene_desc *s)
{
    return s->placement.jitter_m > 0 || s->placement.jitter_rad > 0;
}

static bool has_objective(const murk_scene_desc *s)
{
    return s->placement.over != MURK_SCENE_OBJECTIVE_NONE;
}

static bool has_regret(const murk_scene_desc *s)
{
    return s->placement.over == MURK_SCENE_OBJECTIVE_REGRET;
}

static bool has_target(const murk_scene_desc *s)
{
    return s->sensors.target > 0;
}

static bool has_budget(const murk_scene_desc *s)
{
    return s->sensors.budget > 0;
}

static bool stores(const murk_scene_desc *s)
{
    return s->photons.maps != MURK_SCENE_MAPS_NONE;
}

static bool asks_time(const murk_scene_desc *s)
{
    for (size_t i = 0; i < s->n_lights; ++i) {
        const murk_scene_light *light = &s->lights[i];
        if (murk_scene_light_is_of_sky(light) ||
            light->schedule.when == MURK_SCENE_NIGHT ||
            light->schedule.when == MURK_SCENE_BY_CLOCK) {
            return true;
        }
    }
    return false;
}

static bool has_outside(const murk_scene_desc *s)
{
    return !s->domain.is_periodic;
}

#define WITHOUT "has no effect without "

const murk_idle_key murk_idle_keys[] = {
    {"domain.outside", has_outside, "has no effect with sides: periodic"},
    {"placement.threshold", has_threshold, WITHOUT "detection: threshold"},
    {"placement.power_radius_m", has_power, WITHOUT "detection: power"},
    {"placement.power_neighbours", has_neighbours,
     WITHOUT "detection: power, and beside power_radius_m"},
    {"placement.through", bends_sight,
     "bends no sightlines with visibility: normal"},
    {"placement.start_m", explores, WITHOUT "knowledge: explore"},
    {"placement.restarts", restarts, WITHOUT "method: best"},
    {"placement.nodes", branches,
     WITHOUT "method: best or exact, and knowledge: known"},
    {"placement.at_least", has_target, WITHOUT "sensors.target"},
    {"placement.elsewhere", has_interest, WITHOUT "interest"},
    {"placement.jitter_draws", has_jitter, WITHOUT "jitter_m or jitter_deg"},
    {"placement.condition_weights", has_objective,
     WITHOUT "over: mean or worst"},
    {"placement.regret", has_regret, WITHOUT "over: regret"},
    {"sensors.types.*.aperture_m2", has_power, WITHOUT "detection: power"},
    {"sensors.types.*.quantum_efficiency", has_power,
     WITHOUT "detection: power"},
    {"sensors.types.*.exposure_s", has_power, WITHOUT "detection: power"},
    {"sensors.types.*.target_m2", has_power, WITHOUT "detection: power"},
    {"sensors.types.*.target_m3", has_power, WITHOUT "detection: power"},
    {"sensors.types.*.cost", has_budget, WITHOUT "sensors.budget"},
    {"photons.store_when", stores, "has no effect with maps: none"},
    {"photons.max_stored", stores, "has no effect with maps: none"},
    {"site", asks_time, WITHOUT "a light of the sky or a lamp with a schedule"},
    {NULL, NULL, NULL},
};

static bool acts_anywhere(const murk_idle_key *inert,
                          const murk_scene_desc *scene)
{
    bool acts = inert->acts(scene);
    for (size_t i = 0; i < scene->n_conditions; ++i) {
        acts = acts || inert->acts(scene->conditions[i].scene);
    }
    return acts;
}

/* ---- keys set by the user ---- */

static bool is_preset(const murk_yaml *node, const char *preset)
{
    double is, want;
    char *end;
    if (!preset || node->kind != MURK_YAML_SCALAR) {
        return false;
    }
    want = strtod(preset, &end);
    return murk_yaml_number(node, &is) && end != preset && *end == '\0'
               ? is == want
               : strcmp(node->text, preset) == 0;
}

/* True if the user has set the node to another value than the default.
 * Resolved scenes have all keys, so a default value does not count. */
static bool is_set_by_user(const murk_yaml *node, const murk_key *row)
{
    if (node->kind != MURK_YAML_MAP || !row->keys) {
        return node->line != 0 && !is_preset(node, row->preset);
    }
    for (size_t i = 0; i < node->n; ++i) {
        const murk_key *inner = murk_keys_find(row->keys, node->key[i]);
        if (!inner || is_set_by_user(node->child[i], inner)) {
            return true;
        }
    }
    return false;
}

/* ---- the list ---- */

static bool add(murk_scene_desc *scene, const murk_yaml *node, const char *key,
                const char *text)
{
    murk_scene_idle *grown =
        realloc(scene->idle, (scene->idles + 1) * sizeof *grown);
    if (!grown) {
        return false;
    }
    scene->idle = grown;
    murk_scene_idle *idle = &scene->idle[scene->idles++];
    murk_walk_where(node, key, true, idle->where);
    idle->text = text;
    return true;
}

/* Follows the rest of a table key from a node; the first `used` bytes of
 * key[] are the path of the node. Adds every matching key that the user has
 * set. */
static bool follow(murk_scene_desc *scene, const murk_idle_key *inert,
                   const char *rest, const murk_yaml *node,
                   const murk_keys *keys, char key[MURK_WALK_KEY_SIZE],
                   size_t used)
{
    const char *dot = strchr(rest, '.');
    const size_t length = dot ? (size_t)(dot - rest) : strlen(rest);
    bool has_memory = true;
    for (size_t i = 0; i < node->n && has_memory; ++i) {
        char number[24];
        snprintf(number, sizeof number, "%zu", i);
        const char *name = node->key ? node->key[i] : number;
        const bool is_any = length == 1 && rest[0] == '*';
        const murk_key *row = is_any ? NULL : murk_keys_find(keys, name);
        if (!is_any && (strlen(name) != length ||
                        strncmp(name, rest, length) != 0 || !row)) {
            continue;
        }
        /* Extend the path by the name of the child. */
        const int more = snprintf(key + used, MURK_WALK_KEY_SIZE - used, "%s%s",
                                  used ? "." : "", name);
        if (more < 0 || used + (size_t)more >= MURK_WALK_KEY_SIZE) {
            continue; /* longer than any key */
        }
        const murk_yaml *child = node->child[i];
        /* Descend, or add the key at the end of the path. */
        if (dot) {
            has_memory =
                follow(scene, inert, dot + 1, child, is_any ? keys : row->keys,
                       key, used + (size_t)more);
        } else if (is_set_by_user(child, row)) {
            has_memory = add(scene, child, key, inert->text);
        }
        key[used] = '\0';
    }
    return has_memory;
}

static bool has_region(const murk_scene_desc *scene, const char *medium)
{
    bool is_used = false;
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_medium *of = &scene->media[scene->regions[i].medium];
        is_used = is_used || strcmp(of->name, medium) == 0;
    }
    for (size_t i = 0; i < scene->n_conditions; ++i) {
        is_used = is_used || has_region(scene->conditions[i].scene, medium);
    }
    return is_used;
}

static bool find_media(murk_scene_desc *scene, const murk_yaml *media)
{
    bool has_memory = true;
    for (size_t m = 0; media && m < media->n && has_memory; ++m) {
        if (!has_region(scene, media->key[m])) {
            char key[MURK_WALK_KEY_SIZE];
            snprintf(key, sizeof key, "media.%s", media->key[m]);
            has_memory = add(scene, media->child[m], key,
                             "has no effect: it is in no region");
        }
    }
    return has_memory;
}

bool murk_idle_find(murk_scene_desc *scene, const murk_yaml *root)
{
    bool has_memory = find_media(scene, murk_yaml_get(root, "media"));
    const murk_idle_key *inert = murk_idle_keys;
    for (; inert->key && has_memory; ++inert) {
        char key[MURK_WALK_KEY_SIZE] = "";
        if (!acts_anywhere(inert, scene)) {
            has_memory = follow(scene, inert, inert->key, root,
                                &murk_scene_keys, key, 0);
        }
    }
    return has_memory;
}
