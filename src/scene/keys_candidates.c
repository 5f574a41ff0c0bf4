/* Keys of candidate sites: a grid, points, mounts on surfaces, and zones in
 * which sensors may or may not stand. */
#include "scene/keys_rows.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/value.h"

/* 1e7 candidates: more than placement can hold in memory. */
#define MAX_CANDIDATES 1e7

/* The quotient (max - min) / spacing_m is rounded a few times: a last point
 * that exceeds max by less than this fraction of a step still counts. */
#define STEP_SLACK 1e-9

static void fill_size_by_spacing(murk_scene_candidates *settings,
                                 double spacing)
{
    const double min[3] = {settings->grid_min.x, settings->grid_min.y,
                           settings->grid_min.z};
    double *const max[3] = {&settings->grid_max.x, &settings->grid_max.y,
                            &settings->grid_max.z};
    for (int i = 0; i < 3; ++i) {
        const double steps = fmin(
            floor((*max[i] - min[i]) / spacing + STEP_SLACK), MAX_CANDIDATES);
        settings->grid_size[i] = (size_t)steps + 1;
        *max[i] = min[i] + steps * spacing;
    }
}

static murk_status check_grid(murk_key_reader *walk, const murk_yaml *map,
                              void *item)
{
    murk_scene_candidates *settings =
        &((murk_scene_desc *)item)->sensors.candidates;
    const murk_vec3 min = settings->grid_min, max = settings->grid_max;
    if (!(min.x <= max.x && min.y <= max.y && min.z <= max.z)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "min_m [%.9g, %.9g, %.9g] and max_m "
                              "[%.9g, %.9g, %.9g], min must be at most max on "
                              "each axis, m",
                              min.x, min.y, min.z, max.x, max.y, max.z);
    }
    /* A spacing determines the size; then count the points. */
    const murk_yaml *spacing = murk_yaml_get(map, "spacing_m");
    double spacing_m;
    if (spacing && murk_yaml_number(spacing, &spacing_m)) {
        fill_size_by_spacing(settings, spacing_m);
    }
    const double extent[3] = {max.x - min.x, max.y - min.y, max.z - min.z};
    double points = 1;
    for (int i = 0; i < 3; ++i) {
        points *= (double)settings->grid_size[i];
        if (extent[i] == 0 && settings->grid_size[i] > 1) {
            return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                                  "size %zu along %c where min_m is max_m, "
                                  "must be 1",
                                  settings->grid_size[i], "xyz"[i]);
        }
    }
    if (!(points <= MAX_CANDIDATES)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "%.9g points, must be at most 1e7", points);
    }
    return MURK_OK;
}

static const murk_key GRID_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, LONG_M,
        AT(murk_scene_desc, sensors.candidates.grid_min)),
    ROW("max_m", VECTOR, NEEDED, LONG_M,
        AT(murk_scene_desc, sensors.candidates.grid_max)),
    ROW("size", SIZES, .group = 1, NEEDED, .min = 1, .max = MAX_CANDIDATES,
        .unit = "points", AT(murk_scene_desc, sensors.candidates.grid_size)),
    ROW("spacing_m", NUMBER, .group = 1, NEEDED, SIZE_M),
    END,
};

static const murk_keys GRID = {
    .noun = "grid",
    .check = check_grid,
    WHERE(murk_scene_desc, sensors.candidates.grid_where),
    .key = GRID_ROWS,
};

/* ---- points ---- */

static murk_status wrong(murk_key_reader *walk, const murk_key *key,
                         const murk_yaml *node)
{
    char found[MURK_FOUND_SIZE];
    murk_value_found(node, found);
    return murk_walk_fail(walk, MURK_BAD_VALUE, node, false, "%s, must be %s",
                          found, key->allowed);
}

static murk_status read_point(murk_key_reader *walk, murk_yaml *node,
                              murk_scene_points *points)
{
    static const murk_key FILE_NAME = {
        .name = "", .kind = MURK_KEY_PATH, .size = sizeof(char *)};
    static const murk_key POINT = {
        .name = "", .kind = MURK_KEY_VECTOR, LONG_M, .size = sizeof(murk_vec3)};
    if (node->kind == MURK_YAML_SCALAR) {
        /* counted first, so that the entry is freed after a failure */
        return murk_value_read(walk, &FILE_NAME, node,
                               &points->file[points->files++]);
    }
    return murk_value_read(walk, &POINT, node,
                           &points->position[points->positions++]);
}

