/* Light sources of the sky for a place and a time. The position of sun and moon
 * comes from source/ephemeris.h, irradiance under a clear sky from
 * source/clear_sky.h, spectra from source/solar_spectrum.h, moonlight, twilight
 * and airglow from source/moonlight.h, source/twilight.h and
 * source/night_sky.h; each of these headers cites the model. This file adds
 * clouds (Kasten and Czeplak 1980, below), the choice of the radiance
 * distribution of the sky (CIE standard general sky, source/dome.h), the split
 * of the irradiance into bands, the weather (scene/weather.h), daylight in
 * parts (world/daylight.h), and the schedules of lamps. */
#include "world/sky.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "base/calendar.h"
#include "base/log.h"
#include "base/photometry.h"
#include "source/clear_sky.h"
#include "source/ephemeris.h"
#include "source/moonlight.h"
#include "source/night_sky.h"
#include "source/solar_spectrum.h"
#include "source/twilight.h"
#include "world/daylight.h"
#include "world/lamp_shape.h"

#define DAY_S     86400.0         /* seconds of a day */
#define RAD       (MURK_PI / 180) /* radians in a degree */
#define RIGHT_DEG 90.0            /* elevation of the zenith */

/* Elevation, without refraction, of the centre of the sun at sunrise and sunset
 * by the convention of almanacs: minus the refraction at the horizon, 34', and
 * minus the semidiameter, 16'. */
#define SUNRISE_DEG (-50.0 / 60)

/* The effect of clouds over a share N of the sky, 0..1: left is the share of
 * the global irradiance of a clear sky that remains, 1 - .75 N^3.4; diffuse is
 * the share of the remaining irradiance that is diffuse, .3 + .7 N^2. Source:
 * F. Kasten and G. Czeplak, Solar Energy 24 (1980) 177,
 * doi:10.1016/0038-092X(80)90391-6. */
typedef struct clouds {
    double left, diffuse;
} clouds;

static clouds clouds_of(murk_scene_cover cover)
{
    /* The share of the sky that each key word stands for. */
    static const double share[] = {[MURK_SCENE_CLEAR] = 0,
                                   [MURK_SCENE_INTERMEDIATE] = .5,
                                   [MURK_SCENE_OVERCAST] = 1};
    const double n = share[cover];
    return (clouds){1 - .75 * pow(n, 3.4), .3 + .7 * n * n};
}

/* ---- positions of sun and moon ---- */

static murk_observer observer_of(const murk_scene_site *site)
{
    return (murk_observer){.latitude_deg = site->latitude_deg,
                           .longitude_deg = site->longitude_deg,
                           .altitude_m = site->altitude_m,
                           .pressure_hpa =
                               site->has_pressure ? site->pressure_hpa : 0,
                           .temperature_c = site->temperature_c};
}

typedef murk_status (*body_finder)(murk_body *out, const murk_observer *,
                                   double, murk_error *);

/* Computes the position of a body at the place and time of `site` with the
 * function `at`; an error names the time. */
static murk_status find(murk_body *out, body_finder at,
                        const murk_scene_site *site, const char *where,
                        murk_error *err)
{
    const murk_observer observer = observer_of(site);
    murk_error cause = {0};
    const murk_status status =
        at(out, &observer, murk_julian_date(site->unix_s), &cause);
    if (!status) {
        return MURK_OK;
    }
    char time[MURK_TIME_SIZE];
    murk_time_print(time, site->unix_s, site->zone_min);
    return murk_fail(err, status, where, "at %s: %s", time, cause.text);
}

/* Unit vector from the ground towards a body; north is the unit vector of north
 * in the coordinates of the scene. */
static murk_vec3 towards(const murk_body *body, murk_vec3 north)
{
    const murk_vec3 east = murk_vec(north.y, -north.x, 0);
    const double azimuth = body->azimuth_deg * RAD,
                 elevation = body->elevation_deg * RAD;
    murk_vec3 to = murk_vec(0, 0, sin(elevation));
    to = murk_along(to, cos(elevation) * cos(azimuth), north);
    return murk_along(to, cos(elevation) * sin(azimuth), east);
}

