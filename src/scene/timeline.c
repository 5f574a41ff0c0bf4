/* Puts the values of one time in place: reads the timeline by the key table,
 * then makes for each track the nodes of the values at that time, and puts them
 * at their paths by scene/override.h. */
#include "scene/timeline.h"

#include "base/number.h"
#include "base/words.h"
#include "scene/frames.h"
#include "scene/idle.h"
#include "scene/key_path.h"
#include "scene/override.h"
#include "scene/value.h"
#include "scene/walk.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PATH_SIZE 400 /* of a key; names of 63 bytes and some words */
#define NAMES_MAX 64  /* of items, from which a message suggests one */

/* Times that differ by less than this share of a step are the same: times of
 * steps and of files are computed from decimal fractions. */
#define TIME_ROUNDING 1e-9

/* The length of the difference of unit vectors that rounding may make. */
#define TURN_ROUNDING 1e-9

/* ---- steps ---- */

size_t murk_timeline_steps(const murk_scene_timeline *t)
{
    return t->times_s.n > 0
               ? t->times_s.n
               : (size_t)((t->to_s - t->from_s) / t->every_s + TIME_ROUNDING) +
                     1;
}

double murk_timeline_time_s(const murk_scene_timeline *t, size_t i)
{
    return t->times_s.n > 0 ? t->times_s.value[i]
                            : t->from_s + (double)i * t->every_s;
}

bool murk_timeline_changes_power(const murk_scene_desc *scene)
{
    const murk_scene_timeline *t = &scene->timeline;
    bool changes = t->given && murk_idle_asks_time(scene);
    for (size_t i = 0; i < t->tracks; ++i) {
        const char *key = t->track[i].key;
        changes = changes || (key && (murk_override_overlap(key, "lights") ||
                                      murk_override_overlap(key, "site")));
    }
    return changes;
}

/* ---- values between keyframes ---- */

/* Two keyframes and the weight of the later one. */
typedef struct bracket {
    size_t before, after;
    double weight;
} bracket;

static bracket find(const murk_scene_track *track, double t_s)
{
    const murk_scene_keyframe *frame = track->keyframe;
    size_t after = 0;
    while (after < track->keyframes && frame[after].t_s <= t_s) {
        ++after;
    }
    if (after == 0 || after == track->keyframes) {
        const size_t only = after == 0 ? 0 : after - 1;
        return (bracket){only, only, 0};
    }
    const double from = frame[after - 1].t_s, to = frame[after].t_s;
    bracket out = {after - 1, after, (t_s - from) / (to - from)};
    /* A value that holds, or the nearer one, is that of one keyframe. */
    if (track->between == MURK_BETWEEN_NEAREST && out.weight >= 0.5) {
        out.before = after;
    }
    if (track->between != MURK_BETWEEN_LINEAR) {
        out.weight = 0;
    }
    return out;
}

murk_drift murk_timeline_drift(const murk_scene_track *track, double t_s)
{
    const bracket at = find(track, t_s);
    const murk_scene_keyframe *a = &track->keyframe[at.before],
                              *b = &track->keyframe[at.after];
    const double u = 1 - at.weight, v = at.weight;
    return (murk_drift){
        murk_add(murk_scale(u, a->offset_m), murk_scale(v, b->offset_m)),
        u * a->heading_offset_rad + v * b->heading_offset_rad,
        u * a->tilt_offset_rad + v * b->tilt_offset_rad};
}

static murk_yaml *text_node(const char *text, const char *source)
{
    murk_yaml *node = murk_yaml_make(MURK_YAML_SCALAR, source);
    if (node && !murk_yaml_set_text(node, text)) {
        murk_yaml_destroy(node);
        node = NULL;
    }
    return node;
}

static murk_yaml *number_node(double value, const char *source)
{
    char text[MURK_NUMBER_SIZE];
    murk_number_print(text, value);
    return text_node(text, source);
}

/* The value between two nodes: of numbers, and of the numbers of lists of equal
 * length, by the weight of the later one; otherwise the earlier value. NULL
 * when out of memory. */
static murk_yaml *between(const murk_yaml *a, const murk_yaml *b, double weight)
{
    double from, to;
    if (weight > 0 && murk_yaml_number(a, &from) && murk_yaml_number(b, &to)) {
        return number_node(from + weight * (to - from), a->source);
    }
    murk_yaml *out = murk_yaml_copy(a);
    const bool is_list = weight > 0 && a->kind == MURK_YAML_LIST &&
                         b->kind == MURK_YAML_LIST && a->n == b->n;
    for (size_t i = 0; out && is_list && i < a->n; ++i) {
        murk_yaml *item = between(a->child[i], b->child[i], weight);
        if (!item) {
            murk_yaml_destroy(out);
            return NULL;
        }
        murk_yaml_destroy(out->child[i]);
        out->child[i] = item;
    }
    return out;
}

