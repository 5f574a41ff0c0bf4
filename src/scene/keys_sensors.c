/* Keys of sensors: types, fixed sensors, and the number of sensors to place. */
#include "scene/keys_rows.h"

#include <string.h>

/* ---- types ---- */

#define VIEW_NAME(id, name) name,
static const char *const VIEW_VARIANTS[] = {MURK_VIEW_SHAPES(VIEW_NAME) NULL};

#define TYPE(member) AT(murk_scene_sensor_type, member)

/* A field of view of a frustum: less than a half space. */
#define FOV                                                    \
    NEEDED, .above = true, .below = true, .max = 180, RADIANS, \
            .variants = BIT(MURK_VIEW_FRUSTUM)

static const murk_key VIEW_ROWS[] = {
    ROW("cone_deg", NUMBER, NEEDED, .above = true, .max = 360, RADIANS,
        .variants = BIT(MURK_VIEW_CONE), TYPE(cone_rad)),
    ROW("hfov_deg", NUMBER, FOV, TYPE(hfov_rad)),
    ROW("vfov_deg", NUMBER, FOV, TYPE(vfov_rad)),
    END,
};

static murk_status choose_view(murk_key_reader *walk, const murk_yaml *map,
                               int *variant)
{
    (void)walk;
    *variant =
        murk_yaml_get(map, "cone_deg") ? MURK_VIEW_CONE : MURK_VIEW_FRUSTUM;
    return MURK_OK;
}

static const murk_keys VIEW = {
    .noun = "view",
    .choose = choose_view,
    .variant_names = VIEW_VARIANTS,
    VARIANT(murk_scene_sensor_type, view),
    .key = VIEW_ROWS,
};

/* A type with a limited view has headings and tilts. */
enum { ALL_ROUND, DIRECTED };

static const char *const TYPE_VARIANTS[] = {"all round", "with a view", NULL};

static murk_status choose_type(murk_key_reader *walk, const murk_yaml *map,
                               int *variant)
{
    const murk_yaml *view = murk_yaml_get(map, "view");
    (void)walk;
    *variant = view && view->kind == MURK_YAML_MAP ? DIRECTED : ALL_ROUND;
    return MURK_OK;
}

int murk_scene_band_of(const murk_scene_desc *scene, double nm)
{
    for (int b = 0; b < scene->bands; ++b) {
        if (scene->has_edges ? nm >= scene->band_edge_nm[b] &&
                                   nm < scene->band_edge_nm[b + 1]
                             : nm == scene->band_nm[b]) {
            return b;
        }
    }
    return -1;
}

static murk_status find_bands(murk_key_reader *walk, const murk_yaml *map,
                              murk_scene_sensor_type *type)
{
    const murk_yaml *list = murk_yaml_get(map, "bands");
    for (size_t i = 0; i < type->bands_nm.n; ++i) {
        const int band =
            murk_scene_band_of(walk->scene, type->bands_nm.value[i]);
        if (band < 0) {
            return murk_walk_fail(walk, list->child[i],
                                  "bands: %.9g nm is in no band of the scene",
                                  type->bands_nm.value[i]);
        }
        type->bands |= 1u << band;
    }
    return MURK_OK;
}

static murk_status check_type(murk_key_reader *walk, const murk_yaml *map,
                              void *item)
{
    murk_scene_sensor_type *type = item;
    if (!(type->least_range_m < type->range_m)) {
        return murk_walk_fail(
            walk, map,
            "least_range_m is %.9g and range_m %.9g m, the least must be less",
            type->least_range_m, type->range_m);
    }
    if (type->min_count > type->max_count) {
        return murk_walk_fail(walk, map,
                              "least_count is %llu and max_count %llu, the "
                              "least must be at most the other",
                              (unsigned long long)type->min_count,
                              (unsigned long long)type->max_count);
    }
    const murk_status status = murk_check_own_name(
        walk, map, "type", walk->scene->sensors.type, sizeof *type, type);
    return status ? status : find_bands(walk, map, type);
}

#define HAS_VIEW .variants = BIT(DIRECTED)
/* Larger values are mistakes. */
#define POSITIVE .above = true, .max = 1e9
/* A number of sensors; 1e6 stands for no limit. */
#define COUNT_OF .max = 1e6, .unit = "sensors"

