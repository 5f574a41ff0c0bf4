/* Sensors for maps of the earth: sensors.geojson (RFC 7946) and
 * sensors_geo.csv, with longitudes and latitudes. */
#ifndef MURK_RESULTS_GEO_H
#define MURK_RESULTS_GEO_H

#include "results/coverage.h"
#include "results/session.h"

/* Fails with MURK_BAD_VALUE if one of these exports is asked for and the site
 * of the scene has no longitude and latitude. */
murk_status murk_geo_check(const murk_session *session, murk_error *err);

/* Adds those of the two files that are asked for. Fails as murk_results_add().
 */
murk_status murk_geo_add(murk_session *session,
                         const murk_sensor_results *sensors, murk_error *err);

/* Lists the columns of sensors_geo.csv. `of` points to a murk_sensor_results;
 * NULL: the columns are only described. */
void murk_results_list_geo(murk_results_fields *f, const void *of, size_t i);

#endif