/* ---- putting values in place ---- */

/* The changes of a tree at one time. */
typedef struct changes {
    murk_yaml *root;
    const murk_scene_timeline *timeline;
    const murk_yaml *tracks;    /* list of the tracks, as read by the table */
    const murk_yaml *condition; /* whose values are in place; NULL: none */
    char (*path)[PATH_SIZE];    /* [n] that were set */
    size_t n;
    murk_error *err;
} changes;

static murk_status no_memory(const changes *c)
{
    return murk_no_memory(c->err, c->timeline->where, "for the timeline");
}

/* Copies a path with the numbers of items of lists in place of their names. */
static void canonical(char out[PATH_SIZE], const murk_yaml *root,
                      const char *path)
{
    const murk_yaml *node = root;
    size_t length = 0;
    while (*path && length < PATH_SIZE) {
        const size_t n = strcspn(path, ".");
        char part[MURK_SCENE_NAME_SIZE];
        size_t i;
        snprintf(part, sizeof part, "%.*s", (int)n, path);
        const bool is_item = node && node->kind == MURK_YAML_LIST &&
                             murk_key_path_item(node, part, &i);
        if (is_item) {
            snprintf(part, sizeof part, "%zu", i);
        }
        length += (size_t)snprintf(out + length, PATH_SIZE - length, "%s%s",
                                   length ? "." : "", part);
        node = is_item                               ? node->child[i]
               : node && node->kind == MURK_YAML_MAP ? murk_yaml_get(node, part)
                                                     : NULL;
        path += n + (path[n] == '.');
    }
}

/* Notes that a track sets a key, which no other track and no value of the
 * condition may set. */
static murk_status note_path(changes *c, const char *given, const char *where)
{
    char path[PATH_SIZE] = "", other[PATH_SIZE] = "";
    canonical(path, c->root, given);
    for (size_t i = 0; i < c->n; ++i) {
        if (murk_override_overlap(c->path[i], path)) {
            return murk_fail(c->err, MURK_BAD_VALUE, where,
                             "sets %s, which an earlier track sets, too", path);
        }
    }
    for (size_t i = 0; c->condition && i < c->condition->n; ++i) {
        canonical(other, c->root, c->condition->key[i]);
        if (murk_override_overlap(other, path)) {
            return murk_fail(c->err, MURK_BAD_VALUE, where,
                             "sets %s, which the condition sets, too", path);
        }
    }
    char(*grown)[PATH_SIZE] = realloc(c->path, (c->n + 1) * sizeof *grown);
    if (!grown) {
        return no_memory(c);
    }
    c->path = grown;
    memcpy(c->path[c->n++], path, PATH_SIZE);
    return MURK_OK;
}

/* Fails if an option or a row of a study gives the value at a path, which the
 * track is about to replace. It may give the whole map around the value, and a
 * track that moves lights uses the value. */
static murk_status check_options(const changes *c,
                                 const murk_scene_track *track,
                                 const char *given)
{
    char path[PATH_SIZE] = "";
    canonical(path, c->root, given);
    const murk_yaml *node = c->root, *around = c->root;
    /* Find the node, and the map or list around it. */
    for (char *part = path; node && part;) {
        char *const dot = strchr(part, '.');
        size_t i;
        if (dot) {
            *dot = '\0';
        }
        around = node;
        node =
            node->kind == MURK_YAML_MAP ? murk_yaml_get(node, part)
            : node->kind == MURK_YAML_LIST && murk_key_path_item(node, part, &i)
                ? node->child[i]
                : NULL;
        part = dot ? dot + 1 : NULL;
    }
    return !node || node->source == around->source || track->light.n > 0
               ? MURK_OK
               : murk_fail(c->err, MURK_BAD_VALUE, node->source,
                           "a track of the timeline sets %s, at any time",
                           given);
}

/* Lets a value of an item of a list keep the name that the item has, so that
 * paths and tracks find the item by its name at any time. Fails if the value
 * has another one. */
