/* The timeline: the values that tracks have at a time, the clocks, what the
 * resolved scene gives when it is read again, and refusals. Nothing here is
 * random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "refusals.h"
#include "scene/timeline.h"

#include <math.h>

#define BOX "domain: {min_m: [0, 0, 0], max_m: [9, 9, 9]}\n"
#define AT(tracks)                                                          \
    HEAD BOX "timeline: {from_s: 0, to_s: 10, every_s: 5, tracks: [" tracks \
             "]}\n"
#define LOAD                                                         \
    "geometry: [{sphere: {center_m: [8, 8, 8], radius_m: 1}},\n"     \
    "  {name: load, box: {min_m: [-1, -1, -1], max_m: [1, 1, 1]},\n" \
    "   translate_m: [1, 2, 3]}]\n"

/* Reads a scene at a time; the caller destroys it. */
static murk_scene_desc *read_at(const char *text, const char *at)
{
    murk_scene_desc *scene;
    murk_error err;
    char option[64];
    snprintf(option, sizeof option, "timeline.at_s=%s", at ? at : "");
    const murk_override override = {option, "--at"};
    if (scene_of(&scene, text, &override, at ? 1 : 0, &err)) {
        printf("%s: %s\n", err.where, err.text);
        CHECK(scene != NULL); /* a good scene was refused */
        exit(check_done());
    }
    return scene;
}

static void test_steps(void)
{
    murk_scene_desc *scene = read_at(AT("") LAMP, NULL);
    const murk_scene_timeline *t = &scene->timeline;
    CHECK(murk_timeline_steps(t) == 3 && t->at_s == 0);
    CHECK(murk_timeline_time_s(t, 2) == 10);
    murk_scene_desc_destroy(scene);
    /* A step at the end is not lost by rounding: .1 + 9 * .1 is below 1. */
    scene = read_at(
        HEAD BOX "timeline: {from_s: .1, to_s: 1, every_s: .1}\n" LAMP, NULL);
    CHECK(murk_timeline_steps(&scene->timeline) == 10);
    murk_scene_desc_destroy(scene);
    scene = read_at(HEAD BOX "timeline: {times_s: [3, 4.5, 70]}\n" LAMP, NULL);
    CHECK(murk_timeline_steps(&scene->timeline) == 3);
    CHECK(scene->timeline.at_s == 3);
    CHECK(murk_timeline_time_s(&scene->timeline, 1) == 4.5);
    murk_scene_desc_destroy(scene);
}

/* The power of the lamp at a time. */
static double power_at(const char *text, const char *at)
{
    murk_scene_desc *scene = read_at(text, at);
    const double power_w = scene->lights[0].power_w.band[0];
    murk_scene_desc_destroy(scene);
    return power_w;
}

#define POWERS(between)                                                    \
    AT("{key: lights.0.power_w, between: " between ", keyframes: "         \
       "[{t_s: 2, value: 10}, {t_s: 4, value: 20}, {t_s: 8, value: 60}]}") \
    LAMP

static void test_keys_between_keyframes(void)
{
    const struct {
        const char *at;
        double linear, nearest, hold;
    } cases[] = {
        {"-5", 10, 10, 10}, {"2", 10, 10, 10},     {"2.5", 12.5, 10, 10},
        {"3", 15, 20, 10},  {"3.5", 17.5, 20, 10}, {"4", 20, 20, 20},
        {"7", 50, 60, 20},  {"8", 60, 60, 60},     {"99", 60, 60, 60}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        CHECK(power_at(POWERS("linear"), cases[i].at) == cases[i].linear);
        CHECK(power_at(POWERS("nearest"), cases[i].at) == cases[i].nearest);
        CHECK(power_at(POWERS("hold"), cases[i].at) == cases[i].hold);
    }
}

