/* Keys of cameras. Whether a camera is inside the domain is checked later,
 * when the domain is known. */
#include "scene/keys_rows.h"

#include <float.h>

/* Largest number of pixels of one picture: 67 megapixels, to bound memory. */
#define PIXELS_MAX (1u << 26)

static murk_status check_direction(murk_key_reader *walk, const murk_yaml *map,
                                   const murk_scene_camera *camera)
{
    const bool is_all_round = camera->projection == MURK_SCENE_EQUIRECTANGULAR;
    const murk_vec3 up = is_all_round ? murk_vec(0, 0, 1) : camera->up;
    const murk_vec3 direction = murk_sub(camera->to, camera->from);
    if (!(murk_length(direction) > 0)) {
        return murk_walk_fail(
            walk, map,
            "from_m and to_m are both [%.9g, %.9g, %.9g] m, must be apart",
            camera->to.x, camera->to.y, camera->to.z);
    }
    const double across = murk_length(murk_cross(direction, up));
    /* rounding of the product of parallel vectors */
    const double slack =
        4 * DBL_EPSILON * murk_length(direction) * murk_length(up);
    if (across > slack) {
        return MURK_OK;
    }
    if (is_all_round) {
        return murk_walk_fail(walk, map,
                              "to_m is straight above or below from_m, must be "
                              "to one side: it says what is in the middle");
    }
    return murk_walk_fail(
        walk, map,
        "up is [%.9g, %.9g, %.9g], must not be zero or along the way it looks",
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
    if ((double)camera->pixels[0] * (double)camera->pixels[1] > PIXELS_MAX) {
        return murk_walk_fail(
            walk, map, "pixels are %zu x %zu, must be %u or fewer together",
            camera->pixels[0], camera->pixels[1], PIXELS_MAX);
    }
    return murk_check_own_name(walk, map, "camera", walk->scene->cameras,
                               sizeof *camera, camera);
}

#define CAMERA(member) AT(murk_scene_camera, member)

#define PERSPECTIVE  .variants = BIT(MURK_SCENE_PERSPECTIVE)
#define ORTHOGRAPHIC .variants = BIT(MURK_SCENE_ORTHOGRAPHIC)
#define FLAT \
    .variants = BIT(MURK_SCENE_PERSPECTIVE) | BIT(MURK_SCENE_ORTHOGRAPHIC)
#define ALL_ROUND .variants = BIT(MURK_SCENE_EQUIRECTANGULAR)
#define TO        PLACE_M, FLAG(murk_scene_camera, has_to), CAMERA(to)
/* Longer edges are mistakes; PIXELS_MAX limits the product. */
#define PIXELS .min = 1, .max = 65536, .unit = "pixels", CAMERA(pixels)

static murk_status check_clip(murk_key_reader *walk, const murk_yaml *map,
                              void *item)
{
    const murk_scene_camera *camera = item;
    return murk_length(camera->clip_normal) > 0
               ? MURK_OK
               : murk_walk_fail(walk, map,
                                "normal is [0, 0, 0], must have a length");
}

static const murk_key CLIP_ROWS[] = {
    ROW("point_m", VECTOR, NEEDED, PLACE_M, CAMERA(clip_point)),
    ROW("normal", VECTOR, NEEDED, ANY_UNIT, CAMERA(clip_normal)),
    END,
};

static const murk_keys CLIP = {
    .noun = "clip plane",
    .check = check_clip,
    .key = CLIP_ROWS,
};

static const murk_key CAMERA_ROWS[] = {
    ROW("name", TEXT, NEEDED, CAMERA(name)),
    ROW("type", WORD, .preset = "perspective",
        WORDS({"perspective", MURK_SCENE_PERSPECTIVE},
              {"equirectangular", MURK_SCENE_EQUIRECTANGULAR},
              {"orthographic", MURK_SCENE_ORTHOGRAPHIC})),
    ROW("from_m", VECTOR, NEEDED, PLACE_M, CAMERA(from)),
    ROW("to_m", VECTOR, NEEDED, FLAT, TO),
    ROW("to_m", VECTOR, ALL_ROUND, TO),
    ROW("up", VECTOR, ANY_UNIT, .preset = "[0, 0, 1]", FLAT, CAMERA(up)),
    ROW("vfov_deg", NUMBER, PERSPECTIVE, .above = true, .below = true,
        .max = 180, RADIANS, .preset = "45", CAMERA(vfov_rad)),
    ROW("width_m", NUMBER, NEEDED, ORTHOGRAPHIC, SIZE_M, CAMERA(width_m)),
    ROW("pixels", SIZES, .preset = "[640, 480]", FLAT, PIXELS),
    ROW("pixels", SIZES, .preset = "[640, 320]", ALL_ROUND, PIXELS),
    ROW("samples", COUNT, .min = 1, .max = 65536, .unit = "samples",
        .preset = "16", CAMERA(samples)),
    ROW("clip", MAP, .keys = &CLIP, FLAG(murk_scene_camera, has_clip)),
    END,
};

const murk_keys murk_camera_keys = {
    .noun = "camera",
    .selector = "type",
    VARIANT(murk_scene_camera, projection),
    .check = check_camera,
    WHERE(murk_scene_camera, where),
    ITEMS(murk_scene_desc, cameras, n_cameras),
    .max_items = 256,
    .key = CAMERA_ROWS,
};