static murk_status keep_name(const changes *c, const murk_scene_track *track,
                             const char *path, murk_yaml *value)
{
    const murk_key_position at = murk_key_path_find(c->root, path);
    const bool is_item = at.node && at.in_item && at.row->keys &&
                         murk_keys_find(at.row->keys, "name") &&
                         value->kind == MURK_YAML_MAP;
    const murk_yaml *old = is_item ? murk_yaml_get(at.node, "name") : NULL,
                    *new = is_item ? murk_yaml_get(value, "name") : NULL;
    if (!old || old->kind != MURK_YAML_SCALAR) {
        return MURK_OK;
    }
    if (new &&
        (new->kind != MURK_YAML_SCALAR || strcmp(new->text, old->text) != 0)) {
        return murk_fail(c->err, MURK_BAD_VALUE, track->where,
                         "key: %s has another name at a keyframe, must be %s "
                         "or left out",
                         path, old->text);
    }
    murk_yaml *name = new ? NULL : text_node(old->text, value->source);
    return new || (name && murk_yaml_put(value, "name", name)) ? MURK_OK
                                                               : no_memory(c);
}

/* Puts a value, which it owns, at a path. */
static murk_status put(changes *c, const murk_scene_track *track,
                       const char *path, murk_yaml *value)
{
    if (!value) {
        return no_memory(c);
    }
    murk_status status = check_options(c, track, path);
    if (!status) {
        status = note_path(c, path, track->where);
    }
    if (!status) {
        status = keep_name(c, track, path, value);
    }
    if (status) {
        murk_yaml_destroy(value);
        return status;
    }
    murk_yaml *const none[1] = {NULL};
    return murk_override_put(c->root, path, value, track->where, none, 0,
                             c->err);
}

/* Puts the values that the key `member` of the keyframes has, if they have
 * it. */
static murk_status put_member(changes *c, const murk_scene_track *track,
                              const char *member, const char *path)
{
    const size_t number = (size_t)(track - c->timeline->track);
    const murk_yaml *frames =
        murk_yaml_get(c->tracks->child[number], "keyframes");
    const bracket at = find(track, c->timeline->at_s);
    const murk_yaml *a = murk_yaml_get(frames->child[at.before], member),
                    *b = murk_yaml_get(frames->child[at.after], member);
    return a && b ? put(c, track, path, between(a, b, at.weight)) : MURK_OK;
}

/* ---- moved geometry ---- */

static double number_or(const murk_yaml *node, double preset)
{
    double value = preset;
    if (node) {
        (void)murk_yaml_number(node, &value);
    }
    return value;
}

static murk_vec3 vector_or_zero(const murk_yaml *node)
{
    double value[3] = {0, 0, 0};
    for (size_t i = 0; node && i < node->n && i < 3; ++i) {
        value[i] = number_or(node->child[i], 0);
    }
    return murk_vec(value[0], value[1], value[2]);
}

static murk_affine placed(const murk_yaml *item)
{
    return murk_affine_place(
        vector_or_zero(murk_yaml_get(item, "rotate_deg")),
        number_or(murk_yaml_get(item, "scale"), 1),
        vector_or_zero(murk_yaml_get(item, "translate_m")));
}

/* The row of that name that holds a vector: `aim` is a vector of one type of
 * light and a list of portals of another. NULL: there is none. */
static const murk_key *find_vector(const murk_keys *keys, const char *name)
{
    const murk_key *key = keys->key;
    while (key->name &&
           (strcmp(key->name, name) != 0 || key->kind != MURK_KEY_VECTOR)) {
        ++key;
    }
    return key->name ? key : NULL;
}

/* True if a motion turns directions by more than rounding. */
static bool does_turn(const murk_affine *motion)
{
    const murk_vec3 axis[2] = {{1, 0, 0}, {0, 1, 0}};
    bool turns = false;
    for (int i = 0; i < 2; ++i) {
        const murk_vec3 moved =
            murk_unit(murk_affine_direction(motion, axis[i]));
        turns = turns || murk_length(murk_sub(moved, axis[i])) > TURN_ROUNDING;
    }
    return turns;
}

/* Refuses lights that cannot move along: arrays, and luminaires that turn and
 * leave their directions to defaults, which would not turn. */
static murk_status check_mover(const changes *c, const murk_scene_track *track,
                               const murk_yaml *light, size_t number,
                               const murk_affine *motion)
{
    if (murk_yaml_get(light, "array")) {
        return murk_fail(c->err, MURK_BAD_VALUE, track->where,
                         "lights: %zu is an array, must be a light alone",
                         number);
    }
    if (murk_yaml_get(light, "file") && does_turn(motion) &&
        !(murk_yaml_get(light, "aim") && murk_yaml_get(light, "c0"))) {
        return murk_fail(c->err, MURK_BAD_VALUE, track->where,
                         "lights: %zu is a luminaire that turns, must have "
                         "aim and c0",
                         number);
    }
    return MURK_OK;
}

