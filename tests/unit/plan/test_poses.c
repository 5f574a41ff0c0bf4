/* Candidates and rules of a scene's sensors. Nothing here is random. */
#include "check.h"
#include "plan/poses.h"
#include "stage_text.h"

#include <stdio.h>
#include <string.h>

#define HEAD                                                       \
    "murk: 1\n"                                                    \
    "domain: {min_m: [0, 0, 0], max_m: [4, 4, 3]}\n"               \
    "lights: [{type: point, position_m: [1, 1, 1], power_w: 8}]\n" \
    "sensors:\n"

static const murk_vec3 site[3] = {{1, 1, 1}, {2, 1, 1}, {3, 1, 1}};

typedef struct made {
    murk_stage *stage;
    murk_poses *poses;
    murk_error err;
} made;

static made make(const char *sensors)
{
    char text[2048];
    const char *const none[] = {NULL};
    made m = {0};
    snprintf(text, sizeof text, HEAD "%s", sensors);
    m.stage = stage_text_create(text, none);
    CHECK(m.stage != NULL);
    if (m.stage) {
        (void)murk_poses_create(&m.poses, m.stage->scene,
                                &m.stage->world.domain, site, 3, &m.err);
    }
    return m;
}

static void unmake(made *m)
{
    murk_poses_destroy(m->poses);
    stage_text_destroy(m->stage);
}

static bool is_angle(double rad, double deg)
{
    return fabs(rad * 180 / MURK_PI - deg) < 1e-12;
}

static void test_every_type_heading_and_tilt_at_every_site(void)
{
    /* Three types: one without direction, one with four headings and two
     * tilts, one with a given heading. */
    made m = make("  types:\n"
                  "    - {name: node, range_m: 2}\n"
                  "    - {name: cam, range_m: 9, view: {cone_deg: 40}, "
                  "headings: 4, tilts_deg: [0, -30]}\n"
                  "    - {name: spot, range_m: 9, view: {hfov_deg: 40, "
                  "vfov_deg: 20}, headings_deg: [15]}\n");
    /* Ten poses at each of three sites, and no constraints. */
    CHECK_TEXT(m.err.text, "");
    CHECK(m.poses && m.poses->count == 3 * (1 + 4 * 2 + 1));
    CHECK(m.poses && murk_poses_constraints(m.poses) == NULL);
    /* Poses of a site are in the order of types, headings and tilts. */
    for (size_t s = 0; m.poses && s < 3; ++s) {
        const murk_pose *pose = m.poses->pose + 10 * s;
        for (size_t k = 0; k < 10; ++k) {
            CHECK(pose[k].position.x == site[s].x);
            CHECK(pose[k].type == (k == 0 ? 0u : k == 9 ? 2u : 1u));
            CHECK(m.poses->site[10 * s + k] == s);
        }
        CHECK(is_angle(pose[1].heading_rad, 0) &&
              is_angle(pose[1].tilt_rad, 0));
        CHECK(is_angle(pose[4].heading_rad, 90) &&
              is_angle(pose[4].tilt_rad, -30));
        CHECK(is_angle(pose[9].heading_rad, 15));
    }
    unmake(&m);
}

static void test_constraints_are_the_scenes(void)
{
    /* A scene with every kind of constraint. */
    made m = make("  types:\n"
                  "    - {name: node, range_m: 2, cost: 0.1, least_count: 1}\n"
                  "    - {name: cam, range_m: 9, cost: 3, max_count: 2, view: "
                  "{cone_deg: 40}, headings: 2}\n"
                  "  fixed: [{type: cam, position_m: [2, 1, 1], heading_deg: "
                  "45}, {type: node, position_m: [0.5, 3, 1]}]\n"
                  "  candidates: {spacing_m: 0.5}\n"
                  "  one_per_site: true\n"
                  "  budget: 6.3\n");
    CHECK_TEXT(m.err.text, "");
    const murk_constraints *r =
        m.poses ? murk_poses_constraints(m.poses) : NULL;
    CHECK(r && m.poses->count == 3 * 3 + 2);
    /* Classes are types; costs and budget are in millionths. */
    if (r) {
        CHECK(r->classes == 2 && r->min[0] == 1 && r->min[1] == 0);
        CHECK(r->max[0] == 11 && r->max[1] == 2);
        CHECK(r->cost[0] == 100000 && r->cost[1] == 3000000);
        CHECK(r->budget == 6300000 && r->spacing_m == 0.5);
        /* Fixed sensors follow the candidates, cost nothing, and have the
         * site number of their place, or a new one. */
        CHECK(r->fixed_count == 2 && r->fixed[0] == 9 && r->fixed[1] == 10);
        CHECK(r->cost[9] == 0 && r->cost[10] == 0);
        CHECK(r->site[3] == 1 && r->site[9] == 1 && r->site[10] > 2);
        CHECK(r->class_of[9] == 1 && r->class_of[10] == 0);
        CHECK(r->position_m[10][1] == 3);
        CHECK(is_angle(m.poses->pose[9].heading_rad, 45));
    }
    unmake(&m);
}

static void check_refused(const char *sensors, const char *where,
                          const char *text)
{
    made m = make(sensors);
    CHECK(m.poses == NULL);
    CHECK_MENTIONS(m.err.where, where);
    CHECK_TEXT(m.err.text, text);
    unmake(&m);
}

static void test_what_cannot_be_is_refused(void)
{
    check_refused("  types: [{name: a, range_m: 1}]\n  count: 4\n", "sensors",
                  "count: 4 sensors, but only 3 candidates");
    check_refused("  types: [{name: a, range_m: 1, least_count: 4}]\n",
                  "sensors",
                  "type a must have at least 4 sensors, but has only 3 usable "
                  "candidates");
    /* A budget of less than half a millionth is not "no budget". */
    check_refused("  types: [{name: a, range_m: 1, cost: 1}]\n"
                  "  budget: 1e-9\n",
                  "sensors",
                  "budget is 1e-06, but the cheapest candidate costs 1");
    check_refused("  types: [{name: a, range_m: 1}]\n  count: 1\n"
                  "  fixed: [{position_m: [1, 2, 2]}, {position_m: [1, 2, "
                  "1]}]\n",
                  "sensors",
                  "1 sensors asked for, but fixed sensors and least counts "
                  "need 2");
    check_refused("  types: [{name: a, range_m: 1}]\n"
                  "  fixed: [{position_m: [1, 2, 3.5]}]\n",
                  "sensors.fixed.0",
                  "position_m: [1, 2, 3.5] m lies outside the domain, [0, 0, "
                  "0] to [4, 4, 3] m");
}

int main(void)
{
    test_every_type_heading_and_tilt_at_every_site();
    test_constraints_are_the_scenes();
    test_what_cannot_be_is_refused();
    return check_done();
}