/* ---- schedules ---- */

/* True if the local time of day at the site lies in one of the spans of the
 * schedule. A span whose end is an earlier time of day than the beginning
 * passes midnight. The beginning of a span belongs to the span, the end does
 * not. */
static bool is_within_spans(const murk_scene_schedule *schedule,
                            const murk_scene_site *site)
{
    const double local_s = site->unix_s + 60.0 * site->zone_min;
    const double clock_s = local_s - DAY_S * floor(local_s / DAY_S);
    for (size_t i = 0; i < schedule->spans; ++i) {
        const double from = schedule->from_s[i], to = schedule->to_s[i];
        const bool is_after = clock_s >= from, is_before = clock_s < to;
        if (from < to ? is_after && is_before : is_after || is_before) {
            return true;
        }
    }
    return false;
}

/* Sets *out to whether the upper limb of the sun is below the horizon
 * (SUNRISE_DEG) at the place and time of the scene. Fails with MURK_BAD_VALUE
 * if the scene has no latitude or longitude, or as murk_sun_at() does. */
static murk_status is_night(bool *out, const murk_scene_desc *scene,
                            const char *where, murk_error *err)
{
    murk_body sun;
    if (!scene->site.has_latitude || !scene->site.has_longitude) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "schedule: night, must have site.latitude_deg and "
                         "site.longitude_deg");
    }
    const murk_status status =
        find(&sun, murk_sun_at, &scene->site, where, err);
    if (!status) {
        *out = sun.geometric_elevation_deg < SUNRISE_DEG;
    }
    return status;
}

/* Sets *out to whether a lamp or directional light is on at the time of the
 * scene by its schedule. Fails as is_night() if the schedule is night. */
static murk_status shines(bool *out, const murk_scene_desc *scene,
                          const murk_scene_light *light, murk_error *err)
{
    switch (light->schedule.when) {
    case MURK_SCENE_NEVER:
        *out = false;
        break;
    case MURK_SCENE_BY_CLOCK:
        *out = is_within_spans(&light->schedule, &scene->site);
        break;
    case MURK_SCENE_NIGHT:
        return is_night(out, scene, light->where, err);
    case MURK_SCENE_ALWAYS:
        *out = true;
        break;
    }
    return MURK_OK;
}

/* ---- irradiance and spectrum ---- */

/* Warns of the first band that reaches beyond the wavelengths of the spectrum.
 * At the wavelengths beyond, the spectrum is 0 only because the model ends.
 * Bands without edges give no warning. */
static void warn_beyond(const murk_scene_desc *scene,
                        const murk_scene_light *light,
                        const murk_solar_spectrum *spectrum)
{
    const double first = spectrum->nm[0],
                 last = spectrum->nm[spectrum->nodes - 1];
    for (int b = 0; scene->has_edges && b < scene->bands; ++b) {
        const double from = scene->band_edge_nm[b],
                     to = scene->band_edge_nm[b + 1];
        if (from < first || to > last) {
            murk_warn(light->where,
                      "band %g..%g nm reaches beyond %g..%g nm, for which its "
                      "spectrum is known: there it is taken as dark",
                      from, to, first, last);
            return;
        }
    }
}

/* Splits an irradiance over all wavelengths [W/m2] into the bands of the scene
 * by the spectrum. If the user gives a total, it is the irradiance of all bands
 * together, and is split in place of the irradiance of the model. If the user
 * gives an irradiance for each band, these are returned as they are. */
