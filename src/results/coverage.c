#include "results/coverage.h"

#include "plan/few_photons.h"
#include "results/summary.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Each byte may be a quote; two quotes stand around; and the end. */
#define QUOTED_SIZE (2 * MURK_SCENE_NAME_SIZE + 3)

#define CSV_LINE_MAX 512
#define HEADING_SIZE 256

void murk_json_photons(cJSON *root, const murk_traced *traced)
{
    cJSON *object = cJSON_AddObjectToObject(root, "photons");
    cJSON_AddNumberToObject(object, "emitted", (double)traced->emitted);
    cJSON_AddNumberToObject(object, "surface",
                            (double)murk_photon_map_count(traced->surface));
    cJSON_AddNumberToObject(object, "volume",
                            (double)murk_photon_map_count(traced->volume));
}

/* As it was asked for: turning to radians and back leaves rounding behind. */
static double degrees(double rad)
{
    return round(rad * (180 / MURK_PI) * 1e9) / 1e9;
}

static bool is_all_round(const murk_scene_desc *scene, const murk_pose *sensor)
{
    return scene->sensors.type[sensor->type].view == MURK_SCENE_VIEW_SPHERE;
}

void murk_json_heading(cJSON *object, const murk_scene_desc *scene,
                       const murk_pose *pose)
{
    const bool has_axis = !is_all_round(scene, pose);
    murk_json_number(object, "heading_deg",
                     has_axis ? degrees(pose->heading_rad) : NAN);
    murk_json_number(object, "tilt_deg",
                     has_axis ? degrees(pose->tilt_rad) : NAN);
}

/* Sensors that see all round have no heading, and an axis only by convention:
 * up. */
void murk_json_sensors(cJSON *root, const murk_scene_desc *scene,
                       const murk_pose *sensor, size_t n,
                       const murk_coverage_result *coverage)
{
    cJSON *list = cJSON_AddArrayToObject(root, "sensors");
    for (size_t i = 0; i < n; ++i) {
        const bool has_axis = !is_all_round(scene, &sensor[i]);
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "type",
                                scene->sensors.type[sensor[i].type].name);
        murk_json_vector(item, "position_m",
                         murk_scene_user(scene, sensor[i].position));
        murk_json_vector(item, "axis",
                         has_axis
                             ? murk_pose_frame(&sensor[i], scene->north).axis
                             : murk_vec(0, 0, 1));
        murk_json_heading(item, scene, &sensor[i]);
        murk_json_number(item, "covers", coverage->covers[i]);
        murk_json_number(item, "only_it_covers", coverage->only_it_covers[i]);
        cJSON_AddItemToArray(list, item);
    }
}

void murk_json_seen(cJSON *root, const murk_coverage_result *coverage, size_t n)
{
    cJSON *list = cJSON_AddArrayToObject(root, "seen_by_at_least");
    for (size_t i = 0; i < n; ++i) {
        const double seen = coverage->seen_by_at_least[i];
        cJSON_AddItemToArray(list, isfinite(seen) ? cJSON_CreateNumber(seen)
                                                  : cJSON_CreateNull());
    }
}

void murk_json_weights(cJSON *root, const murk_scene_desc *scene,
                       const murk_coverage_result *coverage)
{
    static const char *const name[] = {"surface", "volume"};
    const int thin = murk_thin_map(scene, coverage);
    cJSON *object = cJSON_AddObjectToObject(root, "weights_used");
    for (int p = 0; p < 2; ++p) {
        murk_json_number(object, name[p], coverage->map[p].weight);
    }
    if (thin < 0) {
        cJSON_AddNullToObject(root, "thin_map");
        return;
    }
    object = cJSON_AddObjectToObject(root, "thin_map");
    cJSON_AddStringToObject(object, "map", name[thin]);
    cJSON_AddNumberToObject(object, "photons",
                            (double)coverage->map[thin].photons);
    murk_json_number(object, "weight", coverage->map[thin].weight);
    murk_json_number(object, "standard_error",
                     coverage->map[thin].standard_error);
    murk_json_number(object, "variance_share",
                     murk_map_variance_share(coverage, thin));
}

void murk_number_text(char out[32], double value)
{
    for (int digits = 6; digits <= 17; ++digits) {
        snprintf(out, 32, "%.*g", digits, value);
        if (strtod(out, NULL) == value) {
            return;
        }
    }
}

/* A text as one CSV cell: quoted where it must be (RFC 4180). */
static void quote(char out[QUOTED_SIZE], const char *text)
{
    if (!strpbrk(text, ",\"\r\n")) {
        strcpy(out, text);
        return;
    }
    *out++ = '"';
    for (; *text; ++text) {
        if (*text == '"') {
            *out++ = '"';
        }
        *out++ = *text;
    }
    *out++ = '"';
    *out = '\0';
}

