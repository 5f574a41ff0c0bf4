/* Candidates of a scene, from its keys and files to usable sites: which grid
 * carries reach, what files hold, what zones keep out, and messages at the
 * scene's own places. Nothing here is random. */
#define _DEFAULT_SOURCE /* mkdtemp */
#include "check.h"
#include "plan/sites.h"
#include "stage_text.h"
#include "written.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static char folder[] = "/tmp/murk_test_sites_XXXXXX";
static char surveyed[64], crate[64];

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [4, 3, 2.5]}\n"
    "materials: {wood: {diffuse: 0.4}}\n"
    "geometry:\n"
    "  - {box: {min_m: [0, 0, 0], max_m: [4, 3, 2.5]}}\n"
    "  - {box: {min_m: [2, 1, 0], max_m: [3, 2, 1]}, material: wood}\n"
    "lights: [{type: point, position_m: [1, 1, 2.2], power_w: 8}]\n"
    "photons: {emit: 300}\n"
    "sensors: {types: [{name: node, range_m: 1}], count: 1}\n";

/* With err, it must fail so. */
static murk_candidates *sites_of(const char *candidates, unsigned threads,
                                 murk_error *err)
{
    char text[512];
    snprintf(text, sizeof text, "sensors.candidates=%s", candidates);
    murk_stage *stage =
        stage_text_create(scene_text, (const char *const[]){text, NULL});
    murk_candidates *sites = NULL;
    murk_error found_err = {0};
    CHECK(stage != NULL);
    const murk_status status =
        stage ? murk_sites_find(&sites, stage, threads, &found_err)
              : MURK_BAD_VALUE;
    CHECK((status != MURK_OK) == (err != NULL));
    if (err) {
        *err = found_err;
    } else {
        CHECK_TEXT(found_err.text, "");
    }
    stage_text_destroy(stage);
    return sites;
}

static void check_counts(const char *candidates, size_t asked, size_t usable)
{
    murk_candidates *c = sites_of(candidates, 2, NULL);
    if (!c || c->asked != asked || c->usable != usable) {
        printf("%s: %zu asked, %zu usable, want %zu and %zu\n", candidates,
               c ? c->asked : 0, c ? c->usable : 0, asked, usable);
    }
    CHECK(c && c->asked == asked && c->usable == usable);
    murk_candidates_destroy(c);
}

static void check_refused(const char *candidates, const char *where,
                          const char *text)
{
    murk_error err = {0};
    murk_candidates *c = sites_of(candidates, 1, &err);
    CHECK(c == NULL);
    CHECK_MENTIONS(err.where, where);
    CHECK_MENTIONS(err.text, text);
    murk_candidates_destroy(c);
}

#define GRID \
    "grid: {min_m: [.5, .5, .5], max_m: [3.5, 2.5, 2], size: [7, 5, 4]}"

static void test_sources_join(void)
{
    write_text(surveyed,
               "name,z_m,x_m,y_m\n# behind the door\na,1,.5,.5\nb,.5,2.5,"
               "1.5\n\"c\",1.2,3.25,1.75\n");
    char text[300];
    /* of the grid's 7 x 5 x 4, 3 x 3 x 2 are in or on the crate */
    check_counts("{" GRID "}", 140, 140 - 18);
    snprintf(text, sizeof text, "{" GRID ", points: %s}", surveyed);
    check_counts(text, 143, 122 + 1); /* a is of the grid, b in the crate */
    snprintf(text, sizeof text, "{points: [%s, [1, 1, 1], [.5, .5, 1]]}",
             surveyed);
    check_counts(text, 5, 3);
    check_counts("{mount: {surfaces: [wood], spacing_m: .5}}", 48, 20);
    check_counts("{mount: [{surfaces: [wood], spacing_m: .5}, {surfaces: "
                 "[wood], facing: up, spacing_m: .5}]}",
                 48 + 8, 20);
    check_counts("{mount: {facing: side, z_m: [2, 2], spacing_m: .5}}", 2 * 28,
                 28);
    check_counts("{}", 13 * 10 * 8, 13 * 10 * 8 - 48);
}

