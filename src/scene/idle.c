/* Finds keys that have no effect. A table lists the keys that are used only
 * with a certain feature of a scene. Keys of the table that the user has set
 * are reported if neither the scene nor a condition has the feature. */
#include "scene/idle.h"

#include "scene/key_path.h"
#include "scene/override.h"
#include "scene/walk.h"
#include "scene/weather.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- uses of keys ---- */

/* The features of a scene that use keys of the table. */
enum {
    OUTSIDE,
    THRESHOLD,
    POWER,
    NEIGHBOURS,
    SIGHT,
    EXPLORING,
    START_PLAN,
    FROM_ANYWHERE,
    FROM_A_PLAN,
    STEPS,
    RESTARTS,
    BRANCHING,
    TARGET,
    INTEREST,
    JITTER,
    OBJECTIVE,
    REGRET,
    BUDGET,
    STORE,
    SITE,
    WEATHER,
    N_USES
};

bool murk_idle_asks_time(const murk_scene_desc *s)
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

/* True if a track of the timeline sets a key in that of the scene. */
static bool is_changed(const murk_scene_desc *s, const char *key)
{
    bool is = false;
    for (size_t i = 0; i < s->timeline.tracks; ++i) {
        const char *of = s->timeline.track[i].key;
        is = is || (of && murk_override_overlap(of, key));
    }
    return is;
}

/* True if a light of the sky or a medium takes the weather, or may take it at
 * another time. */
static bool uses_weather(const murk_scene_desc *s)
{
    bool uses = is_changed(s, "lights") || is_changed(s, "media");
    for (size_t i = 0; i < s->n_lights; ++i) {
        uses = uses || s->lights[i].by_weather;
    }
    for (size_t i = 0; i < s->n_media; ++i) {
        const char *preset = s->media[i].preset;
        uses = uses || (preset && strcmp(preset, MURK_SCENE_BY_WEATHER) == 0);
    }
    return uses;
}

/* True if a field may have axes of longitude and latitude. */
static bool has_netcdf(const murk_scene_desc *s)
{
    bool has = false;
    for (size_t i = 0; i < s->n_media; ++i) {
        has = has || s->media[i].netcdf;
    }
    return has;
}

/* Adds the features of a scene. */
static void add_uses(bool uses[N_USES], const murk_scene_desc *s)
{
    const murk_scene_placement *p = &s->placement;
    const bool by_power =
        murk_detection_is(p->detection, MURK_DETECTION_BY_POWER);
    const bool is_best = p->method == MURK_PLACE_BEST;
    /* Each feature, by the values of the keys that make it. */
    const bool own[N_USES] = {
        [OUTSIDE] = !s->domain.is_periodic,
        [THRESHOLD] =
            murk_detection_is(p->detection, MURK_DETECTION_HAS_THRESHOLD),
        [POWER] = by_power,
        [NEIGHBOURS] = by_power && !(p->power_radius_m > 0),
        [SIGHT] = p->through != MURK_SCENE_REFRACT || !p->by_normal,
        [EXPLORING] = p->knowledge == MURK_SCENE_EXPLORE,
        [START_PLAN] = p->method != MURK_PLACE_GREEDY,
        [FROM_ANYWHERE] = !is_best || !p->start_plan,
        [FROM_A_PLAN] = p->start_plan || s->timeline.given,
        [STEPS] = s->timeline.given,
        [RESTARTS] = is_best,
        [BRANCHING] = (is_best || p->method == MURK_PLACE_EXACT) &&
                      p->knowledge == MURK_SCENE_KNOWN,
        [TARGET] = s->sensors.target > 0,
        [INTEREST] = p->n_interests > 0,
        [JITTER] = p->jitter_m > 0 || p->jitter_rad > 0,
        [OBJECTIVE] = p->over != MURK_SCENE_OBJECTIVE_NONE,
        [REGRET] = p->over == MURK_SCENE_OBJECTIVE_REGRET,
        [BUDGET] = s->sensors.budget > 0,
        [STORE] = s->photons.maps != MURK_SCENE_MAPS_NONE,
        [SITE] = murk_idle_asks_time(s) || is_changed(s, "lights") ||
                 murk_scene_has_ground(s) || uses_weather(s) || has_netcdf(s) ||
                 s->sensors.candidates.points.files > 0 || p->targets.points ||
                 /* positions of sensors by longitude and latitude */
                 (s->site.has_latitude && s->site.has_longitude &&
                  s->sensors.types > 0),
        [WEATHER] = uses_weather(s),
    };
    for (int i = 0; i < N_USES; ++i) {
        uses[i] = uses[i] || own[i];
    }
}

#define WITHOUT "has no effect without "
#define A_PLAN  "start_plan, timeline or murk_plan_update()"

