/* Fields on a box of voxels as files that viewers open: NAME.vdb for Blender,
 * Houdini and OpenVDB, and NAME.vti for ParaView, which in Debian's build reads
 * no .vdb.
 *
 * A .vdb has one grid of floats for each field, of class fog volume, with
 * background 0; its transform maps indices to voxel centres. The metadata of a
 * grid are unit, quantity, meaning (if any), band_nm, scene, scene_sha256,
 * seed, murk_version and murk_commit. A further grid `density` may come last,
 * because Blender's volume shader shows a grid of this name by default: the
 * first field times a factor, with 0 for negative values. Its metadata are
 * unit, quantity, of (the name of the field) and factor. A .vti has the same
 * fields, without `density`, as cell data, and the metadata as field data. */
#ifndef MURK_RESULTS_FIELD_FILES_H
#define MURK_RESULTS_FIELD_FILES_H

#include "results/results.h"
#include "results/vtk.h"

typedef struct murk_field_box {
    murk_box box;
    size_t size[3]; /* voxels along each axis */
} murk_field_box;

size_t murk_field_voxels(const murk_field_box *box);

/* Maps voxel indices, from 0, to voxel centres in the box. */
murk_affine murk_field_to_world(const murk_field_box *box);

typedef struct murk_voxel_field {
    char name[48]; /* "coverage_532nm" */
    const char *unit, *quantity;
    const char *meaning; /* explains the quantity; NULL: nothing to add */
    int band;            /* of the scene; -1: all bands together */
    float *value;        /* [voxels], x fastest; finite */
} murk_voxel_field;

/* The largest number of fields: for a plan five of each band (four and the
 * extinction). A tally has fewer, for B > 1 bands 4 B + 2: photon density,
 * fluence rate and their errors, and the density summed over the bands with its
 * error. */
#define MURK_VOXEL_FIELDS_MAX (5 * MURK_BANDS_MAX)

/* Fields on one box. */
typedef struct murk_voxel_fields {
    const murk_scene_desc *scene;
    murk_field_box box;
    murk_voxel_field field[MURK_VOXEL_FIELDS_MAX];
    size_t n;
} murk_voxel_fields;

/* Adds a field like the given one: of a band, whose wavelength is appended to
 * the name ("_532nm"), or of all bands (-1), with the name as it is. Returns
 * the array of values, which the caller fills and the list owns, or NULL when
 * out of memory. The texts of `like` must outlive the list. */
float *murk_voxel_fields_add(murk_voxel_fields *fields,
                             const murk_voxel_field *like, int band);
void murk_voxel_fields_release(murk_voxel_fields *fields);

/* Whether a .vdb has the grid `density`, and its factor on the first field. */
typedef enum murk_field_density {
    MURK_DENSITY_NONE,
    MURK_DENSITY_EQUAL, /* factor 1, for an extinction, which is what a shader
                           takes for density */
    MURK_DENSITY_SCALED /* a factor such that the mean of the values above 0 is
                           an optical depth of 2 over the longest edge of the
                           box; 1 if no value is above 0 */
} murk_field_density;

/* Adds a file of at least 1 field. The name includes the ending. Fails as
 * murk_results_add() does, or with MURK_NO_MEMORY. */
murk_status murk_field_add_vdb(murk_results *results, const char *name,
                               const murk_voxel_fields *fields,
                               murk_field_density density, murk_error *err);
murk_status murk_field_add_vti(murk_results *results, const char *name,
                               const murk_voxel_fields *fields,
                               murk_error *err);

#endif
