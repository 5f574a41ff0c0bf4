/* The timeline of a scene: puts the values that the tracks have at one time in
 * place in the tree of the scene, before the scene is checked, so that nothing
 * later needs to know of tracks.
 *
 * A track replaces the value that the scene gives to its keys; an option or a
 * condition may not give one. Doing so twice for the same time changes nothing
 * more: the resolved scene, which contains the timeline, gives the same scene
 * again. */
#ifndef MURK_SCENE_TIMELINE_H
#define MURK_SCENE_TIMELINE_H

#include "scene/scene.h"
#include "scene/yaml.h"

/* Puts the values of the time timeline.at_s, or without that key of the first
 * step, in place. Does nothing without the key `timeline`. condition: the map
 * of the condition whose values are in place; no track may set a key of it.
 * NULL: none. Fails with MURK_BAD_VALUE or MURK_BAD_FILE at the place of the
 * track, or with MURK_NO_MEMORY. */
murk_status murk_timeline_apply(murk_yaml *root, const murk_yaml *condition,
                                murk_error *err);

/* If the tree has a timeline and places over conditions, but has none, adds a
 * condition for each step: `step-0000`, with timeline.at_s, and so on. So a
 * plan over conditions is one for all steps. *added: it has done so. Fails with
 * MURK_BAD_VALUE if there are more than MURK_SCENE_CONDITIONS_MAX steps, as
 * reading the timeline does, or with MURK_NO_MEMORY. */
murk_status murk_timeline_add_conditions(bool *added, murk_yaml *root,
                                         murk_error *err);

/* For the structs of a scene that was read from such a tree: advances the
 * clocks of the scene and of its lights by at_s, removes the fixed sensors that
 * have failed, and lowers sensors.count by the number of all that have. Numbers
 * of sensors that are sensors.count or more do not count. */
void murk_timeline_finish(murk_scene_desc *scene);

/* The number of steps, at least 1, and the time of step i [s]. */
size_t murk_timeline_steps(const murk_scene_timeline *timeline);
double murk_timeline_time_s(const murk_scene_timeline *timeline, size_t i);

/* True if powers of light sources may change in the course of the timeline: by
 * tracks of keys of lights or site, or by clocks. */
bool murk_timeline_changes_power(const murk_scene_desc *scene);

/* The displacement of a planned sensor. */
typedef struct murk_drift {
    murk_vec3 offset_m;
    double heading_rad, tilt_rad;
} murk_drift;

/* The displacement of a track with keyframes at a time. A sensor that was
 * placed at another time has drifted by the difference to the displacement at
 * that time. */
murk_drift murk_timeline_drift(const murk_scene_track *track, double t_s);

/* The number of the file of a track of a medium at a time, counted from
 * first_frame at from_s: whole unless the track is interpolated linearly. False
 * before from_s, when there is none. */
bool murk_timeline_frame(const murk_scene_track *track, double t_s,
                         double *frame);

#endif
