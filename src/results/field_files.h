/* Fields on a box of voxels as files that viewers open: NAME.vdb for Blender
 * (and Houdini, OpenVDB), NAME.vti for ParaView, as Debian's reads no .vdb.
 *
 * A .vdb has one float grid a field, class fog volume, voxel centres where the
 * transform says; 0 is its background. Each grid's metadata: unit, quantity,
 * meaning, band_nm, scene, scene_sha256, seed, murk_version, murk_commit. Last
 * may come a grid `density`, which is what Blender's volume shader shows
 * unasked: a multiple of the first field, without what is negative; metadata
 * factor and of. A .vti has the same values as cell data, without `density`;
 * metadata as field data. */
#ifndef MURK_RESULTS_FIELD_FILES_H
#define MURK_RESULTS_FIELD_FILES_H

#include "results/results.h"
#include "results/vtk.h"

typedef struct murk_field_box {
    murk_box box;
    size_t size[3]; /* voxels along each axis */
} murk_field_box;

size_t murk_field_voxels(const murk_field_box *box);

/* From whole numbers to voxel centres. */
murk_affine murk_field_to_world(const murk_field_box *box);

typedef struct murk_voxel_field {
    char name[48]; /* "coverage_532nm" */
    const char *unit, *quantity;
    const char *meaning; /* NULL: the quantity says it all */
    int band;            /* of the scene's; -1: all of them together */
    float *value;        /* [voxels], x fastest; finite */
} murk_voxel_field;

/* Of a plan four of each band, and extinction; of a tally two values and two
 * errors of each band, and two sums. */
#define MURK_VOXEL_FIELDS_MAX (5 * MURK_BANDS_MAX)

/* Fields on one box. */
typedef struct murk_voxel_fields {
    const murk_scene_desc *scene;
    murk_field_box box;
    murk_voxel_field field[MURK_VOXEL_FIELDS_MAX];
    size_t n;
} murk_voxel_fields;

/* Adds a field like the given one, of a band, whose wavelength is added to the
 * name, or of all (-1). Returns its values, which the caller fills, or NULL
 * when out of memory. */
float *murk_voxel_fields_add(murk_voxel_fields *fields,
                             const murk_voxel_field *like, int band);
void murk_voxel_fields_release(murk_voxel_fields *fields);

/* The grid `density` of a .vdb, by the factor on the first field. */
typedef enum murk_field_density {
    MURK_DENSITY_NONE,
    MURK_DENSITY_EQUAL, /* an extinction: what a shader means by density */
    MURK_DENSITY_SCALED /* so that what is above 0 has, in the mean, an optical
                           depth of 2 over the box's longest edge */
} murk_field_density;

/* At least 1 field. name: with its ending. As murk_results_add(). */
murk_status murk_field_add_vdb(murk_results *results, const char *name,
                               const murk_voxel_fields *fields,
                               murk_field_density density, murk_error *err);
murk_status murk_field_add_vti(murk_results *results, const char *name,
                               const murk_voxel_fields *fields,
                               murk_error *err);

#endif
