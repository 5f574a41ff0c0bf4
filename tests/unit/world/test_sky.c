/* Lights by place and time: what a scene's words become in the light room.
 * Nothing here is random. */
#include "base/log.h"
#include "check.h"
#include "stage_text.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define HEAD                                                    \
    "murk: 1\nband_edges_nm: [400, 500, 600, 700]\n"            \
    "domain: {min_m: [0, 0, 0], max_m: [10, 10, 10]}\n"         \
    "site: {latitude_deg: 40, longitude_deg: -105, time_zone: " \
    "\"-07:00\", date: 2026-06-21, clock: \"%s\"}\nlights:\n%s"

static murk_stage *stage_at(const char *clock, const char *lights,
                            const char *const *overrides)
{
    char text[2000];
    snprintf(text, sizeof text, HEAD, clock, lights);
    return stage_text_create(text, overrides);
}

static double power_w(const murk_stage *stage, size_t light)
{
    double all = 0;
    for (size_t b = 0; b < 3; ++b) {
        all += murk_sources_channel_power_w(stage->lights, 3 * light + b);
    }
    return all;
}

/* At noon, mean time of the meridian -105, the sun stands due south but for
 * the equation of time (-1.9 min on that day), at 90 - 40 + 23.44 degrees. */
static void test_noon(void)
{
    murk_stage *stage =
        stage_at("12:00", "  - {type: sun}\n  - {type: sky}\n", NULL);
    CHECK(stage != NULL);
    if (!stage) {
        return;
    }
    const murk_sky_facts *sun = &stage->sky[0], *sky = &stage->sky[1];
    CHECK_NEAR(sun->elevation_deg, 73.44, .03);
    CHECK_NEAR(sun->azimuth_deg, 180, 2);
    const murk_vec3 d = murk_sources_get(stage->lights, 0)->direction;
    CHECK(d.z < 0 && d.y > 0 && fabs(d.x) < .02); /* light goes north */
    /* PAR is some .43 of a clear day's direct light, more of its sky */
    CHECK(sun->irradiance_w_per_m2 > 350 && sun->irradiance_w_per_m2 < 450);
    CHECK(sky->irradiance_w_per_m2 > 50 && sky->irradiance_w_per_m2 < 100);
    stage_text_destroy(stage);
}

/* With north along x, the same light goes along x. */
static void test_north(void)
{
    static const char *const turned[] = {"north=[1, 0, 0]", NULL};
    murk_stage *stage = stage_at("12:00", "  - {type: sun}\n", turned);
    CHECK(stage != NULL);
    if (stage) {
        const murk_vec3 d = murk_sources_get(stage->lights, 0)->direction;
        CHECK(d.x > 0 && fabs(d.y) < .02);
    }
    stage_text_destroy(stage);
    stage = stage_at("08:00", "  - {type: sun}\n", turned);
    CHECK(stage != NULL);
    if (stage) { /* in the morning light goes west, which is y then */
        CHECK(murk_sources_get(stage->lights, 0)->direction.y > 0);
    }
    stage_text_destroy(stage);
}

static void test_night(void)
{
    murk_stage *stage = stage_at(
        "01:00", "  - {type: sun}\n  - {type: night_sky}\n  - {type: sky}\n",
        NULL);
    CHECK(stage != NULL);
    if (stage) {
        CHECK(!stage->sky[0].is_on && power_w(stage, 0) == 0);
        CHECK(stage->sky[0].elevation_deg < 0);
        CHECK(power_w(stage, 1) > 0);
        CHECK(stage->sky[1].irradiance_w_per_m2 < 1e-4);
    }
    stage_text_destroy(stage);
}

static void test_cover(void)
{
    murk_stage *stage = stage_at("12:00",
                                 "  - {type: sun, cover: overcast}\n"
                                 "  - {type: sky, cover: overcast}\n"
                                 "  - {type: sky}\n",
                                 NULL);
    CHECK(stage != NULL);
    if (stage) {
        CHECK(!stage->sky[0].is_on);
        CHECK(stage->sky[1].irradiance_w_per_m2 >
              stage->sky[2].irradiance_w_per_m2);
        const murk_dome *dome = &murk_sources_get(stage->lights, 1)->dome;
        CHECK(dome->a == 4 && dome->b == -.7); /* CIE type 1 */
    }
    stage_text_destroy(stage);
}

/* A total is spread by the spectrum and sums to what was given. */
static void test_given_irradiance(void)
{
    murk_stage *stage =
        stage_at("12:00",
                 "  - {type: sun, irradiance_w_per_m2: 300}\n"
                 "  - {type: sun, irradiance_w_per_m2: [1, 2, 3]}\n",
                 NULL);
    CHECK(stage != NULL);
    if (stage) {
        CHECK_NEAR(stage->sky[0].irradiance_w_per_m2, 300, 1e-9);
        CHECK_NEAR(stage->sky[1].irradiance_w_per_m2, 6, 1e-12);
        const murk_spectrum *s = &murk_sources_get(stage->lights, 0)->power_w;
        CHECK(s->band[1] != s->band[0]); /* not evenly */
    }
    stage_text_destroy(stage);
}