static murk_status read_points(murk_key_reader *walk, const murk_key *key,
                               murk_yaml *node, void *item)
{
    murk_scene_points *points =
        &((murk_scene_desc *)item)->sensors.candidates.points;
    const bool is_list = node->kind == MURK_YAML_LIST;
    const size_t n = is_list ? node->n : 1;
    murk_status status = MURK_OK;
    if (node->kind == MURK_YAML_MAP || n == 0) {
        return wrong(walk, key, node);
    }
    if (n > MURK_SCENE_LIST_MAX) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, node, false,
                              "a list of %zu, must be at most %d; a file may "
                              "have more",
                              n, MURK_SCENE_LIST_MAX);
    }
    /* Reserve both arrays for the worst case, then read each item. */
    murk_walk_where(node, walk->key, false, points->where);
    points->file = calloc(n, sizeof *points->file);
    points->position = calloc(n, sizeof *points->position);
    if (!points->file || !points->position) {
        return murk_walk_no_memory(walk);
    }
    for (size_t i = 0; i < n && !status; ++i) {
        char number[24];
        snprintf(number, sizeof number, "%zu", i);
        const size_t back =
            is_list ? murk_walk_enter(walk, number) : strlen(walk->key);
        status = read_point(walk, is_list ? node->child[i] : node, points);
        murk_walk_leave(walk, back);
    }
    return status;
}

/* ---- mounts ---- */

static const murk_word SURFACES_WORDS[] = {
    {"all", 0},
    WORDS_END,
};

static const murk_key BAND_ITEMS[] = {
    ROW("low", NUMBER, LONG_M),
    ROW("high", NUMBER, LONG_M),
    END,
};

static const murk_word FACING_WORDS[] = {
    {"any", MURK_SCENE_FACING_ANY},
    {"up", MURK_SCENE_FACING_UP},
    {"down", MURK_SCENE_FACING_DOWN},
    {"side", MURK_SCENE_FACING_SIDE},
    WORDS_END,
};

static const murk_key MOUNT_ROWS[] = {
    ROW("surfaces", REFERENCES, .of = "materials", .preset = "all",
        .words = SURFACES_WORDS, AT(murk_scene_mount, materials)),
    ROW("spacing_m", NUMBER, SIZE_M, .preset = "1",
        AT(murk_scene_mount, spacing_m)),
    ROW("offset_m", NUMBER, SIZE_M, .preset = "0.05",
        AT(murk_scene_mount, offset_m)),
    ROW("z_m", NUMBERS, .items = BAND_ITEMS, AT(murk_scene_mount, band_m),
        FLAG(murk_scene_mount, has_band)),
    ROW("facing", WORD, .words = FACING_WORDS, .preset = "any",
        AT(murk_scene_mount, facing)),
    END,
};

static murk_status check_mount(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    const murk_scene_mount *mount = item;
    if (!(mount->band_m[0] <= mount->band_m[1])) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "z_m is from %.9g to %.9g m, must not fall",
                              mount->band_m[0], mount->band_m[1]);
    }
    return MURK_OK;
}

static const murk_keys MOUNT = {
    .noun = "mount",
    .check = check_mount,
    WHERE(murk_scene_mount, where),
    ITEMS(murk_scene_mount, sensors.candidates.mount,
          sensors.candidates.mounts),
    .max_items = 64,
    .key = MOUNT_ROWS,
};

/* Reads a map as one mount, a list as several; the word `free` as none. */
static murk_status read_mount(murk_key_reader *walk, const murk_key *key,
                              murk_yaml *node, void *item)
{
    static const murk_key ONE = {
        .name = "", .kind = MURK_KEY_MAP, .keys = &MOUNT};
    static const murk_key MANY = {
        .name = "", .kind = MURK_KEY_LIST, .keys = &MOUNT};
    murk_scene_candidates *settings =
        &((murk_scene_desc *)item)->sensors.candidates;
    if (node->kind == MURK_YAML_LIST) {
        return murk_walk_value(walk, &MANY, node, item);
    }
    if (node->kind == MURK_YAML_SCALAR && strcmp(node->text, "free") == 0) {
        node->is_quoted = false;
        return MURK_OK;
    }
    if (node->kind != MURK_YAML_MAP) {
        return wrong(walk, key, node);
    }
    /* A single mount becomes an array of one. */
    settings->mount = calloc(1, sizeof *settings->mount);
    if (!settings->mount) {
        return murk_walk_no_memory(walk);
    }
    settings->mounts = 1;
    return murk_walk_value(walk, &ONE, node, settings->mount);
}

