/* Positions of sun and moon, clear-sky irradiance, the solar spectrum, lux and
 * photon counts, against published values and a measured day. */
#include "am15.h"
#include "base/photometry.h"
#include "base/vector.h"
#include "clear_day.h"
#include "library/library.h"
#include "source/clear_sky.h"
#include "source/ephemeris.h"
#include "source/geocentric.h"
#include "source/solar_spectrum.h"

#define DEG            (180 / MURK_PI)
#define ASTRONOMICAL_M 149597870700.0

static void compare_spa(murk_library *library)
{
    const char *source = "Reda and Andreas, NREL/TP-560-34302, A.5";
    const char *why = "the issue's";
    const murk_observer observer = {39.742476, -105.1786, 1830.14, 820, 11};
    murk_body sun = {0};
    (void)murk_sun_at(&sun, &observer, 2452930.312847222, NULL);
    murk_library_title(library, "Sun, NREL's example",
                       "2003-10-17T12:30:30-07:00, Golden, Colorado, 820 hPa, "
                       "11 degrees C.");
    murk_library_row(library, "apparent zenith angle", "deg", 50.11162,
                     90 - sun.elevation_deg, 0.005, why, source);
    murk_library_row(library, "azimuth", "deg", 194.340241, sun.azimuth_deg,
                     0.005, why, source);
    murk_library_row(library, "elevation without air", "deg", 39.872046,
                     sun.geometric_elevation_deg, 0.005, why, source);
}

/* Computed with PyEphem 4.1.4 (libastro), without air. */
static const struct {
    const char *name;
    double julian_date, latitude_deg, longitude_deg, altitude_m;
    double sun_azimuth, sun_elevation, moon_azimuth, moon_elevation;
} elsewhere[] = {
    {"Sydney, 2026-06-21T02:00:00Z", 2461212.583333, -33.87, 151.21, 0,
     359.1513, 32.6855, 81.9405, 6.2817},
    {"Tromso, 2026-12-21T11:00:00Z", 2461395.958333, 69.65, 18.96, 0, 184.0873,
     -3.1444, 40.8504, 7.4531},
    {"South Pole station, 2010-01-10T06:30:00Z", 2455206.770833, -90, 0, 2835,
     84.3505, 21.9617, 23.1376, 22.2023},
    {"Quito, 1950-03-21T14:15:00Z", 2433362.093750, -0.18, -78.47, 2850,
     89.6103, 43.4366, 74.9406, 12.6134},
    {"Greenwich, 1987-04-10T19:21:00Z", 2446896.306250, 51.4779, 0, 0, 290.6069,
     -5.8306, 133.6022, 39.5232},
    {"Cape Town, 2049-11-02T15:45:00Z", 2469748.156250, -33.93, 18.42, 0,
     263.3703, 17.4872, 35.3411, 64.7872},
};

static void row(murk_library *library, const char *place, const char *what,
                double reference, double value, double limit)
{
    char quantity[128];
    snprintf(quantity, sizeof quantity, "%s, %s", place, what);
    murk_library_row(library, quantity, "deg", reference, value, limit,
                     limit < 0.01 ? "the issue's" : "1/25 of the moon",
                     "PyEphem 4.1.4, computed");
}

static void compare_elsewhere(murk_library *library)
{
    murk_library_title(library, "Sun and moon elsewhere",
                       "Directions without air, by another ephemeris.");
    for (size_t i = 0; i < sizeof elsewhere / sizeof *elsewhere; ++i) {
        const murk_observer observer = {
            .latitude_deg = elsewhere[i].latitude_deg,
            .longitude_deg = elsewhere[i].longitude_deg,
            .altitude_m = elsewhere[i].altitude_m};
        murk_body sun = {0}, moon = {0};
        (void)murk_sun_at(&sun, &observer, elsewhere[i].julian_date, NULL);
        (void)murk_moon_at(&moon, &observer, elsewhere[i].julian_date, NULL);
        const char *name = elsewhere[i].name;
        row(library, name, "sun's azimuth", elsewhere[i].sun_azimuth,
            sun.azimuth_deg, 0.005);
        row(library, name, "sun's elevation", elsewhere[i].sun_elevation,
            sun.geometric_elevation_deg, 0.005);
        row(library, name, "moon's azimuth", elsewhere[i].moon_azimuth,
            moon.azimuth_deg, 0.02);
        row(library, name, "moon's elevation", elsewhere[i].moon_elevation,
            moon.geometric_elevation_deg, 0.02);
    }
}

static void compare_meeus(murk_library *library)
{
    const char *source = "Meeus 1998, Astronomical Algorithms, ex. 47.a, 48.a";
    const murk_vec3 moon = murk_geocentric_moon_m(2448724.5);
    const murk_vec3 to_sun =
        murk_unit(murk_sub(murk_geocentric_sun_m(2448724.5), moon));
    const double cosine = -murk_dot(to_sun, murk_unit(moon));
    murk_library_title(library, "Moon, Meeus' example",
                       "From the middle of the earth, 1992-04-12T00:00 TT.");
    murk_library_row(library, "right ascension", "deg", 134.688470,
                     DEG * atan2(moon.y, moon.x), 0.02, "1/25 of the moon",
                     source);
    murk_library_row(library, "declination", "deg", 13.768368,
                     DEG * asin(moon.z / murk_length(moon)), 0.02,
                     "1/25 of the moon", source);
    murk_library_row(library, "distance", "km", 368409.7,
                     murk_length(moon) / 1e3, 10, "the shorter series' error",
                     source);
    murk_library_row(library, "phase angle", "deg", 69.0756, DEG * acos(cosine),
                     0.003, "the shorter series' error", source);
    murk_library_row(library, "illuminated", "", 0.6786, (1 + cosine) / 2,
                     0.0001, "last digit printed", source);
}

