/* The mesh files that a scene names, as one list: those of the geometry, of the
 * regions, of the regions of interest, of the targets, and of the zones of
 * candidate sites (those to avoid, then those to keep within). */
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
