/* Fields on a box of voxels as files that viewers open: NAME.vdb for Blender
 * (and Houdini, OpenVDB), NAME.vti for ParaView, as Debian's reads no .vdb.
 *
 * A .vdb has one float grid a field, class fog volume, voxel centres where the
 * transform says; 0 is its background. Each grid's metadata: unit, quantity,
 * meaning, band_nm, scene, scene_sha256, seed, murk_version, murk_commit. Last
 * comes a grid `density`, which is what Blender's volume shader shows unasked:
 * a multiple of the first field, without what is negative; metadata factor and
 * of. A .vti has the same values as cell data, without `density`; metadata as
 * field data. */
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

typedef char murk_field_name[48];

/* "coverage_532nm" */
void murk_field_name_of(murk_field_name name, const char *quantity,
                        double band_nm);

typedef struct murk_voxel_field {
    murk_field_name name;
    const char *unit, *quantity;
    const char *meaning; /* NULL: the quantity says it all */
    int band;            /* of the scene's; -1: all of them together */
    const float *value;  /* [voxels], x fastest; finite */
} murk_voxel_field;

/* Metadata of a grid: key, text, key, text, ..., NULL, for grid_write.h. */
#define MURK_FIELD_NOTES 24
typedef struct murk_field_notes {
    const char *note[MURK_FIELD_NOTES];
    murk_facts facts;
    char band_nm[32];
} murk_field_notes;
void murk_field_notes_of(murk_field_notes *out, const murk_scene_desc *scene,
                         const murk_voxel_field *field);

/* What `density` is a multiple of the first field by. */
typedef enum murk_field_look {
    MURK_FIELD_AS_IT_IS, /* an extinction: what a shader means by density */
    MURK_FIELD_SCALED    /* so that what is above 0 has, in the mean, an optical
                            depth of 2 over the box's longest edge */
} murk_field_look;

/* n fields, at least 1. name: with its ending. As murk_results_add(). */
murk_status murk_field_add_vdb(murk_results *results, const char *name,
                               const murk_scene_desc *scene,
                               const murk_field_box *box,
                               const murk_voxel_field *field, size_t n,
                               murk_field_look look, murk_error *err);
murk_status murk_field_add_vti(murk_results *results, const char *name,
                               const murk_scene_desc *scene,
                               const murk_field_box *box,
                               const murk_voxel_field *field, size_t n,
                               murk_error *err);

#endif