static murk_spectrum spread(const murk_scene_desc *scene,
                            const murk_scene_light *light,
                            const murk_solar_spectrum *spectrum,
                            double irradiance)
{
    murk_spectrum out = light->power_w;
    if (light->has_irradiance && !light->irradiance_total) {
        return out;
    }
    warn_beyond(scene, light, spectrum);
    /* Shares of the bands in the spectrum. */
    double all = 0;
    for (int b = 0; b < scene->bands; ++b) {
        out.band[b] =
            scene->has_edges
                ? murk_solar_spectrum_share(spectrum, scene->band_edge_nm[b],
                                            scene->band_edge_nm[b + 1])
                : 1; /* bands without edges: scene/keys_sky.c accepts only a
                      * single band here, of which the user gives the total */
        all += out.band[b];
    }
    /* Scale the shares to the irradiance. */
    const double scale = !light->has_irradiance ? irradiance
                         : all > 0              ? light->power_w.band[0] / all
                                                : 0;
    for (int b = 0; b < scene->bands; ++b) {
        out.band[b] *= scale;
    }
    return out;
}

/* Luminous efficacy of the spectrum: lumens per watt of the power at all
 * wavelengths. */
static double lumen_per_watt(const murk_solar_spectrum *spectrum)
{
    const double from = 380, to = 780; /* nm; limits of the photopic luminosity
                                        * function */
    return murk_solar_spectrum_share(spectrum, from, to) *
           murk_quantity_per_watt_of(MURK_PHOTOMETRIC, from, to,
                                     murk_solar_spectrum_at, spectrum);
}

static double pressure_hpa_of(const murk_scene_site *site)
{
    return site->has_pressure ? site->pressure_hpa
                              : murk_standard_pressure_hpa(site->altitude_m);
}

/* The spectrum of sun, moon, sky or night sky, according to `source`, if the
 * body that emits or reflects the light has this apparent elevation. */
static murk_solar_spectrum spectrum_of(murk_spectrum_source source,
                                       const murk_scene_light *light,
                                       double elevation_deg)
{
    murk_spectrum_air air = murk_spectrum_air_defaults();
    murk_solar_spectrum out;
    air.apparent_zenith_deg = RIGHT_DEG - elevation_deg;
    air.linke_turbidity = light->linke_turbidity;
    air.pressure_hpa = pressure_hpa_of(&light->site);
    murk_solar_spectrum_make(&out, source, &air);
    return out;
}

/* Position of the sun and irradiance under a clear sky. */
typedef struct daylight {
    murk_body sun;
    murk_clear_sky clear;
} daylight;

static murk_status find_daylight(daylight *out, const murk_scene_light *light,
                                 murk_error *err)
{
    const murk_scene_site *site = &light->site;
    const murk_status status =
        find(&out->sun, murk_sun_at, site, light->where, err);
    if (status) {
        return status;
    }
    const double zenith = RIGHT_DEG - out->sun.elevation_deg;
    out->clear = murk_clear_sky_at(
        zenith, murk_absolute_airmass(zenith, pressure_hpa_of(site)),
        light->linke_turbidity, site->altitude_m,
        murk_extraterrestrial_w_per_m2(out->sun.distance_m));
    return MURK_OK;
}

/* Sets the direction and the angular radius of a source whose rays come from
 * the body. */
static void aim_from(murk_source *out, const murk_body *body, murk_vec3 north)
{
    out->direction = murk_scale(-1, towards(body, north));
    out->angular_radius_rad = body->diameter_deg / 2 * RAD;
}

static murk_status sun_light(murk_source *out, murk_sky_facts *facts,
                             const murk_scene_desc *scene,
                             const murk_scene_light *light, murk_error *err)
{
    daylight day;
    const murk_status status = find_daylight(&day, light, err);
    if (status) {
        return status;
    }
    facts->azimuth_deg = day.sun.azimuth_deg;
    facts->elevation_deg = day.sun.elevation_deg;
    facts->is_on = day.sun.elevation_deg > 0;
    aim_from(out, &day.sun, scene->north);
    /* Under clouds the direct irradiance on a level plane is the share of the
     * remaining global irradiance that is not diffuse. Divided by the sine of
     * the elevation, it is normal to the beam; it is never more than the direct
     * irradiance of a clear sky. */
    double direct = day.clear.direct_w_per_m2;
    if (light->by_weather && !isnan(scene->weather.seen.direct_w_per_m2)) {
        direct = scene->weather.seen.direct_w_per_m2;
    } else if (light->cover != MURK_SCENE_CLEAR && facts->is_on) {
        const clouds c = clouds_of(light->cover);
        direct =
            fmin(direct, c.left * (1 - c.diffuse) * day.clear.global_w_per_m2 /
                             sin(day.sun.elevation_deg * RAD));
    }
    facts->spectrum =
        spectrum_of(MURK_SPECTRUM_DIRECT, light, day.sun.elevation_deg);
    out->power_w = spread(scene, light, &facts->spectrum, direct);
    return MURK_OK;
}

