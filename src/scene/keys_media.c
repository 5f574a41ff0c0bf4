/* Keys of media (homogeneous, grid, profile, preset, fields of files, with a
 * preset or without), of their phase functions and albedo, and of the regions
 * that they fill. */
#include "scene/keys_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fds/extinction.h"
#include "scene/frames.h"
#include "scene/medium_preset.h"

enum {
    MEDIUM_HOMOGENEOUS,
    MEDIUM_GRID,
    MEDIUM_PROFILE,
    MEDIUM_PRESET,
    MEDIUM_PRESET_GRID,
    MEDIUM_FDS,
    MEDIUM_PRESET_FDS,
    MEDIUM_NETCDF,
    MEDIUM_PRESET_NETCDF,
    MEDIUM_DROPLETS_NETCDF
};

/* True if a NetCDF file holds droplets and the map does not say how they
 * scatter. */
static bool leaves_optics_to_droplets(const murk_yaml *map)
{
    return murk_yaml_get(map, "netcdf") && !murk_yaml_get(map, "variable") &&
           !murk_yaml_get(map, "albedo") && !murk_yaml_get(map, "phase");
}

static murk_status choose_medium(murk_key_reader *walk, const murk_yaml *map,
                                 int *variant)
{
    (void)walk;
    if (murk_yaml_get(map, "preset")) {
        *variant = murk_yaml_get(map, "vdb")      ? MEDIUM_PRESET_GRID
                   : murk_yaml_get(map, "fds")    ? MEDIUM_PRESET_FDS
                   : murk_yaml_get(map, "netcdf") ? MEDIUM_PRESET_NETCDF
                                                  : MEDIUM_PRESET;
        return MURK_OK;
    }
    *variant = murk_yaml_get(map, "vdb")        ? MEDIUM_GRID
               : murk_yaml_get(map, "profile")  ? MEDIUM_PROFILE
               : murk_yaml_get(map, "fds")      ? MEDIUM_FDS
               : leaves_optics_to_droplets(map) ? MEDIUM_DROPLETS_NETCDF
               : murk_yaml_get(map, "netcdf")   ? MEDIUM_NETCDF
                                                : MEDIUM_HOMOGENEOUS;
    return MURK_OK;
}

#define PHASE(member) AT(murk_scene_phase, member)

static const murk_key PHASE_ROWS[] = {
    ROW("hg", SPECTRUM, .group = 1, NEEDED, COSINE, PHASE(mean_cosine)),
    TWO_HG_ROW(PHASE(value)),
    FOURNIER_FORAND_ROW(PHASE(value)),
    ROW("table", PATH, .group = 1, NEEDED, PHASE(table)),
    END,
};

#define PHASE_NAME(id, name, numbers) name,
const char *const murk_phase_variants[] = {MURK_PHASE_KINDS(PHASE_NAME) NULL};

static const murk_keys PHASE_KEYS = {
    .noun = "phase",
    .by_key = true,
    .variant_names = murk_phase_variants,
    VARIANT(murk_scene_phase, kind),
    WHERE(murk_scene_phase, where),
    .item_size = sizeof(murk_scene_phase),
    .count_at = offsetof(murk_scene_medium, n_phases),
    .key = PHASE_ROWS,
};

#define MEDIUM(member) AT(murk_scene_medium, member)

static const murk_key ALBEDO_ROWS[] = {
    ROW("grid", TEXT, NEEDED, MEDIUM(albedo_grid)),
    ROW("vdb", PATH, MEDIUM(albedo_vdb)),
    END,
};

static const murk_keys ALBEDO = {.noun = "albedo", .key = ALBEDO_ROWS};

static murk_status check_profile(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    const murk_scene_medium *medium = item;
    const murk_scene_numbers *z = &medium->profile_z_m;
    /* There must be at least two heights and as many extinctions. */
    if (z->n < 2 || z->n != medium->profile_per_m.n) {
        return murk_walk_fail(walk, map,
                              "%zu heights and %zu extinctions, must be as "
                              "many of both, at least 2",
                              z->n, medium->profile_per_m.n);
    }
    /* Heights rise; two equal ones in succession are a jump. */
    for (size_t i = 1; i < z->n; ++i) {
        if (z->value[i] < z->value[i - 1] ||
            (i > 1 && z->value[i] == z->value[i - 2])) {
            return murk_walk_fail(walk, map,
                                  "z_m has %.9g after %.9g, must rise; a "
                                  "height given twice is a jump",
                                  z->value[i], z->value[i - 1]);
        }
    }
    if (z->value[0] == z->value[z->n - 1]) {
        return murk_walk_fail(
            walk, map, "z_m has %.9g alone, must span a layer", z->value[0]);
    }
    return MURK_OK;
}

