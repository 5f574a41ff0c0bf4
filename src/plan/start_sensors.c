/* Reads the sensors at which a search begins. A sensor that has drifted stands
 * where no candidate is, so its pose becomes a candidate, unless the sensor has
 * left the domain or the space in which the sites lie. */
#include "plan/start_sensors.h"

#include "base/log.h"
#include "base/position.h"
#include "plan/placement_in.h"

#include <stdlib.h>

/* True if an open straight line joins the position to a usable site: sites lie
 * in free space, so the position does, too. */
static bool is_usable(murk_vec3 x, const murk_stage *stage,
                      const murk_candidates *sites)
{
    if (!murk_box_contains(&stage->world.domain.box, x)) {
        return false;
    }
    size_t i = 0;
    while (
        i < sites->usable &&
        murk_surfaces_blocked(stage->surfaces, x, sites->position[i], true)) {
        ++i;
    }
    return i < sites->usable;
}

murk_status murk_start_sensors_read(murk_start_sensors *out,
                                    const murk_stage *stage,
                                    const murk_candidates *sites,
                                    murk_error *err)
{
    const char *path = stage->scene->placement.start_plan;
    bool *is_drifted = NULL;
    size_t n = 0;
    *out = (murk_start_sensors){0};
    if (!path) {
        return MURK_OK;
    }
    murk_status status =
        murk_placement_read_start(&out->pose, &is_drifted, &n, path,
                                  stage->scene, &stage->world.domain, err);
    out->drifted = calloc(n + 1, sizeof *out->drifted);
    if (!status && !out->drifted) {
        status = murk_no_memory(err, path, "for %zu sensors", n);
    }
    /* Leave out sensors that cannot stay; the poses of the others that have
     * drifted become candidates. */
    for (size_t i = 0; i < n && !status; ++i) {
        const murk_pose pose = out->pose[i];
        if (is_drifted[i] && !is_usable(pose.position, stage, sites)) {
            murk_warn("placement.start_plan",
                      "%s: sensor %zu has drifted to %s m, which is outside "
                      "of the domain or behind a surface; another pose takes "
                      "its place",
                      path, i + 1, murk_position_show(pose.position).text);
            continue;
        }
        out->pose[out->n++] = pose;
        if (is_drifted[i]) {
            out->drifted[out->n_drifted++] = pose;
        }
    }
    free(is_drifted);
    return status;
}

void murk_start_sensors_release(murk_start_sensors *start)
{
    free(start->pose);
    free(start->drifted);
    *start = (murk_start_sensors){0};
}
