/* The material names in the mesh files of the geometry, and the material of the
 * scene that each name was given. A name without an entry in `materials` gets
 * the material `default` without an error, so the user must be able to see
 * which names have no entry. */
#ifndef MURK_WORLD_MESH_MATERIALS_H
#define MURK_WORLD_MESH_MATERIALS_H

#include "world/stage.h"

/* One material name of one mesh file of `geometry`. */
typedef struct murk_mesh_material {
    size_t geometry;  /* index into the geometry of the scene */
    const char *name; /* as the importer gives it; borrowed from the mesh */
    double area_m2;   /* area of the triangles with this name, in world
                       * coordinates; above 0 */
    int material;     /* index into the materials of the scene: the material
                       * that the triangles got */
    bool is_forced;   /* the key geometry.*.material chose the material, not the
                       * name */
    bool is_named;    /* `materials` has an entry of this name, apart from case
                       * and blanks; false if is_forced */
} murk_mesh_material;

/* Sets *out to the *n material names whose triangles have an area, ordered by
 * geometry, and within one geometry as in the imported mesh. The caller frees
 * *out, which must not outlive the stage. Fails with MURK_NO_MEMORY. */
murk_status murk_mesh_materials(murk_mesh_material **out, size_t *n,
                                const murk_stage *stage, murk_error *err);

/* Warns of names that got the material `default` because no entry has the name,
 * with one line for each mesh, which lists the first names only if there are
 * many; and of each entry of `materials` other than `default` that no surface
 * uses. Names that importers give to triangles without a material do not count.
 * Nothing is printed if there is no memory for the list of names. */
void murk_warn_of_materials(const murk_stage *stage);

#endif