/* Moves the positions and directions of a light. */
static murk_status move_light(changes *c, const murk_scene_track *track,
                              size_t number, const murk_affine *motion)
{
    murk_yaml *light = murk_yaml_get(c->root, "lights")->child[number];
    const murk_keys *lights = murk_keys_find(&murk_scene_keys, "lights")->keys;
    const murk_status bad = check_mover(c, track, light, number, motion);
    if (bad) {
        return bad;
    }
    for (size_t i = 0; i < light->n; ++i) {
        murk_yaml *node = light->child[i];
        const murk_key *key = find_vector(lights, light->key[i]);
        if (!key || node->kind != MURK_YAML_LIST || node->n != 3 ||
            node->child[0]->kind != MURK_YAML_SCALAR) {
            continue;
        }
        char path[PATH_SIZE];
        snprintf(path, sizeof path, "lights.%zu.%s", number, light->key[i]);
        const murk_status status = note_path(c, path, track->where);
        if (status) {
            return status;
        }
        /* A position is moved and turned, a direction only turned. */
        const murk_vec3 old = vector_or_zero(node),
                        moved = key->is_position
                                    ? murk_affine_point(motion, old)
                                    : murk_affine_direction(motion, old);
        const double value[3] = {moved.x, moved.y, moved.z};
        for (int k = 0; k < 3; ++k) {
            murk_yaml *value_node = number_node(value[k], node->source);
            if (!value_node) {
                return no_memory(c);
            }
            murk_yaml_destroy(node->child[k]);
            node->child[k] = value_node;
        }
    }
    return MURK_OK;
}

/* Moves the lights of a track by the motion of its item. */
static murk_status move_lights(changes *c, const murk_scene_track *track,
                               const murk_affine *old, const murk_affine *new)
{
    const murk_yaml *lights = murk_yaml_get(c->root, "lights");
    const size_t n = lights && lights->kind == MURK_YAML_LIST ? lights->n : 0;
    murk_affine back;
    murk_status status = MURK_OK;
    /* Without motion every bit stays. */
    murk_affine motion = murk_affine_identity();
    if (memcmp(old, new, sizeof *old) != 0 && murk_affine_invert(old, &back)) {
        motion = murk_affine_compose(new, &back);
    }
    for (size_t i = 0; i < track->light.n && !status; ++i) {
        const double index = track->light.value[i];
        status = index < (double)n
                     ? move_light(c, track, (size_t)index, &motion)
                     : murk_fail(c->err, MURK_BAD_VALUE, track->where,
                                 "lights: %g, but the scene has %zu lights",
                                 index, n);
    }
    return status;
}

static murk_status no_such_item(const changes *c, const murk_scene_track *track,
                                const murk_yaml *list)
{
    const char *names[NAMES_MAX];
    size_t n = 0;
    for (size_t i = 0; i < list->n && n < NAMES_MAX; ++i) {
        const murk_yaml *name = murk_yaml_get(list->child[i], "name");
        if (name && name->kind == MURK_YAML_SCALAR) {
            names[n++] = name->text;
        }
    }
    return murk_fail(c->err, MURK_BAD_VALUE, track->where,
                     "geometry: %s is no name and no index of the %zu items%s",
                     track->item, list->n,
                     murk_words_suggest(track->item, names, n).text);
}

static murk_status move_geometry(changes *c, const murk_scene_track *track)
{
    static const murk_yaml none = {.kind = MURK_YAML_LIST};
    const murk_yaml *list = murk_yaml_get(c->root, "geometry");
    size_t i;
    list = list && list->kind == MURK_YAML_LIST ? list : &none;
    if (!murk_key_path_item(list, track->item, &i)) {
        return no_such_item(c, track, list);
    }
    const murk_affine old = placed(list->child[i]);
    char path[2][PATH_SIZE];
    snprintf(path[0], PATH_SIZE, "geometry.%zu.translate_m", i);
    snprintf(path[1], PATH_SIZE, "geometry.%zu.rotate_deg", i);
    murk_status status = put_member(c, track, "translate_m", path[0]);
    if (!status) {
        status = put_member(c, track, "rotate_deg", path[1]);
    }
    const murk_affine new = placed(list->child[i]);
    return status ? status : move_lights(c, track, &old, &new);
}

