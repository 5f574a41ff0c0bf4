/* Keys of tallies. Names, and whether a tally is inside the domain, are
 * checked later, when the domain is known. */
#include "scene/keys_rows.h"

static murk_status check_tally(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    const murk_scene_tally *tally = item;
    if (tally->type == MURK_TALLY_GRID) {
        return murk_check_box(walk, map, tally->box);
    }
    if (tally->type == MURK_TALLY_PLANE && !(murk_length(tally->normal) > 0)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "normal is [0, 0, 0], must point somewhere");
    }
    return MURK_OK;
}

static const char *const TALLY_VARIANTS[] = {"plane", "grid", "sphere"};

#define PLANE  .variants = BIT(MURK_TALLY_PLANE)
#define GRID   .variants = BIT(MURK_TALLY_GRID)
#define SPHERE .variants = BIT(MURK_TALLY_SPHERE)

#define TALLY_WORD(id, name) {name, MURK_TALLY_##id},
static const murk_word TALLY_WORDS[] = {MURK_TALLY_TYPES(TALLY_WORD) WORDS_END};

static const murk_key TALLY_ROWS[] = {
    ROW("name", TEXT, NEEDED, AT(murk_scene_tally, name)),
    ROW("type", WORD, NEEDED, .words = TALLY_WORDS),
    ROW("point_m", VECTOR, NEEDED, LONG_M, PLANE, AT(murk_scene_tally, point)),
    ROW("normal", VECTOR, NEEDED, ANY_UNIT, PLANE,
        AT(murk_scene_tally, normal)),
    ROW("bins", SIZES, .min = 1, .max = 1e6, .unit = "bins", .preset = "[1, 1]",
        PLANE, AT(murk_scene_tally, bins)),
    ROW("angle_bins", COUNT, .min = 1, .max = 1e6, .unit = "bins",
        .preset = "1", PLANE, AT(murk_scene_tally, angle_bins)),
    ROW("min_m", VECTOR, NEEDED, LONG_M, GRID, AT(murk_scene_tally, box.min)),
    ROW("max_m", VECTOR, NEEDED, LONG_M, GRID, AT(murk_scene_tally, box.max)),
    ROW("size", SIZES, NEEDED, .min = 1, .max = 1e6, .unit = "cells", GRID,
        AT(murk_scene_tally, size)),
    ROW("center_m", VECTOR, NEEDED, LONG_M, SPHERE,
        AT(murk_scene_tally, center)),
    ROW("radius_m", NUMBER, NEEDED, SIZE_M, SPHERE,
        AT(murk_scene_tally, radius_m)),
    ROW("hemispheres", BOOL, .preset = "false", SPHERE,
        AT(murk_scene_tally, hemispheres)),
    END,
};

const murk_keys murk_tally_keys = {
    .noun = "tally",
    .selector = "type",
    .check = check_tally,
    .variant_names = TALLY_VARIANTS,
    VARIANT(murk_scene_tally, type),
    WHERE(murk_scene_tally, where),
    ITEMS(murk_scene_tally, tallies, n_tallies),
    .max_items = 64,
    .key = TALLY_ROWS,
};