static void test_lists_are_interpolated_and_words_hold(void)
{
    const char text[] =
        AT("{key: lights.0.position_m, keyframes: [{t_s: 0, value: [0, 4, 8]},"
           "  {t_s: 10, value: [1, 0, 8]}]},"
           "{key: media.fog.phase, keyframes: [{t_s: 0, value: isotropic},"
           "  {t_s: 10, value: rayleigh}]}") "media: {fog: {extinction_per_m: "
                                             "1, albedo: 1}}\n" LAMP;
    murk_scene_desc *scene = read_at(text, "5");
    const murk_vec3 p = scene->lights[0].position;
    CHECK(p.x == 0.5 && p.y == 2 && p.z == 8);
    CHECK(scene->media[0].phase[0].kind == MURK_PHASE_HG);
    murk_scene_desc_destroy(scene);
    scene = read_at(text, "10");
    CHECK(scene->media[0].phase[0].kind == MURK_PHASE_RAYLEIGH);
    murk_scene_desc_destroy(scene);
}

/* Between two whole numbers, words or maps there is no other value: they hold,
 * unless the track asks for the nearest, and the scene as resolved says so. */
static void test_whole_numbers_step(void)
{
    const char text[] =
        AT("{key: sensors.count, keyframes: [{t_s: 0, value: 2}, {t_s: 10, "
           "value: 5}]}, {key: cameras.0.samples, between: nearest, "
           "keyframes: [{t_s: 0, value: 4}, {t_s: 10, value: 9}]}, "
           "{key: media.fog.phase, keyframes: [{t_s: 0, value: {hg: 0}}, {t_s: "
           "10, value: {hg: 0.5}}]}, {key: media.mist.phase.hg, keyframes: "
           "[{t_s: 0, value: 0}, {t_s: 10, value: 0.5}]}") SENSORS
        "count: 3}\n"
        "media: {fog: {extinction_per_m: 1, albedo: 1}, mist: "
        "{extinction_per_m: 1, albedo: 1}}\n"
        "cameras: [{name: eye, from_m: [1, 1, 1], to_m: [2, 2, "
        "2]}]\n" LAMP;
    murk_scene_desc *scene = read_at(text, "9");
    CHECK(scene->sensors.count == 2);
    CHECK(scene->timeline.track[0].between == MURK_BETWEEN_HOLD);
    CHECK(scene->cameras[0].samples == 9);
    CHECK(scene->media[0].phase[0].mean_cosine.band[0] == 0);
    CHECK_NEAR(scene->media[1].phase[0].mean_cosine.band[0], 0.45, 1e-15);
    /* The scene as resolved. */
    murk_scene_desc *again = read_at(scene->resolved, "10");
    CHECK(again->sensors.count == 5);
    CHECK(again->media[0].phase[0].mean_cosine.band[0] == 0.5);
    murk_scene_desc_destroy(again);
    murk_scene_desc_destroy(scene);
}

/* A track that replaces an item by another one leaves it the name by which the
 * scene as resolved, and other keys, find it. */
static void test_items_keep_their_names(void)
{
    const char *const paths[] = {"geometry.load", "geometry.1"};
    for (int i = 0; i < 2; ++i) {
        char text[1000];
        snprintf(text, sizeof text,
                 AT("{key: %s, keyframes: [{t_s: 0, value: {sphere: {center_m: "
                    "[2, 2, 2], radius_m: 1}}}, {t_s: 5, value: {name: load, "
                    "sphere: {center_m: [3, 2, 2], radius_m: 1}}}]}") LOAD LAMP,
                 paths[i]);
        murk_scene_desc *scene = read_at(text, "0");
        CHECK_TEXT(scene->geometry[1].name, "load");
        murk_scene_desc *again = read_at(scene->resolved, "6");
        CHECK_TEXT(again->geometry[1].name, "load");
        CHECK(again->geometry[1].solid.center.x == 3);
        murk_scene_desc_destroy(again);
        murk_scene_desc_destroy(scene);
    }
    CHECK_REFUSED(AT("{key: geometry.load, keyframes: [{t_s: 0, value: {name: "
                     "hook, sphere: {center_m: [2, 2, 2], radius_m: 1}}}]}")
                      LOAD LAMP,
                  VALUE, "fog.yaml:3:54: timeline.tracks.0",
                  "key: geometry.load has another name at a keyframe, must be "
                  "load or left out");
}

/* A lamp moves along with the load: it is shifted, and turned about the place
 * of the load. */