static double extinction_of(const murk_scene_light *light)
{
    return murk_visual_extinction(light->linke_turbidity,
                                  light->site.altitude_m);
}

/* Position of the moon and moonlight under a clear sky. */
static murk_status find_moonlight(murk_body *body, murk_moonlight *out,
                                  const murk_scene_light *light,
                                  murk_error *err)
{
    const murk_status status =
        find(body, murk_moon_at, &light->site, light->where, err);
    if (!status) {
        const murk_moon moon = {.phase_angle_deg = body->phase_angle_deg,
                                .distance_m = body->distance_m,
                                .elevation_deg = body->elevation_deg};
        *out = murk_moonlight_at(&moon, extinction_of(light));
    }
    return status;
}

static murk_status moon_light(murk_source *out, murk_sky_facts *facts,
                              const murk_scene_desc *scene,
                              const murk_scene_light *light, murk_error *err)
{
    murk_body body;
    murk_moonlight moonlight;
    const murk_status status = find_moonlight(&body, &moonlight, light, err);
    if (status) {
        return status;
    }
    facts->azimuth_deg = body.azimuth_deg;
    facts->elevation_deg = body.elevation_deg;
    facts->is_on = body.elevation_deg > 0;
    aim_from(out, &body, scene->north);
    /* The share of the direct moonlight that clouds let through: the ratio of
     * the direct irradiance under the clouds to that under a clear sky, both by
     * the law of Kasten and Czeplak. */
    const clouds c = clouds_of(light->cover),
                 none = clouds_of(MURK_SCENE_CLEAR);
    const double seen = c.left * (1 - c.diffuse) / (1 - none.diffuse);
    facts->spectrum =
        spectrum_of(MURK_SPECTRUM_DIRECT, light, body.elevation_deg);
    out->power_w =
        spread(scene, light, &facts->spectrum,
               seen * moonlight.direct_lux / lumen_per_watt(&facts->spectrum));
    return MURK_OK;
}

/* Diffuse irradiance by the model of twilight (source/twilight.h) on a level
 * plane [W/m2] under the clouds; with the sun up, that at the horizon. */
static double twilight_w_per_m2(const daylight *day, murk_scene_cover cover,
                                const murk_solar_spectrum *spectrum)
{
    return clouds_of(cover).left *
           murk_twilight_lux(day->sun.geometric_elevation_deg) /
           lumen_per_watt(spectrum);
}

/* Diffuse irradiance by sunlight on a level plane [W/m2] under the clouds: the
 * larger of the values of the model of the day (source/clear_sky.h) and of the
 * model of twilight, so that the two join without a gap. */
static double scattered_w_per_m2(const daylight *day, murk_scene_cover cover,
                                 const murk_solar_spectrum *spectrum)
{
    const clouds c = clouds_of(cover);
    const double by_day = cover == MURK_SCENE_CLEAR
                              ? day->clear.diffuse_w_per_m2
                              : c.left * c.diffuse * day->clear.global_w_per_m2;
    return fmax(by_day, twilight_w_per_m2(day, cover, spectrum));
}

/* Sets cover and type of a sky under the weather by the clearness, if the sun
 * is up and both irradiances are measured. Classes 1 and 2 are overcast, 3 to 5
 * partly cloudy. */
