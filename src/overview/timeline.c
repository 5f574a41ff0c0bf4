/* The timeline of a scene as murk check reports it. */
#include "overview/parts.h"

#include "base/file.h"
#include "base/log.h"
#include "results/summary.h"
#include "scene/frames.h"
#include "scene/timeline.h"
#include "scene/variant.h"
#include "world/sky.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What a track changes, and when. */
typedef struct facts {
    const char *of; /* geometry, medium, key, sensor */
    char name[300];
    double from_s, to_s; /* first and last change; NaN: none or without end */
} facts;

static facts facts_of(const murk_scene_track *t)
{
    static const char *const kinds[] = {[MURK_TRACK_GEOMETRY] = "geometry",
                                        [MURK_TRACK_MEDIUM] = "medium",
                                        [MURK_TRACK_KEY] = "key",
                                        [MURK_TRACK_SENSOR] = "sensor"};
    facts f = {.of = kinds[t->kind], .from_s = NAN, .to_s = NAN};
    /* The name of what changes. */
    if (t->kind == MURK_TRACK_SENSOR) {
        snprintf(f.name, sizeof f.name, "%" PRIu64, t->sensor);
    } else {
        snprintf(f.name, sizeof f.name, "%s",
                 t->kind == MURK_TRACK_GEOMETRY ? t->item
                 : t->kind == MURK_TRACK_MEDIUM ? t->medium
                                                : t->key);
    }
    /* The times of keyframes, of a failure, and of files. */
    if (t->keyframes > 0) {
        f.from_s = t->keyframe[0].t_s;
        f.to_s = t->keyframe[t->keyframes - 1].t_s;
    }
    if (t->fails) {
        f.from_s = fmin(f.from_s, t->fails_at_s);
        f.to_s = t->fails_at_s;
    }
    if (t->kind == MURK_TRACK_MEDIUM) {
        f.from_s = t->from_s;
    }
    return f;
}

/* The pattern of the files of a track of a medium. */
static const char *pattern_of(const murk_scene_desc *scene,
                              const murk_scene_track *track)
{
    for (size_t i = 0; i < scene->n_media && !track->frames; ++i) {
        if (strcmp(scene->media[i].name, track->medium) == 0) {
            return scene->media[i].vdb_frames;
        }
    }
    return track->frames;
}

/* ---- JSON ---- */

static void add_track(cJSON *list, const murk_scene_desc *scene,
                      const murk_scene_track *t)
{
    const facts f = facts_of(t);
    cJSON *item = murk_json_item(list);
    cJSON_AddStringToObject(item, "of", f.of);
    cJSON_AddStringToObject(item, "name", f.name);
    murk_json_number(item, "from_s", f.from_s);
    murk_json_number(item, "to_s", f.to_s);
    murk_json_number(item, "keyframes",
                     t->keyframes > 0 ? (double)t->keyframes : NAN);
    if (t->kind == MURK_TRACK_MEDIUM) {
        const char *pattern = pattern_of(scene, t);
        cJSON_AddStringToObject(item, "files",
                                pattern ? murk_path_name(pattern) : "");
    } else {
        cJSON_AddNullToObject(item, "files");
    }
}

void murk_overview_json_timeline(cJSON *root, const murk_scene_desc *scene)
{
    const murk_scene_timeline *t = &scene->timeline;
    if (!t->given) {
        return;
    }
    const size_t steps = murk_timeline_steps(t);
    cJSON *map = cJSON_AddObjectToObject(root, "timeline");
    murk_json_number(map, "steps", (double)steps);
    murk_json_number(map, "from_s", murk_timeline_time_s(t, 0));
    murk_json_number(map, "to_s", murk_timeline_time_s(t, steps - 1));
    murk_json_number(map, "at_s", t->at_s);
    cJSON *list = cJSON_AddArrayToObject(map, "tracks");
    for (size_t i = 0; i < t->tracks; ++i) {
        add_track(list, scene, &t->track[i]);
    }
}

/* ---- lines ---- */

