/* Depths and sheets of seen sightlines are what looks round. */
#include "check.h"
#include "plan/plan.h"
#include "sensing/sight.h"
#include "stage_text.h"

#include <stdlib.h>

static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [6, 4, 3]}\n"
    "geometry:\n"
    "  - {rect: {corner_m: [0, 0, 0.2], edge1_m: [6, 0, 0],"
    " edge2_m: [0, 4, 0]}, material: floor}\n"
    "  - {rect: {corner_m: [3, 0, 0.2], edge1_m: [0, 3, 0],"
    " edge2_m: [0, 0, 2]}, material: pane}\n"
    "materials: {floor: {diffuse: 0.7}, pane: {transmit: 0.6}}\n"
    "media:\n"
    "  fog: {extinction_per_m: 0.4, albedo: 0.9, phase: isotropic}\n"
    "  smoke: {extinction_per_m: 0.8, albedo: 0.9, phase: isotropic}\n"
    "regions:\n"
    "  - {medium: fog}\n"
    "  - {medium: smoke, sphere: {center_m: [2, 2, 1], radius_m: 0.8}}\n"
    "lights:\n"
    "  - {type: point, position_m: [1, 1, 2], power_w: 1}\n"
    "photons: {emit: 1000}\n"
    "sensors: {types: [{name: node, range_m: 5}]}\n";

/* Clarity is a whole multiple of 1/65535, and the transmittance from depths
 * and sheets is not rounded: both agree within the rounding. */
static void check_queries(const char *override, bool has_sheets)
{
    /* The row of one sensor in the traced scene. */
    const char *const overrides[] = {override, NULL};
    const murk_pose pose = {.position = {4.5, 1.5, 1}};
    murk_stage *stage = stage_text_create(scene_text, overrides);
    murk_traced *traced = NULL;
    murk_sight *sight = NULL;
    murk_sparse_row row;
    CHECK(stage && !murk_lightmap_trace(&traced, stage, 0, 1, NULL) &&
          !murk_plan_sight(&sight, stage, traced, 1, NULL));
    murk_sight_row(sight, 0, &pose, &row);
    CHECK(row.seen > 50 && row.clarity);
    /* Depths along the same sightlines, for the same media twice. */
    const murk_media *const media[2] = {stage->media, stage->media};
    double *depth = malloc(row.seen * 2 * sizeof *depth);
    double *sheets = malloc(row.seen * sizeof *sheets);
    size_t behind = 0;
    murk_sight_depths(depth, sheets, sight, &pose, row.photon, row.seen, media,
                      2);
    /* Both depths are equal, and with the sheets they give the clarity of
     * the row. */
    for (size_t i = 0; i < row.seen; ++i) {
        CHECK(depth[2 * i] == depth[2 * i + 1]);
        CHECK_NEAR(sheets[i] * exp(-depth[2 * i]) * MURK_CLEAR, row.clarity[i],
                   0.5 + 1e-9);
        behind += sheets[i] < 1;
    }
    /* The pane dims some sightlines only where the settings let sight
     * through sheets. */
    CHECK((behind > 0) == has_sheets);
    free(depth);
    free(sheets);
    murk_sight_destroy(sight);
    murk_traced_destroy(traced);
    stage_text_destroy(stage);
}

int main(void)
{
    check_queries("seed=1", true);
    check_queries("domain.sides=periodic", true);
    check_queries("placement.through=block", false);
    check_queries("placement.visibility=normal", false);
    return check_done();
}