/* Irradiances of a clear sky against clearsky_ineichen.csv. */
static void compare_clear_sky(murk_library *library)
{
    /* Apparent zenith angle, air mass, and global, direct and diffuse
     * irradiance. */
    static const double published[][5] = {
        {10, 1, 1038.159219, 942.208186, 110.2652929},
        {46.0467599, 1.32355476, 704.6968125, 888.9014703, 87.73601277},
        {10.56413562, 0.93527685, 1044.123068, 953.2492585, 107.031097},
        {34.86074109, 1.12008114, 853.020657, 922.0612471, 96.42909484},
        {72.41687122, 3.01614096, 251.9942769, 655.4492524, 53.9901349},
        {82.85457044, 6.97935524, 65.49426624, 321.1609218, 25.54562017}};
    /* Compare the three irradiances at each zenith angle. */
    murk_library_title(library, "Clear sky",
                       "Ineichen and Perez, Linke turbidity 3, at the sea, "
                       "1364 W/m2 outside.");
    for (size_t i = 0; i < sizeof published / sizeof *published; ++i) {
        const double *p = published[i];
        const murk_clear_sky sky = murk_clear_sky_at(p[0], p[1], 3, 0, 1364);
        const double value[] = {sky.global_w_per_m2, sky.direct_w_per_m2,
                                sky.diffuse_w_per_m2};
        static const char *const names[] = {"global", "direct", "diffuse"};
        for (int k = 0; k < 3; ++k) {
            char quantity[64];
            snprintf(quantity, sizeof quantity, "%s, zenith angle %.2f",
                     names[k], p[0]);
            murk_library_row(library, quantity, "W/m2", p[2 + k], value[k],
                             2e-6, "digits printed of the input",
                             "pvlib-python, tests/test_clearsky.py");
        }
    }
}

/* Against solar_lux_photon.csv, in bands of 10 nm with constant power per
 * nanometre in each. */
static void compare_lux(murk_library *library)
{
    /* Illuminance and photon flux of the three standard spectra. */
    static const struct {
        const char *name;
        double lux, photons;
    } standard[] = {{"extraterrestrial", 133100.9, 1.45317e21},
                    {"AM 1.5 global", 109495.1, 1.19110e21},
                    {"AM 1.5 direct", 97142.3, 1.04496e21}};
    murk_library_title(library, "Lux and photons of sunlight",
                       "ASTM G173 in 372 bands, each even within.");
    /* Sum both over the bands of each spectrum. */
    for (size_t i = 0; i < sizeof standard / sizeof *standard; ++i) {
        const murk_solar_spectrum s = astm_spectrum(i);
        double lux = 0, photons = 0;
        for (int nm = 280; nm < 4000; nm += 10) {
            const double power =
                murk_solar_spectrum_share(&s, nm, nm + 10) * s.total;
            lux +=
                power * murk_quantity_per_watt(MURK_PHOTOMETRIC, nm, nm + 10);
            photons += power * murk_quantity_per_watt(MURK_PAR, nm, nm + 10) *
                       1e-6 * MURK_AVOGADRO;
        }
        char quantity[64];
        snprintf(quantity, sizeof quantity, "%s", standard[i].name);
        murk_library_row(library, quantity, "klx", standard[i].lux / 1e3,
                         lux / 1e3, 1e-6 * standard[i].lux, ".1 %",
                         "solar_lux_photon.csv, computed");
        murk_library_row(library, quantity, "1e21 photons of 400-700 nm/s/m2",
                         standard[i].photons / 1e21, photons / 1e21,
                         1e-24 * standard[i].photons, ".1 %",
                         "solar_lux_photon.csv, computed");
    }
    /* At one line the conversion is known without a spectrum. */
    const double photons = murk_quantity_per_watt(MURK_PHOTONS, 532, 532);
    const double lux = murk_quantity_per_watt(MURK_PHOTOMETRIC, 532, 532);
    murk_library_row(library, "V at 532 nm", "", 0.884426,
                     murk_luminous_efficiency(532), 1e-3, ".1 %",
                     "lux_to_photons.csv, computed from V at 10 nm");
    murk_library_row(library, "a lux of 532 nm", "1e15 photons/s/m2", 4.433560,
                     photons / lux / 1e15, 5e-3, ".1 %",
                     "lux_to_photons.csv, computed from V at 10 nm");
}

static void compare_field(murk_library *library, const clear_day *day)
{
    const char *source = "NOAA SURFRAD, Alamosa, 2016-01-01";
    const clear_fit fit = clear_day_fit(day);
    murk_library_title(library, "A clear day in the field",
                       "All minutes with the sun up, one turbidity fitted: "
                       "differences over the measured mean.");
    murk_library_row(library, "global, rms", "", 0, fit.global.rms, 0.10,
                     "10 %: the issue's", source);
    murk_library_row(library, "direct, rms", "", 0, fit.direct.rms, 0.10,
                     "10 %: the issue's", source);
    murk_library_row(library, "diffuse, mean difference", "", 0,
                     fit.diffuse.bias, .6, "60 %: what the manual says",
                     source);
}

void murk_library_sun(murk_library *library)
{
    static clear_day day;
    compare_spa(library);
    compare_elsewhere(library);
    compare_meeus(library);
    compare_clear_sky(library);
    compare_lux(library);
    if (clear_day_read(&day, 0)) {
        compare_field(library, &day);
    }
}
