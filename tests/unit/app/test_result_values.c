/* What result files share: power from quanta, numbers that JSON can hold, what
 * is read back from a folder. Expected values are worked out by hand. */
#include "base/file.h"
#include "check.h"
#include "report/results_in.h"
#include "results/catalogue.h"
#include "results/coverage.h"
#include "results/json.h"
#include "results/ledger.h"
#include "stage_text.h"

#include <stdlib.h>
#include <string.h>

#define DEG (MURK_PI / 180)

static const char scene_text[] =
    "murk: 1\n"
    "bands_nm: [450, 600]\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"
    "media: {fog: {extinction_per_m: 0.3, albedo: 0.9}}\n"
    "regions: [{medium: fog}]\n"
    "lights:\n"
    "  - {type: point, position_m: [1, 1, 2.5], power_w: [8, 2]}\n"
    "  - {type: point, position_m: [3, 3, 2.5], power_w: 1}\n"
    "photons: {emit: 500}\n"
    "sensors:\n"
    "  types:\n"
    "    - {name: node, range_m: 2}\n"
    "    - {name: 'a \"b\", c', range_m: 2, view: {cone_deg: 60}}\n"
    "  candidates: {}\n"
    "  count: 1\n";

static double at(const cJSON *root, const char *key, const char *part, int band)
{
    const cJSON *item = cJSON_GetObjectItem(root, key);
    item = item ? cJSON_GetObjectItem(item, part) : NULL;
    item = item && band >= 0 ? cJSON_GetArrayItem(item, band) : item;
    return item ? item->valuedouble : NAN;
}

/* Channels are light * bands + band; a packet of each has its own power. */
static void test_quanta_become_watts(const murk_stage *stage)
{
    murk_error err = {0};
    murk_traced *t = murk_traced_create(stage, 0, &err);
    CHECK(t != NULL && t->channels == 4);
    if (!t || t->channels != 4) {
        return;
    }
    for (size_t c = 0; c < 4; ++c) {
        t->packet_w[c] = (double)(c + 1);
        /* 10 packets emitted, 1 absorbed by fog, 4 escaped, 5 lost */
        murk_tally_add(&t->ledger->emitted[c], 10 * MURK_PACKET);
        murk_tally_add(&t->ledger->absorbed_media[c], MURK_PACKET);
        murk_tally_add(&t->ledger->escaped[c], 4 * MURK_PACKET);
        murk_tally_add(&t->ledger->lost[c], 5 * MURK_PACKET);
    }
    murk_tally_add(&t->ledger->escaped[3], -(MURK_PACKET / 4));
    CHECK_NEAR(murk_ledger_watts(t, t->ledger->emitted), 100, 1e-12);
    CHECK_NEAR(murk_ledger_watts(t, t->ledger->lost), 50, 1e-12);
    murk_tally_add(&t->ledger->photons, 40);
    murk_tally_add(&t->ledger->collisions, 77);
    murk_tally_add(&t->ledger->lost_photons[MURK_LOSS_WRAPS], 3);
    const murk_ledger_results ledger = {t, stage};
    cJSON *root = murk_results_json(murk_results_list_ledger, &ledger);
    CHECK_NEAR(at(root, "emitted_w", "total", -1), 100, 1e-12);
    CHECK_NEAR(at(root, "emitted_w", "bands", 0), 10 * (1 + 3), 1e-12);
    CHECK_NEAR(at(root, "emitted_w", "bands", 1), 10 * (2 + 4), 1e-12);
    CHECK_NEAR(at(root, "absorbed_media_w", "total", -1), 10, 1e-12);
    CHECK_NEAR(at(root, "escaped_w", "bands", 0), 4 * (1 + 3), 1e-12);
    CHECK_NEAR(at(root, "escaped_w", "bands", 1), 4 * (2 + 4) - 1, 1e-12);
    CHECK_NEAR(at(root, "absorbed_surfaces_w", "total", -1), 0, 0);
    CHECK_NEAR(cJSON_GetObjectItem(root, "photons_emitted")->valuedouble, 40,
               0);
    CHECK_NEAR(cJSON_GetObjectItem(root, "collisions")->valuedouble, 77, 0);
    CHECK_NEAR(at(root, "lost", "wraps", -1), 3, 0);
    CHECK_NEAR(at(root, "lost", "events", -1), 0, 0);
    CHECK_NEAR(cJSON_GetObjectItem(root, "imbalance_quanta")->valuedouble,
               (double)(MURK_PACKET / 4), 0);
    cJSON_Delete(root);
    murk_traced_destroy(t);
}

