/* Keys of tallies. Names, and whether a tally is inside the domain, are
 * checked later, when the domain is known. */
#include "scene/keys_rows.h"

static murk_status check_tally(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    murk_scene_tally *tally = item;
    if (tally->type == MURK_TALLY_GRID) {
        return murk_check_box(walk, map, &tally->box);
    }
    if (tally->type == MURK_TALLY_PLANE && !(murk_length(tally->normal) > 0)) {
        return murk_walk_fail(walk, map,
                              "normal is [0, 0, 0], must point somewhere");
    }
    return MURK_OK;
}

#define TALLY_WORD(id, name) {name, MURK_TALLY_##id},
static const murk_word TALLY_WORDS[] = {MURK_TALLY_TYPES(TALLY_WORD) WORDS_END};

#define TALLY(member) AT(murk_scene_tally, member)

#define PLANE .variants = BIT(MURK_TALLY_PLANE)
#define GRID  .variants = BIT(MURK_TALLY_GRID)
#define BALL  .variants = BIT(MURK_TALLY_SPHERE)
/* More bins along one axis than any result needs. */
#define BINS .min = 1, .max = 1e6, .unit = "bins"

static const murk_key TALLY_ROWS[] = {
    ROW("name", TEXT, NEEDED, TALLY(name)),
    ROW("type", WORD, NEEDED, .words = TALLY_WORDS),
    ROW("point_m", VECTOR, NEEDED, PLACE_M, PLANE, TALLY(point)),
    ROW("normal", VECTOR, NEEDED, ANY_UNIT, PLANE, TALLY(normal)),
    ROW("bins", SIZES, BINS, .preset = "[1, 1]", PLANE, TALLY(bins)),
    ROW("angle_bins", COUNT, BINS, .preset = "1", PLANE, TALLY(angle_bins)),
    ROW("min_m", VECTOR, NEEDED, PLACE_M, GRID, TALLY(box.min)),
    ROW("max_m", VECTOR, NEEDED, PLACE_M, GRID, TALLY(box.max)),
    ROW("size", SIZES, NEEDED, .min = 1, .max = 1e6, .unit = "cells", GRID,
        TALLY(size)),
    ROW("center_m", VECTOR, NEEDED, PLACE_M, BALL, TALLY(center)),
    ROW("radius_m", NUMBER, NEEDED, SIZE_M, BALL, TALLY(radius_m)),
    ROW("hemispheres", BOOL, .preset = "false", BALL, TALLY(hemispheres)),
    END,
};

const murk_keys murk_tally_keys = {
    .noun = "tally",
    .selector = "type",
    .check = check_tally,
    VARIANT(murk_scene_tally, type),
    WHERE(murk_scene_tally, where),
    ITEMS(murk_scene_desc, tallies, n_tallies),
    .max_items = 64,
    .key = TALLY_ROWS,
};
