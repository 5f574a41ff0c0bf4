#include "app/report_scene.h"

#include "base/log.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SENSORS_MAX 2000 /* that are drawn */

/* ---- the note ---- */

static void note(murk_report_scene *s, const murk_error *why, const char *what)
{
    const size_t length = strlen(s->note);
    snprintf(s->note + length, sizeof s->note - length, "%s%s (%.200s)",
             length > 0 ? " " : "", what, why->text);
}

/* ---- reading ---- */

static murk_vec3 vector_at(const murk_yaml *root, const char *key)
{
    double v[3] = {NAN, NAN, NAN};
    const murk_yaml *list = murk_result_at(root, key);
    for (size_t k = 0; list && list->kind == MURK_YAML_LIST && k < 3; ++k) {
        v[k] = k < list->n ? murk_result_number(list->child[k], "") : NAN;
    }
    return murk_vec(v[0], v[1], v[2]);
}

static const murk_scene_sensor_type *type_of(const murk_scene *scene,
                                             const char *name)
{
    for (size_t i = 0; scene && i < scene->sensors.types; ++i) {
        if (strcmp(scene->sensors.type[i].name, name) == 0) {
            return &scene->sensors.type[i];
        }
    }
    return NULL;
}

static murk_status read_sensors(murk_report_scene *out, const murk_yaml *plan,
                                murk_error *err)
{
    const size_t n = murk_result_count(plan, "sensors");
    const murk_yaml *list = murk_result_at(plan, "sensors");
    out->sensor = calloc(n + 1, sizeof *out->sensor);
    if (!out->sensor) {
        return murk_fail(err, MURK_NO_MEMORY, "", "no memory for the sensors");
    }
    for (size_t i = 0; i < n && i < SENSORS_MAX; ++i) {
        const murk_yaml *item = list->child[i];
        const char *type = murk_result_text(item, "type");
        const murk_shown_sensor sensor = {
            .place = vector_at(item, "position_m"),
            .heading_deg = murk_result_number(item, "heading_deg"),
            .tilt_deg = murk_result_number(item, "tilt_deg"),
            .type = type ? type : "",
            .of = type_of(out->scene, type ? type : ""),
            .covers = murk_result_number(item, "covers"),
            .only = murk_result_number(item, "only_it_covers")};
        if (murk_is_finite(sensor.place)) {
            out->sensor[out->sensors++] = sensor;
        }
    }
    return MURK_OK;
}

/* plan.ply; or that of the first condition. */
static char *points_path(const char *folder, const murk_yaml *plan)
{
    char name[160] = "plan.ply";
    if (!murk_results_has(folder, name) &&
        murk_result_count(plan, "conditions") > 0) {
        const murk_yaml *list = murk_result_at(plan, "conditions");
        const char *condition = murk_result_text(list->child[0], "name");
        snprintf(name, sizeof name, "plan-%.100s.ply",
                 condition ? condition : "");
    }
    return murk_results_has(folder, name) ? murk_results_path(folder, name)
                                          : NULL;
}

murk_status murk_report_scene_read(murk_report_scene *out,
                                   const murk_results_in *results,
                                   murk_error *err)
{
    *out = (murk_report_scene){0};
    const murk_yaml *made = results->json[MURK_RESULT_PLAN];
    const murk_yaml *plan = made ? made : results->json[MURK_RESULT_COVERAGE];
    murk_error why = {0};
    const murk_warn_sink told = murk_warn_to(NULL); /* by the run */
    if (plan && murk_results_has(results->folder, "scene.yaml")) {
        char *path = murk_results_path(results->folder, "scene.yaml");
        if (path && murk_scene_read(&out->scene, path, NULL, 0, &why)) {
            note(out, &why,
                 "scene.yaml cannot be read again, so ranges and surfaces are "
                 "not shown");
        } else if (path && murk_stage_create(&out->stage, out->scene, &why)) {
            note(out, &why,
                 "What the scene names cannot be read again, so surfaces and "
                 "media are not shown");
        }
        free(path);
    }
    murk_warn_to(told);
    if (!plan) {
        return MURK_OK;
    }
    const murk_status status = read_sensors(out, plan, err);
    char *path = points_path(results->folder, plan);
    why = (murk_error){0};
    if (!status && path &&
        murk_plan_points_read(&out->points, path, MURK_REPORT_PHOTONS_MAX,
                              &why)) {
        note(out, &why, "plan.ply cannot be read, so photons are not shown");
        murk_plan_points_release(&out->points);
    }
    free(path);
    return status;
}

void murk_report_scene_release(murk_report_scene *scene)
{
    murk_stage_destroy(scene->stage);
    murk_scene_destroy(scene->scene);
    murk_plan_points_release(&scene->points);
    free(scene->sensor);
    *scene = (murk_report_scene){0};
}
