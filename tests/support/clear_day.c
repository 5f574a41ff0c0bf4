/* Reads a day of SURFRAD minutes, computes the position of the sun for each,
 * and finds by ternary search the one Linke turbidity at which the clear-sky
 * model fits global and direct irradiance best. */
#include "clear_day.h"

#include "base/calendar.h"
#include "source/clear_sky.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define MIN_LINKE 1.0
#define MAX_LINKE 10.0

/* a line holds the means of the minute that ends at its time */
#define MIDDLE_S 30.0

typedef struct line {
    int year, of_year, month, day, hour, minute;
    double hours, zenith, global, up, direct, diffuse;
    int global_flag, up_flag, direct_flag, diffuse_flag;
} line;

static bool read_line(const char *text, line *l)
{
    return sscanf(text, "%d %d %d %d %d %d %lf %lf %lf %d %lf %d %lf %d %lf %d",
                  &l->year, &l->of_year, &l->month, &l->day, &l->hour,
                  &l->minute, &l->hours, &l->zenith, &l->global,
                  &l->global_flag, &l->up, &l->up_flag, &l->direct,
                  &l->direct_flag, &l->diffuse, &l->diffuse_flag) == 16 &&
           l->global_flag == 0 && l->direct_flag == 0 && l->diffuse_flag == 0;
}

static void add_minute(clear_day *day, const line *l, double clock_error_s)
{
    const murk_date date = {l->year, l->month, l->day};
    const double seconds = 86400 * murk_date_days(date) + 3600.0 * l->hour +
                           60.0 * l->minute - MIDDLE_S + clock_error_s;
    murk_body sun;
    if (murk_sun_at(&sun, &day->observer, murk_julian_date(seconds), NULL) ||
        !(sun.elevation_deg > 0)) {
        return;
    }
    const double zenith = 90 - sun.elevation_deg;
    day->minute[day->n++] = (clear_minute){
        .global = l->global,
        .direct = l->direct,
        .diffuse = l->diffuse,
        .stated_zenith_deg = l->zenith,
        .apparent_zenith_deg = zenith,
        .airmass = murk_absolute_airmass(
            zenith, murk_standard_pressure_hpa(day->observer.altitude_m)),
        .outside = murk_extraterrestrial_w_per_m2(sun.distance_m)};
}

bool clear_day_read(clear_day *day, double clock_error_s)
{
    char text[1024];
    FILE *file = fopen(CLEAR_DAY_FILE, "r");
    if (!file) {
        return false;
    }
    double west = 0;
    *day = (clear_day){.n = 0};
    const bool has_head =
        fgets(text, sizeof text, file) && fgets(text, sizeof text, file) &&
        sscanf(text, "%lf %lf %lf", &day->observer.latitude_deg, &west,
               &day->observer.altitude_m) == 3;
    day->observer.longitude_deg = -west;
    line l;
    while (has_head && day->n < 1440 && fgets(text, sizeof text, file)) {
        if (read_line(text, &l)) {
            add_minute(day, &l, clock_error_s);
        }
    }
    fclose(file);
    return has_head;
}

typedef struct pair {
    double model, measured;
} pair;

static pair pair_of(const clear_day *day, size_t i, double linke, int which)
{
    const clear_minute *m = &day->minute[i];
    const murk_clear_sky sky =
        murk_clear_sky_at(m->apparent_zenith_deg, m->airmass, linke,
                          day->observer.altitude_m, m->outside);
    switch (which) {
    case 0:
        return (pair){sky.global_w_per_m2, m->global};
    case 1:
        return (pair){sky.direct_w_per_m2, m->direct};
    default:
        return (pair){sky.diffuse_w_per_m2, m->diffuse};
    }
}

static clear_misfit misfit(const clear_day *day, double linke, int which)
{
    double mean = 0, square = 0, absolute = 0, bias = 0;
    const double n = (double)day->n;
    for (size_t i = 0; i < day->n; ++i) {
        const pair p = pair_of(day, i, linke, which);
        const double off = p.model - p.measured;
        mean += p.measured / n;
        square += off * off / n;
        absolute += fabs(off) / n;
        bias += off / n;
    }
    return (clear_misfit){mean, sqrt(square) / mean, absolute / mean,
                          bias / mean};
}

static double badness(const clear_day *day, double linke)
{
    const double global = misfit(day, linke, 0).rms;
    const double direct = misfit(day, linke, 1).rms;
    return global * global + direct * direct;
}

clear_fit clear_day_fit(const clear_day *day)
{
    double low = MIN_LINKE, high = MAX_LINKE;
    while (high - low > 1e-4) { /* one valley: thirds */
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (badness(day, a) < badness(day, b)) {
            high = b;
        } else {
            low = a;
        }
    }
    const double linke = (low + high) / 2;
    return (clear_fit){linke, misfit(day, linke, 0), misfit(day, linke, 1),
                       misfit(day, linke, 2)};
}