static void test_numbers_that_json_has_not(void)
{
    /* Numbers that are not finite, and empty boxes, become null. */
    cJSON *root = cJSON_CreateObject();
    murk_json_number(root, "nan", NAN);
    murk_json_number(root, "inf", -INFINITY);
    murk_json_number(root, "one", 1);
    CHECK(cJSON_IsNull(cJSON_GetObjectItem(root, "nan")));
    CHECK(cJSON_IsNull(cJSON_GetObjectItem(root, "inf")));
    CHECK(cJSON_IsNumber(cJSON_GetObjectItem(root, "one")));
    const murk_box empty = murk_box_empty(), box = {{1, 2, 3}, {4, 5, 6}};
    murk_json_box(root, "empty", &empty);
    murk_json_box(root, "box", &box);
    CHECK(cJSON_IsNull(cJSON_GetObjectItem(root, "empty")));
    CHECK_NEAR(at(root, "box", "min_m", 2), 3, 0);
    CHECK_NEAR(at(root, "box", "max_m", 0), 4, 0);
    /* The text ends with the facts of the run, and parses as YAML. */
    cJSON *summary = cJSON_CreateArray();
    cJSON_AddItemToArray(summary, cJSON_CreateString("a \"b\""));
    const murk_run_facts run = {
        .threads = 3, .trace_s = 1.5, .total_s = 2, .summary = summary};
    char *text = murk_json_end(root, &run);
    cJSON_Delete(summary);
    CHECK(text != NULL && strchr(text, '\t') == NULL);
    CHECK(text && text[strlen(text) - 1] == '\n');
    murk_yaml *read = NULL;
    CHECK(text && !murk_yaml_parse(&read, text, strlen(text), "x.json", NULL));
    /* Reading gives the numbers, and NaN for null and for missing keys. */
    CHECK_NEAR(murk_result_number(read, "run.threads"), 3, 0);
    CHECK_NEAR(murk_result_number(read, "run.seconds.trace"), 1.5, 0);
    CHECK_NEAR(murk_result_number(read, "run.seconds.total"), 2, 0);
    CHECK_NEAR(murk_result_number(read, "run.seconds.load"), 0, 0);
    CHECK_TEXT(murk_result_at(read, "run.summary")->child[0]->text, "a \"b\"");
    CHECK(isnan(murk_result_number(read, "nan")));
    CHECK(isnan(murk_result_number(read, "run.none")));
    CHECK(isnan(murk_result_number(read, "run")));
    /* Texts, counts and comparisons of missing values. */
    CHECK(murk_result_text(read, "inf") == NULL);
    CHECK(murk_result_count(read, "box.min_m") == 3);
    CHECK(murk_result_count(read, "one") == 0);
    CHECK(murk_result_is(read, "one", "1") && !murk_result_is(read, "one", ""));
    CHECK(!murk_result_is(NULL, "one", "1"));
    murk_yaml_destroy(read);
    cJSON_free(text);
}

static void test_shortest_decimals(void)
{
    static const double values[] = {0.1,  1.0 / 3, 1e300,     123456789,
                                    -2.5, 1e-7,    0.1 + 0.2, 299792458.25};
    char text[32];
    for (size_t i = 0; i < sizeof values / sizeof *values; ++i) {
        murk_number_text(text, values[i]);
        CHECK(strtod(text, NULL) == values[i]);
    }
    murk_number_text(text, 0.1);
    CHECK_TEXT(text, "0.1");
    murk_number_text(text, 0.1 + 0.2);
    CHECK_TEXT(text, "0.30000000000000004");
}

/* A line of poses: cells quoted as RFC 4180 says, angles of what has an axis.
 */
