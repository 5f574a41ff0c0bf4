/* Reads what the page shows in space: sensors and photons of each state. read.c
 * reads studies, readings and paths, and world.c builds surfaces and media. */
#include "report/scene.h"

#include "base/file.h"
#include "base/log.h"
#include "world/stage_build.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define WHAT_SIZE (FILE_NAME_MAX + 64) /* of a sentence that names a file */

#define SENSORS_MAX    2000 /* that are drawn: 1 MB of the page */
#define FILE_NAME_MAX  (MURK_SCENE_NAME_SIZE + 16) /* "plan-NAME.ply" */
#define BYTES_A_PHOTON 7       /* in a page, without the bits of sensors */
#define PHOTON_BYTES   1000000 /* of all photons in a page */
#define BITS_MAX_BYTES 4       /* for the first 32 sensors */
#define FARTHEST_M     1e12    /* limit on coordinates of places */

/* ---- the note ---- */

void murk_report_scene_note(murk_report_scene *s, const char *what,
                            const murk_error *why)
{
    const size_t length = strlen(s->note);
    snprintf(s->note + length, sizeof s->note - length, "%s%s (%.200s).",
             length > 0 ? " " : "", what, why->text);
}

bool murk_is_shown(murk_vec3 place)
{
    return fabs(place.x) <= FARTHEST_M && fabs(place.y) <= FARTHEST_M &&
           fabs(place.z) <= FARTHEST_M;
}

/* ---- sensors ---- */

static murk_vec3 vector_at(const murk_yaml *root, const char *key)
{
    double v[3] = {NAN, NAN, NAN};
    const murk_yaml *list = murk_result_at(root, key);
    for (size_t k = 0; list && list->kind == MURK_YAML_LIST && k < 3; ++k) {
        v[k] = k < list->n ? murk_result_number(list->child[k], "") : NAN;
    }
    return murk_vec(v[0], v[1], v[2]);
}

/* The place relative to the local origin of the scene, as the page draws it.
 * Where the page prints coordinates, it adds the origin. */
static murk_vec3 local_of(const murk_scene_desc *scene, murk_vec3 place)
{
    return scene ? murk_scene_local(scene, place) : place;
}

static const murk_scene_sensor_type *type_of(const murk_scene_desc *scene,
                                             const char *name)
{
    for (size_t i = 0; scene && i < scene->sensors.types; ++i) {
        if (strcmp(scene->sensors.type[i].name, name) == 0) {
            return &scene->sensors.type[i];
        }
    }
    return NULL;
}

murk_status murk_report_read_sensors(murk_shown_sensor **out, size_t *n,
                                     const murk_scene_desc *scene,
                                     const murk_yaml *list, murk_error *err)
{
    const size_t asked = list && list->kind == MURK_YAML_LIST ? list->n : 0;
    murk_shown_sensor *sensor = calloc(asked + 1, sizeof *sensor);
    if (!sensor) {
        return murk_no_memory(err, "", "for the sensors");
    }
    /* sensors that have a place */
    *n = 0;
    for (size_t i = 0; i < asked && *n < SENSORS_MAX; ++i) {
        const murk_yaml *item = list->child[i];
        const char *type = murk_result_text(item, "type");
        const murk_shown_sensor one = {
            .place = local_of(scene, vector_at(item, "position_m")),
            .heading_deg = murk_result_number(item, "heading_deg"),
            .tilt_deg = murk_result_number(item, "tilt_deg"),
            .type = type ? type : "",
            .of = type_of(scene, type ? type : ""),
            .covers = murk_result_number(item, "covers"),
            .only = murk_result_number(item, "only_it_covers")};
        if (murk_is_shown(one.place)) {
            sensor[(*n)++] = one;
        }
    }
    *out = sensor;
    return MURK_OK;
}

/* ---- photons ---- */

/* Limit on photons of one state, so that those of all states fit into the
 * page. */
static size_t photons_of_a_state(const murk_report_scene *s)
{
    const size_t sensors = s->state[0].sensors;
    const size_t bits =
        sensors < 8 * BITS_MAX_BYTES ? (sensors + 7) / 8 : BITS_MAX_BYTES;
    const size_t max = PHOTON_BYTES / (BYTES_A_PHOTON + bits);
    return (max < MURK_REPORT_PHOTONS_MAX ? max : MURK_REPORT_PHOTONS_MAX) /
           s->states;
}

static void read_points(murk_report_scene *out, size_t state,
                        const char *folder, const char *name)
{
    murk_error why = {0};
    murk_plan_points *points = &out->state[state].points;
    const size_t max = photons_of_a_state(out);
    char *path = murk_results_path(folder, name);
    const bool is_light = strcmp(name, "light.murk") == 0;
    if (path && (is_light ? murk_plan_points_of_light(points, path, max, &why)
                          : murk_plan_points_read(points, path, out->scene, max,
                                                  &why))) {
        char what[WHAT_SIZE];
        snprintf(what, sizeof what,
                 "%s cannot be read, so photons are not shown", name);
        murk_report_scene_note(out, what, &why);
        murk_plan_points_release(points);
    }
    free(path);
}

