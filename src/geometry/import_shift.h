/* Shifts mesh files with large coordinates towards 0 in double precision,
 * before Assimp reads them in single precision.
 *
 * At 5.5e6 m, a typical surveyed coordinate, a step of single precision is 0.5
 * m. OBJ and PLY files are simple enough to be rewritten: if a coordinate of
 * the middle of the bounding box of the vertices exceeds 16 times the longest
 * edge of the box, a round shift is subtracted from the text (or the binary
 * doubles) of each vertex. The rest of the file is copied, so Assimp reads it
 * as before. */
#ifndef MURK_GEOMETRY_IMPORT_SHIFT_H
#define MURK_GEOMETRY_IMPORT_SHIFT_H

#include <stdbool.h>
#include <stddef.h>

/* True if files with the ending of `path` can be shifted: OBJ and PLY. */
bool murk_import_may_shift(const char *path);

/* Shifts a file, given as bytes; the ending of `path` tells the format. True if
 * the vertices are far from 0: then shift[] is in the file's units and axes,
 * and *out is the rewritten file, which the caller frees with free(). False:
 * the file is to be read as it is. The result is also false without memory, for
 * PLY files whose vertices are not the first element or are binary but not
 * doubles, for OBJ files whose vertices have weights or continue on the next
 * line, and for malformed files, because Assimp's message is better. */
bool murk_import_shift(const char *path, const char *bytes, size_t size,
                       char **out, size_t *out_size, double shift[3]);

#endif