static void test_geometry_moves_with_its_lights(void)
{
    const char *const items[] = {"load", "1"};
    for (int i = 0; i < 2; ++i) {
        char text[1000];
        snprintf(text, sizeof text,
                 AT("{geometry: %s, lights: [0], keyframes: ["
                    "{t_s: 0, translate_m: [1, 2, 3], rotate_deg: [0, 0, 0]},"
                    "{t_s: 10, translate_m: [3, 2, 3], rotate_deg: [0, 0, 90]}]"
                    "}") LOAD
                 "lights: [{type: beam, origin_m: [2, 2, 4], direction: [1, 0, "
                 "0], power_w: 1}]\n",
                 items[i]);
        murk_scene_desc *scene = read_at(text, "10");
        const murk_scene_solid *load = &scene->geometry[1].solid;
        CHECK(load->translate_m.x == 3 && load->translate_m.y == 2);
        CHECK(load->rotate_deg.z == 90);
        CHECK(scene->geometry[0].solid.translate_m.x == 0);
        const murk_vec3 p = scene->lights[0].position,
                        d = scene->lights[0].direction;
        CHECK(murk_length(murk_sub(p, murk_vec(3, 3, 4))) < 1e-12);
        CHECK(murk_length(murk_sub(d, murk_vec(0, 1, 0))) < 1e-12);
        murk_scene_desc_destroy(scene);
        scene = read_at(text, "5");
        CHECK(scene->geometry[1].solid.translate_m.x == 2);
        CHECK(scene->geometry[1].solid.rotate_deg.z == 45);
        murk_scene_desc_destroy(scene);
        /* At the first keyframe the item is where the scene has it: the lights
         * keep their bits. */
        scene = read_at(text, "0");
        CHECK(scene->lights[0].position.x == 2);
        CHECK(scene->lights[0].direction.x == 1);
        murk_scene_desc_destroy(scene);
    }
}

/* Even below, and dark above. */
#define IES "IESNA91\nTILT=NONE\n1 9 1 2 1 1 2 0 0 0\n1 1 3\n0 90\n0\n1 1\n"
#define LOAD_TURNS                                                       \
    AT("{geometry: load, lights: [0], keyframes: [{t_s: 0, rotate_deg: " \
       "[90, 0, 0]}]}")                                                  \
    LOAD
#define LAMP_OF_LOAD                                                      \
    "lights: [{type: luminaire, file: a.ies, position_m: [1, 2, 4], c0: " \
    "[1, 0, 0]"

/* The aim of a luminaire and C = 0 turn along with the load. If the scene
 * leaves one of them to its default, the track is refused. */
static void test_luminaires_turn(void)
{
    write_text("a.ies", IES);
    murk_scene_desc *scene =
        read_at(LOAD_TURNS LAMP_OF_LOAD ", aim: [0, 0, -1]}]\n", "0");
    const murk_scene_light *l = &scene->lights[0];
    CHECK(murk_length(murk_sub(l->direction, murk_vec(0, 1, 0))) < 1e-12);
    CHECK(murk_length(murk_sub(l->c0, murk_vec(1, 0, 0))) < 1e-12);
    murk_scene_desc_destroy(scene);
    CHECK_REFUSED(LOAD_TURNS LAMP_OF_LOAD "}]\n", VALUE,
                  "fog.yaml:3:54: timeline.tracks.0",
                  "lights: 0 is a luminaire that turns, must have aim and c0");
    CHECK_REFUSED(LOAD_TURNS "lights: [{type: luminaire, file: a.ies, "
                             "position_m: [1, 2, 4], aim: [0, 0, -1]}]\n",
                  VALUE, "fog.yaml:3:54: timeline.tracks.0",
                  "lights: 0 is a luminaire that turns, must have aim and c0");
}

#define PLUME                                                                \
    "media: {plume: {vdb: s.##.vdb, frame: 7, extinction_per_m: 1, albedo: " \
    "1}}\nregions: [{medium: plume}]\n"

static double frame_at(const char *track, const char *at)
{
    char text[1000];
    snprintf(text, sizeof text, AT("%s") PLUME LAMP, track);
    murk_scene_desc *scene = read_at(text, at);
    const murk_scene_medium *plume = &scene->media[0];
    const double frame = plume->frame;
    CHECK(plume->next_weight == (plume->vdb_next ? frame - floor(frame) : 0));
    murk_scene_desc_destroy(scene);
    return frame;
}

