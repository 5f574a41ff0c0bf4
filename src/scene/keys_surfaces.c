/* Keys of geometry (mesh file, box, rectangle, sphere) and of materials. */
#include "scene/keys_rows.h"

#include <float.h>
#include <string.h>

#define SHAPE_KEY(id, key) key,
static const char *const GEOMETRY_VARIANTS[] = {
    MURK_SURFACE_SHAPES(SHAPE_KEY) "fds", "geotiff", NULL};

/* The variants of the walls of an FDS run and of the ground of a GeoTIFF file,
 * which are meshes once they are read. */
#define SHAPE_COUNTED(id, key) +1
#define SHAPE_FDS              (0 MURK_SURFACE_SHAPES(SHAPE_COUNTED))
#define SHAPE_GEOTIFF          (SHAPE_FDS + 1)

static murk_status check_rect(murk_key_reader *walk, const murk_yaml *map,
                              void *item)
{
    const murk_scene_geometry *rect = item;
    return murk_check_edges(walk, map, rect->edge1, rect->edge2);
}

#define GEOMETRY(member) AT(murk_scene_geometry, member)

static const murk_key RECT_ROWS[] = {
    ROW("corner_m", VECTOR, NEEDED, LONG_M, GEOMETRY(corner)),
    ROW("edge1_m", VECTOR, NEEDED, LONG_M, GEOMETRY(edge1)),
    ROW("edge2_m", VECTOR, NEEDED, LONG_M, GEOMETRY(edge2)),
    END,
};

static const murk_keys RECT = {
    .noun = "rect", .check = check_rect, .key = RECT_ROWS};

/* ---- ground ---- */

static murk_status check_geotiff(murk_key_reader *walk, const murk_yaml *map,
                                 void *item)
{
    const murk_geotiff_asked *asked = &((murk_scene_geometry *)item)->geotiff;
    const murk_status status =
        asked->has_within ? murk_check_within(walk, map, asked->within_m)
                          : MURK_OK;
    const murk_scene_site *site = &walk->scene->site;
    return status ? status
           : site->has_latitude && site->has_longitude
               ? MURK_OK
               : murk_walk_fail(walk, map,
                                "needs site.latitude_deg and "
                                "site.longitude_deg, or none of them: then the "
                                "middle of the file is the site");
}

/* No place on earth is higher than this above another; GDAL has int bands. */
#define ERROR_MAX_M 1e4
#define BANDS_MAX   65535

static const murk_key GEOTIFF_ROWS[] = {
    ROW("file", PATH, NEEDED, GEOMETRY(solid.mesh)),
    ROW("error_m", NUMBER, .max = ERROR_MAX_M, .unit = "m", .preset = "0.5",
        .selects_files = true, GEOMETRY(geotiff.error_m)),
    ROW("band", COUNT, .min = 1, .max = BANDS_MAX, .selects_files = true,
        GEOMETRY(geotiff.band)),
    ROW("height_unit", WORD,
        WORDS({"m", MURK_SCENE_HEIGHT_M}, {"cm", MURK_SCENE_HEIGHT_CM},
              {"ft", MURK_SCENE_HEIGHT_FT}, {"us-ft", MURK_SCENE_HEIGHT_US_FT}),
        GEOMETRY(height_unit)),
    ROW("nodata", NUMBER, .min = -DBL_MAX, .max = DBL_MAX,
        .selects_files = true, GEOMETRY(geotiff.nodata),
        FLAG(murk_scene_geometry, geotiff.has_nodata)),
    WITHIN_ROW(GEOMETRY(geotiff.within_m),
               FLAG(murk_scene_geometry, geotiff.has_within)),
    END,
};

static const murk_keys GEOTIFF = {
    .noun = "geotiff", .check = check_geotiff, .key = GEOTIFF_ROWS};

/* ---- geometry ---- */

#define OF_MESH    .variants = BIT(MURK_SHAPE_MESH)
#define OF_FDS     .variants = BIT(SHAPE_FDS)
#define OF_GEOTIFF .variants = BIT(SHAPE_GEOTIFF)
/* All but ground, whose place and heights are those of its file. */
#define PLACED .variants = BIT(SHAPE_GEOTIFF) - 1

