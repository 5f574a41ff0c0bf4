/* Reads plan.ply and light.murk: photons, and from plan.ply which sensors see
 * each. */
#ifndef MURK_REPORT_PLAN_POINTS_H
#define MURK_REPORT_PLAN_POINTS_H

#include "base/status.h"
#include "scene/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct murk_plan_point {
    float place_m[3];
    uint32_t sensors; /* bit k: sensor k, of the first 32, sees the photon */
    uint16_t seen_by;
    bool is_volume;
} murk_plan_point;

typedef struct murk_plan_points {
    uint64_t photons; /* in the file; of plan.ply, those with a place that
                         can be drawn */
    size_t n; /* photons in point[]: evenly chosen among those of the file, in
                 the order of the file, in which neighbours are near in space */
    murk_plan_point *point; /* [n] */
} murk_plan_points;

/* Reads at most `max` photons of a plan.ply. The file is read vertex by vertex,
 * so memory does not depend on its size. Fails with MURK_BAD_FILE if it is not
 * a plan.ply as results/plan_ply.h describes it, or is cut short, or with
 * MURK_NO_MEMORY. Release *out in any case. */
murk_status murk_plan_points_read(murk_plan_points *out, const char *path,
                                  const murk_scene_desc *scene, size_t max,
                                  murk_error *err);

/* Reads at most `max` photons of a light.murk: photons of the surface map, then
 * of the volume map. seen_by and sensors are 0, and a coordinate beyond 1e12 m
 * becomes 0. Fails with MURK_BAD_FILE if the file cannot be read, has not both
 * maps, or is above 2 GB, or with MURK_NO_MEMORY. Release *out in any case. */
murk_status murk_plan_points_of_light(murk_plan_points *out, const char *path,
                                      size_t max, murk_error *err);

void murk_plan_points_release(murk_plan_points *points);

/* Reads the header of a PLY file, finds the number of vertices, and moves to
 * the byte after the header. False if the header does not begin with `begin`,
 * is longer than 2048 bytes, or if the vertices do not have a position as files
 * of this scene have it, followed by `properties`. More properties may follow.
 */
bool murk_ply_begin(FILE *file, uint64_t *vertices, const char *begin,
                    const char *properties, const murk_scene_desc *scene);

#endif
