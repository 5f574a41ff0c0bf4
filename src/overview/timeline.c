/* The timeline of a scene as murk check reports it. */
#include "overview/parts.h"

#include "base/file.h"
#include "base/log.h"
#include "results/summary.h"
#include "scene/frames.h"
#include "scene/timeline.h"

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

void murk_overview_warn_of_timeline(const murk_scene_desc *scene)
{
    const murk_scene_timeline *t = &scene->timeline;
    for (size_t i = 0; i < t->tracks; ++i) {
        const char *pattern = t->track[i].kind == MURK_TRACK_MEDIUM
                                  ? pattern_of(scene, &t->track[i])
                                  : NULL;
        if (pattern) {
            warn_of_files(&t->track[i], t, pattern);
        }
    }
}