static void see_clearness(murk_scene_light *light, const murk_observation *seen,
                          const murk_body *sun)
{
    enum { OVERCAST_UP_TO = 2, CLOUDY_UP_TO = 5 };
    const double all = seen->direct_w_per_m2 + seen->diffuse_w_per_m2;
    if (isnan(all) || !(all > 0) || !(sun->elevation_deg > 0)) {
        return;
    }
    const int clearness =
        murk_sky_clearness(seen->direct_w_per_m2, seen->diffuse_w_per_m2,
                           (RIGHT_DEG - sun->elevation_deg) * RAD);
    light->cover = clearness <= OVERCAST_UP_TO ? MURK_SCENE_OVERCAST
                   : clearness <= CLOUDY_UP_TO ? MURK_SCENE_INTERMEDIATE
                                               : MURK_SCENE_CLEAR;
    if (light->cie_type == 0) {
        light->cie_type = (uint64_t)murk_sky_cie_type(clearness);
    }
}

/* The light by a weather that states a diffuse irradiance of 0: less than half
 * a unit of the last digit, because files state whole W/m2, and models for such
 * files give 0 for a sun that is up to some 6 degrees high. The light is that
 * of the model of twilight (at the horizon, if the sun is up), at most that
 * half unit, so that a rising sun never makes the sky darker. */
static double below_resolution(const murk_scene_light *light,
                               const daylight *day,
                               const murk_solar_spectrum *spectrum)
{
    return fmin(twilight_w_per_m2(day, light->cover, spectrum),
                MURK_WEATHER_RESOLVED_W_PER_M2);
}

/* Diffuse irradiance by sunlight on a level plane [W/m2]: that of the weather,
 * if it states one, else that of the models. */
static double diffuse_by_sun(const murk_scene_desc *scene,
                             const murk_scene_light *light, const daylight *day,
                             const murk_solar_spectrum *spectrum)
{
    const double measured =
        light->by_weather ? scene->weather.seen.diffuse_w_per_m2 : NAN;
    return measured > 0    ? measured
           : measured == 0 ? below_resolution(light, day, spectrum)
                           : scattered_w_per_m2(day, light->cover, spectrum);
}

static murk_status sky_light(murk_source *out, murk_sky_facts *facts,
                             const murk_scene_desc *scene,
                             const murk_scene_light *given, murk_error *err)
{
    /* The type of the CIE standard general sky for each key word: 12 clear, 7
     * partly cloudy, 1 overcast. The key cie_type replaces it. */
    static const int type_of[] = {[MURK_SCENE_CLEAR] = 12,
                                  [MURK_SCENE_INTERMEDIATE] = 7,
                                  [MURK_SCENE_OVERCAST] = 1};
    /* Positions of sun and moon, and the light of both under a clear sky. */
    daylight day;
    murk_body body;
    murk_moonlight moonlight;
    murk_status status = find_daylight(&day, given, err);
    if (!status) {
        status = find_moonlight(&body, &moonlight, given, err);
    }
    if (status) {
        return status;
    }
    murk_scene_light seen = *given;
    const murk_scene_light *const light = &seen;
    if (given->by_weather) {
        see_clearness(&seen, &scene->weather.seen, &day.sun);
    }
    const murk_spectrum_source source = light->cover == MURK_SCENE_CLEAR
                                            ? MURK_SPECTRUM_CLEAR_SKY
                                            : MURK_SPECTRUM_OVERCAST;
    /* Diffuse irradiance from the sun and from the moon. */
    facts->spectrum = spectrum_of(
        source, light, fmax(day.sun.elevation_deg, body.elevation_deg));
    const double by_sun = diffuse_by_sun(scene, light, &day, &facts->spectrum);
    const double by_moon = clouds_of(light->cover).left *
                           moonlight.diffuse_lux /
                           lumen_per_watt(&facts->spectrum);
    /* The radiance distribution is that for the position of sun or moon,
     * whichever gives more diffuse irradiance. */
    const murk_body *brighter = by_sun >= by_moon ? &day.sun : &body;
    facts->azimuth_deg = day.sun.azimuth_deg;
    facts->elevation_deg = day.sun.elevation_deg;
    out->dome = murk_dome_cie(light->cie_type > 0 ? (int)light->cie_type
                                                  : type_of[light->cover],
                              towards(brighter, scene->north));
    out->power_w = spread(scene, light, &facts->spectrum, by_sun + by_moon);
    return MURK_OK;
}

