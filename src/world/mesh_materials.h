/* The materials that mesh files name, and what the scene makes of them. A name
 * that no entry of `materials` has falls to `default` without being an error,
 * so the user must be able to see it. */
#ifndef MURK_WORLD_MESH_MATERIALS_H
#define MURK_WORLD_MESH_MATERIALS_H

#include "world/stage.h"

/* One material name of one mesh file of `geometry`. */
typedef struct murk_mesh_material {
    size_t geometry;  /* index into the scene's geometry */
    const char *name; /* as the importer gives it; borrowed from the mesh */
    double area_m2;   /* of its triangles, in the world; more than 0 */
    int material;     /* index into the scene's materials: what they got */
    bool is_forced;   /* geometry.*.material says so, not the name */
    bool is_named;    /* an entry of `materials` has the name */
} murk_mesh_material;

/* All names that have an area, in the order of geometry and file. *out is the
 * caller's: free(). */
murk_status murk_mesh_materials(murk_mesh_material **out, size_t *n,
                                const murk_stage *stage, murk_error *err);

/* Warns of names that fell to `default`, a line a mesh, and of entries of
 * `materials` that neither a name nor a geometry refers to. */
void murk_warn_of_materials(const murk_stage *stage);

#endif
