/* Mesh files whose coordinates are large, brought near 0 in double precision
 * before Assimp reads them in single precision.
 *
 * At the 5.5e6 m of surveyed coordinates a single-precision step is .5 m. OBJ
 * and PLY files are plain enough to be rewritten: where the middle of their
 * vertices is further from 0 than 16 times their extent, a round shift is
 * subtracted from the text (or the doubles) of each vertex. All else of the
 * file stays, so Assimp reads it as before. */
#ifndef MURK_GEOMETRY_IMPORT_SHIFT_H
#define MURK_GEOMETRY_IMPORT_SHIFT_H

#include <stdbool.h>
#include <stddef.h>

/* Whether files of that ending can be: OBJ and PLY. */
bool murk_import_may_shift(const char *path);

/* Of a file's bytes, by the ending of its path. Where its vertices lie far
 * from 0: true, shift[] in the file's units and axes, and *out (from malloc,
 * the caller's) the rewritten file. False: read the file as it is; so also
 * where it is malformed, which Assimp says better. */
bool murk_import_shift(const char *path, const char *bytes, size_t size,
                       char **out, size_t *out_size, double shift[3]);

#endif
