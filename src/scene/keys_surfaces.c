/* Keys of geometry (mesh file, box, rectangle, sphere) and of materials. */
#include <float.h>

#include "scene/keys_rows.h"

/* The table has checked that exactly one shape is given. */
/* Variants have the names of the keys that select them. */
#define SHAPE_KEY(id, key) key,
static const char *const GEOMETRY_VARIANTS[] = {MURK_SURFACE_SHAPES(SHAPE_KEY)};

static murk_status choose_geometry(murk_key_reader *walk, const murk_yaml *map,
                                   int *variant)
{
    (void)walk;
    const int n = sizeof GEOMETRY_VARIANTS / sizeof *GEOMETRY_VARIANTS;
    *variant = MURK_SHAPE_MESH;
    for (int i = 0; i < n; ++i) {
        if (murk_yaml_get(map, GEOMETRY_VARIANTS[i])) {
            *variant = i;
        }
    }
    return MURK_OK;
}

static murk_status check_geometry_box(murk_key_reader *walk,
                                      const murk_yaml *map, void *item)
{
    return murk_check_box(walk, map, ((murk_scene_geometry *)item)->box);
}

static murk_status check_geometry_rect(murk_key_reader *walk,
                                       const murk_yaml *map, void *item)
{
    const murk_scene_geometry *rect = item;
    return murk_check_edges(walk, map, rect->edge1, rect->edge2);
}

static const murk_key GEOMETRY_BOX_ROWS[] = {
    ROW("min_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_geometry, box.min)),
    ROW("max_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_geometry, box.max)),
    END,
};

static const murk_keys GEOMETRY_BOX = {
    .noun = "box",
    .check = check_geometry_box,
    .key = GEOMETRY_BOX_ROWS,
};

static const murk_key GEOMETRY_RECT_ROWS[] = {
    ROW("corner_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_geometry, corner)),
    ROW("edge1_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_geometry, edge1)),
    ROW("edge2_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_geometry, edge2)),
    END,
};

static const murk_keys GEOMETRY_RECT = {
    .noun = "rect",
    .check = check_geometry_rect,
    .key = GEOMETRY_RECT_ROWS,
};

static const murk_key GEOMETRY_SPHERE_ROWS[] = {
    ROW("center_m", VECTOR, NEEDED, LONG_M, AT(murk_scene_geometry, center)),
    ROW("radius_m", NUMBER, NEEDED, SIZE_M, AT(murk_scene_geometry, radius_m)),
    END,
};

static const murk_keys GEOMETRY_SPHERE = {
    .noun = "sphere",
    .key = GEOMETRY_SPHERE_ROWS,
};

const murk_word murk_up_words[] = {
    {"x", 'x'},
    {"y", 'y'},
    {"z", 'z'},
    WORDS_END,
};

static const murk_key GEOMETRY_ROWS[] = {
    ROW("file", PATH, .group = 1, NEEDED, AT(murk_scene_geometry, file)),
    ROW("box", MAP, .group = 1, NEEDED, .keys = &GEOMETRY_BOX),
    ROW("rect", MAP, .group = 1, NEEDED, .keys = &GEOMETRY_RECT),
    ROW("sphere", MAP, .group = 1, NEEDED, .keys = &GEOMETRY_SPHERE),
    ROW("unit_m", NUMBER, SIZE_M, .variants = BIT(MURK_SHAPE_MESH),
        AT(murk_scene_geometry, unit_m)),
    ROW("allow", PATH, .variants = BIT(MURK_SHAPE_MESH),
        AT(murk_scene_geometry, allow)),
    ROW("up", WORD, .variants = BIT(MURK_SHAPE_MESH), .words = murk_up_words,
        AT(murk_scene_geometry, up)),
    ROW("scale", NUMBER, .above = true, .max = 1e9, .preset = "1",
        AT(murk_scene_geometry, scale)),
    ROW("rotate_deg", VECTOR, ANY_UNIT, .unit = "degrees",
        .preset = "[0, 0, 0]", AT(murk_scene_geometry, rotate_deg)),
    ROW("translate_m", VECTOR, LONG_M, .preset = "[0, 0, 0]",
        AT(murk_scene_geometry, translate_m)),
    ROW("material", REFERENCE, .of = "materials",
        AT(murk_scene_geometry, material)),
    END,
};

const murk_keys murk_geometry_keys = {
    .noun = "geometry",
    .choose = choose_geometry,
    .variant_names = GEOMETRY_VARIANTS,
    VARIANT(murk_scene_geometry, shape),
    WHERE(murk_scene_geometry, where),
    ITEMS(murk_scene_geometry, geometry, geometries),
    .max_items = 10000,
    .key = GEOMETRY_ROWS,
};

/* ---- materials ---- */

static murk_status check_material(murk_key_reader *walk, const murk_yaml *map,
                                  void *item)
{
    const murk_scene_material *material = item;
    for (int i = 0; i < walk->scene->bands; ++i) {
        const double sum = material->diffuse.band[i] +
                           material->specular.band[i] +
                           material->transmit.band[i];
        /* three decimal fractions and two sums may round up: 0.35 + 0.6 +
         * 0.05 */
        if (!(sum <= 1 + 4 * DBL_EPSILON)) {
            return murk_walk_fail(walk, MURK_BAD_VALUE, map, false,
                                  "diffuse + specular + transmit is %.9g at "
                                  "%.9g nm, must be at most 1",
                                  sum, walk->scene->band_nm[i]);
        }
    }
    return MURK_OK;
}

static const murk_key MATERIAL_ROWS[] = {
    ROW("diffuse", SPECTRUM, SHARE, .preset = "0",
        AT(murk_scene_material, diffuse)),
    ROW("specular", SPECTRUM, SHARE, .preset = "0",
        AT(murk_scene_material, specular)),
    ROW("transmit", SPECTRUM, SHARE, .preset = "0",
        AT(murk_scene_material, transmit)),
    ROW("ior", NUMBER, .min = 1, .max = 10, AT(murk_scene_material, ior)),
    END,
};

const murk_keys murk_material_keys = {
    .noun = "material",
    .check = check_material,
    WHERE(murk_scene_material, where),
    ITEMS(murk_scene_material, materials, n_materials),
    .max_items = 256,
    .name_at = offsetof(murk_scene_material, name),
    .first = "default",
    .first_preset = "{diffuse: 0.5}",
    .key = MATERIAL_ROWS,
};
