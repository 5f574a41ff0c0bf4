/* Keys of cameras. Whether a camera is inside the domain is checked later,
 * when the domain is known. */
#include <float.h>
#include <string.h>

#include "scene/keys_rows.h"

/* Largest number of pixels of one picture: 67 megapixels, to bound memory. */
#define PIXELS_MAX (1u << 26)

static const char *const CAMERA_VARIANTS[] = {"perspective", "equirectangular"};

#define PERSPECTIVE .variants = BIT(MURK_SCENE_PERSPECTIVE)
#define ALL_ROUND   .variants = BIT(MURK_SCENE_EQUIRECTANGULAR)

static const murk_word PROJECTION_WORDS[] = {
    {"perspective", MURK_SCENE_PERSPECTIVE},
    {"equirectangular", MURK_SCENE_EQUIRECTANGULAR},
    WORDS_END,
};

static murk_status check_direction(murk_key_reader *walk, const murk_yaml *map,
                                   const murk_scene_camera *camera)
{
    const bool is_all_round = camera->projection == MURK_SCENE_EQUIRECTANGULAR;
    const murk_vec3 up = is_all_round ? murk_vec(0, 0, 1) : camera->up;
    const murk_vec3 way = murk_sub(camera->to, camera->from);
    if (!(murk_length(way) > 0)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "from_m and to_m are both [%.9g, %.9g, %.9g] m, "
                              "must be apart",
                              camera->to.x, camera->to.y, camera->to.z);
    }
    const double across = murk_length(murk_cross(way, up));
    /* rounding of the product of parallel vectors */
    const double slack = 4 * DBL_EPSILON * murk_length(way) * murk_length(up);
    if (across > slack) {
        return MURK_OK;
    }
    if (is_all_round) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "to_m is straight above or below from_m, must "
                              "be to one side: it says what is in the middle");
    }
    return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                          "up is [%.9g, %.9g, %.9g], must not be zero or "
                          "along the way it looks",
                          up.x, up.y, up.z);
}

static murk_status check_camera(murk_key_reader *walk, const murk_yaml *map,
                                void *item)
{
    const murk_scene_camera *camera = item;
    const murk_status status =
        camera->has_to ? check_direction(walk, map, camera) : MURK_OK;
    if (status) {
        return status;
    }
    /* Size of the picture, then the name, which must be unique. */
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
    ROW("type", WORD, .preset = "perspective", .words = PROJECTION_WORDS),
    ROW("from_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_camera, from)),
    ROW("to_m", VECTOR, NEEDED, LONG_M, PERSPECTIVE,
        FLAG(murk_scene_camera, has_to), AT(murk_scene_camera, to)),
    ROW("to_m", VECTOR, LONG_M, ALL_ROUND, FLAG(murk_scene_camera, has_to),
        AT(murk_scene_camera, to)),
    ROW("up", VECTOR, ANY_UNIT, .preset = "[0, 0, 1]", PERSPECTIVE,
        AT(murk_scene_camera, up)),
    ROW("vfov_deg", NUMBER, PERSPECTIVE, .above = true, .below = true,
        .max = 180, .unit = "degrees", .factor = MURK_PI / 180, .preset = "45",
        AT(murk_scene_camera, vfov_rad)),
    ROW("pixels", SIZES, .min = 1, .max = 65536, .unit = "pixels",
        .preset = "[640, 480]", PERSPECTIVE, AT(murk_scene_camera, pixels)),
    ROW("pixels", SIZES, .min = 1, .max = 65536, .unit = "pixels",
        .preset = "[640, 320]", ALL_ROUND, AT(murk_scene_camera, pixels)),
    ROW("samples", COUNT, .min = 1, .max = 65536, .unit = "samples",
        .preset = "16", AT(murk_scene_camera, samples)),
    END,
};

const murk_keys murk_camera_keys = {
    .noun = "camera",
    .selector = "type",
    .variant_names = CAMERA_VARIANTS,
    VARIANT(murk_scene_camera, projection),
    .check = check_camera,
    WHERE(murk_scene_camera, where),
    ITEMS(murk_scene_camera, cameras, n_cameras),
    .max_items = 256,
    .key = CAMERA_ROWS,
};
