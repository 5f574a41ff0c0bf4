/* Reads the nights of a sky quality meter, computes moonlight at the zenith
 * for each reading, and finds by ternary search the one level of the dark sky
 * that fits all nights best. */
#include "night_field.h"

#include "base/calendar.h"
#include "check.h"
#include "source/ephemeris.h"
#include "source/moonlight.h"
#include "source/night_sky.h"

#include <glob.h>

#define TURBIDITY 3.0 /* Linke's: clear, the default of a scene's sky */

static void read_line(night_field *f, const murk_observer *at, const char *line,
                      double clock_error_s)
{
    char time[32];
    double magnitude = 0, utc_s = 0;
    bool has_zone;
    int zone;
    /* Time and magnitude of the reading. */
    if (sscanf(line, "%23[^.].%*[^;];%*[^;];%*[^;];%*[^;];%lf", time,
               &magnitude) != 2 ||
        !murk_time_read(time, &utc_s, &has_zone, &zone)) {
        return;
    }
    /* Leave out twilight. */
    const double date = murk_julian_date(utc_s + clock_error_s);
    murk_body sun, body;
    CHECK(murk_sun_at(&sun, at, date, NULL) == MURK_OK);
    if (sun.elevation_deg > NIGHT_FIELD_SUN_DEG ||
        f->n == sizeof f->reading / sizeof *f->reading) {
        return;
    }
    /* Moonlight scattered into the zenith. */
    CHECK(murk_moon_at(&body, at, date, NULL) == MURK_OK);
    const murk_moon moon = {body.phase_angle_deg, body.distance_m,
                            body.elevation_deg};
    const double taken = murk_visual_extinction(TURBIDITY, at->altitude_m);
    f->reading[f->n++] = (night_reading){
        f->nights, magnitude,
        murk_moonlit_sky(&moon, 0, 90 - body.elevation_deg, taken)};
}

static void read_night(night_field *f, const char *path, double clock_error_s)
{
    murk_observer at = {.temperature_c = 10};
    FILE *file = fopen(path, "r");
    char line[512];
    CHECK(file != NULL);
    while (file && fgets(line, sizeof line, file)) {
        if (line[0] != '#') {
            read_line(f, &at, line, clock_error_s);
        } else {
            sscanf(line, "# Position (lat, lon, elev(m)): %lf, %lf, %lf",
                   &at.latitude_deg, &at.longitude_deg, &at.altitude_m);
        }
    }
    if (file) {
        fclose(file);
    }
    CHECK(at.latitude_deg > 52 && at.latitude_deg < 53);
    ++f->nights;
}

bool night_field_read(night_field *f, double clock_error_s)
{
    f->n = f->nights = 0;
    glob_t found = {0};
    const bool is_here = glob(NIGHT_FIELD_FILES, 0, NULL, &found) == 0;
    for (size_t i = 0; is_here && i < found.gl_pathc && i < NIGHT_FIELD_NIGHTS;
         ++i) {
        read_night(f, found.gl_pathv[i], clock_error_s);
    }
    globfree(&found);
    return is_here;
}

static double misfit(const night_field *f, double level_mag)
{
    const double level = murk_sky_luminance(level_mag);
    double sum = 0;
    for (size_t i = 0; i < f->n; ++i) {
        const night_reading *r = &f->reading[i];
        const double d =
            murk_sky_magnitude(level + r->moonlight) - r->measured_mag;
        sum += d * d;
    }
    return sum;
}

/* The free level, to .001 mag: the misfit has one valley. */
static double best_level(const night_field *f)
{
    double low = 17, high = 24;
    while (high - low > 1e-3) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (misfit(f, a) < misfit(f, b)) {
            high = b;
        } else {
            low = a;
        }
    }
    return (low + high) / 2;
}

static double correlation_of(const night_field *f, double level)
{
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (size_t i = 0; i < f->n; ++i) {
        const double a = murk_sky_magnitude(level + f->reading[i].moonlight);
        const double b = f->reading[i].measured_mag;
        x += a, y += b, xx += a * a, yy += b * b, xy += a * b;
    }
    const double n = (double)f->n;
    return (n * xy - x * y) / sqrt((n * xx - x * x) * (n * yy - y * y));
}

/* The nights with the most moonlight, and whether the meter agrees. */
static void order(night_fit *x, size_t nights)
{
    for (size_t i = 0; i < nights; ++i) {
        size_t above = 0;
        for (size_t j = 0; j < nights; ++j) {
            above += x->moonlight[j] > x->moonlight[i];
        }
        if (above < NIGHT_FIELD_MOON) {
            x->by_moonlight[above] = i;
        }
    }
    for (size_t k = 1; k < NIGHT_FIELD_MOON; ++k) {
        x->out_of_order += !(x->measured[x->by_moonlight[k - 1]] >
                             x->measured[x->by_moonlight[k]]);
    }
}

night_fit night_field_fit(const night_field *f)
{
    night_fit out = {.level_mag = best_level(f)};
    const double level = murk_sky_luminance(out.level_mag);
    size_t count[NIGHT_FIELD_NIGHTS] = {0};
    for (size_t i = 0; i < f->n; ++i) {
        const night_reading *r = &f->reading[i];
        out.measured[r->night] += murk_sky_luminance(r->measured_mag);
        out.model[r->night] += level + r->moonlight;
        out.moonlight[r->night] += r->moonlight;
        ++count[r->night];
    }
    for (size_t k = 0; k < f->nights; ++k) {
        const double n = (double)count[k];
        out.measured[k] /= n, out.model[k] /= n, out.moonlight[k] /= n;
    }
    out.correlation = correlation_of(f, level);
    out.rms_mag = sqrt(misfit(f, out.level_mag) / (double)f->n);
    order(&out, f->nights);
    return out;
}