static void test_sequences_of_grids(void)
{
    const char nearest[] = "{medium: plume, from_s: 1, every_s: 0.1}",
               held[] = "{medium: plume, every_s: 2, between: hold}",
               own[] = "{medium: plume, frames: a.##.vdb, first_frame: 20, "
                       "every_s: 2}",
               mixed[] = "{medium: plume, every_s: 2, between: linear}";
    CHECK(frame_at(nearest, "1") == 7);
    CHECK(frame_at(nearest, "1.3") == 10); /* (1.3 - 1) / .1 is below 3 */
    CHECK(frame_at(nearest, "1.34") == 10 && frame_at(nearest, "1.36") == 11);
    CHECK(frame_at(nearest, "1.05") == 8); /* halfway: the later one */
    CHECK(frame_at(held, "3.9") == 8 && frame_at(held, "4") == 9);
    CHECK(frame_at(own, "4") == 22);
    CHECK(frame_at(mixed, "4") == 9 && frame_at(mixed, "4.5") == 9.25);
    /* Without a number in the scene the first file is that which exists. */
    write_text("s.05.vdb", "");
    write_text("s.04.vdb", "");
    char text[1000];
    snprintf(
        text, sizeof text,
        AT("{medium: plume, every_s: 2}") "media: {plume: {vdb: "
                                          "s.##.vdb, extinction_per_m: 1, "
                                          "albedo: 1}}\nregions: [{medium: "
                                          "plume}]\n" LAMP);
    murk_scene_desc *scene = read_at(text, "4");
    CHECK(scene->media[0].frame == 6);
    CHECK_TEXT(scene->media[0].vdb, "s.06.vdb");
    /* The scene as resolved counts from the same file. */
    char *resolved = strdup(scene->resolved);
    CHECK_MENTIONS(resolved, "first_frame: 4");
    murk_scene_desc *again = read_at(resolved, NULL);
    CHECK(again->media[0].frame == 6);
    murk_scene_desc_destroy(again);
    murk_scene_desc_destroy(scene);
    free(resolved);
    unlink("s.04.vdb");
    unlink("s.05.vdb");
}

static void test_sensors_drift_and_fail(void)
{
    const char text[] = AT(
        "{sensor: 0, fails_at_s: 6, keyframes: [{t_s: 0, position_m: [1, 1, 1]}"
        ", {t_s: 4, position_m: [3, 1, 1]}]}, {sensor: 4, fails_at_s: 0}, "
        "{sensor: 5, fails_at_s: 0}") SENSORS
        "count: 5, fixed: [{position_m: [1, 1, 1]}, {position_m: [4, "
        "4, 4]}]}\n" LAMP;
    murk_scene_desc *scene = read_at(text, "2");
    CHECK(scene->sensors.n_fixed == 2);
    CHECK(scene->sensors.fixed[0].position.x == 2);
    murk_scene_desc_destroy(scene);
    scene = read_at(text, "5.9");
    CHECK(scene->sensors.n_fixed == 2);
    CHECK(scene->sensors.fixed[0].position.x == 3);
    murk_scene_desc_destroy(scene);
    scene = read_at(text, "6");
    CHECK(scene->sensors.n_fixed == 1);
    CHECK(scene->sensors.fixed[0].position.x == 4);
    /* Sensors 0 and 4 have failed; a plan of 5 has no sensor of number 5. */
    CHECK(scene->sensors.count == 3);
    murk_scene_desc *again = read_at(scene->resolved, NULL);
    CHECK(again->sensors.n_fixed == 1 && again->sensors.count == 3);
    murk_scene_desc_destroy(again);
    /* The scene as resolved after a failure has the sensor before it. */
    again = read_at(scene->resolved, "5");
    CHECK(again->sensors.n_fixed == 2 && again->sensors.count == 4);
    murk_scene_desc_destroy(again);
    murk_scene_desc_destroy(scene);
}

