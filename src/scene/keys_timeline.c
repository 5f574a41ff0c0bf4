/* Keys of the timeline: the times of the steps, and tracks, which say what
 * changes in the course of time. scene/timeline.c puts the values of a time in
 * place before the scene is checked. */
#include "scene/keys_rows.h"

#include <string.h>

#include "scene/value.h"

/* Some 30 years: longer times are mistakes. */
#define SECONDS .min = -1e9, .max = 1e9, .unit = "s"

/* ---- keyframes ---- */

/* The value of a track of a key is checked once it is in place. */
static murk_status read_any(murk_key_reader *walk, const murk_key *key,
                            murk_yaml *node, void *member)
{
    (void)member;
    return murk_yaml_is_null(node) ? murk_value_wrong(walk, key, node)
                                   : MURK_OK;
}

#define KEYFRAME(member) AT(murk_scene_keyframe, member)

static const murk_key KEYFRAME_ROWS[] = {
    ROW("t_s", NUMBER, NEEDED, SECONDS, KEYFRAME(t_s)),
    ROW("translate_m", VECTOR, LONG_M, KEYFRAME(translate_m)),
    ROW("rotate_deg", VECTOR, ANY_UNIT, .unit = "degrees",
        KEYFRAME(rotate_deg)),
    ROW("position_m", VECTOR, LONG_M, KEYFRAME(position_m)),
    ROW("heading_deg", NUMBER, .min = -360, .max = 360, .unit = "degrees"),
    ROW("tilt_deg", NUMBER, .min = -90, .max = 90, .unit = "degrees"),
    ROW("offset_m", VECTOR, LONG_M, KEYFRAME(offset_m)),
    ROW("heading_offset_deg", NUMBER, .min = -360, .max = 360, RADIANS,
        KEYFRAME(heading_offset_rad)),
    ROW("tilt_offset_deg", NUMBER, .min = -180, .max = 180, RADIANS,
        KEYFRAME(tilt_offset_rad)),
    ROW("value", OWN, .read = read_any, .allowed = "a value of the key",
        .schema = "{}"),
    END,
};

static const murk_keys KEYFRAME_KEYS = {
    .noun = "keyframe",
    ITEMS(murk_scene_track, keyframe, keyframes),
    .max_items = MURK_SCENE_LIST_MAX,
    .needs_item = true,
    .key = KEYFRAME_ROWS,
};

/* True if a track of that kind may have keyframes with the key. */
static bool suits(murk_track_kind kind, const char *key)
{
    static const char *const keys[][8] = {
        [MURK_TRACK_GEOMETRY] = {"t_s", "translate_m", "rotate_deg"},
        [MURK_TRACK_KEY] = {"t_s", "value"},
        [MURK_TRACK_SENSOR] = {"t_s", "position_m", "heading_deg", "tilt_deg",
                               "offset_m", "heading_offset_deg",
                               "tilt_offset_deg"},
    };
    bool is_found = false;
    for (int i = 0; i < 8 && keys[kind][i]; ++i) {
        is_found = is_found || strcmp(keys[kind][i], key) == 0;
    }
    return is_found;
}

/* All keyframes of a track have the same keys, and more than t_s. */
static murk_status check_members(murk_key_reader *walk,
                                 const murk_scene_track *track,
                                 const murk_yaml *frames)
{
    const murk_yaml *first = frames->child[0];
    for (size_t i = 0; i < frames->n; ++i) {
        const murk_yaml *frame = frames->child[i];
        const size_t back = murk_walk_enter_item(walk, i);
        if (frame->n < 2) {
            return murk_walk_fail(walk, frame,
                                  "has t_s alone, must say what "
                                  "changes");
        }
        /* Keys that suit the kind of the track, and are those of the first
         * keyframe. */
        for (size_t k = 0; k < frame->n; ++k) {
            if (!suits(track->kind, frame->key[k])) {
                return murk_walk_fail(walk, frame,
                                      "%s is no key of the keyframes of such "
                                      "a track",
                                      frame->key[k]);
            }
            if (!murk_yaml_get(first, frame->key[k]) || frame->n != first->n) {
                return murk_walk_fail(walk, frame,
                                      "has other keys than the first keyframe, "
                                      "must have the same");
            }
        }
        murk_walk_leave(walk, back);
    }
    return MURK_OK;
}