/* ---- sequences of grids ---- */

/* The frame of a track at from_s: that of the track, of the medium, or the
 * first that exists. */
static murk_status find_first(const changes *c, const murk_scene_track *track,
                              const murk_yaml *medium, uint64_t *first)
{
    const murk_yaml *own = murk_yaml_get(medium, "frame"),
                    *vdb = murk_yaml_get(medium, "vdb");
    if (track->has_first) {
        *first = track->first_frame;
        return MURK_OK;
    }
    if (own && murk_yaml_count(own, first)) {
        return MURK_OK;
    }
    char *pattern = track->frames ? strdup(track->frames)
                    : vdb         ? murk_value_opened(vdb)
                                  : NULL;
    const bool is_found = pattern && murk_frames_first(pattern, first);
    const murk_status status =
        is_found ? MURK_OK
                 : murk_fail(c->err, MURK_BAD_VALUE, track->where,
                             "no file matches %s, must be a pattern such as "
                             "smoke.####.vdb of files that exist",
                             pattern ? pattern : "the medium's vdb");
    free(pattern);
    return status;
}

bool murk_timeline_frame(const murk_scene_track *track, double t_s,
                         double *frame)
{
    const double steps = (t_s - track->from_s) / track->every_s;
    const double nearest = floor(steps + 0.5 + TIME_ROUNDING),
                 whole = floor(steps + TIME_ROUNDING);
    const bool is_whole = fabs(steps - nearest) <= TIME_ROUNDING;
    *frame = (double)track->first_frame +
             (track->between == MURK_BETWEEN_HOLD                  ? whole
              : is_whole || track->between == MURK_BETWEEN_NEAREST ? nearest
                                                                   : steps);
    return steps >= -TIME_ROUNDING;
}

/* Writes the first frame into the track of the tree, so that the resolved scene
 * gives the same frames again. */
static bool keep_first(const changes *c, size_t number, uint64_t first)
{
    murk_yaml *tracks =
        murk_yaml_get(murk_yaml_get(c->root, "timeline"), "tracks");
    murk_yaml *node = number_node((double)first, c->root->source);
    return node && murk_yaml_put(tracks->child[number], "first_frame", node);
}

static murk_status choose_files(changes *c, const murk_scene_track *track)
{
    const size_t number = (size_t)(track - c->timeline->track);
    const murk_yaml *media = murk_yaml_get(c->root, "media"),
                    *medium =
                        media ? murk_yaml_get(media, track->medium) : NULL;
    uint64_t first = 0;
    double frame = 0;
    char path[2][PATH_SIZE];
    if (!medium || medium->kind != MURK_YAML_MAP) {
        const bool has_any = media && media->kind == MURK_YAML_MAP;
        return murk_fail(
            c->err, MURK_BAD_VALUE, track->where,
            "medium: the scene has no medium %s%s", track->medium,
            murk_words_suggest(track->medium,
                               has_any ? (const char *const *)media->key : NULL,
                               has_any ? media->n : 0)
                .text);
    }
    /* The first file, then that of the time. */
    murk_status status = find_first(c, track, medium, &first);
    murk_scene_track from = *track;
    from.first_frame = first;
    if (!status && !murk_timeline_frame(&from, c->timeline->at_s, &frame)) {
        status = murk_fail(c->err, MURK_BAD_VALUE, track->where,
                           "medium: %s has no file at %g s, its files begin at "
                           "%g s",
                           track->medium, c->timeline->at_s, track->from_s);
    }
    if (!status && !keep_first(c, number, first)) {
        status = no_memory(c);
    }
    snprintf(path[0], PATH_SIZE, "media.%s.vdb", track->medium);
    snprintf(path[1], PATH_SIZE, "media.%s.frame", track->medium);
    if (!status && track->frames) {
        status = put(
            c, track, path[0],
            murk_yaml_copy(murk_yaml_get(c->tracks->child[number], "frames")));
    }
    return status ? status
                  : put(c, track, path[1], number_node(frame, c->root->source));
}

/* ---- keys and sensors ---- */

/* Refuses keyframes with lists of light sources of different lengths: photons
 * are dealt to the same light sources at all times. */
