/* Sensors and coverage: fields of JSON, columns of CSV, and lines of the
 * summary. */
#include "results/coverage.h"

#include "plan/few_photons.h"
#include "results/summary.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define HEADING_SIZE 256 /* of a line of the table */

/* ---- rows ---- */

void murk_results_list_photons(murk_results_fields *f, const void *of)
{
    const murk_traced *traced = of;
    MURK_COUNT(f, "emitted", "emitted photons", traced->emitted);
    MURK_COUNT(f, "surface", "stored in the surface map",
               murk_photon_map_count(traced->surface));
    MURK_COUNT(f, "volume", "stored in the volume map",
               murk_photon_map_count(traced->volume));
}

double murk_degrees(double rad)
{
    return round(rad * (180 / MURK_PI) * 1e9) / 1e9;
}

static bool is_all_round(const murk_scene_desc *scene, const murk_pose *sensor)
{
    return scene->sensors.type[sensor->type].view == MURK_VIEW_SPHERE;
}

void murk_results_list_type(murk_results_fields *f, murk_posed p)
{
    MURK_TEXT(f, "type", "name of the sensor type",
              p.scene->sensors.type[p.pose->type].name);
}

void murk_results_list_position(murk_results_fields *f, murk_posed p)
{
    if (murk_results_is_csv(f)) {
        MURK_NUMBER(f, "x_m", "m", "position",
                    murk_scene_user(p.scene, p.pose->position).x);
        MURK_NUMBER(f, "y_m", "m", "position",
                    murk_scene_user(p.scene, p.pose->position).y);
        MURK_NUMBER(f, "z_m", "m", "position",
                    murk_scene_user(p.scene, p.pose->position).z);
    } else {
        MURK_VECTOR(f, "position_m", "m", "position",
                    murk_scene_user(p.scene, p.pose->position));
    }
}

void murk_results_list_heading(murk_results_fields *f, murk_posed p)
{
    MURK_NUMBER(f, "heading_deg", "degrees",
                "clockwise from north; none of a sensor that sees all round",
                is_all_round(p.scene, p.pose)
                    ? NAN
                    : murk_degrees(p.pose->heading_rad));
    MURK_NUMBER(f, "tilt_deg", "degrees", "up from the horizon",
                is_all_round(p.scene, p.pose) ? NAN
                                              : murk_degrees(p.pose->tilt_rad));
}

/* Sensors that see all round have an axis only by convention: up. */
static murk_vec3 axis_of(murk_posed p)
{
    return is_all_round(p.scene, p.pose)
               ? murk_vec(0, 0, 1)
               : murk_pose_frame(p.pose, p.scene->north).axis;
}

static murk_posed posed_of(const murk_sensor_results *s, size_t i)
{
    return s ? (murk_posed){s->scene, &s->pose[i]} : (murk_posed){NULL, NULL};
}

/* sensors[] of plan.json and coverage.json, and coverage.csv. */
void murk_results_list_sensor(murk_results_fields *f, const void *of, size_t i)
{
    const murk_sensor_results *s = of;
    const murk_posed p = posed_of(s, i);
    if (murk_results_is_csv(f)) {
        MURK_COUNT(f, "sensor", "number, from 1", i + 1);
    }
    murk_results_list_type(f, p);
    murk_results_list_position(f, p);
    if (!murk_results_is_csv(f)) {
        MURK_VECTOR(f, "axis", "", "unit vector of the view", axis_of(p));
        murk_results_list_heading(f, p);
    }
    MURK_NUMBER(f, "covers", "1", "share that the sensor covers alone",
                s->coverage->covers[i]);
    MURK_NUMBER(f, "only_it_covers", "1",
                "share that is lost without the sensor",
                s->coverage->only_it_covers[i]);
}

/* sensors.csv, which sense reads. */
void murk_results_list_place(murk_results_fields *f, const void *of, size_t i)
{
    const murk_posed p = posed_of(of, i);
    murk_results_list_type(f, p);
    murk_results_list_position(f, p);
    murk_results_list_heading(f, p);
}

void murk_results_list_sensors(murk_results_fields *f, const void *of)
{
    const murk_sensor_results *s = of;
    MURK_LIST(f, "sensors", "the sensors", murk_results_list_sensor, s, s->n);
}

static const char *const map_name[] = {"surface", "volume"};

static void list_weights(murk_results_fields *f, const void *of)
{
    const murk_coverage_result *coverage = of;
    for (int p = 0; p < 2; ++p) {
        MURK_NUMBER(f, map_name[p], "1",
                    "weight of the map's own coverage in the total",
                    coverage->map[p].weight);
    }
}

/* The map whose part of the coverage rests on few photons
 * (plan/few_photons.h). */
