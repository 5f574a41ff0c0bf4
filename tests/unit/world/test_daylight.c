/* Daylight in parts against sun and sky as they are: the same irradiance on
 * level planes; on upright ones within what doc/reference/lights.md states; the
 * same shapes at every hour, dark or not; and places at which the sun was. */
#include "world/daylight.h"

#include "check.h"
#include "source/patch_table.h"
#include "stage_text.h"
#include "world/source_shapes.h"
#include "world/stage.h"

#include <stdlib.h>

#define SCENE                                                              \
    "murk: 1\n"                                                            \
    "band_edges_nm: [400, 700]\n"                                          \
    "domain: {min_m: [0, 0, 0], max_m: [10, 10, 10]}\n"                    \
    "site: {latitude_deg: 52.1, longitude_deg: 5.2, time_zone: '+01:00', " \
    "date: 2026-06-21, clock: '12:00'}\n"                                  \
    "photons: {emit: 10}\n"

/* The irradiance of a plane by all skies of a stage, each on a lattice of its
 * patch or of the upper half. */
static double by_sky(const murk_stage *stage, murk_vec3 normal)
{
    const murk_sky_patch all = {0, 1, 0, 2 * MURK_PI};
    double sum = 0;
    for (size_t i = 0; i < murk_sources_count(stage->lights); ++i) {
        const murk_source *l = murk_sources_get(stage->lights, i);
        const bool is_patch = l->dome.patch.high > 0;
        const murk_sky_patch *patch = is_patch ? &l->dome.patch : &all;
        const int n = is_patch ? 30 : 600;
        murk_dome dome = l->dome;
        double level = 0, own = 0;
        dome.towards = is_patch ? dome.towards : murk_unit(dome.towards);
        for (int c = 0; l->type == MURK_SOURCE_SKY && c < n * n; ++c) {
            const murk_vec3 d =
                murk_sky_patch_at(patch, (c / n + .5) / n, (c % n + .5) / n);
            const double radiance = murk_dome_radiance(&dome, d);
            level += radiance * d.z;
            own += radiance * fmax(0, murk_dot(d, normal));
        }
        sum += level > 0 ? l->power_w.band[0] * own / level : 0;
    }
    return sum;
}

static double by_sun(const murk_stage *stage, murk_vec3 normal)
{
    double sum = 0;
    for (size_t i = 0; i < murk_sources_count(stage->lights); ++i) {
        const murk_source *l = murk_sources_get(stage->lights, i);
        sum +=
            l->type == MURK_SOURCE_SUN
                ? l->power_w.band[0] * fmax(0, -murk_dot(l->direction, normal))
                : 0;
    }
    return sum;
}

static void compare(const char *clock, const char *date, int cie_type,
                    double upright)
{
    static const murk_vec3 planes[] = {
        {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    char time[64], day[64];
    snprintf(time, sizeof time, "site.clock='%s'", clock);
    snprintf(day, sizeof day, "site.date=%s", date);
    char of_parts[32], of_sky[32];
    snprintf(of_parts, sizeof of_parts, "lights.0.cie_type=%d", cie_type);
    snprintf(of_sky, sizeof of_sky, "lights.1.cie_type=%d", cie_type);
    const char *const set[] = {time, day, of_parts, NULL},
                      *const whole_set[] = {time, day, of_sky, NULL};
    murk_stage *parts =
                   stage_text_create(SCENE "lights: [{type: daylight}]\n", set),
               *whole = stage_text_create(
                   SCENE "lights: [{type: sun}, {type: sky}]\n", whole_set);
    CHECK(parts && whole);
    if (parts && whole) {
        const murk_vec3 up = {0, 0, 1};
        const double sun = by_sun(whole, up), sky = by_sky(whole, up);
        CHECK(sun > 0 && sky > 0);
        CHECK_NEAR(by_sun(parts, up), sun, 1e-9 * sun);
        CHECK_NEAR(by_sky(parts, up), sky, 1e-9 * sky);
        for (size_t k = 0; k < sizeof planes / sizeof *planes; ++k) {
            const double is = by_sky(parts, planes[k]),
                         want = by_sky(whole, planes[k]);
            CHECK_NEAR(is, want, upright * want);
        }
        /* The sun comes from three places within half an hour and 8 degrees. */
        int places = 0;
        const murk_vec3 to = murk_sources_get(whole->lights, 0)->direction;
        for (size_t i = 0; i < murk_sources_count(parts->lights); ++i) {
            const murk_source *l = murk_sources_get(parts->lights, i);
            if (l->type == MURK_SOURCE_SUN && l->power_w.band[0] > 0) {
                ++places;
                CHECK(murk_dot(l->direction, to) > cos(.27));
            }
        }
        CHECK(places >= 1 && places <= 3);
    }
    stage_text_destroy(parts);
    stage_text_destroy(whole);
}

/* The text of the shapes of all lights at a time. */
static char *shapes_at(const char *clock, double *power_w)
{
    char time[64], *text = NULL;
    size_t size = 0;
    murk_error err = {0};
    snprintf(time, sizeof time, "site.clock='%s'", clock);
    const char *const set[] = {time, NULL};
    murk_stage *stage =
        stage_text_create(SCENE "lights: [{type: daylight}]\n", set);
    FILE *out = open_memstream(&text, &size);
    CHECK(stage && out);
    if (stage && out) {
        CHECK(!murk_source_shapes_print(out, stage->scene, &err));
        *power_w = murk_sources_power_w(stage->lights);
    }
    if (out) {
        fclose(out);
    }
    stage_text_destroy(stage);
    return text;
}

static void test_shapes_stay(void)
{
    static const char *const clocks[] = {"23:00", "04:30", "12:00", "18:17"};
    double power_w = 0, before_w = -1;
    char *first = shapes_at(clocks[0], &power_w);
    CHECK(first && strlen(first) > 10000);
    for (size_t i = 1; i < sizeof clocks / sizeof *clocks; ++i) {
        char *text = shapes_at(clocks[i], &power_w);
        CHECK(text && first && strcmp(text, first) == 0);
        CHECK(power_w != before_w);
        before_w = power_w;
        free(text);
    }
    free(first);
}

int main(void)
{
    /* Suns at 61, 41, 20 and 7 degrees. */
    compare("12:40", "2026-06-21", 12, .01);
    compare("09:20", "2026-06-21", 12, .01);
    compare("06:50", "2026-06-21", 12, .016);
    compare("05:10", "2026-06-21", 12, .022);
    compare("12:00", "2026-12-21", 12, .019);
    /* The other types that the weather chooses. */
    static const int types[] = {1, 3, 7, 8, 11};
    for (size_t i = 0; i < sizeof types / sizeof *types; ++i) {
        compare("12:40", "2026-06-21", types[i], .012);
        compare("06:50", "2026-06-21", types[i], .016);
    }
    test_shapes_stay();
    return check_done();
}
