/* Photons of a light.murk for a view: all of them in their order, or evenly
 * chosen of both maps together; what is no such file is refused. Nothing here
 * is random. */
#include "check.h"
#include "photonmap/map_file.h"
#include "photonmap/photon.h"
#include "report/plan_points.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SURFACE 700
#define VOLUME  300

static char path[64];

/* Photon i of all lies at x = i. */
static void write_light(const char *second)
{
    murk_photon *photon = calloc(SURFACE + VOLUME, sizeof *photon);
    CHECK(photon != NULL);
    for (size_t i = 0; i < SURFACE + VOLUME; ++i) {
        photon[i].position_m[0] = (float)i;
        photon[i].kind = murk_photon_kind(i >= SURFACE, 0);
    }
    murk_section section[2] = {
        {.name = "surface", .bytes = photon, .size = SURFACE * sizeof *photon},
        {.bytes = photon + SURFACE, .size = VOLUME * sizeof *photon}};
    snprintf(section[1].name, sizeof section[1].name, "%s", second);
    CHECK(murk_map_file_write(path, section, 2, NULL) == MURK_OK);
    free(photon);
}

static void test_all_in_order(void)
{
    murk_plan_points points;
    write_light("volume");
    CHECK(murk_plan_points_of_light(&points, path, 5000, NULL) == MURK_OK);
    CHECK(points.photons == SURFACE + VOLUME && points.n == points.photons);
    for (size_t i = 0; i < points.n; ++i) {
        CHECK(fabsf(points.point[i].place_m[0] - (float)i) < 0.5F);
        CHECK(points.point[i].is_volume == (i >= SURFACE));
        CHECK(points.point[i].seen_by == 0 && points.point[i].sensors == 0);
    }
    murk_plan_points_release(&points);
}

/* k * photons / n, rounded down: steps of two sizes that differ by one. */
static void test_evenly_chosen(void)
{
    const size_t max[] = {1, 7, 64, 333, 999};
    for (size_t m = 0; m < sizeof max / sizeof *max; ++m) {
        murk_plan_points points;
        CHECK(murk_plan_points_of_light(&points, path, max[m], NULL) ==
              MURK_OK);
        CHECK(points.n == max[m] && points.photons == SURFACE + VOLUME);
        const size_t step = (SURFACE + VOLUME) / max[m];
        size_t in_volume = 0;
        for (size_t i = 0; i < points.n; ++i) {
            const double x = (double)points.point[i].place_m[0];
            const double before = i > 0 ? (double)points.point[i - 1].place_m[0]
                                        : x - (double)step;
            CHECK(x - before >= (double)step && x - before <= (double)step + 1);
            in_volume += points.point[i].is_volume;
        }
        CHECK(fabs((double)in_volume -
                   (double)(max[m] * VOLUME) / (SURFACE + VOLUME)) <= 1);
        murk_plan_points_release(&points);
    }
}

static void test_others_are_refused(void)
{
    murk_plan_points points;
    murk_error err = {0};
    write_light("depths");
    CHECK(murk_plan_points_of_light(&points, path, 10, &err) == MURK_BAD_FILE);
    CHECK(strcmp(err.text, "has no volume map") == 0);
    murk_plan_points_release(&points);
    CHECK(truncate(path, 100) == 0);
    CHECK(murk_plan_points_of_light(&points, path, 10, NULL) == MURK_BAD_FILE);
    murk_plan_points_release(&points);
    CHECK(murk_plan_points_read(&points, path, NULL, 10, NULL) ==
          MURK_BAD_FILE);
    murk_plan_points_release(&points);
}

int main(void)
{
    snprintf(path, sizeof path, "test_plan_points_%ld.murk", (long)getpid());
    test_all_in_order();
    test_evenly_chosen();
    test_others_are_refused();
    remove(path);
    return check_done();
}