static murk_status check_keyframes(murk_key_reader *walk, const murk_yaml *map,
                                   const murk_scene_track *track)
{
    const murk_yaml *frames = murk_yaml_get(map, "keyframes");
    murk_walk_enter(walk, "keyframes");
    for (size_t i = 1; i < track->keyframes; ++i) {
        const double before = track->keyframe[i - 1].t_s,
                     t_s = track->keyframe[i].t_s;
        if (!(t_s > before)) {
            return murk_walk_fail(walk, frames->child[i],
                                  "t_s: %g after %g, must rise", t_s, before);
        }
    }
    return check_members(walk, track, frames);
}

/* ---- tracks ---- */

static const char *const TRACK_VARIANTS[] = {"geometry", "medium", "key",
                                             "sensor", NULL};

#define OF_GEOMETRY BIT(MURK_TRACK_GEOMETRY)
#define OF_MEDIUM   BIT(MURK_TRACK_MEDIUM)
#define OF_KEY      BIT(MURK_TRACK_KEY)
#define OF_SENSOR   BIT(MURK_TRACK_SENSOR)

static murk_status check_track(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    const murk_scene_track *track = item;
    if (track->kind == MURK_TRACK_SENSOR && track->keyframes == 0 &&
        !track->fails) {
        return murk_walk_fail(
            walk, map, "misses keyframes or fails_at_s, must have one of them");
    }
    for (size_t i = 0; i < track->light.n; ++i) {
        const double index = track->light.value[i];
        if (index != (double)(size_t)index) {
            return murk_walk_fail(
                walk, map, "lights: %g, must be the index of a light", index);
        }
    }
    return track->keyframes > 0 ? check_keyframes(walk, map, track) : MURK_OK;
}

/* The name or the index of an item of the geometry. */
static murk_status read_item(murk_key_reader *walk, const murk_key *key,
                             murk_yaml *node, void *member)
{
    if (node->kind != MURK_YAML_SCALAR || murk_yaml_is_null(node) ||
        strlen(node->text) >= MURK_SCENE_NAME_SIZE) {
        return murk_value_wrong(walk, key, node);
    }
    strcpy(member, node->text);
    return MURK_OK;
}

#define TRACK(member) AT(murk_scene_track, member)
#define BETWEEN                                                               \
    WORDS({"linear", MURK_BETWEEN_LINEAR}, {"nearest", MURK_BETWEEN_NEAREST}, \
          {"hold", MURK_BETWEEN_HOLD}),                                       \
        TRACK(between)

static const murk_key TRACK_ROWS[] = {
    ROW("geometry", OWN, .group = 1, NEEDED, .read = read_item, TRACK(item),
        .allowed = "the name or the index of an item of `geometry`",
        .schema = "{\"type\": [\"string\", \"integer\"]}"),
    ROW("medium", TEXT, .group = 1, NEEDED, TRACK(medium)),
    ROW("key", TEXT, .group = 1, NEEDED, TRACK(key)),
    ROW("sensor", COUNT, .group = 1, NEEDED, .max = 999999, TRACK(sensor)),
    ROW("lights", NUMBER_LIST, .variants = OF_GEOMETRY, .max = 255,
        TRACK(light)),
    ROW("frames", PATH, .variants = OF_MEDIUM, TRACK(frames)),
    ROW("first_frame", COUNT, .variants = OF_MEDIUM, .max = 999999999,
        TRACK(first_frame), FLAG(murk_scene_track, has_first)),
    ROW("from_s", NUMBER, .variants = OF_MEDIUM, SECONDS, .preset = "0",
        TRACK(from_s)),
    ROW("every_s", NUMBER, .variants = OF_MEDIUM, NEEDED, .above = true,
        .max = 1e9, .unit = "s", TRACK(every_s)),
    ROW("between", WORD, .variants = OF_MEDIUM, .preset = "nearest", BETWEEN),
    ROW("between", WORD, .variants = OF_GEOMETRY | OF_KEY | OF_SENSOR,
        .preset = "linear", BETWEEN),
    ROW("fails_at_s", NUMBER, .variants = OF_SENSOR, SECONDS, TRACK(fails_at_s),
        FLAG(murk_scene_track, fails)),
    ROW("keyframes", LIST, .variants = OF_GEOMETRY | OF_KEY, NEEDED,
        .keys = &KEYFRAME_KEYS),
    ROW("keyframes", LIST, .variants = OF_SENSOR, .keys = &KEYFRAME_KEYS),
    END,
};