static void list_thin_map(murk_results_fields *f, const void *of)
{
    const murk_sensor_results *s = of;
    const int thin = s ? murk_thin_map(s->scene, s->coverage) : 0;
    const murk_map_share *map = s ? &s->coverage->map[thin] : NULL;
    MURK_TEXT(f, "map", "surface or volume", map_name[thin]);
    MURK_COUNT(f, "photons", "stored in the map", map->photons);
    MURK_NUMBER(f, "weight", "1", "the map's share of the coverage",
                map->weight);
    MURK_NUMBER(f, "standard_error", "1",
                "of the coverage, from this map alone", map->standard_error);
    MURK_NUMBER(f, "variance_share", "1", "of the coverage's variance",
                murk_map_variance_share(s->coverage, thin));
}

void murk_results_list_shares(murk_results_fields *f, const void *of)
{
    const murk_sensor_results *s = of;
    MURK_OBJECT(f, "weights_used",
                "weight of each map in the coverage, together 1", list_weights,
                s->coverage);
    MURK_OBJECT(f, "thin_map",
                "null, or the map that has few photons, each of which "
                "weighs much",
                list_thin_map,
                murk_thin_map(s->scene, s->coverage) < 0 ? NULL : s);
    MURK_NUMBERS(f, "seen_by_at_least", "1",
                 "share that at least 1, 2, ... sensors see",
                 s->coverage->seen_by_at_least, s->n);
}

/* ---- the summary ---- */

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

/* Writes the heading of the table of sensors to heading[] and returns the width
 * of the heading. */
static int print_heading(char heading[HEADING_SIZE], const columns *c)
{
    return snprintf(heading, HEADING_SIZE,
                    "sensors     %-*s %*s %*s %*s %7s %5s %8s %8s", c->type,
                    "type", c->place[0], "x m", c->place[1], "y m", c->place[2],
                    "z m", "heading", "tilt", "covers", "only it");
}

static int wider(int width, int other)
{
    return width > other ? width : other;
}

static columns columns_of(const murk_scene_desc *scene, const murk_pose *sensor,
                          size_t n, int decimals, int min)
{
    columns c = {wider(min, 4), {min, min, min}, decimals};
    for (size_t i = 0; i < n; ++i) {
        const murk_vec3 p = murk_scene_user(scene, sensor[i].position);
        const double x[3] = {p.x, p.y, p.z};
        c.type = wider(c.type,
                       (int)strlen(scene->sensors.type[sensor[i].type].name));
        for (int axis = 0; axis < 3; ++axis) {
            c.place[axis] = wider(c.place[axis],
                                  snprintf(NULL, 0, "%.*f", decimals, x[axis]));
        }
    }
    return c;
}

/* The columns of types and coordinates are at least 8 wide if the heading then
 * fits 80 columns. Otherwise they are as wide as their content, and coordinates
 * lose decimals, of which sensors.csv has all, until the heading fits or no
 * decimal is left. */
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

void murk_print_sensors(const murk_sensor_results *sensors, const char *folder)
{
    const murk_scene_desc *scene = sensors->scene;
    const murk_pose *sensor = sensors->pose;
    const murk_coverage_result *coverage = sensors->coverage;
    const size_t n = sensors->n;
    const size_t shown = n < MURK_PRINTED_ROWS ? n : MURK_PRINTED_ROWS;
    const columns c = choose_columns(scene, sensor, shown);
    char heading[HEADING_SIZE];
    print_heading(heading, &c);
    murk_print("%s\n", heading);
    /* A line for each sensor. */
    for (size_t i = 0; i < shown; ++i) {
        const murk_vec3 p = murk_scene_user(scene, sensor[i].position);
        char angles[20] = "all round";
        if (!is_all_round(scene, &sensor[i])) {
            snprintf(angles, sizeof angles, "%7.1f %5.1f",
                     murk_degrees(sensor[i].heading_rad),
                     murk_degrees(sensor[i].tilt_rad));
        }
        char covers[16], only[16];
        show_share(covers, coverage->covers[i]);
        show_share(only, coverage->only_it_covers[i]);
        murk_print("%10zu  %-*s %*.*f %*.*f %*.*f %13s %8s %8s\n", i + 1,
                   c.type, scene->sensors.type[sensor[i].type].name, c.place[0],
                   c.decimals, p.x, c.place[1], c.decimals, p.y, c.place[2],
                   c.decimals, p.z, angles, covers, only);
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
    char thin[MURK_THIN_MAP_SIZE];
    if (murk_thin_map_text(thin, sizeof thin, scene, coverage, NULL)) {
        murk_print("            few photons: %s\n", thin);
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