static murk_status check_lights(const changes *c, const murk_scene_track *track)
{
    const size_t number = (size_t)(track - c->timeline->track);
    const murk_yaml *frames =
        murk_yaml_get(c->tracks->child[number], "keyframes");
    const murk_yaml *first = murk_yaml_get(frames->child[0], "value");
    for (size_t i = 1; i < frames->n; ++i) {
        const murk_yaml *value = murk_yaml_get(frames->child[i], "value");
        if (first && value && first->n != value->n) {
            return murk_fail(c->err, MURK_BAD_VALUE, track->where,
                             "key: lights has %zu items at %g s and %zu at %g "
                             "s, must have as many at all times; a light that "
                             "is off has power_w 0",
                             first->n, track->keyframe[0].t_s, value->n,
                             track->keyframe[i].t_s);
        }
    }
    return MURK_OK;
}

/* Lets values of a key step that are no numbers between which there are others:
 * the track then says `hold`, so that the resolved scene does, too. Fails if
 * the track asks for `linear`. */
static murk_status choose_between(const changes *c,
                                  const murk_scene_track *track)
{
    const size_t number = (size_t)(track - c->timeline->track);
    const murk_key *row = murk_key_path_find(c->root, track->key).row;
    murk_yaml *given =
        murk_yaml_get(murk_yaml_get(c->root, "timeline"), "tracks")
            ->child[number];
    if (track->between != MURK_BETWEEN_LINEAR || !row ||
        murk_key_is_continuous(row)) {
        return MURK_OK;
    }
    /* The word as the user gave it: the track has the default, too. */
    if (murk_yaml_get(given, "between")) {
        return murk_fail(
            c->err, MURK_BAD_VALUE, track->where,
            "between: linear, but %s takes %s; must be nearest or hold",
            track->key,
            row->kind == MURK_KEY_COUNT || row->kind == MURK_KEY_SIZES
                ? "whole numbers"
                : "no numbers");
    }
    c->timeline->track[number].between = MURK_BETWEEN_HOLD;
    murk_yaml *word = text_node("hold", c->root->source);
    return word && murk_yaml_put(given, "between", word) ? MURK_OK
                                                         : no_memory(c);
}

static murk_status set_key(changes *c, const murk_scene_track *track)
{
    const murk_key *key = murk_scene_keys.key;
    while (key->name && !murk_override_overlap(track->key, key->name)) {
        ++key;
    }
    const bool is_goal = strcmp(track->key, "sensors.count") == 0 ||
                         strcmp(track->key, "sensors.target") == 0 ||
                         strcmp(track->key, "sensors.budget") == 0;
    if (key->name && key->is_still && !is_goal) {
        return murk_fail(c->err, MURK_BAD_VALUE, track->where,
                         "key: %s must be the same at all times", track->key);
    }
    murk_status status =
        strcmp(track->key, "lights") == 0 ? check_lights(c, track) : MURK_OK;
    if (!status) {
        status = choose_between(c, track);
    }
    return status ? status : put_member(c, track, "value", track->key);
}

/* Says of a fixed sensor whether it has failed by now. */
static murk_status set_failed(changes *c, const murk_scene_track *track)
{
    char path[PATH_SIZE];
    const bool has_failed = c->timeline->at_s >= track->fails_at_s;
    murk_yaml *failed =
        text_node(has_failed ? "true" : "false", c->root->source);
    snprintf(path, sizeof path, "sensors.fixed.%zu.failed",
             (size_t)track->sensor);
    return put(c, track, path, failed);
}

/* Checks a track of a sensor that is planned. The scene knows no more of such
 * sensors than how many have failed (murk_timeline_finish()): drift concerns
 * plans that follow each other alone. */
static murk_status check_planned(changes *c, const murk_scene_track *track,
                                 const murk_yaml *frame, size_t fixed)
{
    char path[PATH_SIZE];
    for (size_t i = 0; frame && i < frame->n; ++i) {
        const char *member = frame->key[i];
        if (strcmp(member, "t_s") != 0 && !strstr(member, "offset")) {
            return murk_fail(c->err, MURK_BAD_VALUE, track->where,
                             "sensor: %zu has keyframes of %s, which only the "
                             "%zu of sensors.fixed may have; others have "
                             "offset_m",
                             (size_t)track->sensor, member, fixed);
        }
    }
    snprintf(path, sizeof path, "drift.%zu", (size_t)track->sensor);
    return frame ? note_path(c, path, track->where) : MURK_OK;
}

