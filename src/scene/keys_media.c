/* Keys of media (homogeneous, grid, profile or preset), of their phase
 * functions and albedo, and of the regions that they fill. */
#include "scene/keys_rows.h"

#include <stdlib.h>
#include <string.h>

#include "scene/frames.h"
#include "scene/medium_preset.h"

enum {
    MEDIUM_HOMOGENEOUS,
    MEDIUM_GRID,
    MEDIUM_PROFILE,
    MEDIUM_PRESET,
    MEDIUM_PRESET_GRID
};

static murk_status choose_medium(murk_key_reader *walk, const murk_yaml *map,
                                 int *variant)
{
    (void)walk;
    if (murk_yaml_get(map, "preset")) {
        *variant =
            murk_yaml_get(map, "vdb") ? MEDIUM_PRESET_GRID : MEDIUM_PRESET;
        return MURK_OK;
    }
    *variant = murk_yaml_get(map, "vdb")       ? MEDIUM_GRID
               : murk_yaml_get(map, "profile") ? MEDIUM_PROFILE
                                               : MEDIUM_HOMOGENEOUS;
    return MURK_OK;
}

static murk_status choose_phase(murk_key_reader *walk, const murk_yaml *map,
                                int *variant)
{
    (void)walk;
    for (int i = 0; murk_phase_kinds[i].name; ++i) {
        if (murk_yaml_get(map, murk_phase_kinds[i].name)) {
            *variant = i;
        }
    }
    return MURK_OK;
}

/* A mean cosine: at -1 and 1 the phase function has no density. */
#define COSINE .min = -1, .max = 1, .above = true, .below = true

static const murk_key TWO_HG_ITEMS[] = {
    ROW("g1", NUMBER, COSINE),
    ROW("g2", NUMBER, COSINE),
    ROW("weight1", NUMBER, SHARE),
    END,
};

static const murk_key FOURNIER_FORAND_ITEMS[] = {
    ROW("n", NUMBER, .min = 1.001, .max = 2),
    ROW("mu", NUMBER, .min = 3.0001, .max = 4.9999),
    END,
};

static const murk_key PHASE_ROWS[] = {
    ROW("hg", SPECTRUM, .group = 1, NEEDED, COSINE,
        AT(murk_scene_phase, mean_cosine)),
    ROW("two_hg", NUMBERS, .group = 1, NEEDED, .items = TWO_HG_ITEMS,
        AT(murk_scene_phase, value)),
    ROW("fournier_forand", NUMBERS, .group = 1, NEEDED,
        .items = FOURNIER_FORAND_ITEMS, AT(murk_scene_phase, value)),
    ROW("table", PATH, .group = 1, NEEDED, AT(murk_scene_phase, table)),
    END,
};

static const murk_keys PHASE = {
    .noun = "phase",
    .choose = choose_phase,
    VARIANT(murk_scene_phase, kind),
    WHERE(murk_scene_phase, where),
    .item_size = sizeof(murk_scene_phase),
    .count_at = offsetof(murk_scene_medium, n_phases),
    .key = PHASE_ROWS,
};

static const murk_key ALBEDO_ROWS[] = {
    ROW("grid", TEXT, NEEDED, AT(murk_scene_medium, albedo_grid)),
    ROW("vdb", PATH, AT(murk_scene_medium, albedo_vdb)),
    END,
};

static const murk_keys ALBEDO = {
    .noun = "albedo",
    .key = ALBEDO_ROWS,
};

static murk_status check_profile(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    const murk_scene_medium *medium = item;
    const murk_scene_numbers *z = &medium->profile_z_m;
    /* As many heights as extinctions. */
    if (z->n < 2 || z->n != medium->profile_per_m.n) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "%zu heights and %zu extinctions, must be as "
                              "many of both, at least 2",
                              z->n, medium->profile_per_m.n);
    }
    /* Heights rise; two equal ones in succession are a jump. */
    for (size_t i = 1; i < z->n; ++i) {
        if (z->value[i] < z->value[i - 1] ||
            (i > 1 && z->value[i] == z->value[i - 2])) {
            return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                                  "z_m has %.9g after %.9g, must rise; a "
                                  "height given twice is a jump",
                                  z->value[i], z->value[i - 1]);
        }
    }
    if (z->value[0] == z->value[z->n - 1]) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "z_m has %.9g alone, must span a layer",
                              z->value[0]);
    }
    return MURK_OK;
}

