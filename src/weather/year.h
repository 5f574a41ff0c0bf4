/* Weather years in the EPW format of EnergyPlus (TMY and other files): a row
 * for each hour, or for each part of an hour.
 *
 * A row has the means over the interval that ends at the hour and minute of the
 * row, in local standard time: hour 1 ends at 01:00. Rows are found by month,
 * day and time of day, because typical years join months of different years.
 *
 * Source: EnergyPlus Auxiliary Programs, EnergyPlus Weather File Data
 * Dictionary (U.S. Department of Energy). */
#ifndef MURK_WEATHER_YEAR_H
#define MURK_WEATHER_YEAR_H

#include "base/calendar.h"
#include "base/status.h"
#include "weather/observation.h"

#include <stddef.h>

/* Largest size of a file: a year of minutes has some 60 to 100 MB. */
#define MURK_WEATHER_BYTES_MAX 110000000

/* A row of the file. */
typedef struct murk_weather_row {
    int year, month, day;
    int ends_min; /* end of the interval, minutes from 00:00, 1..1440 */
    int line;     /* in the file */
    murk_observation seen;
} murk_weather_row;

typedef struct murk_weather_year {
    size_t owners; /* of weather/year.c */
    double latitude_deg, longitude_deg, altitude_m;
    int zone_min;     /* of the local standard time, minutes east of UTC */
    int interval_min; /* length of the interval of a row */
    size_t n;
    murk_weather_row row[]; /* [n], in the order of the file */
} murk_weather_year;

/* Reads a file, or shares what was read of it before, because a study reads one
 * file once for each of its rows. The caller owns *out with others, does not
 * change it, and gives it up with murk_weather_year_release(). Fails with
 * MURK_BAD_FILE, with file and line, or with MURK_NO_MEMORY. */
murk_status murk_weather_year_read(murk_weather_year **out, const char *path,
                                   murk_error *err);
void murk_weather_year_release(murk_weather_year *year); /* NULL is fine */

/* As murk_weather_year_read(), from a text of `size` bytes, which a '\0'
 * follows; the text is changed. `path` is the name in messages. */
murk_status murk_weather_year_parse(murk_weather_year **out, const char *path,
                                    char *text, size_t size, murk_error *err);

/* The row whose interval begins at or before a time and ends after it; of
 * several years the one of that time, else the first in the file. NULL: the
 * file has no row of that month, day and time of day. */
const murk_weather_row *murk_weather_year_at(const murk_weather_year *weather,
                                             double unix_s);

/* The middle of the interval of a row, in seconds since 1970, UTC. */
double murk_weather_row_middle(const murk_weather_year *weather,
                               const murk_weather_row *row);

#endif