/* Moves a fixed sensor, or marks it as failed. */
static murk_status set_fixed(changes *c, const murk_scene_track *track,
                             const murk_yaml *frame)
{
    static const char *const members[] = {"position_m", "heading_deg",
                                          "tilt_deg"};
    char path[PATH_SIZE];
    murk_status status = MURK_OK;
    for (size_t i = 0; frame && i < frame->n; ++i) {
        if (strstr(frame->key[i], "offset")) {
            return murk_fail(c->err, MURK_BAD_VALUE, track->where,
                             "sensor: %zu is of sensors.fixed, whose keyframes "
                             "have position_m, heading_deg and tilt_deg, not "
                             "%s",
                             (size_t)track->sensor, frame->key[i]);
        }
    }
    for (int i = 0; i < 3 && frame && !status; ++i) {
        snprintf(path, sizeof path, "sensors.fixed.%zu.%s",
                 (size_t)track->sensor, members[i]);
        status = put_member(c, track, members[i], path);
    }
    return status || !track->fails ? status : set_failed(c, track);
}

static murk_status set_sensor(changes *c, const murk_scene_track *track)
{
    const size_t number = (size_t)(track - c->timeline->track);
    const murk_yaml *sensors = murk_yaml_get(c->root, "sensors"),
                    *fixed = sensors ? murk_yaml_get(sensors, "fixed") : NULL,
                    *frames =
                        murk_yaml_get(c->tracks->child[number], "keyframes"),
                    *frame = frames ? frames->child[0] : NULL;
    const size_t n = fixed && fixed->kind == MURK_YAML_LIST ? fixed->n : 0;
    murk_status status = MURK_OK;
    char path[PATH_SIZE];
    /* The number of the sensor is noted like a path, so that no two tracks end
     * the same one. */
    snprintf(path, sizeof path, "sensor.%zu", (size_t)track->sensor);
    if (track->fails) {
        status = note_path(c, path, track->where);
    }
    if (status) {
        return status;
    }
    return track->sensor < n ? set_fixed(c, track, frame)
                             : check_planned(c, track, frame, n);
}

/* ---- all tracks ---- */

static murk_status apply_tracks(changes *c)
{
    typedef murk_status apply(changes *, const murk_scene_track *);
    static apply *const by_kind[] = {[MURK_TRACK_GEOMETRY] = move_geometry,
                                     [MURK_TRACK_MEDIUM] = choose_files,
                                     [MURK_TRACK_KEY] = set_key,
                                     [MURK_TRACK_SENSOR] = set_sensor};
    murk_status status = MURK_OK;
    for (size_t i = 0; i < c->timeline->tracks && !status; ++i) {
        const murk_scene_track *track = &c->timeline->track[i];
        status = by_kind[track->kind](c, track);
    }
    return status;
}

/* Reads the timeline alone, by its row of the key table, from a copy `node` of
 * its tree. */
static murk_status read_timeline(murk_scene_desc *out, murk_yaml *root,
                                 murk_yaml *node, murk_error *err)
{
    murk_key_reader walk = {.scene = out, .root = root, .err = err};
    const murk_key *row = murk_keys_find(&murk_scene_keys, "timeline");
    out->bands = 1;
    murk_walk_enter(&walk, row->name);
    const murk_status status = murk_walk_value(&walk, row, node, out);
    free(walk.paths);
    return status;
}

/* A timeline that was read, and the copy of its tree. */
typedef struct read_tree {
    murk_yaml *node; /* NULL: the scene has no timeline */
    murk_scene_desc *scene;
} read_tree;

static murk_status begin(read_tree *out, murk_yaml *root, murk_error *err)
{
    const murk_yaml *given =
        root->kind == MURK_YAML_MAP ? murk_yaml_get(root, "timeline") : NULL;
    *out = (read_tree){NULL, NULL};
    if (!given) {
        return MURK_OK;
    }
    out->node = murk_yaml_copy(given);
    out->scene = calloc(1, sizeof *out->scene);
    return out->node && out->scene
               ? read_timeline(out->scene, root, out->node, err)
               : murk_no_memory(err, root->source, "for the timeline");
}

static void end(read_tree *tree)
{
    murk_scene_desc_destroy(tree->scene);
    murk_yaml_destroy(tree->node);
}

murk_status murk_timeline_apply(murk_yaml *root, const murk_yaml *condition,
                                murk_error *err)
{
    read_tree tree;
    murk_status status = begin(&tree, root, err);
    if (!status && tree.node) {
        changes c = {.root = root,
                     .timeline = &tree.scene->timeline,
                     .tracks = murk_yaml_get(tree.node, "tracks"),
                     .condition = condition,
                     .err = err};
        status = apply_tracks(&c);
        free(c.path);
    }
    end(&tree);
    return status;
}