const murk_idle_key murk_idle_keys[] = {
    {"domain.outside", OUTSIDE, "has no effect with sides: periodic"},
    {"placement.threshold", THRESHOLD, WITHOUT "detection: threshold"},
    {"placement.power_radius_m", POWER, WITHOUT "detection: power"},
    {"placement.power_neighbours", NEIGHBOURS,
     WITHOUT "detection: power, and beside power_radius_m"},
    {"placement.through", SIGHT, "bends no sightlines with visibility: normal"},
    {"placement.start_m", EXPLORING, WITHOUT "knowledge: explore"},
    {"placement.start_plan", START_PLAN, "has no effect with method: greedy"},
    {"placement.moves_at_most", FROM_A_PLAN, WITHOUT A_PLAN},
    {"placement.move_cost", FROM_A_PLAN, WITHOUT A_PLAN},
    {"placement.look_ahead", STEPS, WITHOUT "timeline"},
    {"placement.restarts", RESTARTS, WITHOUT "method: best"},
    {"placement.restarts", FROM_ANYWHERE, "has no effect beside start_plan"},
    {"placement.nodes", BRANCHING,
     WITHOUT "method: best or exact, and knowledge: known"},
    {"placement.nodes", FROM_ANYWHERE,
     "has no effect with method: best beside start_plan"},
    {"placement.at_least", TARGET, WITHOUT "sensors.target"},
    {"placement.elsewhere", INTEREST, WITHOUT "interest"},
    {"placement.jitter_draws", JITTER, WITHOUT "jitter_m or jitter_deg"},
    {"placement.condition_weights", OBJECTIVE, WITHOUT "over: mean or worst"},
    {"placement.regret", REGRET, WITHOUT "over: regret"},
    {"sensors.types.*.aperture_m2", POWER, WITHOUT "detection: power"},
    {"sensors.types.*.quantum_efficiency", POWER, WITHOUT "detection: power"},
    {"sensors.types.*.exposure_s", POWER, WITHOUT "detection: power"},
    {"sensors.types.*.target_m2", POWER, WITHOUT "detection: power"},
    {"sensors.types.*.target_m3", POWER, WITHOUT "detection: power"},
    {"sensors.types.*.cost", BUDGET, WITHOUT "sensors.budget"},
    {"photons.store_when", STORE, "has no effect with maps: none"},
    {"photons.max_stored", STORE, "has no effect with maps: none"},
    {"site", SITE,
     WITHOUT "a light of the sky, a lamp with a schedule, ground of a file, or "
             "a table of places"},
    {"weather", WEATHER,
     WITHOUT "a light with cover: weather or a medium with preset: weather"},
    {NULL, N_USES, NULL},
};

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

/* Follows the rest of a table key from a position; the first `used` bytes of
 * key[] are the path of the position. Adds every matching key that the user has
 * set. False when out of memory. */
static bool follow(murk_scene_desc *scene, const murk_idle_key *inert,
                   const char *rest, const murk_key_position *at,
                   char key[MURK_WALK_KEY_SIZE], size_t used)
{
    const size_t length = strcspn(rest, ".");
    const murk_yaml *node = at->node;
    bool has_memory = true;
    for (size_t i = 0; i < node->n && has_memory; ++i) {
        char number[24];
        snprintf(number, sizeof number, "%zu", i);
        const char *name = node->key ? node->key[i] : number;
        const bool is_it =
            strncmp(rest, "*", length) == 0 ||
            (strlen(name) == length && strncmp(name, rest, length) == 0);
        const murk_key_position next =
            murk_key_path_member(at, name, node->child[i]);
        if (!is_it || !next.row) {
            continue;
        }
        /* Extend the path by the name of the child. */
        const int more = snprintf(key + used, MURK_WALK_KEY_SIZE - used, "%s%s",
                                  used ? "." : "", name);
        if (more < 0 || used + (size_t)more >= MURK_WALK_KEY_SIZE) {
            continue; /* longer than any key */
        }
        /* Descend, or add the key at the end of the path. */
        if (rest[length] == '.') {
            has_memory = follow(scene, inert, rest + length + 1, &next, key,
                                used + (size_t)more);
        } else if (is_set_by_user(next.node, next.row)) {
            has_memory = add(scene, next.node, key, inert->text);
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
    const bool is_any = is_changed(scene, "regions");
    bool has_memory = true;
    for (size_t m = 0; media && m < media->n && has_memory; ++m) {
        if (!is_any && !has_region(scene, media->key[m])) {
            char key[MURK_WALK_KEY_SIZE];
            snprintf(key, sizeof key, "media.%s", media->key[m]);
            has_memory = add(scene, media->child[m], key,
                             "has no effect: it is in no region");
        }
    }
    return has_memory;
}

bool murk_idle_find(murk_scene_desc *scene, murk_yaml *root)
{
    bool uses[N_USES] = {false};
    add_uses(uses, scene);
    for (size_t i = 0; i < scene->n_conditions; ++i) {
        add_uses(uses, scene->conditions[i].scene);
    }
    bool has_memory = find_media(scene, murk_yaml_get(root, "media"));
    const murk_key_position at = murk_key_path_root(root);
    const murk_idle_key *inert = murk_idle_keys;
    for (; inert->key && has_memory; ++inert) {
        char key[MURK_WALK_KEY_SIZE] = "";
        if (!uses[inert->use]) {
            has_memory = follow(scene, inert, inert->key, &at, key, 0);
        }
    }
    return has_memory;
}
