/* Keys of regions of interest: weights of photons inside a box, a sphere or
 * a mesh, on a material or in a medium. */
#include "scene/keys_rows.h"

static murk_status check_interest_box(murk_key_reader *walk,
                                      const murk_yaml *map, void *item)
{
    return murk_check_box(walk, map, ((murk_scene_interest *)item)->box);
}

static const murk_key INTEREST_BOX_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_interest, box.min)),
    ROW("max_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_interest, box.max)),
    END,
};

static const murk_keys INTEREST_BOX = {
    .noun = "box",
    .check = check_interest_box,
    .key = INTEREST_BOX_ROWS,
};

static const murk_key INTEREST_SPHERE_ROWS[] = {
    ROW("center_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_interest, center)),
    ROW("radius_m", NUMBER, NEEDED, SIZE_M, AT(murk_scene_interest, radius_m)),
    END,
};

static const murk_keys INTEREST_SPHERE = {
    .noun = "sphere",
    .key = INTEREST_SPHERE_ROWS,
};

const char *const murk_zone_variants[] = {"without a shape", "box", "sphere",
                                          "mesh"};

murk_region_shape murk_shape_of_region(const murk_yaml *map,
                                       murk_region_shape otherwise)
{
#define SHAPE_KEY(id, name, key) [MURK_REGION_##id] = key,
    static const char *const keys[] = {MURK_REGION_SHAPES(SHAPE_KEY)};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; ++i) {
        if (keys[i] && murk_yaml_get(map, keys[i])) {
            return (murk_region_shape)i;
        }
    }
    return otherwise;
}

murk_status murk_choose_zone(murk_key_reader *walk, const murk_yaml *map,
                             int *variant)
{
    (void)walk;
    *variant = murk_shape_of_region(map, MURK_REGION_EVERYWHERE);
    return MURK_OK;
}

static murk_status check_interest(murk_key_reader *walk, const murk_yaml *map,
                                  void *item)
{
    const murk_scene_interest *region = item;
    if (region->shape == MURK_REGION_EVERYWHERE && region->material < 0 &&
        region->medium < 0) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "says no place, must have one or more of box, "
                              "sphere, mesh, material, medium");
    }
    return MURK_OK;
}

#define MESH .variants = BIT(MURK_REGION_MESH)

static const murk_key INTEREST_ROWS[] = {
    ROW("name", TEXT, NEEDED, AT(murk_scene_interest, name)),
    ROW("weight", NUMBER, .max = 1e6, .preset = "1",
        AT(murk_scene_interest, weight)),
    ROW("box", MAP, .group = 1, .keys = &INTEREST_BOX),
    ROW("sphere", MAP, .group = 1, .keys = &INTEREST_SPHERE),
    ROW("mesh", PATH, .group = 1, AT(murk_scene_interest, mesh)),
    ROW("unit_m", NUMBER, SIZE_M, MESH, AT(murk_scene_interest, unit_m)),
    ROW("up", WORD, MESH, .words = murk_up_words, AT(murk_scene_interest, up)),
    ROW("scale", NUMBER, .above = true, .max = 1e9, MESH, .preset = "1",
        AT(murk_scene_interest, scale)),
    ROW("rotate_deg", VECTOR, ANY_UNIT, MESH, .unit = "degrees",
        .preset = "[0, 0, 0]", AT(murk_scene_interest, rotate_deg)),
    ROW("translate_m", VECTOR, LONG_M, MESH, .preset = "[0, 0, 0]",
        AT(murk_scene_interest, translate_m)),
    ROW("material", REFERENCE, .group = 2, .of = "materials",
        AT(murk_scene_interest, material)),
    ROW("medium", REFERENCE, .group = 2, .of = "media",
        AT(murk_scene_interest, medium)),
    END,
};

const murk_keys murk_interest_keys = {
    .noun = "region of interest",
    .choose = murk_choose_zone,
    .check = check_interest,
    .variant_names = murk_zone_variants,
    VARIANT(murk_scene_interest, shape),
    WHERE(murk_scene_interest, where),
    ITEMS(murk_scene_interest, placement.interest, placement.n_interests),
    .max_items = 64,
    .key = INTEREST_ROWS,
};