/* True if the scene places over conditions and has none. */
static bool wants_conditions(const murk_yaml *root)
{
    const murk_yaml *placement = murk_yaml_get(root, "placement"),
                    *all = murk_yaml_get(root, "conditions"),
                    *over = placement ? murk_yaml_get(placement, "over") : NULL;
    return over && over->kind == MURK_YAML_SCALAR && !murk_yaml_is_null(over) &&
           (!all || (all->kind == MURK_YAML_MAP && all->n == 0));
}

/* Makes the map of a condition that is a time. NULL when out of memory. */
static murk_yaml *condition_at(double t_s, const char *source)
{
    murk_yaml *map = murk_yaml_make(MURK_YAML_MAP, source);
    murk_yaml *number = number_node(t_s, source);
    if (!map || !number || !murk_yaml_put(map, "timeline.at_s", number)) {
        murk_yaml_destroy(map);
        return NULL;
    }
    return map;
}

static bool add_conditions(murk_yaml *root, const murk_scene_timeline *timeline)
{
    murk_yaml *all = murk_yaml_make(MURK_YAML_MAP, root->source);
    bool is_whole = all != NULL;
    for (size_t i = 0; is_whole && i < murk_timeline_steps(timeline); ++i) {
        char name[MURK_SCENE_NAME_SIZE];
        snprintf(name, sizeof name, "step-%04zu", i);
        murk_yaml *map =
            condition_at(murk_timeline_time_s(timeline, i), root->source);
        is_whole = map && murk_yaml_put(all, name, map);
    }
    if (!is_whole) {
        murk_yaml_destroy(all);
    }
    return is_whole && murk_yaml_put(root, "conditions", all);
}

murk_status murk_timeline_add_conditions(bool *added, murk_yaml *root,
                                         murk_error *err)
{
    read_tree tree = {NULL, NULL};
    murk_status status = root->kind == MURK_YAML_MAP && wants_conditions(root)
                             ? begin(&tree, root, err)
                             : MURK_OK;
    *added = !status && tree.node;
    if (*added) {
        const murk_scene_timeline *timeline = &tree.scene->timeline;
        const size_t steps = murk_timeline_steps(timeline);
        status = steps > MURK_SCENE_CONDITIONS_MAX
                     ? murk_fail(err, MURK_BAD_VALUE, timeline->where,
                                 "%zu steps for one plan (placement.over), "
                                 "must be at most %d",
                                 steps, MURK_SCENE_CONDITIONS_MAX)
                 : add_conditions(root, timeline)
                     ? MURK_OK
                     : murk_no_memory(err, root->source, "for the timeline");
    }
    end(&tree);
    return status;
}

/* The number of sensors that have failed. A number that no sensor of a plan of
 * so many has does not count. */
static uint64_t count_failed(const murk_scene_desc *scene)
{
    const murk_scene_timeline *timeline = &scene->timeline;
    const murk_scene_sensors *sensors = &scene->sensors;
    uint64_t failed = 0;
    for (size_t i = 0; i < timeline->tracks; ++i) {
        const murk_scene_track *track = &timeline->track[i];
        failed += track->fails && timeline->at_s >= track->fails_at_s &&
                  (track->sensor < sensors->count ||
                   track->sensor < sensors->fixed_listed);
    }
    return failed;
}

/* Puts the fixed sensors that have failed behind the others, whose order
 * stays, and counts the others alone. */
static void put_failed_last(murk_scene_sensors *sensors)
{
    size_t n = 0;
    for (size_t i = 0; i < sensors->n_fixed; ++i) {
        sensors->fixed[i].number = i;
        const murk_scene_fixed_sensor fixed = sensors->fixed[i];
        if (!fixed.is_failed) {
            memmove(&sensors->fixed[n + 1], &sensors->fixed[n],
                    (i - n) * sizeof fixed);
            sensors->fixed[n++] = fixed;
        }
    }
    sensors->n_fixed = n;
}

void murk_timeline_finish(murk_scene_desc *scene)
{
    murk_scene_sensors *sensors = &scene->sensors;
    const double t_s = scene->timeline.given ? scene->timeline.at_s : 0;
    scene->site.unix_s += t_s;
    for (size_t i = 0; i < scene->n_lights; ++i) {
        scene->lights[i].site.unix_s += t_s;
    }
    sensors->fixed_listed = sensors->n_fixed;
    put_failed_last(sensors);
    const uint64_t failed = count_failed(scene);
    sensors->all_failed = sensors->count > 0 && failed >= sensors->count;
    if (sensors->count > 0) {
        sensors->count -= sensors->all_failed ? sensors->count : failed;
    }
}
