/* Writes sensors with their longitudes and latitudes (results/geo.h).
 *
 * The files have names of their own, so that sensors.csv and coverage.csv are
 * the same with and without a site. */
#include "results/geo.h"

#include "results/json.h"
#include "scene/ground.h"

#include <cjson/cJSON.h>
#include <math.h>

/* Decimals of degrees: 0.1 mm on the ground. */
#define DEGREE_STEPS 1e9

typedef struct earth_place {
    double longitude_deg, latitude_deg;
    double height_m; /* z plus site.altitude_m */
} earth_place;

/* The place of sensor i, in a scene that has a frame. */
static earth_place place_of(const murk_sensor_results *s, size_t i)
{
    const murk_vec3 at = murk_scene_user(s->scene, s->pose[i].position);
    murk_local_frame frame;
    earth_place p = {NAN, NAN, at.z + s->scene->site.altitude_m};
    if (murk_scene_frame(s->scene, &frame)) {
        murk_geographic_from_local(&frame, (const double[]){at.x, at.y},
                                   &p.latitude_deg, &p.longitude_deg);
        p.latitude_deg =
            nearbyint(p.latitude_deg * DEGREE_STEPS) / DEGREE_STEPS;
        p.longitude_deg =
            nearbyint(p.longitude_deg * DEGREE_STEPS) / DEGREE_STEPS;
    }
    return p;
}

void murk_results_list_geo(murk_results_fields *f, const void *of, size_t i)
{
    const murk_sensor_results *s = of;
    const murk_posed p =
        s ? (murk_posed){s->scene, &s->pose[i]} : (murk_posed){NULL, NULL};
    murk_results_list_type(f, p);
    murk_results_list_position(f, p);
    MURK_NUMBER(f, "longitude_deg", "degrees", "east of Greenwich, WGS84",
                place_of(s, i).longitude_deg);
    MURK_NUMBER(f, "latitude_deg", "degrees", "north of the equator, WGS84",
                place_of(s, i).latitude_deg);
    MURK_NUMBER(f, "height_m", "m", "z plus site.altitude_m",
                place_of(s, i).height_m);
    murk_results_list_heading(f, p);
    MURK_NUMBER(f, "covers", "1", "share that the sensor covers alone",
                s->coverage->covers[i]);
    MURK_NUMBER(f, "only_it_covers", "1",
                "share that is lost without the sensor",
                s->coverage->only_it_covers[i]);
}

/* One sensor of a list, for murk_results_json(). */
typedef struct one_sensor {
    const murk_sensor_results *sensors;
    size_t i;
} one_sensor;

static void list_one(murk_results_fields *f, const void *of)
{
    const one_sensor *one = of;
    murk_results_list_sensor(f, one->sensors, one->i);
}

/* A point with the fields of sensors[i] of plan.json as properties. */
static void add_feature(cJSON *features, const murk_sensor_results *s, size_t i)
{
    const earth_place p = place_of(s, i);
    const double coordinates[] = {p.longitude_deg, p.latitude_deg, p.height_m};
    const one_sensor one = {s, i};
    cJSON *feature = murk_json_item(features);
    cJSON_AddStringToObject(feature, "type", "Feature");
    cJSON_AddNumberToObject(feature, "id", (double)i);
    cJSON *geometry = cJSON_AddObjectToObject(feature, "geometry");
    cJSON_AddStringToObject(geometry, "type", "Point");
    murk_json_numbers(geometry, "coordinates", coordinates, 3);
    cJSON_AddItemToObject(feature, "properties",
                          murk_results_json(list_one, &one));
}

static murk_status add_geojson(murk_session *session,
                               const murk_sensor_results *s, murk_error *err)
{
    cJSON *root = cJSON_CreateObject();
    cJSON_AddStringToObject(root, "type", "FeatureCollection");
    cJSON *features = cJSON_AddArrayToObject(root, "features");
    for (size_t i = 0; i < s->n; ++i) {
        add_feature(features, s, i);
    }
    char *text = cJSON_Print(root);
    cJSON_Delete(root);
    const murk_status status =
        text ? murk_results_add_text(&session->results, "sensors.geojson", text,
                                     err)
             : murk_no_memory(err, "sensors.geojson", "to write it");
    cJSON_free(text);
    return status;
}

murk_status murk_geo_check(const murk_session *session, murk_error *err)
{
    murk_local_frame frame;
    return !(session->settings.exports & MURK_EXPORTS_OF_SENSORS) ||
                   murk_scene_frame(session->scene, &frame)
               ? MURK_OK
               : murk_fail(err, MURK_BAD_VALUE, "exports",
                           "geojson and geo-csv need a place on the earth: "
                           "site.latitude_deg and site.longitude_deg");
}

murk_status murk_geo_add(murk_session *session, const murk_sensor_results *s,
                         murk_error *err)
{
    const unsigned exports = session->settings.exports;
    murk_status status = MURK_OK;
    if (exports & MURK_EXPORT_GEO_CSV) {
        status = murk_results_add_csv(&session->results, "sensors_geo.csv",
                                      murk_results_list_geo, s, s->n, err);
    }
    if (!status && exports & MURK_EXPORT_GEOJSON) {
        status = add_geojson(session, s, err);
    }
    return status;
}