static const murk_keys TRACK_KEYS = {
    .noun = "track",
    .by_key = true,
    .variant_names = TRACK_VARIANTS,
    .check = check_track,
    VARIANT(murk_scene_track, kind),
    WHERE(murk_scene_track, where),
    ITEMS(murk_scene_timeline, track, tracks),
    .max_items = 1000,
    .key = TRACK_ROWS,
};

/* ---- the timeline ---- */

static murk_status check_times(murk_key_reader *walk, const murk_yaml *map,
                               const murk_scene_timeline *timeline)
{
    const murk_scene_numbers *times = &timeline->times_s;
    for (size_t i = 1; i < times->n; ++i) {
        if (!(times->value[i] > times->value[i - 1])) {
            return murk_walk_fail(walk, map, "times_s: %g after %g, must rise",
                                  times->value[i], times->value[i - 1]);
        }
    }
    if (times->n > 0) {
        return MURK_OK;
    }
    /* Without a list: from, to and every. */
    const char *missing = !murk_yaml_get(map, "to_s")      ? "to_s"
                          : !murk_yaml_get(map, "every_s") ? "every_s"
                                                           : NULL;
    if (missing) {
        return murk_walk_fail(walk, map,
                              "misses %s, must have from_s, to_s and every_s "
                              "together, or times_s",
                              missing);
    }
    if (timeline->to_s < timeline->from_s) {
        return murk_walk_fail(walk, map,
                              "to_s: %g is before from_s %g, must not be",
                              timeline->to_s, timeline->from_s);
    }
    const double steps =
        (timeline->to_s - timeline->from_s) / timeline->every_s;
    return steps < MURK_TIMELINE_STEPS_MAX
               ? MURK_OK
               : murk_walk_fail(walk, map, "%g steps, must be at most %d",
                                steps + 1, MURK_TIMELINE_STEPS_MAX);
}

static murk_status check_timeline(murk_key_reader *walk, const murk_yaml *map,
                                  void *item)
{
    murk_scene_timeline *timeline = item;
    const murk_status status = check_times(walk, map, timeline);
    if (!status && !timeline->has_at) {
        timeline->at_s = timeline->times_s.n > 0 ? timeline->times_s.value[0]
                                                 : timeline->from_s;
    }
    return status;
}

#define TIMELINE(member) AT(murk_scene_timeline, member)

static const murk_key TIMELINE_ROWS[] = {
    ROW("from_s", NUMBER, .group = 1, NEEDED, SECONDS, TIMELINE(from_s)),
    ROW("times_s", NUMBER_LIST, .group = 1, NEEDED, SECONDS, TIMELINE(times_s)),
    ROW("to_s", NUMBER, SECONDS, TIMELINE(to_s)),
    ROW("every_s", NUMBER, .above = true, .max = 1e9, .unit = "s",
        TIMELINE(every_s)),
    ROW("at_s", NUMBER, SECONDS, TIMELINE(at_s),
        FLAG(murk_scene_timeline, has_at)),
    ROW("search_from", WORD, .preset = "before",
        WORDS({"before", 0}, {"start_plan", 1}), TIMELINE(from_start_plan)),
    ROW("tracks", LIST, .keys = &TRACK_KEYS, .preset = "[]"),
    END,
};

const murk_keys murk_timeline_keys = {
    .noun = "timeline",
    .check = check_timeline,
    WHERE(murk_scene_timeline, where),
    .key = TIMELINE_ROWS,
};

murk_status murk_check_timeline(murk_key_reader *walk,
                                const murk_scene_desc *scene)
{
    if (!scene->timeline.given || scene->has_domain) {
        return MURK_OK;
    }
    return murk_fail(walk->err, MURK_BAD_VALUE, scene->timeline.where,
                     "needs a domain, which must not change with time; a scene "
                     "without one has that of its geometry");
}