/* The radiance of a night sky rises towards the horizon, because the line of
 * sight crosses more glowing air, and extinction along the longer path lowers
 * the radiance again. murk_night_sky_lux() includes both effects; the source is
 * an even sky of the same irradiance on a level plane. */
static murk_status night_light(murk_source *out, murk_sky_facts *facts,
                               const murk_scene_desc *scene,
                               const murk_scene_light *light, murk_error *err)
{
    (void)err;
    const double lux =
        murk_night_sky_lux(light->mag_per_arcsec2, extinction_of(light));
    facts->spectrum =
        spectrum_of(MURK_SPECTRUM_EXTRATERRESTRIAL, light, RIGHT_DEG);
    out->power_w = spread(scene, light, &facts->spectrum,
                          lux / lumen_per_watt(&facts->spectrum));
    return MURK_OK;
}

/* ---- all lights ---- */

murk_source murk_sky_lamp(const murk_scene_light *light)
{
    murk_source out = {.type = light->type,
                       .position = light->position,
                       .edge1 = light->edge1,
                       .edge2 = light->edge2,
                       .direction = light->direction,
                       .radius_m = light->radius_m,
                       .divergence_rad = light->divergence_rad,
                       .power_w = light->power_w,
                       .where = light->where};
    if (light->luminaire) {
        murk_lamp_shape(&out, light);
    }
    return out;
}

static double sum(const murk_spectrum *spectrum, int bands)
{
    double all = 0;
    for (int b = 0; b < bands; ++b) {
        all += spectrum->band[b];
    }
    return all;
}

/* Converts sun, moon or a sky as a whole. */
static murk_status whole_light(murk_source *out, murk_sky_facts *facts,
                               const murk_scene_desc *scene,
                               const murk_scene_light *light, murk_error *err)
{
    static murk_status (*const of_sky[])(
        murk_source *, murk_sky_facts *, const murk_scene_desc *,
        const murk_scene_light *,
        murk_error *) = {[MURK_SOURCE_SUN] = sun_light,
                         [MURK_SOURCE_MOON] = moon_light,
                         [MURK_SOURCE_SKY] = sky_light,
                         [MURK_SOURCE_NIGHT_SKY] = night_light};
    *out = (murk_source){.type = light->type, .where = light->where};
    const murk_status status =
        of_sky[light->type](out, facts, scene, light, err);
    if (!status && !facts->is_on) {
        out->power_w = murk_spectrum_flat(0, MURK_BANDS_MAX);
    }
    return status;
}

/* ---- daylight in parts ---- */

/* What the parts of the last light of type daylight have in common, so that sun
 * and sky are computed once for all of them. */
typedef struct whole_daylight {
    bool is_made;
    size_t item;
    murk_source sun, sky;
    murk_sky_facts sun_facts, sky_facts;
    murk_daylight parts;
} whole_daylight;

static murk_status make_daylight(whole_daylight *out,
                                 const murk_scene_desc *scene,
                                 const murk_scene_light *part, murk_error *err)
{
    murk_scene_light whole = *part;
    whole.part = 0;
    whole.type = MURK_SOURCE_SUN;
    out->sun_facts = out->sky_facts = (murk_sky_facts){.is_on = true};
    murk_status status =
        whole_light(&out->sun, &out->sun_facts, scene, &whole, err);
    whole.type = MURK_SOURCE_SKY;
    if (!status) {
        status = whole_light(&out->sky, &out->sky_facts, scene, &whole, err);
    }
    if (!status) {
        murk_daylight_make(&out->parts, &out->sun, &out->sky,
                           part->site.latitude_deg, scene->north);
    }
    out->sun.where = out->sky.where = NULL; /* `whole` ends here */
    out->item = part->item;
    out->is_made = !status;
    return status;
}