/* The displacement of a planned sensor, between keyframes and beyond them. */
static void test_offsets(void)
{
    const char text[] =
        AT("{sensor: 3, keyframes: [{t_s: 2, offset_m: [1, 0, -1], "
           "heading_offset_deg: 0}, {t_s: 6, offset_m: [3, 1, -1], "
           "heading_offset_deg: 90}]}, {sensor: 2, between: hold, keyframes: "
           "[{t_s: 0, offset_m: [1, 0, 0]}, {t_s: 4, offset_m: [2, 0, 0]}]}")
            SENSORS "count: 5}\n" LAMP;
    murk_scene_desc *scene = read_at(text, "2");
    const murk_scene_track *track = scene->timeline.track;
    const murk_drift before = murk_timeline_drift(&track[0], -7),
                     half = murk_timeline_drift(&track[0], 4),
                     after = murk_timeline_drift(&track[0], 99);
    CHECK(before.offset_m.x == 1 && before.offset_m.z == -1);
    CHECK(before.heading_rad == 0);
    CHECK(half.offset_m.x == 2 && half.offset_m.y == 0.5);
    CHECK_NEAR(half.heading_rad, MURK_PI / 4, 1e-15);
    CHECK(after.offset_m.x == 3 && after.tilt_rad == 0);
    CHECK(murk_timeline_drift(&track[1], 3.9).offset_m.x == 1);
    CHECK(murk_timeline_drift(&track[1], 4).offset_m.x == 2);
    CHECK(scene->sensors.count == 5);
    murk_scene_desc_destroy(scene);
}

#define SITE                                                                \
    "site: {latitude_deg: 50, longitude_deg: 8, time: 2026-06-21T12:00Z}\n" \
    "band_edges_nm: [400, 700]\n"

static void test_clocks_run(void)
{
    murk_scene_desc *early =
        read_at(AT("") SITE "lights: [{type: sun}]\n", NULL);
    murk_scene_desc *late =
        read_at(AT("") SITE "lights: [{type: sun}]\n", "7200");
    CHECK(late->site.unix_s == early->site.unix_s + 7200);
    CHECK(late->lights[0].site.unix_s == early->lights[0].site.unix_s + 7200);
    CHECK(strcmp(late->light_key, early->light_key) != 0);
    CHECK_TEXT(late->world_key, early->world_key);
    murk_scene_desc *again = read_at(late->resolved, NULL);
    CHECK(again->site.unix_s == late->site.unix_s);
    CHECK_TEXT(again->light_key, late->light_key);
    CHECK_TEXT(again->resolved, late->resolved);
    murk_scene_desc_destroy(again);
    murk_scene_desc_destroy(late);
    murk_scene_desc_destroy(early);
    /* The light of a lamp that no clock switches is the same at all times. */
    early = read_at(AT("") SITE LAMP, NULL);
    late = read_at(AT("") SITE LAMP, "7200");
    CHECK_TEXT(late->light_key, early->light_key);
    CHECK(strcmp(late->whole_key, early->whole_key) != 0);
    murk_scene_desc_destroy(late);
    murk_scene_desc_destroy(early);
}

/* Rounding is that of the domain in a scene with a timeline, so its light is
 * another than without one. */
static void test_light_of_a_timeline_is_its_own(void)
{
    murk_scene_desc *with = read_at(AT("") LAMP, NULL);
    murk_scene_desc *without = read_at(HEAD BOX LAMP, NULL);
    CHECK(strcmp(with->light_key, without->light_key) != 0);
    CHECK(strcmp(with->world_key, without->world_key) != 0);
    murk_scene_desc_destroy(with);
    murk_scene_desc_destroy(without);
}

static void test_conditions_are_times(void)
{
    murk_scene_desc *scene =
        read_at(AT("{key: lights.0.power_w, keyframes: [{t_s: 0, value: 10},"
                   "  {t_s: 10, value: 20}]}") LAMP
                "conditions: {early: {}, late: {timeline.at_s: 5}}\n",
                NULL);
    CHECK(scene->lights[0].power_w.band[0] == 10);
    CHECK(scene->conditions[0].scene->lights[0].power_w.band[0] == 10);
    CHECK(scene->conditions[1].scene->lights[0].power_w.band[0] == 15);
    CHECK(scene->conditions[1].scene->timeline.at_s == 5);
    murk_scene_desc_destroy(scene);
}

