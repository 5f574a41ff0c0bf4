/* Files of VTK, for ParaView: XML before raw bytes.
 *
 * Source of the format: Schroeder, Martin, Lorensen, The Visualization
 * Toolkit, 4th ed., Kitware, 2006, and its file formats' notes. */
#ifndef MURK_RESULTS_VTK_H
#define MURK_RESULTS_VTK_H

#include "base/status.h"
#include "scene/scene.h"

#include <stdio.h>

/* Where a result is from: key, text, key, text, ..., NULL: scene,
 * scene_sha256, seed, murk_version, murk_commit. */
#define MURK_FACTS 11
typedef struct murk_facts {
    const char *fact[MURK_FACTS];
    char seed[16];
} murk_facts;
void murk_facts_of(murk_facts *out, const murk_scene_desc *scene);

/* As comments of a PLY file, a line each; bytes that would end one are "?". */
void murk_ply_put_facts(FILE *to, const murk_scene_desc *scene);
void murk_ply_put_comment(FILE *to, const char *key, const char *text);

/* A text as an array of field data: character by character, so that nothing
 * has to be escaped; and all facts. */
void murk_vtk_put_text(FILE *to, const char *name, const char *text);
void murk_vtk_put_facts(FILE *to, const murk_scene_desc *scene);

/* The file's first line, and the element around all. */
void murk_vtk_begin(FILE *to, const char *type);

/* One array. put writes item i, components of the type, as they lie in
 * memory. */
typedef struct murk_vtk_array {
    const char *name;
    const char *type; /* "Float32", "UInt8", .. */
    size_t components, item_bytes;
    void (*put)(const void *context, size_t i, void *item);
} murk_vtk_array;

/* Points, and triangles that have three of their own each, in order, or no
 * triangles: then the points are shown by themselves. */
typedef struct murk_vtp {
    const murk_scene_desc *scene;
    const char *const *notes; /* more field data: name, text, ..., NULL */
    size_t points;
    bool has_triangles;          /* points / 3 */
    murk_vtk_array place;        /* of points: scene/places.h */
    const murk_vtk_array *array; /* of triangles, or of points */
    size_t arrays;
    const void *context;
    const char *step; /* of a progress bar */
} murk_vtp;

/* Streams it: nothing is held twice. Fails with MURK_INTERRUPTED or
 * MURK_RUN_FAILED. */
murk_status murk_vtp_write(const murk_vtp *vtp, const char *path,
                           murk_error *err);

#endif