static const murk_key PROFILE_ROWS[] = {
    ROW("z_m", NUMBER_LIST, NEEDED, LONG_M, AT(murk_scene_medium, profile_z_m)),
    ROW("extinction_per_m", SPECTRUM_LIST, NEEDED, .max = 1e9, .unit = "1/m",
        AT(murk_scene_medium, profile_per_m)),
    END,
};

static const murk_keys PROFILE = {
    .noun = "profile",
    .check = check_profile,
    .key = PROFILE_ROWS,
};

/* Replaces the pattern of file names by the file of the frame. */
static murk_status choose_frame(murk_key_reader *walk, const murk_yaml *map,
                                murk_scene_medium *medium)
{
    char *file = murk_frames_file(medium->vdb, medium->frame);
    if (!file) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "a frame of %.200s, which has no place for its "
                              "number, such as #### or %%04d",
                              medium->vdb);
    }
    medium->vdb_frames = medium->vdb;
    medium->vdb = file;
    file = medium->albedo_vdb
               ? murk_frames_file(medium->albedo_vdb, medium->frame)
               : NULL;
    if (file) {
        free(medium->albedo_vdb);
        medium->albedo_vdb = file;
    }
    return MURK_OK;
}

static murk_status check_medium(murk_key_reader *walk, const murk_yaml *map,
                                void *item)
{
    murk_scene_medium *medium = item;
    /* The file of the frame, then the properties of the preset. */
    if (medium->has_frame) {
        const murk_status status = choose_frame(walk, map, medium);
        if (status) {
            return status;
        }
    }
    if (medium->preset) {
        const murk_status status = murk_medium_preset_fill(walk, map, medium);
        if (status) {
            return status;
        }
    }
    if (!medium->albedo_grid || medium->albedo_vdb) {
        return MURK_OK;
    }
    /* An albedo grid without a file of its own is in the file of the
     * density. */
    if (!medium->vdb) {
        const size_t back = murk_walk_enter(walk, "albedo");
        const murk_status status =
            murk_walk_fail(walk, MURK_BAD_VALUE, murk_yaml_get(map, "albedo"),
                           false, "misses vdb, must be the name of a file");
        murk_walk_leave(walk, back);
        return status;
    }
    medium->albedo_vdb = strdup(medium->vdb);
    return medium->albedo_vdb ? MURK_OK : murk_walk_no_memory(walk);
}

static const char *const MEDIUM_VARIANTS[] = {"homogeneous", "grid", "profile",
                                              "preset", "preset in a grid"};

static const murk_word INTERPOLATION_WORDS[] = {
    {"nearest", 0},
    {"linear", 1},
    WORDS_END,
};

static const murk_word PHASE_WORDS[] = {
    {"isotropic", MURK_PHASE_HG},
    {"rayleigh", MURK_PHASE_RAYLEIGH},
    WORDS_END,
};

#define GRIDS   BIT(MEDIUM_GRID) | BIT(MEDIUM_PRESET_GRID)
#define PRESETS BIT(MEDIUM_PRESET) | BIT(MEDIUM_PRESET_GRID)
#define PLAIN   BIT(MEDIUM_HOMOGENEOUS) | BIT(MEDIUM_GRID) | BIT(MEDIUM_PROFILE)

static const murk_key DROPLET_SHAPE_ITEMS[] = {
    ROW("a", NUMBER, .max = 1e3),
    ROW("b", NUMBER, .above = true, .max = 1e6),
    ROW("c", NUMBER, .above = true, .max = 100),
    END,
};