/* One plan for all steps: each is a condition. */
static void test_steps_are_conditions(void)
{
    murk_scene_desc *scene = read_at(
        AT("{key: lights.0.power_w, keyframes: [{t_s: 0, value: 10},"
           "  {t_s: 10, value: 20}]}") LAMP "placement: {over: worst}\n",
        NULL);
    CHECK(scene->n_conditions == 3);
    CHECK_TEXT(scene->conditions[1].name, "step-0001");
    CHECK(scene->conditions[1].scene->timeline.at_s == 5);
    CHECK(scene->conditions[1].scene->lights[0].power_w.band[0] == 15);
    murk_scene_desc *again = read_at(scene->resolved, NULL);
    CHECK(again->n_conditions == 3);
    CHECK_TEXT(again->resolved, scene->resolved);
    murk_scene_desc_destroy(again);
    murk_scene_desc_destroy(scene);
    /* Conditions of the scene stay the only ones. */
    scene = read_at(AT("") LAMP "placement: {over: mean}\n"
                                "conditions: {late: {timeline.at_s: 7}}\n",
                    NULL);
    CHECK(scene->n_conditions == 1);
    murk_scene_desc_destroy(scene);
    CHECK_REFUSED(HEAD BOX "timeline: {from_s: 0, to_s: 64, every_s: 1}\n"
                           "placement: {over: mean}\n" LAMP,
                  VALUE, "fog.yaml:3:1: timeline",
                  "65 steps for one plan (placement.over), must be at most 64");
}

static void test_names_stand_for_indices(void)
{
    murk_scene_desc *scene;
    murk_error err;
    const murk_override by_name = {"geometry.load.translate_m=[7, 7, 7]", NULL},
                        wrong = {"geometry.lod.translate_m=[7, 7, 7]", NULL};
    CHECK(scene_of(&scene, HEAD LOAD LAMP, &by_name, 1, &err) == MURK_OK);
    CHECK(scene && scene->geometry[1].solid.translate_m.x == 7);
    murk_scene_desc_destroy(scene);
    CHECK(scene_of(&scene, HEAD LOAD LAMP, &wrong, 1, &err) == VALUE);
    CHECK_TEXT(err.text, "item lod of a list of 2, must be 0..1 or the name of "
                         "an item");
    CHECK_REFUSED(HEAD LAMP
                  "geometry: [{name: a, sphere: {center_m: [0, 0, 0], radius_m:"
                  " 1}}, {name: a, sphere: {center_m: [0, 0, 0], radius_m: 1}}"
                  "]\n",
                  VALUE, "fog.yaml:3:67: geometry.1",
                  "name: a is the name of an earlier geometry, must be one's "
                  "own");
    CHECK_REFUSED(HEAD LAMP "geometry: [{name: \"12\", sphere: {center_m: [0, "
                            "0, 0], radius_m: 1}}]\n",
                  VALUE, "fog.yaml:3:12: geometry.0",
                  "name: 12, must not be a number or have a point");
}

#define TRACKS(tracks) \
    BOX "timeline: {from_s: 0, to_s: 1, every_s: 1, tracks: [" tracks "]}\n"
#define TRACK_0 "fog.yaml:3:53: timeline.tracks.0"
#define MOVE    "keyframes: [{t_s: 0, translate_m: [0, 0, 0]}]"
#define FRAMES  "keyframes: [{t_s: 0, value: 1}]"