/* Makes a state for each condition of a plan over conditions, as long as there
 * are states. */
static void name_conditions(murk_report_scene *out, const murk_yaml *plan)
{
    const murk_yaml *list = murk_result_at(plan, "conditions");
    const size_t n = murk_result_count(plan, "conditions");
    for (size_t i = 0; i < n; ++i) {
        const char *name = murk_result_text(list->child[i], "name");
        if (name && out->states < MURK_SHOWN_STATES_MAX) {
            snprintf(out->state[out->states++].name, sizeof out->state->name,
                     "%.*s", (int)sizeof out->state->name - 1, name);
        }
    }
    out->states_asked = n;
}

static void read_photons(murk_report_scene *out, const char *folder,
                         const murk_results_in *results)
{
    const bool has_plan = results->json[MURK_RESULT_PLAN] != NULL;
    const bool is_sensed = results->json[MURK_RESULT_COVERAGE] != NULL;
    if (has_plan && out->state[0].name[0]) {
        for (size_t i = 0; i < out->states; ++i) {
            char name[FILE_NAME_MAX];
            snprintf(name, sizeof name, "plan-%.*s.ply", MURK_SCENE_NAME_SIZE,
                     out->state[i].name);
            read_points(out, i, folder, name);
        }
    } else if (has_plan || is_sensed) {
        read_points(out, 0, folder, has_plan ? "plan.ply" : "coverage.ply");
    } else if (out->is_follow) {
        for (size_t i = 0; i < out->states && out->state[i].folder; ++i) {
            read_points(out, i, out->state[i].folder, "plan.ply");
        }
    } else if (results->json[MURK_RESULT_LEDGER]) {
        read_points(out, 0, folder, "light.murk");
    }
}

/* ---- all of it ---- */

/* Reads the sensors of a plan. Each state has its own copy of the list. */
static murk_status read_plan(murk_report_scene *out, const murk_yaml *plan,
                             murk_error *err)
{
    murk_status status = MURK_OK;
    name_conditions(out, plan);
    out->states = out->states > 0 ? out->states : 1;
    for (size_t i = 0; i < out->states && !status; ++i) {
        murk_shown_state *state = &out->state[i];
        status = murk_report_read_sensors(&state->sensor, &state->sensors,
                                          out->scene,
                                          murk_result_at(plan, "sensors"), err);
    }
    return status;
}

static murk_status read_all(murk_report_scene *out,
                            const murk_results_in *results, murk_error *err)
{
    const murk_yaml *made = results->json[MURK_RESULT_PLAN];
    const murk_yaml *plan = made ? made : results->json[MURK_RESULT_COVERAGE];
    const murk_yaml *study = results->json[MURK_RESULT_STUDY];
    const murk_yaml *follow = results->json[MURK_RESULT_FOLLOW];
    murk_status status = MURK_OK;
    /* the scene first, because its origin and sensor types are needed below */
    out->scene = results->scene;
    if (!out->scene) {
        murk_report_scene_note(
            out,
            "the resolved scene cannot be read again, so surfaces, "
            "ranges and media are not shown",
            &results->no_scene);
    }
    if (plan) {
        status = read_plan(out, plan, err);
    } else if (study) {
        out->is_study = true;
        status = murk_report_read_study(out, study, err);
    } else if (follow) {
        out->is_follow = true;
        status = murk_report_read_follow(out, results->folder, follow, err);
    }
    out->states = out->states > 0 ? out->states : 1;
    if (!status && murk_results_has_readings(results)) {
        status = murk_report_read_fit(out, results->folder, err);
    }
    if (!status && made) {
        status = murk_report_read_path(out, results->folder, err);
    }
    if (out->scene) {
        murk_report_build(out);
    }
    read_photons(out, results->folder, results);
    return status;
}

murk_status murk_report_scene_read(murk_report_scene *out,
                                   const murk_results_in *results,
                                   murk_error *err)
{
    *out = (murk_report_scene){0};
    const murk_warn_sink sink = murk_warn_to(NULL); /* the run has printed the
                                                       warnings */
    const murk_status status = read_all(out, results, err);
    murk_warn_to(sink);
    return status;
}

void murk_report_scene_release(murk_report_scene *scene)
{
    for (size_t i = 0; i < MURK_SHOWN_STATES_MAX; ++i) {
        murk_media_destroy(scene->state[i].media);
        murk_phases_destroy(scene->state[i].phases);
        murk_fillings_destroy(scene->state[i].fillings);
        murk_plan_points_release(&scene->state[i].points);
        free(scene->state[i].sensor);
        free(scene->state[i].folder);
        murk_scene_desc_destroy(scene->state[i].scene);
    }
    murk_stage_destroy(scene->stage);
    free(scene->stop);
    free(scene->reading);
    murk_table_destroy(scene->fit);
    *scene = (murk_report_scene){0};
}

bool murk_report_has_view(const murk_report_scene *scene)
{
    const murk_shown_state *first = &scene->state[0];
    return scene->stage ||
           first->points.n + first->sensors + scene->readings > 0;
}
