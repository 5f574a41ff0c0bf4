/* Parts that several files for viewers share: the provenance of a file (scene,
 * seed, version), and the beginning of the files of VTK, which are XML and then
 * raw bytes. */
#ifndef MURK_RESULTS_VTK_H
#define MURK_RESULTS_VTK_H

#include "scene/scene.h"

#include <stdio.h>

/* The provenance of a result, as key, text, key, text, ..., NULL. The keys are
 * scene, scene_sha256, seed, murk_version and murk_commit. The texts of the
 * scene are borrowed, and one pointer in fact[] leads to `seed` in the struct,
 * so the struct must not be copied. */
#define MURK_FACTS 11
typedef struct murk_facts {
    const char *fact[MURK_FACTS];
    char seed[16];
} murk_facts;
void murk_facts_of(murk_facts *out, const murk_scene_desc *scene);

/* Writes the facts of a scene, then notes (key, text, ..., NULL; or NULL), as
 * comments of a PLY file, one line each. Control characters are written as
 * "?". */
void murk_ply_put_facts(FILE *to, const murk_scene_desc *scene,
                        const char *const *note);

/* Returns "0: fog, 1: smoke" for n names that begin `stride` bytes apart. The
 * caller frees it. NULL when out of memory. */
char *murk_numbered_names(const char *first, size_t n, size_t stride);

/* Write field data: the first a text as an array of the numbers of its bytes,
 * so that nothing has to be escaped; the second in this way the facts of a
 * scene, then notes (key, text, ..., NULL; or NULL). */
void murk_vtk_put_text(FILE *to, const char *name, const char *text);
void murk_vtk_put_facts(FILE *to, const murk_scene_desc *scene,
                        const char *const *note);

/* Writes the first line of the file, and opens the outermost element. type:
 * that of the data set, such as "ImageData". */
void murk_vtk_begin(FILE *to, const char *type);

#endif
