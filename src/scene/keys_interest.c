/* Keys of regions of interest: weights of photons inside a box, a sphere or
 * a mesh, on a material or in a medium. */
#include "scene/keys_rows.h"

/* Gives shapes that cannot be moved the scale 1. Fails if the region says no
 * place. */
static murk_status check_interest(murk_key_reader *walk, const murk_yaml *map,
                                  void *item)
{
    murk_scene_interest *region = item;
    if (region->shape != MURK_REGION_MESH) {
        region->solid.scale = 1;
    }
    return region->shape != MURK_REGION_EVERYWHERE || region->material >= 0 ||
                   region->medium >= 0
               ? MURK_OK
               : murk_walk_fail(walk, map,
                                "says no place, must have one or more of box, "
                                "sphere, mesh, material, medium");
}

#define INTEREST(member) AT(murk_scene_interest, member)

static const murk_key INTEREST_ROWS[] = {
    ROW("name", TEXT, NEEDED, INTEREST(name)),
    ROW("weight", NUMBER, .max = 1e6, .preset = "1", INTEREST(weight)),
    BOX_ROW(murk_scene_interest, .group = 1),
    SPHERE_ROW(murk_scene_interest, .group = 1),
    MESH_ROWS(murk_scene_interest, .group = 1),
    PLACEMENT_ROWS(murk_scene_interest, .variants = BIT(MURK_REGION_MESH)),
    ROW("material", REFERENCE, .group = 2, .of = "materials",
        INTEREST(material)),
    ROW("medium", REFERENCE, .group = 2, .of = "media", INTEREST(medium)),
    END,
};

const murk_keys murk_interest_keys = {
    .noun = "region of interest",
    .by_key = true,
    .check = check_interest,
    .variant_names = murk_zone_variants,
    VARIANT(murk_scene_interest, shape),
    WHERE(murk_scene_interest, where),
    ITEMS(murk_scene_placement, interest, n_interests),
    .max_items = 64,
    .key = INTEREST_ROWS,
};