void murk_write_pose(FILE *to, size_t number, const murk_scene_desc *scene,
                     const murk_pose *pose)
{
    const murk_vec3 p = murk_scene_user(scene, pose->position);
    char type[QUOTED_SIZE];
    char x[32], y[32], z[32], heading[32] = "", tilt[32] = "";
    quote(type, scene->sensors.type[pose->type].name);
    murk_number_text(x, p.x);
    murk_number_text(y, p.y);
    murk_number_text(z, p.z);
    if (!is_all_round(scene, pose)) {
        murk_number_text(heading, degrees(pose->heading_rad));
        murk_number_text(tilt, degrees(pose->tilt_rad));
    }
    fprintf(to, "%zu,%s,%s,%s,%s,%s,%s", number, x, y, z, type, heading, tilt);
}

/* Empty where there is nothing to see. */
static void write_share(char out[32], double share)
{
    out[0] = '\0';
    if (isfinite(share)) {
        murk_number_text(out, share);
    }
}

static murk_status add_csv(murk_results *results, const char *name,
                           const char *header, const murk_scene_desc *scene,
                           const murk_pose *sensor, size_t n,
                           const murk_coverage_result *coverage,
                           murk_error *err)
{
    if (!results->folder) {
        return MURK_OK;
    }
    const size_t room = strlen(header) + n * CSV_LINE_MAX + 1;
    char *text = malloc(room);
    size_t at = 0;
    if (text) {
        at = (size_t)snprintf(text, room, "%s", header);
    }
    for (size_t i = 0; text && i < n; ++i) {
        const murk_vec3 p = murk_scene_user(scene, sensor[i].position);
        char type[QUOTED_SIZE];
        char x[32], y[32], z[32], covers[32], only[32];
        char heading[32] = "", tilt[32] = "";
        quote(type, scene->sensors.type[sensor[i].type].name);
        murk_number_text(x, p.x);
        murk_number_text(y, p.y);
        murk_number_text(z, p.z);
        if (!is_all_round(scene, &sensor[i])) {
            murk_number_text(heading, degrees(sensor[i].heading_rad));
            murk_number_text(tilt, degrees(sensor[i].tilt_rad));
        }
        if (coverage) {
            write_share(covers, coverage->covers[i]);
            write_share(only, coverage->only_it_covers[i]);
            at += (size_t)snprintf(text + at, room - at,
                                   "%zu,%s,%s,%s,%s,%s,%s\n", i + 1, type, x, y,
                                   z, covers, only);
        } else {
            at += (size_t)snprintf(text + at, room - at, "%s,%s,%s,%s,%s,%s\n",
                                   type, x, y, z, heading, tilt);
        }
    }
    const murk_status status = murk_results_add_text(results, name, text, err);
    free(text);
    return status;
}

murk_status murk_add_sensors_csv(murk_results *results,
                                 const murk_scene_desc *scene,
                                 const murk_pose *sensor, size_t n,
                                 murk_error *err)
{
    return add_csv(results, "sensors.csv",
                   "type,x_m,y_m,z_m,heading_deg,tilt_deg\n", scene, sensor, n,
                   NULL, err);
}

murk_status murk_add_coverage_csv(murk_results *results,
                                  const murk_scene_desc *scene,
                                  const murk_pose *sensor, size_t n,
                                  const murk_coverage_result *coverage,
                                  murk_error *err)
{
    return add_csv(results, "coverage.csv",
                   "sensor,type,x_m,y_m,z_m,covers,only_it_covers\n", scene,
                   sensor, n, coverage, err);
}

static void show_share(char out[16], double share)
{
    if (isfinite(share)) {
        snprintf(out, 16, "%.4f", share);
    } else {
        strcpy(out, "-");
    }
}

/* Widths of the table of sensors. */
typedef struct columns {
    int type, place[3], decimals;
} columns;

/* Writes the table's heading. Returns how wide it is. */
static int print_heading(char heading[HEADING_SIZE], const columns *c)
{
    return snprintf(heading, HEADING_SIZE,
                    "sensors     %-*s %*s %*s %*s %7s %5s %8s %8s", c->type,
                    "type", c->place[0], "x m", c->place[1], "y m", c->place[2],
                    "z m", "heading", "tilt", "covers", "only it");
}

