/* Keys of targets that plans cover in place of photons: points on surfaces,
 * in a volume, or from a file. */
#include "scene/keys_rows.h"

#define OF(member) AT(murk_scene_desc, placement.targets.member)

/* Number of points; the default if neither number nor spacing is given. */
#define POINTS \
    .min = 1, .max = 1e8, .unit = "points", .group = 1, .preset = "10000"

static const murk_word MATERIALS_WORDS[] = {
    {"all", 0},
    WORDS_END,
};

static const murk_key SURFACES_ROWS[] = {
    ROW("materials", REFERENCES, .of = "materials", .preset = "all",
        .words = MATERIALS_WORDS, OF(materials)),
    ROW("points", COUNT, POINTS, OF(surface_points)),
    ROW("spacing_m", NUMBER, .group = 1, SIZE_M, OF(surface_spacing_m)),
    END,
};

static const murk_keys SURFACES = {
    .noun = "surfaces",
    WHERE(murk_scene_desc, placement.targets.surfaces_where),
    .key = SURFACES_ROWS,
};

/* ---- volume ---- */

static murk_status check_volume_box(murk_key_reader *walk, const murk_yaml *map,
                                    void *item)
{
    return murk_check_box(walk, map,
                          ((murk_scene_desc *)item)->placement.targets.box);
}

static const murk_key VOLUME_BOX_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, LONG_M, OF(box.min)),
    ROW("max_m", VECTOR, NEEDED, LONG_M, OF(box.max)),
    END,
};

static const murk_keys VOLUME_BOX = {
    .noun = "box",
    .check = check_volume_box,
    .key = VOLUME_BOX_ROWS,
};

static const murk_key VOLUME_SPHERE_ROWS[] = {
    ROW("center_m", VECTOR, NEEDED, LONG_M, OF(center)),
    ROW("radius_m", NUMBER, NEEDED, SIZE_M, OF(radius_m)),
    END,
};

static const murk_keys VOLUME_SPHERE = {
    .noun = "sphere",
    .key = VOLUME_SPHERE_ROWS,
};

#define MESH .variants = BIT(MURK_REGION_MESH)

static const murk_key VOLUME_ROWS[] = {
    ROW("box", MAP, .group = 2, .keys = &VOLUME_BOX),
    ROW("sphere", MAP, .group = 2, .keys = &VOLUME_SPHERE),
    ROW("mesh", PATH, .group = 2, OF(mesh)),
    ROW("unit_m", NUMBER, SIZE_M, MESH, OF(unit_m)),
    ROW("up", WORD, MESH, .words = murk_up_words, OF(up)),
    ROW("scale", NUMBER, .above = true, .max = 1e9, MESH, .preset = "1",
        OF(scale)),
    ROW("rotate_deg", VECTOR, ANY_UNIT, MESH, .unit = "degrees",
        .preset = "[0, 0, 0]", OF(rotate_deg)),
    ROW("translate_m", VECTOR, LONG_M, MESH, .preset = "[0, 0, 0]",
        OF(translate_m)),
    ROW("medium", REFERENCE, .of = "media", OF(medium)),
    ROW("points", COUNT, POINTS, OF(volume_points)),
    ROW("spacing_m", NUMBER, .group = 1, SIZE_M, OF(volume_spacing_m)),
    END,
};

static const murk_keys VOLUME = {
    .noun = "volume",
    .choose = murk_choose_zone,
    .variant_names = murk_zone_variants,
    VARIANT(murk_scene_desc, placement.targets.shape),
    WHERE(murk_scene_desc, placement.targets.volume_where),
    .key = VOLUME_ROWS,
};

/* ---- targets ---- */

static murk_status check_targets(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    murk_scene_targets *targets = &((murk_scene_desc *)item)->placement.targets;
    const murk_scene_desc *scene = item;
    targets->given = true;
    /* Targets are drawn, or listed in a file. */
    const bool is_drawn = targets->has_surfaces || targets->has_volume;
    if (!is_drawn && !targets->points) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "names no targets, must have surfaces, volume or "
                              "both, or points");
    }
    if (is_drawn && targets->points) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "has points and others, points must stand "
                              "alone");
    }
    /* The band must be one of the scene's. */
    bool is_band = targets->band_nm == 0;
    for (int i = 0; i < scene->bands; ++i) {
        is_band |= scene->band_nm[i] == targets->band_nm;
    }
    if (!is_band) {
        const size_t back = murk_walk_enter(walk, "band_nm");
        const murk_status status = murk_walk_fail(
            walk, MURK_BAD_VALUE, murk_yaml_get(map, "band_nm"), false,
            "%.9g nm is none of the scene's bands", targets->band_nm);
        murk_walk_leave(walk, back);
        return status;
    }
    return MURK_OK;
}

static const murk_key TARGET_ROWS[] = {
    ROW("surfaces", MAP, .keys = &SURFACES,
        FLAG(murk_scene_desc, placement.targets.has_surfaces)),
    ROW("volume", MAP, .keys = &VOLUME,
        FLAG(murk_scene_desc, placement.targets.has_volume)),
    ROW("points", PATH, OF(points)),
    ROW("band_nm", NUMBER, .above = true, .max = 1e9, .unit = "nm",
        OF(band_nm)),
    END,
};

const murk_keys murk_target_keys = {
    .noun = "targets",
    .check = check_targets,
    WHERE(murk_scene_desc, placement.targets.where),
    .key = TARGET_ROWS,
};