/* Zones: a mesh in its own units and place, and a turned box. */
static void test_zones(void)
{
    write_text(crate,
               "v 0 0 0\nv 0 1000 0\nv 1000 0 0\nv 0 0 1000\nf 1 2 3\nf 1 2 "
               "4\nf 1 3 4\nf 2 3 4\n");
    char text[400];
    /* of points .4 m apart from .2 m on, those with x + y + z < .95 */
    snprintf(text, sizeof text,
             "{grid: {min_m: [.2, .2, .2], max_m: [3.8, 2.6, 2.2], spacing_m: "
             ".4}, avoid: [{mesh: %s, unit_m: 0.00095}]}",
             crate);
    murk_candidates *c = sites_of(text, 1, NULL);
    CHECK(c && c->forbidden == 1);
    murk_candidates_destroy(c);
    snprintf(text, sizeof text,
             "{grid: {min_m: [.2, .2, .2], max_m: [3.8, 2.6, 2.2], spacing_m: "
             ".4}, within: [{mesh: %s, unit_m: 0.001, scale: 1.5, "
             "translate_m: [0, 0, .05]}]}",
             crate);
    c = sites_of(text, 1, NULL); /* now those with x + y + z < 1.55 */
    CHECK(c && c->usable == 10);
    murk_candidates_destroy(c);
    c = sites_of("{" GRID ", within: [{box: {min_m: [0, 0, 0], max_m: [1.1, "
                 "1.1, 3]}, rotate_deg: [0, 0, 90], translate_m: [1.1, 0, 0]}, "
                 "{sphere: {center_m: [3.5, 2.5, 2], radius_m: .5}}]}",
                 1, NULL);
    CHECK(c && c->usable == 2 * 2 * 4 + 4);
    murk_candidates_destroy(c);
}

static void test_bad_files_are_named(void)
{
    char text[300], where[100];
    snprintf(text, sizeof text, "{points: %s}", surveyed);
    write_text(surveyed, "x_m,y_m,z_m\n1,1,1\n1,1,high\n");
    snprintf(where, sizeof where, "%s:3: z_m", surveyed);
    check_refused(text, where, "high");
    write_text(surveyed, "x_m,y_m,z_m\n1,1,1\n\n1,,1\n");
    snprintf(where, sizeof where, "%s:4: y_m", surveyed);
    check_refused(text, where, "");
    write_text(surveyed, "x_m,y_m,z_m\n1,1,1\n1,1,2.6\n");
    snprintf(where, sizeof where, "%s:3", surveyed);
    check_refused(text, where,
                  "[1, 1, 2.6] m is outside the domain, [0, 0, "
                  "0] to [4, 3, 2.5] m");
    write_text(surveyed, "x_m,y_m,height\n1,1,1\n");
    check_refused(text, surveyed, "misses column z_m");
    write_text(surveyed, "x_m,y_m,z_m\n");
    check_refused(text, surveyed, "lists no points");
    unlink(surveyed);
    check_refused(text, surveyed, "");
    check_refused("{points: [[9, 1, 1]]}", "sensors.candidates",
                  "[9, 1, 1] m is outside the domain");
}

static void test_bad_mounts_are_named(void)
{
    check_refused("{mount: [{}, {surfaces: [wood], z_m: [2, 3]}]}",
                  "sensors.candidates", "nothing to mount on");
    check_refused("{mount: {spacing_m: 1e-5}}", "sensors.candidates",
                  "spacing_m is 1e-05 m, must be more than 3.05e-05 m");
    check_refused("{mount: {spacing_m: 1e-4}}", "sensors.candidates",
                  "lays more than 5000000 places");
    check_refused("{mount: {offset_m: 1e-5}}", "sensors.candidates",
                  "offset_m is 1e-05 m");
    check_refused("{mount: {surfaces: [wood]}, clearance_m: 3}",
                  "sensors.candidates",
                  "none of the 12 candidates is usable: 7 out of reach");
}

