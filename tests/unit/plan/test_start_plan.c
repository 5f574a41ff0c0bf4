/* The candidates that stand for the sensors of a given plan: exact ones, the
 * nearest position, then the nearest direction; and files that are refused.
 * Nothing here is random. */
#include "base/log.h"
#include "check.h"
#include "plan/start_plan.h"
#include "stage_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define HEAD                                                       \
    "murk: 1\n"                                                    \
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"               \
    "lights: [{type: point, position_m: [1, 1, 1], power_w: 8}]\n" \
    "sensors:\n"                                                   \
    "  types:\n"                                                   \
    "    - {name: node, range_m: 2}\n"                             \
    "    - {name: cam, range_m: 9, view: {hfov_deg: 40, "          \
    "vfov_deg: 20}, headings: 4, tilts_deg: [0, -90]}\n"

/* Poses of a site: the node, then the cameras with headings 0, 90, 180 and 270,
 * each with tilts 0 and -90. */
#define OF_SITE 9

static const murk_vec3 site[3] = {{1, 1, 1}, {2, 1, 1}, {3, 1, 1}};

static char folder[] = "/tmp/murk-start-XXXXXX";
static char note[512];

static void keep_note(const char *where, const char *text)
{
    CHECK_TEXT(where, "placement.start_plan");
    snprintf(note, sizeof note, "%s", text);
}

typedef struct matched {
    murk_stage *stage;
    murk_poses *poses;
    murk_status status;
    murk_error err;
} matched;

/* Matches a file of this name and text with the poses of the scene HEAD and
 * `more`. */
static matched match(const char *name, const char *text, const char *more)
{
    char scene[2048], path[64], set[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    CHECK(file && fputs(text, file) >= 0 && fclose(file) == 0);
    snprintf(scene, sizeof scene, HEAD "%s", more);
    snprintf(set, sizeof set, "placement.start_plan=%s", path);
    const char *const list[] = {set, NULL};
    matched m = {.stage = stage_text_create(scene, list)};
    note[0] = 0;
    CHECK(m.stage != NULL);
    if (m.stage) {
        const murk_domain *domain = &m.stage->world.domain;
        CHECK(!murk_poses_create(&m.poses, m.stage->scene, domain, site, 3,
                                 &m.err));
        const murk_warn_sink before = murk_warn_to(keep_note);
        m.status =
            murk_start_plan_match(m.poses, m.stage->scene, domain, &m.err);
        (void)murk_warn_to(before);
    }
    (void)unlink(path);
    return m;
}

static void unmatch(matched *m)
{
    murk_poses_destroy(m->poses);
    stage_text_destroy(m->stage);
}

static void check_start(const matched *m, const uint32_t *want, size_t n)
{
    CHECK_TEXT(m->err.text, "");
    CHECK(m->poses && m->poses->starts == n);
    for (size_t i = 0; i < n && m->poses && m->poses->starts == n; ++i) {
        CHECK(m->poses->start[i] == want[i]);
    }
}

#define CSV "type,x_m,y_m,z_m,heading_deg,tilt_deg\n"

static void test_exact(void)
{
    matched m = match("start.csv",
                      CSV "cam,2,1,1,90,0\nnode,3,1,1,,\ncam,1,1,1,270,-90\n",
                      "  count: 2\n");
    check_start(&m, (const uint32_t[]){OF_SITE + 3, 2 * OF_SITE, 8}, 3);
    CHECK_TEXT(note, "");
    unmatch(&m);
}

/* Position comes before direction. Straight down all headings have one axis,
 * but the picture is turned. */
static void test_nearest(void)
{
    matched m =
        match("start.json",
              "{\"sensors\": [{\"type\": \"cam\", \"position_m\": [2.2, "
              "1, 1], \"heading_deg\": -80, \"tilt_deg\": 10}, "
              "{\"type\": \"cam\", \"position_m\": [0.9, 1.1, 1], "
              "\"heading_deg\": 170, \"tilt_deg\": -90}]}",
              "  count: 2\n");
    check_start(&m, (const uint32_t[]){OF_SITE + 7, 6}, 2);
    CHECK_TEXT(note, "");
    unmatch(&m);
}

/* The second sensor of a candidate is left out, and a sensor that is far from
 * all candidates is told. */
static void test_far_and_twice(void)
{
    matched m = match("start.csv",
                      "type,x_m,y_m,z_m\nnode,1,1,1\nnode,1.1,1,1\n"
                      "node,3,3,1\n",
                      "  count: 2\n");
    check_start(&m, (const uint32_t[]){0, 2 * OF_SITE}, 2);
    CHECK_MENTIONS(note, "start.csv: sensor 3 lies 2 m from the nearest "
                         "candidate of its type, which is 1 m from the next");
    unmatch(&m);
}

/* At equal poses the fixed sensor stands for the sensor of the file. */
static void test_fixed(void)
{
    matched m = match("start.csv", "type,x_m,y_m,z_m\nnode,2,1,1\n",
                      "  count: 2\n"
                      "  fixed: [{type: node, position_m: [2, 1, 1]}]\n");
    check_start(&m, (const uint32_t[]){3 * OF_SITE}, 1);
    unmatch(&m);
}

static void test_no_sensors(void)
{
    matched m = match("start.json", "{\"sensors\": []}", "  count: 2\n");
    check_start(&m, NULL, 0);
    CHECK(m.poses && m.poses->start != NULL);
    unmatch(&m);
}

static void test_refused(void)
{
    static const struct {
        const char *name, *text, *where, *says;
    } cases[] = {
        {"start.csv", "type,x_m,y_m,z_m\nbuoy,1,1,1\n", "start.csv:2",
         "buoy is no type of the scene's sensors"},
        {"start.csv", "type,x_m,y_m\nnode,1,1\n", "start.csv",
         "misses column z_m"},
        {"start.csv", "type,x_m,y_m,z_m\nnode,1,1,9\n", "start.csv:2",
         "lies outside the domain"},
        {"start.json", "{\"places\": []}", "start.json",
         "has no list \"sensors\""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        matched m = match(cases[i].name, cases[i].text, "  count: 2\n");
        CHECK(m.status != MURK_OK);
        CHECK_MENTIONS(m.err.where, cases[i].where);
        CHECK_MENTIONS(m.err.text, cases[i].says);
        unmatch(&m);
    }
}

int main(void)
{
    if (!mkdtemp(folder)) {
        perror(folder);
        return 1;
    }
    test_exact();
    test_nearest();
    test_far_and_twice();
    test_fixed();
    test_no_sensors();
    test_refused();
    (void)rmdir(folder);
    return check_done();
}