static void test_poses_as_lines(const murk_scene_desc *scene)
{
    const murk_pose pose[] = {{.type = 0, .position = {1, 2.5, 0.1}},
                              {.type = 1,
                               .position = {0, 0, 1},
                               .heading_rad = 350 * DEG,
                               .tilt_rad = -30 * DEG}};
    const murk_sensor_results sensors = {scene, pose, 2, NULL, NULL};
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    murk_results_csv_heading(to, murk_results_list_place);
    murk_results_csv_line(to, murk_results_list_place, &sensors, 0);
    murk_results_csv_line(to, murk_results_list_place, &sensors, 1);
    fclose(to);
    CHECK_TEXT(text, "type,x_m,y_m,z_m,heading_deg,tilt_deg\n"
                     "node,1,2.5,0.1,,\n"
                     "\"a \"\"b\"\", c\",0,0,1,350,-30\n");
    free(text);
}

/* The description walks every table without results. */
static void test_every_field_has_help(void)
{
    char *text = NULL;
    size_t size = 0, rows = 0;
    FILE *to = open_memstream(&text, &size);
    murk_results_catalogue(to);
    fclose(to);
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        CHECK(!strstr(line, "` |  |"));
        rows += strncmp(line, "| `", 3) == 0;
    }
    CHECK(rows > 250);
    free(text);
}

static void test_sensors_in_json(const murk_scene_desc *scene)
{
    const murk_pose pose[] = {{.type = 0, .position = {1, 2, 3}},
                              {.type = 1,
                               .position = {0, 0, 1},
                               .heading_rad = 90 * DEG,
                               .tilt_rad = 0}};
    double covers[] = {.5, .25}, only[] = {.125, NAN}, seen[] = {.75, .25};
    const murk_coverage_result coverage = {
        .covers = covers, .only_it_covers = only, .seen_by_at_least = seen};
    const murk_sensor_results sensors = {scene, pose, 2, &coverage, NULL};
    cJSON *root = murk_results_json(murk_results_list_sensors, &sensors);
    const cJSON *list = cJSON_GetObjectItem(root, "sensors");
    const cJSON *one = cJSON_GetArrayItem(list, 0);
    const cJSON *two = cJSON_GetArrayItem(list, 1);
    CHECK(cJSON_GetArraySize(list) == 2);
    CHECK(cJSON_IsNull(cJSON_GetObjectItem(one, "heading_deg")));
    CHECK_NEAR(cJSON_GetObjectItem(one, "covers")->valuedouble, .5, 0);
    CHECK_NEAR(cJSON_GetObjectItem(one, "only_it_covers")->valuedouble, .125,
               0);
    const cJSON *axis = cJSON_GetObjectItem(one, "axis");
    CHECK_NEAR(cJSON_GetArrayItem(axis, 2)->valuedouble, 1, 0); /* up */
    CHECK_NEAR(cJSON_GetObjectItem(two, "heading_deg")->valuedouble, 90, 0);
    CHECK_NEAR(cJSON_GetObjectItem(two, "tilt_deg")->valuedouble, 0, 0);
    CHECK(cJSON_IsNull(cJSON_GetObjectItem(two, "only_it_covers")));
    axis = cJSON_GetObjectItem(two, "axis"); /* clockwise from north: east */
    CHECK_NEAR(cJSON_GetArrayItem(axis, 0)->valuedouble, 1, 1e-12);
    cJSON_Delete(root);
    root = murk_results_json(murk_results_list_shares, &sensors);
    const cJSON *by = cJSON_GetObjectItem(root, "seen_by_at_least");
    CHECK_NEAR(cJSON_GetArrayItem(by, 1)->valuedouble, .25, 0);
    cJSON_Delete(root);
}

static void test_paths_of_folders(void)
{
    static const char *const folder[] = {"out", "out/"};
    for (size_t i = 0; i < 2; ++i) {
        char *path = murk_path_join(folder[i], "plan.json");
        CHECK_TEXT(path, "out/plan.json");
        free(path);
    }
    CHECK(!murk_results_has("/", "tmp")); /* a folder is no file */
}

int main(void)
{
    murk_stage *stage = stage_text_create(scene_text, NULL);
    CHECK(stage != NULL);
    if (stage) {
        test_quanta_become_watts(stage);
        test_poses_as_lines(stage->scene);
        test_sensors_in_json(stage->scene);
    }
    test_numbers_that_json_has_not();
    test_every_field_has_help();
    test_shortest_decimals();
    test_paths_of_folders();
    stage_text_destroy(stage);
    return check_done();
}
