/* Cameras that pictures are taken by. Whether they stand within the domain is
 * looked at where that is known. */
#include <float.h>
#include <string.h>

#include "scene/keys_rows.h"

/* Of one picture. */
#define PIXELS_MAX (1u << 26)

static murk_status check_camera(murk_walk *walk, const murk_yaml *map,
                                void *item)
{
    const murk_scene_camera *camera = item;
    const murk_vec3 way = murk_sub(camera->to, camera->from);
    if (!(murk_length(way) > 0)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "from_m and to_m are both [%.9g, %.9g, %.9g] m, "
                              "must be apart",
                              camera->to.x, camera->to.y, camera->to.z);
    }
    const double across = murk_length(murk_cross(way, camera->up));
    /* what rounding leaves of the product of parallel vectors */
    const double slack =
        4 * DBL_EPSILON * murk_length(way) * murk_length(camera->up);
    if (!(across > slack)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "up is [%.9g, %.9g, %.9g], must not be zero or "
                              "along the way it looks",
                              camera->up.x, camera->up.y, camera->up.z);
    }
    if ((double)camera->pixels[0] * (double)camera->pixels[1] > PIXELS_MAX) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "pixels are %zu x %zu, must be %u or fewer "
                              "together",
                              camera->pixels[0], camera->pixels[1], PIXELS_MAX);
    }
    for (const murk_scene_camera *other = walk->scene->cameras; other < camera;
         ++other) {
        if (strcmp(other->name, camera->name) == 0) {
            return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                                  "name: %s is the name of an earlier camera, "
                                  "must be one's own",
                                  camera->name);
        }
    }
    return MURK_OK;
}

static const murk_key CAMERA_ROWS[] = {
    ROW("name", TEXT, NEEDED, AT(murk_scene_camera, name)),
    ROW("from_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_camera, from)),
    ROW("to_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_camera, to)),
    ROW("up", VECTOR, ANY_UNIT, .preset = "[0, 0, 1]",
        AT(murk_scene_camera, up)),
    ROW("vfov_deg", NUMBER, .above = true, .below = true, .most = 180,
        .unit = "degrees", .factor = MURK_PI / 180, .preset = "45",
        AT(murk_scene_camera, vfov_rad)),
    ROW("pixels", SIZES, .least = 1, .most = 65536, .unit = "pixels",
        .preset = "[640, 480]", AT(murk_scene_camera, pixels)),
    ROW("samples", COUNT, .least = 1, .most = 65536, .unit = "samples",
        .preset = "16", AT(murk_scene_camera, samples)),
    END,
};

const murk_keys murk_camera_keys = {
    .noun = "camera",
    .check = check_camera,
    WHERE(murk_scene_camera, where),
    ITEMS(murk_scene_camera, cameras, n_cameras),
    .most_items = 256,
    .key = CAMERA_ROWS,
};