static const murk_key PROFILE_ROWS[] = {
    ROW("z_m", NUMBER_LIST, NEEDED, PLACE_M, MEDIUM(profile_z_m)),
    ROW("extinction_per_m", SPECTRUM_LIST, NEEDED, .max = 1e9, .unit = "1/m",
        MEDIUM(profile_per_m)),
    END,
};

static const murk_keys PROFILE = {
    .noun = "profile", .check = check_profile, .key = PROFILE_ROWS};

/* For a time between two frames: adds the file of the next frame and the weight
 * of its densities. has_albedos: each frame has a grid of albedos; then the
 * function fails, because albedos are not interpolated in time. */
static murk_status choose_next_frame(murk_key_reader *walk,
                                     const murk_yaml *map, bool has_albedos,
                                     murk_scene_medium *medium)
{
    const double weight = medium->frame - floor(medium->frame);
    if (!(weight > 0)) {
        return MURK_OK;
    }
    if (has_albedos) {
        murk_walk_enter(walk, "frame");
        return murk_walk_fail(walk, murk_yaml_get(map, "frame"),
                              "%.15g is between two frames, must be whole if "
                              "each frame has a grid of albedos: only "
                              "densities are interpolated in time",
                              medium->frame);
    }
    medium->next_weight = weight;
    medium->vdb_next =
        murk_frames_file(medium->vdb_frames, (uint64_t)medium->frame + 1);
    return medium->vdb_next ? MURK_OK : murk_walk_no_memory(walk);
}

/* Replaces the patterns of vdb and albedo_vdb by the files of the frame;
 * vdb_frames keeps the pattern of vdb. Fails if vdb is no pattern, or as
 * choose_next_frame() does. */
static murk_status choose_frame(murk_key_reader *walk, const murk_yaml *map,
                                murk_scene_medium *medium)
{
    const uint64_t frame = (uint64_t)medium->frame;
    char *file = murk_frames_file(medium->vdb, frame);
    if (!file) {
        return murk_walk_fail(walk, map,
                              "a frame of %.200s, which has no place for its "
                              "number, such as #### or %%04d",
                              medium->vdb);
    }
    medium->vdb_frames = medium->vdb;
    medium->vdb = file;
    /* The albedos are in the file of the densities, in a sequence of their own,
     * or in one file for all frames. */
    file =
        medium->albedo_vdb ? murk_frames_file(medium->albedo_vdb, frame) : NULL;
    const bool has_albedos =
        medium->albedo_grid && (!medium->albedo_vdb || file);
    if (file) {
        free(medium->albedo_vdb);
        medium->albedo_vdb = file;
    }
    return choose_next_frame(walk, map, has_albedos, medium);
}

static murk_status check_medium(murk_key_reader *walk, const murk_yaml *map,
                                void *item)
{
    murk_scene_medium *medium = item;
    if (medium->has_within) {
        const murk_status status =
            murk_check_within(walk, map, medium->within_m);
        if (status) {
            return status;
        }
    }
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
        murk_walk_enter(walk, "albedo");
        return murk_walk_fail(walk, murk_yaml_get(map, "albedo"),
                              "misses vdb, must be the name of a file");
    }
    medium->albedo_vdb = strdup(medium->vdb);
    return medium->albedo_vdb ? MURK_OK : murk_walk_no_memory(walk);
}

static const char *const MEDIUM_VARIANTS[] = {
    "homogeneous",
    "grid",
    "profile",
    "preset",
    "preset in a grid",
    "smoke of an FDS run",
    "preset in the smoke of an FDS run",
    "NetCDF file",
    "preset in a NetCDF file",
    "droplets of a NetCDF file",
    NULL};

const murk_word murk_phase_words[] = {
    {"isotropic", MURK_PHASE_HG}, {"rayleigh", MURK_PHASE_RAYLEIGH}, WORDS_END};

#define GRIDS BIT(MEDIUM_GRID) | BIT(MEDIUM_PRESET_GRID)
#define FDS   BIT(MEDIUM_FDS) | BIT(MEDIUM_PRESET_FDS)
#define NETCDF \
    BIT(MEDIUM_NETCDF) | BIT(MEDIUM_PRESET_NETCDF) | BIT(MEDIUM_DROPLETS_NETCDF)
