/* Light of a weather year against the file itself: in each class of sky the
 * irradiance of a level plane, direct times the sine of the elevation plus
 * diffuse, agrees with the global column, which was measured or modelled
 * without murk (mid-hour, above the horizon; every third of 4,330 hours, with
 * an argument all of them). Also by daylight in parts. */
#include "base/log.h"
#include "check.h"
#include "scene/scene.h"
#include "weather/year.h"
#include "world/sky.h"

#include <stdlib.h>
#include <unistd.h>

#define EPW                                                     \
    "../shared/data/frontier/weather/USA_CO_Golden-NREL.724666" \
    "_TMY3.epw"
/* The bounds of the issue for each class: bias and root mean square, of the
 * mean of the class. */
#define BIAS 2e-3
#define RMS  1e-2

static const char SCENE[] = "murk: 1\n"
                            "band_edges_nm: [300, 4000]\n"
                            "domain: {min_m: [0, 0, 0], max_m: [10, 10, 10]}\n"
                            "weather: {epw: " EPW "}\n"
                            "site: {time: 2000-01-01T12:00:00Z}\n"
                            "photons: {emit: 10}\n";

/* Irradiance of a level plane by all lights, and the elevation of the sun. */
static double level_irradiance(const char *lights, double unix_s,
                               double *elevation_deg)
{
    char text[1000], time[MURK_TIME_SIZE], set[80];
    murk_scene_desc *scene = NULL;
    murk_source *light = NULL;
    murk_error err = {0};
    double sum = 0;
    /* The scene at that time. */
    murk_time_print(time, unix_s, -7 * 60);
    snprintf(set, sizeof set, "site.time=%s", time);
    snprintf(text, sizeof text, "%slights: %s\n", SCENE, lights);
    const murk_override override = {.text = set};
    CHECK(
        !murk_scene_desc_parse(&scene, text, "scene.yaml", &override, 1, &err));
    if (!scene) {
        printf("%s\n", err.text);
        return NAN;
    }
    murk_sky_facts *facts = calloc(scene->n_lights, sizeof *facts);
    CHECK(facts && !murk_sky_lights(&light, facts, scene, &err));
    for (size_t i = 0; facts && light && i < scene->n_lights; ++i) {
        const double irradiance = light[i].power_w.band[0];
        sum += light[i].type == MURK_SOURCE_SKY
                   ? irradiance
                   : -irradiance * light[i].direction.z /
                         murk_length(light[i].direction);
    }
    *elevation_deg = facts ? facts[0].elevation_deg : NAN;
    free(facts);
    free(light);
    murk_scene_desc_destroy(scene);
    return sum;
}

typedef struct sums {
    double n, is, want, square;
} sums;

static void test_classes(const murk_weather_year *year, size_t step)
{
    sums of[9] = {{0}};
    int parts = 0;
    for (size_t i = 0; i < year->n; i += step) {
        const murk_observation *seen = &year->row[i].seen;
        double elevation_deg, same_deg;
        if (!(seen->global_w_per_m2 > 0)) {
            continue;
        }
        const double unix_s = murk_weather_row_middle(year, &year->row[i]);
        const double is = level_irradiance("[{type: sun}, {type: sky}]", unix_s,
                                           &elevation_deg);
        if (!(elevation_deg > 0)) {
            continue;
        }
        sums *s = &of[murk_sky_clearness(seen->direct_w_per_m2,
                                         seen->diffuse_w_per_m2,
                                         (90 - elevation_deg) * MURK_PI / 180)];
        const double off = is - seen->global_w_per_m2;
        s->n += 1;
        s->is += is;
        s->want += seen->global_w_per_m2;
        s->square += off * off;
        if (i % 20 == 0) { /* in parts */
            CHECK_NEAR(
                level_irradiance("[{type: daylight}]", unix_s, &same_deg), is,
                1e-9 * is);
            ++parts;
        }
    }
    for (int class = 1; class <= 8; ++class) {
        const sums *s = &of[class];
        const double mean = s->want / s->n;
        const double bias = (s->is - s->want) / s->want;
        const double rms = sqrt(s->square / s->n) / mean;
        printf("class %d: %4.0f hours, bias %+.3f %%, rms %.3f %%\n", class,
               s->n, 100 * bias, 100 * rms);
        CHECK(s->n > 60);
        CHECK(fabs(bias) <= BIAS && rms <= RMS);
    }
    CHECK(parts > 50);
}

int main(int argc, char **argv)
{
    (void)argv;
    murk_weather_year *year = NULL;
    murk_error err = {0};
    if (access(EPW, R_OK) != 0) {
        check_skip(EPW " is not here");
    }
    murk_warn_to(NULL);
    CHECK(!murk_weather_year_read(&year, EPW, &err));
    if (year) {
        test_classes(year, argc > 1 ? 1 : 3);
    }
    murk_weather_year_release(year);
    return check_done();
}
