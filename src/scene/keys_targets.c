/* Keys of targets that plans cover in place of photons: points on surfaces,
 * in a volume, or from a file. */
#include "scene/keys_rows.h"

#define TARGETS(member) AT(murk_scene_targets, member)

/* A number of points; 10000 if neither a number nor a spacing is given. */
#define POINTS \
    .min = 1, .max = 1e8, .unit = "points", .group = 1, .preset = "10000"

static const murk_key SURFACES_ROWS[] = {
    ROW("materials", REFERENCES, .of = "materials", .preset = "all",
        WORDS({"all", 0}), TARGETS(materials)),
    ROW("points", COUNT, POINTS, TARGETS(surface_points)),
    ROW("spacing_m", NUMBER, .group = 1, SIZE_M, TARGETS(surface_spacing_m)),
    END,
};

static const murk_keys SURFACES = {
    .noun = "surfaces",
    WHERE(murk_scene_targets, surfaces_where),
    .key = SURFACES_ROWS,
};

static const murk_key VOLUME_ROWS[] = {
    BOX_ROW(murk_scene_targets, .group = 2),
    SPHERE_ROW(murk_scene_targets, .group = 2),
    MESH_ROWS(murk_scene_targets, .group = 2),
    PLACEMENT_ROWS(murk_scene_targets, .variants = BIT(MURK_REGION_MESH)),
    ROW("medium", REFERENCE, .of = "media", TARGETS(medium)),
    ROW("points", COUNT, POINTS, TARGETS(volume_points)),
    ROW("spacing_m", NUMBER, .group = 1, SIZE_M, TARGETS(volume_spacing_m)),
    END,
};

static const murk_keys VOLUME = {
    .noun = "volume",
    .by_key = true,
    .variant_names = murk_zone_variants,
    VARIANT(murk_scene_targets, shape),
    WHERE(murk_scene_targets, volume_where),
    .key = VOLUME_ROWS,
};

static murk_status check_targets(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    murk_scene_targets *targets = item;
    targets->given = true;
    /* Targets are drawn, or listed in a file. */
    const bool is_drawn = targets->has_surfaces || targets->has_volume;
    if (!is_drawn && !targets->points) {
        return murk_walk_fail(
            walk, map,
            "names no targets, must have surfaces, volume or both, or points");
    }
    if (is_drawn && targets->points) {
        return murk_walk_fail(walk, map,
                              "has points and others, points must stand alone");
    }
    /* The band must be one of the scene's. */
    bool is_band = targets->band_nm == 0;
    for (int i = 0; i < walk->scene->bands; ++i) {
        is_band |= walk->scene->band_nm[i] == targets->band_nm;
    }
    if (!is_band) {
        murk_walk_enter(walk, "band_nm");
        return murk_walk_fail(walk, murk_yaml_get(map, "band_nm"),
                              "%.9g nm is none of the scene's bands",
                              targets->band_nm);
    }
    return MURK_OK;
}

static const murk_key TARGET_ROWS[] = {
    ROW("surfaces", MAP, .keys = &SURFACES,
        FLAG(murk_scene_targets, has_surfaces)),
    ROW("volume", MAP, .keys = &VOLUME, FLAG(murk_scene_targets, has_volume)),
    ROW("points", PATH, TARGETS(points)),
    ROW("band_nm", NUMBER, .above = true, .max = 1e9, .unit = "nm",
        TARGETS(band_nm)),
    END,
};

const murk_keys murk_target_keys = {
    .noun = "targets",
    .check = check_targets,
    WHERE(murk_scene_targets, where),
    .key = TARGET_ROWS,
};