#define LAMP "  - {type: point, position_m: [5, 5, 5], power_w: 3, schedule: "

static bool shines(const char *clock, const char *schedule)
{
    char lamp[200];
    snprintf(lamp, sizeof lamp, LAMP "%s}\n", schedule);
    murk_stage *stage = stage_at(clock, lamp, NULL);
    CHECK(stage != NULL);
    const bool is_on = stage && power_w(stage, 0) > 0;
    CHECK(!stage || stage->sky[0].is_on == is_on);
    stage_text_destroy(stage);
    return is_on;
}

static void test_schedules(void)
{
    static const struct {
        const char *clock, *schedule;
        bool shines;
    } cases[] = {
        {"12:00", "always", true},
        {"12:00", "never", false},
        {"06:00", "[[\"06:00\", \"22:00\"]]", true},
        {"21:59:59", "[[\"06:00\", \"22:00\"]]", true},
        {"22:00", "[[\"06:00\", \"22:00\"]]", false},
        {"23:00", "[[\"22:00\", \"06:00\"]]", true},
        {"05:00", "[[\"22:00\", \"06:00\"]]", true},
        {"12:00", "[[\"22:00\", \"06:00\"]]", false},
        {"12:00", "night", false},
        {"04:25", "night", true}, /* sunrise there is at 4:31 */
        {"04:37", "night", false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        CHECK(shines(cases[i].clock, cases[i].schedule) == cases[i].shines);
    }
}

static int warnings;

static void count_spectrum(const char *where, const char *text)
{
    (void)where;
    warnings += strstr(text, "for which its spectrum is known") != NULL;
}

/* No light is made up beyond a spectrum's ends, nor left out in silence. */
static void test_bands_beyond_the_spectrum(void)
{
    static const struct {
        const char *edges;
        int warnings;
    } cases[] = {{"band_edges_nm=[400, 500, 600, 700]", 0},
                 {"band_edges_nm=[300, 500, 600, 4000]", 0},
                 {"band_edges_nm=[200, 500, 600, 700]", 1},
                 {"band_edges_nm=[4900, 5000, 5100, 5200]", 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const char *const edges[] = {cases[i].edges, NULL};
        warnings = 0;
        murk_warn_to(count_spectrum);
        murk_stage *stage = stage_at("12:00", "  - {type: sun}\n", edges);
        murk_warn_to(murk_warn_to_stderr);
        CHECK(stage != NULL);
        CHECK(warnings == cases[i].warnings);
        stage_text_destroy(stage);
    }
}

/* Dawn by a weather year whose hours state a diffuse irradiance of 0 up to
 * 05:00, while the sun rises before 04:30: the sky never grows darker, and has
 * at most .5 W/m2 (the file states whole ones), which it reaches. */
static void test_dawn_by_weather(void)
{
    char folder[2048], epw[2200];
    double before = 0, elevation_deg = -90;
    CHECK(getcwd(folder, sizeof folder) != NULL);
    snprintf(epw, sizeof epw, "weather.epw=%s/scenes/weather/june.epw", folder);
    /* Every five minutes from 03:00 to 04:55. */
    for (int minute = 180; minute < 300; minute += 5) {
        char time[64];
        snprintf(time, sizeof time, "site.time=2025-06-02T%02d:%02d:00+01:00",
                 minute / 60, minute % 60);
        const char *const set[] = {epw, time, NULL};
        murk_stage *stage =
            stage_text_create("murk: 1\nband_edges_nm: [300, 4000]\n"
                              "domain: {min_m: [0, 0, 0], max_m: [1, 1, 1]}\n"
                              "weather: {epw: june.epw}\n"
                              "site: {time: 2025-06-02T03:00:00+01:00}\n"
                              "lights: [{type: sky}]\n",
                              set);
        CHECK(stage && stage->scene->weather.seen.diffuse_w_per_m2 == 0);
        if (stage) {
            const double irradiance = stage->sky[0].irradiance_w_per_m2;
            elevation_deg = stage->sky[0].elevation_deg;
            CHECK(irradiance >= before);
            CHECK(irradiance > 0 && irradiance <= .5);
            before = irradiance;
        }
        stage_text_destroy(stage);
    }
    CHECK(elevation_deg > 1);
    CHECK_NEAR(before, .5, .001);
}

int main(void)
{
    test_noon();
    test_north();
    test_night();
    test_cover();
    test_given_irradiance();
    test_schedules();
    test_dawn_by_weather();
    test_bands_beyond_the_spectrum();
    return check_done();
}
