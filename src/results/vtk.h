/* Where a file for viewers is from, and the beginning of VTK's files (for
 * ParaView: XML before raw bytes). */
#ifndef MURK_RESULTS_VTK_H
#define MURK_RESULTS_VTK_H

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

/* Facts, and a list of notes like theirs (or NULL), as comments of a PLY file,
 * a line each; bytes that would end a line are "?". */
void murk_ply_put_facts(FILE *to, const murk_scene_desc *scene,
                        const char *const *note);

/* "0: fog, 1: smoke" of n names that begin `stride` bytes apart; the caller's.
 * NULL when out of memory. */
char *murk_numbered_names(const char *first, size_t n, size_t stride);

/* A text as an array of field data: character by character, so that nothing
 * has to be escaped; the same of all facts, and of a list of notes or NULL. */
void murk_vtk_put_text(FILE *to, const char *name, const char *text);
void murk_vtk_put_facts(FILE *to, const murk_scene_desc *scene,
                        const char *const *note);

/* The file's first line, and the element around all. */
void murk_vtk_begin(FILE *to, const char *type);

#endif