static void print_track(const murk_scene_desc *scene, const murk_scene_track *t)
{
    static const char *const words[] = {[MURK_BETWEEN_LINEAR] = "linear",
                                        [MURK_BETWEEN_NEAREST] = "nearest",
                                        [MURK_BETWEEN_HOLD] = "held"};
    const facts f = facts_of(t);
    const char *between = words[t->between];
    murk_print("track       %s %s", f.of, f.name);
    if (t->kind == MURK_TRACK_MEDIUM) {
        const char *pattern = pattern_of(scene, t);
        murk_print(": %s, from number %" PRIu64 " at %.6g s, one every %.6g s, "
                   "%s",
                   pattern ? murk_path_name(pattern) : "no files",
                   t->first_frame, t->from_s, t->every_s, between);
    }
    /* Keyframes, lights that move along, and a failure. */
    if (t->keyframes > 0) {
        murk_print(": %zu keyframe%s from %.6g to %.6g s, %s between",
                   t->keyframes, t->keyframes == 1 ? "" : "s",
                   t->keyframe[0].t_s, t->keyframe[t->keyframes - 1].t_s,
                   between);
    }
    if (t->light.n > 0) {
        murk_print(", with %zu light%s", t->light.n,
                   t->light.n == 1 ? "" : "s");
    }
    if (t->fails) {
        murk_print("%s fails at %.6g s", t->keyframes > 0 ? ", and" : "",
                   t->fails_at_s);
    }
    murk_print("\n");
}

void murk_overview_print_timeline(const murk_scene_desc *scene)
{
    const murk_scene_timeline *t = &scene->timeline;
    if (!t->given) {
        return;
    }
    const size_t steps = murk_timeline_steps(t);
    murk_print("timeline    %zu step%s from %.6g to %.6g s; shown at %.6g s\n",
               steps, steps == 1 ? "" : "s", murk_timeline_time_s(t, 0),
               murk_timeline_time_s(t, steps - 1), t->at_s);
    for (size_t i = 0; i < t->tracks; ++i) {
        print_track(scene, &t->track[i]);
    }
    if (scene->photons.store > 0) {
        murk_print(
            "            with photons.store the power of a packet changes "
            "from step to step, so every photon does; emit keeps those "
            "that nothing touches\n");
    }
}

/* ---- files that do not exist ---- */

static bool is_missing(const char *pattern, uint64_t frame)
{
    char *file = murk_frames_file(pattern, frame);
    const bool is_there = !file || access(file, F_OK) == 0;
    free(file);
    return !is_there;
}

static void warn_of_files(const murk_scene_track *track,
                          const murk_scene_timeline *t, const char *pattern)
{
    uint64_t checked = UINT64_MAX, first = 0;
    size_t missing = 0;
    for (size_t i = 0; i < murk_timeline_steps(t); ++i) {
        const double t_s = murk_timeline_time_s(t, i);
        double frame;
        if (!murk_timeline_frame(track, t_s, &frame)) {
            continue;
        }
        /* Between two files both are needed. */
        for (double f = floor(frame); f <= ceil(frame); ++f) {
            const uint64_t number = (uint64_t)f;
            if (number != checked && is_missing(pattern, number)) {
                first = missing++ == 0 ? number : first;
            }
            checked = number;
        }
    }
    if (missing > 0) {
        char found[200];
        murk_frames_list(pattern, found, sizeof found);
        murk_warn(track->where,
                  "%zu file%s of %s that steps need %s missing, the first is "
                  "number %" PRIu64 "; found: %s",
                  missing, missing == 1 ? "" : "s", murk_path_name(pattern),
                  missing == 1 ? "is" : "are", first, found);
    }
}

/* ---- steps at which the scene is refused ---- */

/* Steps that are checked: this many spread evenly over the timeline, and this
 * many in all, with those beside keyframes. Reading the scene of a step takes
 * milliseconds, or with a weather year some ten times as long. No more keys
 * than KEYS_MAX are named, since more of them have one cause. */
#define SPREAD_MAX 64
#define LOOKED_MAX 512
#define KEYS_MAX   8

