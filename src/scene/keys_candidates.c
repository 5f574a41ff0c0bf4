/* Keys of candidate sites: a grid, points, mounts on surfaces, and zones in
 * which sensors may or may not stand. */
#include "scene/keys_rows.h"

#include <stdlib.h>

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
    murk_scene_candidates *settings = &((murk_scene_sensors *)item)->candidates;
    const murk_vec3 min = settings->grid_min, max = settings->grid_max;
    if (!(min.x <= max.x && min.y <= max.y && min.z <= max.z)) {
        return murk_walk_fail(walk, map,
                              "min_m [%.9g, %.9g, %.9g] and max_m [%.9g, %.9g, "
                              "%.9g], min must be at most max on each axis, m",
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
            return murk_walk_fail(
                walk, map, "size %zu along %c where min_m is max_m, must be 1",
                settings->grid_size[i], "xyz"[i]);
        }
    }
    if (!(points <= MAX_CANDIDATES)) {
        return murk_walk_fail(walk, map, "%.9g points, must be at most 1e7",
                              points);
    }
    return MURK_OK;
}

#define CANDIDATES(member) AT(murk_scene_sensors, candidates.member)

static const murk_key GRID_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, PLACE_M, CANDIDATES(grid_min)),
    ROW("max_m", VECTOR, NEEDED, PLACE_M, CANDIDATES(grid_max)),
    ROW("size", SIZES, .group = 1, NEEDED, .min = 1, .max = MAX_CANDIDATES,
        .unit = "points", CANDIDATES(grid_size)),
    ROW("spacing_m", NUMBER, .group = 1, NEEDED, SIZE_M),
    END,
};

static const murk_keys GRID = {
    .noun = "grid",
    .check = check_grid,
    WHERE(murk_scene_sensors, candidates.grid_where),
    .key = GRID_ROWS,
};

/* ---- points ---- */

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
                               murk_yaml *node, void *member)
{
    murk_scene_points *points = member;
    const bool is_list = node->kind == MURK_YAML_LIST;
    const size_t n = is_list ? node->n : 1;
    murk_status status = MURK_OK;
    if (node->kind == MURK_YAML_MAP || n == 0) {
        return murk_value_wrong(walk, key, node);
    }
    if (n > MURK_SCENE_LIST_MAX) {
        return murk_walk_fail(
            walk, node,
            "a list of %zu, must be at most %d; a file may have more", n,
            MURK_SCENE_LIST_MAX);
    }
    /* Reserve both arrays for the worst case, then read each item. */
    murk_walk_where(node, walk->key, false, points->where);
    points->file = calloc(n, sizeof *points->file);
    points->position = calloc(n, sizeof *points->position);
    if (!points->file || !points->position) {
        return murk_walk_no_memory(walk);
    }
    if (!is_list) {
        return read_point(walk, node, points);
    }
    for (size_t i = 0; i < n && !status; ++i) {
        const size_t back = murk_walk_enter_item(walk, i);
        status = read_point(walk, node->child[i], points);
        if (!status) {
            murk_walk_leave(walk, back);
        }
    }
    return status;
}

/* ---- mounts ---- */

#define MOUNT(member) AT(murk_scene_mount, member)

static const murk_key MOUNT_ROWS[] = {
    ROW("surfaces", REFERENCES, .of = "materials", .preset = "all",
        WORDS({"all", 0}), MOUNT(materials)),
    ROW("spacing_m", NUMBER, SIZE_M, .preset = "1", MOUNT(spacing_m)),
    ROW("offset_m", NUMBER, SIZE_M, .preset = "0.05", MOUNT(offset_m)),
    ROW("z_m", NUMBERS,
        LIST_ITEMS(ROW("low", NUMBER, LONG_M), ROW("high", NUMBER, LONG_M)),
        .is_position = true, MOUNT(band_m), FLAG(murk_scene_mount, has_band)),
    ROW("facing", WORD, .preset = "any", MOUNT(facing),
        WORDS({"any", MURK_SCENE_FACING_ANY}, {"up", MURK_SCENE_FACING_UP},
              {"down", MURK_SCENE_FACING_DOWN},
              {"side", MURK_SCENE_FACING_SIDE})),
    END,
};

static murk_status check_mount(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    const murk_scene_mount *mount = item;
    return mount->band_m[0] <= mount->band_m[1]
               ? MURK_OK
               : murk_walk_fail(walk, map,
                                "z_m is from %.9g to %.9g m, must not fall",
                                mount->band_m[0], mount->band_m[1]);
}

static const murk_keys MOUNT_KEYS = {
    .noun = "mount",
    .check = check_mount,
    WHERE(murk_scene_mount, where),
    ITEMS(murk_scene_sensors, candidates.mount, candidates.mounts),
    .max_items = 64,
    .key = MOUNT_ROWS,
};

/* ---- zones ---- */

static const murk_key ZONE_ROWS[] = {
    BOX_ROW(murk_scene_site_zone, .group = 1, NEEDED),
    SPHERE_ROW(murk_scene_site_zone, .group = 1, NEEDED),
    MESH_ROWS(murk_scene_site_zone, .group = 1, NEEDED),
    PLACEMENT_ROWS(murk_scene_site_zone, .variants = 0),
    END,
};

#define ZONES(array, count)                                                  \
    {                                                                        \
        .noun = "zone", .by_key = true, .variant_names = murk_zone_variants, \
        VARIANT(murk_scene_site_zone, shape),                                \
        WHERE(murk_scene_site_zone, where),                                  \
        ITEMS(murk_scene_sensors, candidates.array, candidates.count),       \
        .max_items = 64, .key = ZONE_ROWS,                                   \
    }

static const murk_keys AVOID = ZONES(avoid, avoids);
static const murk_keys WITHIN = ZONES(within, withins);

/* ---- all of it ---- */

static const murk_key CANDIDATES_ROWS[] = {
    ROW("grid", MAP, .keys = &GRID,
        FLAG(murk_scene_sensors, candidates.has_grid)),
    ROW("points", OWN, .read = read_points,
        .allowed = "the name of a file, or a list of such names and of "
                   "[x, y, z]",
        .schema = "{\"anyOf\": [{\"type\": \"string\"}, {\"type\": \"array\", "
                  "\"minItems\": 1, \"items\": {\"anyOf\": [{\"type\": "
                  "\"string\"}, {\"type\": \"array\", \"items\": {\"type\": "
                  "\"number\"}, \"minItems\": 3, \"maxItems\": 3}]}}]}",
        CANDIDATES(points), FLAG(murk_scene_sensors, candidates.points.given)),
    ROW("mount", MAPS, .keys = &MOUNT_KEYS, .preset = "free",
        WORDS({"free", 0})),
    ROW("clearance_m", NUMBER, .max = 1e9, .unit = "m", .preset = "0",
        CANDIDATES(clearance_m)),
    ROW("avoid", LIST, .keys = &AVOID, .preset = "[]"),
    ROW("within", LIST, .keys = &WITHIN, .preset = "[]"),
    ROW("spacing_m", NUMBER, .max = 1e9, .unit = "m", .preset = "0",
        AT(murk_scene_sensors, spacing_m)),
    END,
};

const murk_keys murk_candidate_keys = {
    .noun = "candidates",
    WHERE(murk_scene_sensors, candidates.where),
    .key = CANDIDATES_ROWS,
};
