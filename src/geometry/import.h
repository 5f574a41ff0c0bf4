/* The child's half of reading a mesh: the one door to Assimp.
 *
 * What it hands over, in order: murk_import_head, then float[3 * vertices],
 * uint32_t[3 * triangles], uint32_t[triangles] (material), then
 * char[materials][MURK_NAME_SIZE]. */
#ifndef MURK_GEOMETRY_IMPORT_H
#define MURK_GEOMETRY_IMPORT_H

#include "base/subprocess.h"
#include "geometry/mesh.h"

typedef struct murk_import_head {
    uint64_t vertices, triangles, materials;
    double origin_m[3]; /* that the vertices count from */
} murk_import_head;

typedef struct murk_import_order {
    const char *path, *where;
    murk_mesh_import import;
} murk_import_order;

/* A murk_subprocess_work; context is a murk_import_order. */
murk_status murk_import_work(murk_subprocess *child, void *context,
                             murk_error *err);

#endif
