/* Refusals of what goes by place and time, to the letter. Nothing here is
 * random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "scene_files.h"

#define HEAD  "murk: 1\n"
#define LAMP  "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n"
#define VALUE MURK_BAD_VALUE

#define EDGES "band_edges_nm: [400, 700]\n"
#define PLACE "latitude_deg: 52, longitude_deg: 5"
#define SUN   "lights:\n  - {type: sun, "

static void test_the_sky(void)
{
    /* A sun without a complete place, or without a valid time with an offset
     * from UTC. */
    CHECK_REFUSED(HEAD EDGES SUN "latitude_deg: 5}\n", VALUE,
                  "fog.yaml:4:5: lights.0",
                  "misses longitude_deg, must be here or in site");
    CHECK_REFUSED(HEAD EDGES SUN PLACE "}\n", VALUE, "fog.yaml:4:5: lights.0",
                  "misses time, must be here or in site");
    CHECK_REFUSED(HEAD EDGES SUN PLACE ", time: 2026-06-31T12:00Z}\n", VALUE,
                  "fog.yaml:4:59: lights.0.time",
                  "2026-06-31T12:00Z, must be a date and time, such as "
                  "2026-06-21T12:00:00Z");
    CHECK_REFUSED(HEAD EDGES SUN PLACE ", time: 2026-06-21T12:00}\n", VALUE,
                  "fog.yaml:4:59: lights.0.time",
                  "2026-06-21T12:00 without its offset from UTC, must end in "
                  "Z or in one such as +02:00 (or site.time_zone be given)");
    /* A spectrum needs bands with edges. */
    CHECK_REFUSED(HEAD SUN PLACE ", time: 2026-06-21T12:00Z, "
                                 "irradiance_w_per_m2: 5}\n"
                                 "bands_nm: [400, 500]\n",
                  VALUE, "fog.yaml:3:5: lights.0",
                  "needs bands with edges (band_edges_nm) to spread its "
                  "spectrum over, or irradiance_w_per_m2 for each line");
    /* A site whose time is incomplete or given twice, or whose time zone is no
     * offset. */
    CHECK_REFUSED(HEAD "site: {date: 2026-06-21, clock: 06:00}\n" LAMP, VALUE,
                  "fog.yaml:2:1: site",
                  "misses time_zone, must have date, clock and time_zone "
                  "together");
    CHECK_REFUSED(HEAD "site: {time: 2026-06-21T12:00Z, clock: 06:00}\n" LAMP,
                  VALUE, "fog.yaml:2:1: site",
                  "has time and clock, must have time, or date, clock and "
                  "time_zone");
    CHECK_REFUSED(HEAD "site: {time_zone: CET}\n" LAMP, VALUE,
                  "fog.yaml:2:19: site.time_zone",
                  "CET, must be an offset from UTC, such as +02:00 or Z");
    /* An aim without area. */
    CHECK_REFUSED(HEAD EDGES "lights:\n  - {type: night_sky, aim: [{corner_m: "
                             "[0, 0, 0], edge1_m: [1, 0, 0], edge2_m: [2, 0, "
                             "0]}]}\n",
                  VALUE, "fog.yaml:4:29: lights.0.aim.0",
                  "edge1_m and edge2_m span no area, must not be zero or "
                  "parallel");
}

#define LAMP_BY                                                        \
    HEAD "lights:\n  - {type: point, position_m: [0, 0, 0], power_w: " \
         "1, schedule: "
#define SCHEDULES                                                 \
    ", must be always, night, never, or a list of spans such as " \
    "[[06:00, 22:00]]"

static void test_schedules(void)
{
    CHECK_REFUSED(LAMP_BY "night}\n", VALUE, "fog.yaml:3:64: lights.0",
                  "a schedule by the time of a scene that has none, must have "
                  "site.time (or site.date and site.clock)");
    CHECK_REFUSED(LAMP_BY "nigt}\n", VALUE, "fog.yaml:3:64: lights.0.schedule",
                  "nigt" SCHEDULES);
    CHECK_REFUSED(LAMP_BY "[[06:00]]}\n", VALUE,
                  "fog.yaml:3:65: lights.0.schedule", "a list" SCHEDULES);
    CHECK_REFUSED(LAMP_BY "[[06:00, [1]]]}\n", VALUE,
                  "fog.yaml:3:65: lights.0.schedule", "a list" SCHEDULES);
    CHECK_REFUSED(LAMP_BY "[[[1], 06:00]]}\n", VALUE,
                  "fog.yaml:3:65: lights.0.schedule", "a list" SCHEDULES);
    CHECK_REFUSED(LAMP_BY "[[06:00, 07:00, 08:00]]}\n", VALUE,
                  "fog.yaml:3:65: lights.0.schedule", "a list" SCHEDULES);
    CHECK_REFUSED(LAMP_BY "[[06:00, 24:01]]}\n", VALUE,
                  "fog.yaml:3:65: lights.0.schedule", "a list" SCHEDULES);
    CHECK_REFUSED(LAMP_BY "[[06:00, 06:00]]}\n", VALUE,
                  "fog.yaml:3:65: lights.0.schedule",
                  "from 06:00 to 06:00 is no time, must not be equal");
}

int main(void)
{
    if (!folder_enter()) {
        check_skip("no folder for temporary files");
    }
    test_the_sky();
    test_schedules();
    folder_leave((const char *const[]){"fog.yaml", NULL});
    return check_done();
}
