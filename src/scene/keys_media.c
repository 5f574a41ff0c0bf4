/* Media and the regions that they fill. */
#include "scene/keys_rows.h"

enum { MEDIUM_HOMOGENEOUS, MEDIUM_GRID };

static murk_status choose_medium(murk_walk *walk, const murk_yaml *map,
                                 int *variant)
{
    (void)walk;
    *variant = murk_yaml_get(map, "vdb") ? MEDIUM_GRID : MEDIUM_HOMOGENEOUS;
    return MURK_OK;
}

static murk_status choose_phase(murk_walk *walk, const murk_yaml *map,
                                int *variant)
{
    (void)walk;
    *variant = murk_yaml_get(map, "two_hg") ? MURK_SCENE_PHASE_TWO_HG
               : murk_yaml_get(map, "fournier_forand")
                   ? MURK_SCENE_PHASE_FOURNIER_FORAND
               : murk_yaml_get(map, "table") ? MURK_SCENE_PHASE_TABLE
                                             : MURK_SCENE_PHASE_HG;
    return MURK_OK;
}

#define COSINE .least = -1, .most = 1, .above = true, .below = true

static const murk_key TWO_HG_ITEMS[] = {
    ROW("g1", NUMBER, COSINE),
    ROW("g2", NUMBER, COSINE),
    ROW("weight1", NUMBER, SHARE),
    END,
};

static const murk_key FOURNIER_FORAND_ITEMS[] = {
    ROW("n", NUMBER, .least = 1.001, .most = 2),
    ROW("mu", NUMBER, .least = 3, .most = 5, .above = true, .below = true),
    END,
};

static const murk_key PHASE_ROWS[] = {
    ROW("hg", SPECTRUM, .group = 1, NEEDED, COSINE,
        AT(murk_scene_phase, mean_cosine)),
    ROW("two_hg", NUMBERS, .group = 1, NEEDED, .items = TWO_HG_ITEMS,
        AT(murk_scene_phase, two_hg)),
    ROW("fournier_forand", NUMBERS, .group = 1, NEEDED,
        .items = FOURNIER_FORAND_ITEMS, AT(murk_scene_phase, fournier_forand)),
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

static const char *const MEDIUM_VARIANTS[] = {"homogeneous", "grid"};

static const murk_word INTERPOLATION_WORDS[] = {
    {"nearest", 0, false},
    {"linear", 1, false},
    WORDS_END,
};

static const murk_word PHASE_WORDS[] = {
    {"isotropic", MURK_SCENE_PHASE_HG, false},
    {"rayleigh", MURK_SCENE_PHASE_RAYLEIGH, false},
    WORDS_END,
};

static const murk_key MEDIUM_ROWS[] = {
    ROW("vdb", PATH, AT(murk_scene_medium, vdb)),
    ROW("grid", TEXT, .variants = BIT(MEDIUM_GRID),
        AT(murk_scene_medium, grid)),
    ROW("interpolation", WORD, .variants = BIT(MEDIUM_GRID),
        .preset = "nearest", .words = INTERPOLATION_WORDS,
        AT(murk_scene_medium, is_linear)),
    ROW("extinction_per_m", SPECTRUM, NEEDED, .most = 1e9, .unit = "1/m",
        AT(murk_scene_medium, extinction_per_m)),
    ROW("albedo", SPECTRUM, NEEDED, SHARE, AT(murk_scene_medium, albedo)),
    ROW("phase", PER_BAND, .keys = &PHASE, .preset = "isotropic",
        .words = PHASE_WORDS, AT(murk_scene_medium, phase)),
    LATER("preset"),
    LATER("visibility_m"),
    LATER("mor_m"),
    LATER("profile"),
    END,
};

const murk_keys murk_medium_keys = {
    .noun = "medium",
    .choose = choose_medium,
    .variant_names = MEDIUM_VARIANTS,
    WHERE(murk_scene_medium, where),
    ITEMS(murk_scene_medium, media, n_media),
    .most_items = 256,
    .name_at = offsetof(murk_scene_medium, name),
    .key = MEDIUM_ROWS,
};

static murk_status check_region_box(murk_walk *walk, const murk_yaml *map,
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

static const char *const REGION_VARIANTS[] = {"everywhere", "box", "sphere",
                                              "grid", "half space"};

/* A region without a shape is everywhere, or where its medium's grid lies. */
static murk_status choose_region(murk_walk *walk, const murk_yaml *map,
                                 int *variant)
{
    const murk_yaml *media = murk_yaml_get(walk->root, "media");
    const murk_yaml *name = murk_yaml_get(map, "medium");
    const murk_yaml *medium =
        media && name && name->text ? murk_yaml_get(media, name->text) : NULL;
    const bool has_grid = medium && murk_yaml_get(medium, "vdb");
    *variant = murk_yaml_get(map, "box")         ? MURK_SCENE_IN_BOX
               : murk_yaml_get(map, "sphere")    ? MURK_SCENE_IN_SPHERE
               : murk_yaml_get(map, "below_z_m") ? MURK_SCENE_BELOW
               : has_grid                        ? MURK_SCENE_IN_GRID
                                                 : MURK_SCENE_EVERYWHERE;
    return MURK_OK;
}

/* What may have an index of refraction: anything but a grid without a shape.
 */
#define SHARP (~BIT(MURK_SCENE_IN_GRID))

#define MOVABLE                                                      \
    .variants = BIT(MURK_SCENE_IN_BOX) | BIT(MURK_SCENE_IN_SPHERE) | \
                BIT(MURK_SCENE_IN_GRID)

/* What is not moved still holds the identity. */
static murk_status check_region(murk_walk *walk, const murk_yaml *map,
                                void *item)
{
    murk_scene_region *region = item;
    (void)walk;
    (void)map;
    if (region->shape == MURK_SCENE_EVERYWHERE ||
        region->shape == MURK_SCENE_BELOW) {
        region->scale = 1;
    }
    return MURK_OK;
}

static const murk_key REGION_ROWS[] = {
    ROW("medium", REFERENCE, .of = "media", NEEDED,
        AT(murk_scene_region, medium)),
    ROW("box", MAP, .group = 1, .keys = &REGION_BOX),
    ROW("sphere", MAP, .group = 1, .keys = &REGION_SPHERE),
    ROW("below_z_m", NUMBER, .group = 1, LONG_M,
        AT(murk_scene_region, below_z_m)),
    ROW("scale", NUMBER, .above = true, .most = 1e9, MOVABLE, .preset = "1",
        AT(murk_scene_region, scale)),
    ROW("rotate_deg", VECTOR, ANY_UNIT, MOVABLE, .unit = "degrees",
        .preset = "[0, 0, 0]", AT(murk_scene_region, rotate_deg)),
    ROW("translate_m", VECTOR, LONG_M, MOVABLE, .preset = "[0, 0, 0]",
        AT(murk_scene_region, translate_m)),
    ROW("replace", BOOL, .preset = "false", AT(murk_scene_region, replaces)),
    ROW("ior", NUMBER, .least = 1, .most = 10, .variants = SHARP,
        AT(murk_scene_region, ior)),
    LATER("mesh"),
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
    .most_items = 64,
    .key = REGION_ROWS,
};