static const murk_key TYPE_ROWS[] = {
    ROW("name", TEXT, NEEDED, TYPE(name)),
    ROW("range_m", NUMBER, NEEDED, SIZE_M, TYPE(range_m)),
    ROW("least_range_m", NUMBER, .max = 1e9, .unit = "m", .preset = "0",
        TYPE(least_range_m)),
    ROW("view", MAP, .keys = &VIEW, WORDS({"sphere", MURK_VIEW_SPHERE}),
        .preset = "sphere", TYPE(view)),
    ROW("headings", COUNT, .group = 1, .min = 1, .max = 3600,
        .unit = "headings", .preset = "8", HAS_VIEW, TYPE(headings)),
    ROW("headings_deg", NUMBER_LIST, .group = 1, .min = -360, .max = 360,
        .unit = "degrees", HAS_VIEW, TYPE(headings_deg)),
    ROW("tilts_deg", NUMBER_LIST, .min = -90, .max = 90, .unit = "degrees",
        .preset = "[0]", HAS_VIEW, TYPE(tilts_deg)),
    ROW("arrival", WORD, WORDS({"any", 0}, {"toward", 1}), .preset = "any",
        TYPE(toward)),
    ROW("acceptance_deg", NUMBER, .max = 180, RADIANS, .preset = "0",
        TYPE(acceptance_rad)),
    ROW("aperture_m2", NUMBER, POSITIVE, .unit = "m2", .preset = "1e-4",
        TYPE(aperture_m2)),
    ROW("quantum_efficiency", NUMBER, .above = true, .max = 1, .preset = "0.5",
        TYPE(quantum_efficiency)),
    ROW("exposure_s", NUMBER, POSITIVE, .unit = "s", .preset = "0.01",
        TYPE(exposure_s)),
    ROW("target_m2", NUMBER, POSITIVE, .unit = "m2", .preset = "1e-4",
        TYPE(target_m2)),
    ROW("target_m3", NUMBER, POSITIVE, .unit = "m3", .preset = "1e-6",
        TYPE(target_m3)),
    ROW("bands", NUMBER_LIST, POSITIVE, .unit = "nm", WORDS({"all", 0}),
        .preset = "all", TYPE(bands_nm)),
    ROW("cost", NUMBER, .max = 1e6, .preset = "1", TYPE(cost)),
    ROW("least_count", COUNT, COUNT_OF, .preset = "0", TYPE(min_count)),
    ROW("max_count", COUNT, COUNT_OF, .preset = "1000000", TYPE(max_count)),
    END,
};

static const murk_keys TYPE_KEYS = {
    .noun = "sensor type",
    .choose = choose_type,
    .variant_names = TYPE_VARIANTS,
    .variant_needs = (const char *const[]){"", "view"},
    .check = check_type,
    WHERE(murk_scene_sensor_type, where),
    ITEMS(murk_scene_sensors, type, types),
    .max_items = 64,
    .needs_item = true,
    .key = TYPE_ROWS,
};

/* ---- fixed sensors ---- */

static murk_status check_fixed(murk_key_reader *walk, const murk_yaml *map,
                               void *item)
{
    murk_scene_fixed_sensor *fixed = item;
    const murk_scene_sensors *all = &walk->scene->sensors;
    fixed->type = all->types;
    /* Find the type by name; without a name there must be only one. */
    for (size_t i = 0; i < all->types; ++i) {
        const bool is_it = fixed->type_name[0] ? strcmp(all->type[i].name,
                                                        fixed->type_name) == 0
                                               : all->types == 1;
        fixed->type = is_it ? i : fixed->type;
    }
    if (fixed->type == all->types) {
        return fixed->type_name[0]
                   ? murk_walk_fail(walk, map, "type: %s is no type of `types`",
                                    fixed->type_name)
                   : murk_walk_fail(walk, map,
                                    "misses type, must be a name of `types`");
    }
    /* A direction needs a type with a limited view. */
    const bool has_pose =
        murk_yaml_get(map, "heading_deg") || murk_yaml_get(map, "tilt_deg");
    if (has_pose && all->type[fixed->type].view == MURK_VIEW_SPHERE) {
        return murk_walk_fail(
            walk, map, "heading_deg or tilt_deg, but type %s sees all round",
            all->type[fixed->type].name);
    }
    return MURK_OK;
}

#define FIXED(member) AT(murk_scene_fixed_sensor, member)

static const murk_key FIXED_ROWS[] = {
    ROW("type", TEXT, FIXED(type_name)),
    ROW("position_m", VECTOR, NEEDED, PLACE_M, FIXED(position)),
    ROW("heading_deg", NUMBER, .min = -360, .max = 360, RADIANS,
        FIXED(heading_rad)),
    ROW("tilt_deg", NUMBER, .min = -90, .max = 90, RADIANS, FIXED(tilt_rad)),
    ROW("failed", BOOL, FIXED(is_failed)),
    END,
};

static const murk_keys FIXED_KEYS = {
    .noun = "fixed sensor",
    .check = check_fixed,
    WHERE(murk_scene_fixed_sensor, where),
    ITEMS(murk_scene_sensors, fixed, n_fixed),
    .max_items = 10000,
    .key = FIXED_ROWS,
};

/* ---- all of it ---- */

#define SENSORS(member) AT(murk_scene_sensors, member)

static const murk_key SENSORS_ROWS[] = {
    ROW("types", LIST, NEEDED, .keys = &TYPE_KEYS),
    ROW("candidates", MAP, .keys = &murk_candidate_keys, .preset = "{}"),
    ROW("fixed", LIST, .keys = &FIXED_KEYS, .preset = "[]"),
    ROW("one_per_site", BOOL, .preset = "false", SENSORS(one_per_site)),
    ROW("count", COUNT, .group = 1, .min = 1, COUNT_OF, SENSORS(count)),
    ROW("target", NUMBER, .group = 1, .above = true, .max = 1, SENSORS(target)),
    ROW("budget", NUMBER, .group = 1, .above = true, .max = 1e12,
        SENSORS(budget)),
    END,
};

const murk_keys murk_sensor_keys = {
    .noun = "sensors",
    WHERE(murk_scene_sensors, where),
    .key = SENSORS_ROWS,
};