/* The number of steps that are earlier than a time. */
static size_t steps_before(const murk_scene_timeline *t, double t_s)
{
    size_t low = 0, high = murk_timeline_steps(t);
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (murk_timeline_time_s(t, middle) < t_s) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/* Marks the steps before and after each keyframe, between which values are
 * those between the values of these steps; and steps throughout, since clocks
 * and turns give other values between them. */
static void mark_steps(bool *is_looked_at, const murk_scene_timeline *t)
{
    const size_t steps = murk_timeline_steps(t);
    const size_t n = steps < SPREAD_MAX ? steps : SPREAD_MAX;
    for (size_t i = 0; i < n; ++i) {
        is_looked_at[n > 1 ? i * (steps - 1) / (n - 1) : 0] = true;
    }
    for (size_t i = 0; i < t->tracks; ++i) {
        const murk_scene_track *track = &t->track[i];
        for (size_t k = 0; k < track->keyframes; ++k) {
            const size_t after = steps_before(t, track->keyframe[k].t_s);
            is_looked_at[after < steps ? after : steps - 1] = true;
            is_looked_at[after > 0 ? after - 1 : 0] = true;
        }
    }
}

/* Fails if the scene, a light source or a fixed sensor is refused at a time. */
static murk_status check_at(const murk_stage *stage, double t_s,
                            murk_error *err)
{
    const murk_domain *domain = &stage->world.domain;
    murk_scene_desc *now = NULL;
    murk_source *light = NULL;
    murk_sources *lights = NULL;
    murk_status status = murk_scene_desc_read_at(&now, stage->scene, t_s, err);
    const bool was_silent = murk_warn_quiet(true);
    if (!status) {
        status = murk_sky_lights(&light, NULL, now, err);
    }
    if (!status) {
        status = murk_sources_create(&lights, light, now->n_lights, now->bands,
                                     domain, err);
    }
    if (!status) {
        status = murk_poses_check_fixed(&now->sensors, domain, err);
    }
    murk_warn_quiet(was_silent);
    murk_sources_destroy(lights);
    free(light);
    murk_scene_desc_destroy(now);
    return status;
}

/* The key of a place in the resolved scene, "FILE:LINE:COLUMN: KEY". */
static const char *key_of(const char *where, const char *file)
{
    const size_t n = strlen(file);
    if (strncmp(where, file, n) != 0) {
        return where;
    }
    const char *key = where + n + strspn(where + n, ":0123456789");
    return key + strspn(key, " ");
}

static void warn_of_steps(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    const murk_scene_timeline *t = &scene->timeline;
    const size_t steps = murk_timeline_steps(t);
    char named[KEYS_MAX][sizeof(murk_scene_where)];
    size_t looked = 0, n = 0;
    bool *is_looked_at = calloc(steps, sizeof *is_looked_at);
    if (is_looked_at) {
        mark_steps(is_looked_at, t);
    }
    for (size_t i = 0; is_looked_at && i < steps && looked < LOOKED_MAX; ++i) {
        const double t_s = murk_timeline_time_s(t, i);
        murk_error why = {.size = sizeof why};
        if (!is_looked_at[i] || t_s == t->at_s) {
            continue;
        }
        ++looked;
        if (!check_at(stage, t_s, &why)) {
            continue;
        }
        /* The first step at which this key is refused. */
        const char *key = key_of(why.where, scene->path);
        size_t k = 0;
        while (k < n && strcmp(named[k], key) != 0) {
            ++k;
        }
        if (k == n && n < KEYS_MAX) {
            snprintf(named[n++], sizeof *named, "%s", key);
            murk_warn(t->where, "is wrong at %.6g s: %s: %s", t_s, key,
                      why.text);
        }
    }
    free(is_looked_at);
}

void murk_overview_warn_of_timeline(const murk_stage *stage)
{
    const murk_scene_desc *scene = stage->scene;
    const murk_scene_timeline *t = &scene->timeline;
    for (size_t i = 0; i < t->tracks; ++i) {
        const char *pattern = t->track[i].kind == MURK_TRACK_MEDIUM
                                  ? pattern_of(scene, &t->track[i])
                                  : NULL;
        if (pattern) {
            warn_of_files(&t->track[i], t, pattern);
        }
    }
    if (t->given) {
        warn_of_steps(stage);
    }
}