static void test_refusals(void)
{
    static const refusal refusals[] = {
        {"timeline: {times_s: [1]}\n", VALUE, "fog.yaml:2:1: timeline",
         "needs a domain, which must not change with time; a scene without one "
         "has that of its geometry"},
        {"timeline: {}\n", VALUE, "fog.yaml:2:1: timeline",
         "misses a key of a timeline, must be one of from_s, times_s"},
        {"timeline: {from_s: 1, to_s: 2}\n", VALUE, "fog.yaml:2:1: timeline",
         "misses every_s, must have from_s, to_s and every_s together, or "
         "times_s"},
        {"timeline: {from_s: 3, to_s: 2, every_s: 1}\n", VALUE,
         "fog.yaml:2:1: timeline", "to_s: 2 is before from_s 3, must not be"},
        {"timeline: {from_s: 0, to_s: 2, every_s: 1e-6}\n", VALUE,
         "fog.yaml:2:1: timeline", "2e+06 steps, must be at most 1000000"},
        {"timeline: {times_s: [1, 3, 2]}\n", VALUE, "fog.yaml:2:1: timeline",
         "times_s: 2 after 3, must rise"},
        {TRACKS("{geometry: load, keyframes: [{t_s: 0, translate_m: [0, 0, "
                "0]}]}"),
         VALUE, TRACK_0,
         "geometry: load is no name and no index of the 0 items"},
        {TRACKS("{geometry: 0, keyframes: [{t_s: 0}]}"), VALUE,
         "fog.yaml:3:79: timeline.tracks.0.keyframes.0",
         "has t_s alone, must say what changes"},
        {TRACKS("{geometry: 0, keyframes: [{t_s: 0, value: 2}]}"), VALUE,
         "fog.yaml:3:79: timeline.tracks.0.keyframes.0",
         "value is no key of the keyframes of such a track"},
        {TRACKS("{key: seed, " FRAMES "}"), VALUE, TRACK_0,
         "key: seed must be the same at all times"},
        {TRACKS("{key: sensors.types, " FRAMES "}"), VALUE, TRACK_0,
         "key: sensors.types must be the same at all times"},
        {TRACKS("{sensor: 3, fails_at_s: 1}, {sensor: 3, fails_at_s: 2}"),
         VALUE, "fog.yaml:3:81: timeline.tracks.1",
         "sets sensor.3, which an earlier track sets, too"},
        {TRACKS("{key: domain.max_m, " FRAMES "}"), VALUE, TRACK_0,
         "key: domain.max_m must be the same at all times"},
        {TRACKS("{key: lights.0.pover_w, " FRAMES "}"), VALUE, TRACK_0,
         "no pover_w in lights, did you mean power_w?"},
        {TRACKS("{key: lights.0.power_w, keyframes: [{t_s: 2, value: 1}, {t_s: "
                "1, value: 1}]}"),
         VALUE, "fog.yaml:3:109: timeline.tracks.0.keyframes",
         "t_s: 1 after 2, must rise"},
        {TRACKS("{sensor: 0}"), VALUE, TRACK_0,
         "misses keyframes or fails_at_s, must have one of them"},
        {TRACKS("{medium: fog, every_s: 1}"), VALUE, TRACK_0,
         "medium: the scene has no medium fog"},
        {TRACKS("{medium: fog}"), VALUE, TRACK_0,
         "misses every_s, must be a number, more than 0 and at most 1e9 s"},
        {TRACKS("{key: lights.0.power_w, " FRAMES "}, {key: lights.0, " FRAMES
                "}"),
         VALUE, "fog.yaml:3:111: timeline.tracks.1",
         "sets lights.0, which an earlier track sets, too"},
        {TRACKS("{key: lights, keyframes: [{t_s: 0, value: [{type: point, "
                "position_m: [1, 1, 1], power_w: 1}]}, {t_s: 1, value: []}]}"),
         VALUE, TRACK_0,
         "key: lights has 1 items at 0 s and 0 at 1 s, must have as many at "
         "all "
         "times; a light that is off has power_w 0"},
        {TRACKS("{key: sensors.count, between: linear, " FRAMES "}"), VALUE,
         TRACK_0,
         "between: linear, but sensors.count takes whole numbers; must be "
         "nearest or hold"},
        {TRACKS("{key: lights.0.schedule, between: linear, " FRAMES "}"), VALUE,
         TRACK_0,
         "between: linear, but lights.0.schedule takes no numbers; must be "
         "nearest or hold"},
        {TRACKS("{key: lights.0.power_w, keyframes: [{t_s: 0, value: -1}]}"),
         VALUE, "fog.yaml:3:105: lights.0.power_w", "-1, must be 0..1e15 W"},
    };
    check_refusals(refusals, sizeof refusals / sizeof *refusals);
    CHECK_REFUSED(AT("{sensor: 1, keyframes: [{t_s: 0, position_m: [1, 1, 1]}]"
                     "}") SENSORS "fixed: [{position_m: [1, 1, 1]}]}\n" LAMP,
                  VALUE, "fog.yaml:3:54: timeline.tracks.0",
                  "sensor: 1 has keyframes of position_m, which only the 1 of "
                  "sensors.fixed may have; others have offset_m");
    /* A name and an index are the same key; a light moves with one item, and a
     * condition does not set what a track sets. */
    CHECK_REFUSED(AT("{geometry: load, " MOVE "}, {key: "
                     "geometry.1.translate_m, keyframes: [{t_s: 0, value: [0, "
                     "0, 0]}]}") LOAD LAMP,
                  VALUE, "fog.yaml:3:119: timeline.tracks.1",
                  "sets geometry.1.translate_m, which an earlier track sets, "
                  "too");
    CHECK_REFUSED(AT("{geometry: 0, lights: [0], " MOVE "}, {geometry: 1, "
                     "lights: [0], " MOVE "}") LOAD LAMP,
                  VALUE, "fog.yaml:3:129: timeline.tracks.1",
                  "sets lights.0.position_m, which an earlier track sets, too");
    CHECK_REFUSED(AT("{geometry: 0, lights: [0], " MOVE "}") LOAD LAMP
                  "conditions: {a: {lights.0.position_m: [1, 1, 1]}}\n",
                  VALUE, "fog.yaml:3:54: timeline.tracks.0",
                  "sets lights.0.position_m, which the condition sets, too");
    CHECK_REFUSED(AT("{geometry: load, " MOVE "}") LOAD LAMP
                  "conditions: {a: {geometry.1.translate_m: [1, 1, 1]}}\n",
                  VALUE, "fog.yaml:3:54: timeline.tracks.0",
                  "sets geometry.1.translate_m, which the condition sets, too");
    /* Before the first file of a sequence there is no grid. */
    CHECK_REFUSED(AT("{medium: plume, from_s: 3, every_s: 1}") PLUME LAMP,
                  VALUE, "fog.yaml:3:54: timeline.tracks.0",
                  "medium: plume has no file at 0 s, its files begin at 3 s");
}