/* A room with one window above the plane of the candidates: no straight
 * path along an axis leads out, but light that is aimed at the window comes
 * in through it. This holds for lights that are off, too. */
static void test_a_window_lets_reach_in(void)
{
    /* A closed room, lit through the window by light from outside. */
    static const char text[] =
        "murk: 1\n"
        "domain: {min_m: [-2, -1, -1], max_m: [5, 4, 4]}\n"
        "materials: {pane: {transmit: 0.9}}\n"
        "geometry:\n"
        "  - {rect: {corner_m: [0, 0, 0], edge1_m: [4, 0, 0], "
        "edge2_m: [0, 3, 0]}}\n"
        "  - {rect: {corner_m: [0, 0, 3], edge1_m: [4, 0, 0], "
        "edge2_m: [0, 3, 0]}}\n"
        "  - {rect: {corner_m: [0, 0, 0], edge1_m: [4, 0, 0], "
        "edge2_m: [0, 0, 3]}}\n"
        "  - {rect: {corner_m: [0, 3, 0], edge1_m: [4, 0, 0], "
        "edge2_m: [0, 0, 3]}}\n"
        "  - {rect: {corner_m: [4, 0, 0], edge1_m: [0, 3, 0], "
        "edge2_m: [0, 0, 3]}}\n"
        "  - {rect: {corner_m: [0, 0, 0], edge1_m: [0, 3, 0], "
        "edge2_m: [0, 0, 2]}}\n"
        "  - {rect: {corner_m: [0, 0, 2], edge1_m: [0, 3, 0], "
        "edge2_m: [0, 0, 1]}, material: pane}\n"
        "lights: [{type: directional, direction: [1, 0, -1], "
        "irradiance_w_per_m2: 8}]\n"
        "photons: {emit: 300}\n"
        "sensors: {types: [{name: node, range_m: 1}], count: 1, candidates: "
        "{grid: {min_m: [0.5, 0.5, 0.5], max_m: [3.5, 2.5, 1.5], size: [3, 3, "
        "2]}}}\n";
    /* Without an aim no candidate is usable; with one all are, also if the
     * light is off. */
    const char *const aim =
        "lights.0.aim=[{corner_m: [0, 0, 2], edge1_m: [0, 3, 0], edge2_m: [0, "
        "0, 1]}]";
    const char *const overrides[3][3] = {
        {NULL}, {aim, NULL}, {aim, "lights.0.schedule=never", NULL}};
    const size_t want[3] = {0, 18, 18};
    for (int i = 0; i < 3; ++i) {
        /* Candidates are found, or the search fails. */
        murk_stage *stage = stage_text_create(text, overrides[i]);
        murk_candidates *sites = NULL;
        murk_error err = {0};
        CHECK(stage != NULL);
        const murk_status status =
            stage ? murk_sites_find(&sites, stage, 1, &err) : MURK_BAD_VALUE;
        CHECK((status == MURK_OK) == (want[i] > 0));
        CHECK(status || sites->usable == want[i]);
        murk_candidates_destroy(sites);
        stage_text_destroy(stage);
    }
}

int main(void)
{
    if (!mkdtemp(folder)) {
        check_skip("no temporary folder");
    }
    snprintf(surveyed, sizeof surveyed, "%s/surveyed.csv", folder);
    snprintf(crate, sizeof crate, "%s/crate.obj", folder);
    test_a_window_lets_reach_in();
    test_sources_join();
    test_zones();
    test_bad_files_are_named();
    test_bad_mounts_are_named();
    unlink(surveyed);
    unlink(crate);
    rmdir(folder);
    return check_done();
}
