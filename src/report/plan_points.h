/* plan.ply, read back: photons, and which sensors see each. */
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
    uint32_t sensors; /* bit k: sensor k sees it; of the first 32 */
    uint16_t seen_by;
    bool is_volume;
} murk_plan_point;

typedef struct murk_plan_points {
    uint64_t photons;       /* in the file */
    size_t n;               /* of them here, evenly chosen in its order, in
                               which neighbours are neighbours in space */
    murk_plan_point *point; /* [n] */
} murk_plan_points;

/* At most `most` of them; the file is read in pieces, whatever its size. Fails
 * with MURK_BAD_FILE where it is no plan.ply of results/plan_ply.h, or cut
 * short. Release *out in any case. */
murk_status murk_plan_points_read(murk_plan_points *out, const char *path,
                                  const murk_scene_desc *scene, size_t max,
                                  murk_error *err);

/* The same of a light.murk, for which no sensor looked: the surface map, then
 * the volume map. Files above 2 GB fail. */
murk_status murk_plan_points_of_light(murk_plan_points *out, const char *path,
                                      size_t max, murk_error *err);

void murk_plan_points_release(murk_plan_points *points);

/* Moves behind the header of a binary PLY file that begins with a text, and
 * whose vertices are a place of the scene followed by these properties, and
 * finds how many there are. False if the file is another one. */
bool murk_ply_begin(FILE *file, uint64_t *vertices, const char *begin,
                    const char *properties, const murk_scene_desc *scene);

#endif