/* An option, or a row of a study, does not set what a track sets at any time; a
 * value around it, and the place of an item that lights move with, it may. */
static void test_options(void)
{
    static const struct {
        const char *option, *track;
        bool is_refused;
    } cases[] = {
        {"geometry.load.translate_m=[5,5,5]", "{geometry: 1, " MOVE "}", true},
        {"geometry.load.translate_m=[5,5,5]",
         "{geometry: load, lights: [0], " MOVE "}", false},
        {"geometry.load.scale=2", "{geometry: load, " MOVE "}", false},
        {"lights.0.power_w=2",
         "{key: lights.0.power_w, keyframes: [{t_s: 0, value: 3}]}", true},
        {"lights.0={type: point, position_m: [1,1,1], power_w: 2}",
         "{key: lights.0.power_w, keyframes: [{t_s: 0, value: 3}]}", false},
        {"lights.0.position_m=[1,1,1]",
         "{key: lights.0.power_w, keyframes: [{t_s: 0, value: 3}]}", false},
    };
    /* Read each. */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        char text[2048];
        murk_scene_desc *scene = NULL;
        murk_error err;
        const murk_override override = {cases[i].option, NULL};
        snprintf(text, sizeof text, AT("%s") LOAD LAMP, cases[i].track);
        const murk_status status = scene_of(&scene, text, &override, 1, &err);
        CHECK(status == (cases[i].is_refused ? MURK_BAD_VALUE : MURK_OK));
        if (status) {
            CHECK(strstr(err.where, "--set "));
            CHECK(strstr(err.text, "a track of the timeline sets"));
        }
        murk_scene_desc_destroy(scene);
    }
}

int main(void)
{
    test_options();
    if (!folder_enter()) {
        return 1;
    }
    test_steps();
    test_keys_between_keyframes();
    test_lists_are_interpolated_and_words_hold();
    test_whole_numbers_step();
    test_items_keep_their_names();
    test_geometry_moves_with_its_lights();
    test_luminaires_turn();
    test_sequences_of_grids();
    test_sensors_drift_and_fail();
    test_offsets();
    test_clocks_run();
    test_light_of_a_timeline_is_its_own();
    test_conditions_are_times();
    test_steps_are_conditions();
    test_names_stand_for_indices();
    test_refusals();
    folder_leave((const char *const[]){"fog.yaml", "a.ies", NULL});
    return check_done();
}
