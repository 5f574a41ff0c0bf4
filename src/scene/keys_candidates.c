/* Where sensors may stand. */
#include "scene/keys_rows.h"

#define MOST_CANDIDATES 1e7

/* max - min over spacing_m is rounded a few times: a last point that passes
 * max by less than this share of a step still counts. */
#define STEP_SLACK 1e-9

static void fill_size_by_spacing(murk_scene_candidates *wish, double spacing)
{
    const double min[3] = {wish->grid_min.x, wish->grid_min.y,
                           wish->grid_min.z};
    double *const max[3] = {&wish->grid_max.x, &wish->grid_max.y,
                            &wish->grid_max.z};
    for (int i = 0; i < 3; ++i) {
        const double steps = fmin(
            floor((*max[i] - min[i]) / spacing + STEP_SLACK), MOST_CANDIDATES);
        wish->grid_size[i] = (size_t)steps + 1;
        *max[i] = min[i] + steps * spacing;
    }
}

static murk_status check_grid(murk_walk *walk, const murk_yaml *map, void *item)
{
    murk_scene_candidates *wish = &((murk_scene *)item)->sensors.candidates;
    const murk_vec3 min = wish->grid_min, max = wish->grid_max;
    if (!(min.x <= max.x && min.y <= max.y && min.z <= max.z)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "min_m [%.9g, %.9g, %.9g] and max_m "
                              "[%.9g, %.9g, %.9g], min must be at most max on "
                              "each axis, m",
                              min.x, min.y, min.z, max.x, max.y, max.z);
    }
    const murk_yaml *spacing = murk_yaml_get(map, "spacing_m");
    double spacing_m;
    if (spacing && murk_yaml_number(spacing, &spacing_m)) {
        fill_size_by_spacing(wish, spacing_m);
    }
    const double extent[3] = {max.x - min.x, max.y - min.y, max.z - min.z};
    double points = 1;
    for (int i = 0; i < 3; ++i) {
        points *= (double)wish->grid_size[i];
        if (extent[i] == 0 && wish->grid_size[i] > 1) {
            return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                                  "size %zu along %c where min_m is max_m, "
                                  "must be 1",
                                  wish->grid_size[i], "xyz"[i]);
        }
    }
    if (!(points <= MOST_CANDIDATES)) {
        return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                              "%.9g points, must be at most 1e7", points);
    }
    return MURK_OK;
}

static const murk_key GRID_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, LONG_M,
        AT(murk_scene, sensors.candidates.grid_min)),
    ROW("max_m", VECTOR, NEEDED, LONG_M,
        AT(murk_scene, sensors.candidates.grid_max)),
    ROW("size", SIZES, .group = 1, NEEDED, .least = 1, .most = MOST_CANDIDATES,
        .unit = "points", AT(murk_scene, sensors.candidates.grid_size)),
    ROW("spacing_m", NUMBER, .group = 1, NEEDED, SIZE_M),
    END,
};

static const murk_keys GRID = {
    .noun = "grid",
    .check = check_grid,
    WHERE(murk_scene, sensors.candidates.grid_where),
    .key = GRID_ROWS,
};

static const murk_key CANDIDATES_ROWS[] = {
    ROW("grid", MAP, .keys = &GRID,
        FLAG(murk_scene, sensors.candidates.has_grid)),
    ROW("clearance_m", NUMBER, .most = 1e9, .unit = "m", .preset = "0",
        AT(murk_scene, sensors.candidates.clearance_m)),
    ROW("avoid", ONLY, .preset = "[]"),
    ROW("mount", ONLY, .preset = "free"),
    ROW("spacing_m", NUMBER, .most = 1e9, .unit = "m", .preset = "0",
        AT(murk_scene, sensors.spacing_m)),
    END,
};

const murk_keys murk_candidate_keys = {
    .noun = "candidates",
    WHERE(murk_scene, sensors.candidates.where),
    .key = CANDIDATES_ROWS,
};