static murk_status part_of_daylight(murk_source *out, murk_sky_facts *facts,
                                    const murk_scene_desc *scene,
                                    const murk_scene_light *light,
                                    whole_daylight *day, murk_error *err)
{
    if (!day->is_made || day->item != light->item) {
        const murk_status status = make_daylight(day, scene, light, err);
        if (status) {
            return status;
        }
    }
    if (light->type == MURK_SOURCE_SKY) {
        *out = day->sky;
        *facts = day->sky_facts;
        murk_daylight_patch(out, &day->parts, light->part - 1);
    } else {
        *out = day->sun;
        *facts = day->sun_facts;
        murk_daylight_place(out, &day->parts, light->part - 1);
    }
    out->where = light->where;
    return MURK_OK;
}

/* As murk_sky_light(); `day` is for lights of the same scene. */
static murk_status convert(murk_source *out, murk_sky_facts *facts,
                           const murk_scene_desc *scene, size_t light,
                           whole_daylight *day, murk_error *err)
{
    const murk_scene_light *l = &scene->lights[light];
    murk_status status;
    *facts = (murk_sky_facts){
        .is_on = true, .azimuth_deg = NAN, .elevation_deg = NAN};
    /* Sun, moon and skies are computed; lamps and directional light follow
     * their schedule. */
    if (l->part > 0) {
        status = part_of_daylight(out, facts, scene, l, day, err);
    } else if (murk_scene_light_is_of_sky(l)) {
        status = whole_light(out, facts, scene, l, err);
    } else {
        *out = murk_sky_lamp(l);
        facts->lamp_spectrum = l->spectrum;
        status = shines(&facts->is_on, scene, l, err);
    }
    if (status) {
        return status;
    }
    /* A source that is off gets power 0 in all bands; then every source whose
     * power is 0 in all bands counts as off. */
    if (!facts->is_on) {
        out->power_w = murk_spectrum_flat(0, MURK_BANDS_MAX);
    }
    facts->irradiance_w_per_m2 =
        murk_scene_light_is_distant(l) ? sum(&out->power_w, scene->bands) : NAN;
    facts->is_on = sum(&out->power_w, scene->bands) > 0;
    return MURK_OK;
}

murk_status murk_sky_light(murk_source *out, murk_sky_facts *facts,
                           const murk_scene_desc *scene, size_t light,
                           murk_error *err)
{
    whole_daylight day = {0};
    return convert(out, facts, scene, light, &day, err);
}

murk_status murk_sky_lights(murk_source **out, murk_sky_facts *facts,
                            const murk_scene_desc *scene, murk_error *err)
{
    const size_t n = scene->n_lights;
    size_t portals = 0;
    for (size_t i = 0; i < n; ++i) {
        portals += scene->lights[i].portals;
    }
    /* One block of memory holds the sources, then the portals of all sources.
     */
    murk_source *light =
        calloc(1, (n + 1) * sizeof *light + portals * sizeof(murk_portal));
    if (!light) {
        return murk_no_memory(err, scene->path, "for the lights");
    }
    murk_portal *next = (murk_portal *)(light + n + 1);
    whole_daylight day = {0};
    /* Convert each light source, and append its portals to the portals of the
     * sources before it. */
    murk_status status = MURK_OK;
    for (size_t i = 0; i < n && !status; ++i) {
        const murk_scene_light *from = &scene->lights[i];
        murk_sky_facts own;
        status =
            convert(&light[i], facts ? &facts[i] : &own, scene, i, &day, err);
        light[i].portal = next;
        light[i].portals = from->portals;
        for (size_t k = 0; k < from->portals; ++k) {
            const murk_scene_portal *p = &from->portal[k];
            *next++ = (murk_portal){p->corner, p->edge1, p->edge2};
        }
    }
    if (status) {
        free(light);
        return status;
    }
    *out = light;
    return MURK_OK;
}