static int widest_coordinate(const murk_scene_desc *scene,
                             const murk_pose *sensor, size_t n, int axis,
                             int decimals)
{
    int widest = 0;
    for (size_t i = 0; i < n; ++i) {
        const murk_vec3 p = murk_scene_user(scene, sensor[i].position);
        const double x[3] = {p.x, p.y, p.z};
        const int width = snprintf(NULL, 0, "%.*f", decimals, x[axis]);
        widest = width > widest ? width : widest;
    }
    return widest;
}

static columns columns_of(const murk_scene_desc *scene, const murk_pose *sensor,
                          size_t n, int decimals, int min)
{
    columns c = {.decimals = decimals, .type = min < 4 ? 4 : min};
    for (size_t i = 0; i < n; ++i) {
        const int length =
            (int)strlen(scene->sensors.type[sensor[i].type].name);
        c.type = length > c.type ? length : c.type;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int width = widest_coordinate(scene, sensor, n, axis, decimals);
        c.place[axis] = width > min ? width : min;
    }
    return c;
}

/* Columns of 8 where these are enough. Else, as for surveyed coordinates, as
 * wide as what they hold, and coordinates with fewer decimals where the line
 * would not fit: sensors.csv has all of them. */
static columns choose_columns(const murk_scene_desc *scene,
                              const murk_pose *sensor, size_t n)
{
    char heading[HEADING_SIZE];
    columns c = columns_of(scene, sensor, n, 3, 8);
    for (int decimals = 3; print_heading(heading, &c) > 80 && decimals >= 0;
         --decimals) {
        c = columns_of(scene, sensor, n, decimals, 3);
    }
    return c;
}

void murk_print_sensors(const murk_scene_desc *scene, const murk_pose *sensor,
                        size_t n, const murk_coverage_result *coverage,
                        const char *folder)
{
    const size_t shown = n < MURK_PRINTED_ROWS ? n : MURK_PRINTED_ROWS;
    const columns c = choose_columns(scene, sensor, shown);
    char heading[HEADING_SIZE];
    print_heading(heading, &c);
    murk_print("%s\n", heading);
    for (size_t i = 0; i < shown; ++i) {
        const murk_vec3 p = murk_scene_user(scene, sensor[i].position);
        char way[20] = "all round";
        if (!is_all_round(scene, &sensor[i])) {
            snprintf(way, sizeof way, "%7.1f %5.1f",
                     degrees(sensor[i].heading_rad),
                     degrees(sensor[i].tilt_rad));
        }
        char covers[16], only[16];
        show_share(covers, coverage->covers[i]);
        show_share(only, coverage->only_it_covers[i]);
        murk_print("%10zu  %-*s %*.*f %*.*f %*.*f %13s %8s %8s\n", i + 1,
                   c.type, scene->sensors.type[sensor[i].type].name, c.place[0],
                   c.decimals, p.x, c.place[1], c.decimals, p.y, c.place[2],
                   c.decimals, p.z, way, covers, only);
    }
    murk_print_more(n, folder, "coverage.csv");
}

static void print_map(const char *name, murk_estimate fraction)
{
    if (!isfinite(fraction.value)) {
        murk_print("nothing in the %s map", name);
    } else if (!isfinite(fraction.standard_error)) {
        murk_print("%s %.4f", name, fraction.value);
    } else {
        murk_print("%s %.4f +- %.4f", name, fraction.value,
                   fraction.standard_error);
    }
}

void murk_print_maps(const murk_coverage_result *coverage)
{
    print_map("surface", coverage->surface);
    murk_print(", ");
    print_map("volume", coverage->volume);
}

void murk_print_weights(const murk_scene_desc *scene,
                        const murk_coverage_result *coverage)
{
    const murk_map_share *s = &coverage->map[0], *v = &coverage->map[1];
    if (!(s->weight > 0 && v->weight > 0)) {
        return;
    }
    const char *what = scene->placement.targets.given ? "targets" : "photons";
    if (scene->placement.balanced) {
        murk_print("weights     balanced: coverage is the mean of what is seen "
                   "of %zu surface %s and of %zu volume %s\n",
                   s->photons, what, v->photons, what);
    } else {
        murk_print("weights     %.4g of the coverage is of %zu surface %s, "
                   "%.4g of %zu volume %s\n",
                   s->weight, s->photons, what, v->weight, v->photons, what);
    }
}

void murk_print_estimate(murk_estimate of)
{
    if (!isfinite(of.value)) {
        murk_print("not known: that map is empty");
    } else if (!isfinite(of.standard_error)) {
        murk_print("%.4f, error not known: one photon alone", of.value);
    } else {
        murk_print("%.4f +- %.4f", of.value, of.standard_error);
    }
}
