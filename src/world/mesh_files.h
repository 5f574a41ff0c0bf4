/* The mesh files that a scene names, as one list. The list has an item for each
 * geometry, then for each region, for each region of interest, one for the
 * targets, and one for each zone of candidate sites (those to avoid, then those
 * to keep within), whether or not the shape is a mesh. */
#ifndef MURK_WORLD_MESH_FILES_H
#define MURK_WORLD_MESH_FILES_H

#include "geometry/mesh.h"
#include "scene/scene.h"

typedef struct murk_mesh_file {
    const char *path; /* NULL: the item is not a mesh file */
    murk_mesh_import import;
    double scale;
    const char *where;
} murk_mesh_file;

size_t murk_mesh_files_count(const murk_scene_desc *scene);

/* The i-th item of the list. */
murk_mesh_file murk_mesh_file_at(const murk_scene_desc *scene, size_t i);

#endif