/* Checks the name and gives walls and ground from files their shape. Names
 * serve as parts of paths, where a number is the index of an item. */
static murk_status check_geometry(murk_key_reader *walk, const murk_yaml *map,
                                  void *item)
{
    const murk_scene_geometry *first = walk->scene->geometry;
    murk_scene_geometry *own = item;
    if ((int)own->shape == SHAPE_FDS) {
        own->shape = MURK_SHAPE_MESH;
        own->is_fds = true;
    } else if ((int)own->shape == SHAPE_GEOTIFF) {
        own->shape = MURK_SHAPE_MESH;
        own->is_geotiff = true;
        own->solid.scale = 1; /* the ground has no placement */
    }
    if (own->name[0] == '\0') {
        return MURK_OK;
    }
    if (strspn(own->name, "0123456789") == strlen(own->name) ||
        strchr(own->name, '.')) {
        return murk_walk_fail(walk, map,
                              "name: %s, must not be a number or have a point",
                              own->name);
    }
    return murk_check_own_name(walk, map, "geometry", first, sizeof *first,
                               own);
}

static const murk_key GEOMETRY_ROWS[] = {
    ROW("name", TEXT, GEOMETRY(name)),
    ROW("file", PATH, .group = 1, NEEDED, GEOMETRY(solid.mesh)),
    BOX_ROW(murk_scene_geometry, .group = 1, NEEDED),
    ROW("rect", MAP, .group = 1, NEEDED, .keys = &RECT),
    SPHERE_ROW(murk_scene_geometry, .group = 1, NEEDED),
    ROW("fds", PATH, .group = 1, NEEDED, OF_FDS, GEOMETRY(solid.mesh)),
    ROW("geotiff", MAP, .group = 1, NEEDED, OF_GEOTIFF, .keys = &GEOTIFF,
        .takes_file = true),
    ROW("time_s", NUMBER, OF_FDS, .min = -1e9, .max = 1e9, .unit = "s",
        .preset = "0", GEOMETRY(time_s)),
    ROW("unit_m", NUMBER, SIZE_M, OF_MESH, GEOMETRY(solid.unit_m)),
    ROW("allow", PATH, OF_MESH, GEOMETRY(allow)),
    ROW("up", WORD, OF_MESH, .words = murk_up_words, GEOMETRY(solid.up)),
    PLACEMENT_ROWS(murk_scene_geometry, PLACED),
    ROW("material", REFERENCE, .of = "materials", GEOMETRY(material)),
    END,
};

const murk_keys murk_geometry_keys = {
    .noun = "geometry",
    .by_key = true,
    .variant_names = GEOMETRY_VARIANTS,
    .check = check_geometry,
    VARIANT(murk_scene_geometry, shape),
    WHERE(murk_scene_geometry, where),
    ITEMS(murk_scene_desc, geometry, geometries),
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
            return murk_walk_fail(walk, map,
                                  "diffuse + specular + transmit is %.9g at "
                                  "%.9g nm, must be at most 1",
                                  sum, walk->scene->band_nm[i]);
        }
    }
    return MURK_OK;
}

#define MATERIAL(member) AT(murk_scene_material, member)

static const murk_key MATERIAL_ROWS[] = {
    ROW("diffuse", SPECTRUM, SHARE, .preset = "0", MATERIAL(diffuse)),
    ROW("specular", SPECTRUM, SHARE, .preset = "0", MATERIAL(specular)),
    ROW("transmit", SPECTRUM, SHARE, .preset = "0", MATERIAL(transmit)),
    ROW("ior", NUMBER, .min = 1, .max = 10, MATERIAL(ior)),
    END,
};

const murk_keys murk_material_keys = {
    .noun = "material",
    .check = check_material,
    WHERE(murk_scene_material, where),
    ITEMS(murk_scene_desc, materials, n_materials),
    .max_items = 256,
    .name_at = offsetof(murk_scene_material, name),
    .first = "default",
    .first_preset = "{diffuse: 0.5}",
    .key = MATERIAL_ROWS,
};