#define PRESETS                                                             \
    BIT(MEDIUM_PRESET) | BIT(MEDIUM_PRESET_GRID) | BIT(MEDIUM_PRESET_FDS) | \
        BIT(MEDIUM_PRESET_NETCDF)
#define PLAIN                                                          \
    BIT(MEDIUM_HOMOGENEOUS) | BIT(MEDIUM_GRID) | BIT(MEDIUM_PROFILE) | \
        BIT(MEDIUM_FDS) | BIT(MEDIUM_NETCDF)

/* NetCDF files of which a variable may be named in place of droplets. */
#define VARIABLE BIT(MEDIUM_NETCDF) | BIT(MEDIUM_PRESET_NETCDF)

/* The gamma distributions of these effective variances v have the powers of r
 * 1/v - 3 of 0..37, which are in the range 0..40 of the preset cloud/droplets.
 */
#define VARIANCE_MIN .025
#define VARIANCE_MAX .33

/* A word of presets (preset/words.h); each preset states its own range. */
#define WORD_ROW(name, id, ...)                 \
    ROW(name, NUMBER, .variants = PRESETS,      \
        MEDIUM(words.value[MURK_WORD_##id][0]), \
        FLAG(murk_scene_medium, words.given[MURK_WORD_##id]), __VA_ARGS__)
#define AMOUNT     .max = 1e9
#define EXTINCTION .max = 1e9, .unit = "1/m", MEDIUM(extinction_per_m)

/* The words that a variable of a file may be the amount of. */
static const murk_word AMOUNT_WORDS[] = {
    {"chlorophyll_mg_per_m3", MURK_WORD_CHLOROPHYLL},
    {"sediment_g_per_m3", MURK_WORD_SEDIMENT},
    {"cdom_per_m", MURK_WORD_CDOM},
    {"soot_g_per_m3", MURK_WORD_SOOT},
    {"rain_mm_per_h", MURK_WORD_RAIN},
    {"liquid_water_g_per_m3", MURK_WORD_LIQUID_WATER},
    {"droplets_per_cm3", MURK_WORD_DROPLETS},
    {"temperature_c", MURK_WORD_TEMPERATURE},
    {"salinity_psu", MURK_WORD_SALINITY},
    WORDS_END};

static const murk_key MEDIUM_ROWS[] = {
    ROW("preset", TEXT, .variants = PRESETS, MEDIUM(preset)),
    WORD_ROW("visibility_m", VISIBILITY, .group = 2, SIZE_M),
    WORD_ROW("mor_m", MOR, .group = 2, SIZE_M),
    WORD_ROW("rain_mm_per_h", RAIN, AMOUNT, .unit = "mm/h"),
    WORD_ROW("soot_g_per_m3", SOOT, AMOUNT, .unit = "g/m3"),
    WORD_ROW("droplets_per_cm3", DROPLETS, .group = 2, AMOUNT, .unit = "1/cm3"),
    WORD_ROW("liquid_water_g_per_m3", LIQUID_WATER, .group = 2, AMOUNT,
             .unit = "g/m3"),
    ROW("droplet_shape", NUMBERS, .variants = PRESETS,
        LIST_ITEMS(ROW("a", NUMBER, .max = 1e3),
                   ROW("b", NUMBER, .above = true, .max = 1e6),
                   ROW("c", NUMBER, .above = true, .max = 100)),
        MEDIUM(words.value[MURK_WORD_DROPLET_SHAPE]),
        FLAG(murk_scene_medium, words.given[MURK_WORD_DROPLET_SHAPE])),
    WORD_ROW("chlorophyll_mg_per_m3", CHLOROPHYLL, AMOUNT, .unit = "mg/m3"),
    WORD_ROW("sediment_g_per_m3", SEDIMENT, AMOUNT, .unit = "g/m3"),
    WORD_ROW("cdom_per_m", CDOM, AMOUNT, .unit = "1/m"),
    WORD_ROW("beam_attenuation_per_m", BEAM_ATTENUATION, AMOUNT, .unit = "1/m"),
    WORD_ROW("temperature_c", TEMPERATURE, .min = -100, .max = 100,
             .unit = "degrees C"),
    WORD_ROW("salinity_psu", SALINITY, .max = 100, .unit = "psu"),
    WORD_ROW("pressure_hpa", PRESSURE, .max = 1e5, .unit = "hPa"),
    ROW("vdb", PATH, .group = 1, MEDIUM(vdb)),
    ROW("frame", NUMBER, .variants = GRIDS, .max = 999999999,
        .selects_files = true, MEDIUM(frame),
        FLAG(murk_scene_medium, has_frame)),
    ROW("grid", TEXT, .variants = GRIDS, MEDIUM(grid)),
    ROW("interpolation", WORD, .variants = GRIDS | NETCDF, .preset = "nearest",
        WORDS({"nearest", 0}, {"linear", 1}), MEDIUM(is_linear)),
    ROW("fds", PATH, .group = 1, MEDIUM(fds)),
    ROW("quantity", WORD, .variants = FDS, .preset = "soot density",
        WORDS({"soot density", MURK_FDS_SOOT_DENSITY},
              {"extinction", MURK_FDS_EXTINCTION},
              {"visibility", MURK_FDS_VISIBILITY}),
        MEDIUM(fds_quantity)),
    ROW("mesh", NUMBER_LIST, .variants = FDS, .min = 1,
        .max = MURK_FDS_MESHES_MAX, .preset = "all", WORDS({"all", 0}),
        MEDIUM(fds_mesh)),
    ROW("netcdf", PATH, .group = 1, MEDIUM(netcdf)),
    ROW("liquid_water", TEXT, .variants = NETCDF, MEDIUM(liquid_water)),
    ROW("effective_radius", TEXT, .variants = NETCDF, MEDIUM(effective_radius)),
    ROW("effective_radius_um", NUMBER, .variants = NETCDF, .above = true,
        .max = 1e6, .unit = "um", .selects_files = true,
        MEDIUM(effective_radius_um)),
    ROW("effective_variance", NUMBER, .variants = BIT(MEDIUM_DROPLETS_NETCDF),
        .min = VARIANCE_MIN, .max = VARIANCE_MAX, .preset = "0.1",
        MEDIUM(effective_variance)),
    ROW("variable", TEXT, .variants = VARIABLE, MEDIUM(variable)),
    ROW("word", WORD, .variants = BIT(MEDIUM_PRESET_NETCDF),
        .words = AMOUNT_WORDS, MEDIUM(word), FLAG(murk_scene_medium, by_word)),
    ROW("per_unit", NUMBER, .variants = VARIABLE, .max = 1e9, .unit = "1/m",
        .preset = "1", .selects_files = true, MEDIUM(per_unit)),
    ROW("time_s", NUMBER, .variants = FDS, NEEDED, .min = -1e9, .max = 1e9,
        .unit = "s", .selects_files = true, MEDIUM(time_s)),
    ROW("time_s", NUMBER, .variants = NETCDF, .max = 1e9, .unit = "s",
        .preset = "0", .selects_files = true, MEDIUM(time_s)),
    WITHIN_ROW(MEDIUM(within_m), FLAG(murk_scene_medium, has_within),
               .variants = NETCDF),
    ROW("profile", MAP, .group = 1, .variants = PLAIN, .keys = &PROFILE),
    ROW("extinction_per_m", SPECTRUM, NEEDED, EXTINCTION,
        .variants = BIT(MEDIUM_HOMOGENEOUS) | BIT(MEDIUM_GRID)),
    ROW("extinction_per_m", SPECTRUM, EXTINCTION,
        .variants = BIT(MEDIUM_PRESET) | BIT(MEDIUM_PRESET_GRID)),
    ROW("albedo", SPECTRUM, NEEDED, SHARE, .keys = &ALBEDO, .variants = PLAIN,
        MEDIUM(albedo)),
    ROW("albedo", SPECTRUM, SHARE, .keys = &ALBEDO, .variants = PRESETS,
        MEDIUM(albedo)),
    ROW("phase", PER_BAND, .keys = &PHASE_KEYS, .preset = "isotropic",
        .words = murk_phase_words, .variants = PLAIN, MEDIUM(phase)),
    ROW("phase", PER_BAND, .keys = &PHASE_KEYS, .words = murk_phase_words,
        .variants = PRESETS, MEDIUM(phase)),
    END,
};

const murk_keys murk_medium_keys = {
    .noun = "medium",
    .choose = choose_medium,
    .variant_names = MEDIUM_VARIANTS,
    .variant_needs = (const char *const[]){"", "vdb", "profile", "preset",
                                           "preset vdb", "fds", "preset fds",
                                           "netcdf", "preset netcdf", "netcdf"},
    .complete = murk_medium_preset_complete,
    .check = check_medium,
    WHERE(murk_scene_medium, where),
    ITEMS(murk_scene_desc, media, n_media),
    .max_items = 256,
    .name_at = offsetof(murk_scene_medium, name),
    .key = MEDIUM_ROWS,
};

#define SHAPE_NAME(id, name, key) name,
static const char *const REGION_VARIANTS[] = {MURK_REGION_SHAPES(SHAPE_NAME)
                                                  NULL};

#define SHAPE_NEEDS(id, name, key) key,

/* A region without a shape is everywhere, or the box of the grid of the
 * medium. */
static murk_status choose_region(murk_key_reader *walk, const murk_yaml *map,
                                 int *variant)
{
#define SHAPE_KEY(id, name, key) [MURK_REGION_##id] = key,
    static const char *const keys[] = {MURK_REGION_SHAPES(SHAPE_KEY)};
    const murk_yaml *media = murk_yaml_get(walk->root, "media");
    const murk_yaml *name = murk_yaml_get(map, "medium");
    const murk_yaml *medium =
        media && name && name->text ? murk_yaml_get(media, name->text) : NULL;
    const bool has_grid = medium && (murk_yaml_get(medium, "vdb") ||
                                     murk_yaml_get(medium, "fds") ||
                                     murk_yaml_get(medium, "netcdf"));
    *variant = has_grid ? MURK_REGION_GRID : MURK_REGION_EVERYWHERE;
    for (int i = 0; i < (int)(sizeof keys / sizeof *keys); ++i) {
        if (keys[i] && murk_yaml_get(map, keys[i])) {
            *variant = i;
        }
    }
    return MURK_OK;
}

/* A region may have an index of refraction, unless it has no shape of its own
 * and its medium is a grid. */
#define SHARP (~BIT(MURK_REGION_GRID))

#define MOVABLE                                                  \
    .variants = BIT(MURK_REGION_BOX) | BIT(MURK_REGION_SPHERE) | \
                BIT(MURK_REGION_GRID) | BIT(MURK_REGION_MESH)

/* Shapes that cannot be moved get the scale 1. Fails if a region has wind but
 * no index of refraction. */
static murk_status check_region(murk_key_reader *walk, const murk_yaml *map,
                                void *item)
{
    murk_scene_region *region = item;
    if (region->shape == MURK_REGION_EVERYWHERE ||
        region->shape == MURK_REGION_BELOW) {
        region->solid.scale = 1;
    }
    if (!(region->wind_m_per_s > 0) || region->ior > 0) {
        return MURK_OK;
    }
    murk_walk_enter(walk, "wind_m_per_s");
    return murk_walk_fail(walk, murk_yaml_get(map, "wind_m_per_s"),
                          "%g m/s over a region without ior, must be 0 there: "
                          "only where the index changes waves bend light",
                          region->wind_m_per_s);
}

#define REGION(member) AT(murk_scene_region, member)

static const murk_key REGION_ROWS[] = {
    ROW("medium", REFERENCE, .of = "media", NEEDED, REGION(medium)),
    BOX_ROW(murk_scene_region, .group = 1),
    SPHERE_ROW(murk_scene_region, .group = 1),
    ROW("below_z_m", NUMBER, .group = 1, PLACE_M, REGION(below_z_m)),
    MESH_ROWS(murk_scene_region, .group = 1),
    PLACEMENT_ROWS(murk_scene_region, MOVABLE),
    ROW("replace", BOOL, .preset = "false", REGION(replaces)),
    ROW("ior", NUMBER, .min = 1, .max = 10, .variants = SHARP, REGION(ior)),
    ROW("wind_m_per_s", NUMBER, .max = 20, .unit = "m/s",
        .variants = BIT(MURK_REGION_BELOW), REGION(wind_m_per_s)),
    END,
};

const murk_keys murk_region_keys = {
    .noun = "region",
    .choose = choose_region,
    .check = check_region,
    .variant_names = REGION_VARIANTS,
    .variant_needs = (const char *const[]){MURK_REGION_SHAPES(SHAPE_NEEDS)},
    VARIANT(murk_scene_region, shape),
    WHERE(murk_scene_region, where),
    ITEMS(murk_scene_desc, regions, n_regions),
    .max_items = 64,
    .key = REGION_ROWS,
};