/* ---- zones ---- */

static murk_status check_zone_box(murk_key_reader *walk, const murk_yaml *map,
                                  void *item)
{
    return murk_check_box(walk, map, ((murk_scene_site_zone *)item)->box);
}

static const murk_key ZONE_BOX_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_site_zone, box.min)),
    ROW("max_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_site_zone, box.max)),
    END,
};

static const murk_keys ZONE_BOX = {
    .noun = "box",
    .check = check_zone_box,
    .key = ZONE_BOX_ROWS,
};

static const murk_key ZONE_SPHERE_ROWS[] = {
    ROW("center_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_site_zone, center)),
    ROW("radius_m", NUMBER, NEEDED, SIZE_M, AT(murk_scene_site_zone, radius_m)),
    END,
};

static const murk_keys ZONE_SPHERE = {
    .noun = "sphere",
    .key = ZONE_SPHERE_ROWS,
};

static const char *const ZONE_VARIANTS[] = {"zone", "box", "sphere", "mesh"};

static murk_status choose_zone(murk_key_reader *walk, const murk_yaml *map,
                               int *variant)
{
    (void)walk;
    *variant = murk_shape_of_region(map, MURK_REGION_BOX);
    return MURK_OK;
}

#define MESH .variants = BIT(MURK_REGION_MESH)

static const murk_key ZONE_ROWS[] = {
    ROW("box", MAP, .group = 1, NEEDED, .keys = &ZONE_BOX),
    ROW("sphere", MAP, .group = 1, NEEDED, .keys = &ZONE_SPHERE),
    ROW("mesh", PATH, .group = 1, NEEDED, AT(murk_scene_site_zone, mesh)),
    ROW("unit_m", NUMBER, SIZE_M, MESH, AT(murk_scene_site_zone, unit_m)),
    ROW("up", WORD, MESH, .words = murk_up_words, AT(murk_scene_site_zone, up)),
    ROW("scale", NUMBER, .above = true, .max = 1e9, .preset = "1",
        AT(murk_scene_site_zone, scale)),
    ROW("rotate_deg", VECTOR, ANY_UNIT, .unit = "degrees",
        .preset = "[0, 0, 0]", AT(murk_scene_site_zone, rotate_deg)),
    ROW("translate_m", VECTOR, LONG_M, .preset = "[0, 0, 0]",
        AT(murk_scene_site_zone, translate_m)),
    END,
};

#define ZONES(array, count)                                                    \
    {                                                                          \
        .noun = "zone", .choose = choose_zone, .variant_names = ZONE_VARIANTS, \
        VARIANT(murk_scene_site_zone, shape),                                  \
        WHERE(murk_scene_site_zone, where),                                    \
        ITEMS(murk_scene_site_zone, sensors.candidates.array,                  \
              sensors.candidates.count),                                       \
        .max_items = 64, .key = ZONE_ROWS,                                     \
    }

static const murk_keys AVOID = ZONES(avoid, avoids);
static const murk_keys WITHIN = ZONES(within, withins);

/* ---- all of it ---- */

static const murk_key CANDIDATES_ROWS[] = {
    ROW("grid", MAP, .keys = &GRID,
        FLAG(murk_scene_desc, sensors.candidates.has_grid)),
    ROW("points", OWN, .read = read_points,
        .allowed = "the name of a file, or a list of such names and of "
                   "[x, y, z]",
        FLAG(murk_scene_desc, sensors.candidates.points.given)),
    ROW("mount", OWN, .read = read_mount, .keys = &MOUNT, .preset = "free",
        .allowed = "free or a map of keys, or a list of them"),
    ROW("clearance_m", NUMBER, .max = 1e9, .unit = "m", .preset = "0",
        AT(murk_scene_desc, sensors.candidates.clearance_m)),
    ROW("avoid", LIST, .keys = &AVOID, .preset = "[]"),
    ROW("within", LIST, .keys = &WITHIN, .preset = "[]"),
    ROW("spacing_m", NUMBER, .max = 1e9, .unit = "m", .preset = "0",
        AT(murk_scene_desc, sensors.spacing_m)),
    END,
};

const murk_keys murk_candidate_keys = {
    .noun = "candidates",
    WHERE(murk_scene_desc, sensors.candidates.where),
    .key = CANDIDATES_ROWS,
};