/* A word of presets (preset/words.h); each preset states its own range. */
#define WORD_ROW(name, id, ...)                                \
    ROW(name, NUMBER, .variants = PRESETS,                     \
        AT(murk_scene_medium, words.value[MURK_WORD_##id][0]), \
        FLAG(murk_scene_medium, words.given[MURK_WORD_##id]), __VA_ARGS__)
#define AMOUNT .max = 1e9

static const murk_key MEDIUM_ROWS[] = {
    ROW("preset", TEXT, .variants = PRESETS, AT(murk_scene_medium, preset)),
    WORD_ROW("visibility_m", VISIBILITY, .group = 2, SIZE_M),
    WORD_ROW("mor_m", MOR, .group = 2, SIZE_M),
    WORD_ROW("rain_mm_per_h", RAIN, AMOUNT, .unit = "mm/h"),
    WORD_ROW("soot_g_per_m3", SOOT, AMOUNT, .unit = "g/m3"),
    WORD_ROW("droplets_per_cm3", DROPLETS, .group = 2, AMOUNT, .unit = "1/cm3"),
    WORD_ROW("liquid_water_g_per_m3", LIQUID_WATER, .group = 2, AMOUNT,
             .unit = "g/m3"),
    ROW("droplet_shape", NUMBERS, .variants = PRESETS,
        .items = DROPLET_SHAPE_ITEMS,
        AT(murk_scene_medium, words.value[MURK_WORD_DROPLET_SHAPE]),
        FLAG(murk_scene_medium, words.given[MURK_WORD_DROPLET_SHAPE])),
    WORD_ROW("chlorophyll_mg_per_m3", CHLOROPHYLL, AMOUNT, .unit = "mg/m3"),
    WORD_ROW("sediment_g_per_m3", SEDIMENT, AMOUNT, .unit = "g/m3"),
    WORD_ROW("cdom_per_m", CDOM, AMOUNT, .unit = "1/m"),
    WORD_ROW("beam_attenuation_per_m", BEAM_ATTENUATION, AMOUNT, .unit = "1/m"),
    WORD_ROW("temperature_c", TEMPERATURE, .min = -100, .max = 100,
             .unit = "degrees C"),
    WORD_ROW("salinity_psu", SALINITY, .max = 100, .unit = "psu"),
    WORD_ROW("pressure_hpa", PRESSURE, .max = 1e5, .unit = "hPa"),
    ROW("vdb", PATH, .group = 1, AT(murk_scene_medium, vdb)),
    ROW("frame", COUNT, .variants = GRIDS, .max = 999999999,
        AT(murk_scene_medium, frame), FLAG(murk_scene_medium, has_frame)),
    ROW("grid", TEXT, .variants = GRIDS, AT(murk_scene_medium, grid)),
    ROW("interpolation", WORD, .variants = GRIDS, .preset = "nearest",
        .words = INTERPOLATION_WORDS, AT(murk_scene_medium, is_linear)),
    ROW("profile", MAP, .group = 1, .variants = PLAIN, .keys = &PROFILE),
    ROW("extinction_per_m", SPECTRUM, NEEDED, .max = 1e9, .unit = "1/m",
        .variants = BIT(MEDIUM_HOMOGENEOUS) | BIT(MEDIUM_GRID),
        AT(murk_scene_medium, extinction_per_m)),
    ROW("extinction_per_m", SPECTRUM, .max = 1e9, .unit = "1/m",
        .variants = PRESETS, AT(murk_scene_medium, extinction_per_m)),
    ROW("albedo", SPECTRUM, NEEDED, SHARE, .keys = &ALBEDO, .variants = PLAIN,
        AT(murk_scene_medium, albedo)),
    ROW("albedo", SPECTRUM, SHARE, .keys = &ALBEDO, .variants = PRESETS,
        AT(murk_scene_medium, albedo)),
    ROW("phase", PER_BAND, .keys = &PHASE, .preset = "isotropic",
        .words = PHASE_WORDS, .variants = PLAIN, AT(murk_scene_medium, phase)),
    ROW("phase", PER_BAND, .keys = &PHASE, .words = PHASE_WORDS,
        .variants = PRESETS, AT(murk_scene_medium, phase)),
    END,
};

const murk_keys murk_medium_keys = {
    .noun = "medium",
    .choose = choose_medium,
    .variant_names = MEDIUM_VARIANTS,
    .complete = murk_medium_preset_complete,
    .check = check_medium,
    WHERE(murk_scene_medium, where),
    ITEMS(murk_scene_medium, media, n_media),
    .max_items = 256,
    .name_at = offsetof(murk_scene_medium, name),
    .key = MEDIUM_ROWS,
};

static murk_status check_region_box(murk_key_reader *walk, const murk_yaml *map,
                                    void *item)
{
    return murk_check_box(walk, map, ((murk_scene_region *)item)->box);
}

static const murk_key REGION_BOX_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_region, box.min)),
    ROW("max_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_region, box.max)),
    END,
};

static const murk_keys REGION_BOX = {
    .noun = "box",
    .check = check_region_box,
    .key = REGION_BOX_ROWS,
};

static const murk_key REGION_SPHERE_ROWS[] = {
    ROW("center_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_region, center)),
    ROW("radius_m", NUMBER, NEEDED, SIZE_M, AT(murk_scene_region, radius_m)),
    END,
};

static const murk_keys REGION_SPHERE = {
    .noun = "sphere",
    .key = REGION_SPHERE_ROWS,
};

#define SHAPE_NAME(id, name, key) name,
static const char *const REGION_VARIANTS[] = {MURK_REGION_SHAPES(SHAPE_NAME)};

/* A region without a shape is everywhere, or the box of the grid of the
 * medium. */
static murk_status choose_region(murk_key_reader *walk, const murk_yaml *map,
                                 int *variant)
{
    const murk_yaml *media = murk_yaml_get(walk->root, "media");
    const murk_yaml *name = murk_yaml_get(map, "medium");
    const murk_yaml *medium =
        media && name && name->text ? murk_yaml_get(media, name->text) : NULL;
    const bool has_grid = medium && murk_yaml_get(medium, "vdb");
    *variant = murk_shape_of_region(map, has_grid ? MURK_REGION_GRID
                                                  : MURK_REGION_EVERYWHERE);
    return MURK_OK;
}

/* Shapes that may have an index of refraction: all but a grid without a
 * shape. */
#define SHARP (~BIT(MURK_REGION_GRID))

#define MOVABLE                                                  \
    .variants = BIT(MURK_REGION_BOX) | BIT(MURK_REGION_SPHERE) | \
                BIT(MURK_REGION_GRID) | BIT(MURK_REGION_MESH)

/* Checks a region. Shapes that cannot be moved have the scale 1. */
static murk_status check_region(murk_key_reader *walk, const murk_yaml *map,
                                void *item)
{
    murk_scene_region *region = item;
    if (region->shape == MURK_REGION_EVERYWHERE ||
        region->shape == MURK_REGION_BELOW) {
        region->scale = 1;
    }
    if (!(region->wind_m_per_s > 0) || region->ior > 0) {
        return MURK_OK;
    }
    const size_t back = murk_walk_enter(walk, "wind_m_per_s");
    const murk_status status = murk_walk_fail(
        walk, MURK_BAD_VALUE, murk_yaml_get(map, "wind_m_per_s"), false,
        "%g m/s over a region without ior, must be 0 there: only where the "
        "index changes waves bend light",
        region->wind_m_per_s);
    murk_walk_leave(walk, back);
    return status;
}

static const murk_key REGION_ROWS[] = {
    ROW("medium", REFERENCE, .of = "media", NEEDED,
        AT(murk_scene_region, medium)),
    ROW("box", MAP, .group = 1, .keys = &REGION_BOX),
    ROW("sphere", MAP, .group = 1, .keys = &REGION_SPHERE),
    ROW("below_z_m", NUMBER, .group = 1, LONG_M,
        AT(murk_scene_region, below_z_m)),
    ROW("mesh", PATH, .group = 1, AT(murk_scene_region, mesh)),
    ROW("unit_m", NUMBER, SIZE_M, .variants = BIT(MURK_REGION_MESH),
        AT(murk_scene_region, unit_m)),
    ROW("up", WORD, .variants = BIT(MURK_REGION_MESH), .words = murk_up_words,
        AT(murk_scene_region, up)),
    ROW("scale", NUMBER, .above = true, .max = 1e9, MOVABLE, .preset = "1",
        AT(murk_scene_region, scale)),
    ROW("rotate_deg", VECTOR, ANY_UNIT, MOVABLE, .unit = "degrees",
        .preset = "[0, 0, 0]", AT(murk_scene_region, rotate_deg)),
    ROW("translate_m", VECTOR, LONG_M, MOVABLE, .preset = "[0, 0, 0]",
        AT(murk_scene_region, translate_m)),
    ROW("replace", BOOL, .preset = "false", AT(murk_scene_region, replaces)),
    ROW("ior", NUMBER, .min = 1, .max = 10, .variants = SHARP,
        AT(murk_scene_region, ior)),
    ROW("wind_m_per_s", NUMBER, .max = 20, .unit = "m/s",
        .variants = BIT(MURK_REGION_BELOW),
        AT(murk_scene_region, wind_m_per_s)),
    END,
};

const murk_keys murk_region_keys = {
    .noun = "region",
    .choose = choose_region,
    .check = check_region,
    .variant_names = REGION_VARIANTS,
    VARIANT(murk_scene_region, shape),
    WHERE(murk_scene_region, where),
    ITEMS(murk_scene_region, regions, n_regions),
    .max_items = 64,
    .key = REGION_ROWS,
};
